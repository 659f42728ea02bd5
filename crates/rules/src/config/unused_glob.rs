//! A glob of the configuration that fits no file.

use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Finding, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: "The `glob` of a `[[path]]`, or an entry of `exclude` in mhlint.toml, matches no file or folder. The \
        settings of the `[[path]]` then have no effect: the files were moved, or the glob was never right. An \
        `exclude` that matches nothing is an info, because a build may create the files.\n\nGlobs are relative \
        to the folder of mhlint.toml, and `*` stays within one folder name.\n\nCorrect the glob, or remove it. \
        It is reported only if the run checked everything that it could be for: not with `--base`, and not if \
        PATH is narrower. Globs of hidden files and folders are not checked.",
    ..RuleInfo::new("config-unused-glob", Level::Warning, "a path glob that matches no file")
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for idle in &upkeep.idle {
        let message = format!("`{}` in `{}` matches no file", idle.glob, idle.setting);
        let help = match &idle.meant {
            Some(meant) => format!("did you mean `{meant}`? The glob is relative to the folder of mhlint.toml"),
            None => "correct or remove the glob; it is relative to the folder of mhlint.toml".to_owned(),
        };
        let finding = Finding::new(&RULE.info, idle.path.clone(), idle.place.clone(), message).help(help);
        let level = if idle.setting == "exclude" { Level::Info } else { Level::Warning };
        out.push(finding.level(level).key(format!("{} {}", idle.setting, idle.glob)));
    }
}
