//! Name, version and licence of weights.

use super::super::{Check, Rule, RuleCx, either};
use super::readable;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "stores `name` and `version` without using them, and never reads `license`",
        ),
        (Makehuman1, "stores these keys without using them"),
    ],
    docs: include_str!("metadata.md").trim_ascii_end(),
    ..RuleInfo::new(
        "weights-metadata",
        Level::Info,
        "a weights file has no name, version or licence",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (own, weights) in readable(body) {
        let missing = EXPECTED
            .iter()
            .filter(|key| !weights.metadata.iter().any(|known| known == *key));
        let missing: Vec<String> = missing.map(|key| format!("`{key}`")).collect();
        if missing.is_empty() {
            continue;
        }
        let message = format!("the weights file has no {}", either(&missing));
        out.push(
            RULE.at(own.file, Place::File, message)
                .parts(&missing)
                .help("add them next to `weights`"),
        );
    }
}

/// Keys that every weights file should have.
const EXPECTED: [&str; 3] = ["name", "version", "license"];
