//! A data line of a target has four fields.

use super::super::cause::consequence::{BY_HAND, MACRO_ROWS};
use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "silently skips such lines: their vertices do not move",
        ),
        (
            Makehuman1,
            "silently skips such lines: their vertices do not move",
        ),
        (
            Mpfb,
            "fails when its slider moves first and does nothing afterwards; saved characters with \
                it load only in part",
        ),
    ],
    levels: &[(Mpfb, Level::Error)],
    docs: include_str!("field_count.md").trim_ascii_end(),
    counts: "lines",
    ..RuleInfo::new(
        "target-field-count",
        Level::Warning,
        "a line of a target does not have four \
        fields",
    )
});

const NO_ROW: &str = "silently skips the line, which is not a row";
const PROSE: Case = &[
    (Makehuman2, Level::Info, NO_ROW),
    (Makehuman1, Level::Info, NO_ROW),
];
const BOTH: &str =
    "skips the markers and reads the rows of both sides; the last row of a vertex wins";
const BOTH_SIDES: Case = &[
    (Makehuman2, Level::Warning, BOTH),
    (Makehuman1, Level::Warning, BOTH),
];

/// The same for MPFB: what stops it, else what it takes and others do not.
fn of_mpfb(view: &View<'_>, file: &FileFacts, out: &mut Vec<Finding>) {
    let Some(blanks) = file.target().and_then(|facts| facts.blanks.as_ref()) else {
        return;
    };
    for (tally, case, help) in [
        (
            &blanks.few,
            &[][..],
            "write rows as `INDEX X Y Z`, and remarks on lines of their own that begin with `#`",
        ),
        (
            &blanks.further,
            TAKEN,
            "put remarks on lines of their own that begin with `#`",
        ),
    ] {
        let Some((line, fields)) = tally.first.first() else {
            continue;
        };
        let fields = counted(fields.unsigned_abs(), "field");
        let message = match tally.count {
            1 => format!("the line has {fields} instead of 4"),
            count => format!("{count} lines do not have four fields; the first has {fields}"),
        };
        let mut evidence = Evidence::of_unnamed(
            tally
                .first
                .iter()
                .map(|(line, fields)| format!("line {line}: {fields}")),
        );
        evidence.count = tally.count;
        let finding = RULE
            .at(file, Place::Line(*line), message)
            .case(case)
            .help(help)
            .evidence(evidence);
        let stops = match file.kind {
            Kind::PartTarget | Kind::PackedPartTarget => BY_HAND,
            _ if view.composes_name_of(file) => MACRO_ROWS,
            _ => &[],
        };
        return out.push(if case.is_empty() {
            finding.case(stops)
        } else {
            finding
        });
    }
}

const TAKEN: Case = &[(
    Mpfb,
    Level::Info,
    "takes the first four fields; MakeHuman skips the line",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return of_mpfb(view, file, out);
    }
    // A packed one only MPFB opens.
    let Some(facts) = file.target().filter(|_| file.kind == Kind::Target) else {
        return;
    };
    let Some((line, fields)) = facts.field_count.first.first() else {
        return;
    };
    // What has no row is no target unless it lies where one is looked for: systemd has files of
    // this name.
    if facts.rows == 0
        && view.is_makehuman1()
        && !view.layers().checks_system()
        && !view.lists(file)
    {
        return;
    }
    // A marker of four words stops the program: `target-syntax`.
    if facts.conflict.is_some() && facts.unreadable_rows > 0 {
        return;
    }
    if let Some((line, marker)) = &facts.conflict {
        let message = format!("unresolved merge conflict: `{marker}`");
        let finding = RULE
            .at(file, Place::Line(*line), message)
            .key("conflict")
            .case(BOTH_SIDES);
        return out.push(
            finding.help("keep one side, and remove the lines `<<<<<<<`, `=======` and `>>>>>>>`"),
        );
    }
    let count = facts.field_count.count;
    let fields = counted(fields.unsigned_abs(), "field");
    let message = match (facts.rows, count) {
        (0, _) => {
            format!("no line has four fields, so the target does nothing; the first has {fields}")
        }
        (_, 1) => format!("the line has {fields} instead of 4 and is skipped"),
        _ => {
            format!("{count} lines do not have four fields and are skipped; the first has {fields}")
        }
    };
    let cases = facts
        .field_count
        .first
        .iter()
        .map(|(line, fields)| format!("line {line}: {fields}"));
    let mut evidence = Evidence::of_unnamed(cases);
    evidence.count = count;
    let total = facts
        .rows
        .saturating_add(usize::try_from(count).unwrap_or(usize::MAX));
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .help("write rows as `INDEX X Y Z`, and remarks on lines of their own that begin with `#`")
        .parts(facts.field_count_names.names())
        .evidence(evidence.out_of(total));
    let is_prose = facts.rows > 0 && facts.broken_rows == 0;
    out.push(if is_prose {
        finding.case(PROSE)
    } else {
        finding
    });
}
