//! A macro has a target for each combination of values.

use super::super::{Check, Rule, RuleCx, such};
use super::macro_group::macro_groups;
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "leaves the figure without this part of its shape at these settings")],
    docs: "The targets of a macro of MakeHuman 1 have the values of several categories in their names. A combination without a \
        target adds nothing at its settings.\n\n\
        A value that no target of the group has, such as `averageheight`, is left out on purpose, and so is a pair of values \
        that never occurs together. The rule reports the other combinations that are missing. A file whose name does not fit \
        is `target-macro-token`.\n\n\
        Add the target; it may be empty.",
    ..RuleInfo::new("target-missing-combination", Level::Warning, "a combination of macro values without a target")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for group in macro_groups(view) {
        let holes: Vec<String> = group.holes().into_iter().map(|values| values.join("-")).collect();
        let (Some(first), Some(target)) = (holes.first(), group.targets.first()) else { continue };
        let message =
            format!("no target of `{}` has the values `{first}`{}", group.name, such(holes.len(), "combinations"));
        let finding = RULE
            .at(target.file, Place::File, message)
            .key(group.name)
            .asset(view.layers.checked.display(target.file.folder()));
        let finding = finding.parts(holes.iter().map(String::as_str));
        out.push(
            finding
                .evidence(Evidence::of_cases(holes.iter().map(String::as_str)))
                .help("add the target; it may be empty"),
        );
    }
}
