//! A saved character of MPFB has the keys and values that its loader takes, and names what exists.

use super::super::cause::consequence::NO_PART;
use super::super::unfit::{findings, is_misspelt, top};
use super::super::{Check, Rule, RuleCx};
use super::names::{NO_RIG, Named, named};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo, steps};
use mhlint_discover::Kind;
use mhlint_formats::human_preset::HumanPreset;
use mhlint_formats::unfit::{Unfit, Why};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "fails with an exception when the character is loaded, which leaves it half-built")],
    docs: "A saved character of MPFB (`config/human.<name>.json`) needs `phenotype`, `skin_mhmat` and `skin_material_type`.\n\n\
        `phenotype` is null, or has `race` and no other keys than the eight settings; all values are numbers. `targets` is a \
        list of objects with `target` and `value`. MPFB builds the character step by step, and fails with an exception at \
        the first key or value that it does not take: what comes later is missing. A rig that does not exist and a \
        makeup file that does not exist stop it as well. `clothes` as a string is read letter by letter: all clothes are \
        missing.\n\n\
        What else does not exist is left out, with a message in the log (a warning): targets, assets, the skin, \
        expressions. A target is found by its name in whatever capitals; the beginning of a name is enough, but if several \
        begin so, the disk decides. A value outside 0 to 1 is limited.\n\n\
        Names are checked where both the data of MPFB and the user's are at hand.\n\n\
        Correct the key, the value or the name, or save the character again.",
    ..RuleInfo::new("preset-schema", Level::Error, "a saved character with what its loader does not take or find")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::HumanPreset) {
        let Some(preset) = file.human_preset() else { continue };
        let stops = findings(&RULE, file, &preset.stops, cx);
        out.extend(stops.map(|(first, finding)| if top(first) == "rig" { finding.effect(NO_RIG) } else { finding }));
        let ignored = findings(&RULE, file, &preset.ignored, cx);
        out.extend(ignored.map(|(first, finding)| passed_over(view, first, finding)));
        let unread = findings(&RULE, file, &preset.unread, cx).filter(|(first, _)| is_misspelt(first, cx));
        out.extend(
            unread
                .map(|(_, finding)| finding.level(Level::Warning).effect("silently ignores the key and what it holds")),
        );
        if view.is_complete() {
            out.extend(unknown(view, file, preset, cx));
        }
    }
}

/// What does not stop the loader has a consequence of its own.
fn passed_over(view: &View<'_>, first: &Unfit, finding: Finding) -> Finding {
    let setting = steps(&first.pointer).last().unwrap_or_default();
    let (level, effect) = match (top(first).as_str(), &first.why) {
        ("clothes", _) => (Level::Error, "reads the string letter by letter: all clothes are missing"),
        ("phenotype", Why::Range(value)) if view.leaves_no_shape(&setting, *value) => return finding.case(NO_PART),
        ("phenotype", Why::Range(_)) => (Level::Warning, "does not limit the value: the shape of this macro vanishes"),
        ("targets", Why::Range(_)) => (Level::Warning, "limits the value to the range from 0 to 1"),
        ("targets", _) => (Level::Warning, "applies the target twice"),
        ("skin_material_type", _) => (Level::Warning, "shows the body without a material, without a message"),
        ("expressions", Why::Range(_)) => (Level::Warning, "passes the value on to the face, which is distorted"),
        ("expressions", _) => (Level::Warning, "silently drops the expression"),
        _ => (Level::Warning, "ignores the value"),
    };
    finding.level(level).effect(effect)
}

/// Findings on names that lead nowhere.
fn unknown(view: &View<'_>, file: &FileFacts, preset: &HumanPreset, cx: &RuleCx<'_>) -> Vec<Finding> {
    named(view, preset, cx)
        .into_iter()
        .map(|Named { at, message, key, help, level, effect, cases }| {
            let finding = RULE.at(file, Place::Pointer(at), message).key(key).help(help);
            finding.evidence(cases).level(level).effect(effect)
        })
        .collect()
}
