//! An author or a licence must be ASCII.

use super::super::{Check, Rule, RuleCx, such};
use super::texts;
use crate::diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::mhclo::Entry;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "exports the asset as `CC0` from the second start on, and cuts the name of the author")],
    docs: "A comment of an asset names an author, a licence, a homepage or a copyright with letters that are not ASCII, \
        such as `# author Jürgen` or `# license CC-BY © 2020`.\n\n\
        In the data of a user MakeHuman 1 compiles an asset when it is put on. It counts these texts in letters and reads \
        them back in bytes: the author is cut, and the licence becomes `CC0`. Exports carry the wrong licence from the \
        second start on.\n\n\
        Write these comments with letters a to z: `Juergen`, `(c)`.",
    ..RuleInfo::new("proxy-licence-lost", Level::Warning, "author or licence of an asset is not ASCII")
});

const KEPT: [&str; 4] = ["author", "license", "copyright", "homepage"];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Nothing is compiled in the data of the program.
    if body.layers.checks_system() {
        return;
    }
    for text in texts(body) {
        let is_lost = |entry: &&Entry| entry.is_comment && KEPT.contains(&&*entry.keyword) && !entry.value.is_ascii();
        let lost: Vec<&Entry> = text.clothes.entries.iter().filter(is_lost).collect();
        let Some(first) = lost.first() else { continue };
        let letter = first.value.chars().find(|letter| !letter.is_ascii()).unwrap_or_default();
        let more = such(lost.len(), "values");
        let message = format!("`{}` has the letter `{letter}`, which is not ASCII{more}", first.keyword);
        let finding = RULE.at(text.file, Place::Span(first.span.clone()), message);
        let evidence = Evidence::of_cases(lost.iter().map(|entry| entry.keyword.to_string()));
        out.push(
            finding.evidence(evidence).help("write it with plain letters, without accents: `Juergen` for `Jürgen`"),
        );
    }
}
