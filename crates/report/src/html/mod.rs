//! One page for a browser: readable as it is, sorted, filtered and searched where scripts run.
//!
//! Nothing is loaded from anywhere. Every text goes through `maud`, which escapes it, and the page
//! forbids the browser to run or load anything but the one style and the one script that it holds.

mod finding;

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::files::{by_file, for_page};
use super::matrix::Matrix;
use super::phrase::{self, Piece, pieces};
use super::unchecked::unchecked;
use super::{View, count, printable, verdict};
use mhlint_diag::{Application, Finding, Level, Outcome, RuleInfo};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// What the browser may do: nothing but use the style and the script with these hashes.
const POLICY: &str = "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; \
    style-src 'sha256-szzw7sx/ZqM42GxrRvugVvG4iZn9LGBcVP/Q4XngP08='; script-src \
    'sha256-IizRmeWnv7wyt1MgkAm2DcJ75/gnKrsLN7VJ49b0+cI='";

/// Where the list of the findings goes. No text of an asset can hold it: there `<` is escaped.
const LIST: &str = "<!--list-->";

/// Levels, gravest first, with what they mean.
const LEVELS: [(Level, &str); 3] = [
    (Level::Error, "crash, rejected file or lost data"),
    (Level::Warning, "the result differs from the files"),
    (Level::Info, "no visible effect today"),
];

/// Writes the page.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let (findings, left) = for_page(&outcome.findings);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "mhlint: " (if view.pass { "passed" } else { "failed" }) ", " (verdict::tally(outcome)) }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE)) }
            }
            body {
                a .skip href="#findings" { "Skip to the findings" }
                (top(outcome, view))
                main #findings tabindex="-1" {
                    @if findings.is_empty() {
                        p .empty { "There are no findings." }
                    } @else {
                        (controls(&findings))
                        @if left > 0 {
                            p .quiet { (count(left, "more finding")) " left out: the page shows \
                                the gravest, other formats list all." }
                        }
                        (files(&findings))
                        div #list { (PreEscaped(LIST)) }
                        p #nothing .empty hidden { "No findings match. " button #again type="button" { "Show all" } }
                    }
                }
                (rules(&findings, view.rules))
                footer { p { "Written by mhlint " (env!("CARGO_PKG_VERSION")) "." } }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    let page = page.into_string();
    // The list is made file by file while it is written: a page of many findings is larger than all
    // that was checked.
    let (before, after) = page.split_once(LIST).unwrap_or((&page, ""));
    out.write_all(before.as_bytes())?;
    list(&findings, out)?;
    writeln!(out, "{after}")
}

fn top(outcome: &Outcome, view: &View<'_>) -> Markup {
    let summary = &outcome.summary;
    let numbers = [summary.error, summary.warning, summary.info];
    let state = if view.pass { "passed" } else { "failed" };
    html! {
        header .(state) {
            p .name { "mhlint report" }
            h1 { (inline(&verdict::words(outcome, view))) }
            ul .counts {
                @for ((level, meaning), number) in LEVELS.iter().zip(numbers) {
                    li .(level.word()) .none[number == 0] data-level=(level.word()) {
                        span .number { (number) }
                        " " span .noun { (level.word()) @if number != 1 { "s" } }
                        " " span .meaning { (meaning) }
                    }
                }
            }
            @for root in verdict::roots(outcome) {
                p .root { "Checked: " (inline(&printable(&root))) }
            }
            p .root {
                (verdict::files(summary))
                @for (number, what) in verdict::hidden(outcome) { ", " (count(number, "finding")) " " (what) }
            }
            @if let Some(matrix) = Matrix::of(outcome) { (loaded_by(&matrix)) }
            @if !outcome.notes.is_empty() {
                section .notes aria-label="Notes" {
                    h2 { "Notes" }
                    ul { @for note in &outcome.notes { li { (inline(&printable(&super::note(note)))) } } }
                }
            }
            @if !outcome.not_checked.is_empty() {
                section .notes aria-label="Not checked" {
                    h2 { "Not checked" }
                    ul { @for clause in unchecked(outcome) { li { (inline(&printable(&clause))) } } }
                }
            }
        }
    }
}

/// Who loads what.
fn loaded_by(matrix: &Matrix) -> Markup {
    html! {
        table .matrix {
            thead { tr {
                th scope="col" { "loaded by" }
                @for application in &matrix.applications { th scope="col" { (application.title()) } }
            } }
            tbody {
                @for (title, cells) in &matrix.rows {
                    tr { th scope="row" { (title) } @for cell in cells { td { (cell) } } }
                }
            }
        }
    }
}

/// Search, filters and order. Of no use without scripts, so the script shows them.
fn controls(findings: &[&Finding]) -> Markup {
    let rules: BTreeSet<&str> = findings.iter().map(|finding| finding.rule).collect();
    let breaks = findings.iter().flat_map(|finding| &finding.breaks);
    let applications: BTreeSet<Application> = breaks.map(|one| one.application).collect();
    let levels: BTreeSet<Level> = findings.iter().map(|finding| finding.level).collect();
    html! {
        form #controls role="search" aria-label="Findings" hidden {
            div .field .wide {
                label for="search" { "Search" }
                input #search type="search" autocomplete="off" spellcheck="false" aria-keyshortcuts="/";
            }
            fieldset {
                legend { "Level" }
                @for (level, _) in LEVELS.iter().filter(|(level, _)| levels.contains(level)) {
                    label .(level.word()) {
                        input type="checkbox" name="level" value=(level.word()) checked;
                        " " (level.word())
                    }
                }
            }
            (choice("rule", "Rule", "all rules", rules.iter().map(|rule| (*rule, *rule))))
            @if applications.len() > 1 {
                (choice("application", "Application", "all applications",
                    applications.iter().map(|one| (one.word(), one.title()))))
            }
            div .field {
                label for="order" { "Order" }
                select #order {
                    option value="path" { "by file" }
                    option value="level" { "by level" }
                    option value="rule" { "by rule" }
                }
            }
            div .buttons {
                button #unfold type="button" { "Open all" }
                button #fold type="button" { "Close all" }
                button #clear type="reset" { "Reset" }
            }
            p #shown role="status" {}
            p .keys {
                kbd { "/" } " search, " kbd { "j" } " " kbd { "k" } " next and previous finding, "
                kbd { "Enter" } " open or close, " kbd { "Esc" } " leave the search"
            }
        }
    }
}

