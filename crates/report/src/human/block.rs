//! One finding as a block of text, drawn by miette.
//!
//! The only file that knows miette. Its stock sources are walked from the first byte of a file for
//! every label; here it is served from the few lines that the engine has already cut out.

use std::error::Error;
use std::fmt;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError,
    MietteSpanContents, Severity, SourceCode, SourceSpan, SpanContents, ThemeCharacters,
    ThemeStyles,
};
use textwrap::{WordSeparator, WordSplitter};

use crate::phrase::{self, bare_place, doubt, lines};
use crate::snippet::{Snippet, snippet};
use crate::{Paint, View, hang, printable};
use mhlint_diag::{Break, Finding, Level, Location};

/// The block of a finding: message, consequences, source text, evidence, other places, help.
/// Of the consequences only `effects`, of the help only what was not said before.
pub(super) fn render(
    finding: &Finding,
    effects: &[&Break],
    with_help: bool,
    view: &View<'_>,
) -> String {
    let source = finding
        .location
        .excerpt
        .as_ref()
        .and_then(|excerpt| snippet(excerpt, view.width));
    let source = source.map(|snippet| Source {
        snippet,
        path: printable(&finding.path),
        at: &finding.location,
    });
    let has_source = source.is_some();
    let shown = Shown {
        finding,
        consequence: Consequence::chain(effects),
        source,
    };
    let mut text = String::new();
    handler(finding, view)
        .render_report(&mut text, &shown)
        .expect(
            "invariant: writing to a string does not fail and the label lies within the snippet",
        );
    for (label, line) in footer(finding, has_source)
        .into_iter()
        .filter(|(label, _)| with_help || label != "help")
    {
        let paint = Paint { color: view.color };
        let plain = format!("  {label}: ");
        let block = hang(&plain, &printable(&line), view.width);
        text.push_str(&block.replacen(&label, &paint.hint(&label), 1));
        text.push('\n');
    }
    text
}

/// Lines below the source text, with what they are called. The consequences stand above it.
fn footer(finding: &Finding, has_source: bool) -> Vec<(String, String)> {
    let at = bare_place(&finding.location)
        .filter(|_| !has_source)
        .map(|at| ("at".to_owned(), at));
    let lines = lines(finding).into_iter().skip(finding.breaks.len());
    at.into_iter()
        .chain(lines.map(|line| (line.label, line.text)))
        .collect()
}

fn handler(finding: &Finding, view: &View<'_>) -> GraphicalReportHandler {
    let mut characters = if view.unicode {
        ThemeCharacters::unicode()
    } else {
        ThemeCharacters::ascii()
    };
    let title = format!(
        "{}[{}]{}",
        finding.level,
        finding.rule,
        doubt(finding.confidence)
    );
    let slot = match finding.level {
        Level::Error => &mut characters.error,
        Level::Warning => &mut characters.warning,
        Level::Info => &mut characters.advice,
    };
    *slot = title;
    let styles = if view.color {
        ThemeStyles::ansi()
    } else {
        ThemeStyles::none()
    };
    GraphicalReportHandler::new_themed(GraphicalTheme { characters, styles })
        .with_width(view.width)
        .with_links(false)
        .with_break_words(false)
        // Names of files stay whole, hyphens and all.
        .with_word_separator(WordSeparator::AsciiSpace)
        .with_word_splitter(WordSplitter::NoHyphenation)
        .without_syntax_highlighting()
}

/// A finding as miette sees it.
#[derive(Debug)]
struct Shown<'a> {
    finding: &'a Finding,
    consequence: Option<Consequence>,
    source: Option<Source<'a>>,
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&phrase::message(self.finding)))
    }
}

impl Error for Shown<'_> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.consequence
            .as_ref()
            .map(|consequence| consequence as &dyn Error)
    }
}

impl Diagnostic for Shown<'_> {
    fn severity(&self) -> Option<Severity> {
        Some(match self.finding.level {
            Level::Error => Severity::Error,
            Level::Warning => Severity::Warning,
            Level::Info => Severity::Advice,
        })
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let mark = self.source.as_ref()?.snippet.mark.clone();
        Some(Box::new(std::iter::once(
            LabeledSpan::new_primary_with_span(None, mark),
        )))
    }
}

