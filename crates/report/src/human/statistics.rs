//! `--statistics`: how many findings each rule has, in place of the findings.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::io::{self, Write};

use super::super::{Paint, View};
use mhlint_diag::{Level, Outcome};

/// A line for each rule, the gravest first, then the most frequent.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut counts: BTreeMap<(Level, &str), usize> = BTreeMap::new();
    for finding in &outcome.findings {
        *counts.entry((finding.level, finding.rule)).or_default() += 1;
    }
    let mut rows: Vec<((Level, &str), usize)> = counts.into_iter().collect();
    rows.sort_by_key(|((level, _), count)| (Reverse(*level), Reverse(*count)));
    let wide = rows
        .iter()
        .map(|(_, count)| count.to_string().len())
        .max()
        .unwrap_or_default();
    let long = rows
        .iter()
        .map(|((_, rule), _)| rule.len())
        .max()
        .unwrap_or_default();
    let paint = Paint { color: view.color };
    for ((level, rule), count) in &rows {
        let word = paint.level(*level, &format!("{:<7}", level.word()));
        let summary = view
            .rules
            .iter()
            .find(|info| info.id == *rule)
            .map_or("", |info| info.summary);
        let line = format!(
            "{count:>wide$}  {word}  {rule:<long$}  {}",
            paint.dim(summary)
        );
        writeln!(out, "{}", line.trim_end())?;
    }
    if rows.is_empty() {
        Ok(())
    } else {
        writeln!(out)
    }
}
