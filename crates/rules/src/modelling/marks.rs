//! The key `user`, which marks sliders of the user's targets: where it should not be, and where it
//! is missing.

use std::collections::BTreeSet;

use super::super::cause::is_generated_for;
use super::super::{Rule, such};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_repo::makehuman2::Base;
use mhlint_repo::{Reference, ReferenceKind};

/// What becomes of an entry of the generated file whose target is gone.
pub(super) const OF_GENERATED: &str = "crashes with `AttributeError` when the slider moves; if the \
    folder is newer than the file, it writes the file again and the slider disappears";
pub(super) const ANEW: &str = "delete modelling.json and target_cat.json in this folder: \
    MakeHuman 2 writes them again from the user targets";

/// Sliders of the system that say that their targets are a user's.
pub(super) fn needless(rule: &Rule, marked: &[&Reference<'_>]) -> Option<Finding> {
    let first = marked.first()?;
    let owners: BTreeSet<&str> = marked.iter().map(|reference| reference.owner).collect();
    let more = such(owners.len(), "entries");
    let key = first.owner;
    let message = format!(
        "`{key}` has the key `user`, so `{}` is expected among the user targets{more}",
        first.text
    );
    let finding = rule
        .at(first.from, Place::key([key, "user"]), message)
        .key("user");
    let effect = "does not find the target in the user's folder and crashes with `AttributeError` \
        when the slider moves";
    let help = "remove the key `user`, whatever its value; only the file that MakeHuman 2 writes \
        for user targets needs it";
    Some(
        finding
            .effect(effect)
            .help(help)
            .evidence(Evidence::of_cases(owners)),
    )
}

/// A target of the user in an entry that does not say so.
pub(super) fn missing(
    rule: &Rule,
    base: &Base<'_>,
    first: &Reference<'_>,
    count: usize,
) -> Option<Finding> {
    let own = base
        .user_targets
        .filter(|_| is_generated_for(base, first.from))?;
    own.target(first.text)?;
    let system = base.targets.map_or_else(
        || format!("target/{}", base.name),
        |folder| folder.layer.display(&folder.rel()),
    );
    let side = if first.kind == ReferenceKind::Incr {
        "incr"
    } else {
        "decr"
    };
    let more = such(count, "names");
    let message = format!(
        "`{}` lacks the key `user`, so `{}` is expected in `{system}`{more}",
        first.owner, first.text
    );
    let finding = rule
        .at(first.from, first.place.clone(), message)
        .key(format!("{} {side}", first.owner));
    let effect = "does not look for the target in the user's folder and crashes with \
        `AttributeError` when the slider moves";
    Some(finding.effect(effect).help(format!(
        "move sliders and macros of your own to `contarget/{}`, then {ANEW}",
        base.name
    )))
}
