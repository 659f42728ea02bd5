//! Two user targets must not be given the same key.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::makehuman2::{Base, View, user_scan};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "makes one slider of them; the order of files in the folder decides which target is lost",
    )],
    docs: include_str!("user_key_collision.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "modelling-user-key-collision",
        Level::Error,
        "two user targets get the same key",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let targets = user_scan::targets(base);
    let by_key = grouped(
        user_scan::entries(&targets)
            .into_iter()
            .map(|entry| (entry.key, entry.file)),
    );
    for (key, files) in by_key.iter() {
        let Some((last, others)) = files.split_last().filter(|(_, others)| !others.is_empty())
        else {
            continue;
        };
        let message = format!(
            "{} user targets become the same slider `{key}`",
            files.len()
        );
        let mut finding = RULE
            .at(last, Place::File, message)
            .key(key)
            .help(
                "rename the newer of the files, as saved models know its slider by the name; \
                case, `-` and spaces make no difference",
            )
            .evidence(Evidence::of_cases(
                files.iter().map(|file| file.file_name()),
            ));
        for other in others {
            finding = finding.related(other.path.clone(), Place::File, "gets the same key");
        }
        out.push(finding);
    }
}
