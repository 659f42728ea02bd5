//! `mhlint rules`: the rule table, for people, programs and the documents.

use std::io::Write;

use serde_json::{Value, json};

use super::args::ListFormat;
use super::exit::{Exit, Failure};
use mhlint_diag::{FixKind, RuleInfo};
use mhlint_engine::rule_infos;
use mhlint_report::Paint;

pub(super) fn run(format: ListFormat, paint: Paint, out: &mut dyn Write) -> Result<Exit, Failure> {
    let rules = rule_infos();
    match format {
        ListFormat::Table => write_table(&rules, paint, out)?,
        ListFormat::Markdown => write_markdown(&rules, out)?,
        ListFormat::Json => {
            let items: Vec<Value> = rules.iter().map(|rule| item(rule)).collect();
            serde_json::to_writer_pretty(&mut *out, &items).map_err(std::io::Error::from)?;
            writeln!(out)?;
        }
    }
    Ok(Exit::Clean)
}

/// How a rule fixes what it finds; nothing where only a person can.
const fn shown_fix(rule: &RuleInfo) -> &'static str {
    match rule.fix {
        FixKind::None => "",
        kind => kind.word(),
    }
}

/// Writes rules as lines of id, level, kind of fix and summary.
pub(super) fn write_table(
    rules: &[&RuleInfo],
    paint: Paint,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let width = rules.iter().map(|rule| rule.id.len()).max().unwrap_or(0);
    for rule in rules {
        let level = paint.level(rule.level, &format!("{:<7}", rule.level.word()));
        writeln!(
            out,
            "{:<width$}  {level}  {:<6}  {}",
            rule.id,
            shown_fix(rule),
            rule.summary
        )?;
    }
    Ok(())
}

fn write_markdown(rules: &[&RuleInfo], out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(
        out,
        "| rule | level | fix | what is wrong |\n|---|---|---|---|"
    )?;
    for rule in rules {
        writeln!(
            out,
            "| `{}` | {} | {} | {} |",
            rule.id,
            rule.level,
            shown_fix(rule),
            rule.summary.replace('|', "\\|")
        )?;
    }
    Ok(())
}

fn item(rule: &RuleInfo) -> Value {
    let breaks = rule
        .breaks
        .iter()
        .map(|(application, effect)| json!({ "application": application, "effect": effect }));
    json!({
        "id": rule.id,
        "family": rule.family(),
        "level": rule.level,
        "summary": rule.summary,
        "fix": rule.fix.word(),
        "unmutable": rule.cannot_be_ignored,
        "breaks": breaks.collect::<Vec<_>>(),
        "options": rule.options,
    })
}
