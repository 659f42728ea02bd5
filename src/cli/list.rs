//! `mhlint rules`: the rule table, for people, programs and the README.

use std::io::Write;

use serde::Serialize;

use super::args::ListFormat;
use super::exit::{Exit, Failure};
use crate::diag::{Application, FixKind, Level, RuleInfo};
use crate::engine::rule_infos;
use crate::report::Paint;

#[derive(Serialize)]
struct Item {
    id: &'static str,
    family: &'static str,
    level: Level,
    summary: &'static str,
    fix: &'static str,
    unmutable: bool,
    breaks: Vec<BreakItem>,
    options: Vec<OptionItem>,
}

#[derive(Serialize)]
struct BreakItem {
    application: Application,
    effect: &'static str,
}

#[derive(Serialize)]
struct OptionItem {
    name: &'static str,
    default: f64,
    docs: &'static str,
}

pub(super) fn run(format: ListFormat, paint: Paint, out: &mut dyn Write) -> Result<Exit, Failure> {
    let rules = rule_infos();
    match format {
        ListFormat::Table => write_table(&rules, paint, out)?,
        ListFormat::Markdown => write_markdown(&rules, out)?,
        ListFormat::Json => {
            let items: Vec<Item> = rules.iter().map(|rule| item(rule)).collect();
            serde_json::to_writer_pretty(&mut *out, &items).map_err(std::io::Error::from)?;
            writeln!(out)?;
        }
    }
    Ok(Exit::Clean)
}

/// The word for a kind of fix.
pub(super) const fn fix_word(fix: FixKind) -> &'static str {
    match fix {
        FixKind::None => "none",
        FixKind::Safe => "safe",
        FixKind::Unsafe => "unsafe",
    }
}

/// Writes rules as lines of id, level and summary.
pub(super) fn write_table(rules: &[&RuleInfo], paint: Paint, out: &mut dyn Write) -> Result<(), Failure> {
    let width = rules.iter().map(|rule| rule.id.len()).max().unwrap_or(0);
    for rule in rules {
        let level = paint.level(rule.level, &format!("{:<7}", rule.level.word()));
        writeln!(out, "{:<width$}  {level}  {}", rule.id, rule.summary)?;
    }
    Ok(())
}

fn write_markdown(rules: &[&RuleInfo], out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "| rule | level | what is wrong |\n|---|---|---|")?;
    for rule in rules {
        writeln!(out, "| `{}` | {} | {} |", rule.id, rule.level, rule.summary.replace('|', "\\|"))?;
    }
    Ok(())
}

fn item(rule: &RuleInfo) -> Item {
    let breaks = rule.breaks.iter().map(|(application, effect)| BreakItem { application: *application, effect });
    let options = rule.options.iter();
    Item {
        id: rule.id,
        family: rule.family(),
        level: rule.level,
        summary: rule.summary,
        fix: fix_word(rule.fix),
        unmutable: rule.unmutable,
        breaks: breaks.collect(),
        options: options
            .map(|option| OptionItem { name: option.name, default: option.default, docs: option.docs })
            .collect(),
    }
}
