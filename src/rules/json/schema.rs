//! A JSON must fit the schema of its format.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, structural};
use crate::discover::Kind;
use crate::json::SchemaFault;
use crate::repo::{FileFacts, Layer};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "takes the value unchecked and fails where it is used, mostly with a TypeError or KeyError at start",
        )],
        docs: "Each format has a JSON Schema that says which keys an object needs and what their values are; `mhlint schema \
            NAME` prints it, and editors can complete and check by it.\n\nMakeHuman 2 checks almost nothing when it reads a \
            JSON. A text in place of a number, or a missing key, becomes an exception wherever the value is used first, \
            often at start. In a few places the entry is skipped without a word instead; that is a warning.\n\nWrite the \
            value as the schema wants it.",
        ..RuleInfo::new("json-schema", Level::Error, "a value does not fit the schema of its format")
    },
    check: Check::Layer(run),
};

fn run(layer: &Layer, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in layer.files.values().filter(|file| !file.is_ignored_override()) {
        let mut by_keyword: BTreeMap<(&str, String), Vec<&SchemaFault>> = BTreeMap::new();
        for fault in &file.schema.faults {
            by_keyword.entry((&fault.keyword, missing(fault))).or_default().push(fault);
        }
        out.extend(by_keyword.into_iter().filter_map(|((keyword, _), all)| judge(file, keyword, &all)));
    }
}

/// Two missing keys of one object fail at the same keyword; they are two faults.
fn missing(fault: &SchemaFault) -> String {
    fault.message.split_once(" has no ").map(|(_, key)| key.to_owned()).unwrap_or_default()
}

/// One finding for all values that fail in the same way.
fn judge(file: &FileFacts, keyword: &str, all: &[&SchemaFault]) -> Option<Finding> {
    let first = all.first()?;
    let message = match all.len() {
        1 => first.message.clone(),
        count => format!("{} ({count} values like it)", first.message),
    };
    let mut finding = RULE.at(file, Place::Pointer(first.pointer.clone()), message);
    finding = finding.key(format!("{keyword}{}", missing(first))).help(help(first));
    if let Some(effect) = gentle(file.kind, keyword) {
        finding = finding.level(Level::Warning).breaks(Application::Makehuman2, effect);
    }
    for other in all.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(file.path.clone(), Place::Pointer(other.pointer.clone()), other.message.clone());
    }
    let parts = all.iter().map(|fault| structural(&fault.pointer));
    Some(finding.parts(parts).evidence(Evidence::of_cases(all.iter().map(|fault| &fault.pointer))))
}

fn help(fault: &SchemaFault) -> String {
    fault.description.clone().unwrap_or_else(|| "`mhlint schema` shows what the format wants".to_owned())
}

/// Where a wrong value stops nothing: the effect in place of the usual one.
fn gentle(kind: Kind, keyword: &str) -> Option<&'static str> {
    match (kind, keyword) {
        // formats/makehuman2.md §9: read by scripts only.
        (Kind::Geometry, _) => Some("never reads this file; the scripts that align joint cubes stop"),
        // §3.1: an entry without `name` or `t` is skipped; one whose name is no text is never met.
        (Kind::MacroJson, "/$defs/target/required" | "/$defs/target/properties/name/type") => {
            Some("skips the combination without a word")
        }
        // §7: for the tools that compile meshes and adapt morphs.
        (Kind::BaseJson, "/properties/numverts/type") => Some("does not read the number; its mesh tools do"),
        (Kind::BaseJson, "/$defs/random/properties/groups/additionalProperties/type") => {
            Some("takes anything but 0, empty and null for true")
        }
        _ => None,
    }
}
