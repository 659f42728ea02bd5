//! A glob of the configuration that fits no file.

use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Finding, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: include_str!("unused_glob.md").trim_ascii_end(),
    ..RuleInfo::new(
        "config-unused-glob",
        Level::Warning,
        "a path glob that matches no file",
    )
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for idle in &upkeep.idle {
        let message = format!("`{}` in `{}` matches no file", idle.glob, idle.setting);
        let help = match &idle.meant {
            Some(meant) => {
                format!("did you mean `{meant}`? The glob is relative to the folder of mhlint.toml")
            }
            None => {
                "correct or remove the glob; it is relative to the folder of mhlint.toml".to_owned()
            }
        };
        let finding =
            Finding::new(&RULE.info, idle.path.clone(), idle.place.clone(), message).help(help);
        let level = if idle.setting == "exclude" {
            Level::Info
        } else {
            Level::Warning
        };
        out.push(
            finding
                .level(level)
                .key(format!("{} {}", idle.setting, idle.glob)),
        );
    }
}
