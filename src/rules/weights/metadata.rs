//! Name, version and licence of weights.

use super::super::{Check, Rule, RuleCx};
use super::readable;
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, "keeps `name` and `version` without using them, and does not read `license`"),
            (Application::Makehuman1, "keeps what is there without using it"),
            (Application::Mpfb, "never reads any of it"),
        ],
        docs: "`name`, `version` and `license` have no effect on the shape. They tell people what the weights are \
            for and whether they may be passed on.\n\nAdd them beside `weights`.",
        ..RuleInfo::new("weights-metadata", Level::Info, "weights do not say what they are")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (own, weights) in readable(body) {
        let missing = EXPECTED.iter().filter(|key| !weights.metadata.iter().any(|known| known == *key));
        let missing: Vec<String> = missing.map(|key| format!("`{key}`")).collect();
        if missing.is_empty() {
            continue;
        }
        let message = format!("the weights have no {}", missing.join(", no "));
        out.push(RULE.at(own.file, Place::File, message).parts(&missing).help("add them beside `weights`"));
    }
}

/// Keys that every weights file should have.
const EXPECTED: [&str; 3] = ["name", "version", "license"];
