//! Combinations of the cross product that a macro definition does not list.

use super::super::{Check, Rule, RuleCx};
use super::absence::{Absence, absences};
use super::combination_patterns::is_walkable;
use super::component::unknown_patterns;
use super::listing::Listing;
use super::judgeable::judged_space;
use super::space::Space;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::macro_json::Macrodef;
use crate::repo::{Base, FileFacts, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "applies nothing for a combination that is not listed: at that corner of the sliders the shape snaps back",
        )],
        docs: "A macrodef stands for every combination of the values of its components. A combination that is not \
            listed changes nothing, exactly as `null` does, and MakeHuman 2 says nothing about it.\n\nThat is \
            fine where it is a system: a value that has no entry at all (`male` in a macro for breasts, `none` \
            in a macro for height), a neutral state (the values at the default position of their sliders), or a \
            combination all of whose siblings are `null`. Such absences are listed as an info, so that they can \
            be compared with what was meant. It is not fine where a single corner is missing in a block that is \
            listed otherwise: there the shape snaps back when the sliders come near (warning). Where fewer than \
            half of a block is listed, a table is taken for sparse on purpose (info).\n\nIn the patterns `*` \
            stands for every value; the number behind a pattern is how many combinations it covers, and patterns \
            may overlap. Products of more than about a million combinations are counted, not listed.\n\nAdd the \
            entries; write `null` for a combination that should change nothing.",
        ..RuleInfo::new(
            "macro-missing-combination",
            Level::Warning,
            "a macrodef leaves combinations of its components unlisted",
        )
    },
    check: Check::Base(run),
};

/// Patterns in the message and in the evidence.
const SHOWN: usize = 8;

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    if base.modelling.winner().is_none() {
        return; // Without sliders nothing tells which values are neutral; the missing file is reported itself.
    }
    for macrodef in &macros.macrodefs {
        let Some(space) = judged_space(file, macros, macrodef) else { continue };
        // A dead definition has no corners, whatever it lists.
        if space.axes.iter().any(|axis| !unknown_patterns(base, axis).is_empty()) {
            continue;
        }
        if macrodef.links.iter().any(|link| space.spellings(&link.name) > 1) {
            continue; // Which combinations are listed is open: `macro-ambiguous-value`.
        }
        let mut listing = Listing::of(&space, macrodef);
        // One table holds all names: what another definition lists is found for this one too.
        let elsewhere = macros.macrodefs.iter().filter(|other| other.index != macrodef.index);
        listing.claimed.extend(elsewhere.flat_map(|other| &other.links).filter_map(|link| space.parse(&link.name)));
        let lost = listing.strangers.iter().filter(|stranger| stranger.intended.is_none()).count();
        if lost > listing.found.len() {
            continue; // The names are for other components: `macro-unexpected-combination`.
        }
        if is_walkable(&space.sizes()) {
            let [system, holes] = absences(base, &space, &listing);
            // An entry whose name is unknown stands for a combination; the schema speaks of it.
            let below = format!("/macrodef/{}/targets/", macrodef.index);
            let faulty = file.schema.faults.iter().filter(|fault| fault.pointer.starts_with(&below)).count();
            let nameless = macrodef.links.iter().filter(|link| link.name.is_empty()).count();
            let holes = if holes.count <= faulty + nameless { Absence::default() } else { holes };
            let is_hole = holes.count <= listing.found.len();
            out.extend(finding(file, macrodef, &space, &holes, if is_hole { Kind::Hole } else { Kind::Sparse }));
            out.extend(finding(file, macrodef, &space, &system, Kind::System));
        } else {
            out.extend(uncounted(file, macrodef, &space, listing.found.len()));
        }
    }
}

/// How combinations are absent.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// In a block that is listed otherwise.
    Hole,
    /// In a table that lists fewer than half of its block.
    Sparse,
    /// By a system.
    System,
}

/// A finding on absent combinations of one kind, if there are any.
fn finding(file: &FileFacts, macrodef: &Macrodef, space: &Space<'_>, absence: &Absence, kind: Kind) -> Option<Finding> {
    let total = space.size()?;
    let count = absence.count;
    let (first, size) = absence.patterns.first()?;
    let shown = absence.patterns.iter().take(SHOWN).map(|(text, size)| match size {
        1 => format!("`{text}`"),
        size => format!("`{text}` ({size})"),
    });
    let mut shown = shown.collect::<Vec<_>>().join(", ");
    if absence.patterns.len() > SHOWN {
        shown = format!("{shown} and {} patterns more", absence.patterns.len() - SHOWN);
    }
    let message = match (kind, *size, count) {
        (Kind::Hole, 1, 1) => format!("`{first}` is not listed, a hole in a block that is listed otherwise"),
        (Kind::Hole, ..) => {
            format!("{count} of {total} combinations are holes in a block that is listed otherwise: {shown}")
        }
        (Kind::System, 1, 1) => {
            format!(
                "`{first}` is not listed, a hole without effect: the state is neutral, or all its siblings are null"
            )
        }
        (Kind::System, ..) => format!("{count} of {total} combinations are left out systematically: {shown}"),
        (Kind::Sparse, ..) => format!("{count} of {total} combinations are left out, more than are listed: {shown}"),
    };
    let evidence = Evidence::of_groups(absence.patterns.iter().map(|(text, _)| text), count as u64).out_of(total);
    let word = match kind {
        Kind::Hole => "holes",
        Kind::Sparse => "sparse",
        Kind::System => "system",
    };
    let finding = RULE.at(file, place(macrodef), message).key(format!("{}/{word}", macrodef.components.join("-")));
    let finding = finding.parts(&absence.names);
    let finding = if kind == Kind::Hole {
        finding.help("add the entries; write `null` for a combination that should change nothing")
    } else {
        let effect = "nothing: these combinations are meant to have no shape of their own";
        let help = "nothing needs to be done if no shape is meant here";
        finding.level(Level::Info).breaks(Application::Makehuman2, effect).help(help)
    };
    Some(finding.evidence(evidence))
}

/// What can be said of a product too large to be walked.
fn uncounted(file: &FileFacts, macrodef: &Macrodef, space: &Space<'_>, listed: usize) -> Option<Finding> {
    let absent = match space.size() {
        Some(total) if total == listed => return None,
        Some(total) => format!("{} of {total}", total - listed),
        None => format!("all but {listed}"),
    };
    let message = format!("{absent} combinations are not listed; they are too many to tell holes from systems");
    let finding = RULE.at(file, place(macrodef), message).key(format!("{}/uncounted", macrodef.components.join("-")));
    Some(finding.level(Level::Info).help("split the macrodef into several with fewer components"))
}

fn place(macrodef: &Macrodef) -> Place {
    let index = macrodef.index.to_string();
    if macrodef.links.is_empty() {
        Place::pointer(["macrodef", &index])
    } else {
        Place::pointer(["macrodef", &index, "targets"])
    }
}
