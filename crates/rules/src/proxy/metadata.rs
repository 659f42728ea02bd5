//! What an asset says of itself.

use super::super::{Check, Rule, RuleCx, are, counted, enumerated};
use super::{Text, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lists the asset with what it has: no license in exports, no tags to filter \
            by",
        ),
        (
            Makehuman1,
            "lists the asset with what it has; one without license counts as CC0 of the \
            MakeHuman team",
        ),
    ],
    docs: include_str!("metadata.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-metadata",
        Level::Info,
        "an asset without author, license, \
        description, tag or z_depth",
    )
});

const WANTED: [&str; 5] = ["author", "license", "description", "tag", "z_depth"];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let lacking: Vec<_> = texts(body)
        .map(|text| (text, lacks(&text)))
        .filter(|(_, lacks)| !lacks.is_empty())
        .collect();
    let Some((first, wanted)) = lacking.first() else {
        return;
    };
    let all: Vec<&str> = WANTED
        .into_iter()
        .filter(|word| lacking.iter().any(|(_, lacks)| lacks.contains(word)))
        .collect();
    let quoted = |words: &[&str]| {
        enumerated(
            &words
                .iter()
                .map(|word| format!("`{word}`"))
                .collect::<Vec<_>>(),
        )
    };
    let message = match lacking.len() {
        1 => format!("{} {} missing", quoted(wanted), are(wanted.len())),
        count if all.len() == 1 => format!("{} have no {}", counted(count, "asset"), quoted(&all)),
        count => format!("{} lack some of {}", counted(count, "asset"), quoted(&all)),
    };
    let finding = RULE.at(first.file, Place::File, message);
    let parts = lacking.iter().map(|(text, lacks)| {
        (
            format!("{}: {}", text.file.shown(), lacks.join(", ")),
            &text.file.path,
        )
    });
    let cases = lacking
        .iter()
        .map(|(text, lacks)| format!("{} ({})", text.file.file_name(), lacks.join(", ")));
    let finding = finding.parts_in(parts).evidence(Evidence::of_cases(cases));
    out.push(
        finding
            .help("add the lines above `verts`; author and license as comments, `# author: NAME`"),
    );
}

/// What an asset does not say. A line that is misspelt, glued or empty has a finding of its own.
fn lacks(text: &Text<'_, '_>) -> Vec<&'static str> {
    let has = |word: &str| {
        text.clothes
            .entries
            .iter()
            .any(|entry| bare(&entry.keyword).eq_ignore_ascii_case(word))
    };
    // The layer of a topology is that of the body.
    let is_needless = |word: &str| word == "z_depth" && text.worn.is_topology();
    let is_marked = text.file.encoding.byte_order_mark;
    let scanned = &text.clothes.scanned;
    let is_author = |word: &str| {
        word == "author"
            && (scanned.author.is_some() || scanned.glued_author.is_some() || is_marked)
    };
    let is_told =
        |word: &str| text.misspelt(word).is_some() || is_needless(word) || is_author(word);
    WANTED
        .into_iter()
        .filter(|word| !has(word) && !is_told(word))
        .collect()
}

/// A keyword without what may be glued to it.
fn bare(keyword: &str) -> &str {
    keyword
        .trim_start_matches(['\u{feff}', '#'])
        .trim_end_matches(':')
}
