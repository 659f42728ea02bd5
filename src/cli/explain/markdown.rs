//! Rules as sections of a page in Markdown, for `docs/rules/`.

use std::io::Write;

use super::case::Case;
use super::{SAFETY, fix, result, shown_cases};
use crate::cli::exit::Failure;
use mhlint_diag::RuleInfo;

/// Several rules, with an empty line between them.
pub(super) fn write_rules(rules: &[&RuleInfo], out: &mut dyn Write) -> Result<(), Failure> {
    for (at, rule) in rules.iter().enumerate() {
        if at > 0 {
            writeln!(out)?;
        }
        write_rule(rule, out)?;
    }
    Ok(())
}

pub(super) fn write_rule(rule: &RuleInfo, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(
        out,
        "## {}\n\n**{}**: {}\n\n{}\n",
        rule.id,
        rule.level,
        rule.summary,
        rule.documentation()
    )?;
    for (application, effect) in rule.breaks {
        writeln!(out, "- **{application}:** {effect}")?;
    }
    writeln!(out, "- **Automatic fix:** {}", fix(rule.fix))?;
    if rule.cannot_be_ignored {
        writeln!(out, "- {SAFETY}")?;
    }
    for option in rule.options {
        writeln!(
            out,
            "- **Option `{}`** (default {}): {}",
            option.name, option.default, option.docs
        )?;
    }
    shown_cases(rule.id)
        .iter()
        .try_for_each(|case| write_case(case, out))
}

fn write_case(case: &Case, out: &mut dyn Write) -> Result<(), Failure> {
    let is_bad = case.name.starts_with("bad");
    writeln!(
        out,
        "\n**{}:** {}\n",
        if is_bad { "Bad" } else { "Good" },
        case.why
    )?;
    write_block(
        "diff",
        &case
            .lines()
            .iter()
            .map(|line| outdented(line))
            .collect::<Vec<_>>(),
        out,
    )?;
    if case.expected.is_empty() {
        writeln!(out, "\n{}.", result(case))?;
    } else {
        writeln!(out, "\n{}\n", result(case))?;
        write_block(
            "text",
            &case.expected.iter().map(String::as_str).collect::<Vec<_>>(),
            out,
        )?;
    }
    Ok(())
}

/// A line of a case with its sign in the first column, where readers of diffs look for it.
fn outdented(line: &str) -> &str {
    let outer = line.strip_prefix("  ").unwrap_or(line);
    outer.strip_prefix("  ").unwrap_or(outer)
}

fn write_block(language: &str, lines: &[&str], out: &mut dyn Write) -> Result<(), Failure> {
    let fence = if lines.iter().any(|line| line.contains("```")) {
        "````"
    } else {
        "```"
    };
    writeln!(out, "{fence}{language}")?;
    for line in lines {
        writeln!(out, "{}", line.trim_end())?;
    }
    writeln!(out, "{fence}")?;
    Ok(())
}
