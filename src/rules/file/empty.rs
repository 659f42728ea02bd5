//! Files without anything in them where content is needed.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::loader::{extension, is_generated, is_met, is_override, refused_json};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::formats::Content;
use crate::json::SchemaFault;
use crate::repo::{FileFacts, ReferenceKind, Resolution, View, makehuman2};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "loads nothing, or stops")],
        docs: "The file has no bytes, or nothing but blanks and comments. Often a download or an export was interrupted.\n\nHow bad that is \
            depends on the file. An empty `.mhskel`, `.mhpose` or `.mhbin` stops MakeHuman 2 while it scans the assets, an empty `base.mhbin` when it loads the base, an empty \
            `compressedtargets.npz` stops every start until it is deleted, and an empty JSON, also one that is no more than `{}`, `[]`, `\"\"`, `0`, `false` or `null`, counts as missing (an override in `contarget/` is the business of `overlay-broken-override`). A target \
            without a row loads and moves nothing; where a macro names it, `macro-empty-target` speaks instead.\n\nRestore the \
            content, or remove the file and what refers to it.",
        ..RuleInfo::new("file-empty", Level::Warning, "an empty file where content is needed")
    },
    check: Check::Repository(run),
};

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(view) = view.makehuman2() else { return };
    let macros = targets_of_macros(view);
    let needed = |file: &&FileFacts| is_met(view, file) && !is_override(file);
    for file in view.layers.checked.files.values().filter(needed) {
        let Some(what) = emptiness(file).or_else(|| counts_as_missing(view, file)) else { continue };
        if macros.contains(file.rel.as_str()) {
            continue;
        }
        let Some((level, effect)) = consequence(view, file) else { continue };
        let (level, effect) = if needs_no_macros(view, file) {
            (Level::Info, "takes it as missing, as it may be: no slider needs macros")
        } else {
            (level, effect)
        };
        let message = format!("`{}` is empty{what}", file.file_name());
        let help = match file.kind {
            Kind::TargetArchive => "delete it: MakeHuman 2 makes a new one from the targets",
            _ => "restore the content, or remove the file and what refers to it",
        };
        out.push(RULE.at(file, Place::File, message).level(level).breaks(Application::Makehuman2, effect).help(help));
    }
}

/// Python takes an empty object, list or text, 0, false and null for false, and the loader that for no file. An empty
/// generated modelling.json is usual.
fn counts_as_missing(view: &makehuman2::View<'_>, file: &FileFacts) -> Option<&'static str> {
    let wanted = matches!(file.kind, Kind::BaseJson | Kind::MacroJson | Kind::ModellingJson | Kind::TargetCategories);
    let usual = file.kind == Kind::ModellingJson && is_generated(view, file);
    let read = !matches!(file.content, Content::Broken(_) | Content::Unread);
    let is_object = !file.schema.faults.iter().any(SchemaFault::is_wrong_root);
    let what =
        if is_object { " (`{}` counts as no file)" } else { " (null, 0, false and empty values count as no file)" };
    (wanted && !usual && read && file.json.falsy).then_some(what)
}

/// Whether the file is the `macro.json` of a base without a macro slider, which does as well without.
fn needs_no_macros(view: &makehuman2::View<'_>, file: &FileFacts) -> bool {
    let mut bases = view.bases.iter().filter(|base| file.base() == Some(base.name));
    file.kind == Kind::MacroJson && bases.all(|base| !base.sliders.iter().any(|slider| slider.slider.is_macro()))
}

/// `macro-empty-target` knows these better.
fn targets_of_macros<'r>(view: &'r makehuman2::View<'_>) -> BTreeSet<&'r str> {
    let macros = view.references.iter().filter(|reference| reference.kind == ReferenceKind::MacroTarget);
    macros
        .filter_map(|reference| match reference.resolution {
            Resolution::Found(file) if view.layers.is_checked(file) => Some(file.rel.as_str()),
            _ => None,
        })
        .collect()
}

fn emptiness(file: &FileFacts) -> Option<&'static str> {
    let encoding = &file.encoding;
    match file.kind {
        _ if file.size == 0 => Some(" (0 bytes)"),
        kind if !kind.is_text() => None,
        _ if encoding.blank && encoding.byte_order_mark => Some(" (nothing but a byte order mark)"),
        _ if encoding.blank => Some(" (nothing but blanks)"),
        // A comment is no JSON: that is a matter of syntax.
        kind if !kind.is_json() && encoding.only_comments => Some(" (nothing but comments)"),
        _ => None,
    }
}

/// Level and consequence, or nothing where nobody needs content.
fn consequence(view: &makehuman2::View<'_>, file: &FileFacts) -> Option<(Level, &'static str)> {
    Some(match (file.kind, extension(&file.rel)) {
        (kind, _) if kind.is_json() => refused_json(view, file),
        (Kind::Target, _) => (Level::Warning, "loads it; nothing moves"),
        // `archive-malformed` speaks.
        (Kind::TargetArchive, _) => return None,
        (Kind::BaseMesh, _) => (Level::Error, "stops at start: there is no base mesh"),
        (Kind::Material, _) => (Level::Warning, "shows the default white material"),
        (Kind::Model, _) => (Level::Warning, "loads a model without a setting"),
        (Kind::MotionMeta, _) => (Level::Warning, "names the pose after its file"),
        (Kind::Motion, _) => (Level::Error, "stops with an IndexError when the pose is used"),
        (Kind::Clothes | Kind::AssetMesh, _) => (Level::Error, "cannot attach the asset"),
        (Kind::Image | Kind::TargetIcon, _) => (Level::Warning, "shows no picture"),
        (Kind::Packed, "mhbin") if file.rel.starts_with("base/") => {
            (Level::Error, "stops with an EOFError when it loads the base")
        }
        (Kind::Packed, "mhbin") => (Level::Error, "stops at start while it scans the assets"),
        _ => return None,
    })
}
