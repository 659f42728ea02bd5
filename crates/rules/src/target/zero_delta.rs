//! Rows that move nothing in a target that moves something.

use super::super::{Check, Rule, RuleCx, counted};
use super::{first_row, targets};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Change, EXAMPLES, Evidence, Finding, Fix, FixKind, Level, Rewrite, RuleInfo, grouped,
};
use mhlint_discover::Kind;
use mhlint_formats::target::TargetFacts;
use mhlint_repo::{Body, FileFacts, Layer};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[
        (
            Makehuman2,
            "loads and adds the zeros, which only costs a little time and memory",
        ),
        (
            Mpfb,
            "adds the zeros, which changes nothing; it writes such rows itself",
        ),
    ],
    docs: include_str!("zero_delta.md").trim_ascii_end(),
    counts: "rows",
    ..RuleInfo::new(
        "target-zero-delta",
        Level::Info,
        "rows of a target that move nothing",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = body.layers.checked;
    // A target that moves nothing is a finding of its own.
    let with_zero_rows =
        targets(body).filter(|(_, _, facts)| facts.zero.count > 0 && !facts.moves_nothing());
    for (folder, found) in
        grouped(with_zero_rows.map(|(_, file, facts)| (body.folder_of(file), (file, facts))))
    {
        let finding = match found.as_slice() {
            [] => continue,
            [(file, facts)] => one_file(layer, folder, file, facts),
            [(file, facts), ..] => {
                let most = most_first(&found);
                let (message, evidence) = of_folder(&layer.shown(folder), &most);
                let finding = RULE
                    .at(file, first_row(&facts.zero), message)
                    .evidence(evidence);
                let parts = found
                    .iter()
                    .map(|(file, facts)| (&file.rel, &file.path, first_row(&facts.zero)));
                let finding = finding.asset(layer.display(folder)).parts_at(parts);
                most.iter()
                    .take(EXAMPLES * 2)
                    .fold(finding, |finding, (file, facts)| {
                        finding.related(
                            &file.path,
                            first_row(&facts.zero),
                            counted(facts.zero.count, "zero row"),
                        )
                    })
            }
        };
        let help = "remove the rows, unless they should move something";
        out.push(finding.help(help).fix(fix(body, &found)));
    }
}

fn fix(body: &Body<'_>, found: &[(&FileFacts, &TargetFacts)]) -> Fix {
    let read = found.iter().filter(|(file, _)| {
        is_text(file)
            && body
                .target(&file.path)
                .is_some_and(|own| own.packed_in.is_none())
    });
    let fix = Fix::new(RULE.info.fix, "remove the rows");
    read.fold(fix, |fix, (file, _)| {
        fix.step(&file.path, Change::Rewrite(Rewrite::DropZeroRows))
    })
}

/// Whether it can be rewritten: what is packed stays as it is.
fn is_text(file: &FileFacts) -> bool {
    file.kind == Kind::Target
}

fn one_file(layer: &Layer, folder: &str, file: &FileFacts, facts: &TargetFacts) -> Finding {
    let message = match facts.zero.count {
        1 => "1 zero row moves nothing".to_owned(),
        count => format!("{count} zero rows move nothing"),
    };
    let finding = RULE
        .at(file, first_row(&facts.zero), message)
        .parts([&file.rel]);
    finding
        .asset(layer.display(folder))
        .evidence(facts.zero.evidence(facts.rows))
}

/// The files by how many of their rows are zero.
fn most_first<'f>(
    files: &[(&'f FileFacts, &'f TargetFacts)],
) -> Vec<(&'f FileFacts, &'f TargetFacts)> {
    let mut most = files.to_vec();
    most.sort_by_key(|(file, facts)| (std::cmp::Reverse(facts.zero.count), &file.rel));
    most
}

/// What is said of several files.
fn of_folder(folder: &str, files: &[(&FileFacts, &TargetFacts)]) -> (String, Evidence) {
    let count: u64 = files.iter().map(|(_, facts)| facts.zero.count).sum();
    let of: usize = files.iter().map(|(_, facts)| facts.rows).sum();
    let message = format!(
        "{count} zero rows in {} of `{folder}` move nothing",
        counted(files.len(), "target")
    );
    let named = files
        .iter()
        .map(|(file, facts)| format!("{} ({})", file.shown(), facts.zero.count));
    let evidence = Evidence::of_groups(named, count);
    (message, evidence.out_of(of))
}
