//! Yes and no have their words.

use super::super::{Check, Rule, RuleCx, shown};
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use mhlint_formats::mhmat::{Line, Value};
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "takes it for false"),
        (Makehuman1, "takes it for false"),
    ],
    docs: include_str!("boolean_spelling.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-boolean-spelling",
        Level::Warning,
        "a word for true that an application takes for false",
    )
});

const TRUE: [&str; 3] = ["true", "yes", "enabled"];
const FALSE: [&str; 8] = ["false", "no", "disabled", "off", "0", "f", "n", "none"];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let lines = surface
            .material
            .lines
            .iter()
            .filter(|line| loader::reads(surface.application, line.keyword.name));
        let flags = lines.filter(|line| line.keyword.value == Value::Flag && line.count > 0);
        let is_last = |line: &&Line| {
            surface
                .material
                .last(line.keyword.name)
                .is_some_and(|last| std::ptr::eq(last, *line))
        };
        let of_shader = surface
            .material
            .lines_of("shaderConfig")
            .filter(|_| loader::is_1(surface.application));
        let faults = flags
            .filter(is_last)
            .filter_map(fault)
            .chain(of_shader.filter_map(of_config))
            .collect();
        report(
            &RULE,
            surface,
            faults,
            "have words that count as false",
            out,
        );
    }
}

/// A part of the shader that is switched on or off.
fn of_config(line: &Line) -> Option<Fault> {
    let word = line.word(1).to_lowercase();
    if line.count < 2 || TRUE.contains(&&*word) || FALSE.contains(&&*word) {
        return None;
    }
    let shown = |at: usize| shown(line.word(at));
    let (key, text) = (format!("shaderConfig {}", shown(0)), shown(1));
    Some(Fault {
        message: format!("`{key} {text}` counts as false"),
        place: Surface::place(line),
        level: Level::Warning,
        effect: "reads it as false: only `true`, `yes` and `enabled` are true".to_owned(),
        help: format!("write `{key} True` or `{key} False`"),
        key,
    })
}

fn fault(line: &Line) -> Option<Fault> {
    let (keyword, word) = (line.keyword.name, line.word(0).to_lowercase());
    if TRUE.contains(&&*word) || FALSE.contains(&&*word) {
        return None;
    }
    let text = shown(line.word(0));
    Some(Fault {
        key: keyword.to_owned(),
        place: Surface::place(line),
        level: Level::Warning,
        message: format!("`{keyword} {text}` counts as false"),
        effect: "reads it as false: only `true`, `yes` and `enabled` are true".to_owned(),
        help: format!("write `{keyword} True` or `{keyword} False`"),
    })
}
