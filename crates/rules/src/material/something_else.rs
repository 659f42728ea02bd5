//! A file that is no material of MPFB, such as a web page
//! (`docs/loaders/mpfb/materials.md#lines-of-a-material`).

use super::super::Rule;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place};
use mhlint_formats::mhmat::mpfb::is_key;
use mhlint_repo::mpfb::Look;
use mhlint_source::Guess;

/// A file that is something else. What is no text has a finding of its own.
pub(super) fn told(rule: &Rule, look: &Look<'_>) -> Option<Finding> {
    let material = look.material;
    let is_known = |word: &str| is_key(word) || look.reads(word);
    let has_key = material
        .statements
        .iter()
        .any(|statement| is_known(&statement.key.text));
    let is_text = matches!(look.file.encoding.guess, None | Some(Guess::SingleByte));
    if has_key || !is_text || !material.lines.is_empty() {
        return None;
    }
    let words = material.statements.iter().map(|statement| &statement.key);
    let first = words
        .chain(material.unknown.iter().map(|one| &one.word))
        .min_by_key(|word| word.span.start)?;
    let place = Place::Span(first.span.clone());
    let finding = rule
        .at(
            look.file,
            place,
            "no line begins with a keyword of a material",
        )
        .key("all")
        .case(NOTHING);
    Some(finding.help("restore the material, or export it again"))
}

const NOTHING: Case = &[(
    Mpfb,
    Level::Warning,
    "ignores all lines, with a message in the log: the material has nothing of its own",
)];
