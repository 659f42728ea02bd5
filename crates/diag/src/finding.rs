//! The finding itself and the small builder that rules use.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{
    Application, Case, Cases, Confidence, EXAMPLES, Evidence, Figure, Fix, Grown, Grows, Level,
    Location, Measure, MeasureKind, Name, Parts, Place, RuleInfo, Subject,
};

/// Something wrong in an asset repository.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Id of the rule.
    pub rule: &'static str,
    /// The worst level in the applications of [`Finding::breaks`], after everything that lowers or
    /// raises it.
    pub level: Level,
    /// How sure the rule is.
    pub confidence: Confidence,
    /// File, as reports print it: relative to the working directory.
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
    /// What that counts, in the plural; empty where the message alone says it.
    pub counts: &'static str,
    /// Other places that belong to the same fault.
    pub related: Vec<Related>,
    /// How it can be fixed without a person.
    pub fix: Option<Fix>,
    /// What it is about: its identity.
    pub subject: Subject,
    /// The other files of some that do not fit one another: where its own file is not the one that
    /// is checked, the finding belongs to the first of these that is.
    pub against: Vec<String>,
    /// Files that have one fault between them, written as paths are: it is gone when fewer than two
    /// are left.
    pub between: Vec<String>,
    /// Where only some of [`Finding::files`] are ignored; filled by the engine.
    pub ignored: Option<IgnoredFiles>,
    /// What the worst value of its evidence measures.
    pub grows: Option<Grows>,
    /// How much more of it there is than before, where that is why it is reported.
    pub grown: Option<Grown>,
    /// How many of its parts are new, where only new ones are reported.
    pub new_parts: Option<NewParts>,
    /// Stable identity, filled by the engine.
    pub fingerprint: String,
    /// Where its parts stand, by file and name, as far as that is known.
    pub places: BTreeMap<(String, String), Place>,
}

/// How many of the files that a finding is about are ignored.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IgnoredFiles {
    /// These, by path.
    pub files: Vec<String>,
    /// Of so many.
    pub of: usize,
}

/// How many of the parts of a finding are new.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NewParts {
    /// So many.
    pub count: u64,
    /// Of so many.
    pub of: u64,
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
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Related {
    /// File, as in [`Finding::path`].
    pub path: String,
    /// Symbolic place.
    #[serde(skip)]
    pub place: Place,
    /// Place after the source was consulted; filled by the engine.
    #[serde(rename = "place")]
    pub location: Location,
    /// What is there.
    pub message: String,
}

