//! One finding as an article: what is wrong, where, what each application does with it, and what to
//! do.

use maud::{Markup, html};

use super::inline;
use crate::phrase::{self, bare_place, colons, doubt, evidence_of, fixed_by};
use crate::printable;
use crate::snippet::snippet;
use mhlint_diag::{Finding, Location};

/// Columns of quoted source lines; longer ones are cut around the mark.
const WIDTH: usize = 140;

/// Related places shown for one finding.
const RELATED: usize = 50;

/// The article.
pub(super) fn article(finding: &Finding, id: &str, open: bool) -> Markup {
    let level = finding.level.word();
    let applications: Vec<&str> = finding
        .breaks
        .iter()
        .map(|one| one.application.word())
        .collect();
    html! {
        article .finding .(level) #(id) data-level=(level) data-rule=(finding.rule)
            data-path=(phrase::path_of(finding)) data-applications=(applications.join(" ")) {
            details open[open] {
                summary {
                    span .chip .(level) { (level) }
                    " "
                    h3 { (inline(&printable(&phrase::message(finding)))) (doubt(finding.confidence)) }
                    span .at { span .of { (phrase::path_of(finding)) " " } (short_place(&finding.location)) }
                }
                (source(finding))
                dl {
                    @for one in &finding.breaks {
                        div .consequence { dt { (one.application.title()) } dd { (inline(&printable(&one.effect))) } }
                    }
                    @if let Some(help) = &finding.help {
                        div .help { dt { "What to do" } dd { (inline(&printable(help))) } }
                    }
                    @if let Some(fix) = &finding.fix {
                        div .help { dt { "Fix" } dd { (inline(&printable(&fixed_by(fix)))) } }
                    }
                    (evidence(finding))
                    (related(finding))
                }
                p .quiet {
                    a href={ "#rule-" (finding.rule) } { (finding.rule) }
                    span .self { " · " a href={ "#" (id) } { "link to this finding" } }
                }
            }
        }
    }
}

fn short_place(location: &Location) -> String {
    printable(&bare_place(location).unwrap_or_default())
}

/// Path and place, and below it the source lines where there are any.
fn source(finding: &Finding) -> Markup {
    let path = phrase::path_of(finding);
    let found = finding
        .location
        .excerpt
        .as_ref()
        .and_then(|excerpt| snippet(excerpt, WIDTH));
    let parts = found.as_ref().and_then(|found| {
        let lead = found.text.get(..found.mark.start)?;
        let marked = found.text.get(found.mark.clone())?;
        Some((lead, marked, found.text.get(found.mark.end..)?))
    });
    html! {
        p .where { code { (path) (colons(&finding.location)) } }
        @if let (Some(found), Some((lead, marked, trail))) = (&found, parts) {
            div .source {
                pre .numbers aria-hidden="true" {
                    @for number in found.first_line..=found.first_line + found.text.matches('\n').count() {
                        (number) "\n"
                    }
                }
                pre tabindex="0" { code { (lead) mark { (marked) } (trail) } }
            }
        }
    }
}

fn evidence(finding: &Finding) -> Markup {
    let line = evidence_of(finding);
    html! {
        @if let Some(line) = line {
            div { dt { "Seen" } dd { (inline(&printable(&line))) } }
        }
    }
}

fn related(finding: &Finding) -> Markup {
    let related = &finding.related;
    let left = related.len().saturating_sub(RELATED);
    html! {
        @if !related.is_empty() {
            div {
                dt { "See also" }
                dd {
                    ul {
                        @for one in related.iter().take(RELATED) {
                            li {
                                @if !phrase::is_note(finding, one) {
                                    code { (phrase::path(&one.path, &one.location)) (colons(&one.location)) }
                                    ": "
                                }
                                (inline(&printable(&one.message)))
                            }
                        }
                        @if left > 0 { li { (left) " places more" } }
                    }
                }
            }
        }
    }
}
