//! A saved character of MPFB has the keys and values that its loader takes, and names what exists.

use super::super::cause::consequence::NO_PART;
use super::super::unfit::{findings, is_misspelt, top};
use super::super::{Check, Rule, RuleCx};
use super::names::{Known, NO_RIG, Named, named};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo, steps};
use mhlint_discover::Kind;
use mhlint_formats::human_preset::HumanPreset;
use mhlint_formats::unfit::{Unfit, Why};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails with an exception when the character is loaded, which leaves it half-built",
    )],
    docs: include_str!("schema.md").trim_ascii_end(),
    ..RuleInfo::new(
        "preset-schema",
        Level::Error,
        "a saved character with what its loader does not take or find",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let known = Known::of(view);
    for file in view.own(Kind::HumanPreset) {
        let Some(preset) = file.human_preset() else {
            continue;
        };
        let stops = findings(&RULE, file, &preset.stops, cx);
        out.extend(stops.map(|(first, finding)| {
            if top(first) == "rig" {
                finding.effect(NO_RIG)
            } else {
                finding
            }
        }));
        let ignored = findings(&RULE, file, &preset.ignored, cx);
        out.extend(ignored.map(|(first, finding)| passed_over(view, first, finding)));
        let unread =
            findings(&RULE, file, &preset.unread, cx).filter(|(first, _)| is_misspelt(first, cx));
        out.extend(unread.map(|(_, finding)| {
            finding
                .level(Level::Warning)
                .effect("silently ignores the key and what it holds")
        }));
        if view.is_complete() {
            out.extend(unknown(view, &known, file, preset, cx));
        }
    }
}

/// What does not stop the loader has a consequence of its own.
fn passed_over(view: &View<'_>, first: &Unfit, finding: Finding) -> Finding {
    let setting = steps(&first.pointer).last().unwrap_or_default();
    let (level, effect) = match (top(first).as_str(), &first.why) {
        ("clothes", _) => (
            Level::Error,
            "reads the string letter by letter: all clothes are missing",
        ),
        ("phenotype", Why::Range(value)) if view.leaves_no_shape(&setting, *value) => {
            return finding.case(NO_PART);
        }
        ("phenotype", Why::Range(_)) => (
            Level::Warning,
            "does not limit the value: the shape of this macro vanishes",
        ),
        ("targets", Why::Range(_)) => (Level::Warning, "limits the value to the range from 0 to 1"),
        ("targets", _) => (Level::Warning, "applies the target twice"),
        ("skin_material_type", _) => (
            Level::Warning,
            "shows the body without a material, without a message",
        ),
        ("expressions", Why::Range(_)) => (
            Level::Warning,
            "passes the value on to the face, which is distorted",
        ),
        ("expressions", _) => (Level::Warning, "silently drops the expression"),
        _ => (Level::Warning, "ignores the value"),
    };
    finding.level(level).effect(effect)
}

/// Findings on names that lead nowhere.
fn unknown(
    view: &View<'_>,
    known: &Known,
    file: &FileFacts,
    preset: &HumanPreset,
    cx: &RuleCx<'_>,
) -> Vec<Finding> {
    named(view, known, preset, cx)
        .into_iter()
        .map(
            |Named {
                 at,
                 message,
                 key,
                 help,
                 level,
                 effect,
                 cases,
             }| {
                let finding = RULE
                    .at(file, Place::Pointer(at), message)
                    .key(key)
                    .help(help);
                finding.evidence(cases).level(level).effect(effect)
            },
        )
        .collect()
}
