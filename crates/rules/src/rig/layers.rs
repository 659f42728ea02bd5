//! MPFB reads layers only in rigs below version 110, and there are 32 layers.

use super::super::{Check, Rule, RuleCx, such};
use super::{STOPS, stops, subject};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::rig::LayersFault;
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("layers.md").trim_ascii_end(),
    counts: "keys",
    ..RuleInfo::new(
        "rig-layers",
        Level::Error,
        "layers that do not exist, or that nothing reads",
    )
});

const DEAD: Case = &[(
    Mpfb,
    Level::Warning,
    "does not read the layers: the bone goes to the first collection",
)];
const HARMLESS: Case = &[(
    Mpfb,
    Level::Info,
    "does not read the layers, which say nothing but where every bone is",
)];
const SHORT: Case = &[(Mpfb, Level::Info, "reads the entries that there are")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let of = |is_so: fn(&LayersFault) -> bool| {
            rig.faults
                .layers
                .iter()
                .filter(|fault| is_so(fault))
                .collect()
        };
        out.extend(finding(
            file,
            of(|fault| matches!(fault, LayersFault::Beyond(..))),
            None,
        ));
        out.extend(finding(
            file,
            of(|fault| matches!(fault, LayersFault::Length(..))),
            Some(SHORT),
        ));
        out.extend(finding(
            file,
            of(|fault| matches!(fault, LayersFault::Dead(_, false))),
            Some(DEAD),
        ));
        out.extend(finding(
            file,
            of(|fault| matches!(fault, LayersFault::Dead(_, true))),
            Some(HARMLESS),
        ));
    }
}

/// The key that names bone collections where older rigs have layers: the key of a bone, or that of
/// a parameter of Rigify.
fn successor(pointer: &str) -> String {
    let member = pointer
        .rsplit('/')
        .next()
        .and_then(|member| member.strip_suffix("_layers"));
    member.map_or_else(
        || "collections".to_owned(),
        |part| format!("{part}_coll_refs"),
    )
}

fn finding(file: &RigFile<'_>, all: Vec<&LayersFault>, case: Option<Case>) -> Option<Finding> {
    let more = |pointer: &str| (subject(pointer), such(all.len(), "lists"));
    let (pointer, key, message, help) = match *all.first()? {
        LayersFault::Beyond(pointer, at) => {
            let (subject, more) = more(pointer);
            (
                pointer,
                "beyond",
                format!(
                    "entry {at} of {subject} is set, counted from 0: there are 32 layers{more}"
                ),
                "keep the first 32 entries".to_owned(),
            )
        }
        LayersFault::Length(pointer, count) => {
            let (subject, more) = more(pointer);
            (
                pointer,
                "length",
                format!("{subject} is a list of {count}, usually of 32{more}"),
                "write 32 entries".to_owned(),
            )
        }
        LayersFault::Dead(pointer, _) => {
            let (subject, more) = more(pointer);
            let help = format!(
                "write `{}` instead, with names of collections",
                successor(pointer)
            );
            (
                pointer,
                "dead",
                format!("{subject} is not read at version 110{more}"),
                help,
            )
        }
    };
    let finding = RULE
        .at(file.file, Place::Pointer(pointer.clone()), message)
        .key(key)
        .help(help);
    let pointers = all.iter().map(|fault| match fault {
        LayersFault::Beyond(pointer, _)
        | LayersFault::Length(pointer, _)
        | LayersFault::Dead(pointer, _) => pointer,
    });
    let finding = finding.evidence(Evidence::of_cases(pointers));
    Some(match case {
        Some(case) => finding.case(case),
        None => stops(file, finding),
    })
}
