//! Names of everything that one finding is about.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

/// What a part is called. Must not depend on order, layout or wording.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Name {
    /// Elements with numbers in a row, from the first to the last: vertices are many, and mostly
    /// neighbours.
    Numbers(u64, u64),
    /// A bone, a pattern, a file.
    Text(String),
}

/// The parts of a finding, in order, each once. None where it is about one thing, or about more
/// than can be told apart.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(into = "Vec<String>", from = "Vec<String>")]
pub struct Parts {
    /// Names, with the position of their file in `files`.
    named: Vec<(Name, Option<usize>)>,
    /// Files that parts lie in, where that is not only the one at which the finding stands.
    files: Vec<String>,
}

/// Parts that are told apart by name; more of them are one mass.
const MOST: u64 = 65_536;

impl Name {
    /// A name as it was written.
    fn read(text: &str) -> Self {
        let number = |text: &str| {
            text.parse::<u64>()
                .ok()
                .filter(|number| number.to_string() == text)
        };
        let run = text
            .split_once('-')
            .and_then(|(first, last)| Some((number(first)?, number(last)?)));
        let alone = || number(text).map(|number| (number, number));
        run.or_else(alone).map_or_else(
            || Self::Text(text.to_owned()),
            |(first, last)| Self::Numbers(first, last),
        )
    }

    const fn count(&self) -> u64 {
        match self {
            Self::Numbers(first, last) => last.saturating_sub(*first).saturating_add(1),
            Self::Text(_) => 1,
        }
    }
}

impl Parts {
    /// Parts with the files that they lie in, written as paths are.
    pub fn in_files<N: Into<Name>, F: AsRef<str>>(parts: impl IntoIterator<Item = (N, F)>) -> Self {
        let mut files: Vec<String> = Vec::new();
        let mut numbers: BTreeMap<String, usize> = BTreeMap::new();
        let mut number_of = |file: &str| {
            numbers.get(file).copied().unwrap_or_else(|| {
                files.push(file.to_owned());
                numbers.insert(file.to_owned(), files.len() - 1);
                files.len() - 1
            })
        };
        let named = parts
            .into_iter()
            .map(|(name, file)| (name.into(), Some(number_of(file.as_ref()))))
            .collect();
        Self {
            named: merged(named),
            files,
        }
    }

    /// Those that lie in no file, or in one that is to be kept; with no other files.
    pub(super) fn in_kept(&self, is_kept: impl Fn(&str) -> bool) -> Self {
        let mut kept = Self::default();
        let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
        for (name, number) in &self.named {
            let number = match number.and_then(|number| Some((number, self.files.get(number)?))) {
                Some((_, file)) if !is_kept(file) => continue,
                Some((number, file)) => Some(*numbers.entry(number).or_insert_with(|| {
                    kept.files.push(file.clone());
                    kept.files.len() - 1
                })),
                None => None,
            };
            kept.named.push((name.clone(), number));
        }
        kept
    }

    /// The same, or no names where they are too many; the files stay.
    #[must_use]
    pub(super) fn if_few(mut self) -> Self {
        if self.count() > MOST {
            self.named.clear();
        }
        self
    }

    /// Whether no part has a name.
    pub fn is_empty(&self) -> bool {
        self.named.is_empty()
    }

    /// How many there are.
    pub fn count(&self) -> u64 {
        self.named
            .iter()
            .fold(0, |count, (name, _)| name.count().saturating_add(count))
    }

    /// Each name with its file, where that is not the one at which the finding stands.
    pub fn iter(&self) -> impl Iterator<Item = (&Name, Option<&str>)> {
        self.named.iter().map(|(name, file)| {
            (
                name,
                file.and_then(|file| self.files.get(file))
                    .map(String::as_str),
            )
        })
    }

    /// The files that they lie in, where that is not only the one at which the finding stands.
    pub fn files(&self) -> &[String] {
        &self.files
    }

