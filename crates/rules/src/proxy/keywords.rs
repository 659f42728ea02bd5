//! The keywords of assets, and which one a misspelt one is meant to be.

use mhlint_diag::{Application, begins_word, glued, is_like_path, nearest};
pub(super) use mhlint_formats::mhclo::makehuman1::knows as known_to_makehuman1;
use mhlint_formats::mhclo::makehuman2::KEYWORDS as READ;
use mhlint_formats::mhclo::{Entry, Section, makehuman1};
use mhlint_formats::python_float;

/// What MakeHuman 1 keeps and never looks at, and what only MPFB reads.
const OTHERS: [&str; 2] = ["basemesh", "texture"];

/// Other words for the same.
const ALIASES: [(&str, &str); 5] = [
    ("tags", "tag"),
    ("licence", "license"),
    ("vertexboneweights", "vertexboneweights_file"),
    ("mesh", "obj_file"),
    ("obj", "obj_file"),
];

/// Whether a line has one of the keywords that MakeHuman 1 cannot take, outside of comments.
pub(super) fn is_licence(entry: &Entry) -> bool {
    let is_one = matches!(
        (&*entry.keyword, entry.has_colon),
        ("author" | "license", _) | ("homepage", false)
    );
    is_one && !entry.is_comment
}

/// Keywords that nothing but a text to read depends on.
pub(super) fn is_harmless(keyword: &str) -> bool {
    matches!(
        keyword,
        "description" | "author" | "license" | "homepage" | "version"
    )
}

/// Whether a line has a keyword, however it is spelt.
pub(super) fn is_known(entry: &Entry) -> bool {
    let written = entry.keyword.trim_start_matches('\u{feff}');
    !entry.is_comment && (READ.contains(&written) || is_other(written) || meant(entry).is_some())
}

/// The keyword of an application that a line of an unknown one is meant to have.
pub(super) fn meant_in(application: Application, entry: &Entry) -> Option<&'static str> {
    let own: &[&str] = if application == Application::Makehuman1 {
        &makehuman1::KEYWORDS
    } else {
        &[]
    };
    let is_bare = |entry: &Entry| application != Application::Makehuman1 || !entry.has_colon;
    if READ.contains(&&*entry.keyword) && !is_bare(entry) && !entry.is_comment {
        return READ.into_iter().find(|known| **known == *entry.keyword);
    }
    meant(entry).or_else(|| {
        let is_unknown =
            !entry.is_comment && !READ.contains(&&*entry.keyword) && !is_other(&entry.keyword);
        let near = nearest(&entry.keyword, others()).filter(|_| is_unknown)?;
        own.iter().copied().find(|known| *known == near)
    })
}

/// The keyword that a line of an unknown one is meant to have.
pub(super) fn meant(entry: &Entry) -> Option<&'static str> {
    let written = &*entry.keyword;
    if entry.is_comment || entry.section == Section::Deleted && entry.value.is_empty() {
        return None;
    }
    if READ.contains(&written) || is_other(written) {
        return None;
    }
    // With a byte order mark, which has a finding of its own.
    if written.starts_with('\u{feff}') {
        return None;
    }
    if !written.starts_with(char::is_alphabetic) {
        return None;
    }
    let folded = folded(written);
    let same = READ.into_iter().find(|known| self::folded(known) == folded);
    let alias = || {
        ALIASES
            .iter()
            .find(|(other, _)| *other == folded)
            .map(|(_, known)| *known)
    };
    let near = || {
        // One that is nearer to a keyword of another application is meant as that.
        let near = nearest(written, READ.into_iter().chain(others()))?;
        READ.into_iter().find(|known| *known == near)
    };
    let unparted = || unparted(written).map(|(keyword, _)| keyword);
    same.or_else(alias).or_else(unparted).or_else(near)
}

/// A keyword, and the value that is written against it.
fn unparted(word: &str) -> Option<(&'static str, &str)> {
    glued(word, READ, |keyword, value| match keyword {
        "obj_file" | "material" | "vertexboneweights_file" => is_like_path(value),
        "uuid" => {
            value.len() >= SHORTEST_UUID
                && value
                    .bytes()
                    .all(|byte| byte.is_ascii_hexdigit() || byte == b'-')
        }
        "verts" | "delete_verts" => value.bytes().all(|byte| byte.is_ascii_digit()),
        "version" | "z_depth" | "x_scale" | "y_scale" | "z_scale" => {
            python_float(value.as_bytes()).is_some()
        }
        "weights" => false,
        _ => begins_word(value),
    })
}

/// Letters from which on a text may be a uuid.
const SHORTEST_UUID: usize = 8;

/// The right keyword for a line, with what was written against the wrong one.
pub(super) fn corrected(entry: &Entry, meant: &str) -> String {
    match unparted(&entry.keyword).filter(|(keyword, _)| *keyword == meant) {
        Some((_, value)) if entry.value.is_empty() => format!("{meant} {value}"),
        Some((_, value)) => format!("{meant} {value} {}", entry.value),
        None => meant.to_owned(),
    }
}

/// Keywords that MakeHuman 2 has no use for.
fn others() -> impl Iterator<Item = &'static str> {
    makehuman1::KEYWORDS
        .into_iter()
        .chain(makehuman1::OLD)
        .chain(OTHERS)
}

fn is_other(word: &str) -> bool {
    others().any(|known| known == word)
}

/// Without capitals, lines and dashes.
fn folded(word: &str) -> String {
    word.chars()
        .filter(|letter| letter.is_alphanumeric())
        .flat_map(char::to_lowercase)
        .collect()
}
