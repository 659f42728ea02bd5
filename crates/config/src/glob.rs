//! Globs of rules and of paths.

use std::ops::Range;

use globset::{Glob, GlobBuilder, GlobMatcher};

use mhlint_source::is_below;

/// A rule or a glob of rules, as written.
#[derive(Debug, Clone)]
pub struct Selector {
    /// As written.
    pub text: String,
    /// Where.
    pub span: Range<usize>,
    /// None if the text is the name of a rule.
    glob: Option<GlobMatcher>,
}

/// A glob of paths, as written.
#[derive(Debug, Clone)]
pub struct PathGlob {
    /// As written.
    pub text: String,
    /// Where.
    pub span: Range<usize>,
    /// None if the text is a plain path.
    glob: Option<GlobMatcher>,
}

/// Characters that mean something in a glob. Without them it fits itself alone, and comparing is
/// much faster.
const SPECIAL: [char; 8] = ['*', '?', '[', ']', '{', '}', '!', '\\'];

/// Most bytes of a glob: no system has longer paths.
const LONGEST: usize = 4096;
/// Most braces inside one another: the compiler descends into each of them.
const DEEPEST: usize = 10;

fn is_plain(text: &str) -> bool {
    !text.contains(SPECIAL)
}

/// Compiles a glob; nothing is compiled of a text that means itself.
fn compiled(text: &str, star_stops_at_slash: bool) -> Result<Option<GlobMatcher>, String> {
    if text.len() > LONGEST {
        return Err(format!("it is longer than {LONGEST} bytes"));
    }
    if is_plain(text) {
        return Ok(None);
    }
    if depth(text) > DEEPEST {
        return Err(format!(
            "its braces are nested deeper than {DEEPEST} levels"
        ));
    }
    let glob = GlobBuilder::new(text)
        .literal_separator(star_stops_at_slash)
        .build();
    Ok(Some(
        glob.map_err(|error| error.kind().to_string())?
            .compile_matcher(),
    ))
}

/// How many braces are open at once, at most.
fn depth(text: &str) -> usize {
    let mut open = 0_usize;
    let depths = text.chars().map(|c| {
        match c {
            '{' => open += 1,
            '}' => open = open.saturating_sub(1),
            _ => {}
        }
        open
    });
    depths.max().unwrap_or(0)
}

impl Selector {
    /// Compiles a glob of rule ids.
    ///
    /// # Errors
    /// What is wrong with the glob.
    pub fn new(text: &str, span: Range<usize>) -> Result<Self, String> {
        Ok(Self {
            text: text.to_owned(),
            span,
            glob: compiled(text, false)?,
        })
    }

    /// Characters that had to be compiled.
    pub(super) fn compiled(&self) -> usize {
        self.glob.as_ref().map_or(0, |_| self.text.len())
    }

    /// Whether it fits a rule: by its name, the name of its family, or the glob.
    pub fn fits(&self, rule: &str) -> bool {
        let is_named = || {
            self.text == rule
                || rule
                    .split_once('-')
                    .is_some_and(|(family, _)| family == self.text)
        };
        self.glob
            .as_ref()
            .map_or_else(is_named, |glob| glob.is_match(rule))
    }
}

impl PathGlob {
    /// Compiles a glob of paths.
    ///
    /// # Errors
    /// What is wrong with the glob.
    pub fn new(text: &str, span: Range<usize>) -> Result<Self, String> {
        let plain = text.trim_start_matches("./").trim_end_matches('/');
        Ok(Self {
            text: plain.to_owned(),
            span,
            glob: compiled(plain, true)?,
        })
    }

    /// Characters that had to be compiled; none of a plain path.
    pub(super) fn compiled(&self) -> usize {
        self.glob.as_ref().map_or(0, |_| self.text.len())
    }

    /// Whether it fits a path. Without a wildcard it names a file, or a folder with everything in
    /// it.
    pub fn fits(&self, path: &str) -> bool {
        match &self.glob {
            None => self.text == path || is_below(path, &self.text),
            Some(glob) => glob.is_match(path) || (!self.is_wild() && is_below(path, &self.text)),
        }
    }

    /// Whether it is a path without anything that means something in a glob.
    pub const fn is_plain(&self) -> bool {
        self.glob.is_none()
    }

    /// The glob, if it has wildcards.
    pub(super) fn wild(&self) -> Option<&Glob> {
        self.glob
            .as_ref()
            .map(GlobMatcher::glob)
            .filter(|_| self.is_wild())
    }

    /// The folders in front of the first wildcard: everything that fits lies there.
    pub fn folder(&self) -> &str {
        let Some(wild) = self.text.find(['*', '?', '[', '{']) else {
            return &self.text;
        };
        self.text
            .get(..wild)
            .and_then(|text| text.rsplit_once('/'))
            .map_or("", |(folder, _)| folder)
    }

    fn is_wild(&self) -> bool {
        self.text.contains(['*', '?', '[', '{'])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stays_in_its_folder_and_a_plain_name_covers_a_folder() {
        let fits = |glob: &str, path: &str| PathGlob::new(glob, 0..0).unwrap().fits(path);
        assert!(fits("rigs/*/a.mhw", "rigs/hm08/a.mhw") && !fits("rigs/*", "rigs/hm08/a.mhw"));
        assert!(fits("rigs/**", "rigs/hm08/a.mhw") && fits("**/a.mhw", "rigs/hm08/a.mhw"));
        assert!(fits("rigs/a.mhw", "rigs/a.mhw") && !fits("rigs/a.mhw", "rigs/b.mhw"));
        assert!(
            fits("rigs", "rigs/hm08/a.mhw")
                && fits("./rigs/", "rigs/a")
                && !fits("rigs", "rigs2/a")
        );
    }

    #[test]
    fn a_glob_that_is_long_or_deep_is_refused_before_it_is_compiled() {
        let nested = |levels: usize| "{a,".repeat(levels) + &"}".repeat(levels);
        for levels in [11, 126, 50_000] {
            assert!(PathGlob::new(&nested(levels), 0..0).is_err(), "{levels}");
            assert!(Selector::new(&nested(levels), 0..0).is_err(), "{levels}");
        }
        let open = "{".repeat(50_000);
        assert!(PathGlob::new(&open, 0..0).unwrap_err().contains("bytes"));
        assert!(PathGlob::new(&nested(10), 0..0).unwrap().fits("a"));
        assert!(PathGlob::new(&"{a}".repeat(300), 0..0).is_ok());
        let long = "a*".repeat(2049);
        assert_eq!(
            Selector::new(&long, 0..0).unwrap_err(),
            "it is longer than 4096 bytes"
        );
        assert!(Selector::new(&long[2..], 0..0).is_ok());
    }

    #[test]
    fn everything_that_fits_lies_in_its_folder() {
        let folder = |glob: &str| PathGlob::new(glob, 0..0).unwrap().folder().to_owned();
        assert_eq!(
            [
                folder("a/b*/c"),
                folder("a/b"),
                folder("**"),
                folder("a/**")
            ],
            ["a", "a/b", "", "a"]
        );
    }
}
