//! What Blender knows sliders by, and the targets of users that become sliders
//! (`docs/loaders/mpfb/sliders.md#length-and-character-limits`,
//! `docs/loaders/mpfb/sliders.md#names-of-user-targets`).

use super::view::View;
use crate::FileFacts;
use mhlint_formats::target_catalog::{Category, Section};

/// A name of a property is no longer than this, in letters.
pub const LONGEST: usize = 63;
/// The name of a section becomes part of the name of a class, with something in front.
pub const LONGEST_SECTION: usize = 39;
/// The same of one of the catalogue with sliders in it.
pub const LONGEST_SECTION_WITH_SLIDERS: usize = 36;

/// The pairs of words that the two ends of a slider are called by, as `.mhm` files have them
/// (`docs/loaders/mpfb/sliders.md#shipped-catalogue`).
const PAIRS: [(&str, &str); 8] = [
    ("decr", "incr"),
    ("down", "up"),
    ("in", "out"),
    ("backward", "forward"),
    ("concave", "convex"),
    ("square", "round"),
    ("pointed", "triangle"),
    ("compress", "uncompress"),
];

/// A target of a user, which is a slider of its own.
#[derive(Debug, Clone)]
pub struct UserTarget<'a> {
    /// Where it is.
    pub file: &'a FileFacts,
    /// The section that shows it.
    pub section: String,
    /// What the slider, and the shape key, is called.
    pub name: String,
}

/// Where users' targets of one section lie, in every data root.
const CUSTOM: &str = "custom";

/// What Blender calls a slider.
pub fn identifier(section: &str, name: &str) -> String {
    let plain = |letter: char| {
        if letter.is_ascii_alphanumeric() || letter == '_' {
            letter
        } else {
            '_'
        }
    };
    format!("{section}_{name}").chars().map(plain).collect()
}

/// The same for the sliders of a category: one, or one for each side.
pub fn identifiers(section: &Section, category: &Category) -> Vec<String> {
    category
        .sides()
        .iter()
        .map(|side| identifier(&section.name, &format!("{side}{}", category.name)))
        .collect()
}

/// What stands before the words of the two ends in a name, and these, with a sign between them;
/// `None` for a name that ends in no pair.
pub fn ends(name: &str, between: char) -> Option<(&str, &'static str, &'static str)> {
    PAIRS.into_iter().find_map(|(negative, positive)| {
        let stem = name
            .strip_suffix(positive)?
            .strip_suffix(between)?
            .strip_suffix(negative)?;
        Some((stem, negative, positive))
    })
}

/// The same of the name of a slider, without the sign in front of the words.
pub fn pair(name: &str) -> Option<(&str, &'static str, &'static str)> {
    let (stem, negative, positive) = ends(name, '-')?;
    let stem = stem.strip_suffix('-').filter(|stem| !stem.is_empty())?;
    Some((stem, negative, positive))
}

/// Whether a path is that of a target of a user in any data root.
pub fn is_custom(rel: &str) -> bool {
    rel.starts_with("custom/") || rel.starts_with("targets/custom/")
}

impl<'a> UserTarget<'a> {
    /// What a file is as a slider; `None` for one that is none.
    fn of(file: &'a FileFacts) -> Option<Self> {
        let parts: Vec<&str> = file.rel.split('/').collect();
        let (name, folders) = parts.split_last()?;
        let is_plain = name.ends_with(".target");
        let is_custom = is_custom(&file.rel);
        if !(is_plain || is_custom && name.ends_with(".target.gz")) {
            return None;
        }
        let section = match folders {
            _ if is_custom => CUSTOM,
            ["targets"] => "targets",
            ["targets", .., parent] => parent,
            _ => return None,
        };
        Some(Self {
            file,
            section: section.to_owned(),
            name: name.replace(".target", ""),
        })
    }

    /// What Blender calls the slider.
    pub fn identifier(&self) -> String {
        identifier(&self.section, &self.name)
    }
}

impl<'a> View<'a> {
    /// The targets of the checked layer that become sliders without the catalogue. In MPFB's own
    /// data nobody puts any.
    pub fn user_targets(&self) -> impl Iterator<Item = UserTarget<'a>> + use<'a> {
        let is_system = self.layers.checks_system();
        let files = self
            .layers
            .checked
            .files
            .values()
            .filter(move |file| !is_system || is_custom(&file.rel));
        files.filter_map(UserTarget::of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slider_is_known_by_section_and_name() {
        assert_eq!(
            identifier("nose", "nose-hump-decr-incr"),
            "nose_nose_hump_decr_incr"
        );
        assert_eq!(identifier("custom", "ü"), "custom__");
        assert_eq!(
            pair("nose-hump-decr-incr"),
            Some(("nose-hump", "decr", "incr"))
        );
        assert_eq!(pair("x-concave-convex"), Some(("x", "concave", "convex")));
        assert_eq!(
            (pair("chin-triangle"), pair("decr-incr"), pair("in-outer")),
            (None, None, None)
        );
    }
}
