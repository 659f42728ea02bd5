//! The finding itself and the small builder that rules use.

use serde::Serialize;

use super::{Application, Because, Confidence, Evidence, Fix, Level, Location, Place, RuleInfo};

/// Parts of a finding that are told apart by name; more of them are one mass.
const MOST_PARTS: usize = 65_536;

/// Something wrong in an asset repository.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Id of the rule.
    pub rule: &'static str,
    /// The worst level in the applications of [`Finding::breaks`], after everything that lowers or raises it.
    pub level: Level,
    /// How sure the rule is.
    pub confidence: Confidence,
    /// File, relative to its data root in rules; relative to the working directory in reports.
    pub path: String,
    /// Symbolic place.
    pub place: Place,
    /// Place after the source was consulted; filled by the engine.
    pub location: Location,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
    /// What each application does with it.
    pub breaks: Vec<Break>,
    /// Counts, examples, worst value.
    pub evidence: Option<Evidence>,
    /// Other places that belong to the same fault.
    pub related: Vec<Related>,
    /// How it can be mended without a person.
    pub fix: Option<Fix>,
    /// Structural name of the fault inside the file (a bone, a pattern): part of the fingerprint.
    pub key: String,
    /// What the fingerprint names in place of [`Finding::path`] where that is only the first of several
    /// files: a folder, a base. Written as paths are.
    pub asset: Option<String>,
    /// What the finding is a part of where its rule tells parts one by one or all together, as it comes: a folder,
    /// written as paths are. A baseline knows it by this and by [`Finding::parts`].
    pub whole: Option<String>,
    /// Structural names of everything that one finding speaks for, sorted. A baseline hides it only as
    /// long as nothing is among them that was not there before.
    pub parts: Vec<String>,
    /// The files that it speaks for, where that is not just [`Finding::path`].
    pub over: Over,
    /// Stable identity, filled by the engine.
    pub fingerprint: String,
    /// Why a change can affect it, where the run is narrowed to a change; filled by the engine.
    pub because: Option<Because>,
}

/// Files that a finding speaks for, written as paths are. Mutes are for files, so they need to know.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum Over {
    /// The one at which it stands.
    #[default]
    Own,
    /// Files with a fault each, told together: muted when all of them are.
    Each(Vec<String>),
    /// Files that have one fault between them: muted when one of them is.
    Between(Vec<String>),
}

/// The consequence in one application.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Break {
    /// Who.
    pub application: Application,
    /// How bad it is there.
    pub level: Level,
    /// What happens to its user.
    pub effect: String,
}

/// Another place that belongs to a finding.
#[derive(Debug, Clone, PartialEq)]
pub struct Related {
    /// File, as in [`Finding::path`].
    pub path: String,
    /// Symbolic place.
    pub place: Place,
    /// Place after the source was consulted; filled by the engine.
    pub location: Location,
    /// What is there.
    pub message: String,
}

