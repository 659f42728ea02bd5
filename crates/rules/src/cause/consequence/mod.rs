//! What happens when an application cannot read a file: one table for each application, with a row
//! for each role that a file can have.
//!
//! The rules `file-*`, `json-*` and `overlay-*` ask here how severe a damage is and what the user
//! sees of it.

mod makehuman1;
mod makehuman1_values;
mod makehuman2;
mod makehuman2_keys;
mod makehuman2_values;
mod mpfb;
mod reach;
mod table;
mod unread;
mod values;

pub(crate) use makehuman1::{NO_FRAME, STOPS_AT_START};
pub(crate) use makehuman2::{
    ARCHIVED, NEVER_OPENED, NO_LAMP, NO_POSE_SKELETON, NOT_SCANNED, UNREAD_MESH, ignored_override,
    is_opened_by_scripts,
};
use table::{Row, Spot, Standing, Table};
pub use unread::Unread;
pub use unread::unread;

use mhlint_diag::{
    Application::{self, Makehuman1, Makehuman2, Mpfb},
    Finding, Level,
};
use mhlint_discover::Kind;
use mhlint_formats::target::name::TargetName;
use mhlint_json::{SchemaFault, UnknownKey};
use mhlint_repo::makehuman1::Unused;
use mhlint_repo::{FileFacts, ReferenceKind, Target, View};
pub(crate) use mpfb::{BY_HAND, MACRO_ROWS, NO_MESH_NAMED, NO_PART};

/// When an application opens a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Moment {
    /// When it starts, or loads a base mesh.
    Start,
    /// When it scans its assets, which it also does at start: one bad file takes all assets along.
    Scan,
    /// When somebody uses the asset.
    Use,
    /// The application never opens it, but tools that come with the application do.
    Tools,
    /// Neither the application nor its tools ever open it.
    Never,
}

/// What is wrong with a file as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Damage {
    /// There is no file of this name; where the file system tells capitals apart, a file in other
    /// capitals does not count.
    Absent,
    /// It cannot be opened.
    Closed,
    /// It is a symbolic link to a path that does not exist, and no other file names it.
    Dangling,
    /// A Git LFS pointer lies in place of the content.
    Pointer,
    /// The file is empty.
    Empty,
    /// The file is empty, and nothing would be missed without it.
    Needless,
    /// A JSON that the parser rejects before it looks at any syntax: the file is empty, or begins
    /// with a byte order mark.
    Refused,
    /// A byte order mark before a line of numbers.
    MarkedRow,
    /// A byte order mark before a word, such as a keyword.
    MarkedWord,
    /// A byte order mark before a comment.
    MarkedComment,
    /// It is not UTF-8.
    NotUtf8,
    /// It is not valid JSON.
    Syntax,
    /// It contains `NaN` or an infinity, which JSON does not have.
    Special,
    /// Its JSON is nested deeper than any parser allows.
    TooDeep,
    /// It cannot be unpacked.
    Packed,
}

/// How severe a damage is, and what the user sees of it; no effect is given where the general text
/// of the rule is right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Consequence {
    pub(crate) level: Level,
    pub(crate) effect: Option<&'static str>,
}

impl Consequence {
    const fn new(level: Level, effect: &'static str) -> Self {
        Self {
            level,
            effect: Some(effect),
        }
    }

    /// The finding, with this level and effect set for the application of the view.
    pub(crate) fn of(self, view: &View<'_>, finding: Finding) -> Finding {
        let finding = finding.level_in(view.application(), self.level);
        if let Some(effect) = self.effect {
            finding.effect_in(view.application(), effect)
        } else {
            finding
        }
    }
}

/// The table of an application.
const fn table(application: Application) -> &'static Table {
    match application {
        Makehuman2 => &makehuman2::TABLE,
        Mpfb => &mpfb::TABLE,
        Makehuman1 => &makehuman1::TABLE,
    }
}

