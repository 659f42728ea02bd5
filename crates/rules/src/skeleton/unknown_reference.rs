//! Referenced bones must exist in the default skeleton.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, such};
use super::unknown_names::{finding, of_makehuman1};
use super::{Rig, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "ignores these names; the bone gets weights and poses from its other \
            references, if any",
        ),
        (
            Makehuman1,
            "fails with `KeyError` when the skeleton is chosen",
        ),
    ],
    levels: &[(Makehuman1, Level::Error)],
    docs: include_str!("unknown_reference.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-unknown-reference",
        Level::Warning,
        "a bone refers to bones that the default skeleton does not have",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(default) = body.default_rig() else {
        return;
    };
    let Some(pose) = default.skeleton() else {
        return;
    };
    let known: BTreeSet<&str> = pose.bones.iter().map(|bone| bone.name.as_str()).collect();
    if known.is_empty() {
        return;
    }
    if body.is_makehuman1() {
        return of_makehuman1(&RULE, body, &known, cx, out);
    }
    for rig in rigs(body) {
        let (mut unknown, mut spelled) = (Vec::new(), Vec::new());
        for bone in &rig.skeleton.bones {
            for (member, names) in [
                ("reference", &bone.reference),
                ("weights_reference", &bone.weights_reference),
            ] {
                let text = bone.text_references.iter().find(|(key, _)| *key == member);
                let names: Vec<&String> = names
                    .iter()
                    .flatten()
                    .filter(|name| !known.contains(name.as_str()))
                    .collect();
                match text {
                    Some((_, text)) if !names.is_empty() => {
                        spelled.push((bone.name.as_str(), member, text.as_str()));
                    }
                    Some(_) => {}
                    None => unknown.extend(
                        names
                            .into_iter()
                            .map(|name| (bone.name.as_str(), member, name.as_str())),
                    ),
                }
            }
        }
        let found = spelled_out(&rig, &spelled, &known)
            .into_iter()
            .chain(finding(&RULE, &rig, &unknown, &known, cx));
        // Others refer to the default skeleton; what it refers to itself is never read.
        let is_default = std::ptr::eq(rig.file, default.file);
        out.extend(found.map(|one| {
            if is_default {
                one.case(OF_DEFAULT)
            } else {
                one
            }
        }));
    }
}

const OF_DEFAULT: Case = &[(
    Makehuman2,
    Level::Info,
    "never reads references in the default skeleton",
)];

/// Texts in place of lists. What writes one writes all of them so.
fn spelled_out(
    rig: &Rig<'_>,
    texts: &[(&str, &str, &str)],
    known: &BTreeSet<&str>,
) -> Option<Finding> {
    let (bone, member, text) = texts.first()?;
    let more = such(texts.len(), "strings");
    let message = format!(
        "`{member}` of bone `{bone}` is the string `{text}`, which is read letter by letter{more}"
    );
    let finding = RULE
        .at(rig.file, Place::pointer(["bones", bone, member]), message)
        .key("strings");
    let cases = texts
        .iter()
        .map(|(bone, member, _)| format!("{bone}/{member}"));
    let finding = finding
        .parts(cases.clone())
        .evidence(Evidence::of_cases(cases).out_of(rig.skeleton.bones.len()));
    let help = if known.contains(text) {
        format!("write a list: `[\"{text}\"]`")
    } else {
        "write a list with names of bones of the default skeleton".to_owned()
    };
    Some(finding.help(help))
}