impl Finding {
    /// A finding of `rule` at `place` of the file `path`, with the levels and consequences of the rule.
    pub fn new(rule: &RuleInfo, path: impl Into<String>, place: Place, message: impl Into<String>) -> Self {
        let breaks = rule.breaks.iter().map(|(application, effect)| Break {
            application: *application,
            level: rule.level_in(*application),
            effect: (*effect).to_owned(),
        });
        let finding = Self {
            rule: rule.id,
            level: rule.level,
            confidence: Confidence::High,
            path: path.into(),
            place,
            location: Location::default(),
            message: message.into(),
            help: None,
            breaks: breaks.collect(),
            evidence: None,
            related: Vec::new(),
            fix: None,
            key: String::new(),
            asset: None,
            whole: None,
            parts: Vec::new(),
            over: Over::Own,
            fingerprint: String::new(),
            because: None,
        };
        finding.at_worst()
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Names the fault inside the file: bone, pattern, combination. Must not depend on order or layout.
    #[must_use]
    pub fn key(mut self, key: impl Into<String>) -> Self {
        self.key = key.into();
        self
    }

    /// Names what the fault belongs to where the finding stands at one of several files.
    #[must_use]
    pub fn asset(mut self, asset: impl Into<String>) -> Self {
        self.asset = Some(asset.into());
        self
    }

    /// Names what the finding is a part of, and which parts it speaks for, where the rule now and then tells other
    /// parts together.
    #[must_use]
    pub fn part_of<T: ToString>(self, whole: impl Into<String>, parts: impl IntoIterator<Item = T>) -> Self {
        Self { whole: Some(whole.into()), ..self.parts(parts) }
    }

    /// Names everything the finding speaks for, in place of the cases of its evidence. Neither numbers that
    /// count something nor wording may be in a name.
    #[must_use]
    pub fn parts<T: ToString>(mut self, parts: impl IntoIterator<Item = T>) -> Self {
        self.parts = parts.into_iter().map(|part| part.to_string()).collect();
        self.parts.sort();
        self.parts.dedup();
        if self.parts.len() > MOST_PARTS {
            self.parts.clear();
        }
        self
    }

    /// Names the files with a fault each that the finding tells together.
    #[must_use]
    pub fn over_each<T: Into<String>>(self, files: impl IntoIterator<Item = T>) -> Self {
        Self { over: Over::Each(files.into_iter().map(Into::into).collect()), ..self }
    }

    /// Names the files that have the fault between them.
    #[must_use]
    pub fn between<T: Into<String>>(self, files: impl IntoIterator<Item = T>) -> Self {
        Self { over: Over::Between(files.into_iter().map(Into::into).collect()), ..self }
    }

    /// Lowers or raises the level where the consequence differs from the rule's usual one.
    #[must_use]
    pub fn level(mut self, level: Level) -> Self {
        self.level = level;
        self.breaks.iter_mut().for_each(|one| one.level = level);
        self
    }

    /// The same for one application.
    #[must_use]
    pub fn level_in(mut self, application: Application, level: Level) -> Self {
        self.breaks.iter_mut().filter(|one| one.application == application).for_each(|one| one.level = level);
        self.at_worst()
    }

    /// Keeps the consequences in these applications.
    #[must_use]
    pub fn only_in(mut self, applications: &[Application]) -> Self {
        self.breaks.retain(|one| applications.contains(&one.application));
        self.at_worst()
    }

    fn at_worst(mut self) -> Self {
        self.level = self.breaks.iter().map(|one| one.level).max().unwrap_or(self.level);
        self
    }

    /// Takes the level that the settings say, in every application, where they say another one.
    pub fn regrade(&mut self, level: Level) {
        if level != self.level {
            self.level = level;
            self.breaks.iter_mut().for_each(|one| one.level = level);
        }
    }

    /// Whether it is about ignores, settings or the baseline: a matter of no application.
    pub fn is_upkeep(&self) -> bool {
        self.breaks.is_empty()
    }

    /// Marks a heuristic.
    #[must_use]
    pub fn confidence(mut self, confidence: Confidence) -> Self {
        self.confidence = confidence;
        self
    }

    /// Adds counts and examples.
    #[must_use]
    pub fn evidence(mut self, mut evidence: Evidence) -> Self {
        let cases = std::mem::take(&mut evidence.cases);
        let is_whole = cases.len() as u64 == evidence.count;
        self.evidence = Some(evidence);
        if self.parts.is_empty() && is_whole { self.parts(cases) } else { self }
    }

    /// Replaces the usual consequence by the one of this case, in the application at hand.
    #[must_use]
    pub fn effect(mut self, effect: impl Into<String>) -> Self {
        let effect = effect.into();
        self.breaks.iter_mut().for_each(|other| other.effect.clone_from(&effect));
        self
    }

    /// Replaces the usual consequence in one application.
    #[must_use]
    pub fn breaks(mut self, application: Application, effect: impl Into<String>) -> Self {
        let effect = effect.into();
        match self.breaks.iter_mut().find(|one| one.application == application) {
            Some(one) => one.effect = effect,
            None => self.breaks.push(Break { application, level: self.level, effect }),
        }
        self
    }

    /// Says how it can be mended; nothing where a fix has no steps.
    #[must_use]
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fix = (!fix.steps.is_empty()).then_some(fix);
        self
    }

    /// Adds another place.
    #[must_use]
    pub fn related(mut self, path: impl Into<String>, place: Place, message: impl Into<String>) -> Self {
        self.related.push(Related { path: path.into(), place, location: Location::default(), message: message.into() });
        self
    }
}
