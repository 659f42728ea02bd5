//! `docs/coverage.md`: which files are read for each application, what becomes of those that cannot
//! be read, which faults are found, and what is not checked. Made from the kinds of files, the
//! tables of consequences and the table of rules.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use mhlint::diag::AssetGroup;
use mhlint::{Application, CoveredKind, covered_kinds};

use crate::generated::check_file;
use crate::scratch::project;

const HEAD: &str = "# Coverage

What mhlint reads, finds and does not check, for each application.

<!-- Written by tests/all/coverage.rs from the kinds of files, the tables of consequences and the table of rules; edits here are lost. -->
";

/// What no table says.
const NOT_CHECKED: &str = "## What is not checked

A run names the files of which it did not check the contents, and why (`Not checked: …`). Beyond that:

**In every application**

- Pixels: of pictures only the header and the end are read.
- Code: plugins, scripts, and what a graphics driver says of shaders.
- Whether an asset looks good, or has the rights that its licence names.
- Clashes with assets that are not in the run: the data of the user's machine, downloads.
- All settings of all sliders at once: the evaluation visits every step, the middle of every interval and a fixed sample
  (`--samples`), or every corner with `--exhaustive`.
- Other versions of the applications: this page is about MakeHuman 2 at d3b560e, MakeHuman 1.3 and MPFB at 80919fa.

**MakeHuman 2**

- Sources of shaders (`shaders/*.vert`, `*.frag`, `*.geom`), `makehuman2_default.conf`, licence texts, icons of the program.
- The cache of assets that it writes into the user's folder.

**MakeHuman 1**

- `animations/`, `themes/`, `povray/`, `icons/`, `logging.ini`, `poseunits/body-poseunits.json`: no loader of assets reads them.
- Translations: whether texts are complete, and whether placeholders such as `%s` agree.
- Of the lists of its libraries (`cache/*.mhc`) only whether loading them would run code.
- The rules on numbers take targets from their texts, also where the program takes them from `targets.npz`; `target-stale-binary`
  compares both.

**MPFB**

- `hair/haireditor/*.blend`, `logs/`, `cache/`, and what Blender itself stores.
";

/// What is said of each kind of files in the code, by its name there: an entry of the list is a
/// comment and a name.
fn descriptions() -> BTreeMap<String, String> {
    let code = fs::read_to_string(project("crates/discover/src/kind.rs")).unwrap();
    let (_, rest) = code.split_once("pub enum Kind {\n").unwrap();
    let (list, _) = rest.split_once("\n}").unwrap();
    let lines: Vec<&str> = list.lines().map(str::trim).collect();
    let entry = |pair: &[&str]| {
        Some((
            pair[1].strip_suffix(',')?.to_owned(),
            pair[0].strip_prefix("/// ")?.to_owned(),
        ))
    };
    lines.windows(2).filter_map(entry).collect()
}

fn title(group: AssetGroup) -> &'static str {
    match group {
        AssetGroup::BaseMesh => "Base mesh",
        AssetGroup::Targets => "Targets",
        AssetGroup::Sliders => "Sliders and macros",
        AssetGroup::Rigs => "Skeletons, rigs and weights",
        AssetGroup::Poses => "Poses, expressions and motions",
        AssetGroup::Clothes => "Clothes, hair and other worn assets",
        AssetGroup::Materials => "Materials, shaders, skins",
        AssetGroup::Pictures => "Pictures",
        AssetGroup::Models => "Saved characters and presets",
        AssetGroup::Program => "Settings, languages, scenes and lists",
    }
}

