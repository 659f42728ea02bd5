//! `.mhm`: a saved character as MakeHuman 2 reads it
//! (`docs/loaders/makehuman2/models.md#keywords`).
//!
//! A line is a keyword and words, split at white space. A keyword that is not known is passed over,
//! so the lines that could be meant for something are kept.

pub mod columns;
pub mod lines;
mod outdated;

use std::ops::Range;

use crate::fields::fields;
use crate::mhm::columns::Columns;
use crate::mhm::lines::Lines;
use crate::number::python_float;
use crate::outdated::Outdated;
use mhlint_source::lines;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Model {
    /// Its name: the rest of the line. The list reads the lines above the first modifier.
    pub name: Option<Box<str>>,
    /// Its tags, from above the first modifier as well.
    pub tags: Vec<Box<str>>,
    /// Where the keyword of the tags stands, in bytes.
    pub tags_at: Range<usize>,
    /// Sliders that it sets.
    pub modifiers: Vec<Modifier>,
    /// Assets that it wears.
    pub worn: Vec<WornLine>,
    /// Materials of these.
    pub materials: Vec<MaterialLine>,
    /// The skin; of several the last.
    pub skin: Option<Word>,
    /// The skeleton; of several the last.
    pub skeleton: Option<Word>,
    /// Lines with too few words, at which the loader stops.
    pub short: Vec<ShortLine>,
    /// Lines of at least three words whose keyword is not known.
    pub unknown: Vec<WornLine>,
    /// Whether any line begins with a keyword of models.
    pub has_keyword: bool,
    /// The same lines as a loader takes them that does not split them into words.
    pub columns: Columns,
    /// The same lines as MakeHuman 1 takes them.
    pub lines: Lines,
    /// The format that it has instead, of an older version.
    pub outdated: Option<Outdated>,
}

/// A word and where it stands, in bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word {
    /// The word.
    pub text: Box<str>,
    /// Its place.
    pub span: Range<usize>,
}

/// A line `modifier`.
#[derive(Debug, Clone, PartialEq)]
pub struct Modifier {
    /// The pattern of the slider; empty if it is not there.
    pub pattern: Word,
    /// The value, or what is at fault.
    pub value: Result<f64, ModifierFault>,
}

/// Why the loader stops at a modifier.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ModifierFault {
    /// Another number of words than three.
    Words(usize),
    /// What is no number.
    NotANumber(Box<str>),
}

/// A line that puts an asset on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WornLine {
    /// The category.
    pub category: Word,
    /// The name of the asset.
    pub name: Word,
    /// Its uuid.
    pub uuid: Box<str>,
}

/// A line that chooses a material.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MaterialLine {
    /// The name of the asset.
    pub name: Word,
    /// Its uuid.
    pub uuid: Box<str>,
    /// The file.
    pub path: Word,
    /// How many words are behind it.
    pub surplus: usize,
}

/// A line with too few words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShortLine {
    /// Its keyword.
    pub keyword: Word,
    /// How many words it has.
    pub found: usize,
    /// How many it needs.
    pub needed: usize,
}

/// The words that put an asset on.
pub const CATEGORIES: [&str; 8] = [
    "clothes",
    "hair",
    "eyes",
    "eyebrows",
    "eyelashes",
    "teeth",
    "tongue",
    "proxy",
];

/// The other words that lines of models begin with.
const KEYWORDS: [&str; 9] = [
    "version",
    "uuid",
    "author",
    "name",
    "tags",
    "skinMaterial",
    "skeleton",
    "modifier",
    "material",
];

/// Lines of a sort that are kept. No character has as many.
const MOST: usize = 50_000;

/// Reads all lines. Bytes that are no UTF-8 are dropped, as the loader does.
pub fn read(text: &[u8]) -> Model {
    let lines_of_words = lines::read(text);
    let outdated = outdated::of_model(&lines_of_words);
    let columns = columns::read(text);
    let mut model = Model {
        columns,
        lines: lines_of_words,
        outdated,
        ..Model::default()
    };
    for (Range { start, .. }, line) in lines(text) {
        let words = fields(line);
        let word = |at: usize| {
            words
                .get(at)
                .map(|(from, word)| new_word(start + from, word))
                .unwrap_or_default()
        };
        if words
            .first()
            .is_some_and(|(_, first)| !first.starts_with(b"#"))
        {
            model.take(line, words.len(), &word);
        }
    }
    model
}

