//! A zip of assets that cannot be unpacked, in words.

use super::super::{Rule, and_more};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level,
};
use mhlint_repo::Layer;
use mhlint_source::{MemberFault, PackFacts, PackFault};

const WHOLE: Case = &[
    (Makehuman2, Level::Error, "imports nothing of it"),
    (
        Makehuman1,
        Level::Error,
        "gets nothing of it: it cannot be unpacked",
    ),
    (
        Mpfb,
        Level::Error,
        "rejects the zip: nothing of it is imported",
    ),
];
const IN_PART: Case = &[
    (
        Makehuman2,
        Level::Error,
        "breaks off the import with an error: assets are missing",
    ),
    (
        Makehuman1,
        Level::Error,
        "gets only a part of it: assets are missing",
    ),
    (
        Mpfb,
        Level::Error,
        "fails with an exception while it unpacks the zip: assets are missing",
    ),
];

/// What is wrong with the zip that a layer was made of.
pub(super) fn report(rule: &Rule, layer: &Layer, out: &mut Vec<Finding>) {
    let Some(facts) = layer.pack.as_ref().and_then(|pack| pack.faults.as_deref()) else {
        return;
    };
    let at = |message: String| rule.in_layer(layer, "", message).key("pack");
    if let Some(message) = facts.fault.as_ref().and_then(of_whole) {
        let finding = at(message).case(WHOLE);
        out.push(finding.help("download or pack it again, as a plain zip of folders of assets"));
    }
    let bad: Vec<(&str, String, &str)> = members(facts).collect();
    let Some((first, words, help)) = bad.first() else {
        return;
    };
    let more = and_more(bad.len(), "member");
    let finding = at(format!("member `{first}` {words}{more}"))
        .key("members")
        .case(IN_PART);
    let finding = finding.evidence(Evidence::of_cases(bad.iter().map(|(name, ..)| *name)));
    out.push(finding.help(*help));
}

fn of_whole(fault: &PackFault) -> Option<String> {
    Some(match fault {
        PackFault::NoZip => "not a zip archive, or its end is missing".to_owned(),
        PackFault::List => "the list of members at the end of the zip is damaged".to_owned(),
        PackFault::TooMany { most } => {
            format!("more than {most} members; nothing in the zip was checked")
        }
        // It has a rule of its own.
        PackFault::Bomb { .. } => return None,
    })
}

/// The members that cannot be unpacked: what is wrong with each, and what to do.
fn members(facts: &PackFacts) -> impl Iterator<Item = (&str, String, &str)> {
    const AGAIN: &str = "download it or pack it again";
    let words = |fault: &MemberFault| match fault {
        MemberFault::Encrypted => Some((
            "is encrypted".to_owned(),
            "pack it again without a password",
        )),
        MemberFault::Method(method) => {
            let words = format!("is compressed with method {method}, expected deflate");
            Some((words, "pack it again with the usual compression (deflate)"))
        }
        MemberFault::NameNotUtf8 => Some((
            "has a name that is marked as UTF-8 and is not".to_owned(),
            AGAIN,
        )),
        MemberFault::Damaged(reason) => Some((format!("cannot be unpacked: {reason}"), AGAIN)),
        MemberFault::Escapes
        | MemberFault::LinkLeaves { .. }
        | MemberFault::Link { .. }
        | MemberFault::Replaced => None,
    };
    let faults = facts
        .faults
        .iter()
        .filter(|(_, fault)| !fault.is_of_reader());
    faults.filter_map(move |(name, fault)| {
        words(fault).map(|(words, help)| (name.as_str(), words, help))
    })
}
