//! Which rules run and at which level their findings are reported.
//!
//! Three layers, each going before the one above it: what the configuration file says for all
//! files, what it says for some (`[[path]]`), and the command line (the fields of [`Config`]
//! itself).

use std::collections::BTreeMap;

use super::answered::Answered;
use crate::catalogue::{is_upkeep, listed, named};
use crate::error::{Error, SelectorFault};
use mhlint_config::{Config, ConfigFile, Globs, Selector};
use mhlint_diag::{Level, nearest};
use mhlint_rules::{Check, RULES};

/// What the selectors of a run say.
pub(crate) struct Selection<'c> {
    /// What is said of each rule for all paths: a file may hold any number of selectors, and
    /// findings are many.
    rules: BTreeMap<&'static str, Said>,
    /// Globs of `[[path]]`.
    blocks: Globs,
    /// What the blocks say for a path.
    here: Answered<Option<Say>>,
    file: Option<&'c ConfigFile>,
    no_eval: bool,
}

/// What is said of a rule for all paths.
struct Said {
    command_line: Option<Say>,
    file: Say,
}

/// Compiled selectors of the command line.
struct CommandLine {
    only: Vec<Selector>,
    skip: Vec<Selector>,
    levels: Vec<(Selector, Option<Level>)>,
}

/// What becomes of a finding, or of its part in one file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// Reported at this level.
    At(Level),
    /// Hidden by somebody's wish, and counted: ignored, or of a rule that is off for this path
    /// alone.
    Hidden,
    /// Excluded, and not counted.
    Excluded,
    /// The rule is off.
    Off,
}

/// What a layer says on a rule.
#[derive(Clone, Copy)]
enum Say {
    Off,
    On(Option<Level>),
}

impl<'c> Selection<'c> {
    /// Compiles the selectors; one that fits no rule is refused.
    pub(crate) fn new(config: &'c Config) -> Result<Self, Error> {
        let all = |texts: &[String]| {
            texts
                .iter()
                .map(|text| selector(text))
                .collect::<Result<Vec<_>, _>>()
        };
        let levels = config
            .levels
            .iter()
            .map(|(text, level)| Ok((selector(text)?, *level)));
        let command_line = CommandLine {
            only: all(&config.only)?,
            skip: all(&config.skip)?,
            levels: levels.collect::<Result<_, _>>()?,
        };
        refuse_ignored_safety(config)?;
        refuse_empty_select(config)?;
        let file = config.file.as_ref();
        let said = |id| Said {
            command_line: command_line.say(id),
            file: for_all_paths(file, id),
        };
        Ok(Self {
            rules: RULES
                .iter()
                .map(|rule| (rule.info.id, said(rule.info.id)))
                .collect(),
            blocks: file
                .iter()
                .flat_map(|file| &file.blocks)
                .map(|block| block.glob.clone())
                .collect(),
            here: Answered::default(),
            file,
            no_eval: config.no_eval,
        })
    }

    /// Whether a rule runs at all: whether there is a path for which it is on.
    pub(crate) fn runs(&self, rule: &str) -> bool {
        let blocks = || self.file.iter().flat_map(|file| &file.blocks);
        let turned_on = || {
            blocks().any(|block| matches!(say(&block.skip, &block.levels, rule), Some(Say::On(_))))
        };
        cannot_be_ignored(rule)
            || match self.command_line(rule) {
                Some(Say::Off) => false,
                Some(Say::On(_)) => true,
                None => matches!(self.for_all_paths(rule), Say::On(_)) || turned_on(),
            }
    }

    /// What becomes of a finding of a rule; `rel` is its path relative to the configuration file.
    pub(crate) fn verdict(&self, rule: &'static str, level: Level, rel: Option<&str>) -> Verdict {
        if cannot_be_ignored(rule) {
            return Verdict::At(level);
        }
        let general = self.for_all_paths(rule);
        let here = rel.filter(|_| !self.blocks.is_empty());
        let here = here.and_then(|rel| self.here.of(rel, rule, || self.for_path(rule, rel)));
        let set = match (&here, &general) {
            (Some(Say::On(set)), _) => *set,
            (_, Say::On(set)) => *set,
            (_, Say::Off) => None,
        };
        match (self.command_line(rule), here, general) {
            (Some(Say::Off), ..) => Verdict::Off,
            (Some(Say::On(asked)), ..) => Verdict::At(asked.or(set).unwrap_or(level)),
            (None, Some(Say::Off), Say::On(_)) => Verdict::Hidden,
            (None, Some(Say::Off) | None, Say::Off) => Verdict::Off,
            (None, ..) => Verdict::At(set.unwrap_or(level)),
        }
    }

