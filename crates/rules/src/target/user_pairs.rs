//! User targets that look like the two halves of a slider and are none to the scan
//! (`docs/loaders/makehuman2/user-targets.md#pairs`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::Rule;
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::user_scan::{self, UserTarget};
use mhlint_repo::makehuman2::{Base, View};

const NO_PAIR: Case = &[(
    Makehuman2,
    Level::Warning,
    "creates two sliders with one direction each: it replaces every `incr` in the name to find \
        the opposite",
)];
const ONE_SIDE: Case = &[(
    Makehuman2,
    Level::Warning,
    "creates a slider with the increasing direction only, and cuts the last letters off its name",
)];

/// Targets by folder and stem.
type Known<'t, 'f> = BTreeMap<(Option<&'t str>, &'t str), &'t UserTarget<'f>>;

/// Findings on the user's pairs of which no slider with two directions is made.
pub(super) fn findings(rule: &Rule, view: &View<'_>, base: &Base<'_>) -> Vec<Finding> {
    let is_own = base
        .user_targets
        .is_some_and(|folder| std::ptr::eq(folder.layer, view.layers.checked));
    let targets = if is_own {
        user_scan::targets(base)
    } else {
        Vec::new()
    };
    let all: Known<'_, '_> = targets
        .iter()
        .map(|one| ((one.folder, one.stem), one))
        .collect();
    let of_user = base.sliders.iter().filter(|bound| bound.slider.user);
    let listed: BTreeSet<&str> = of_user
        .filter_map(|bound| bound.slider.incr.as_deref())
        .collect();
    targets
        .iter()
        .filter_map(|target| of_target(rule, base, (&all, &listed), target))
        .collect()
}

fn of_target(
    rule: &Rule,
    base: &Base<'_>,
    (all, listed): (&Known<'_, '_>, &BTreeSet<&str>),
    target: &UserTarget<'_>,
) -> Option<Finding> {
    let begin = target
        .stem
        .strip_suffix("incr")
        .filter(|begin| !begin.is_empty())?;
    let other = format!("{begin}decr");
    let partner = all.get(&(target.folder, other.as_str()))?;
    let (one, other) = (target.stem, partner.stem);
    if begin.contains("incr") {
        let looked_for = target.stem.replace("incr", "decr");
        let message =
            format!("`{one}` and `{other}` are not a pair: MakeHuman 2 looks for `{looked_for}`");
        let help = "rename both without `incr` before the ending";
        return Some(
            finding(rule, target.file, partner.file, message)
                .case(NO_PAIR)
                .help(help),
        );
    }
    if begin.ends_with('-') || is_listed(base, listed, target.file) {
        return None;
    }
    let message = format!("`{one}` and `{other}` have no `-` before their ending");
    let name = begin.trim_end_matches(['_', ' ', '.']);
    let help = format!("rename them to `{name}-incr.target` and `{name}-decr.target`");
    Some(
        finding(rule, target.file, partner.file, message)
            .case(ONE_SIDE)
            .help(help),
    )
}

/// Whether the generated sliders have it already: `modelling-opposites` says the same of these.
fn is_listed(base: &Base<'_>, listed: &BTreeSet<&str>, file: &FileFacts) -> bool {
    let name = base.user_targets.and_then(|folder| folder.name_of(file));
    name.is_some_and(|name| listed.contains(name))
}

fn finding(rule: &Rule, file: &FileFacts, other: &FileFacts, message: String) -> Finding {
    rule.at(file, Place::File, message)
        .related(other.path.clone(), Place::File, "the opposite")
}
