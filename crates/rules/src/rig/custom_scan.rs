//! The rigs in a user's folder appear in the list of MPFB.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::rig::{Identifying, LayoutFault, Rig};
use mhlint_repo::mpfb::{View, is_listed};
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "does not list the rig")],
    docs: include_str!("custom_scan.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-custom-scan",
        Level::Error,
        "a rig of a user that is not listed",
    )
});

const NONE_LISTED: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when rigs are listed: no rig of a user is",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() && !view.layers.is_one_root() {
        return;
    }
    for file in view.own(Kind::CustomRig).chain(view.own(Kind::Rig)) {
        let Some(rig) = file.rig() else { continue };
        out.extend(if parent(&file.rel) == "rigs" {
            listed(view, file, rig)
        } else {
            too_deep(view, file, rig)
        });
    }
}

fn listed(view: &View<'_>, file: &FileFacts, rig: &Rig) -> Option<Finding> {
    if let Some(found) = no_object(rig) {
        // A file that MPFB does not open because of its name does no harm.
        let message = format!("the file is {found}, expected an object");
        let finding = RULE.at(file, Place::File, message).case(NONE_LISTED);
        return is_listed(file)
            .then(|| finding.help("remove the file from `rigs`, or export the rig again"));
    }
    if !is_rig(rig) {
        let finding = || {
            RULE.at(
                file,
                Place::File,
                "the file is a skeleton of MakeHuman, and not a rig of MPFB",
            )
        };
        let is_skeleton = is_listed(file)
            && (rig.has_header && !rig.bones.is_empty()
                || rig.faults.layout.contains(&LayoutFault::Skeleton));
        return is_skeleton.then(|| {
            finding()
                .help("make a rig of it in Blender and save that with MPFB; it reads no `.mhskel`")
        });
    }
    if !is_listed(file) {
        let message = format!(
            "`{}` has other characters than letters, digits and `_` in its name",
            file.file_name()
        );
        return Some(RULE.at(file, Place::File, message).help(renamed(
            view.layers.checked,
            file,
            rig,
        )));
    }
    let lacks = rig.identifying == Identifying::Absent;
    let finding = || RULE.at(file, Place::File, "the rig has no `identifying_bones`");
    lacks.then(|| finding().help(format!("add {SIGN}")))
}

const SIGN: &str = "`identifying_bones` with names of bones that no other rig has";

/// Help for a rig that is not listed because of its name: the new name, and what to do with its
/// weights.
fn renamed(layer: &Layer, file: &FileFacts, rig: &Rig) -> String {
    let plain = |name: &str| -> String {
        name.chars()
            .map(|one| {
                if one.is_ascii_alphanumeric() {
                    one
                } else {
                    '_'
                }
            })
            .collect()
    };
    let is_there = |name: &str| layer.is_there(&format!("rigs/{name}.json"));
    // `rig.<name>.json` is the form of name of the rigs that come with MPFB. Their weights are
    // called `weights.<name>.json`, which is also the form for rigs of a user.
    let own = file
        .stem()
        .strip_prefix("rig.")
        .filter(|own| !own.is_empty());
    let free = own.filter(|own| !is_there(&plain(own)));
    let new = plain(free.unwrap_or(file.stem()));
    let weights = match own
        .map(|own| format!("weights.{own}"))
        .filter(|weights| is_there(weights))
    {
        Some(weights) if free == Some(&*new) => format!("; `{weights}.json` keeps its name"),
        // The name is taken by another rig, and these are the weights of that rig.
        Some(weights) if free.is_none() => {
            format!("; copy `{weights}.json` to `weights.{new}.json`")
        }
        None if free == Some(&*new) => String::new(),
        _ => ", and its weights alike".to_owned(),
    };
    let sign = if rig.identifying == Identifying::Absent {
        format!("; add {SIGN}")
    } else {
        String::new()
    };
    format!("rename it to `{new}.json`{weights}{sign}")
}

fn too_deep(view: &View<'_>, file: &FileFacts, rig: &Rig) -> Option<Finding> {
    if view.layers.is_one_root() || !is_rig(rig) {
        return None;
    }
    let message = format!(
        "rigs of a user are looked for in `rigs` alone, and not in `{}`",
        parent(&file.rel)
    );
    Some(
        RULE.at(file, Place::File, message)
            .help("move the file to `rigs`, with its weights"),
    )
}

fn no_object(rig: &Rig) -> Option<&'static str> {
    rig.faults.layout.iter().find_map(|fault| match fault {
        LayoutFault::NotObject(found) => Some(*found),
        _ => None,
    })
}

/// Whether a file is a rig: it has bones, or `identifying_bones`.
fn is_rig(rig: &Rig) -> bool {
    rig.bones
        .iter()
        .any(|bone| bone.head.is_some() || bone.tail.is_some())
        || rig.identifying != Identifying::Absent
}