    /// Those whose names are in none of the `known`. Where both lie in files, it is the name in
    /// that file.
    #[must_use]
    pub fn without<'p>(&self, known: impl IntoIterator<Item = &'p Self>) -> Self {
        let known = NameIndex::of(known);
        let rest = |(name, number): &(Name, Option<usize>)| {
            let file = number
                .and_then(|number| self.files.get(number))
                .map(String::as_str);
            let number = *number;
            known
                .rest_of(name, file)
                .into_iter()
                .map(move |name| (name, number))
                .collect::<Vec<_>>()
        };
        Self {
            named: self.named.iter().flat_map(rest).collect(),
            files: self.files.clone(),
        }
    }

    /// What of a name is not among these. They may have been read: a text of digits is the number,
    /// too.
    fn rest_of(&self, name: Name) -> Vec<Name> {
        match name {
            Name::Numbers(first, last) => self.gaps(first, last),
            Name::Text(_)
                if self
                    .named
                    .binary_search_by(|(known, _)| known.cmp(&name))
                    .is_ok() =>
            {
                Vec::new()
            }
            Name::Text(ref text) => match Name::read(text) {
                Name::Numbers(first, last) if self.gaps(first, last).is_empty() => Vec::new(),
                _ => vec![name],
            },
        }
    }

    /// The numbers of a row that are not among these.
    fn gaps(&self, first: u64, last: u64) -> Vec<Name> {
        let start = self
            .named
            .partition_point(|(name, _)| matches!(name, Name::Numbers(_, end) if *end < first));
        let mut gaps = Vec::new();
        let mut next = Some(first);
        for (name, _) in self.named.iter().skip(start) {
            let (Name::Numbers(from, to), Some(missing)) = (name, next) else {
                break;
            };
            if *from > last {
                break;
            }
            if *from > missing {
                gaps.push(Name::Numbers(missing, from - 1));
            }
            next = to.checked_add(1);
        }
        gaps.extend(
            next.filter(|next| *next <= last)
                .map(|next| Name::Numbers(next, last)),
        );
        gaps
    }
}

/// Names of some parts, made ready for others to be looked up.
pub struct NameIndex<'p> {
    anywhere: Parts,
    /// Those that lie in no file.
    free: Parts,
    inside: BTreeMap<&'p str, Parts>,
}

impl<'p> NameIndex<'p> {
    /// The names of all these parts.
    pub fn of(parts: impl IntoIterator<Item = &'p Parts>) -> Self {
        let (mut anywhere, mut free, mut inside) =
            (Vec::new(), Vec::new(), BTreeMap::<&str, Vec<Name>>::new());
        for (name, file) in parts.into_iter().flat_map(Parts::iter) {
            anywhere.push(name.clone());
            match file {
                Some(file) => inside.entry(file).or_default().push(name.clone()),
                None => free.push(name.clone()),
            }
        }
        let inside = inside
            .into_iter()
            .map(|(file, names)| (file, names.into_iter().collect()))
            .collect();
        Self {
            anywhere: anywhere.into_iter().collect(),
            free: free.into_iter().collect(),
            inside,
        }
    }

    /// Whether one of the names is among these. Where both lie in files, it is the name in that
    /// file.
    pub fn has_one_of(&self, parts: &Parts) -> bool {
        parts
            .iter()
            .any(|(name, file)| self.rest_of(name, file) != [name.clone()])
    }

    /// What of a name in a file is not among these.
    fn rest_of(&self, name: &Name, file: Option<&str>) -> Vec<Name> {
        let Some(file) = file else {
            return self.anywhere.rest_of(name.clone());
        };
        let own = self
            .inside
            .get(file)
            .map_or_else(|| vec![name.clone()], |own| own.rest_of(name.clone()));
        own.into_iter()
            .flat_map(|name| self.free.rest_of(name))
            .collect()
    }
}

/// Sorted, each once, and numbers in a row as one.
fn merged(mut named: Vec<(Name, Option<usize>)>) -> Vec<(Name, Option<usize>)> {
    named.sort();
    named.dedup_by(|(name, file), (before, file_before)| match (name, before) {
        (Name::Numbers(first, last), Name::Numbers(_, end))
            if file == file_before && *first <= end.saturating_add(1) =>
        {
            *end = (*end).max(*last);
            true
        }
        (name, before) => name == before && file == file_before,
    });
    named
}

impl<N: Into<Name>> FromIterator<N> for Parts {
    fn from_iter<I: IntoIterator<Item = N>>(names: I) -> Self {
        Self {
            named: merged(names.into_iter().map(|name| (name.into(), None)).collect()),
            files: Vec::new(),
        }
    }
}

impl From<Vec<String>> for Parts {
    fn from(written: Vec<String>) -> Self {
        written.iter().map(|text| Name::read(text)).collect()
    }
}

