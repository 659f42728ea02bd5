//! Bones have all keys that MPFB needs, with values of the types that Blender takes.

use std::collections::BTreeMap;

use super::super::unfit::findings_in;
use super::super::{Check, Rule, RuleCx, either, enumerated, such};
use super::{IN_BONES, STOPS, is_of_bone, stops, subject};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_formats::rig::Rig;
use mhlint_formats::unfit::{Unfit, Why};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("missing_key.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-missing-key",
        Level::Error,
        "a key of a rig is missing or of another type",
    )
});

const NO_PANEL: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception after the rig is made: there are neither weights nor parenting",
)];

const LETTERS: Case = &[(
    Mpfb,
    Level::Warning,
    "reads the text letter by letter: the bone that it names takes no weights",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        out.extend(bones_without(file, rig).map(|finding| stops(file, finding)));
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.keys, cx);
        let others = found.filter(|(one, _)| !is_lack_of_bone(one));
        out.extend(others.map(|(_, finding)| stops(file, finding)));
        let texts = findings_in(IN_BONES, &RULE, file.file, &rig.faults.letters, cx);
        out.extend(texts.map(|(_, finding)| finding.case(LETTERS)));
        if file.part == RigPart::Rigify && rig.has_header && !rig.has_rigify_ui {
            let finding = RULE
                .at(file.file, Place::File, "the rig has no `rigify_ui`")
                .key("rigify_ui")
                .case(NO_PANEL);
            out.push(finding.help("add `rigify_ui` with the colours and collections of its panel"));
        }
    }
}

fn is_lack_of_bone(one: &Unfit) -> bool {
    matches!(one.why, Why::Lacks(_)) && is_of_bone(&one.pointer)
}

/// A finding for all bones that lack the same keys.
fn bones_without<'f>(
    file: &'f RigFile<'_>,
    rig: &'f Rig,
) -> impl Iterator<Item = Finding> + use<'f> {
    let mut of_bones: BTreeMap<&str, Vec<&'static str>> = BTreeMap::new();
    for one in rig
        .faults
        .keys
        .all()
        .iter()
        .filter(|one| is_lack_of_bone(one))
    {
        if let Why::Lacks(key) = one.why {
            of_bones.entry(&one.pointer).or_default().push(key);
        }
    }
    let by_keys = grouped(of_bones.into_iter().map(|(pointer, keys)| (keys, pointer)));
    by_keys.into_iter().filter_map(move |(keys, bones)| {
        let keys: Vec<String> = keys.iter().map(|key| format!("`{key}`")).collect();
        let first = bones.first()?;
        let message = format!(
            "{} has no {}{}",
            subject(first),
            either(&keys),
            such(bones.len(), "bones")
        );
        let finding = RULE
            .at(file.file, Place::Key((*first).to_owned()), message)
            .key(keys.join(" "));
        let help = format!("add {}", enumerated(&keys));
        Some(
            finding
                .help(help)
                .evidence(Evidence::of_cases(&bones).out_of(rig.bones.len())),
        )
    })
}