impl Finding {
    /// A finding of `rule` at `place` of the file `path`, with the levels and consequences of the
    /// rule.
    pub fn new(
        rule: &RuleInfo,
        path: impl Into<String>,
        place: Place,
        message: impl Into<String>,
    ) -> Self {
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
            counts: rule.counts,
            related: Vec::new(),
            fix: None,
            subject: Subject::default(),
            against: Vec::new(),
            between: Vec::new(),
            ignored: None,
            fingerprint: String::new(),
            new_parts: None,
            grows: rule.grows,
            grown: None,
            places: BTreeMap::new(),
        };
        finding.at_worst()
    }

    /// How much of the fault there is: the worst value, or how many show it where they have no
    /// names.
    pub fn measure(&self) -> Option<Measure> {
        let evidence = self.evidence.as_ref()?;
        let worst = self
            .grows
            .zip(evidence.worst.as_ref())
            .map(|(grows, worst)| (grows, worst.value));
        let counted = || Some((Grows::more(MeasureKind::Count)?, evidence.count as f64));
        let (grows, value) =
            worst.or_else(|| counted().filter(|_| self.subject.parts.is_empty()))?;
        Some(Measure {
            grows,
            value: Figure(value),
        })
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Names the fault inside the asset: bone, pattern, combination. Must not depend on order or
    /// layout.
    #[must_use]
    pub fn key(mut self, key: impl Into<String>) -> Self {
        self.subject.key = key.into();
        self
    }

    /// Names what the fault belongs to where that is not the file at which the finding stands.
    #[must_use]
    pub fn asset(mut self, asset: impl Into<String>) -> Self {
        self.subject.asset = Some(asset.into());
        self
    }

    /// Names everything the finding is about, in place of the cases of its evidence. Neither
    /// numbers that count something nor wording may be in a name.
    #[must_use]
    pub fn parts<T: Into<Name>>(mut self, parts: impl IntoIterator<Item = T>) -> Self {
        self.subject.parts = parts.into_iter().collect::<Parts>().if_few();
        self
    }

    /// The same where the parts lie in files, each with a fault of its own. Ignores are for files:
    /// the finding stays until all of them are ignored.
    #[must_use]
    pub fn parts_in<T: Into<Name>, F: AsRef<str>>(
        mut self,
        parts: impl IntoIterator<Item = (T, F)>,
    ) -> Self {
        self.subject.parts = Parts::in_files(parts).if_few();
        self
    }

    /// The same where it is known at what place in its file each part stands.
    #[must_use]
    pub fn parts_at<'f, T: Into<Name>>(
        mut self,
        parts: impl IntoIterator<Item = (T, &'f String, Place)>,
    ) -> Self {
        let mut named = Vec::new();
        for (name, file, place) in parts {
            let name = name.into();
            self.places
                .entry((file.clone(), name.to_string()))
                .or_insert(place);
            named.push((name, file));
        }
        self.parts_in(named)
    }

    /// Names another file that this one does not fit.
    #[must_use]
    pub fn against(mut self, path: impl Into<String>) -> Self {
        self.against.push(path.into());
        self
    }

    /// Names the files that have the fault between them.
    #[must_use]
    pub fn between<T: Into<String>>(self, files: impl IntoIterator<Item = T>) -> Self {
        Self {
            between: files.into_iter().map(Into::into).collect(),
            ..self
        }
    }

    /// The files that it is about, where that is not only the one at which it stands.
    pub fn files(&self) -> &[String] {
        if self.between.is_empty() {
            self.subject.parts.files()
        } else {
            &self.between
        }
    }

    /// What the fault belongs to, written as paths are.
    pub fn asset_path(&self) -> &str {
        self.subject.asset.as_deref().unwrap_or(&self.path)
    }

    /// Lowers or raises the level of a rule that one application alone has.
    #[must_use]
    pub fn level(mut self, level: Level) -> Self {
        self.level = level;
        self.breaks.iter_mut().for_each(|one| one.level = level);
        self
    }

    /// Lowers the level in every application to this one, where a case is less bad for all of them.
    #[must_use]
    pub fn at_most(mut self, level: Level) -> Self {
        self.breaks
            .iter_mut()
            .for_each(|one| one.level = one.level.min(level));
        self.at_worst()
    }

    /// Another level in one application.
    #[must_use]
    pub fn level_in(mut self, application: Application, level: Level) -> Self {
        self.breaks
            .iter_mut()
            .filter(|one| one.application == application)
            .for_each(|one| one.level = level);
        self.at_worst()
    }

    /// Makes more than an info one in an application for which it takes effect later, and says
    /// when.
    pub fn wait_in(&mut self, application: Application, until: &str) {
        let waits = |one: &&mut Break| one.application == application && one.level > Level::Info;
        for one in self.breaks.iter_mut().filter(waits) {
            (one.level, one.effect) = (Level::Info, until.to_owned());
        }
        self.level = self
            .breaks
            .iter()
            .map(|one| one.level)
            .max()
            .unwrap_or(self.level);
    }

    /// What the applications of a case do with it; the others do the usual.
    #[must_use]
    pub fn case(self, case: Case) -> Self {
        let told =
            |finding: Self, own: &(_, _, _)| finding.level_in(own.0, own.1).effect_in(own.0, own.2);
        case.iter().fold(self, told)
    }

    /// Keeps the consequences in these applications.
    #[must_use]
    pub fn only_in(mut self, applications: &[Application]) -> Self {
        self.breaks
            .retain(|one| applications.contains(&one.application));
        self.at_worst()
    }

    fn at_worst(mut self) -> Self {
        self.level = self
            .breaks
            .iter()
            .map(|one| one.level)
            .max()
            .unwrap_or(self.level);
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

    /// Adds counts and examples; their names are the parts, where none are named.
    #[must_use]
    pub fn evidence(mut self, evidence: impl Into<Cases>) -> Self {
        let Cases { evidence, parts } = evidence.into();
        self.evidence = Some(evidence);
        if self.subject.parts.is_empty() && self.subject.parts.files().is_empty() {
            self.subject.parts = parts.if_few();
        }
        self
    }

    /// Replaces the usual consequence of a rule that one application alone has.
    #[must_use]
    pub fn effect(mut self, effect: impl Into<String>) -> Self {
        let effect = effect.into();
        self.breaks
            .iter_mut()
            .for_each(|other| other.effect.clone_from(&effect));
        self
    }

    /// Another consequence in one application.
    #[must_use]
    pub fn effect_in(mut self, application: Application, effect: impl Into<String>) -> Self {
        if let Some(own) = self
            .breaks
            .iter_mut()
            .find(|one| one.application == application)
        {
            own.effect = effect.into();
        }
        self
    }

    /// Says how it can be fixed; nothing where a fix has no steps.
    #[must_use]
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fix = (!fix.steps.is_empty()).then_some(fix);
        self
    }

    /// Adds another place.
    #[must_use]
    pub fn related(
        mut self,
        path: impl Into<String>,
        place: Place,
        message: impl Into<String>,
    ) -> Self {
        self.add_related(path, place, message);
        self
    }

    /// The same for a finding that is made already.
    pub fn add_related(
        &mut self,
        path: impl Into<String>,
        place: Place,
        message: impl Into<String>,
    ) {
        self.related.push(Related {
            path: path.into(),
            place,
            location: Location::default(),
            message: message.into(),
        });
    }

    /// Without the parts in files in which it is ignored.
    #[must_use]
    pub fn without_ignored(mut self) -> Self {
        if let Some(ignored) = &self.ignored {
            self.subject.parts = self
                .subject
                .parts
                .in_kept(|file| !ignored.files.iter().any(|other| other == file));
        }
        self
    }

    /// Leaves these of its parts, at the place of the first of them; all of it where these are
    /// none. Gives whether anything is left: files in which it is ignored are no place for it.
    pub fn narrow(&mut self, new: &Parts) -> bool {
        if new.count() == self.subject.parts.count() {
            return true;
        }
        let ignored = self
            .ignored
            .take()
            .map(|ignored| ignored.files)
            .unwrap_or_default();
        let parts = new.in_kept(|file| !ignored.iter().any(|other| other == file));
        if parts.is_empty() {
            return new.is_empty();
        }
        let all = self.files().to_vec();
        // What is between files is of no use without the others.
        let is_needed = |path: &String| {
            !self.between.is_empty() || !all.contains(path) || parts.files().contains(path)
        };
        self.related.retain(|one| is_needed(&one.path));
        self.stand_at(&parts);
        if let Some(evidence) = &mut self.evidence {
            let examples = parts
                .iter()
                .take(EXAMPLES)
                .map(|(name, _)| name.to_string())
                .collect();
            // What it was counted out of belongs to a count of parts only: not to one of rows or
            // targets.
            let of = evidence
                .of
                .filter(|_| evidence.count == self.subject.parts.count());
            *evidence = Evidence {
                count: parts.count(),
                examples,
                of,
                groups: None,
                worst: None,
            };
        }
        self.new_parts = Some(NewParts {
            count: parts.count(),
            of: self.subject.parts.count(),
        });
        self.subject.parts = parts;
        true
    }

    /// Stands in a file that is asked for, if one of its parts does and it is not about something
    /// between files.
    pub fn stand_where(&mut self, is_asked: impl Fn(&str) -> bool) {
        if self.between.is_empty() && !is_asked(&self.path) {
            let asked = self.subject.parts.in_kept(is_asked);
            self.stand_at(&asked);
        }
    }

    /// Moves it to the first of these parts, unless nothing is known of where in the same file that
    /// is.
    fn stand_at(&mut self, parts: &Parts) {
        let Some((name, Some(file))) = parts.iter().next() else {
            return;
        };
        let known = self
            .places
            .get(&(file.to_owned(), name.to_string()))
            .cloned();
        if known.is_none() && parts.files().contains(&self.path) {
            return;
        }
        let related = || {
            self.related
                .iter()
                .find(|one| one.path == file)
                .map(|one| one.place.clone())
        };
        self.place = known.or_else(related).unwrap_or(Place::File);
        let old = std::mem::replace(&mut self.path, file.to_owned());
        for one in self.related.iter_mut().filter(|one| one.path == file) {
            one.path.clone_from(&old);
        }
        self.subject.asset.get_or_insert(old);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_the_parts_unless_parts_are_named() {
        let rule = RuleInfo::new("a-b", Level::Info, "");
        let finding = || Finding::new(&rule, "x", Place::File, "");
        let counted = |finding: Finding| finding.evidence(Evidence::of_cases(["p", "q", "q"]));
        let names = |finding: &Finding| -> Vec<String> { finding.subject.parts.clone().into() };
        assert_eq!(names(&counted(finding())), ["p", "q"]);
        assert_eq!(names(&counted(finding().parts(["r"]))), ["r"]);
        assert_eq!(names(&counted(finding()).parts(["r"])), ["r"]);
        let between = counted(finding().between(["x", "y"]));
        assert_eq!((names(&between).len(), between.files().len()), (2, 2));
        let each = counted(finding().parts_in([("p", "x"), ("q", "y"), ("r", "y")]));
        assert_eq!(
            (names(&each).len(), each.files()),
            (3, &["x".to_owned(), "y".to_owned()][..])
        );
        assert_eq!(
            names(&finding().evidence(Evidence::of_unnamed(["line 3"]))),
            [""; 0]
        );
    }

    #[test]
    fn a_narrowed_finding_stands_where_its_first_new_part_is() {
        let rule = RuleInfo::new("a-b", Level::Info, "");
        let parts = [("p", "x"), ("q", "y"), ("r", "z"), ("s", "x")];
        let [x, y, z] = ["x", "y", "z"].map(str::to_owned);
        let known = [
            ("p", &x, Place::Line(3)),
            ("q", &y, Place::Line(7)),
            ("s", &x, Place::Line(7)),
        ];
        let all = Finding::new(&rule, "x", Place::Line(3), "")
            .parts_at(known)
            .parts_in(parts);
        let all = all
            .related("x", Place::File, "")
            .related("z", Place::Line(5), "");
        let narrowed = |names: &[&str], ignored: &[&str]| {
            let ignored = ignored.iter().map(|file| (*file).to_owned()).collect();
            let mut finding = Finding {
                ignored: Some(IgnoredFiles {
                    files: ignored,
                    of: 3,
                }),
                ..all.clone()
            };
            let new = Parts::in_files(parts.into_iter().filter(|(name, _)| names.contains(name)));
            finding.narrow(&new).then_some(finding)
        };
        let one = narrowed(&["q", "r"], &[]).unwrap();
        assert_eq!(
            (one.path.as_str(), &one.place, one.asset_path()),
            ("y", &Place::Line(7), "x")
        );
        assert_eq!(
            (one.related.len(), one.new_parts),
            (1, Some(NewParts { count: 2, of: 4 }))
        );
        let related = narrowed(&["q", "r"], &["y"]).unwrap();
        assert_eq!((related.path, related.place), (z, Place::Line(5)));
        assert_eq!(narrowed(&["p", "q"], &[]).unwrap().place, Place::Line(3));
        assert_eq!(
            narrowed(&["s"], &[]).unwrap().place,
            Place::Line(7),
            "in the same file"
        );
        assert_eq!(narrowed(&["q"], &["y"]), None);
        assert_eq!(
            narrowed(&["p", "q", "r", "s"], &[]).unwrap().new_parts,
            None
        );
    }

    #[test]
    fn what_is_left_is_counted_out_of_as_many_only_where_its_parts_were() {
        let rule = RuleInfo::new("a-b", Level::Info, "");
        let new: Parts = ["q"].into_iter().collect();
        let left = |evidence: Evidence| {
            let mut finding = Finding::new(&rule, "x", Place::File, "")
                .parts(["p", "q"])
                .evidence(evidence);
            assert!(finding.narrow(&new));
            finding
                .evidence
                .map(|evidence| (evidence.count, evidence.of))
        };
        assert_eq!(
            left(Evidence {
                of: Some(9),
                ..Evidence::counted(2)
            }),
            Some((1, Some(9)))
        );
        assert_eq!(
            left(Evidence {
                of: Some(9),
                ..Evidence::counted(5)
            }),
            Some((1, None)),
            "rows of these parts"
        );
    }
}