impl Model {
    fn take(&mut self, line: &[u8], count: usize, word: &dyn Fn(usize) -> Word) {
        let keyword = word(0);
        self.has_keyword |=
            KEYWORDS.contains(&&*keyword.text) || CATEGORIES.contains(&&*keyword.text);
        let needed = match &*keyword.text {
            "version" | "uuid" | "skinMaterial" | "skeleton" => 2,
            "material" => 4,
            category if CATEGORIES.contains(&category) => 3,
            _ => 0,
        };
        if count < needed {
            return keep(
                &mut self.short,
                ShortLine {
                    keyword,
                    found: count,
                    needed,
                },
            );
        }
        match &*keyword.text {
            "version" | "uuid" | "author" => {}
            "name" | "tags" if !self.modifiers.is_empty() => {}
            "name" => self.name = Some(rest(line, &keyword.text).into()),
            "tags" => {
                self.tags = rest(line, &keyword.text)
                    .split(';')
                    .take(MOST)
                    .map(Into::into)
                    .collect();
                self.tags_at = keyword.span;
            }
            "skinMaterial" => self.skin = Some(word(1)),
            "skeleton" => self.skeleton = Some(word(1)),
            "modifier" => keep(&mut self.modifiers, modifier(count, word)),
            "material" => keep(
                &mut self.materials,
                MaterialLine {
                    name: word(1),
                    uuid: word(2).text,
                    path: word(3),
                    surplus: count - 4,
                },
            ),
            category => {
                let is_known = CATEGORIES.contains(&category);
                let line = WornLine {
                    category: keyword,
                    name: word(1),
                    uuid: word(2).text,
                };
                match is_known {
                    true => keep(&mut self.worn, line),
                    false if count >= 3 => keep(&mut self.unknown, line),
                    false => {}
                }
            }
        }
    }
}

impl Default for Word {
    fn default() -> Self {
        Self {
            text: "".into(),
            span: 0..0,
        }
    }
}

/// A word that begins at this byte.
pub(super) fn new_word(start: usize, word: &[u8]) -> Word {
    let text: String = word.utf8_chunks().map(|chunk| chunk.valid()).collect();
    Word {
        text: text.into(),
        span: start..start + word.len(),
    }
}

fn modifier(count: usize, word: &dyn Fn(usize) -> Word) -> Modifier {
    let value = match (count, word(2).text) {
        (3, text) => python_float(text.as_bytes()).ok_or(ModifierFault::NotANumber(text)),
        _ => Err(ModifierFault::Words(count)),
    };
    let pattern = word(1);
    // Without a pattern the fault is shown at the keyword.
    let pattern = if count < 2 {
        Word {
            span: word(0).span,
            ..pattern
        }
    } else {
        pattern
    };
    Modifier { pattern, value }
}

fn rest(line: &[u8], keyword: &str) -> String {
    let text: String = line.utf8_chunks().map(|chunk| chunk.valid()).collect();
    text.trim()
        .strip_prefix(keyword)
        .unwrap_or_default()
        .trim()
        .to_owned()
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

    const TEXT: &str = "# clothes no\nversion v2\r\nname well dressed\ntags a;b c\nmodifier a/b|c 0.5\nmodifier a/b 0,5\n\
        modifier x\n clothes vest 12\nmaterial vest 12 red.mhmat more\nskinMaterial \
        a.mhmat\nskinMaterial skins/b.mhmat\n\
        skeleton\nhair bob\nCloths vest 12\nnote x\n";

    #[test]
    fn lines_are_what_their_keywords_say() {
        let model = read(TEXT.as_bytes());
        assert_eq!(model.name.as_deref(), Some("well dressed"));
        assert_eq!(model.tags, ["a".into(), "b c".into()] as [Box<str>; 2]);
        let values: Vec<_> = model
            .modifiers
            .iter()
            .map(|one| (&*one.pattern.text, one.value.clone()))
            .collect();
        let comma = Err(ModifierFault::NotANumber("0,5".into()));
        assert_eq!(
            values,
            [
                ("a/b|c", Ok(0.5)),
                ("a/b", comma),
                ("x", Err(ModifierFault::Words(2)))
            ]
        );
        assert_eq!(
            (&*model.worn[0].name.text, &*model.worn[0].uuid),
            ("vest", "12")
        );
        assert_eq!(
            (&*model.materials[0].path.text, model.materials[0].surplus),
            ("red.mhmat", 1)
        );
        assert_eq!(
            model.skin.as_ref().map(|word| &*word.text),
            Some("skins/b.mhmat")
        );
        let short: Vec<_> = model
            .short
            .iter()
            .map(|one| (&*one.keyword.text, one.found, one.needed))
            .collect();
        assert_eq!(short, [("skeleton", 1, 2), ("hair", 2, 3)]);
        assert_eq!(model.unknown.len(), 1);
    }

    #[test]
    fn words_stand_where_they_say() {
        let model = read(TEXT.as_bytes());
        let words = [
            &model.worn[0].name,
            &model.materials[0].path,
            &model.modifiers[0].pattern,
        ];
        assert!(
            words
                .iter()
                .all(|word| TEXT.get(word.span.clone()) == Some(&*word.text))
        );
    }

    proptest! {
        #[test]
        fn no_bytes_stop_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            read(&[b"modifier a ".as_slice(), &bytes, b"\nmaterial ", &bytes].concat());
        }

        #[test]
        fn every_modifier_is_found_again(values in prop::collection::vec(("[a-z/|]{1,9}", -2.0..2.0f64), 0..20)) {
            let lines: Vec<String> = values.iter().map(|(name, value)| format!("modifier {name} \
                {value}")).collect();
            let text = lines.join("\n");
            let found = read(text.as_bytes()).modifiers;
            let found: Vec<_> = found.into_iter().map(|one| (one.pattern.text.to_string(), one.value.unwrap())).collect();
            prop_assert_eq!(found, values);
        }
    }
}
