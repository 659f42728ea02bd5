//! A keyword must not be set twice.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::loader;
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo, grouped};
use crate::formats::mhmat::{Line, Value};
use crate::repo::{Surface, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently uses the last line")],
    docs: "A keyword of a material stands on several lines with different values.\n\n\
        MakeHuman 2 uses the last one; of textures the last one whose picture exists. `tag` may be repeated, and \
        `shaderParam` with different names. Lines that say the same are not reported.\n\n\
        Keep the line that you want.",
    ..RuleInfo::new("material-duplicate-keyword", Level::Warning, "a keyword of a material with different values")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view.surfaces().iter().filter(|surface| view.layers().is_checked(surface.file)) {
        let set = surface.material.lines.iter().filter(|line| loader::reads(line.keyword.name) && line.count > 0);
        let by_name: BTreeMap<(&str, &str), Vec<&Line>> = grouped(set.filter_map(|line| Some((name(line)?, line))));
        for ((keyword, parameter), lines) in by_name {
            out.extend(finding(surface, keyword, parameter, &lines));
        }
    }
}

/// What a line sets.
fn name(line: &Line) -> Option<(&str, &str)> {
    match line.keyword.value {
        Value::Parameter => Some((line.keyword.name, line.word(0))),
        _ if line.keyword.name == "tag" => None,
        _ => Some((line.keyword.name, "")),
    }
}

fn finding(surface: &Surface<'_>, keyword: &str, parameter: &str, lines: &[&Line]) -> Option<Finding> {
    let (last, others) = lines.split_last()?;
    let lost = others.iter().rev().find(|line| line.text() != last.text())?;
    if last.keyword.value == Value::Picture {
        // One that is missing has a finding of its own, and the picture of a line above.
        let own = last.words.first().map(|word| Place::Span(word.span.clone()));
        surface.picture(keyword).filter(|picture| picture.file.is_some() && Some(&picture.place) == own.as_ref())?;
    }
    let what = if parameter.is_empty() { keyword.to_owned() } else { format!("{keyword} {parameter}") };
    let message = format!("`{what}` has {} lines with different values", lines.len());
    let finding = RULE.at(surface.file, Surface::place(last), message).key(what);
    let finding = finding.related(surface.file.path.clone(), Surface::place(lost), "has no effect");
    Some(finding.help("remove the lines that are not meant"))
}
