//! Who loads what: a row for each group of files, a column for each application.

use std::collections::BTreeMap;

use mhlint_diag::{Application, AssetGroup, Consumer, Fares, Outcome, Verdict};

/// The matrix of the consumers, in words.
pub(super) struct Matrix {
    /// The applications of the columns.
    pub(super) applications: Vec<Application>,
    /// Title and cells of each row; the last row has the verdicts.
    pub(super) rows: Vec<(&'static str, Vec<String>)>,
}

/// What stands in a cell of files that an application does not load.
const NONE: &str = "-";

impl Matrix {
    /// That of a run for several applications: where there is one, the verdict says it all.
    pub(super) fn of(outcome: &Outcome) -> Option<Self> {
        if outcome.applications.len() < 2 {
            return None;
        }
        let applications: Vec<Application> = outcome
            .applications
            .iter()
            .map(|one| one.application)
            .collect();
        let all = tallies(outcome);
        let cell = |group, own: &Application| {
            all.get(&(group, *own))
                .map_or(NONE.to_owned(), |tally| tally.words())
        };
        let cells = |group| {
            applications
                .iter()
                .map(|own| cell(group, own))
                .collect::<Vec<_>>()
        };
        let rows = AssetGroup::ALL
            .into_iter()
            .map(|group| (title(group), cells(group)));
        let mut rows: Vec<(&str, Vec<String>)> = rows
            .filter(|(_, cells)| cells.iter().any(|cell| cell != NONE))
            .collect();
        if rows.is_empty() {
            return None;
        }
        rows.push((
            "verdict",
            outcome
                .applications
                .iter()
                .map(|one| verdict(one.verdict).to_owned())
                .collect(),
        ));
        Some(Self { applications, rows })
    }

    /// Lines in columns.
    pub(super) fn lines(&self) -> Vec<String> {
        let titles = self
            .applications
            .iter()
            .map(|application| application.title().to_owned());
        let head = ("loaded by", titles.collect::<Vec<_>>());
        let rows: Vec<&(&str, Vec<String>)> = std::iter::once(&head).chain(&self.rows).collect();
        let width = |at: usize| {
            rows.iter()
                .filter_map(|(_, cells)| cells.get(at))
                .map(String::len)
                .max()
                .unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.applications.len()).map(width).collect();
        let first = rows.iter().map(|(title, _)| title.len()).max().unwrap_or(0);
        let line = |(title, cells): &(&str, Vec<String>)| {
            let cells = cells
                .iter()
                .zip(&widths)
                .map(|(cell, width)| format!("  {cell:<width$}"));
            format!("{title:<first$}{}", cells.collect::<Vec<_>>().concat())
                .trim_end()
                .to_owned()
        };
        rows.into_iter().map(line).collect()
    }
}

/// How the files of a group fare in an application.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Tally {
    /// All that it loads.
    pub(super) files: usize,
    /// Those with an error.
    pub(super) error: usize,
    /// Those whose gravest finding is a warning.
    pub(super) warning: usize,
    /// Those whose gravest finding is an info.
    pub(super) info: usize,
    /// Those whose contents were not checked.
    pub(super) not_checked: usize,
}

/// Tallies of groups and applications, those with files only.
pub(super) type Tallies = BTreeMap<(AssetGroup, Application), Tally>;

/// Counts the files that applications load.
pub(super) fn tallies(outcome: &Outcome) -> Tallies {
    let mut all = Tallies::new();
    for row in &outcome.consumers {
        row.by.iter().for_each(|one| {
            all.entry((row.group, one.application))
                .or_default()
                .add(one);
        });
    }
    all
}

impl Tally {
    fn add(&mut self, one: &Consumer) {
        self.files += 1;
        match one.fares {
            Fares::Fine => {}
            Fares::NotChecked => self.not_checked += 1,
            Fares::Info => self.info += 1,
            Fares::Warning => self.warning += 1,
            Fares::Error => self.error += 1,
        }
    }

    fn words(self) -> String {
        match self {
            Self { error: 1.., .. } => format!("error in {} of {}", self.error, self.files),
            Self { warning: 1.., .. } => format!("warning in {} of {}", self.warning, self.files),
            Self { not_checked: 0, .. } => self.files.to_string(),
            _ if self.not_checked == self.files => format!("{} not checked", self.files),
            _ => format!(
                "{} and {} not checked",
                self.files - self.not_checked,
                self.not_checked
            ),
        }
    }
}

const fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "passed",
        Verdict::Fail => "failed",
    }
}

/// What the files of a group are called.
const fn title(group: AssetGroup) -> &'static str {
    match group {
        AssetGroup::BaseMesh => "base mesh",
        AssetGroup::Targets => "targets",
        AssetGroup::Sliders => "sliders",
        AssetGroup::Rigs => "rigs",
        AssetGroup::Poses => "poses",
        AssetGroup::Clothes => "clothes",
        AssetGroup::Materials => "materials",
        AssetGroup::Pictures => "pictures",
        AssetGroup::Models => "characters",
        AssetGroup::Program => "program",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{ApplicationVerdict, Consumed};

    fn row(path: &str, group: AssetGroup, by: &[(Application, Fares)]) -> Consumed {
        let by = by.iter().map(|(application, fares)| Consumer {
            application: *application,
            root: "data".into(),
            archive: None,
            fares: *fares,
        });
        Consumed {
            path: path.to_owned(),
            group,
            by: by.collect(),
        }
    }

    fn run(verdicts: &[(Application, Verdict)]) -> Outcome {
        use Application::{Makehuman2, Mpfb};
        let clothes = |path, fares| {
            row(
                path,
                AssetGroup::Clothes,
                &[(Makehuman2, Fares::Fine), (Mpfb, fares)],
            )
        };
        let applications = verdicts
            .iter()
            .map(|(application, verdict)| ApplicationVerdict {
                application: *application,
                verdict: *verdict,
            });
        let consumers = vec![
            clothes("a", Fares::Warning),
            clothes("b", Fares::Error),
            clothes("c", Fares::Info),
            row("d", AssetGroup::Program, &[(Mpfb, Fares::NotChecked)]),
        ];
        Outcome {
            consumers,
            applications: applications.collect(),
            ..Outcome::default()
        }
    }

    #[test]
    fn each_application_has_a_column_with_its_gravest_level() {
        let both = [
            (Application::Makehuman2, Verdict::Pass),
            (Application::Mpfb, Verdict::Fail),
        ];
        let lines = Matrix::of(&run(&both)).unwrap().lines();
        let wanted = [
            "loaded by  MakeHuman 2  MPFB",
            "clothes    3            error in 1 of 3",
            "program    -            1 not checked",
            "verdict    passed       failed",
        ];
        assert_eq!(lines, wanted);
        assert!(Matrix::of(&run(&both[..1])).is_none());
    }
}
