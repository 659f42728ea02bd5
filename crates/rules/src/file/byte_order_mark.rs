//! A byte order mark becomes part of the first word.

use super::super::cause::archived::weigh;
use super::super::cause::consequence::{Damage, consequence};
use super::super::cause::{is_override, is_unmet};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Change, Finding, Fix, FixKind, Level, Place, Rewrite, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[
        (Makehuman2, "rejects the file, or loses its first line"),
        (Makehuman1, "rejects the file, or loses its first line"),
        (Mpfb, "rejects the file, or loses its first line"),
    ],
    docs: include_str!("byte_order_mark.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-byte-order-mark",
        Level::Error,
        "a byte order mark at the beginning of a text file",
    )
});

/// Fields of a line that a target's reader takes for data.
const ROW_FIELDS: usize = 4;

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let encoding = &file.encoding;
    // Behind a mark alone there is nothing to lose: the file is empty.
    let is_marked =
        encoding.byte_order_mark && encoding.invalid_utf8_at.is_none() && !encoding.blank;
    if !is_marked || !Format::of(file.kind).is_text() || is_override(file) || is_unmet(view, file) {
        return;
    }
    let damage = damage(view, file);
    let Some(loss) = consequence(view, &file.rel, damage) else {
        return;
    };
    let message = format!("`{}` begins with a byte order mark", file.file_name());
    let fix = Fix::new(RULE.info.fix, "remove the byte order mark");
    let finding = RULE
        .at(file, Place::Span(0..3), message)
        .fix(fix.step(&file.path, Change::Rewrite(Rewrite::DropByteOrderMark)))
        .help("save the file as UTF-8 without a byte order mark");
    let finding = loss.of(view, finding).case(first_keyword(file));
    out.push(if damage == Damage::MarkedRow {
        weigh(&view.target(file), finding)
    } else {
        finding
    });
}

const NO_NAME: Case = &[(
    Makehuman2,
    Level::Error,
    "does not recognise `name`: lists the asset without a name, and models lose it",
)];
const NO_UUID: Case = &[
    (
        Makehuman2,
        Level::Error,
        "does not recognise `uuid`: crashes with `IndexError` when a model saved with the asset \
            is loaded",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not recognise `uuid`: saved models do not find the asset",
    ),
];
const NO_MESH: Case = &[
    (
        Makehuman2,
        Level::Error,
        "does not recognise `obj_file`: crashes with `AttributeError` when the asset is put on",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not recognise `obj_file`: does not put the asset on",
    ),
];
const NO_ROWS: Case = &[
    (
        Makehuman2,
        Level::Error,
        "does not recognise `verts`: crashes with `IndexError` when the asset is put on",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not recognise `verts`: does not put the asset on",
    ),
];

/// What becomes of an asset without its first line, where that is more than to ignore it.
fn first_keyword(file: &FileFacts) -> Case {
    let is_asset = file.kind == Kind::Clothes;
    match file
        .encoding
        .marked_words
        .first()
        .map(AsRef::as_ref)
        .filter(|_| is_asset)
    {
        Some("name") => NO_NAME,
        Some("uuid") => NO_UUID,
        Some("obj_file") => NO_MESH,
        Some("verts") => NO_ROWS,
        _ => &[],
    }
}

fn damage(view: &View<'_>, file: &FileFacts) -> Damage {
    let words = &file.encoding.marked_words;
    match file.kind {
        kind if Format::of(kind).is_json() => Damage::Refused,
        Kind::Target if words.len() == ROW_FIELDS => Damage::MarkedRow,
        _ if words.first().is_none_or(|word| word.starts_with('#')) => Damage::MarkedComment,
        // Nobody reads these lines.
        Kind::Model if view.is_mpfb() && words.first().is_some_and(|word| word == "version") => {
            Damage::MarkedComment
        }
        Kind::Material if words.first().is_some_and(|word| word == "//") => Damage::MarkedComment,
        Kind::BaseMesh | Kind::AssetMesh if !words.first().is_some_and(|word| is_of_mesh(word)) => {
            Damage::MarkedComment
        }
        _ => Damage::MarkedWord,
    }
}

/// Lines of a mesh that are more than a name or a note.
fn is_of_mesh(word: &str) -> bool {
    matches!(word, "v" | "vt" | "f" | "g")
}
