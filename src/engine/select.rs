//! Which rules run and at which level their findings are reported.

use globset::{Glob, GlobMatcher};

use super::outcome::Error;
use super::run::Options;
use crate::diag::{Level, nearest};
use crate::rules::RULES;

/// Compiled selectors of a run.
pub(super) struct Selection {
    only: Vec<GlobMatcher>,
    skip: Vec<GlobMatcher>,
    levels: Vec<(GlobMatcher, Option<Level>)>,
}

impl Selection {
    /// Compiles the selectors; one that fits no rule is refused.
    pub(super) fn new(options: &Options) -> Result<Self, Error> {
        let all = |texts: &[String]| texts.iter().map(|text| selector(text)).collect::<Result<Vec<_>, _>>();
        let selection = Self {
            only: all(&options.only)?,
            skip: all(&options.skip)?,
            levels: options
                .levels
                .iter()
                .map(|(text, level)| Ok((selector(text)?, *level)))
                .collect::<Result<_, _>>()?,
        };
        refuse_muted_safety(options)?;
        Ok(selection)
    }

    /// Whether a rule runs at all.
    pub(super) fn runs(&self, rule: &str) -> bool {
        let fits = |globs: &[GlobMatcher]| globs.iter().any(|glob| glob.is_match(rule));
        is_unmutable(rule) || ((self.only.is_empty() || fits(&self.only)) && !fits(&self.skip))
    }

    /// The level a finding is reported at, `None` for off.
    pub(super) fn level(&self, rule: &str, level: Level) -> Option<Level> {
        if is_unmutable(rule) {
            return Some(level);
        }
        let set = self.levels.iter().rev().find(|(glob, _)| glob.is_match(rule));
        set.map_or(Some(level), |(_, set)| *set)
    }
}

/// Naming a safety rule to mute it is refused aloud; a wide glob just does not reach it.
fn refuse_muted_safety(options: &Options) -> Result<(), Error> {
    let levels = options.levels.iter().map(|(text, _)| text);
    let named = options.skip.iter().chain(levels).find(|text| is_unmutable(text));
    named.map_or(Ok(()), |text| {
        Err(Error::Selector {
            text: text.clone(),
            reason: "this rule guards against running foreign code or filling memory and cannot be muted".to_owned(),
        })
    })
}

fn is_unmutable(rule: &str) -> bool {
    RULES.iter().any(|known| known.info.id == rule && known.info.unmutable)
}

fn selector(text: &str) -> Result<GlobMatcher, Error> {
    let refuse = |reason: String| Error::Selector { text: text.to_owned(), reason };
    let glob = Glob::new(text).map_err(|error| refuse(error.kind().to_string()))?.compile_matcher();
    if RULES.iter().any(|rule| glob.is_match(rule.info.id)) {
        return Ok(glob);
    }
    let known = RULES.iter().map(|rule| rule.info.id);
    Err(refuse(nearest(text, known).map_or_else(
        || "fits no rule; `mhlint rules` lists them".to_owned(),
        |name| format!("fits no rule; did you mean `{name}`?"),
    )))
}
