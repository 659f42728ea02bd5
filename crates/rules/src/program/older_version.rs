//! Data of an older version of a program: said once, in place of all that came later.

use super::super::{Check, Rule, RuleCx};
use super::later::later;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "works with data of its own version; newer programs miss what came later",
        ),
        (
            Makehuman1,
            "works with data of its own version; newer programs miss what came later",
        ),
        (
            Mpfb,
            "works with data of its own version; newer programs miss what came later",
        ),
    ],
    docs: include_str!("older_version.md").trim_ascii_end(),
    of_library: true,
    of_pieces: true,
    ..RuleInfo::new(
        "program-older-version",
        Level::Info,
        "data of an older version of a program",
    )
});

const IN_PIECES: Case = &[(
    Makehuman1,
    Level::Info,
    "since 1.1 does not work with this folder as a whole; the files in it were checked singly",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let Some(version) = view.version().filter(|_| layers.checks_system()) else {
        return;
    };
    if version.is_newest() || layers.checked.is_loose {
        return;
    }
    // Who asks for a version knows it, but not what becomes of such a folder.
    let identity = layers.checked.identities.get(&version.application());
    if identity.is_some_and(|identity| identity.is_version_asked) && !view.is_in_pieces() {
        return;
    }
    let Some(later) = later(version) else { return };
    let message = format!("data of {}: {later} came later", version.title());
    let finding = RULE.in_layer(layers.checked, "", message).key("version");
    let finding = if view.is_in_pieces() {
        finding.case(IN_PIECES)
    } else {
        finding
    };
    out.push(finding);
}