fn choice<'a>(
    id: &str,
    label: &str,
    all: &str,
    options: impl Iterator<Item = (&'a str, &'a str)>,
) -> Markup {
    html! {
        div .field {
            label for=(id) { (label) }
            select #(id) {
                option value="" { (all) }
                @for (value, name) in options { option value=(value) { (name) } }
            }
        }
    }
}

/// The files with their counts, each leading to its findings.
fn files(findings: &[&Finding]) -> Markup {
    let files = by_file(findings);
    html! {
        details .files open[files.len() <= 12] {
            summary { h2 { "Files with findings: " (files.len()) } }
            nav aria-label="Files" {
                ul {
                    @for (number, file) in files.iter().enumerate() {
                        li {
                            a href={ "#file-" (number + 1) } { (path_of(file)) }
                            " " (chips(file))
                        }
                    }
                }
            }
        }
    }
}

/// The findings, file by file.
fn list(findings: &[&Finding], out: &mut dyn Write) -> io::Result<()> {
    let mut ids = BTreeMap::new();
    // A long list is read by its messages; the gravest stand open.
    let loud = findings
        .iter()
        .filter(|finding| finding.level > Level::Info)
        .count();
    let opened = |finding: &Finding| match finding.level {
        Level::Error => true,
        Level::Warning => loud <= 50,
        Level::Info => findings.len() <= 20,
    };
    for (number, file) in by_file(findings).into_iter().enumerate() {
        let head = html! { h2 { code { (path_of(&file)) } " " (chips(&file)) } }.into_string();
        write!(
            out,
            "<section class=\"group\" id=\"file-{}\">{head}",
            number + 1
        )?;
        for finding in file {
            let article = finding::article(
                finding,
                &unique(&finding.fingerprint, &mut ids),
                opened(finding),
            );
            out.write_all(article.into_string().as_bytes())?;
        }
        out.write_all(b"</section>")?;
    }
    Ok(())
}

fn path_of(file: &[&Finding]) -> String {
    file.first()
        .map_or_else(String::new, |first| phrase::path_of(first))
}

/// Two data roots may hold the same asset with the same fault; an id stands once in a page.
fn unique(fingerprint: &str, ids: &mut BTreeMap<String, usize>) -> String {
    let times = ids.entry(fingerprint.to_owned()).or_default();
    *times += 1;
    if *times == 1 {
        format!("f-{fingerprint}")
    } else {
        format!("f-{fingerprint}-{times}")
    }
}

/// `2 errors, 1 info` as small marks.
fn chips(findings: &[&Finding]) -> Markup {
    let number = |level| {
        findings
            .iter()
            .filter(|finding| finding.level == level)
            .count()
    };
    html! {
        span .chips {
            @for (level, number) in LEVELS.map(|(level, _)| (level, number(level))) {
                @if number > 0 { span .chip .(level.word()) { (count(number, level.word())) } " " }
            }
        }
    }
}

/// What the rules of this page mean.
fn rules(findings: &[&Finding], infos: &[&RuleInfo]) -> Markup {
    let used = |info: &&&RuleInfo| findings.iter().any(|finding| finding.rule == info.id);
    let used: Vec<&&RuleInfo> = infos.iter().filter(used).collect();
    html! {
        @if !used.is_empty() {
            section .rules aria-labelledby="rules" {
                h2 #rules { "What the rules mean" }
                @for info in used {
                    details #{ "rule-" (info.id) } {
                        summary { h3 { code { (info.id) } " " span { (inline(info.summary)) } } }
                        @for paragraph in info.documentation().split("\n\n") { p { (inline(paragraph)) } }
                        p .quiet { "With a bad and a good example: " code { "mhlint explain " (info.id) } }
                    }
                }
            }
        }
    }
}

/// Words with names in back quotes, which become code.
fn inline(text: &str) -> Markup {
    html! {
        @for piece in pieces(text) {
            @match piece {
                Piece::Words(words) => (words),
                Piece::Name(name) => code { (name) },
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    use sha2::{Digest, Sha256};

    use super::*;

    #[test]
    fn the_policy_names_the_style_and_the_script() {
        let hash = |text: &str| {
            format!(
                "'sha256-{}'",
                STANDARD.encode(Sha256::digest(text.as_bytes()))
            )
        };
        let expected = format!("style-src {}; script-src {}", hash(STYLE), hash(SCRIPT));
        assert!(
            POLICY.ends_with(&expected),
            "POLICY has to end with: {expected}"
        );
    }

    #[test]
    fn style_and_script_cannot_end_early() {
        assert!(!STYLE.contains("</") && !SCRIPT.contains("</") && !SCRIPT.contains("<!--"));
    }

    #[test]
    fn the_same_fingerprint_twice_gives_two_ids() {
        let mut ids = BTreeMap::new();
        assert_eq!(
            [unique("a", &mut ids), unique("a", &mut ids)],
            ["f-a", "f-a-2"]
        );
    }
}
