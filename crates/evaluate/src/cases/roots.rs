//! The folders that file names in cases are relative to.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use crate::Error;
use mhlint_diag::{Application, nearest};
use mhlint_discover::{Layout, Use};
use mhlint_source::canonical;

/// The folder of a program with its data.
const DATA: &str = "data";

const NAMES: [&str; 4] = ["makehuman2", "makehuman1", "mpfb", "makehuman-assets"];

/// Folders of the programs and assets by name.
#[derive(Debug, Clone, Default)]
pub struct Roots {
    folders: BTreeMap<String, PathBuf>,
}

impl Roots {
    /// Takes names and folders; of several for one name the last.
    ///
    /// # Errors
    /// A name that cases do not use.
    pub fn new(folders: impl IntoIterator<Item = (String, PathBuf)>) -> Result<Self, Error> {
        let mut roots = Self::default();
        for (name, folder) in folders {
            if !NAMES.contains(&name.as_str()) {
                let meant = nearest(&name, NAMES)
                    .map_or(String::new(), |name| format!("; did you mean `{name}`?"));
                return Err(Error::Input(format!(
                    "unknown root `{name}`{meant} (known: {})",
                    NAMES.join(", ")
                )));
            }
            roots.folders.insert(name, folder);
        }
        Ok(roots)
    }

    /// The data folder of a program: the `data` in its folder, or that folder itself.
    pub(super) fn data(&self, application: Application) -> Result<PathBuf, Error> {
        Ok(inside(self.folder(application.word())?, DATA))
    }

    /// Where a file of a case of MakeHuman 2 is.
    pub(crate) fn file(&self, written: &str) -> Result<PathBuf, Error> {
        self.file_of(written, Application::Makehuman2)
    }

    /// Where a file of a case is. The name may end in ` (NAME)`; without, files of the assets begin
    /// with `base/`, and all others are those of the application.
    pub(crate) fn file_of(
        &self,
        written: &str,
        application: Application,
    ) -> Result<PathBuf, Error> {
        let marked = written
            .strip_suffix(')')
            .and_then(|text| text.rsplit_once(" ("));
        let (path, name) = match marked {
            Some((path, name)) => (path, name),
            None if written.starts_with("base/") => (written, "makehuman-assets"),
            None => (written, application.word()),
        };
        let mut parts = Vec::new();
        for part in Path::new(path).components() {
            match part {
                Component::Normal(part) => parts.push(part),
                Component::CurDir => {}
                _ => {
                    return Err(Error::Input(format!(
                        "`{path}` is outside the folder of {name}"
                    )));
                }
            }
        }
        let folder = self.folder(name)?;
        let [first, rest @ ..] = parts.as_slice() else {
            return Err(Error::Input("a file name in the cases is empty".to_owned()));
        };
        let mut place = inside(folder, first);
        place.extend(rest);
        Ok(place)
    }

    fn folder(&self, name: &str) -> Result<&Path, Error> {
        let missing = || {
            Error::Input(format!(
                "the folder of {name} is needed; use `--root {name}=DIR`"
            ))
        };
        self.folders
            .get(name)
            .map(PathBuf::as_path)
            .ok_or_else(missing)
    }
}

/// What an application has a file in its data for that a case names so.
pub(crate) fn use_of(written: &str, application: Application) -> Option<Use> {
    let below = written.strip_prefix(DATA)?.strip_prefix('/')?;
    Some(Layout::of(application).use_of(below))
}

/// `folder/first`, or `folder` where that is already it.
fn inside(folder: &Path, first: impl AsRef<Path>) -> PathBuf {
    let below = folder.join(&first);
    let is_it = folder
        .file_name()
        .is_some_and(|name| Path::new(name) == first.as_ref());
    if canonical(&below).is_none() && is_it {
        folder.to_path_buf()
    } else {
        below
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_to_their_folder() {
        let folder = |name: &str| (name.to_owned(), PathBuf::from(format!("/{name}")));
        let roots = Roots::new([folder("makehuman2"), folder("makehuman-assets")]).unwrap();
        let file = |name: &str| roots.file(name).map(|path| path.display().to_string());
        assert_eq!(file("data/a/b.mhw").unwrap(), "/makehuman2/data/a/b.mhw");
        assert_eq!(
            file("base/a.mhclo").unwrap(),
            "/makehuman-assets/base/a.mhclo"
        );
        assert_eq!(
            file("data/a.mhclo (makehuman2)").unwrap(),
            "/makehuman2/data/a.mhclo"
        );
        assert!(
            file("data/../../etc/passwd").is_err()
                && file("/etc/passwd").is_err()
                && file("").is_err()
        );
        assert!(
            file("x (mpfb)")
                .unwrap_err()
                .to_string()
                .contains("--root mpfb=DIR")
        );
        assert!(
            Roots::new([folder("makehuman3")])
                .unwrap_err()
                .to_string()
                .contains("makehuman2")
        );
    }
}