/// The table of the application of a view, the row in it for a path, and when the application opens
/// the file at that path.
fn asked(view: &View<'_>, rel: &str) -> (&'static Table, &'static Row, Moment) {
    let table = table(view.application());
    let standing = match view.is_generated(rel) {
        true => Standing::Generated,
        false if view.is_replaced(rel) => Standing::Replaced,
        false => Standing::Usual,
    };
    let spot = Spot {
        layout: view.layout(),
        rel,
        standing,
    };
    let row = table.row(view.kind_at(rel), spot);
    (table, row, row.moment(spot))
}

/// When the application opens the file at this path.
pub(crate) fn moment(view: &View<'_>, rel: &str) -> Moment {
    asked(view, rel).2
}

/// What happens if the file at a path has this damage; `None` if nothing happens, or if nobody
/// needs what is lost.
pub(crate) fn consequence(view: &View<'_>, rel: &str, damage: Damage) -> Option<Consequence> {
    let is_of_macros = |file: &FileFacts| view.composes_name_of(file);
    let of_macros = view
        .layers()
        .checked
        .file(rel)
        .filter(|file| is_of_macros(file));
    if let Some(own) = of_macros.and_then(|_| mpfb::of_macro_target(damage)) {
        return Some(own);
    }
    // An empty macro target is on purpose: it is the shape that changes nothing. If it is not known
    // what uses a target, it may be a macro target; one that nothing uses is taken for a macro
    // target by its name.
    let is_identity = |file: &FileFacts| match view.target(file) {
        Target {
            used_as: None,
            is_unused,
            ..
        } => !is_unused || TargetName::of(&file.rel).is_ok_and(|name| name.is_macro()),
        target => target.used_as == Some(ReferenceKind::MacroTarget),
    };
    let is_empty_target =
        damage == Damage::Empty && view.is_makehuman1() && view.kind_at(rel) == Kind::Target;
    if is_empty_target && view.layers().checked.file(rel).is_some_and(is_identity) {
        return None;
    }
    let marked = (damage == Damage::MarkedWord).then(|| of_marked_word(view, rel));
    if let Some(own) = marked.flatten() {
        return Some(own);
    }
    if is_list_without_archive(view, rel) {
        return None;
    }
    let (table, row, moment) = asked(view, rel);
    table.consequence(row, moment, damage)
}

/// Whether the file at this path is the list of pictures of MakeHuman 1, and the archive that goes
/// with it is missing or cannot be opened: the program reads the list only with the archive.
fn is_list_without_archive(view: &View<'_>, rel: &str) -> bool {
    let Some(own) = view
        .as_makehuman1()
        .filter(|_| view.kind_at(rel) == Kind::PictureList)
    else {
        return false;
    };
    own.targets
        .archive
        .as_ref()
        .is_none_or(|archive| archive.unused == Some(Unused::Closed))
}

/// What becomes of a file in which a byte order mark makes the first word unreadable, where all
/// depends on that word: the version of a model, the mesh of an asset.
fn of_marked_word(view: &View<'_>, rel: &str) -> Option<Consequence> {
    let word = view
        .layers()
        .checked
        .file(rel)?
        .encoding
        .marked_words
        .first()?;
    match (view.application(), view.kind_at(rel), &**word) {
        (Makehuman1, Kind::Model, "version") => {
            Some(Consequence::new(Level::Error, makehuman1::RESET))
        }
        (Mpfb, Kind::Clothes, "obj_file") => Some(Consequence::new(Level::Error, NO_MESH_NAMED)),
        _ => None,
    }
}

/// What the application does if a name in a file leads to no file; `None` if the application has no
/// names of this kind.
pub(crate) fn unfound(view: &View<'_>, kind: ReferenceKind) -> Option<Consequence> {
    let names = table(view.application()).unfound;
    names
        .iter()
        .find(|(kinds, _)| kinds.contains(&kind))
        .map(|(_, consequence)| *consequence)
}

/// What happens if a value does not fit the schema; `None` where the general text of `json-schema`
/// is right.
pub(crate) fn of_value(
    view: &View<'_>,
    file: &FileFacts,
    fault: &SchemaFault,
) -> Option<Consequence> {
    match view {
        View::Makehuman2(view) => makehuman2_values::of_value(view, file, fault),
        View::Mpfb(_) => mpfb::of_value(file, fault),
        View::Makehuman1(_) => makehuman1_values::of_value(view.layout(), file, fault),
    }
}

