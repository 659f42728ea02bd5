//! `.mhm` as the importer of MPFB reads it (`docs/loaders/mpfb/models.md#the-model-file`): a
//! keyword counts at the first column alone, and what stands behind it is not split into words.

use std::ops::Range;

use crate::mhm::{CATEGORIES, Word};
use crate::number::python_float;
use mhlint_source::lines;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Columns {
    /// Sliders that it sets.
    pub modifiers: Vec<Setting>,
    /// Assets that it wears.
    pub worn: Vec<Wearing>,
    /// Lines `clothes` without a name, at which the importer stops.
    pub bare: Vec<Word>,
    /// The file of the skin; of several the last.
    pub skin: Option<Word>,
    /// The skeleton; of several the last.
    pub skeleton: Option<Word>,
    /// Lines that would be known without the blanks in front of their keywords, or its capitals:
    /// keyword and place.
    pub displaced: Vec<Word>,
    /// Whether it has a name.
    pub has_name: bool,
    /// Whether the importer knows any line.
    pub has_line: bool,
}

/// A line `modifier`: what stands before the first blank, and the number behind it.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// The slider.
    pub pattern: Word,
    /// The value, or the text that is no number.
    pub value: Result<f64, Box<str>>,
}

/// A line that puts an asset on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wearing {
    /// The category.
    pub category: &'static str,
    /// The name.
    pub name: Word,
    /// The uuid, empty if there is none.
    pub uuid: Box<str>,
}

/// Keywords of lines that put nothing on.
pub const SETTING: [&str; 4] = ["name", "modifier", "skinMaterial", "skeleton"];

/// Parts of a pattern that say nothing of a macro.
const FOLDERS: [&str; 5] = [
    "breast/",
    "macrodetails/",
    "macrodetails-height/",
    "macrodetails-universal/",
    "macrodetails-proportions/",
];

/// What models call the macro settings and the races, and what `macro.json` and saved characters
/// call them.
pub const MACROS: [(&str, &str); 11] = [
    ("Age", "age"),
    ("Gender", "gender"),
    ("Muscle", "muscle"),
    ("Weight", "weight"),
    ("Height", "height"),
    ("BodyProportions", "proportions"),
    ("Asian", "asian"),
    ("African", "african"),
    ("Caucasian", "caucasian"),
    ("BreastSize", "cupsize"),
    ("BreastFirmness", "firmness"),
];

/// A pattern without the part that says nothing of a macro.
pub fn without_folder(pattern: &str) -> &str {
    FOLDERS
        .iter()
        .find_map(|folder| pattern.strip_prefix(folder))
        .unwrap_or(pattern)
}

/// The setting or race that a pattern stands for, if it is a macro.
pub fn setting_of(pattern: &str) -> Option<&'static str> {
    let plain = without_folder(pattern);
    MACROS
        .iter()
        .find(|(name, _)| *name == plain)
        .map(|(_, setting)| *setting)
}

/// Lines of a sort that are kept. No character has as many.
const MOST: usize = 50_000;

/// Reads all lines. One that begins with a blank is another line to the importer.
pub fn read(text: &[u8]) -> Columns {
    let mut columns = Columns::default();
    for (Range { start, .. }, line) in lines(text) {
        let Ok(line) = std::str::from_utf8(line) else {
            continue;
        };
        let (keyword, rest) = line.split_once(' ').unwrap_or((line, ""));
        let at = start + (line.len() - rest.len());
        match keyword {
            "name" => columns.has_name |= !rest.trim().is_empty(),
            "modifier" => keep(&mut columns.modifiers, setting(rest, at)),
            "skinMaterial" => {
                columns.skin = Some(word(rest.trim_end(), at)).filter(|skin| !skin.text.is_empty());
            }
            "clothes" if rest.trim().is_empty() => keep(&mut columns.bare, word(keyword, start)),
            "skeleton" => {
                columns.skeleton =
                    Some(word(rest.trim_end(), at)).filter(|one| !one.text.is_empty());
            }
            other => {
                let Some(category) = CATEGORIES.into_iter().find(|category| *category == other)
                else {
                    displaced(line, start)
                        .into_iter()
                        .for_each(|one| keep(&mut columns.displaced, one));
                    continue;
                };
                columns.worn.extend(wearing(category, rest, at));
            }
        }
        columns.has_line = true;
    }
    columns
}

