//! What is generated is fresh: the families of rules and the help in the README, the table and
//! pages of the rules, the samples of the reports.
//!
//! `UPDATE=1 cargo test generated::` rewrites them.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use crate::mixed::{APPLICATIONS, side_by_side};
use crate::scratch::{Case, edit, example, mhlint, project};

#[test]
fn every_rule_is_in_the_table() {
    let rules = mhlint(&project("."), &["rules", "--format", "markdown"]).stdout;
    let mut table = String::from_utf8(rules).unwrap();
    for rule in mhlint::rule_infos() {
        let [id, family] = [rule.id, rule.family()];
        table = table.replace(
            &format!("| `{id}` |"),
            &format!("| [`{id}`](rules/{family}.md#{id}) |"),
        );
    }
    check("docs/rules.md", "rules", &table);
}

#[test]
fn every_rule_has_its_section_on_the_page_of_its_family() {
    let mut pages: BTreeMap<String, usize> = BTreeMap::new();
    for rule in mhlint::rule_infos() {
        *pages.entry(rule.family().to_owned()).or_default() += 1;
    }
    let mut list = "| family | | on |\n|---|---|---|\n".to_owned();
    for (family, count) in &pages {
        let about = about(family);
        let noun = if *count == 1 { "rule" } else { "rules" };
        writeln!(
            list,
            "| [`{family}`](rules/{family}.md) | {count} {noun} | {about} |"
        )
        .unwrap();
        let explain = ["explain", &format!("{family}-"), "--format", "markdown"];
        let sections = String::from_utf8(mhlint(&project("."), &explain).stdout).unwrap();
        let head = format!(
            "# Rules: {family}\n\nOn {about}. [All families](../rules.md), [how levels are chosen](../levels.md).\n\n\
             <!-- Written by tests/all/generated.rs from the rules and their fixtures; edits here are lost. -->\n\n"
        );
        check_file(
            &format!("docs/rules/{family}.md"),
            &format!("{head}{sections}"),
        );
    }
    check("docs/rules.md", "families", &list);
    check(
        "README.md",
        "families",
        &list.replace("](rules/", "](docs/rules/"),
    );
    for entry in fs::read_dir(project("docs/rules")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let family = name.strip_suffix(".md").unwrap_or(&name);
        assert!(
            pages.contains_key(family),
            "docs/rules/{name} belongs to no family of rules"
        );
    }
}

/// What the rules of a family check.
fn about(family: &str) -> &'static str {
    match family {
        "archive" => {
            "archives of targets (`compressedtargets.npz`, `targets.npz`), of base meshes and of assets (`.mhbin`), and zips of assets"
        }
        "base" => "the settings of a base mesh: `base.json`, `geometry.json` and what they name",
        "baseline" => "the baseline of mhlint itself",
        "bvh" => "motions (`.bvh`)",
        "catalog" => "sliders of MPFB: `target.json` and the targets it names",
        "config" => "ignores and levels in `mhlint.toml`",
        "expression" => {
            "expressions of MPFB (`expressions/**/*.json`) and the targets of their units"
        }
        "file" => "files as such: names, references, links, encodings, packing",
        "filter" => "the labels by which assets are chosen (`selection_filter.json`)",
        "ink" => "ink layers of MPFB (`ink_layers/**/*.json`)",
        "json" => "JSON as such: syntax, schema, keys",
        "library" => "what makes a folder of assets a library: names, identities, places, pictures",
        "macro" => "macro targets: `macro.json` and the combinations it names",
        "material" => "materials (`.mhmat`) and the textures they name",
        "mesh" => "base meshes (`base.obj`, packed in `base.mhbin`) and meshes of assets",
        "metadata" => "what MPFB knows of its base mesh besides the OBJ (`mesh_metadata/`)",
        "model" => "saved characters (`.mhm`)",
        "modelling" => "sliders: `modelling.json` and `target_cat.json`",
        "modifiers" => {
            "modifiers of MakeHuman 1 (`*_modifiers.json`) with their descriptions and sliders"
        }
        "numeric" => {
            "the evaluated figure: shapes, joints and weights over the range of the sliders"
        }
        "overlay" => "user data over system data",
        "pack" => {
            "zips of assets as MakeHuman 2 and MPFB import them, and the lists of packs of MPFB"
        }
        "parts" => "the macro settings of MPFB: `macro.json`, its parts and the targets it needs",
        "pose" => {
            "poses, expressions, what they are made of (`body-poses.json`, `face-poses.json`), and motions"
        }
        "preset" => "saved characters of MPFB (`human.*.json`)",
        "program" => "files of the programs themselves",
        "proxy" => "clothes, hair, eyes and topologies (`.mhclo`, `.proxy`) with what they name",
        "rig" => {
            "rigs of MPFB: bones on the base mesh, those of users, and those of assets (`.mpfbskel`)"
        }
        "scene" => {
            "scenes of MakeHuman 1 (`.mhscene`), and the lists of its libraries (`cache/*.mhc`)"
        }
        "skeleton" => "skeletons (`.mhskel`)",
        "target" => "targets (`.target`)",
        "uv" => "UV layers of MPFB (`uv_layers/*.json.gz`)",
        "weights" => "weights (`.mhw`)",
        _ => panic!("say in tests/all/generated.rs what the rules of the family `{family}` check"),
    }
}

