//! Keys that no application reads.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo};
use crate::json::UnknownKey;
use crate::repo::{FileFacts, Layer};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "ignores the key without a word")],
        docs: "Every loader takes the keys it knows and leaves the others, so a misspelt key is as good as none: the slider \
            has no partner, the bone no parent.\n\nThe usual trap is `sym`: sliders have `rsym` on the left side (it names \
            the right partner) and `lsym` on the right side.\n\nCorrect the key, or remove it. Notes are welcome under \
            `comment` or `description`.",
        ..RuleInfo::new("json-unknown-key", Level::Info, "a key that no application reads")
    },
    check: Check::Layer(run),
};

fn run(layer: &Layer, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in layer.files.values().filter(|file| !file.is_ignored_override()) {
        let mut by_key: BTreeMap<(&str, Option<&str>), Vec<&UnknownKey>> = BTreeMap::new();
        for unknown in &file.schema.unknown {
            by_key.entry((&unknown.key, unknown.object.as_deref())).or_default().push(unknown);
        }
        out.extend(by_key.into_values().filter_map(|all| judge(file, &all)));
    }
}

/// One finding for a key, however many objects have it.
fn judge(file: &FileFacts, all: &[&UnknownKey]) -> Option<Finding> {
    let first = all.first()?;
    let owner = first.object.as_deref().map(|object| format!(" of a {}", object.to_lowercase())).unwrap_or_default();
    let times = if all.len() == 1 { String::new() } else { format!(" ({} times)", all.len()) };
    let message = format!("no application reads the key `{}`{owner}{times}", first.key);
    let mut finding = RULE
        .at(file, Place::Key(first.pointer.clone()), message)
        .key(format!("{}{owner}", first.key))
        .help(match &first.nearest {
            Some(nearest) => format!("did you mean `{nearest}`?"),
            None => "remove it, or keep notes under `comment`".to_owned(),
        })
        .evidence(Evidence::of_cases(all.iter().map(|unknown| &unknown.pointer)).unnamed());
    for other in all.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(file.path.clone(), Place::Key(other.pointer.clone()), "here, too");
    }
    Some(finding)
}
