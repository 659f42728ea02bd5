//! Assets in a format of an older version: each folder is one finding, whatever else follows from
//! it.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;

use super::super::cause::outdated::outdated;
use super::super::{Check, Rule, RuleCx, counted, either};
use super::old_words::{Sort, words};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo, Version, grouped,
};
use mhlint_discover::extension;
use mhlint_formats::outdated::Outdated;
use mhlint_repo::{FileFacts, Layer, View};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "uses nothing of this format"),
        (Makehuman1, "uses nothing of this format"),
        (Mpfb, "uses nothing of this format"),
    ],
    docs: include_str!("old_format.md").trim_ascii_end(),
    counts: "files",
    of_pieces: true,
    ..RuleInfo::new(
        "library-old-format",
        Level::Error,
        "assets in a format of an older version",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    // The program of that time reads what it wrote.
    let reads_old = view.is_makehuman1() && view.version().is_some_and(is_1_0);
    let old = layer.files.values().filter_map(|file| {
        let found = outdated(view, file)
            .filter(|found| !(reads_old && found.versions().contains(&"1.0")))?;
        let (top, _) = file.rel.split_once('/').unwrap_or_default();
        // Where loose files belong is only supposed.
        let top = if file.is_loose { file.folder() } else { top };
        Some(((top, Sort::of(found, file)), (file, found)))
    });
    let old = grouped(old);
    let all = if old.is_empty() {
        Shown::default()
    } else {
        shown(layer)
    };
    for ((top, sort), files) in old {
        out.extend(finding(layer, &all, top, sort, &files));
    }
}

fn is_1_0(version: Version) -> bool {
    version.is_before("1.1") && !version.is_before("1.0")
}

fn finding(
    layer: &Layer,
    shown: &Shown<'_>,
    top: &str,
    sort: Sort,
    files: &[(&FileFacts, Outdated)],
) -> Option<Finding> {
    let (first, _) = files.first()?;
    let mut versions: Vec<&str> = files
        .iter()
        .flat_map(|(_, found)| found.versions())
        .copied()
        .collect();
    // `1.0` comes last.
    versions.sort_by_key(|version| (version.starts_with('1'), *version));
    versions.dedup();
    let versions = either(&versions);
    let words = words(sort, files);
    let message = match files.len() {
        1 => format!("`{}` {} of {versions}", first.file_name(), words.one),
        count => {
            let folder = common_folder(files);
            let all = alike(shown, first, folder);
            let of_all = if all > count {
                format!("{count} of {}", counted(all, words.noun))
            } else {
                counted(count, words.noun)
            };
            let place = if folder.is_empty() {
                String::new()
            } else {
                format!(" in `{folder}`")
            };
            format!("{of_all}{place} {} of {versions}", words.several)
        }
    };
    let asset = if first.is_loose {
        top.to_owned()
    } else {
        layer.display(top)
    };
    let place = first
        .target()
        .and_then(|facts| Some(Place::Line(facts.basemesh.as_ref()?.0)))
        .unwrap_or(Place::File);
    let finding = RULE
        .at(first, place, message)
        .key(sort.key())
        .case(words.case)
        .help(words.help);
    let finding = if files.len() > 1 || !first.is_loose {
        finding.asset(asset)
    } else {
        finding
    };
    let finding = finding.parts_in(files.iter().map(|(file, _)| (file.shown(), &file.path)));
    Some(finding.evidence(Evidence::of_cases(
        files.iter().map(|(file, _)| file.shown()),
    )))
}

/// The folder that all of them lie in or below.
fn common_folder<'f>(files: &[(&'f FileFacts, Outdated)]) -> &'f str {
    let mut folders = files.iter().map(|(file, _)| parent(file.shown()));
    let first = folders.next().unwrap_or_default();
    folders.fold(first, |common, folder| {
        let mut common = common;
        while !common.is_empty() && folder != common && !folder.starts_with(&format!("{common}/")) {
            common = parent(common);
        }
        common
    })
}

/// The printed paths of files by their suffix, in order.
type Shown<'l> = BTreeMap<&'l str, BTreeSet<&'l str>>;

fn shown(layer: &Layer) -> Shown<'_> {
    let mut shown = Shown::new();
    for file in layer.files.values() {
        let alike = shown.entry(extension(&file.rel)).or_default();
        alike.insert(file.shown());
    }
    shown
}

/// How many files of the same suffix lie there.
fn alike(shown: &Shown<'_>, first: &FileFacts, folder: &str) -> usize {
    let Some(alike) = shown.get(extension(&first.rel)) else {
        return 0;
    };
    if folder.is_empty() {
        return alike.len();
    }
    let within = format!("{folder}/");
    let from = alike.range::<str, _>((Bound::Included(within.as_str()), Bound::Unbounded));
    from.take_while(|path| path.starts_with(&within)).count()
}
