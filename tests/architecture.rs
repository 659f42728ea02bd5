//! The house rules that a compiler does not check: who imports whom, who touches files, how long files are.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]

mod scratch;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use scratch::project;

/// What each folder of `src/` may import from the others. `docs/architecture.md` explains the table.
const IMPORTS: &[(&str, &[&str])] = &[
    ("diag", &[]),
    ("json", &["diag"]),
    ("source", &["diag"]),
    ("config", &["diag", "source", "json"]),
    ("discover", &["diag", "source"]),
    ("formats", &["diag", "json", "source", "discover"]),
    ("repo", &["diag", "json", "source", "discover", "formats"]),
    ("fix", &["diag", "source"]),
    ("eval", &[]),
    ("evaluate", &["diag", "json", "source", "config", "discover", "formats", "repo", "eval"]),
    ("rules", &["diag", "json", "source", "discover", "formats", "repo", "eval"]),
    (
        "engine",
        &["diag", "json", "source", "config", "fix", "discover", "formats", "repo", "eval", "evaluate", "rules"],
    ),
    ("report", &["diag"]),
    ("cli", &["diag", "json", "source", "config", "fix", "evaluate", "engine", "report"]),
];

/// Where files may be opened; `engine/load/input.rs` turns PATH arguments into trees.
const MAY_OPEN_FILES: [&str; 4] = ["source/", "fix/", "cli/", "engine/load/input.rs"];

/// Libraries that only some places may know.
const LIBRARIES: [(&str, &[&str]); 8] = [
    ("clap", &["cli/"]),
    ("maud", &["report/html/"]),
    ("miette", &["report/human/block.rs"]),
    ("percent_encoding", &["report/sarif.rs"]),
    ("quick_xml", &["report/junit.rs"]),
    ("rayon", &["engine/", "evaluate/gauge"]),
    ("tempfile", &["fix/"]),
    ("textwrap", &["report/human/block.rs"]),
];

/// Hard bounds in lines without tests.
const RULE_LINES: usize = 150;
const FILE_LINES: usize = 400;
const MAIN_LINES: usize = 40;

/// A file of `src/` without its tests.
struct Source {
    path: String,
    code: String,
}

impl Source {
    fn folder(&self) -> Option<&str> {
        self.path.split_once('/').map(|(folder, _)| folder)
    }

    /// Code without comment lines.
    fn lines(&self) -> impl Iterator<Item = &str> {
        self.code.lines().filter(|line| !line.trim_start().starts_with("//"))
    }
}

fn sources() -> Vec<Source> {
    let root = project("src");
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let code = text.split("\n#[cfg(test)]\nmod ").next().unwrap().to_owned();
        Source { path: path.strip_prefix(&root).unwrap().to_str().unwrap().to_owned(), code }
    };
    files_below(&root).into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs")).map(read).collect()
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { files.extend(files_below(&path)) } else { files.push(path) }
    }
    files.sort();
    files
}

/// The modules named behind each `crate::`, `crate::{a, b::c}` over several lines included.
fn imported(code: &str) -> Vec<&str> {
    let word = |text: &str| text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').count();
    let mut found = Vec::new();
    for (at, start) in code.match_indices("crate::") {
        let rest = &code[at + start.len()..];
        let list: Vec<&str> = match rest.strip_prefix('{') {
            Some(inner) => inner.split(';').next().unwrap().split(',').map(str::trim_start).collect(),
            None => vec![rest],
        };
        found.extend(list.into_iter().map(|part| &part[..word(part)]).filter(|part| !part.is_empty()));
    }
    found
}

