//! A keyword must not be set twice.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Grouped, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhmat::{Line, Value};
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "silently uses the last line"),
        (Makehuman1, "silently uses the last line"),
    ],
    docs: include_str!("duplicate_keyword.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-duplicate-keyword",
        Level::Warning,
        "a keyword of a material with different values",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        // A parameter without a value has a finding of its own, where that is read.
        let is_cut = |line: &Line| {
            loader::is_1(surface.application)
                && line.keyword.value == Value::Parameter
                && line.count < 2
        };
        let set = surface.material.lines.iter().filter(|line| {
            loader::reads(surface.application, line.keyword.name) && line.count > 0 && !is_cut(line)
        });
        let by_name: Grouped<(&str, &str), &Line> =
            grouped(set.filter_map(|line| Some((name(line)?, line))));
        for ((keyword, parameter), lines) in
            by_name.into_iter().filter(|(_, lines)| lines.len() > 1)
        {
            out.extend(finding(view, surface, keyword, parameter, &lines));
        }
    }
}

/// What a line sets.
fn name(line: &Line) -> Option<(&str, &str)> {
    match line.keyword.value {
        Value::Parameter => Some((line.keyword.name, line.word(0))),
        _ if matches!(line.keyword.name, "tag" | "shaderDefine") => None,
        _ => Some((line.keyword.name, "")),
    }
}

/// The words of a line that are read.
fn meaning(line: &Line) -> Vec<&str> {
    let read = match line.keyword.value {
        Value::Text => line.words.len(),
        Value::Colour => 3,
        Value::Parameter => 2,
        Value::Picture | Value::Word | Value::Flag | Value::Number | Value::Whole => 1,
    };
    line.words
        .iter()
        .take(read)
        .map(|word| &*word.text)
        .collect()
}

fn finding(
    view: &View<'_>,
    surface: &Surface<'_>,
    keyword: &str,
    parameter: &str,
    lines: &[&Line],
) -> Option<Finding> {
    // Of pictures those that are missing have findings of their own, and count for nothing.
    let is_picture = lines
        .iter()
        .any(|line| line.keyword.value == Value::Picture)
        && !loader::is_1(surface.application);
    let references = is_picture.then(|| view.references().of_file(surface.file));
    let found = references
        .into_iter()
        .flatten()
        .filter(|one| one.found().is_some());
    let found: BTreeSet<usize> = found.filter_map(|one| start(&one.place)).collect();
    let counts = |line: &&&Line| {
        !is_picture
            || line
                .words
                .first()
                .is_some_and(|word| found.contains(&word.span.start))
    };
    let lines: Vec<&Line> = lines.iter().filter(counts).copied().collect();
    let (last, others) = lines.split_last()?;
    let unused = others
        .iter()
        .rev()
        .find(|line| meaning(line) != meaning(last))?;
    let what = if parameter.is_empty() {
        keyword.to_owned()
    } else {
        format!("{keyword} {parameter}")
    };
    let message = format!("`{what}` has {} lines with different values", lines.len());
    let finding = RULE
        .at(surface.file, Surface::place(last), message)
        .key(what);
    let finding = finding.related(
        surface.file.path.clone(),
        Surface::place(unused),
        "has no effect",
    );
    Some(finding.help("keep the line you want, and remove the others"))
}

const fn start(place: &Place) -> Option<usize> {
    if let Place::Span(span) = place {
        Some(span.start)
    } else {
        None
    }
}
