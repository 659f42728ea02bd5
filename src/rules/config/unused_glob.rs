//! A glob of the configuration that fits no file.

use crate::diag::{Finding, Level, RuleInfo, Upkeep};
use crate::rules::{Check, Rule, RuleCx};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        docs: "The `glob` of a `[[path]]`, or an entry of `exclude` in mhlint.toml, fits no file or folder. The settings of the \
               `[[path]]` are then without effect: the files were moved, or the glob never was right. Globs are relative to the \
               folder of mhlint.toml, and `*` stays within one folder name. An `exclude` of what is not there is an info: what it \
               was meant for may be made by a build.\n\nCorrect the glob, or remove it. It is reported only where the run looked at \
               everything that it could be for: not with `--base`, and not when PATH is \
               narrower. Globs of hidden files and folders are not judged, because those are not looked at.",
        ..RuleInfo::new("config-unused-glob", Level::Warning, "a path glob that fits no file")
    },
    check: Check::Upkeep(run),
};

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for idle in &upkeep.idle {
        let message = format!("`{}` of `{}` fits no file", idle.glob, idle.setting);
        let help = match &idle.meant {
            Some(meant) => format!("did you mean `{meant}`? Globs are relative to the folder of mhlint.toml"),
            None => "correct the glob, or remove it; globs are relative to the folder of mhlint.toml".to_owned(),
        };
        let finding = Finding::new(&RULE.info, idle.path.clone(), idle.place.clone(), message).help(help);
        let level = if idle.setting == "exclude" { Level::Info } else { Level::Warning };
        out.push(finding.level(level).key(format!("{} {}", idle.setting, idle.glob)));
    }
}