#[test]
fn folders_import_only_what_the_table_allows() {
    let mut faults = Vec::new();
    for source in sources() {
        let Some(folder) = source.folder() else { continue };
        let row = IMPORTS.iter().find(|(name, _)| *name == folder);
        let (_, allowed) = row.unwrap_or_else(|| panic!("folder `{folder}` is not in the table of imports"));
        let code: Vec<&str> = source.lines().collect();
        for module in imported(&code.join("\n")) {
            let is_folder = IMPORTS.iter().any(|(name, _)| *name == module);
            if is_folder && module != folder && !allowed.contains(&module) {
                faults.push(format!("{} imports {module}", source.path));
            }
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn the_table_would_notice_an_import() {
    assert_eq!(imported("use crate::engine::Outcome;"), ["engine"]);
    assert_eq!(imported("    crate::report::printable(line)"), ["report"]);
    assert_eq!(imported("use crate::{\n    diag::Level,\n    repo::Base,\n};"), ["diag", "repo"]);
    assert_eq!(imported("pub(crate) fn x()"), Vec::<&str>::new());
}

#[test]
fn no_path_climbs_out_of_its_folder() {
    let mut faults = Vec::new();
    for source in sources() {
        let depth = source.path.matches('/').count() + usize::from(!source.path.ends_with("mod.rs"));
        for line in source.lines() {
            let climbs = line.matches("super::").count();
            if line.contains("super::super::") && climbs >= depth {
                faults.push(format!("{}: {}", source.path, line.trim()));
            }
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn files_are_opened_in_few_places() {
    let opens = |line: &str| line.contains("std::fs") || line.contains("File::open") || line.contains("walkdir::");
    let allowed = |source: &Source| MAY_OPEN_FILES.iter().any(|place| source.path.starts_with(place));
    let faults: Vec<String> =
        sources().into_iter().filter(|s| !allowed(s) && s.lines().any(opens)).map(|s| s.path).collect();
    assert_eq!(faults, Vec::<String>::new());
}

#[test]
fn libraries_stay_behind_their_file() {
    for (library, places) in LIBRARIES {
        let names = |source: &Source| source.lines().any(|line| line.contains(&format!("{library}::")));
        let users = sources().into_iter().filter(names).map(|source| source.path);
        let strangers: Vec<String> = users.filter(|path| !places.iter().any(|place| path.starts_with(place))).collect();
        assert_eq!(strangers, Vec::<String>::new(), "{library} belongs to {places:?}");
    }
}

#[test]
fn files_stay_short() {
    let mut faults = Vec::new();
    for source in sources() {
        let bound = match source.path.as_str() {
            "main.rs" => MAIN_LINES,
            path if path.starts_with("rules/") && source.code.contains("static RULE: Rule") => RULE_LINES,
            _ => FILE_LINES,
        };
        let lines = source.code.lines().count();
        if lines > bound {
            faults.push(format!("{}: {lines} lines, bound {bound}", source.path));
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn every_module_says_what_it_is() {
    let silent = sources().into_iter().filter(|source| !source.code.starts_with("//!"));
    assert_eq!(silent.map(|source| source.path).collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn every_rule_file_has_its_row() {
    let table = fs::read_to_string(project("src/rules/mod.rs")).unwrap();
    let rows: BTreeSet<String> = table
        .split("::RULE")
        .filter_map(|text| text.rsplit_once('&').map(|(_, path)| format!("rules/{}.rs", path.replace("::", "/"))))
        .collect();
    let is_rule = |source: &Source| source.code.contains("static RULE: Rule");
    let files: BTreeSet<String> = sources().into_iter().filter(is_rule).map(|source| source.path).collect();
    assert_eq!(rows, files);
}

/// What two rules need lies in a file beside them.
#[test]
fn no_rule_imports_another_rule() {
    let rules: Vec<Source> = sources().into_iter().filter(|source| source.code.contains("static RULE: Rule")).collect();
    let name = |source: &Source| source.path["rules/".len()..].trim_end_matches(".rs").replace('/', "::");
    let names: BTreeSet<String> = rules.iter().map(name).collect();
    let mut faults = Vec::new();
    for rule in &rules {
        let own = name(rule);
        let family = own.split("::").next().unwrap();
        for (module, word) in neighbours(&rule.code, family) {
            if module != own && names.contains(&module) {
                faults.push(format!("{} imports {word}", rule.path));
            }
        }
    }
    assert_eq!(faults, Vec::<String>::new());
    let found = |code: &str| neighbours(code, "target").into_iter().map(|(module, _)| module).collect::<Vec<_>>();
    assert!(found("use super::{a, syntax};").contains(&"target::syntax".to_owned()));
    assert!(found("use super::super::file::empty::x;").contains(&"file::empty".to_owned()));
}

/// What stands behind each `super::` of a rule file, as a module below `rules`, and as it is written.
fn neighbours<'c>(code: &'c str, family: &str) -> Vec<(String, &'c str)> {
    let mut found = Vec::new();
    for (at, start) in code.match_indices("super::") {
        let rest = &code[at + start.len()..];
        let words: Vec<&str> = match rest.strip_prefix('{') {
            Some(list) => list.split('}').next().unwrap().split(',').map(str::trim).collect(),
            None => vec![rest.split(|c: char| !c.is_alphanumeric() && !"_:".contains(c)).next().unwrap()],
        };
        for word in words {
            let parts: Vec<&str> = word.split("::").collect();
            found.push((format!("{family}::{}", parts[0]), word));
            found.extend(parts.get(1).map(|second| (format!("{}::{second}", parts[0]), word)));
        }
    }
    found
}

/// How far a rule sees, or what it is for, is data of the rule: a new family brings its own.
#[test]
fn what_runs_the_rules_names_none_of_them() {
    let of_rules = |source: &Source| source.path.starts_with("rules/");
    let (rules, others): (Vec<Source>, Vec<Source>) = sources().into_iter().partition(of_rules);
    let ids = rules.iter().filter_map(|rule| rule.code.split_once("RuleInfo::new(")?.1.split('"').nth(1));
    let families: BTreeSet<String> =
        ids.filter_map(|id| id.split_once('-').map(|(family, _)| format!("\"{family}-"))).collect();
    assert!(families.contains("\"target-"), "{families:?}");
    let names_one = |line: &str| families.iter().any(|family| line.contains(family));
    let engine = others.iter().filter(|source| source.path.starts_with("engine/"));
    let faults: Vec<&str> =
        engine.filter(|source| source.lines().any(names_one)).map(|source| source.path.as_str()).collect();
    assert_eq!(faults, Vec::<&str>::new());
}

#[test]
fn every_dependency_has_its_reason() {
    let manifest: toml::Table = toml::from_str(&fs::read_to_string(project("Cargo.toml")).unwrap()).unwrap();
    let reasons = fs::read_to_string(project("docs/dependencies.md")).unwrap();
    for section in ["dependencies", "dev-dependencies"] {
        for name in manifest[section].as_table().unwrap().keys() {
            assert!(reasons.contains(&format!("| `{name}` |")), "docs/dependencies.md lacks `{name}`");
        }
    }
}
