//! User sliders that replace others of the same key.

use std::borrow::Cow;
use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman2, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View, user_scan};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "shows the user's slider instead of the other one, which disappears",
    )],
    docs: include_str!("user_key_clash.md").trim_ascii_end(),
    counts: "sliders",
    ..RuleInfo::new(
        "overlay-user-key-clash",
        Level::Warning,
        "a user target that replaces a slider with the same key",
    )
});

/// A slider that is replaced: its key, and where the user has it.
type Clash<'a> = (Cow<'a, str>, &'a FileFacts, Place);

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, model)) = base.modelling.winner() else {
        return;
    };
    let mut clashes = clashes(base);
    let keys: BTreeSet<&str> = model
        .sliders
        .iter()
        .map(|slider| slider.key.as_str())
        .collect();
    clashes.retain(|(key, ..)| keys.contains(&**key));
    let Some((first, own, place)) = clashes.first() else {
        return;
    };
    let others = match clashes.len() {
        1 => String::new(),
        count => format!(" ({} in all)", counted(count, "slider")),
    };
    let message = format!(
        "the user's slider `{first}` replaces the one with the same key in `{}`{others}",
        file.path
    );
    let mut finding = RULE.at(own, place.clone(), message).key(base.name);
    for (key, ..) in clashes.iter().take(EXAMPLES) {
        finding = finding.related(file.path.clone(), Place::key([key]), "the replaced slider");
    }
    let help = "rename the user's target file or its folder: the key is made from their names, \
        and so are the names in saved models";
    let evidence = Evidence::of_cases(clashes.iter().map(|(key, ..)| key.to_string()));
    out.push(finding.help(help).evidence(evidence));
}

/// The sliders of the user: those in the JSON, and those that the next scan makes of the targets.
fn clashes<'a>(base: &Base<'a>) -> Vec<Clash<'a>> {
    let written = base.user_modelling.accepted();
    let written = written
        .into_iter()
        .flat_map(|(file, user)| user.sliders.iter().map(move |slider| (file, slider)));
    let mut all: Vec<Clash<'_>> = written
        .map(|(file, slider)| (slider.key.as_str().into(), file, Place::key([&slider.key])))
        .collect();
    let known: BTreeSet<String> = all.iter().map(|(key, ..)| key.to_string()).collect();
    let made = user_scan::entries(&user_scan::targets(base));
    let new = made.into_iter().filter(|entry| !known.contains(&entry.key));
    all.extend(new.map(|entry| (entry.key.into(), entry.file, Place::File)));
    all
}
