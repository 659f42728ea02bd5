//! The shader of a material must exist.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, did_you_mean, shown};
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::{FileFacts, Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "silently draws the surface like phong, without its settings",
        ),
        (
            Makehuman1,
            "logs an error and draws the surface without a shader",
        ),
    ],
    docs: include_str!("missing_shader.md").trim_ascii_end(),
    of_whole: true,
    ..RuleInfo::new(
        "material-missing-shader",
        Level::Warning,
        "a material asks for a shader that does not exist",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if loader::is_1(view.application()) {
        return of_files(view, out);
    }
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let (name, line) = (loader::shader(surface), surface.material.last("shader"));
        let Some(line) = line.filter(|line| line.count > 0 && !loader::SHADERS.contains(&name))
        else {
            continue;
        };
        let shown = shown(name);
        let finding = RULE.at(
            surface.file,
            Surface::place(line),
            format!("shader `{shown}` does not exist"),
        );
        let near = cx.suggestions.nearest(name, loader::SHADERS);
        let help = did_you_mean(near, "write `phong`, `litsphere`, `pbr` or `toon`");
        out.push(finding.key(shown).help(help));
    }
}

/// A shader of MakeHuman 1 is a file. Without any shader there is one finding for all
/// (`program-missing-file`).
fn of_files(view: &View<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let has_shaders = layers
        .strongest_first()
        .any(|layer| layer.below(FOLDER).next().is_some());
    let own = view
        .surfaces()
        .iter()
        .filter(|surface| layers.is_checked(surface.file) && has_shaders);
    let missing = own.filter_map(|surface| {
        let shader = surface
            .shader
            .as_ref()
            .filter(|shader| shader.files.is_empty() && !shader.is_open)?;
        Some((shader.text, (surface, shader)))
    });
    out.extend(without_main(view));
    let known = known(view);
    for (text, all) in grouped(missing) {
        let Some((surface, shader)) = all.first() else {
            continue;
        };
        let shown = shown(text);
        let more = if all.len() > 1 {
            format!(" ({} materials name it)", all.len())
        } else {
            String::new()
        };
        let is_absolute = text.starts_with('/') || text.get(1..2) == Some(":");
        let what = if is_absolute {
            "is an absolute path: it exists on one computer at most"
        } else {
            "does not exist"
        };
        let message = format!("shader `{shown}` {what}{more}");
        let name = text.rsplit(['/', '\\']).next().unwrap_or_default();
        let help = match known.get(&name.to_ascii_lowercase()) {
            Some(known) => format!("write `{FOLDER}/{known}`"),
            None => format!("use a shader of `{FOLDER}`, without `_vertex_shader.txt`"),
        };
        let finding = RULE
            .at(surface.file, shader.place.clone(), message)
            .key(shown)
            .help(help);
        let parts = all
            .iter()
            .map(|(one, shader)| (one.file.shown(), &one.file.path, shader.place.clone()));
        let finding = finding.parts_at(parts);
        out.push(match all.len() {
            1 => finding,
            _ => finding.evidence(Evidence::of_cases(
                all.iter().map(|(one, _)| one.file.shown()),
            )),
        });
    }
}

/// Sources that cannot be compiled: nothing begins in them. One that is empty has a finding of its
/// own.
fn without_main(view: &View<'_>) -> Vec<Finding> {
    let own = view
        .surfaces()
        .iter()
        .flat_map(|surface| surface.shader.iter().flat_map(|shader| &shader.files));
    let own = own.filter(|file| view.layers().is_checked(file) && !file.encoding.blank);
    let dead = own.filter(|file| file.shader_source().is_some_and(|source| !source.has_main));
    // Several materials may have one shader.
    let files: BTreeMap<&str, &FileFacts> = dead.map(|file| (file.path.as_str(), *file)).collect();
    let finding = |file: &FileFacts| {
        let finding = RULE
            .at(
                file,
                Place::File,
                format!("`{}` has no function `main`", file.file_name()),
            )
            .key("main");
        finding.help("restore the source: a shader without `main` cannot be compiled")
    };
    files.into_values().map(finding).collect()
}

/// The shaders in the folder of shaders, by their names in small letters; of several the first.
fn known<'v>(view: &'v View<'_>) -> BTreeMap<String, &'v str> {
    let files = view
        .layers()
        .strongest_first()
        .flat_map(|layer| layer.below(FOLDER));
    let names = files.filter_map(|file| file.file_name().split_once("_fragment_shader.txt"));
    let mut known = BTreeMap::new();
    for (name, _) in names {
        known.entry(name.to_ascii_lowercase()).or_insert(name);
    }
    known
}

const FOLDER: &str = "shaders/glsl";
