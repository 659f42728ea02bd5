//! `mhlint explain`: what a rule means, shown on its own fixtures. What is tested is what is told.

mod case;
mod markdown;

use std::io::Write;

use super::args::ExplainFormat;
use super::exit::{Exit, Failure};
use super::list::write_table;
use case::Case;
use mhlint_diag::{FixKind, RuleInfo, nearest};
use mhlint_engine::rule_infos;
use mhlint_report::{Paint, count, hang, paragraphs};

const SAFETY: &str = "Safety rule: cannot be ignored or lowered.";

pub(super) fn run(
    name: &str,
    format: ExplainFormat,
    page: Page,
    out: &mut dyn Write,
) -> Result<Exit, Failure> {
    let rules = rule_infos();
    if let Some(rule) = rules.iter().find(|rule| rule.id == name) {
        match format {
            ExplainFormat::Text => write_rule(rule, page, out)?,
            ExplainFormat::Markdown => markdown::write_rule(rule, out)?,
        }
        return Ok(Exit::Clean);
    }
    let start = name.trim_end_matches('*');
    let family: Vec<&RuleInfo> = rules
        .iter()
        .copied()
        .filter(|rule| rule.id.starts_with(start))
        .collect();
    if start.is_empty() || family.is_empty() {
        return Err(unknown(name, &rules));
    }
    match format {
        ExplainFormat::Text => write_family(start, &family, page.paint, out)?,
        ExplainFormat::Markdown => markdown::write_rules(&family, out)?,
    }
    Ok(Exit::Clean)
}

fn write_family(
    start: &str,
    family: &[&RuleInfo],
    paint: Paint,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    writeln!(
        out,
        "{} whose name starts with `{start}`:\n",
        count(family.len(), "rule")
    )?;
    write_table(family, paint, out)?;
    writeln!(out, "\n`mhlint explain RULE` explains one of them.")?;
    Ok(())
}

fn unknown(name: &str, rules: &[&RuleInfo]) -> Failure {
    let guess = nearest(name, rules.iter().map(|rule| rule.id));
    let hint = guess.map_or_else(
        || "`mhlint rules` lists all rules".to_owned(),
        |id| format!("did you mean `{id}`?"),
    );
    Failure::Usage(format!("unknown rule `{name}`; {hint}"))
}

/// How the page is written.
#[derive(Clone, Copy)]
pub(super) struct Page {
    pub(super) paint: Paint,
    pub(super) width: usize,
}

fn write_rule(rule: &RuleInfo, page: Page, out: &mut dyn Write) -> Result<(), Failure> {
    let Page { paint, width } = page;
    writeln!(
        out,
        "{}",
        paint.level(rule.level, &format!("{}[{}]", rule.level, rule.id))
    )?;
    writeln!(out, "{}\n", paint.bold(&hang("", rule.summary, width)))?;
    writeln!(out, "{}\n", paragraphs(&rule.documentation(), "", width))?;
    for (application, effect) in rule.breaks {
        writeln!(out, "{}", hang(&format!("{application}: "), effect, width))?;
    }
    writeln!(out, "{}", hang("Automatic fix: ", fix(rule.fix), width))?;
    if rule.cannot_be_ignored {
        writeln!(out, "{SAFETY}")?;
    }
    for option in rule.options {
        let head = format!("Option `{}` (default {}): ", option.name, option.default);
        writeln!(out, "{}", hang(&head, option.docs, width))?;
    }
    for case in shown_cases(rule.id) {
        write_case(&case, page, out)?;
    }
    Ok(())
}

/// The case `bad` and a good one, silent if there is such.
fn shown_cases(rule: &str) -> Vec<Case> {
    let cases = case::cases(rule);
    let bad = cases.iter().find(|case| case.name == "bad");
    let mut good = cases.iter().filter(|case| case.name.starts_with("good"));
    let good = good
        .clone()
        .find(|case| case.expected.is_empty())
        .or_else(|| good.next());
    bad.into_iter().chain(good).cloned().collect()
}

fn write_case(case: &Case, page: Page, out: &mut dyn Write) -> Result<(), Failure> {
    let is_bad = case.name.starts_with("bad");
    let title = if is_bad {
        page.paint.bad("Bad:")
    } else {
        page.paint.good("Good:")
    };
    let indent = if is_bad { 5 } else { 6 };
    let why = hang(&" ".repeat(indent), &case.why, page.width);
    writeln!(out, "\n{title} {}", why.trim_start())?;
    for line in case.lines() {
        let painted = match line.chars().nth(4) {
            Some('-') => page.paint.bad(&line),
            Some('+') => page.paint.good(&line),
            _ => line,
        };
        writeln!(out, "{painted}")?;
    }
    writeln!(out, "  {}", page.paint.dim(result(case)))?;
    for found in &case.expected {
        writeln!(out, "{}", hang("    ", found, page.width))?;
    }
    Ok(())
}

/// What leads over to the findings of a case. A good one may need what another rule finds.
fn result(case: &Case) -> &'static str {
    match (case.expected.is_empty(), case.name.starts_with("bad")) {
        (true, _) => "reports nothing",
        (false, true) => "reports",
        (false, false) => "reports nothing from this rule, only",
    }
}

const fn fix(kind: FixKind) -> &'static str {
    match kind {
        FixKind::None => "none; only you can decide what was meant.",
        FixKind::Safe => "`--fix`, where the finding says so; changes nothing else in the asset.",
        FixKind::Unsafe => {
            "`--fix --unsafe-fixes`, where the finding says so; check with `--diff`, it may not \
                do what you want."
        }
    }
}
