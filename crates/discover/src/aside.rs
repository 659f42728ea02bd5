//! Files that look like assets but are not checked as assets: helper tables of add-ons, and test
//! data (`docs/loaders/versions.md#whose-data-a-folder-is`).

use std::collections::{BTreeMap, BTreeSet};

use super::listing::{Listing, at};
use mhlint_diag::Application;
use mhlint_source::{extension, folder_and_name};

/// Why files that look like assets are not checked as assets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Aside {
    /// They are helper files of an add-on for making assets.
    Helpers,
    /// They are test data of a program; some are broken on purpose.
    Tests,
}

/// The folders in a listing that hold files which look like assets and are not, with the reason.
pub fn aside(listing: &Listing<'_>) -> BTreeMap<String, Aside> {
    let mut found = BTreeMap::new();
    let with = |wanted: &str| -> BTreeSet<&str> {
        let split = listing.files().map(folder_and_name);
        let own = split.filter(|(_, name)| extension(name) == wanted);
        own.map(|(folder, _)| folder).collect()
    };
    let beside = Beside {
        mirror: with("mirror"),
        clothes: with("mhclo"),
    };
    for file in listing.files() {
        let (folder, name) = folder_and_name(file);
        if is_helper(listing, folder, name, &beside) {
            found.insert(folder.to_owned(), Aside::Helpers);
        }
        if let Some(tests) = test_data(listing, file) {
            found.insert(tests, Aside::Tests);
        }
    }
    found
}

/// The folders with a `*.mirror` and those with a `*.mhclo`: they decide what other files in the
/// same folder are.
struct Beside<'l> {
    mirror: BTreeSet<&'l str>,
    clothes: BTreeSet<&'l str>,
}

/// Whether a file is a helper file that only an add-on has; the other files in its folder then
/// belong to the add-on as well.
fn is_helper(listing: &Listing<'_>, folder: &str, name: &str, beside: &Beside<'_>) -> bool {
    let has = |wanted: &str| listing.has(&at(folder, wanted));
    match extension(name) {
        "config" => name == "hm08.config" && has("tags.json"),
        "mhclo" if name.ends_with("helper.mhclo") => beside.mirror.contains(folder),
        "mhclo" => name.starts_with("a8_v69_"),
        "trg" => beside.clothes.contains(folder),
        _ => false,
    }
}

/// Where an application has its test data.
pub struct TestData {
    /// The folder with the test data, relative to the top of the source repository.
    pub folder: &'static str,
    /// The folder with the source of the application, relative to the top of the source repository.
    pub source: &'static str,
    /// The application.
    pub application: Application,
}

/// The test data of MPFB.
pub const TEST_DATA: TestData = TestData {
    folder: "test/testdata",
    source: "src/mpfb",
    application: Application::Mpfb,
};

/// The folder of test data that a file lies in, if the source of the application is beside that
/// folder.
fn test_data(listing: &Listing<'_>, file: &str) -> Option<String> {
    let TestData { folder, source, .. } = TEST_DATA;
    let start = format!("/{file}").find(&format!("/{folder}/"))?;
    let above = file.get(..start)?.trim_end_matches('/');
    listing
        .has_folder(&at(above, source))
        .then(|| at(above, folder))
}

/// Whether a file with the name of an asset is a table for fitting other assets: it has rows of
/// numbers, but neither a name nor a mesh, not even in a comment.
pub fn is_fitting_table(text: &[u8]) -> bool {
    let words = |line: &'_ [u8]| -> Vec<String> {
        let line = String::from_utf8_lossy(line);
        line.trim_start_matches(['#', ' ', '\t'])
            .split_whitespace()
            .take(4)
            .map(str::to_owned)
            .collect()
    };
    let mut rows = 0;
    for line in text.split(|byte| *byte == b'\n') {
        let words = words(line);
        match words.first().map(String::as_str) {
            Some("name" | "obj_file" | "uuid" | "material") => return false,
            Some(first) if first.parse::<u32>().is_ok() => rows += 1,
            _ => {}
        }
    }
    rows >= ROWS
}

/// A text with at least this many rows of numbers is a table.
const ROWS: usize = 3;

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[&str]) -> Vec<(String, Aside)> {
        aside(&Listing::of(files.iter().copied(), []))
            .into_iter()
            .collect()
    }

    #[test]
    fn signs_tell_and_names_of_folders_do_not() {
        let helpers = |folder: &str| vec![(folder.to_owned(), Aside::Helpers)];
        assert_eq!(
            found(&["x/data/hm08.config", "x/data/tags.json"]),
            helpers("x/data")
        );
        assert_eq!(
            found(&[
                "maketarget/data/hm08helper.mhclo",
                "maketarget/data/hm08.mirror"
            ]),
            helpers("maketarget/data")
        );
        assert_eq!(
            found(&["maketarget/data/helper.mhclo", "makeclothes/data/tags.json"]),
            []
        );
        assert_eq!(
            found(&["test/testdata/a.mhclo", "src/mpfb/__init__.py"]),
            [("test/testdata".to_owned(), Aside::Tests)]
        );
        assert_eq!(
            found(&["test/testdata/a.mhclo", "src/other/__init__.py"]),
            []
        );
    }

    #[test]
    fn a_table_has_rows_and_no_name() {
        assert!(is_fitting_table(b"# fits\nverts 0\n1\n2\n3\n"));
        assert!(!is_fitting_table(b"# name shirt\nverts 0\n1\n2\n3\n"));
        assert!(!is_fitting_table(b"verts 0\n1\n"));
    }
}
