//! Many globs of paths, asked at once which of them fit.
//!
//! Plain paths are looked up, however many there are. Those with wildcards are tried in small sets,
//! ten times faster than one after the other; how many there may be is limited where the settings
//! are read (`read.rs`). One automaton for all of them would be faster for sound settings, and
//! takes much memory and time for others.

use std::collections::HashMap;

use globset::{Glob, GlobSet, GlobSetBuilder};

use super::PathGlob;

/// Globs that share an automaton.
const TOGETHER: usize = 8;

/// Globs of paths in order of the file.
#[derive(Debug, Clone, Default)]
pub struct Globs {
    list: Vec<PathGlob>,
    /// Numbers of the plain paths.
    plain: HashMap<String, Vec<usize>>,
    /// Those with wildcards, a few at a time, and their numbers.
    wild: Vec<(GlobSet, Vec<usize>)>,
    /// Numbers of those that are tried alone.
    alone: Vec<usize>,
}

impl Globs {
    /// The globs, as written.
    pub fn iter(&self) -> impl Iterator<Item = &PathGlob> {
        self.list.iter()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Whether one of them fits a path.
    pub fn fits(&self, path: &str) -> bool {
        let is_alone = || self.alone_fitting(path).next().is_some();
        self.plain_fitting(path).next().is_some()
            || self.wild.iter().any(|(set, _)| set.is_match(path))
            || is_alone()
    }

    /// Numbers of those that fit a path, in order of the file.
    pub fn fitting(&self, path: &str) -> Vec<usize> {
        let mut fitting: Vec<usize> = self
            .plain_fitting(path)
            .chain(self.alone_fitting(path))
            .collect();
        for (set, numbers) in &self.wild {
            fitting.extend(
                set.matches(path)
                    .into_iter()
                    .filter_map(|place| numbers.get(place)),
            );
        }
        fitting.sort_unstable();
        fitting
    }

    /// A plain path is that of the file, or of a folder above it.
    fn plain_fitting(&self, path: &str) -> impl Iterator<Item = usize> {
        let folders = path
            .match_indices('/')
            .filter_map(|(end, _)| path.get(..end));
        // Nothing at all names the folder of the settings.
        let names = std::iter::once("").chain(folders.filter(|folder| !folder.is_empty()));
        let names = names.chain(std::iter::once(path).filter(|path| !path.is_empty()));
        names
            .filter_map(|name| self.plain.get(name))
            .flatten()
            .copied()
    }

    fn alone_fitting(&self, path: &str) -> impl Iterator<Item = usize> {
        self.alone
            .iter()
            .copied()
            .filter(move |number| self.list.get(*number).is_some_and(|glob| glob.fits(path)))
    }
}

impl FromIterator<PathGlob> for Globs {
    fn from_iter<I: IntoIterator<Item = PathGlob>>(globs: I) -> Self {
        let mut all = Self {
            list: globs.into_iter().collect(),
            ..Self::default()
        };
        let mut wild = Vec::new();
        for (number, glob) in all.list.iter().enumerate() {
            match glob.wild() {
                _ if glob.is_plain() => {
                    all.plain.entry(glob.text.clone()).or_default().push(number);
                }
                Some(compiled) => wild.push((number, compiled)),
                None => all.alone.push(number),
            }
        }
        for some in wild.chunks(TOGETHER) {
            let numbers = some.iter().map(|(number, _)| *number);
            match together(some.iter().map(|(_, glob)| *glob)) {
                Ok(set) => all.wild.push((set, numbers.collect())),
                // They are too large to share one.
                Err(_) => all.alone.extend(numbers),
            }
        }
        all
    }
}

fn together<'g>(globs: impl Iterator<Item = &'g Glob>) -> Result<GlobSet, globset::Error> {
    let mut set = GlobSetBuilder::new();
    for glob in globs {
        set.add(glob.clone());
    }
    set.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn globs(texts: &[String]) -> Globs {
        texts
            .iter()
            .map(|text| PathGlob::new(text, 0..0).unwrap())
            .collect()
    }

    #[test]
    fn all_together_fit_as_each_of_them_does() {
        let mut texts = [
            "a", "./a/", "a/b", "a/*", "**/b", ".", "{a,c}/b", "ab", "a/b/c", "/a", "b!",
        ]
        .map(str::to_owned)
        .to_vec();
        // More than share an automaton.
        texts.extend((0..20).map(|number| format!("?{}", "*".repeat(number % 3))));
        let all = globs(&texts);
        for path in ["a", "a/b", "a/b/c", "ab", "c/b", "", "/a/b", "b!/x", "../a"] {
            let each = texts
                .iter()
                .enumerate()
                .filter(|(_, text)| PathGlob::new(text, 0..0).unwrap().fits(path));
            let each: Vec<usize> = each.map(|(number, _)| number).collect();
            assert_eq!(all.fitting(path), each, "{path}");
            assert_eq!(all.fits(path), !each.is_empty(), "{path}");
        }
    }

    #[test]
    fn plain_paths_are_looked_up_and_not_tried() {
        let texts: Vec<String> = (0..10_000)
            .map(|number| format!("target/{number}"))
            .collect();
        let all = globs(&texts);
        assert!(all.wild.is_empty() && all.alone.is_empty());
        assert_eq!(all.fitting("target/77/a.target"), [77]);
    }
}