impl From<Parts> for Vec<String> {
    fn from(parts: Parts) -> Self {
        let mut written: Self = parts
            .named
            .iter()
            .map(|(name, _)| name.to_string())
            .collect();
        written.dedup();
        written
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numbers(first, last) if first == last => write!(f, "{first}"),
            Self::Numbers(first, last) => write!(f, "{first}-{last}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}

impl From<String> for Name {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<u64> for Name {
    fn from(number: u64) -> Self {
        Self::Numbers(number, number)
    }
}

impl From<i64> for Name {
    fn from(number: i64) -> Self {
        u64::try_from(number).map_or_else(|_| Self::Text(number.to_string()), Self::from)
    }
}

/// The same from what else there is.
macro_rules! names {
    ($($type:ty: $name:ident => $value:expr;)*) => {$(
        impl From<$type> for Name {
            fn from($name: $type) -> Self {
                Self::from($value)
            }
        }
    )*};
}

names! {
    &str: text => text.to_owned();
    &&str: text => (*text).to_owned();
    &String: text => text.clone();
    &&String: text => (*text).clone();
    u32: number => u64::from(number);
    &u32: number => u64::from(*number);
    usize: number => number as u64;
    &i64: number => *number;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(names: &[&str]) -> Parts {
        names
            .iter()
            .map(|name| (*name).to_owned())
            .collect::<Vec<_>>()
            .into()
    }

    fn written(parts: Parts) -> Vec<String> {
        parts.into()
    }

    #[test]
    fn numbers_in_a_row_are_one_name() {
        let parts: Parts = [10_u32, 11, 12, 3, 5, 11].into_iter().collect();
        assert_eq!(
            (parts.count(), written(parts)),
            (5, vec!["3".to_owned(), "5".to_owned(), "10-12".to_owned()])
        );
        let mixed: Parts = [-2_i64, 1, 2].into_iter().collect();
        assert_eq!(written(mixed), ["1-2", "-2"]);
    }

    #[test]
    fn what_was_written_is_known_again_and_nothing_else() {
        let known = read(&["3", "10-12", "18446744073709551615", "toe.L", "01", "7-9"]);
        let left = |names: &[&str]| written(names.iter().collect::<Parts>().without([&known]));
        assert_eq!(
            left(&[
                "3",
                "10",
                "12",
                "18446744073709551615",
                "toe.L",
                "01",
                "7-9"
            ]),
            [""; 0]
        );
        assert_eq!(left(&["2", "4", "13", "011", "-3", ""]).len(), 6);
        let rest = [2_u32, 3, 4, 9, 10, 11, 12, 13]
            .into_iter()
            .collect::<Parts>()
            .without([&known]);
        assert_eq!(written(rest), ["2", "4", "13"]);
        let whole: Parts = [Name::Numbers(0, u64::MAX)].into_iter().collect();
        assert_eq!(
            written(whole.without([&known])),
            ["0-2", "4-6", "13-18446744073709551614"]
        );
        let both = read(&["1-3"]).without([&read(&["1"]), &read(&["3"])]);
        assert_eq!(written(both), ["2"]);
    }

    #[test]
    fn parts_know_their_files() {
        let parts = Parts::in_files([("y", "b"), ("x", "a"), ("z", "b"), ("x", "b")]);
        assert_eq!(parts.files(), ["b", "a"]);
        let left = parts.without([&read(&["x"])]);
        let left: Vec<(String, Option<&str>)> = left
            .iter()
            .map(|(name, file)| (name.to_string(), file))
            .collect();
        assert_eq!(
            left,
            [("y".to_owned(), Some("b")), ("z".to_owned(), Some("b"))]
        );
        let elsewhere = parts.without([&Parts::in_files([("y", "a"), ("x", "a"), ("z", "b")])]);
        let left: Vec<(String, Option<&str>)> = elsewhere
            .iter()
            .map(|(name, file)| (name.to_string(), file))
            .collect();
        assert_eq!(
            left,
            [("x".to_owned(), Some("b")), ("y".to_owned(), Some("b"))]
        );
    }

    #[test]
    fn a_mass_has_no_names_and_keeps_its_files() {
        let named = |count: u64| Parts::in_files((0..count).map(|number| (number, "a"))).if_few();
        assert_eq!((named(MOST).count(), named(MOST + 1).count()), (MOST, 0));
        assert_eq!(named(MOST + 1).files(), ["a"]);
    }
}
