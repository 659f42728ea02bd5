//! The house rules that a compiler does not check: who imports whom, who touches files, how long
//! files are.

mod imports;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use imports::{Crate, circles, used};

/// Where files may be opened; `engine/load/input.rs` turns PATH arguments into trees.
const MAY_OPEN_FILES: [&str; 4] = ["source/", "fix/", "cli/", "engine/load/input.rs"];

/// Libraries that only some places may know.
const LIBRARIES: [(&str, &[&str]); 8] = [
    ("clap", &["cli/"]),
    ("maud", &["report/html/"]),
    ("miette", &["report/human/block.rs"]),
    ("percent_encoding", &["report/sarif.rs"]),
    ("quick_xml", &["report/junit.rs"]),
    (
        "rayon",
        &[
            "engine/",
            "evaluate/gauge",
            "evaluate/formulas.rs",
            "evaluate/worn.rs",
        ],
    ),
    ("tempfile", &["cli/git.rs", "fix/"]),
    ("textwrap", &["report/human/block.rs"]),
];

/// Hard bounds in lines without tests.
const RULE_LINES: usize = 200;
const FILE_LINES: usize = 600;
const MAIN_LINES: usize = 40;

/// Most columns of a line, as rustfmt has it where it can.
const COLUMNS: usize = 100;
/// Where lines may be longer: rustfmt passes over markup, a text for users, and tables.
const WIDE: [&str; 3] = [
    "report/html/",
    "config/template.rs",
    "rules/cause/consequence/",
];

/// The wings of `engine`, and what each may import of the others.
const WINGS: &[(&str, &[&str])] = &[
    ("check", &["settle"]),
    ("load", &["settle"]),
    ("settle", &[]),
];

/// Folders of which a part belongs to an application.
const OF_APPLICATIONS: [&str; 4] = ["discover", "eval", "evaluate", "repo"];

/// Where what all applications have asks for the formulas of one; `evaluate/mod.rs` shows them to
/// users.
const DISPATCH: [&str; 4] = [
    "eval/macros.rs",
    "eval/skeleton.rs",
    "evaluate/formulas.rs",
    "evaluate/mod.rs",
];

/// A file of the program without its tests. Its path is that of its crate, without `crates` and
/// `src`; what it imports of other crates of ours reads as if all were one.
struct Source {
    path: String,
    code: String,
}

impl Source {
    fn code(&self) -> String {
        self.lines().collect::<Vec<_>>().join("\n")
    }

    fn is_rule(&self) -> bool {
        self.code.contains(": Rule =")
    }

    /// Code without comment lines.
    fn lines(&self) -> impl Iterator<Item = &str> {
        self.code
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"))
    }
}

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn sources() -> Vec<Source> {
    let members = fs::read_dir(project("crates"))
        .unwrap()
        .map(|member| member.unwrap().path());
    let named = members.map(|member| {
        (
            member.file_name().unwrap().to_str().unwrap().to_owned(),
            member.join("src"),
        )
    });
    let all = named.chain([(String::new(), project("src"))]);
    all.flat_map(|(member, folder)| {
        files_below(&folder)
            .into_iter()
            .filter_map(move |path| source(&member, &folder, &path))
    })
    .collect()
}