/// A row for each kind of files, a column for each application.
fn files() -> String {
    let said = descriptions();
    let kinds: Vec<Vec<CoveredKind>> = Application::ALL.into_iter().map(covered_kinds).collect();
    let mut text = "\n## Files\n\n**checked**: rules are about what is in the file. **syntax**: its name, encoding and syntax are checked. Empty: the \
         application does not load it.\n"
        .to_owned();
    for group in AssetGroup::ALL {
        let mut names: Vec<&str> = Vec::new();
        for kind in kinds
            .iter()
            .flatten()
            .filter(|kind| kind.group == Some(group))
        {
            if !names.contains(&kind.kind.as_str()) {
                names.push(&kind.kind);
            }
        }
        let titles: Vec<&str> = Application::ALL
            .iter()
            .map(|application| application.title())
            .collect();
        write!(
            text,
            "\n### {}\n\n| file | {} |\n|---|---|---|---|\n",
            title(group),
            titles.join(" | ")
        )
        .unwrap();
        for name in names {
            let cell = |of: &Vec<CoveredKind>| match of.iter().find(|kind| kind.kind == name) {
                Some(kind) if kind.has_rules => "checked",
                Some(_) => "syntax",
                None => "",
            };
            let cells: Vec<&str> = kinds.iter().map(cell).collect();
            let said = said
                .get(name)
                .unwrap_or_else(|| panic!("{name} has no description"))
                .trim_end_matches('.');
            writeln!(text, "| {said} | {} |", cells.join(" | ")).unwrap();
        }
    }
    text
}

/// What becomes of files that cannot be read.
fn unread() -> String {
    let said = descriptions();
    let mut text = "\n## Files that cannot be read\n\nA file that cannot be opened, or is not valid JSON. Files of other kinds are missing where they are used. What comes of a file \
         that is empty, a pointer of Git LFS or not UTF-8, the finding says.\n".to_owned();
    for application in Application::ALL {
        write!(
            text,
            "\n### {}\n\n| file | opened | level | then it … |\n|---|---|---|---|\n",
            application.title()
        )
        .unwrap();
        for kind in covered_kinds(application) {
            for one in &kind.unread {
                let said = said[&kind.kind].trim_end_matches('.');
                let said = if one.role.is_empty() {
                    said.to_owned()
                } else {
                    format!("{said} ({})", one.role)
                };
                writeln!(
                    text,
                    "| {said} | {} | {} | {} |",
                    one.opened, one.level, one.effect
                )
                .unwrap();
            }
        }
    }
    text
}

/// A row for each rule, a column for each application.
fn faults() -> String {
    let rules = mhlint::rule_infos();
    let concerns = |rule: &mhlint::diag::RuleInfo, application: Application| {
        rule.breaks.iter().any(|(own, _)| *own == application)
    };
    let mut text =
        "\n## Faults\n\nThe usual level of each rule in each application; a finding has the level of its own case.\n\n"
            .to_owned();
    for application in Application::ALL {
        let own = rules
            .iter()
            .filter(|rule| concerns(rule, application))
            .count();
        writeln!(text, "- {}: {own} rules", application.title()).unwrap();
    }
    let titles: Vec<&str> = Application::ALL
        .iter()
        .map(|application| application.title())
        .collect();
    write!(
        text,
        "\n| rule | {} | fault |\n|---|---|---|---|---|\n",
        titles.join(" | ")
    )
    .unwrap();
    for rule in rules.iter().filter(|rule| !rule.breaks.is_empty()) {
        let own =
            Application::ALL.map(|application| concerns(rule, application).then_some(application));
        let cell = |own: &Option<Application>| {
            own.map_or_else(String::new, |own| rule.level_in(own).to_string())
        };
        let cells: Vec<String> = own.iter().map(cell).collect();
        let (id, family) = (rule.id, rule.family());
        writeln!(
            text,
            "| [`{id}`](rules/{family}.md#{id}) | {} | {} |",
            cells.join(" | "),
            rule.summary
        )
        .unwrap();
    }
    text
}

#[test]
fn the_page_on_what_is_covered_is_fresh() {
    check_file(
        "docs/coverage.md",
        &[HEAD, &files(), &unread(), &faults(), "\n", NOT_CHECKED].concat(),
    );
}

/// What has a row of consequences or rules is known to the application, and the other way round: a
/// kind without a group is one that nobody loads.
#[test]
fn what_is_checked_belongs_to_a_group_of_files() {
    for kind in Application::ALL.into_iter().flat_map(covered_kinds) {
        let is_general = matches!(
            kind.kind.as_str(),
            "Json" | "ConfigJson" | "Other" | "Unlisted"
        );
        assert_eq!(kind.group.is_none(), is_general, "{}", kind.kind);
    }
}
