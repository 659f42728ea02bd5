//! Versions of the applications, as far as their data or their loaders differ.

use std::fmt;

use serde::{Serialize, Serializer};

use super::Application;

/// A version of an application. Those of one application are ordered, the oldest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    application: Application,
    rank: usize,
}

/// Versions of MakeHuman 1, the oldest first. Those before 1.0 wrote data that nobody loads any
/// more.
const MAKEHUMAN1: [&str; 7] = ["alpha 6", "alpha 7", "alpha 8", "1.0", "1.1", "1.2", "1.3"];
/// Versions of MakeHuman 2, which has no numbers: years, and days of changes to what is loaded.
const MAKEHUMAN2: [&str; 4] = ["2024", "2025", "2026-08-05", "2026-08-20"];
/// Versions of MPFB.
const MPFB: [&str; 13] = [
    "2.0.5", "2.0.6", "2.0.7", "2.0.8", "2.0.9", "2.0.10", "2.0.11", "2.0.12", "2.0.13", "2.0.14",
    "2.0.15", "2.0.16", "2.0.17",
];

const fn all(application: Application) -> &'static [&'static str] {
    match application {
        Application::Makehuman1 => &MAKEHUMAN1,
        Application::Makehuman2 => &MAKEHUMAN2,
        Application::Mpfb => &MPFB,
    }
}

impl Version {
    /// The version of an application that is called so.
    pub fn named(application: Application, name: &str) -> Option<Self> {
        let rank = all(application).iter().position(|known| *known == name)?;
        Some(Self { application, rank })
    }

    /// Those that a run can be asked for: programs that load data of today.
    pub fn names(application: Application) -> impl Iterator<Item = &'static str> {
        all(application)
            .iter()
            .copied()
            .filter(|name| !name.starts_with("alpha"))
    }

    /// Whose version it is.
    pub const fn application(self) -> Application {
        self.application
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        all(self.application)
            .get(self.rank)
            .copied()
            .unwrap_or_default()
    }

    /// The application in this version as people say it: `MakeHuman 1.2`, `MakeHuman 2 of 2024`,
    /// `MPFB 2.0.14`.
    pub fn title(self) -> String {
        match (self.application, self.name()) {
            (Application::Makehuman1, name) if name.starts_with("1.") => {
                format!("MakeHuman {name}")
            }
            (Application::Mpfb, name) => format!("MPFB {name}"),
            (application, name) => format!("{application} of {name}"),
        }
    }

    /// Whether it is older than the version of its application that is called so.
    pub fn is_before(self, name: &str) -> bool {
        Self::named(self.application, name).is_some_and(|other| self.rank < other.rank)
    }

    /// Whether there is none after it.
    pub fn is_newest(self) -> bool {
        self.rank + 1 == all(self.application).len()
    }
}

/// An application, and perhaps a version of it: `makehuman1@1.2`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edition {
    /// Whose.
    pub application: Application,
    /// Which, where that is said.
    pub version: Option<Version>,
}

/// What is wrong with the name of an edition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditionFault {
    /// No application is called so.
    Application,
    /// The application has no version of that name that data can be checked for.
    Version(Application),
}

impl Edition {
    /// What `application` or `application@version` means.
    ///
    /// # Errors
    /// For a name that no application or version has.
    pub fn parse(text: &str) -> Result<Self, EditionFault> {
        let (word, name) = text
            .split_once('@')
            .map_or((text, None), |(word, name)| (word, Some(name)));
        let application = Application::ALL
            .into_iter()
            .find(|known| known.word() == word);
        let application = application.ok_or(EditionFault::Application)?;
        let Some(name) = name else {
            return Ok(Self {
                application,
                version: None,
            });
        };
        let known = Version::names(application).any(|known| known == name);
        let version = Version::named(application, name).filter(|_| known);
        version
            .map(|version| Self {
                application,
                version: Some(version),
            })
            .ok_or(EditionFault::Version(application))
    }

    /// Everything that can be asked for.
    pub fn all() -> Vec<String> {
        let versions = |one: Application| {
            Version::names(one).map(move |name| format!("{}@{name}", one.word()))
        };
        let all = Application::ALL.into_iter();
        all.flat_map(|one| std::iter::once(one.word().to_owned()).chain(versions(one)))
            .collect()
    }
}

impl fmt::Display for Edition {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.application.word())?;
        self.version
            .map_or(Ok(()), |version| write!(out, "@{}", version.name()))
    }
}

impl Serialize for Version {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_of_one_application_are_ordered() {
        let of = |name| Version::named(Application::Makehuman1, name).unwrap();
        assert!(
            of("1.1").is_before("1.3")
                && !of("1.3").is_before("1.3")
                && of("alpha 8").is_before("1.0")
        );
        assert!(of("1.3").is_newest() && !of("1.2").is_newest());
        assert!(
            !of("1.1").is_before("2.0.5"),
            "a name of another application"
        );
        assert_eq!(Version::named(Application::Mpfb, "1.1"), None);
        let edition = |text| Edition::parse(text).map(|one| one.version.map(Version::name));
        assert_eq!(
            (edition("mpfb"), edition("mpfb@2.0.14")),
            (Ok(None), Ok(Some("2.0.14")))
        );
        assert_eq!(
            edition("makehuman1@alpha 7"),
            Err(EditionFault::Version(Application::Makehuman1))
        );
        assert_eq!(edition("makehuman@1.1"), Err(EditionFault::Application));
        assert_eq!(
            Version::names(Application::Makehuman1).collect::<Vec<_>>(),
            ["1.0", "1.1", "1.2", "1.3"]
        );
    }
}