/// A file of a member; of the root if that has no name.
fn source(member: &str, folder: &Path, path: &Path) -> Option<Source> {
    path.extension().filter(|extension| *extension == "rs")?;
    let text = fs::read_to_string(path).unwrap();
    let code = text.split("\n#[cfg(test)]\nmod ").next().unwrap();
    let path = path.strip_prefix(folder).unwrap().to_str().unwrap();
    if member.is_empty() {
        return Some(Source {
            path: path.to_owned(),
            code: code.replace("mhlint_", "crate::"),
        });
    }
    let path = if path == "lib.rs" { "mod.rs" } else { path };
    let code = code
        .replace("crate::", &format!("crate::{member}::"))
        .replace("mhlint_", "crate::");
    Some(Source {
        path: format!("{member}/{path}"),
        code,
    })
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn folder_of(path: &str) -> Option<&str> {
    path.split_once('/').map(|(folder, _)| folder)
}

/// Cargo keeps to its lists; the page says the same, and why.
#[test]
fn the_page_on_the_house_has_the_dependencies_of_each_member() {
    let page = fs::read_to_string(project("docs/architecture.md")).unwrap();
    let mut members: Vec<PathBuf> = fs::read_dir(project("crates"))
        .unwrap()
        .map(|it| it.unwrap().path())
        .collect();
    members.sort();
    for member in members {
        let name = member.file_name().unwrap().to_str().unwrap();
        let manifest: toml::Table =
            toml::from_str(&fs::read_to_string(member.join("Cargo.toml")).unwrap()).unwrap();
        let needs = manifest.get("dependencies").and_then(toml::Value::as_table);
        let own = needs
            .into_iter()
            .flat_map(|needs| needs.keys())
            .filter_map(|name| name.strip_prefix("mhlint-"));
        let row = page
            .lines()
            .find_map(|line| line.strip_prefix(&format!("| `{name}` |")))
            .unwrap_or_default();
        let told: BTreeSet<&str> = row
            .split('|')
            .next()
            .into_iter()
            .flat_map(|cell| cell.split('`').skip(1).step_by(2))
            .collect();
        assert_eq!(told, own.collect(), "docs/architecture.md on `{name}`");
    }
}

/// `cargo test` in the root covers every member.
#[test]
fn the_tests_of_no_member_are_left_out() {
    let read = |path: PathBuf| -> toml::Table {
        toml::from_str(&fs::read_to_string(path).unwrap()).unwrap()
    };
    let workspace = &read(project("Cargo.toml"))["workspace"];
    assert_eq!(
        workspace["members"],
        toml::Value::from(vec!["crates/*", "schemas"])
    );
    assert_eq!(
        workspace["default-members"],
        toml::Value::from(vec![".", "crates/*", "schemas"])
    );
    for member in fs::read_dir(project("crates")).unwrap() {
        let manifest = read(member.unwrap().path().join("Cargo.toml"));
        let lib = manifest.get("lib").and_then(toml::Value::as_table);
        assert!(
            lib.is_none_or(|lib| !lib.contains_key("test") && !lib.contains_key("doctest")),
            "{manifest:?}"
        );
        assert_eq!(manifest["lints"]["workspace"], toml::Value::from(true));
    }
}

#[test]
fn the_table_has_no_circle() {
    let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    let edges = WINGS
        .iter()
        .map(|(name, allowed)| ((*name).to_owned(), owned(allowed)))
        .collect();
    assert_eq!(circles(&edges), Vec::<Vec<&str>>::new());
}

/// Folder below a folder, or file in it.
fn room<'p>(path: &'p str, folder: &str) -> Option<&'p str> {
    let rest = path.strip_prefix(folder)?.strip_prefix('/')?;
    let room = rest
        .split_once('/')
        .map_or(rest.trim_end_matches(".rs"), |(room, _)| room);
    (room != "mod").then_some(room)
}

/// Who imports whom of the rooms of a folder.
fn rooms(folder: &str) -> BTreeMap<String, BTreeSet<String>> {
    let sources = sources();
    let all = Crate::of(&sources);
    let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for source in &sources {
        let Some(own) = room(&source.path, folder) else {
            continue;
        };
        let others = all
            .imports(source)
            .into_iter()
            .filter_map(|path| room(path, folder))
            .filter(|other| *other != own);
        edges
            .entry(own.to_owned())
            .or_default()
            .extend(others.map(str::to_owned));
    }
    edges
}

