//! The data folder of the program has the files without which it does not start.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use crate::repo::{Layer, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "exits at start")],
    docs: "The data folder of MakeHuman 2 itself needs `makehuman2_version.json` and `shaders/shader.json`. Without the first \
        the program exits at start with code 20, without the second with code 21.\n\n\
        The rule asks for them only where the folder holds other parts of the program: shaders, or one of the two.\n\n\
        Restore the file from the program.",
    ..RuleInfo::new("program-missing-file", Level::Error, "a file of the program does not exist")
});

const NEEDED: [(&str, u8); 2] = [("makehuman2_version.json", 20), ("shaders/shader.json", 21)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let Some(system) = layers.system.filter(|system| std::ptr::eq(*system, layers.checked)) else { return };
    if !holds_program(system) {
        return;
    }
    for (rel, code) in NEEDED.into_iter().filter(|(rel, _)| !exists(system, rel)) {
        let message = format!("`{rel}` does not exist");
        let finding = RULE
            .in_layer(system, rel, message)
            .effect_in(view.application(), format!("exits at start with code {code}"));
        out.push(finding.help("restore the file from the program"));
    }
}

/// What is there and cannot be read has a finding of its own; one with other capitals is as good as none on Linux.
fn exists(layer: &Layer, rel: &str) -> bool {
    layer.file(rel).is_some() || layer.has_unusable(rel)
}

fn holds_program(layer: &Layer) -> bool {
    let is_shader = |rel: &str| matches!(rel.rsplit('.').next(), Some("vert" | "frag"));
    let mut shaders = layer.below("shaders");
    NEEDED.iter().any(|(rel, _)| exists(layer, rel)) || shaders.any(|file| is_shader(&file.rel))
}
