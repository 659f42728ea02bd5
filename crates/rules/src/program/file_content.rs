//! What `makehuman2_version.json` names must exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{mpfb_content, version_keys};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo, nearest,
};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "crashes with `KeyError` where it uses the key"),
        (Mpfb, "fails with an exception where it uses the value"),
    ],
    docs: include_str!("file_content.md").trim_ascii_end(),
    ..RuleInfo::new(
        "program-file-content",
        Level::Error,
        "a file of the program names something that does not exist",
    )
});

const NO_MESH: Case = &[(
    Makehuman2,
    Level::Warning,
    "does not find its standard mesh",
)];

fn run(view: &View<'_>, file: &FileFacts, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    mpfb_content::faults(&RULE, view, file, cx, out);
    let Some(version) = file.version() else {
        return;
    };
    let keys: BTreeSet<&str> = version.keys.iter().map(String::as_str).collect();
    out.extend(
        version
            .support
            .iter()
            .filter_map(|(label, key)| support(file, &keys, label, key, cx)),
    );
    out.extend(version_keys::missing(&RULE, file, version, cx));
    out.extend(
        version
            .standard_mesh
            .as_deref()
            .and_then(|mesh| standard_mesh(view, file, mesh)),
    );
}

fn support(
    file: &FileFacts,
    keys: &BTreeSet<&str>,
    label: &str,
    key: &str,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    if keys.contains(key) {
        return None;
    }
    let addresses = cx
        .suggestions
        .looked_through(keys.iter().copied())
        .filter(|key| key.starts_with("url_"));
    let near = cx.suggestions.nearest(key, addresses);
    let message = format!("`{key}` of `{label}` is not a key of this file");
    let finding = RULE
        .at(file, Place::pointer(["support_urls", label]), message)
        .key(label);
    Some(finding.help(did_you_mean(
        near,
        format!("add `{key}` with its address, or remove the entry"),
    )))
}

fn standard_mesh(view: &View<'_>, file: &FileFacts, mesh: &str) -> Option<Finding> {
    let layers = view.layers();
    let bases = view.body_names();
    // A repository need not hold the base meshes of the program.
    let holds_bases = layers
        .system
        .is_some_and(|system| system.below("base").next().is_some());
    if !holds_bases || bases.contains(&mesh) {
        return None;
    }
    let message = format!("base mesh `{mesh}` does not exist");
    let near = nearest(mesh, bases.iter().copied()).or(bases.first().copied());
    let finding = RULE
        .at(file, Place::pointer(["standardmesh"]), message)
        .case(NO_MESH);
    Some(finding.help(did_you_mean(near, "name a base mesh that exists")))
}