#[test]
fn wings_of_the_engine_import_only_what_the_table_allows() {
    let edges = rooms("engine");
    for (wing, allowed) in WINGS {
        let others = edges.get(*wing).into_iter().flatten().map(String::as_str);
        let wings = others.filter(|other| WINGS.iter().any(|(name, _)| name == other));
        assert_eq!(
            wings
                .filter(|other| !allowed.contains(other))
                .collect::<Vec<_>>(),
            Vec::<&str>::new(),
            "{wing}"
        );
    }
    let folders = sources().into_iter().filter_map(|source| {
        Some(
            source
                .path
                .strip_prefix("engine/")?
                .split_once('/')?
                .0
                .to_owned(),
        )
    });
    let known: BTreeSet<String> = WINGS.iter().map(|(wing, _)| (*wing).to_owned()).collect();
    assert_eq!(
        folders.collect::<BTreeSet<_>>(),
        known,
        "the table of wings"
    );
}

/// The application in whose folder a file lies, such as `makehuman2` in `eval/makehuman2/rest.rs`.
fn application_of(path: &str) -> Option<&str> {
    let (folder, rest) = path.split_once('/')?;
    let (application, _) = rest
        .split_once('/')
        .filter(|_| OF_APPLICATIONS.contains(&folder))?;
    mhlint::Application::ALL
        .iter()
        .map(|one| one.word())
        .find(|word| *word == application)
}