#[test]
fn readme_holds_the_help() {
    let help = String::from_utf8(mhlint(&project("."), &["--help"]).stdout).unwrap();
    let lines: Vec<&str> = help.lines().map(str::trim_end).collect();
    check(
        "README.md",
        "help",
        &format!("```text\n{}\n```\n", lines.join("\n").trim_end()),
    );
}

/// On a terminal that draws; the test itself has none.
#[test]
fn the_sample_of_the_readme_is_what_a_terminal_shows() {
    let repository = example();
    Case::read(&project("fixtures/rules/macro-steps-length/bad")).apply(repository.path());
    let tree = mhlint::Tree::on_disk("data", repository.path().join("data"), |_, _, _| false);
    let config = mhlint::Config::default();
    let outcome = mhlint::lint_trees(vec![tree], None, &config).unwrap();
    let view = mhlint::report::View {
        pass: false,
        fail_on: config.fail_on,
        max_warnings: None,
        color: false,
        unicode: true,
        width: 80,
        quiet: false,
        full: false,
        statistics: false,
        rules: &mhlint::rule_infos(),
    };
    let mut sample = Vec::new();
    mhlint::report::write(mhlint::report::Format::Human, &outcome, &view, &mut sample).unwrap();
    let sample = String::from_utf8(sample).unwrap();
    check(
        "README.md",
        "sample",
        &format!("```text\n$ mhlint data\n{}\n```\n", sample.trim_end()),
    );
}

/// A fault of MPFB in a repository of all three applications.
#[test]
fn the_sample_of_several_applications_is_what_is_printed() {
    let repository = side_by_side(&APPLICATIONS, &[]);
    edit(repository.path(), "mpfb/data/targets/target.json", "{", "");
    let report = String::from_utf8(mhlint(repository.path(), &["."]).stdout).unwrap();
    let (_, matrix) = report.split_once("loaded by").unwrap();
    let sample = format!("$ mhlint .\n…\nloaded by{}", matrix.trim_end());
    check("README.md", "mixed", &format!("```text\n{sample}\n```\n"));
}

#[test]
fn the_samples_of_the_reports_are_what_is_written() {
    let repository = example();
    Case::read(&project("fixtures/rules/macro-steps-length/bad")).apply(repository.path());
    let formats = [
        ("human", "text"),
        ("concise", "text"),
        ("json", "json"),
        ("sarif", "json"),
        ("github", "text"),
        ("gitlab", "json"),
        ("junit", "xml"),
        ("markdown", "markdown"),
    ];
    for (format, language) in formats {
        // These list every file that is loaded.
        let path = if matches!(format, "json" | "sarif") {
            "data/target/figure/macro.json"
        } else {
            "data"
        };
        let args = [path, "--only", "macro-steps-length", "--report", format];
        let sample = String::from_utf8(mhlint(repository.path(), &args).stdout).unwrap();
        check(
            "docs/reports.md",
            format,
            &format!("````{language}\n{}\n````\n", sample.trim_end()),
        );
    }
}

#[test]
fn the_schema_of_the_configuration_is_that_of_keys_and_rules() {
    let schema = mhlint::config::schema(&mhlint::rule_infos());
    let wanted = format!("{}\n", serde_json::to_string_pretty(&schema).unwrap());
    check_file("schemas/config.schema.json", &wanted);
}

/// Compares a whole file, or rewrites it.
pub(crate) fn check_file(file: &str, wanted: &str) {
    let path = project(file);
    if fs::read_to_string(&path).unwrap_or_default() == wanted {
        return;
    }
    may_write(file);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, wanted).unwrap();
}

/// Compares what lies between `<!-- NAME -->` and `<!-- /NAME -->`, or rewrites it.
pub(crate) fn check(file: &str, name: &str, wanted: &str) {
    let path = project(file);
    let text = fs::read_to_string(&path).unwrap();
    let [open, close] = [format!("<!-- {name} -->\n"), format!("<!-- /{name} -->")];
    let (before, rest) = text
        .split_once(&open)
        .unwrap_or_else(|| panic!("{file} lacks {open}"));
    let (found, after) = rest
        .split_once(&close)
        .unwrap_or_else(|| panic!("{file} lacks {close}"));
    if found == wanted {
        return;
    }
    may_write(&format!("{file}#{name}"));
    fs::write(path, format!("{before}{open}{wanted}{close}{after}")).unwrap();
}

#[track_caller]
fn may_write(what: &str) {
    let may = std::env::var_os("UPDATE").is_some();
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("generated::").to_owned();
    assert!(
        may,
        "{what} is not fresh: UPDATE=1 cargo test --test all {test} -- --test-threads 1"
    );
}
