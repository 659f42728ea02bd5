//! MPFB recognises a user's rig by bones that no other rig has.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::identify::built_in;
use mhlint_formats::rig::{Identifying, Rig};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "adds the rig, and does not recognise it: refitting it fails, also after a slider moves",
    )],
    docs: include_str!("identifying_bones.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-identifying-bones",
        Level::Error,
        "a rig of a user that is not recognised",
    )
});

const TAKEN_FOR: Case = &[(
    Mpfb,
    Level::Warning,
    "takes the rig for one of its own, and refits and saves it as that",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view
        .own_rigs()
        .filter(|(file, _)| file.part == RigPart::Custom)
    {
        let bones: BTreeSet<&str> = rig.bones.iter().map(|bone| bone.name.as_str()).collect();
        out.extend(unknown(file, rig, &bones, cx));
        let is_whole = rig.identifying != Identifying::Absent && !bones.is_empty();
        let own = built_in(|name| bones.contains(name)).filter(|_| is_whole);
        let Some((name, marks)) = own else { continue };
        let marks: Vec<String> = marks.iter().map(|mark| format!("`{mark}`")).collect();
        let message = format!(
            "the rig has {}: it is taken for the rig `{name}`",
            marks.join(" and ")
        );
        let finding = RULE
            .at(file.file, Place::File, message)
            .key("built-in")
            .case(TAKEN_FOR);
        out.push(finding.help("give these bones other names, here and in the weights"));
    }
}

fn unknown(
    file: &RigFile<'_>,
    rig: &Rig,
    bones: &BTreeSet<&str>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let at = |message: String| {
        RULE.at(file.file, Place::pointer(["identifying_bones"]), message)
            .key("bones")
    };
    let names = match &rig.identifying {
        Identifying::Absent => return None,
        Identifying::Other(found) => {
            let finding = at(format!(
                "`identifying_bones` is {found}, expected a list of bones"
            ));
            return Some(finding.help("write a list with names of bones"));
        }
        Identifying::Bones(names) if names.is_empty() => {
            let finding = at("`identifying_bones` is empty".to_owned());
            return Some(finding.help("name bones of this rig that no other rig has"));
        }
        Identifying::Bones(names) => names,
    };
    if bones.is_empty() {
        return None;
    }
    let unknown: Vec<&str> = names
        .iter()
        .map(String::as_str)
        .filter(|name| !bones.contains(name))
        .collect();
    let first = unknown.first()?;
    let message = format!(
        "`identifying_bones` names `{first}`, which the rig does not have{}",
        such(unknown.len(), "names")
    );
    let near = cx.suggestions.nearest(first, bones.iter().copied());
    Some(
        at(message)
            .help(did_you_mean(near, "name bones of this rig"))
            .evidence(Evidence::of_cases(&unknown)),
    )
}
