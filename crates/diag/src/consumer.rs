//! Who loads what: the files of a run, the applications that load them, and how they fare there.

use std::sync::Arc;

use serde::Serialize;

use super::{Application, Finding, Level};

/// A file that at least one application loads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Consumed {
    /// Its path as printed.
    pub path: String,
    /// What it is part of.
    pub group: AssetGroup,
    /// The applications that load it, each once, in their order.
    pub by: Vec<Consumer>,
}

/// An application that loads a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Consumer {
    /// Who.
    pub application: Application,
    /// The data folder that it finds the file in, as printed.
    pub root: Arc<str>,
    /// The archive that it reads in place of the file, as printed.
    pub archive: Option<Arc<str>>,
    /// How the file fares there.
    pub fares: Fares,
}

/// How a file fares in an application.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Fares {
    /// Nothing is reported.
    Fine,
    /// What is in it was not checked, and nothing else is reported.
    NotChecked,
    /// The gravest finding that concerns it there is an info.
    Info,
    /// A warning.
    Warning,
    /// An error.
    Error,
}

/// What the files of a repository are parts of, in the order of reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum AssetGroup {
    /// The base mesh and what is known of it.
    BaseMesh,
    /// Targets, packed or not.
    Targets,
    /// Sliders, macros and what they show.
    Sliders,
    /// Skeletons, rigs and weights of base meshes.
    Rigs,
    /// Poses, expressions and motions.
    Poses,
    /// Clothes, hair and other worn assets with their meshes and weights.
    Clothes,
    /// Materials, shaders, skins and layers over them.
    Materials,
    /// Pictures.
    Pictures,
    /// Saved characters and presets.
    Models,
    /// Settings, languages, scenes and lists.
    Program,
}

impl AssetGroup {
    /// All of them, in the order of reports.
    pub const ALL: [Self; 10] = [
        Self::BaseMesh,
        Self::Targets,
        Self::Sliders,
        Self::Rigs,
        Self::Poses,
        Self::Clothes,
        Self::Materials,
        Self::Pictures,
        Self::Models,
        Self::Program,
    ];
}

impl From<Level> for Fares {
    fn from(level: Level) -> Self {
        match level {
            Level::Info => Self::Info,
            Level::Warning => Self::Warning,
            Level::Error => Self::Error,
        }
    }
}

impl Consumed {
    /// Says that `application` has a finding of this level about it.
    fn concern(&mut self, application: Application, level: Level) {
        for one in self
            .by
            .iter_mut()
            .filter(|one| one.application == application)
        {
            one.fares = one.fares.max(level.into());
        }
    }
}

/// Tells files how they fare. `consumed` is sorted by path. What is found at a folder concerns the
/// files that it names.
pub fn grade_consumers(consumed: &mut [Consumed], findings: &[Finding]) {
    for finding in findings {
        let named = [finding.path.as_str(), finding.asset_path()].into_iter();
        for path in named.chain(finding.files().iter().map(String::as_str)) {
            let place = consumed.binary_search_by(|row| row.path.as_str().cmp(path));
            if let Some(row) = place.ok().and_then(|place| consumed.get_mut(place)) {
                finding
                    .breaks
                    .iter()
                    .for_each(|one| row.concern(one.application, one.level));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OF_TWO as RULE, Place};

    fn row(path: &str) -> Consumed {
        let by = Application::ALL.map(|application| Consumer {
            application,
            root: "data".into(),
            archive: None,
            fares: Fares::Fine,
        });
        Consumed {
            path: path.to_owned(),
            group: AssetGroup::Clothes,
            by: by.to_vec(),
        }
    }

    fn fares(rows: &[Consumed]) -> Vec<Vec<Fares>> {
        rows.iter()
            .map(|row| row.by.iter().map(|one| one.fares).collect())
            .collect()
    }

    #[test]
    fn a_finding_concerns_its_file_in_the_applications_that_it_breaks() {
        let mut rows = ["data/a", "data/b", "data/b/c"].map(row);
        grade_consumers(
            &mut rows,
            &[Finding::new(&RULE, "data/b", Place::File, "it")],
        );
        let none = vec![Fares::Fine; 3];
        let order = Application::ALL.map(|application| match application {
            Application::Makehuman2 => Fares::Error,
            Application::Mpfb => Fares::Info,
            Application::Makehuman1 => Fares::Fine,
        });
        assert_eq!(fares(&rows), [none.clone(), order.to_vec(), none]);
    }

    #[test]
    fn one_at_a_folder_concerns_the_files_that_it_names() {
        let mut rows = ["data/a/x", "data/a/y", "data/b"].map(row);
        grade_consumers(
            &mut rows,
            &[Finding::new(&RULE, "data/a", Place::File, "it").parts_in([("p", "data/a/y")])],
        );
        let is_touched = |row: &Vec<Fares>| row.contains(&Fares::Error);
        assert_eq!(
            fares(&rows).iter().map(is_touched).collect::<Vec<_>>(),
            [false, true, false]
        );
    }
}
