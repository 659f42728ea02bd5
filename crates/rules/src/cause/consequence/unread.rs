//! What becomes of files that cannot be read, as a list for `docs/coverage.md`.

use super::table::At;
use super::{Damage, Moment, table};
use mhlint_diag::{Application, Level};
use mhlint_discover::{Kind, Single};
use mhlint_formats::Format;

/// What becomes of a file that cannot be read, in one of its roles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unread {
    /// Which of the files of its kind, in words; empty for any other.
    pub role: &'static str,
    /// When the application opens it, in words.
    pub opened: &'static str,
    /// How bad it is.
    pub level: Level,
    /// What its user sees.
    pub effect: &'static str,
}

/// What becomes of files of a kind in an application, its roles in the order of its table. Empty
/// where the table has no words of its own for the kind.
pub fn unread(application: Application, kind: Kind) -> Vec<Unread> {
    let (table, mut all) = (table(application), Vec::new());
    let damage = if Format::of(kind).is_json() {
        Damage::Syntax
    } else {
        Damage::Closed
    };
    for row in table.rows.iter().filter(|row| row.kind == kind) {
        let Some(consequence) = table.consequence(row, row.opened, damage) else {
            continue;
        };
        let Some(effect) = consequence.effect else {
            continue;
        };
        let (role, opened) = (role(&row.at), words(row.opened));
        all.push(Unread {
            role,
            opened,
            level: consequence.level,
            effect,
        });
    }
    all
}

const fn words(opened: Moment) -> &'static str {
    match opened {
        Moment::Start => "at start",
        Moment::Scan => "when its library is listed",
        Moment::Use => "when it is used",
        Moment::Tools => "by tools that come with it",
        Moment::Never => "never",
    }
}

const fn role(at: &At) -> &'static str {
    match at {
        At::Anywhere => "",
        At::Generated => "written by the program itself",
        At::Replaced => "with another file that is read in its place",
        At::Scanned => "where the scan of assets reads it",
        At::Single(single) => match single {
            Single::Expressions => "of expressions",
            Single::Poses => "of poses",
            Single::BesideBase => "beside a base mesh",
            Single::ScriptedRanges => "of `hm08`",
            Single::SkinPicture => "blended by the default skin",
            Single::FirstSkin => "of the start",
            Single::FirstRig => "of the default skeleton",
            Single::CacheFolder => "a file in the place of `cache/`",
            Single::FirstScene => "of the start",
            Single::Thumbnail => "shown in a library",
            Single::OwnTarget => "of a user, in `custom/`",
            Single::LampSymbol => "the symbol of a lamp, `shaders/meshes/lampsymbol.obj`",
            Single::SkySide => "a side of a skybox",
        },
    }
}
