//! `mhlint eval cases`.

use std::io::Write;
use std::path::PathBuf;

use super::args::CasesArgs;
use super::write;
use crate::cli::exit::{Exit, Failure};
use mhlint_engine::open_base;
use mhlint_evaluate::{CaseRun, Comparison, Deviation, Error, Roots, read_text, run_cases};
use mhlint_report::printable;

/// Differences that are listed of a case.
const SHOWN: usize = 10;

pub(super) fn run(
    args: &CasesArgs,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<Exit, Failure> {
    let roots = args
        .roots
        .iter()
        .map(|text| root(text))
        .collect::<Result<Vec<_>, _>>()?;
    let roots = Roots::new(roots)?;
    let text = read_text(&args.file)?;
    let cases = run_cases(&args.file.to_string_lossy(), &text, &roots, open_base)?;
    for report in &cases.reports {
        for note in &report.notes {
            writeln!(
                err,
                "mhlint: {}",
                printable(&format!("case {}: {note}", report.name))
            )?;
        }
    }
    if args.compare {
        return compare(&cases, args, out);
    }
    write::write(&cases.printed(), args.output.as_deref(), out)?;
    let mut exit = Exit::Clean;
    for report in &cases.reports {
        if let Err(error) = &report.outputs {
            writeln!(
                err,
                "mhlint: {}",
                printable(&format!("case {}: {error}", report.name))
            )?;
            exit = Exit::CannotWork;
        }
    }
    Ok(exit)
}

fn root(text: &str) -> Result<(String, PathBuf), Error> {
    let wanted = || {
        Error::Input(format!(
            "`--root {text}`: expected NAME=DIR, for example `makehuman2=/path`"
        ))
    };
    let (name, folder) = text
        .split_once('=')
        .filter(|(_, folder)| !folder.is_empty())
        .ok_or_else(wanted)?;
    Ok((name.to_owned(), PathBuf::from(folder)))
}

fn compare(cases: &CaseRun<'_>, args: &CasesArgs, out: &mut dyn Write) -> Result<Exit, Failure> {
    let comparisons = cases.compared();
    let mut lines: Vec<String> = comparisons.iter().map(line).collect();
    let agreeing = comparisons
        .iter()
        .filter(|comparison| comparison.agrees())
        .count();
    lines.push(format!(
        "{agreeing} of {} cases agree within the tolerances\n",
        comparisons.len()
    ));
    write::write(lines.concat().as_bytes(), args.output.as_deref(), out)?;
    Ok(
        if comparisons
            .iter()
            .any(|comparison| comparison.failure.is_some())
        {
            Exit::CannotWork
        } else if agreeing < comparisons.len() {
            Exit::Findings
        } else {
            Exit::Clean
        },
    )
}

/// A case: its verdict, and the largest deviation of every quantity with what is allowed.
fn line(comparison: &Comparison) -> String {
    if let Some(failure) = &comparison.failure {
        return format!(
            "{}\n",
            printable(&format!("error   {}: {failure}", comparison.name))
        );
    }
    let numbers: Vec<String> = comparison.deviations.iter().map(deviation).collect();
    let verdict = if comparison.agrees() {
        "agrees "
    } else {
        "differs"
    };
    let mut lines = vec![format!(
        "{verdict} {}: {}\n",
        printable(&comparison.name),
        printable(&numbers.join(", "))
    )];
    let shown = comparison.differences.iter().take(SHOWN);
    lines.extend(shown.map(|difference| format!("        {}\n", printable(difference))));
    if comparison.differences.len() > SHOWN {
        lines.push(format!(
            "        and {} more\n",
            comparison.differences.len() - SHOWN
        ));
    }
    lines.concat()
}

fn deviation(deviation: &Deviation) -> String {
    let Deviation {
        quantity,
        worst,
        limit,
        at,
    } = deviation;
    if deviation.is_allowed() {
        format!("{quantity} {worst:.1e} (<= {limit:.0e})")
    } else {
        format!("{quantity} {worst:.1e} (> {limit:.0e}, at {at})")
    }
}