/// What all applications have is evaluated without a look at one of them.
#[test]
fn formulas_of_an_application_are_asked_for_in_few_places() {
    let sources = sources();
    let all = Crate::of(&sources);
    let is_neutral = |source: &&Source| {
        let is_evaluation = matches!(folder_of(&source.path), Some("eval" | "evaluate"));
        is_evaluation
            && application_of(&source.path).is_none()
            && !DISPATCH.contains(&source.path.as_str())
    };
    let mut faults = Vec::new();
    for source in sources.iter().filter(is_neutral) {
        let own = all
            .imports(source)
            .into_iter()
            .filter(|other| application_of(other).is_some());
        faults.extend(own.map(|other| format!("{} imports {other}", source.path)));
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// Folders below folders, each with what lies beside it. Of what all applications have and what is
/// one's own each knows the other: those folders are left out.
#[test]
fn folders_and_the_files_beside_them_import_in_no_circle() {
    let folders: BTreeSet<String> = sources()
        .iter()
        .filter_map(|source| Some(source.path.rsplit_once('/')?.0.to_owned()))
        .collect();
    let inner = |folder: &&String| {
        folders
            .iter()
            .any(|other| room(&format!("{other}/x"), folder).is_some())
    };
    let with_folders = folders
        .iter()
        .filter(inner)
        .filter(|folder| !OF_APPLICATIONS.contains(&folder.as_str()));
    let mut found = Vec::new();
    for folder in with_folders {
        let edges = rooms(folder);
        let is_folder = |room: &&str| folders.contains(&format!("{folder}/{room}"));
        let circles = circles(&edges)
            .into_iter()
            .filter(|circle| circle.iter().any(is_folder));
        found.extend(circles.map(|circle| format!("{folder}: {circle:?}")));
    }
    assert_eq!(found, Vec::<String>::new());
}

#[test]
fn an_import_is_noticed_however_it_is_written() {
    let file = |path: &str, code: &str| Source {
        path: path.to_owned(),
        code: code.to_owned(),
    };
    let sources = [
        file(
            "lib.rs",
            "pub use engine::Outcome;\npub use config::Config;",
        ),
        file(
            "engine/mod.rs",
            "mod load;\npub use crate::eval::SAMPLES;\npub(crate) use outcome::Outcome as Outcome;",
        ),
        file("engine/outcome.rs", "pub struct Outcome;"),
        file("engine/load/mod.rs", "use super::outcome::Outcome;"),
        file(
            "engine/load/read.rs",
            "use super::super::outcome;\nuse super::super::super::report::x;",
        ),
        file("config/mod.rs", "pub struct Config;"),
        file("eval/mod.rs", "pub const SAMPLES: usize = 1;"),
        file(
            "report/mod.rs",
            "use crate::{\n    Config,\n    engine::{Outcome, SAMPLES},\n};\nuse std::fs;",
        ),
        file(
            "cli.rs",
            "fn f() { crate::engine::SAMPLES }\npub(super) fn g() {}",
        ),
    ];
    let all = Crate::of(&sources);
    let of = |number: usize| {
        all.imports(&sources[number])
            .into_iter()
            .collect::<Vec<_>>()
    };
    assert_eq!(of(3), ["engine/mod.rs", "engine/outcome.rs"].split_at(1).1);
    assert_eq!(of(4), ["engine/outcome.rs", "report/mod.rs"]);
    assert_eq!(
        of(7),
        [
            "config/mod.rs",
            "engine/mod.rs",
            "engine/outcome.rs",
            "eval/mod.rs"
        ]
    );
    assert_eq!(of(8), ["engine/mod.rs", "eval/mod.rs"]);
    let edges = [("a", "b"), ("b", "c"), ("c", "a"), ("d", "a")];
    let edges = edges
        .map(|(from, to)| (from.to_owned(), BTreeSet::from([to.to_owned()])))
        .into();
    assert_eq!(circles(&edges), [["a", "b", "c"]]);
    assert_eq!(used("pub use a::b as c;").len(), 1);
}

#[test]
fn files_are_opened_in_few_places() {
    let opens = |line: &str| {
        line.contains("std::fs") || line.contains("File::open") || line.contains("walkdir::")
    };
    let allowed = |source: &Source| {
        MAY_OPEN_FILES
            .iter()
            .any(|place| source.path.starts_with(place))
    };
    let faults: Vec<String> = sources()
        .into_iter()
        .filter(|s| !allowed(s) && s.lines().any(opens))
        .map(|s| s.path)
        .collect();
    assert_eq!(faults, Vec::<String>::new());
}

#[test]
fn libraries_stay_behind_their_file() {
    for (library, places) in LIBRARIES {
        let names = |source: &Source| {
            source
                .lines()
                .any(|line| line.contains(&format!("{library}::")))
        };
        let users = sources()
            .into_iter()
            .filter(names)
            .map(|source| source.path);
        let strangers: Vec<String> = users
            .filter(|path| !places.iter().any(|place| path.starts_with(place)))
            .collect();
        assert_eq!(
            strangers,
            Vec::<String>::new(),
            "{library} belongs to {places:?}"
        );
    }
}

#[test]
fn files_stay_short() {
    let mut faults = Vec::new();
    for source in sources() {
        let bound = match source.path.as_str() {
            "main.rs" => MAIN_LINES,
            path if path.starts_with("rules/") && source.is_rule() => RULE_LINES,
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
fn lines_stay_short() {
    let mut faults = Vec::new();
    for source in sources() {
        if WIDE.iter().any(|wide| source.path.starts_with(wide)) {
            continue;
        }
        // As it stands in the file.
        let member = source.path.split('/').next().unwrap();
        let code = source
            .code
            .replace(&format!("crate::{member}::"), "crate::");
        let lines = code.lines().zip(1..);
        let long = lines.filter(|(line, _)| line.chars().count() > COLUMNS);
        faults.extend(long.map(|(_, number)| format!("{}:{number}", source.path)));
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn every_module_says_what_it_is() {
    let silent = sources()
        .into_iter()
        .filter(|source| !source.code.starts_with("//!"));
    assert_eq!(
        silent.map(|source| source.path).collect::<Vec<_>>(),
        Vec::<String>::new()
    );
}

#[test]
fn every_rule_file_has_its_row() {
    let families = sources()
        .into_iter()
        .filter(|source| source.path.ends_with("/mod.rs"));
    let rows = families.flat_map(|family| {
        let table = family
            .code
            .split_once("static RULES: &[&Rule] =")
            .map(|(_, rest)| rest.to_owned());
        let rows = table.unwrap_or_default();
        let rows = rows
            .split_once("];")
            .map_or("", |(rows, _)| rows.trim_start().trim_start_matches("&["));
        let row = |row: &str| {
            let (file, _) = row.trim().strip_prefix('&')?.split_once("::")?;
            Some(file.to_owned())
        };
        let folder = family.path.trim_end_matches("mod.rs").to_owned();
        rows.split(',')
            .filter_map(row)
            .map(|name| format!("{folder}{name}.rs"))
            .collect::<Vec<_>>()
    });
    let rows: BTreeSet<String> = rows.collect();
    let files: BTreeSet<String> = sources()
        .into_iter()
        .filter(Source::is_rule)
        .map(|source| source.path)
        .collect();
    let faults: Vec<_> = rows.symmetric_difference(&files).collect();
    assert!(
        faults.is_empty(),
        "a row without a file, or the other way round: {faults:?}"
    );
}

/// The file of a rule has the name of its fault; where a file has several rules, it has that of
/// what they have in common.
#[test]
fn a_rule_is_found_by_its_id() {
    // What Rust keeps for itself.
    let reserved = [("material-type", "value_type"), ("rig-enum", "enums")];
    for source in sources()
        .iter()
        .filter(|source| source.path.starts_with("rules/"))
    {
        let new = source.code.split("RuleInfo::new(").skip(1);
        // A name that stands elsewhere is none here.
        let ids = new.filter_map(|rest| rest.trim_start().strip_prefix('"')?.split('"').next());
        let ids: Vec<&str> = ids.collect();
        let [id] = ids.as_slice() else { continue };
        let folders: Vec<&str> = source.path.trim_end_matches(".rs").split('/').collect();
        let ([_, family, ..], Some(file)) = (folders.as_slice(), folders.last()) else {
            continue;
        };
        let family = if *family == "macros" { "macro" } else { family };
        let reserved = reserved
            .iter()
            .find(|(other, _)| other == id)
            .map(|(_, file)| (*file).to_owned());
        let fault = || {
            id.strip_prefix(&format!("{}-", family.replace('_', "-")))
                .map(|fault| fault.replace('-', "_"))
        };
        let of_other_family = || id.replace('-', "_");
        assert_eq!(
            *file,
            reserved.or_else(fault).unwrap_or_else(of_other_family),
            "{id} in {}",
            source.path
        );
    }
}

/// What two rules need lies in a file beside them, and that file needs no rule.
#[test]
fn nothing_imports_a_rule() {
    let sources = sources();
    let all = Crate::of(&sources);
    let rules: BTreeSet<&str> = sources
        .iter()
        .filter(|source| source.is_rule())
        .map(|source| source.path.as_str())
        .collect();
    // The table of a family lists them.
    let is_table = |path: &str| path.ends_with("/mod.rs");
    let others = sources.iter().filter(|source| !is_table(&source.path));
    let imports = |source| {
        all.imports(source)
            .into_iter()
            .map(move |other: &str| (source.path.as_str(), other))
    };
    let faults: Vec<_> = others
        .flat_map(imports)
        .filter(|(_, other)| rules.contains(other))
        .collect();
    assert_eq!(faults, []);
}

/// Names of the code of one application.
const NAMES: [&str; 6] = [
    "makehuman1::",
    "makehuman2::",
    "mpfb::",
    "Application::Makehuman",
    "Application::Mpfb",
    ".makehuman2()",
];

fn names_one(line: &str) -> bool {
    NAMES.iter().any(|name| line.contains(name))
}

/// A rule on what all applications have.
fn is_shared(source: &Source) -> bool {
    const SHARED: [&str; 4] = [
        "Check::File(",
        "Check::Body(",
        "Check::Numeric(",
        "Check::Repository(",
    ];
    source.is_rule() && SHARED.iter().any(|check| source.code.contains(check))
}

/// What stands behind a `const`, but for the constant itself if that is a case.
fn without_case(item: &str) -> &str {
    let is_case = item
        .lines()
        .next()
        .is_some_and(|line| line.contains(": Case ="));
    if is_case {
        item.split_once(";\n").map_or("", |(_, rest)| rest)
    } else {
        item
    }
}

/// A rule over what all applications have takes it as the views offer it; who does what is data:
/// its `breaks` and cases.
#[test]
fn rules_over_what_all_have_open_no_application() {
    let opens = |source: &Source| {
        let (head, rule) = source.code.split_once("static RULE").unwrap();
        let (_, body) = rule.split_once("\n});\n").unwrap();
        let is_code = |line: &&str| !line.trim_start().starts_with("//");
        // The variants are imported for `breaks` and cases.
        let mut imports = head
            .lines()
            .filter(is_code)
            .map(|line| line.replace("Application::", ""));
        let mut code = body
            .split("\nconst ")
            .map(without_case)
            .flat_map(str::lines)
            .filter(is_code);
        let names_variant = |line: &str| {
            ["Makehuman1", "Makehuman2", "Mpfb"]
                .iter()
                .any(|name| line.contains(name))
        };
        imports.any(|line| names_one(&line))
            || code.any(|line| names_one(line) || names_variant(line))
    };
    let faults = sources()
        .into_iter()
        .filter(|source| is_shared(source) && opens(source))
        .map(|source| source.path);
    assert_eq!(faults.collect::<Vec<_>>(), Vec::<String>::new());
}

/// A level or words without an application would be told for every one that a rule is for.
#[test]
fn what_several_applications_have_is_told_by_application() {
    let folder = |source: &Source| {
        source
            .path
            .rsplit_once('/')
            .unwrap_or_default()
            .0
            .to_owned()
    };
    let sources = sources();
    let mut folders: BTreeSet<String> = sources
        .iter()
        .filter(|source| is_shared(source))
        .map(folder)
        .collect();
    folders.insert("rules/cause/consequence".to_owned());
    let is_told = |source: &&Source| {
        is_shared(source) || !source.is_rule() && folders.contains(&folder(source))
    };
    let speaks = |source: &&Source| {
        [".level(", ".effect("]
            .iter()
            .any(|call| source.code.contains(call))
    };
    let faults = sources
        .iter()
        .filter(is_told)
        .filter(speaks)
        .map(|source| source.path.as_str());
    assert_eq!(faults.collect::<Vec<_>>(), Vec::<&str>::new());
}

/// Only the list of what is checked names applications there.
#[test]
fn the_engine_knows_no_application() {
    let in_engine = |source: &Source| {
        source.path.starts_with("engine/") && source.path != "engine/catalogue.rs"
    };
    let faults = sources()
        .into_iter()
        .filter(|source| in_engine(source) && source.lines().any(names_one));
    assert_eq!(
        faults.map(|source| source.path).collect::<Vec<_>>(),
        Vec::<String>::new()
    );
}

/// How far a rule sees, or what it is for, is data of the rule: a new family brings its own.
#[test]
fn what_runs_the_rules_names_none_of_them() {
    let of_rules = |source: &Source| source.path.starts_with("rules/");
    let (rules, others): (Vec<Source>, Vec<Source>) = sources().into_iter().partition(of_rules);
    let ids = rules
        .iter()
        .filter_map(|rule| rule.code.split_once("RuleInfo::new(")?.1.split('"').nth(1));
    let families: BTreeSet<String> = ids
        .filter_map(|id| id.split_once('-').map(|(family, _)| format!("\"{family}-")))
        .collect();
    assert!(families.contains("\"target-"), "{families:?}");
    let names_one = |line: &str| families.iter().any(|family| line.contains(family));
    let engine = others
        .iter()
        .filter(|source| source.path.starts_with("engine/"));
    let faults: Vec<&str> = engine
        .filter(|source| source.lines().any(names_one))
        .map(|source| source.path.as_str())
        .collect();
    assert_eq!(faults, Vec::<&str>::new());
}

#[test]
fn every_dependency_has_its_reason() {
    let manifest: toml::Table =
        toml::from_str(&fs::read_to_string(project("Cargo.toml")).unwrap()).unwrap();
    let reasons = fs::read_to_string(project("docs/dependencies.md")).unwrap();
    let all = manifest["workspace"]["dependencies"]
        .as_table()
        .unwrap()
        .keys();
    for name in all.filter(|name| !name.starts_with("mhlint-")) {
        assert!(
            reasons.contains(&format!("| `{name}` |")),
            "docs/dependencies.md lacks `{name}`"
        );
    }
}
