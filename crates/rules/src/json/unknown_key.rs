//! Keys that no application reads.

use super::super::cause::consequence::of_misspelt;
use super::super::cause::is_ignored_override;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::left_out;
use super::told_keys::{Told, nested};
use mhlint_diag::{
    Application::Makehuman2, Case, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::Kind;
use mhlint_json::UnknownKey;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently ignores the key")],
    docs: include_str!("unknown_key.md").trim_ascii_end(),
    counts: "keys",
    ..RuleInfo::new(
        "json-unknown-key",
        Level::Info,
        "a key that no application reads",
    )
});

/// Something slipped inside another thing of its kind.
const NESTED: Case = &[(
    Makehuman2,
    Level::Warning,
    "silently ignores everything in it",
)];

/// Whoever has no plane takes the vertical, which changes the rest pose
/// (`docs/loaders/makehuman2/skeletons.md#rest-pose`).
const NO_PLANE: Case = &[(
    Makehuman2,
    Level::Warning,
    "ignores the key: the bones have no plane, so the vertical decides their roll",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if file.schema.unknown.is_empty() || is_ignored_override(file) {
        return;
    }
    let told = Told::of(view, file);
    let is_licence =
        |unknown: &UnknownKey| file.kind == Kind::Pose && unknown.pointer == "/licence";
    let unknown = file
        .schema
        .unknown
        .iter()
        .filter(|unknown| !told.has(unknown) && !is_licence(unknown));
    let by_key = grouped(unknown.map(|unknown| ((&unknown.key, &unknown.object), unknown)));
    out.extend(
        by_key
            .into_values()
            .filter_map(|all| finding(view, file, &all)),
    );
    out.extend(left_out(
        &RULE,
        file,
        file.schema.unknown_left_out,
        "unknown key",
    ));
}

/// One finding for a key, however many objects have it.
fn finding(view: &View<'_>, file: &FileFacts, all: &[&UnknownKey]) -> Option<Finding> {
    let first = all.first()?;
    let owner = first
        .object
        .as_deref()
        .map(|object| format!(" of a {}", object.to_lowercase()))
        .unwrap_or_default();
    let times = if all.len() == 1 {
        String::new()
    } else {
        format!(" ({} times)", all.len())
    };
    let kind = first
        .object
        .as_deref()
        .map(|object| format!("{} ", object.to_lowercase()))
        .unwrap_or_default();
    let message = format!("unknown {kind}key `{}`{times}", first.key);
    let mut finding = RULE
        .at(file, Place::Key(first.pointer.clone()), message)
        .key(format!("{}{owner}", first.key))
        .help(did_you_mean(
            first.nearest.as_deref(),
            "remove it, or keep notes under `comment`",
        ))
        .parts(all.iter().map(|unknown| &unknown.name))
        .evidence(Evidence::of_cases(
            all.iter().map(|unknown| &unknown.pointer),
        ));
    if file.kind == Kind::Skeleton && first.nearest.as_deref() == Some("rotation_plane") {
        finding = finding.case(NO_PLANE);
    } else if let Some(loss) = of_misspelt(view, file, first) {
        finding = loss.of(view, finding);
    } else if let Some(noun) = nested(file, first) {
        finding = finding
            .case(NESTED)
            .help(format!("move it one level up if it is a {noun} of its own"));
    }
    for other in all.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(
            file.path.clone(),
            Place::Key(other.pointer.clone()),
            "also here",
        );
    }
    Some(finding)
}
