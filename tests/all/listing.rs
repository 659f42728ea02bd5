//! Every message with its consequences and its help, as the fixtures print them, in one text to be
//! read line by line: `LISTING=target/listing.txt cargo test --test all listing::`. Without
//! `LISTING` it is made and not kept.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::LazyLock;

use crate::scratch::memory::{Asked, Memory};
use crate::scratch::{Case, folders, project};
use mhlint::Finding;
use rayon::prelude::*;

#[test]
fn every_message_can_be_listed() {
    assert!(MESSAGES.len() > 500, "{}", MESSAGES.len());
    if let Some(file) = std::env::var_os("LISTING") {
        std::fs::write(
            file,
            MESSAGES.iter().map(String::as_str).collect::<String>(),
        )
        .unwrap();
    }
}

/// Each once, with its consequences, other places, help and fix.
pub(crate) static MESSAGES: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
    let rules = folders(&project("fixtures/rules"));
    let cases: Vec<_> = rules.iter().flat_map(|rule| folders(rule)).collect();
    let texts: Vec<BTreeSet<String>> = cases.par_iter().map(|case| texts(case)).collect();
    texts.into_iter().flatten().collect()
});

/// The findings of one fixture; none where it needs a disk.
fn texts(folder: &Path) -> BTreeSet<String> {
    let case = Case::read(folder);
    let Some(asked) = Asked::of(&case) else {
        return BTreeSet::new();
    };
    let mut repository = Memory::example(&case);
    repository.apply(&case);
    asked.lint(&repository).findings.iter().map(text).collect()
}

fn text(finding: &Finding) -> String {
    let mut text = format!(
        "{} {}: {}\n",
        finding.rule,
        finding.level.word(),
        finding.message
    );
    for one in &finding.breaks {
        let _ = writeln!(text, "    {}: {}", one.application.title(), one.effect);
    }
    for related in &finding.related {
        let _ = writeln!(text, "    see: {}", related.message);
    }
    finding.help.iter().for_each(|help| {
        let _ = writeln!(text, "    help: {help}");
    });
    finding.fix.iter().for_each(|fix| {
        let _ = writeln!(text, "    fix: {}", fix.title);
    });
    text
}
