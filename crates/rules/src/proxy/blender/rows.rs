//! The rows: which of them are taken, and what they are tied to
//! (`docs/loaders/mpfb/clothes.md#rows-of-an-asset`,
//! `docs/loaders/mpfb/clothes.md#mesh-of-an-asset`, `docs/loaders/mpfb/clothes.md#fitting`).

use super::super::texts;
use super::{at, counted, is_number, lost_rows, whole};
use crate::rule::counted as count_of;
use crate::{Rule, shown};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, Tally};
use mhlint_formats::mhclo::{Flow, Gap, Part, StopCause};
use mhlint_repo::Body;

const VALUE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `ValueError` when the asset is loaded",
)];
const INDEX: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `IndexError` when the asset is loaded",
)];

/// The line at which the reader stops, but for scales and the list, which have findings of their
/// own.
pub(in crate::proxy) fn stops(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let Some(stop) = &text.clothes.flow.stop else {
            continue;
        };
        let word = &*stop.word;
        let (message, case, help) = match stop.cause {
            StopCause::NoValue => (
                format!("`{word}` has no value"),
                INDEX,
                "write the value, or remove the line",
            ),
            StopCause::Value => (
                format!("`{word}` is not a whole number"),
                VALUE,
                "write a whole number",
            ),
            StopCause::Words(words) => (
                format!("a vertex row has {words} words, expected 1 or 9"),
                INDEX,
                OFFSETS,
            ),
            StopCause::RowWord => {
                let help = if word.contains(',') {
                    "write decimal points instead of commas"
                } else {
                    "write a number"
                };
                (
                    format!("`{word}` in a vertex row is not a number"),
                    VALUE,
                    help,
                )
            }
            StopCause::ShortScale | StopCause::ScaleWord | StopCause::ListWord => continue,
        };
        let key = if stop.cause == StopCause::NoValue {
            word
        } else {
            ""
        };
        out.push(
            rule.at(text.file, at(stop.line), message)
                .key(key)
                .case(case)
                .help(help),
        );
    }
}

const OFFSETS: &str =
    "restore the missing numbers: three vertices, three weights and three offsets, such as `0 0 0`";

const NO_ROWS: Case = &[(
    Mpfb,
    Level::Error,
    "takes no vertex row, and fails with `ValueError` when the asset is loaded",
)];

/// Rows behind a line that ends them.
pub(in crate::proxy) fn lost(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in whole(body) {
        let Some(gap) = lost_rows(&text.clothes.flow).filter(|gap| !is_number(&gap.word)) else {
            continue;
        };
        let what = match &*gap.word {
            "" => "an empty line".to_owned(),
            word if word.starts_with('#') => {
                format!("`{}` without a space after the `#`", shown(word))
            }
            word => format!("`{}`", shown(word)),
        };
        let help = match &*gap.word {
            "" => "remove the empty line",
            word if word.starts_with('#') => "write a space after the `#`",
            _ => "move the line above `verts`",
        };
        let message = format!(
            "{what} among the vertex rows ends them: {} behind it",
            rows_are_lost(gap)
        );
        let finding = rule.at(text.file, at(gap.line), message).help(help);
        let finding = finding.evidence(Evidence::counted(
            usize::try_from(gap.lines).unwrap_or(usize::MAX),
        ));
        out.push(if gap.taken == 0 {
            finding.case(NO_ROWS)
        } else {
            finding
        });
    }
}

/// A row that does not begin with digits.
pub(in crate::proxy) fn signs(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in whole(body) {
        let of_rows = |gap: &&Gap| gap.ended == Some(Part::Rows) && is_number(&gap.word);
        let Some(gap) = text.clothes.flow.gaps.iter().find(of_rows) else {
            continue;
        };
        let message = format!(
            "the vertex row `{} …` does not begin with a plain number",
            shown(&gap.word)
        );
        let finding = rule.at(text.file, at(gap.line), message);
        let finding = finding
            .help("write the number of the base vertex in digits only, or export the asset again");
        out.push(if gap.taken == 0 {
            finding.case(NO_ROWS)
        } else {
            finding
        });
    }
}

fn rows_are_lost(gap: &Gap) -> String {
    match gap.lines {
        1 => "1 row is lost".to_owned(),
        lines => format!("{lines} rows are lost"),
    }
}

const MORE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `IndexError` when the asset is put on a character with a rig",
)];

