//! Files without anything in them where content is needed.

use super::super::cause::consequence::{Damage, consequence};
use super::super::cause::schema::is_of_wrong_type;
use super::super::cause::{self, is_override, is_unmet};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_formats::target::TargetFacts;
use mhlint_repo::{FileFacts, Reference, ReferenceKind, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "loads nothing from it, or crashes"),
        (Makehuman1, "loads nothing from it"),
        (Mpfb, "loads nothing from it"),
    ],
    docs: include_str!("empty.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-empty",
        Level::Warning,
        "an empty file that needs content",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_of_program =
        view.layers().checks_system() && view.references().to_file(file).next().is_none();
    let Some(what) = emptiness(file, is_of_program).or_else(|| counts_as_missing(view, file))
    else {
        return;
    };
    if is_override(file) || is_target_of_macros(view, file) || is_unmet(view, file) {
        return;
    }
    let damage = match file.kind {
        _ if view.does_without(file) => Damage::Needless,
        kind if Format::of(kind).is_json() => Damage::Refused,
        _ => Damage::Empty,
    };
    let Some(loss) = consequence(view, &file.rel, damage) else {
        return;
    };
    let message = format!("`{}` is empty{what}", file.file_name());
    let help = match file.kind {
        Kind::TargetArchive => "delete it; MakeHuman 2 rebuilds it from the targets",
        Kind::BaseJson | Kind::BaseMesh => "restore the content",
        Kind::MeshArchive => "delete the archive, or rebuild it with compile_meshes.py",
        Kind::Packed | Kind::PackedBaseMesh
            if view.layers().checked.text_of_archive(&file.rel).is_some() =>
        {
            "delete the archive: it is built again from the text beside it"
        }
        Kind::Packed => "get the asset again from its source",
        kind if Format::of(kind).is_json() => {
            "restore the content from a backup or the original download"
        }
        _ => "restore the content; if the file is not needed, remove it with all references to it",
    };
    out.push(
        loss.of(view, RULE.at(file, Place::File, message))
            .help(help),
    );
}

/// An empty value counts as no file, too. In a generated modelling.json it is usual.
fn counts_as_missing(view: &View<'_>, file: &FileFacts) -> Option<&'static str> {
    let usual = file.kind == Kind::ModellingJson && view.is_generated(&file.rel);
    let what = if is_of_wrong_type(file) {
        " (`null`, `0`, `false` and empty values count as a missing file)"
    } else {
        " (`{}` counts as a missing file)"
    };
    (cause::counts_as_missing(file) && !usual).then_some(what)
}

/// `macro-empty-target` knows these better. Where names are composed an empty one is deliberate:
/// each has to be there.
fn is_target_of_macros(view: &View<'_>, file: &FileFacts) -> bool {
    let is_macro = |reference: &Reference<'_>| reference.kind == ReferenceKind::MacroTarget;
    view.composes_name_of(file)
        || is_neutral(file)
        || view
            .references()
            .to_file(file)
            .any(|reference| is_macro(reference) && reference.found().is_some())
}

/// Whether it is the shape of the middle of every macro setting by its name, and has comments: it
/// moves nothing on purpose, wherever it lies.
fn is_neutral(file: &FileFacts) -> bool {
    let name = file.file_name();
    let Some(stem) = [".target", ".target.gz"]
        .into_iter()
        .find_map(|suffix| name.strip_suffix(suffix))
    else {
        return false;
    };
    let is_average = |word: &&str| AVERAGES.contains(word);
    file.size > 0
        && stem.split('-').filter(is_average).count() > 1
        && stem
            .split('-')
            .all(|word| AVERAGES.contains(&word) || WHOLE.contains(&word))
}

/// Words of the names of macro targets that stand for the middle of a setting.
const AVERAGES: [&str; 5] = [
    "averagemuscle",
    "averageweight",
    "averageheight",
    "averagecup",
    "averagefirmness",
];
/// Those that stand for whom a target is.
const WHOLE: [&str; 10] = [
    "universal",
    "male",
    "female",
    "baby",
    "child",
    "young",
    "old",
    "african",
    "asian",
    "caucasian",
];

/// Whether a packed target can be unpacked and has only comments, or nothing.
fn has_no_line(file: &FileFacts) -> bool {
    let is_empty = |target: &TargetFacts| target.rows == 0 && target.field_count.count == 0;
    file.gzip_fault.is_none() && !file.failed && file.target().is_some_and(is_empty)
}

/// `is_of_program`: a target that the program brings and no slider has. Those of its macro settings
/// may have no row.
fn emptiness(file: &FileFacts, is_of_program: bool) -> Option<&'static str> {
    let encoding = &file.encoding;
    match file.kind {
        _ if file.size == 0 => Some(" (0 bytes)"),
        Kind::PackedTarget if has_no_line(file) && !is_of_program => {
            Some(" (unpacked, it has no row)")
        }
        kind if !Format::of(kind).is_text() => None,
        _ if encoding.blank && encoding.byte_order_mark => Some(" (only a byte order mark)"),
        _ if encoding.blank => Some(" (only whitespace)"),
        // A comment is no JSON: that is a matter of syntax.
        kind if !Format::of(kind).is_json() && encoding.only_comments => Some(" (only comments)"),
        _ => None,
    }
}
