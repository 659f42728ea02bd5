//! `.mhm` as MakeHuman 1 reads it: words split at white space, a comment where the first word is
//! `#` alone (`docs/loaders/makehuman1/models.md#model-keywords`).

use std::ops::Range;

use crate::fields::fields;
use crate::mhm::{CATEGORIES, Word, new_word};
use mhlint_source::lines;

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Lines {
    /// Its lines in order, without comments.
    pub all: Vec<Line>,
    /// The first line without a word.
    pub blank: Option<u32>,
}

/// A line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// Its first word.
    pub keyword: Word,
    /// The words behind it.
    pub values: Vec<Word>,
}

/// What lines begin with besides the categories of assets.
const KEYWORDS: [&str; 13] = [
    "version",
    "uuid",
    "name",
    "tags",
    "camera",
    "modifier",
    "skeleton",
    "pose",
    "expression",
    "clothesHideFaces",
    "subdivide",
    "skinMaterial",
    "material",
];
/// What a plugin reads.
const BACKGROUND: &str = "background";

/// Lines that are kept. No character has as many.
const MOST: usize = 50_000;

/// What lines may begin with.
pub fn keywords() -> impl Iterator<Item = &'static str> {
    KEYWORDS.into_iter().chain(CATEGORIES).chain([BACKGROUND])
}

/// Reads all lines. Bytes that are no UTF-8 are dropped: then the program reads nothing.
pub fn read(text: &[u8]) -> Lines {
    let mut found = Lines::default();
    for (number, (Range { start, .. }, line)) in (1..).zip(lines(text)) {
        let mut words = fields(line)
            .into_iter()
            .map(|(from, word)| new_word(start + from, word));
        match words.next() {
            None => found.blank = found.blank.or(Some(number)),
            Some(keyword) if &*keyword.text == "#" || found.all.len() >= MOST => {}
            Some(keyword) => found.all.push(Line {
                keyword,
                values: words.collect(),
            }),
        }
    }
    found
}

impl Lines {
    /// The lines with a keyword.
    pub fn of(&self, keyword: &str) -> impl DoubleEndedIterator<Item = &Line> {
        self.all
            .iter()
            .filter(move |line| &*line.keyword.text == keyword)
    }

    /// The first value of the last line with a keyword.
    pub fn last(&self, keyword: &str) -> Option<&Word> {
        self.of(keyword).next_back()?.values.first()
    }
}

impl Line {
    /// A value, or nothing.
    pub fn value(&self, at: usize) -> &str {
        self.values.get(at).map_or("", |word| &word.text)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn only_a_hash_alone_is_a_comment() {
        let text = "# a b\n#a b\n\nmodifier a/b 0.5 x\nclothes\n";
        let found = read(text.as_bytes());
        let words: Vec<(&str, usize)> = found
            .all
            .iter()
            .map(|line| (&*line.keyword.text, line.values.len()))
            .collect();
        assert_eq!(words, [("#a", 1), ("modifier", 3), ("clothes", 0)]);
        assert_eq!(
            (found.blank, found.all[1].value(1), found.all[2].value(0)),
            (Some(3), "0.5", "")
        );
        assert_eq!(text.get(found.all[1].values[0].span.clone()), Some("a/b"));
        assert_eq!(found.last("modifier").map(|word| &*word.text), Some("a/b"));
    }

    #[test]
    fn every_keyword_stands_there_once() {
        let mut all: Vec<&str> = keywords().collect();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!((all.len(), count), (22, 22));
    }

    proptest! {
        #[test]
        fn no_bytes_stop_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let found = read(&bytes);
            prop_assert!(found.all.iter().all(|line| line.keyword.span.end <= bytes.len()));
        }
    }
}
