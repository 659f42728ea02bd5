//! Numbers must be where numbers belong.

use super::super::{Check, Rule, RuleCx};
use super::{INDEX, Text, VALUE, all_texts, blender, lines, more, sections, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::{Fault, FaultKind};
use mhlint_formats::{python_float, python_int};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "crashes when the asset is put on"),
        (Makehuman1, "does not put the asset on"),
        (Mpfb, "fails with an exception when the asset is loaded"),
    ],
    docs: include_str!("syntax.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-syntax",
        Level::Error,
        "a line of an asset cannot be read",
    )
});

const NO_ASSET: Case = &[
    (
        Makehuman2,
        Level::Error,
        "lists an asset without a name, and crashes with `AttributeError` when it is put on",
    ),
    (Makehuman1, Level::Error, "does not put the asset on"),
    (
        Mpfb,
        Level::Error,
        "lists the asset, and fails with `ValueError` when it is loaded",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in all_texts(body).filter(|text| !text.is_asset()) {
        let message = "this is not an asset: no line has one of the keywords of assets";
        let finding = RULE
            .at(text.file, Place::File, message)
            .key("file")
            .case(NO_ASSET);
        let is_of_macos = text.file.file_name().starts_with("._");
        out.push(finding.help(if is_of_macos {
            "remove the file: macOS leaves such beside the files that it copies to other disks"
        } else {
            "restore the asset: this file is something else, such as a web page"
        }));
    }
    if body.is_mpfb() {
        return blender::rows::stops(&RULE, body, out);
    }
    for text in texts(body) {
        out.extend(row_words(&text));
        out.extend(short_rows(&text));
        out.extend(whole_numbers(&text));
        out.extend(lone_author(&text));
        out.extend(without_value(&text));
    }
}

/// The rows with a fault, without those that belong to a section whose keyword is wrong.
fn of_rows<'v>(
    text: &Text<'_, 'v>,
    wanted: fn(FaultKind) -> bool,
) -> Option<(Vec<&'v Fault>, u64)> {
    let (faults, count) = text.reading.faults(wanted)?;
    // At `weights` MakeHuman 2 refuses the asset: it reads no row behind it.
    let refused = text
        .reading
        .faults(|kind| kind == FaultKind::OldFormat)
        .filter(|_| !text.is_makehuman1());
    let refused = refused
        .and_then(|(faults, _)| faults.first().map(|fault| fault.line))
        .unwrap_or(u32::MAX);
    let end = sections::misplaced_from(text).min(refused);
    let own: Vec<&Fault> = faults
        .into_iter()
        .filter(|fault| fault.line < end)
        .collect();
    if own.is_empty() {
        None
    } else {
        Some((own, if end == u32::MAX { count } else { 1 }))
    }
}

fn row_words(text: &Text<'_, '_>) -> Option<Finding> {
    let (faults, count) = of_rows(text, |kind| kind == FaultKind::RowWord)?;
    let first = faults.first()?;
    let is_number = python_float(first.word.as_bytes()).is_some();
    let kind = if is_number { "whole number" } else { "number" };
    let message = format!(
        "`{}` in a vertex row is not a {kind}{}",
        first.word,
        more(count)
    );
    let help = match &*first.word {
        word if word.contains(',') => "write decimal points instead of commas",
        word if word.starts_with('#') => "move the comment to a line of its own",
        _ if is_number => "write a whole number: the first three numbers are vertices",
        _ => "write a number",
    };
    Some(told(text, first, message, VALUE, help).evidence(lines(&faults, count)))
}

fn short_rows(text: &Text<'_, '_>) -> Option<Finding> {
    let (faults, count) = of_rows(text, |kind| matches!(kind, FaultKind::FieldCount(_)))?;
    let first = faults.first()?;
    let FaultKind::FieldCount(words) = first.kind else {
        return None;
    };
    let message = format!(
        "a vertex row has {words} words, expected 1, 6 or 9{}",
        more(count)
    );
    let help = "restore the missing numbers, or export the asset again";
    Some(
        told(text, first, message, INDEX, help)
            .key("words")
            .evidence(lines(&faults, count)),
    )
}

fn whole_numbers(text: &Text<'_, '_>) -> Option<Finding> {
    let pole = text
        .reading
        .last("max_pole")
        .filter(|entry| text.is_makehuman1() && python_int(entry.word().as_bytes()).is_none());
    if let Some(entry) = pole {
        let message = format!("`{}` of `max_pole` is not a whole number", entry.word());
        let finding = RULE
            .at(text.file, Place::Span(entry.word_span()), message)
            .key("max_pole")
            .case(VALUE);
        return Some(finding.help("write a whole number"));
    }
    let (faults, _) = text.reading.faults(|kind| kind == FaultKind::NotWhole)?;
    let first = faults.first()?;
    let entry = text
        .clothes
        .entries
        .iter()
        .find(|entry| entry.line == first.line)?;
    let message = format!(
        "`{}` of `{}` is not a whole number",
        first.word, entry.keyword
    );
    Some(told(text, first, message, VALUE, "write a whole number").key(&*entry.keyword))
}

/// Where the word behind a keyword is read, whether there is one or not.
fn without_value(text: &Text<'_, '_>) -> Option<Finding> {
    let reading = text.reading;
    let (faults, _) = reading.faults(|kind| kind == FaultKind::MissingValue)?;
    // A missing mesh has a finding of its own.
    let of_own = |fault: &&&Fault| reading.needs_value(&fault.word) && &*fault.word != "obj_file";
    let first = faults.iter().find(of_own)?;
    let message = format!("`{}` has no value", first.word);
    Some(
        told(
            text,
            first,
            message,
            INDEX,
            "write the value, or remove the line",
        )
        .key(&*first.word),
    )
}

fn lone_author(text: &Text<'_, '_>) -> Option<Finding> {
    let comment = text
        .clothes
        .scanned
        .lone_author
        .as_ref()
        .filter(|_| !text.is_makehuman1())?;
    let message = format!(
        "the comment `{}` has `author` in it but no second word",
        comment.text
    );
    let finding = RULE
        .at(text.file, Place::Span(comment.span.clone()), message)
        .key("author")
        .case(INDEX);
    Some(finding.help("write `# author` followed by a name, or remove the comment"))
}

fn told(text: &Text<'_, '_>, fault: &Fault, message: String, case: Case, help: &str) -> Finding {
    RULE.at(text.file, Place::Span(fault.span.clone()), message)
        .case(case)
        .help(help)
}
