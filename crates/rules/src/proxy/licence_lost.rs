//! An author or a licence must be ASCII.

use super::super::{Check, Rule, RuleCx, plain_letters, such};
use super::{Text, texts};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::mhclo::Entry;
use mhlint_formats::packed::asset::Packed;
use mhlint_formats::packed::proxy::Licence;
use mhlint_repo::{Body, Worn};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "exports the asset as `CC0` from the second start on, and cuts the name of the author",
    )],
    docs: include_str!("licence_lost.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-licence-lost",
        Level::Warning,
        "author or licence of an asset is not ASCII",
    )
});

const KEPT: [&str; 4] = ["author", "license", "copyright", "homepage"];

/// Words in capitals are others to the reader of comments.
const CAPITALS: Case = &[(
    Makehuman1,
    Level::Warning,
    "does not read the comment: an asset without license counts as CC0",
)];

/// `# License: CC-BY` where no comment has the word as it is read.
fn capitals(text: &Text<'_, '_>) -> Option<Finding> {
    let comments = || text.clothes.entries.iter().filter(|entry| entry.is_comment);
    let is_written = |entry: &&Entry| {
        let own = ["author", "license"]
            .into_iter()
            .find(|known| known.eq_ignore_ascii_case(&entry.keyword));
        own.is_some_and(|own| {
            *own != *entry.keyword && !comments().any(|other| *other.keyword == *own)
        })
    };
    let first = comments().find(is_written)?;
    let message = format!(
        "`{}` in a comment has to be in small letters",
        first.keyword
    );
    let finding = RULE
        .at(text.file, Place::Span(first.keyword_span.clone()), message)
        .key("capitals")
        .case(CAPITALS);
    Some(finding.help(format!("write `{}`", first.keyword.to_lowercase())))
}

const LOST: Case = &[(
    Makehuman1,
    Level::Warning,
    "exports the asset as `CC0`, and cuts the name of the author",
)];
const CUT: Case = &[(
    Makehuman1,
    Level::Warning,
    "exports the asset with a part of this text",
)];
const BROKEN: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put the asset on: `UnicodeDecodeError`",
)];
const OF_TEXT: Case = &[(
    Makehuman1,
    Level::Info,
    "reads the text beside it, with a warning in the log",
)];

/// An archive that was packed with such letters.
fn packed(body: &Body<'_>, worn: &Worn<'_>) -> Option<Finding> {
    let lone = worn.packed_proxy().map(|proxy| (worn.file, proxy));
    // What is packed anew has the finding of its text.
    let beside = || {
        worn.binary
            .filter(|file| body.layers.checks_system() && body.layers.is_checked(file))
    };
    let (file, proxy) =
        lone.or_else(|| Some((beside()?, Packed::proxy_of(beside()?.packed())?)))?;
    let (what, case) = match proxy.licence {
        Licence::Whole => return None,
        Licence::Lost => (
            "the licence in the archive is lost behind a letter that is not ASCII",
            LOST,
        ),
        Licence::Cut => (
            "a text behind the licence in the archive is cut for a letter that is not ASCII",
            CUT,
        ),
        Licence::Broken => (
            "author and licence in the archive are cut inside of a letter that is not ASCII",
            if lone.is_some() { BROKEN } else { OF_TEXT },
        ),
    };
    let help = "write author and licence in the text with letters a to z, and pack it again";
    Some(
        RULE.at(file, Place::File, what)
            .key("packed")
            .case(case)
            .help(help),
    )
}

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = body
        .worn
        .iter()
        .filter(|worn| body.layers.is_checked(worn.file));
    out.extend(
        own.filter(|_| body.is_makehuman1())
            .filter_map(|worn| packed(body, worn)),
    );
    out.extend(texts(body).filter_map(|text| capitals(&text)));
    // Nothing is compiled in the data of the program.
    if body.layers.checks_system() {
        return;
    }
    for text in texts(body) {
        // Bytes that are not UTF-8 are dropped before anything is counted (`file-not-utf8`).
        let is_counted = |entry: &&Entry| {
            entry
                .value
                .chars()
                .any(|letter| !letter.is_ascii() && letter != char::REPLACEMENT_CHARACTER)
        };
        let is_lost = |entry: &&Entry| {
            entry.is_comment && KEPT.contains(&&*entry.keyword) && is_counted(entry)
        };
        let lost: Vec<&Entry> = text.clothes.entries.iter().filter(is_lost).collect();
        let Some(first) = lost.first() else { continue };
        let letter = first
            .value
            .chars()
            .find(|letter| !letter.is_ascii())
            .unwrap_or_default();
        let more = such(lost.len(), "values");
        let message = format!(
            "`{}` has the letter `{letter}`, which is not ASCII{more}",
            first.keyword
        );
        let finding = RULE.at(text.file, Place::Span(first.span.clone()), message);
        let is_licensed = |entry: &Entry| {
            entry.is_comment
                && *entry.keyword == *"license"
                && !entry.value.eq_ignore_ascii_case("cc0")
        };
        let finding = if text.clothes.entries.iter().any(is_licensed) {
            finding
        } else {
            finding.case(CUT)
        };
        let evidence = Evidence::of_cases(lost.iter().map(|entry| entry.keyword.to_string()));
        out.push(finding.evidence(evidence).help(plain_letters(letter)));
    }
}
