//! Paths for the code hosts: they look for files from the top of the repository, wherever in it
//! mhlint runs.

use std::borrow::Cow;
use std::env;
use std::path::{Path, PathBuf};

use mhlint_diag::Outcome;
use mhlint_report::Format;
use mhlint_source::{normalized, slashed};

/// How paths that are relative to the working directory become relative to the top of the
/// repository.
struct Workspace {
    /// The top as it is and as the host names it, slashed. An absolute PATH argument may begin with
    /// it.
    tops: Vec<String>,
    /// The working directory, seen from the top.
    here: Option<String>,
}

/// The outcome with the paths that a code host wants in a report of this format.
pub(super) fn placed(outcome: &Outcome, format: Format) -> Cow<'_, Outcome> {
    let Some(workspace) = top(format).and_then(|top| Workspace::of(&top)) else {
        return Cow::Borrowed(outcome);
    };
    let mut placed = outcome.clone();
    for finding in &mut placed.findings {
        finding.path = workspace.path(&finding.path);
        if let Some(file) = finding
            .location
            .folder
            .as_mut()
            .and_then(|folder| folder.file.as_mut())
        {
            *file = workspace.path(file);
        }
        for related in &mut finding.related {
            related.path = workspace.path(&related.path);
        }
        for replaced in finding.fix.iter_mut().flat_map(|fix| &mut fix.replaced) {
            replaced.path = workspace.path(&replaced.path);
        }
    }
    Cow::Owned(placed)
}

/// The top of the repository, where a CI system says it.
fn top(format: Format) -> Option<PathBuf> {
    let names: &[&str] = match format {
        Format::Github => &["GITHUB_WORKSPACE"],
        Format::Gitlab => &["CI_PROJECT_DIR"],
        Format::Sarif => &["GITHUB_WORKSPACE", "CI_PROJECT_DIR"],
        _ => &[],
    };
    names
        .iter()
        .find_map(|name| env::var_os(name).filter(|value| !value.is_empty()))
        .map(PathBuf::from)
}

impl Workspace {
    fn of(top: &Path) -> Option<Self> {
        let real = top.canonicalize().ok()?;
        let here = env::current_dir()
            .and_then(|folder| folder.canonicalize())
            .ok()?;
        // A checkout in a folder of the workspace is what the host knows; a submodule has no such
        // folder.
        let inside = here
            .ancestors()
            .take_while(|above| above.starts_with(&real));
        let checkout = inside
            .into_iter()
            .find(|above| above.join(".git").is_dir())
            .unwrap_or(&real);
        let mut tops = vec![slashed(checkout), slashed(top)];
        tops.extend((checkout != real).then(|| slashed(&real)));
        Some(Self {
            tops,
            here: here.strip_prefix(checkout).ok().map(slashed),
        })
    }

    /// The path from the top; as it is where it leads elsewhere.
    fn path(&self, path: &str) -> String {
        let join = |here: &String| normalized(&format!("{here}/{path}"));
        let below = if Path::new(path).is_absolute() {
            self.cut(path)
        } else {
            self.here.as_ref().and_then(join)
        };
        below.unwrap_or_else(|| path.to_owned())
    }

    fn cut(&self, path: &str) -> Option<String> {
        let below = |top: &String| {
            let rest = path.strip_prefix(top.trim_end_matches('/'))?;
            if rest.is_empty() {
                Some(rest)
            } else {
                rest.strip_prefix('/')
            }
        };
        self.tops.iter().find_map(below).map(str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_seen_from_the_top() {
        let tops = vec!["/ci/repo/".to_owned(), "/mnt/repo".to_owned()];
        let inside = Workspace {
            tops,
            here: Some("assets/new".to_owned()),
        };
        let cases = [
            ("data/a.json", "assets/new/data/a.json"),
            ("", "assets/new"),
            ("../old/a b.json", "assets/old/a b.json"),
            ("../../a", "a"),
            ("../../../elsewhere/a", "../../../elsewhere/a"),
            ("/ci/repo/data/a", "data/a"),
            ("/mnt/repo/data/a", "data/a"),
            ("/ci/repository/a", "/ci/repository/a"),
        ];
        for (path, expected) in cases {
            assert_eq!(inside.path(path), expected, "{path}");
        }
        let outside = Workspace {
            here: None,
            ..inside
        };
        assert_eq!(outside.path("data/a"), "data/a");
    }
}