/// Whether this application accepts a value that does not fit the schema, because the schema is
/// written for other applications or versions as well.
pub(crate) fn is_accepted(view: &View<'_>, file: &FileFacts, fault: &SchemaFault) -> bool {
    // `suffix` came with the version of 2026-08-05, the other required keys with that of 2025:
    // older programs do without them.
    let is_later = file.kind == Kind::Version
        && (fault.missing() == Some("suffix") && view.is_before("2026-08-05")
            || fault.missing().is_some() && view.is_before("2025"));
    is_later || view.is_makehuman1() && makehuman1_values::is_accepted(file, fault)
}

/// What happens if a file contains `NaN` or infinities, which JSON does not have.
pub(crate) fn of_special(view: &View<'_>, file: &FileFacts) -> Option<Consequence> {
    let own = if let View::Makehuman2(_) = view {
        makehuman2_values::of_special(file)
    } else {
        None
    };
    own.or_else(|| consequence(view, &file.rel, Damage::Special))
}

/// What happens because a key is misspelt, so that its value is not read; `None` if the key is like
/// no known key.
pub(crate) fn of_misspelt(
    view: &View<'_>,
    file: &FileFacts,
    unknown: &UnknownKey,
) -> Option<Consequence> {
    match view {
        View::Makehuman2(view) => makehuman2_keys::of_misspelt(view, file, unknown),
        View::Makehuman1(_) | View::Mpfb(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::table::At;
    use super::*;
    use mhlint_discover::Layout;
    use mhlint_formats::FORMATS;

    /// A path that no loader treats specially.
    fn spot(application: Application) -> Spot<'static> {
        Spot {
            layout: Layout::of(application),
            rel: "x",
            standing: Standing::Usual,
        }
    }

    #[test]
    fn every_kind_that_is_read_has_a_consequence_in_every_application() {
        for (format, application) in FORMATS
            .iter()
            .flat_map(|format| Application::ALL.map(|one| (format, one)))
        {
            let table = table(application);
            let spot = spot(application);
            let row = table.row(format.kind, spot);
            let lost = if format.is_json() {
                Damage::Syntax
            } else {
                Damage::Packed
            };
            for damage in [Damage::Closed, Damage::Pointer, Damage::NotUtf8, lost] {
                let found = table.consequence(row, row.moment(spot), damage);
                // MakeHuman 2 never opens a packed target.
                let is_never = (application, format.kind, damage)
                    == (Makehuman2, Kind::PackedTarget, Damage::Pointer);
                // It is not known what a shader compiler does with bytes that are not UTF-8.
                let is_open = (application, format.kind, damage)
                    == (Makehuman1, Kind::ShaderSource, Damage::NotUtf8);
                assert!(
                    found.is_some() || is_never || is_open,
                    "{application:?} {:?} {damage:?}",
                    format.kind
                );
            }
        }
    }

    #[test]
    fn a_cell_can_say_that_nothing_happens() {
        let own = table::anywhere(Kind::Json, Moment::Use, NOT_MINDED);
        let unknown = &table::UNKNOWN;
        assert_eq!(unknown.consequence(&own, Moment::Use, Damage::Syntax), None);
        assert!(
            unknown
                .consequence(&own, Moment::Use, Damage::NotUtf8)
                .is_some()
        );
        let special = |kind| {
            makehuman2::TABLE.consequence(
                makehuman2::TABLE.row(kind, spot(Makehuman2)),
                Moment::Use,
                Damage::Special,
            )
        };
        assert!(special(Kind::AssetWeights).is_none() && special(Kind::Skeleton).is_some());
    }

    const NOT_MINDED: &[table::Cell] = &[table::nothing(Damage::Syntax)];

    #[test]
    fn no_row_stands_behind_the_one_for_all_files_of_its_kind() {
        for table in Application::ALL.map(table) {
            let mut whole = Vec::new();
            for row in table.rows {
                assert!(!whole.contains(&row.kind), "{:?}", row.kind);
                whole.extend(matches!(row.at, At::Anywhere).then_some(row.kind));
            }
        }
    }
}
