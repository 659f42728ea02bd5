//! The frames of which expressions are made have a name each.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `RuntimeError` when the expressions are opened: it lists them and shows none",
    )],
    docs: include_str!("framemapping.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-framemapping",
        Level::Error,
        "the face units of MakeHuman 1 have other names than frames",
    )
});

const KEY: &str = "framemapping";
const TWICE: Case = &[(
    Makehuman1,
    Level::Warning,
    "never uses the second frame of that name",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, names)) = view
        .face
        .names
        .filter(|(file, _)| view.layers.is_checked(file))
    else {
        return;
    };
    if let Some((frames, motion)) = view
        .face
        .frames()
        .zip(view.face.motion)
        .filter(|(frames, _)| *frames != names.len())
    {
        let message = format!(
            "{} for {} of `{}`",
            counted(names.len(), "name"),
            counted(frames, "frame"),
            motion.0.file_name()
        );
        let finding = RULE.at(file, Place::pointer([KEY]), message).related(
            motion.0.path.clone(),
            Place::File,
            "the frames",
        );
        out.push(finding.help("write one name for each frame, in their order"));
        return;
    }
    let mut known = BTreeSet::new();
    let again: Vec<(usize, &str)> = names
        .iter()
        .map(String::as_str)
        .enumerate()
        .filter(|(_, name)| !known.insert(*name))
        .collect();
    let Some((at, name)) = again.first() else {
        return;
    };
    let message = match again.len() {
        1 => format!("two frames are called `{name}`"),
        count => format!("{count} frames have the name of another one, first `{name}`"),
    };
    let place = Place::Pointer(format!("/{KEY}/{at}"));
    let finding = RULE.at(file, place, message).key("twice").case(TWICE);
    let evidence = Evidence::of_cases(again.iter().map(|(_, name)| *name)).out_of(names.len());
    out.push(
        finding
            .evidence(evidence)
            .help("give every frame a name of its own"),
    );
}
