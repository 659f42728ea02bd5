//! A saved character has a name by which MPFB lists it.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::formats::Content;
use crate::repo::mpfb::View;
use crate::repo::parent;

pub(in crate::rules) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "does not list the character, and fails when it is loaded by its path")],
    docs: "MPFB lists saved characters by their names: `human.<name>.json` in the folder `config`, in small letters.\n\n\
        A file with a `phenotype`, which only a saved character has, and another name (`joe.json`, `Human.joe.json`, \
        `human.joe.JSON`) is not listed. MPFB fails with an exception when it is loaded by its path.\n\n\
        Rename the file. The character is called like the file.",
    ..RuleInfo::new("preset-not-listed", Level::Error, "a saved character under a name that MPFB does not list")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::ConfigJson).filter(|file| matches!(&*file.content, Content::StrayCharacter)) {
        let name = file.file_name();
        let stem = name.get(..name.len().saturating_sub(".json".len())).unwrap_or(name);
        let is_begun = stem.get(..BEGINNING.len()).is_some_and(|start| start.eq_ignore_ascii_case(BEGINNING));
        let own = if is_begun { stem.get(BEGINNING.len()..).unwrap_or_default() } else { stem };
        let own = own.trim_start_matches("human").trim_matches(['.', '_', '-', ' ']);
        let wanted = format!("{BEGINNING}{}.json", if own.is_empty() { "name" } else { own });
        let (message, help) = if parent(&file.rel) == "config" {
            let message = format!("`{name}` holds a saved character, but is not called `human.<name>.json`");
            (message, format!("rename it to `{wanted}`"))
        } else {
            let message = format!("`{name}` holds a saved character, but is not in the folder `config`");
            (message, "move it to the folder `config` beside `data`".to_owned())
        };
        out.push(RULE.at(file, Place::File, message).help(help));
    }
}

const BEGINNING: &str = "human.";
