//! A part of a program's data, as ports take some: said once, in place of all that is missing.

use super::super::{Check, Rule, RuleCx, enumerated};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "does not work with this folder alone; the files in it were checked singly",
        ),
        (
            Makehuman1,
            "does not work with this folder alone; the files in it were checked singly",
        ),
        (
            Mpfb,
            "does not work with this folder alone; the files in it were checked singly",
        ),
    ],
    docs: include_str!("partial_copy.md").trim_ascii_end(),
    counts: "targets",
    of_library: true,
    of_pieces: true,
    ..RuleInfo::new(
        "program-partial-copy",
        Level::Info,
        "a part of a program's data",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.is_partial() {
        return;
    }
    let lacking: Vec<String> = view
        .lacking()
        .iter()
        .map(|folder| format!("`{folder}/`"))
        .collect();
    let gaps = view.gaps();
    let (missing, named) = (gaps.missing.len(), gaps.named);
    let targets = format!("{missing} of {named} targets that its indexes name");
    let what = match (lacking.is_empty(), missing) {
        (true, _) => format!("the base mesh and {targets}"),
        (false, 0) => enumerated(&lacking),
        (false, _) => format!("{}, and {targets}", enumerated(&lacking)),
    };
    let message = format!(
        "a part of the data of {}: {what} are missing",
        view.application()
    );
    let finding = RULE
        .in_layer(view.layers().checked, "", message)
        .key("partial");
    let evidence = Evidence::of_cases(gaps.missing.iter().copied()).out_of(named);
    out.push(if missing > 0 {
        finding.evidence(evidence)
    } else {
        finding
    });
}
