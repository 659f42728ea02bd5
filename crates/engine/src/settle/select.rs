//! Which rules run and at which level their findings are reported.
//!
//! Three layers of settings: what the configuration file says for all files, what it says for some
//! files (`[[path]]`), and the command line (the fields of [`Config`] itself). A later layer
//! overrides an earlier one.

use std::collections::BTreeMap;

use super::answered::Answered;
use crate::catalogue::{is_upkeep, named};
use crate::error::{Error, SelectorFault};
use mhlint_config::{Config, ConfigFile, Globs, Selector};
use mhlint_diag::{Level, nearest};
use mhlint_rules::{Check, RULES};

/// The settings for rules in a run.
pub(crate) struct Selection<'c> {
    /// The settings of each rule for all paths. They are worked out once, because a configuration
    /// file may have any number of selectors and there are many findings.
    rules: BTreeMap<&'static str, Said>,
    /// The globs of the `[[path]]` blocks.
    blocks: Globs,
    /// Remembers what the blocks set for a rule at a path.
    here: Answered<Option<Say>>,
    file: Option<&'c ConfigFile>,
    no_eval: bool,
}

/// The settings of a rule for all paths.
struct Said {
    command_line: Option<Say>,
    file: Say,
}

/// The selectors of the command line, compiled.
struct CommandLine {
    only: Vec<Selector>,
    skip: Vec<Selector>,
    levels: Vec<(Selector, Option<Level>)>,
}

/// Whether a finding is reported, or the part of it in one file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// Reported at this level.
    At(Level),
    /// Not reported, but counted as hidden: ignored, or the rule is off for this path alone.
    Hidden,
    /// Not reported and not counted, because the path is excluded.
    Excluded,
    /// Not reported and not counted, because the rule is off.
    Off,
}

/// What a layer of settings says about a rule: off, or on with an optional level.
#[derive(Clone, Copy)]
enum Say {
    Off,
    On(Option<Level>),
}

impl<'c> Selection<'c> {
    /// Compiles the selectors. A selector that matches no rule is an error.
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

    /// Whether a rule has to run, because it is on for at least some paths.
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

    /// Whether a finding of a rule is reported, and at which level; `rel` is the path of the
    /// finding relative to the configuration file.
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

    /// Whether the command line turns off a rule or the evaluation that the rule needs, so that
    /// findings may be missing.
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

/// `select` does not turn off the rules that check the settings themselves: they report a misspelt
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

/// An error if the command line turns off a safety rule by its name. A glob that matches a safety
/// rule has no effect on it and is no error.
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

/// An error if `select` in the configuration file matches no rule: every file would pass.
fn refuse_empty_select(config: &Config) -> Result<(), Error> {
    let Some(file) = config.file.as_ref().filter(|_| config.only.is_empty()) else {
        return Ok(());
    };
    let Some(first) = file.select.first() else {
        return Ok(());
    };
    if RULES.iter().any(|rule| fits(&file.select, rule.info.id)) {
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

/// Whether a rule is a safety rule, which cannot be turned off or ignored.
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
    if RULES.iter().any(|rule| selector.fits(rule.info.id)) {
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

/// The rule whose name is most like a text.
fn like(text: &str) -> Option<&'static str> {
    nearest(text, RULES.iter().map(|rule| rule.info.id))
}