/// What an application does with it; a chain because miette draws causes as one.
#[derive(Debug)]
struct Consequence {
    text: String,
    next: Option<Box<Consequence>>,
}

impl Consequence {
    fn chain(breaks: &[&Break]) -> Option<Self> {
        let (first, rest) = breaks.split_first()?;
        let text = format!("{}: {}", first.application, printable(&first.effect));
        Some(Self {
            text,
            next: Self::chain(rest).map(Box::new),
        })
    }
}

impl fmt::Display for Consequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Error for Consequence {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.next.as_deref().map(|next| next as &dyn Error)
    }
}

/// The quoted lines as a source: all of them for context, position of the mark otherwise.
#[derive(Debug)]
struct Source<'a> {
    snippet: Snippet,
    path: String,
    at: &'a Location,
}

impl SourceCode for Source<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let text = self.snippet.text.as_str();
        let zero_based =
            |number: Option<u32>| number.map_or(0, |number| number.saturating_sub(1) as usize);
        let contents = if before + after == 0 {
            let marked = span.offset()..span.offset() + span.len();
            let data = text.get(marked).ok_or(MietteError::OutOfBounds)?;
            let (line, column) = (zero_based(self.at.line), zero_based(self.at.column));
            MietteSpanContents::new_named(
                self.path.clone(),
                data.as_bytes(),
                *span,
                line,
                column,
                1,
            )
        } else {
            let whole = SourceSpan::from((0, text.len()));
            let first = self.snippet.first_line.saturating_sub(1);
            MietteSpanContents::new_named(
                self.path.clone(),
                text.as_bytes(),
                whole,
                first,
                0,
                text.lines().count(),
            )
        };
        Ok(Box::new(contents))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Confidence, Element, Evidence, Place, RuleInfo};

    fn finding() -> Finding {
        Finding::new(
            &RuleInfo::new("a-rule", Level::Warning, ""),
            "data/a.target",
            Place::File,
            "it is so",
        )
    }

    fn whole(finding: &Finding) -> String {
        render(
            finding,
            &finding.breaks.iter().collect::<Vec<_>>(),
            true,
            &View::PLAIN,
        )
    }

    #[test]
    fn evidence_other_places_and_help_follow_the_message() {
        let mut finding = finding().confidence(Confidence::Medium).help("mend it");
        finding.evidence = Some(
            Evidence::of_unnamed(["x"; 7])
                .out_of(9)
                .with_worst(0.123_456, "vertex 3"),
        );
        finding = finding.related("data/b.target", Place::File, "the other one");
        finding.location.line = Some(4);
        finding.location.element = Some(Element {
            kind: "vertex",
            index: 17,
        });
        let expected = "  warning[a-rule] (likely) it is so\n  at: line 4, vertex 17\n  \
            seen: 7 of 9: x, x, x, x, x and 2 more; worst 0.1235 at vertex 3\n  \
            see: data/b.target: the other one\n  help: mend it\n";
        assert_eq!(whole(&finding), expected);
    }

    #[test]
    fn each_application_has_its_line_and_repetitions_have_none() {
        use mhlint_diag::Application::{Makehuman2, Mpfb};
        let breaks = &[(Makehuman2, "stops"), (Mpfb, "ignores it")];
        let rule = RuleInfo {
            breaks,
            ..RuleInfo::new("a-rule", Level::Warning, "")
        };
        let finding = Finding::new(&rule, "data/a.target", Place::File, "it is so");
        let expected =
            "  warning[a-rule] it is so\n  |-> MakeHuman 2: stops\n  `-> MPFB: ignores it\n";
        assert_eq!(whole(&finding), expected);
        assert_eq!(
            render(&finding, &[], false, &View::PLAIN),
            "  warning[a-rule] it is so\n"
        );
    }

    #[test]
    fn a_mark_without_length_is_drawn() {
        let mut finding = finding();
        let excerpt = mhlint_diag::Excerpt {
            text: "{\n}".to_owned(),
            first_line: 1,
            mark: 3..3,
        };
        (finding.location.line, finding.location.column) = (Some(2), Some(2));
        finding.location.excerpt = Some(excerpt);
        let text = whole(&finding);
        assert!(
            text.contains("[data/a.target:2:2]") && text.contains(" 2 | }"),
            "{text}"
        );
    }
}
