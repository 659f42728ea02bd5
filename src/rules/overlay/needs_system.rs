//! What cannot be judged because the system data was not given.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::counted;
use crate::diag::{Application, Evidence, Finding, Level, RuleInfo};
use crate::repo::{Base, Reference, Repository, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "finds the files if its system data has them, otherwise not")],
        docs: "User data lies over the data that comes with MakeHuman 2. Names in it may lead to files there, which \
            `mhlint` cannot know when it is given the user's folder alone. Nothing is wrong with such names, but nothing is \
            checked either.\n\nGive the system data: `mhlint my-data --system <MakeHuman 2>/data`. It is read and not \
            reported on.",
        ..RuleInfo::new(
            "overlay-needs-system",
            Level::Info,
            "references that cannot be judged without the system data (`--system`)",
        )
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // With a macro.json that is refused, targets are searched in the wrong folder in the first place.
    if base.macros.contarget.is_refused() {
        return;
    }
    let open = |reference: &&Reference<'_>| matches!(reference.resolution, Resolution::NeedsSystem);
    let open: Vec<&Reference<'_>> = repository.references_of(base).filter(open).collect();
    let mut by_file: BTreeMap<&str, Vec<&Reference<'_>>> = BTreeMap::new();
    for reference in &open {
        by_file.entry(&reference.from.path).or_default().push(reference);
    }
    let most = by_file.values().rev().max_by_key(|references| references.len());
    let Some(first) = most.and_then(|references| references.first()) else { return };
    let message = format!(
        "{} of base `{}` cannot be judged without the system data (`--system`)",
        counted(open.len(), "reference"),
        base.name
    );
    let finding = RULE.at(first.from, first.place.clone(), message).key(base.name);
    let finding = finding.asset(&repository.judged.path);
    let help = "add `--system` with the data folder of MakeHuman 2; it is read and not reported";
    let of = repository.references_of(base).count();
    out.push(finding.help(help).evidence(Evidence::of_cases(open.iter().map(|open| &open.rel)).out_of(of)));
}
