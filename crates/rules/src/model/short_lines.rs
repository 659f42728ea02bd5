//! Lines of a model with too few words.

use super::super::{Rule, counted, such};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::mhm::{CATEGORIES, ShortLine};
use mhlint_repo::FileFacts;

/// The finding on lines with too few words.
pub(super) fn finding(rule: &Rule, file: &FileFacts, short: &[ShortLine]) -> Option<Finding> {
    let first = short.first()?;
    let keyword = &first.keyword.text;
    let more = such(short.len(), "lines");
    let message = match (first.found, first.needed) {
        (1, 2) => format!("`{keyword}` has no value{more}"),
        (found, needed) => format!(
            "`{keyword}` has {}, expected {}{more}",
            counted(found - 1, "value"),
            needed - 1
        ),
    };
    let help = match &**keyword {
        "material" => {
            "write `material`, then name and uuid of the asset and the file, or remove the line"
                .to_owned()
        }
        "camera" => "write `camera` and six numbers, or remove the line".to_owned(),
        category if CATEGORIES.contains(&category) => {
            format!("write `{keyword}`, then name and uuid of the asset, or remove the line")
        }
        _ => format!("add the value of `{keyword}`, or remove the line"),
    };
    let finding = rule
        .at(file, Place::Span(first.keyword.span.clone()), message)
        .help(help);
    let evidence = Evidence::of_cases(short.iter().map(|line| line.keyword.text.to_string()));
    Some(finding.evidence(evidence))
}
