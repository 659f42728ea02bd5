//! No bone is its own parent or ancestor.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, enumerated};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::rest::{Defined, Roll, accepted};
use mhlint_formats::rig::Rig;
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently leaves out the last link of the circle: the rig hangs together otherwise than \
            it is written",
    )],
    docs: include_str!("cycle.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-cycle",
        Level::Warning,
        "parents of bones lead in a circle",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        out.extend(finding(file, rig));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig) -> Option<Finding> {
    let numbers: BTreeMap<&str, usize> = rig
        .bones
        .iter()
        .enumerate()
        .map(|(at, bone)| (bone.name.as_str(), at))
        .collect();
    let parents: Vec<Option<usize>> = rig
        .bones
        .iter()
        .map(|bone| numbers.get(bone.parent.as_deref()?).copied())
        .collect();
    let of = |parent: &Option<usize>| Defined {
        head: [0.0; 3],
        tail: [0.0; 3],
        roll: Roll::Angle(0.0),
        parent: *parent,
        use_connect: false,
    };
    let taken = accepted(&parents.iter().map(of).collect::<Vec<_>>());
    let closing = parents
        .iter()
        .zip(&taken)
        .position(|(wanted, taken)| wanted.is_some() && taken.is_none())?;
    let circle = circle(closing, &parents);
    let names: Vec<&str> = circle
        .iter()
        .filter_map(|at| rig.bones.get(*at))
        .map(|bone| bone.name.as_str())
        .collect();
    let first = names.first()?;
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let message = match names.len() {
        1 => format!("bone `{first}` is its own parent"),
        _ => format!(
            "bones {} hang on each other: `{first}` becomes a root",
            enumerated(&quoted)
        ),
    };
    Some(
        at_bones(&RULE, file, rig, &names, "parent", message)?
            .help("correct the parent of one of them"),
    )
}

/// The bones of a circle of parents. The first is the bone whose parent closes the circle.
fn circle(closing: usize, parents: &[Option<usize>]) -> Vec<usize> {
    let mut circle = vec![closing];
    let mut at = closing;
    while let Some(next) = parents
        .get(at)
        .copied()
        .flatten()
        .filter(|next| *next != closing)
    {
        if circle.len() > parents.len() {
            break;
        }
        circle.push(next);
        at = next;
    }
    circle
}