    /// Whether the command line keeps a rule from saying all that it would say.
    pub(crate) fn is_silenced(&self, rule: &str) -> bool {
        let numeric = || named(rule).is_some_and(|known| matches!(known.check, Check::Numeric(_)));
        matches!(self.command_line(rule), Some(Say::Off)) || self.no_eval && numeric()
    }

    fn for_all_paths(&self, rule: &str) -> Say {
        self.rules.get(rule).map_or(Say::On(None), |said| said.file)
    }

    fn for_path(&self, rule: &str, rel: &str) -> Option<Say> {
        let blocks = &self.file?.blocks;
        let mut fitting = self
            .blocks
            .fitting(rel)
            .into_iter()
            .rev()
            .filter_map(|number| blocks.get(number));
        fitting.find_map(|block| say(&block.skip, &block.levels, rule))
    }

    fn command_line(&self, rule: &str) -> Option<Say> {
        self.rules.get(rule).and_then(|said| said.command_line)
    }
}

impl CommandLine {
    fn say(&self, rule: &str) -> Option<Say> {
        if !self.only.is_empty() && !fits(&self.only, rule) {
            return Some(Say::Off);
        }
        say(&self.skip, &self.levels, rule)
            .or_else(|| (!self.only.is_empty()).then_some(Say::On(None)))
    }
}

/// What looks after the settings themselves is not for `select`: it would hide the slip in
/// `select`.
fn for_all_paths(file: Option<&ConfigFile>, rule: &str) -> Say {
    let Some(file) = file else {
        return Say::On(None);
    };
    if !file.select.is_empty() && !fits(&file.select, rule) && !is_upkeep(rule) {
        return Say::Off;
    }
    say(&file.skip, &file.levels, rule).unwrap_or(Say::On(None))
}

fn say(skip: &[Selector], levels: &[(Selector, Option<Level>)], rule: &str) -> Option<Say> {
    if fits(skip, rule) {
        return Some(Say::Off);
    }
    let (_, level) = levels
        .iter()
        .rev()
        .find(|(selector, _)| selector.fits(rule))?;
    Some(level.map_or(Say::Off, |level| Say::On(Some(level))))
}

fn fits(selectors: &[Selector], rule: &str) -> bool {
    selectors.iter().any(|selector| selector.fits(rule))
}

/// Naming a safety rule to ignore it is refused aloud; a wide glob just does not reach it.
fn refuse_ignored_safety(config: &Config) -> Result<(), Error> {
    let levels = config.levels.iter().map(|(text, _)| text);
    let named = config
        .skip
        .iter()
        .chain(levels)
        .find(|text| cannot_be_ignored(text));
    named.map_or(Ok(()), |text| {
        Err(Error::Selector {
            text: text.clone(),
            fault: SelectorFault::Safety,
        })
    })
}

/// A file that selects no rule at all would pass everything.
fn refuse_empty_select(config: &Config) -> Result<(), Error> {
    let Some(file) = config.file.as_ref().filter(|_| config.only.is_empty()) else {
        return Ok(());
    };
    let Some(first) = file.select.first() else {
        return Ok(());
    };
    if listed().any(|rule| fits(&file.select, rule.info.id)) {
        return Ok(());
    }
    let place = format!("{}:{}", file.path, file.line_at(&first.span));
    let fault = SelectorFault::EmptySelect {
        place,
        nearest: like(&first.text),
    };
    Err(Error::Selector {
        text: first.text.clone(),
        fault,
    })
}

/// Whether a rule is a matter of safety.
pub(crate) fn cannot_be_ignored(rule: &str) -> bool {
    named(rule).is_some_and(|known| known.info.cannot_be_ignored)
}

fn selector(text: &str) -> Result<Selector, Error> {
    let refuse = |fault| Error::Selector {
        text: text.to_owned(),
        fault,
    };
    let selector =
        Selector::new(text, 0..0).map_err(|error| refuse(SelectorFault::NoGlob(error)))?;
    if listed().any(|rule| selector.fits(rule.info.id)) {
        return Ok(selector);
    }
    Err(refuse(if text.contains(',') {
        SelectorFault::Several
    } else {
        SelectorFault::NoRule {
            nearest: like(text),
        }
    }))
}

/// A rule that may be meant.
fn like(text: &str) -> Option<&'static str> {
    nearest(text, listed().map(|rule| rule.info.id))
}