/// The keyword of a line that only blanks in front of it, or its capitals, keep from being known.
fn displaced(line: &str, start: usize) -> Option<Word> {
    let plain = line.trim_start();
    let keyword = plain.split_ascii_whitespace().next()?;
    let mut known = SETTING.iter().chain(&CATEGORIES);
    let is_known =
        known.any(|known| known.eq_ignore_ascii_case(keyword)) && plain.len() > keyword.len();
    is_known.then(|| word(keyword, start + line.len() - plain.len()))
}

/// The pattern ends at the first blank, so that the rest of one with a blank in it should be a
/// number.
fn setting(rest: &str, at: usize) -> Setting {
    let (pattern, value) = rest.split_once(' ').unwrap_or((rest, ""));
    let value = value.trim();
    let is_number = python_float(value.as_bytes()).ok_or_else(|| value.into());
    Setting {
        pattern: word(pattern, at),
        value: is_number,
    }
}

/// The uuid is the last word, if there is more than one.
fn wearing(category: &'static str, rest: &str, at: usize) -> Option<Wearing> {
    let rest = rest.trim_end();
    let (name, uuid) = rest.rsplit_once(' ').unwrap_or((rest, ""));
    (!name.is_empty()).then(|| Wearing {
        category,
        name: word(name.trim_end(), at),
        uuid: uuid.into(),
    })
}

fn word(text: &str, at: usize) -> Word {
    Word {
        text: text.into(),
        span: at..at + text.len(),
    }
}

fn keep<T>(all: &mut Vec<T>, one: T) {
    if all.len() < MOST {
        all.push(one);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const TEXT: &str = "version v1\r\nname well dressed\nmodifier a/b|c -0.5 \nmodifier user target 1\nmodifier a/b 1 # x\n\
        modifier a\t1\nclothes\nclothes red_cape 12-3\neyes high\n clothes indented \
        1\nskinMaterial skins/a/b.mhmat\n";

    #[test]
    fn lines_are_split_at_the_first_blank() {
        let found = read(TEXT.as_bytes());
        let values: Vec<_> = found
            .modifiers
            .iter()
            .map(|one| (&*one.pattern.text, one.value.clone()))
            .collect();
        let text = |text: &str| Err(text.into());
        let expected = [
            ("a/b|c", Ok(-0.5)),
            ("user", text("target 1")),
            ("a/b", text("1 # x")),
            ("a\t1", text("")),
        ];
        assert_eq!(values, expected);
        assert!(found.has_name && found.has_line && found.bare.len() == 1);
        let worn: Vec<_> = found
            .worn
            .iter()
            .map(|one| (one.category, &*one.name.text, &*one.uuid))
            .collect();
        assert_eq!(
            worn,
            [("clothes", "red_cape", "12-3"), ("eyes", "high", "")]
        );
        let displaced: Vec<_> = found.displaced.iter().map(|one| &*one.text).collect();
        assert_eq!(displaced, ["clothes"]);
        assert_eq!(
            found.skin.as_ref().map(|skin| &*skin.text),
            Some("skins/a/b.mhmat")
        );
        let words = found
            .modifiers
            .iter()
            .map(|one| &one.pattern)
            .chain(&found.skin);
        assert!(
            words
                .clone()
                .all(|word| TEXT.get(word.span.clone()) == Some(&*word.text))
        );
    }

    #[test]
    fn other_files_have_no_line() {
        assert!(!read(b"<html>\nversion 1\n modifier a 1\nName x\n").has_line);
    }

    proptest! {
        #[test]
        fn no_bytes_stop_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            read(&[b"modifier ".as_slice(), &bytes, b"\nclothes ", &bytes].concat());
        }
    }
}