/// Rows and vertices that faces use.
pub(in crate::proxy) fn count(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in whole(body).filter(|text| !is_told(&text.clothes.flow)) {
        let flow = &text.clothes.flow;
        if flow.rows == 0 {
            let finding = rule
                .at(text.file, Place::File, "there are no vertex rows")
                .key("none")
                .case(NO_ROWS);
            out.push(finding.help("export the asset again"));
            continue;
        }
        let Some((file, mesh)) = text.worn.mesh().filter(|(_, mesh)| body.opens(mesh)) else {
            continue;
        };
        let (all, used) = (mesh.facts.vertices, mesh.used());
        // Rows that count loose vertices are told at the mesh.
        if flow.rows == used || flow.rows == all {
            continue;
        }
        let message = format!(
            "{} for {} of `{}`",
            count_of(flow.rows, "vertex row"),
            if used == 1 {
                "1 vertex".to_owned()
            } else {
                format!("{used} vertices")
            },
            file.file_name()
        );
        let finding = rule.at(text.file, at(text.clothes.line_of(0)), message);
        let finding = finding.related(file.path.clone(), Place::File, "the mesh");
        let finding = finding.evidence(Evidence::counted(flow.rows.abs_diff(used)));
        let finding = finding.help(
            "export the asset again from this mesh, or restore the mesh that it was made from",
        );
        out.push(if flow.rows > used {
            finding.case(MORE)
        } else {
            finding
        });
    }
}

/// Whether it has a finding that explains which rows there are.
fn is_told(flow: &Flow) -> bool {
    let is_verts = |gap: &Gap| gap.ended.is_none() && super::list::is_verts(&gap.word);
    let is_signed = |gap: &Gap| gap.ended == Some(Part::Rows) && is_number(&gap.word);
    lost_rows(flow).is_some()
        || flow.early_range.is_some() && flow.rows > 0
        || flow.gaps.iter().any(|gap| is_verts(gap) || is_signed(gap))
}

const HIDDEN: Case = &[(
    Mpfb,
    Level::Info,
    "ignores the number: it hides what exists",
)];
const FROM_END: Case = &[(
    Mpfb,
    Level::Warning,
    "counts the number from the end of the mesh: the vertex is tied to another place",
)];

/// Rows and lists that name vertices which do not exist.
pub(in crate::proxy) fn range(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in counted(body) {
        let Some(size) = text.size_of_base(body) else {
            continue;
        };
        let last = size.vertices.saturating_sub(1);
        let (rows, deletes) = (&text.clothes.rows, &text.clothes.deletes);
        let told = |tally: &Tally, what: &str| {
            let (line, vertex) = tally.first.first()?;
            let more = crate::rule::such(tally.count, "numbers");
            let message =
                format!("{what} names vertex {vertex}{more}; the base mesh has 0 to {last}");
            let finding = rule
                .at(text.file, at(*line), message)
                .evidence(tally.evidence(rows.count));
            Some(finding.help("export the asset again for this base mesh"))
        };
        let beyond = [&rows.out_of_range, &rows.in_seams]
            .into_iter()
            .find_map(|tally| told(tally, "a vertex row"));
        out.extend(beyond);
        out.extend(told(&rows.unstorable, "a vertex row").map(|finding| {
            let count = i64::try_from(size.vertices).unwrap_or(i64::MAX);
            let wraps = rows
                .unstorable
                .first
                .iter()
                .all(|(_, vertex)| (-count..0).contains(vertex));
            let finding = finding.key("unstorable");
            if wraps {
                finding.case(FROM_END)
            } else {
                finding
            }
        }));
        out.extend(
            told(&deletes.out_of_range, "the list of vertices to hide")
                .map(|one| one.key("list").case(HIDDEN)),
        );
    }
}

const ZERO: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `ZeroDivisionError` on a character with a rig that moves these vertices",
)];

/// Weights that do not sum to 1.
pub(in crate::proxy) fn sums(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in counted(body) {
        let rows = &text.clothes.rows;
        let (Some((line, _)), Some((vertex, sum))) =
            (rows.coarse_sums.first.first(), rows.worst_sum)
        else {
            continue;
        };
        let message = match rows.coarse_sums.count {
            1 => format!("the weights of {} sum to {sum:.3}", text.vertex(vertex)),
            count => format!(
                "the weights of {count} of {} rows do not sum to 1, worst {}: {sum:.3}",
                rows.count,
                text.vertex(vertex)
            ),
        };
        let finding = rule
            .at(text.file, at(*line), message)
            .evidence(rows.coarse_sums.evidence(rows.count));
        let finding = finding.help("export the asset again, or correct the weights of the rows");
        out.push(if sum.abs() < 1e-6 {
            finding.case(ZERO)
        } else {
            finding
        });
    }
}

/// A number that is none.
pub(in crate::proxy) fn not_finite(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in counted(body) {
        let rows = &text.clothes.rows;
        let Some((line, vertex)) = rows.non_finite.first.first() else {
            continue;
        };
        let message = match rows.non_finite.count {
            1 => format!(
                "the row of {} has a number that is NaN or infinite",
                text.vertex(*vertex)
            ),
            count => {
                format!(
                    "{count} rows have numbers that are NaN or infinite, first that of {}",
                    text.vertex(*vertex)
                )
            }
        };
        let finding = rule
            .at(text.file, at(*line), message)
            .evidence(rows.non_finite.evidence(rows.count));
        out.push(finding.help("give the row finite numbers, or export the asset again"));
    }
}
