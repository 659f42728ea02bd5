//! A component has either `steps` or `sum`.

use super::super::{Check, Rule, RuleCx};
use super::component::{sound_components, unknown_patterns, weigh};
use mhlint_diag::{
    Application::Makehuman2, Finding, Grouped, Level, Place, RuleInfo, grouped, pointer,
};
use mhlint_json::UnknownKey;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `KeyError` without either; ignores `sum` if it has both",
    )],
    docs: include_str!("steps_and_sum.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-steps-and-sum",
        Level::Error,
        "a component has both `steps` and `sum`, or neither",
    )
});

/// The keys of a file that are nearly one of the two, by the pointer of their object.
fn misspelt(file: &FileFacts) -> Grouped<&str, String> {
    let help = |key: &'_ UnknownKey| {
        let meant = key.nearest.as_deref();
        let meant = meant.filter(|near| matches!(*near, "steps" | "sum"))?;
        Some(format!("did you mean `{meant}` instead of `{}`?", key.key))
    };
    let keys = file.schema.unknown.iter();
    grouped(keys.filter_map(|key| Some((key.pointer.rsplit_once('/')?.0, help(key)?))))
}

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let misspelt = misspelt(file);
    for component in sound_components(file, macros) {
        let name = &component.name;
        let finding = match (&component.steps, &component.sum) {
            (Some(_), Some(_)) => {
                let dead = !unknown_patterns(base, component).is_empty();
                let (level, effect) = if dead {
                    (
                        Level::Error,
                        "ignores `sum`, finds no slider for `pattern` and never applies the \
                            macrodefs",
                    )
                } else {
                    (Level::Warning, "ignores `sum`")
                };
                let place = Place::key(["components", name, "sum"]);
                RULE.at(
                    file,
                    place,
                    format!("component `{name}` has both `steps` and `sum`"),
                )
                .level(level)
                .effect(effect)
                .help("remove `sum` if the slider is plain, or `steps` if it is a triangle")
            }
            (None, None) => {
                let place = Place::key(["components", name]);
                let own = misspelt.get(pointer(&["components", name]).as_str());
                let meant = own.and_then(|keys| keys.first()).cloned();
                RULE.at(
                    file,
                    place,
                    format!("component `{name}` has neither `steps` nor `sum`"),
                )
                .effect("crashes at start with `KeyError`")
                .help(meant.unwrap_or_else(|| {
                    "add `steps` with a slider position for each value, or `sum` for a \
                            triangle slider"
                        .to_owned()
                }))
            }
            _ => continue,
        };
        out.push(weigh(finding.key(name), macros, component));
    }
}
