//! Presets of the randomizer of MPFB, whose loader takes every key without asking for it
//! (`docs/loaders/mpfb/models.md#presets-of-the-randomizer`).

use super::super::unfit::{Wording, findings_in, sort, subject};
use super::super::{Rule, RuleCx, enumerated};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_formats::randomization::Randomization;
use mhlint_formats::unfit::{Unfit, Why};
use mhlint_repo::{FileFacts, mpfb};

const STOPPED: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when the preset is loaded: it sets what comes before in the preset, \
        and nothing else",
)];

/// What is missing has one cause, wherever it is: the preset was not saved by the add-on as it is
/// now.
const WORDING: Wording = Wording { cause, subject };

fn cause(one: &Unfit) -> String {
    if let Why::Lacks(_) = one.why {
        "lacks".to_owned()
    } else {
        sort(one)
    }
}

pub(super) fn faults(
    rule: &Rule,
    view: &mpfb::View<'_>,
    file: &FileFacts,
    preset: &Randomization,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let catalog = sections(view);
    let stops = preset.stops(catalog.as_deref());
    for (first, finding) in findings_in(WORDING, rule, file, &stops, cx) {
        let is_lack = matches!(first.why, Why::Lacks(_));
        let finding = if is_lack {
            finding.help("save the preset again with the add-on")
        } else {
            finding
        };
        out.push(finding.case(STOPPED));
    }
    if stops.all().is_empty() {
        out.extend(catalog.and_then(|catalog| lacking(rule, file, &preset.lacks(&catalog))));
    }
}

/// The sections of the catalogue that the randomizer has settings for: those with sliders.
fn sections<'v>(view: &mpfb::View<'v>) -> Option<Vec<&'v str>> {
    let sections = view.catalog.as_ref()?.sliders.sections.iter();
    let with_sliders =
        sections.filter(|section| !section.categories.is_empty() && section.name != "measure");
    Some(with_sliders.map(|section| section.name.as_str()).collect())
}

/// One section too few, and none of the presets that were saved before can be loaded.
fn lacking(rule: &Rule, file: &FileFacts, missing: &[&str]) -> Option<Finding> {
    let first = missing.first()?;
    let names: Vec<String> = missing.iter().map(|name| format!("`{name}`")).collect();
    let message = match missing.len() {
        1 => format!("`sections` of `details` has no `{first}`, a section of `target.json`"),
        count => format!(
            "`sections` of `details` lacks {count} sections of `target.json`: {}",
            enumerated(&names)
        ),
    };
    let finding = rule
        .at(file, Place::pointer(["details", "sections"]), message)
        .key("sections")
        .case(STOPPED);
    let help = "save the preset again with the add-on, or copy the settings of another section \
        under this name";
    Some(
        finding
            .help(help)
            .parts(missing.iter().copied())
            .evidence(Evidence::of_cases(missing.iter().copied())),
    )
}
