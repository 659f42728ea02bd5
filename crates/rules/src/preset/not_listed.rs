//! A saved character has a name by which MPFB lists it.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo, nearest};
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "does not list the character, and fails when it is loaded by its path",
    )],
    docs: include_str!("not_listed.md").trim_ascii_end(),
    ..RuleInfo::new(
        "preset-not-listed",
        Level::Error,
        "a saved character under a name that MPFB does not list",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view
        .own(Kind::ConfigJson)
        .filter(|file| matches!(&*file.content, Content::StrayCharacter))
    {
        let name = file.file_name();
        let stem = name
            .get(..name.len().saturating_sub(".json".len()))
            .unwrap_or(name);
        let is_begun = stem
            .get(..BEGINNING.len())
            .is_some_and(|start| start.eq_ignore_ascii_case(BEGINNING));
        let own = if is_begun {
            stem.get(BEGINNING.len()..).unwrap_or_default()
        } else {
            stem
        };
        let own = own
            .trim_start_matches("human")
            .trim_matches(['.', '_', '-', ' ']);
        let wanted = format!(
            "{BEGINNING}{}.json",
            if own.is_empty() { "name" } else { own }
        );
        let (message, help) = if parent(&file.rel) == "config" {
            let message =
                format!("`{name}` holds a saved character, but is not called `human.<name>.json`");
            (message, format!("rename it to `{wanted}`"))
        } else {
            let message =
                format!("`{name}` holds a saved character, but is not in the folder `config`");
            (
                message,
                "move it to the folder `config` beside `data`".to_owned(),
            )
        };
        out.push(RULE.at(file, Place::File, message).help(help));
    }
    out.extend(misspelt(view));
}

/// What the names of presets begin with, up to the first point.
const PRESETS: [&str; 5] = [
    "importer_presets",
    "makeup",
    "randomization",
    "eye_settings",
    "enhanced_settings",
];

/// A preset of another kind under a name that is nearly that of its kind.
fn misspelt(view: &View<'_>) -> Vec<Finding> {
    let others = view
        .own(Kind::ConfigJson)
        .filter(|file| !matches!(&*file.content, Content::StrayCharacter));
    let finding = |file: &FileFacts| {
        let (beginning, _) = file
            .file_name()
            .split_once('.')
            .filter(|_| parent(&file.rel) == "config")?;
        let near = nearest(beginning, PRESETS)?;
        let message = format!(
            "`{}` is not listed: the name begins with `{beginning}`",
            file.file_name()
        );
        let finding = RULE
            .at(file, Place::File, message)
            .key("kind")
            .effect("does not list it");
        Some(finding.help(format!("let the name begin with `{near}.`")))
    };
    others.filter_map(finding).collect()
}

const BEGINNING: &str = "human.";
