//! User sliders that replace others of the same key.

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "shows the user's slider in place of the other one, which is gone")],
        docs: "The generated modelling.json of the user's targets is merged over the sliders of the base, key by key, and the \
            user's entry wins. Its keys are made from folder and file: `head/size.target` becomes `Head Size`. If the base \
            has a slider of that key it vanishes, and models that were saved with it lose the value.\n\nRename the user's \
            target or its folder; MakeHuman 2 writes the file anew.",
        ..RuleInfo::new("overlay-user-key-clash", Level::Warning, "a user target replaces a slider of the same key")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let (Some((user_file, user)), Some((file, model))) = (base.user_modelling.accepted(), base.modelling.winner())
    else {
        return;
    };
    let taken = |key: &str| model.sliders.iter().any(|slider| slider.key == key);
    let keys: Vec<&str> = user.sliders.iter().map(|slider| slider.key.as_str()).filter(|key| taken(key)).collect();
    let Some(first) = keys.first() else { return };
    let others = match keys.len() {
        1 => String::new(),
        count => format!(" ({} in all)", counted(count, "slider")),
    };
    let message = format!("the user's slider `{first}` replaces the one of the same key in `{}`{others}", file.path);
    let mut finding = RULE.at(user_file, Place::key([first]), message).key(base.name);
    for key in keys.iter().take(EXAMPLES) {
        finding = finding.related(file.path.clone(), Place::key([key]), "replaced");
    }
    let help = "rename the user's target file or its folder, from which the key is made";
    out.push(finding.help(help).evidence(Evidence::of_cases(&keys).out_of(user.sliders.len())));
}
