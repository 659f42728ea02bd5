//! Globs of rules and of paths.

use std::ops::Range;

use globset::{Glob, GlobBuilder, GlobMatcher};

use crate::source::is_below;

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

/// Characters that mean something in a glob. Without them it fits itself alone, and comparing is much faster.
const SPECIAL: [char; 8] = ['*', '?', '[', ']', '{', '}', '!', '\\'];

fn is_plain(text: &str) -> bool {
    !text.contains(SPECIAL)
}

impl Selector {
    /// Compiles a glob of rule ids.
    ///
    /// # Errors
    /// What is wrong with the glob.
    pub fn new(text: &str, span: Range<usize>) -> Result<Self, String> {
        let glob = Glob::new(text).map_err(|error| error.kind().to_string())?.compile_matcher();
        Ok(Self { text: text.to_owned(), span, glob: Some(glob).filter(|_| !is_plain(text)) })
    }

    /// Whether it fits a rule.
    pub fn fits(&self, rule: &str) -> bool {
        self.glob.as_ref().map_or(self.text == rule, |glob| glob.is_match(rule))
    }
}

impl PathGlob {
    /// Compiles a glob of paths.
    ///
    /// # Errors
    /// What is wrong with the glob.
    pub fn new(text: &str, span: Range<usize>) -> Result<Self, String> {
        let plain = text.trim_start_matches("./").trim_end_matches('/');
        let glob = GlobBuilder::new(plain).literal_separator(true).build();
        let glob = glob.map_err(|error| error.kind().to_string())?.compile_matcher();
        Ok(Self { text: plain.to_owned(), span, glob: Some(glob).filter(|_| !is_plain(plain)) })
    }

    /// Whether it fits a path. Without a wildcard it names a file, or a folder with everything in it.
    pub fn fits(&self, path: &str) -> bool {
        match &self.glob {
            None => self.text == path || is_below(path, &self.text),
            Some(glob) => glob.is_match(path) || (!self.is_wild() && is_below(path, &self.text)),
        }
    }

    /// The folders in front of the first wildcard: everything that fits lies there.
    pub fn folder(&self) -> &str {
        let Some(wild) = self.text.find(['*', '?', '[', '{']) else { return &self.text };
        self.text.get(..wild).and_then(|text| text.rsplit_once('/')).map_or("", |(folder, _)| folder)
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
        assert!(fits("rigs", "rigs/hm08/a.mhw") && fits("./rigs/", "rigs/a") && !fits("rigs", "rigs2/a"));
    }

    #[test]
    fn everything_that_fits_lies_in_its_folder() {
        let folder = |glob: &str| PathGlob::new(glob, 0..0).unwrap().folder().to_owned();
        assert_eq!([folder("a/b*/c"), folder("a/b"), folder("**"), folder("a/**")], ["a", "a/b", "", "a"]);
    }
}
