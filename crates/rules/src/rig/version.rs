//! The keys of a rig have the layout of the version that it gives.

use super::super::{Check, Rule, RuleCx};
use super::{STOPS, stops};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_formats::rig::{LayoutFault, NEWEST};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("version.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-version",
        Level::Error,
        "the header of a rig is not one that MPFB reads",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        // A user's rig that is no JSON object stops the list of rigs; `rig-custom-scan` reports it.
        let faults = rig.faults.layout.iter();
        let faults = faults.filter(|fault| {
            !(file.part == RigPart::Custom && matches!(fault, LayoutFault::NotObject(_)))
        });
        out.extend(faults.map(|fault| stops(file, finding(file, fault, cx))));
        if rig.is_subrig && file.part != RigPart::Asset {
            let message = "`is_subrig` is set, and this rig is added to no other";
            let finding = RULE
                .at(file.file, Place::key(["is_subrig"]), message)
                .key("is_subrig");
            out.push(finding.help("write `false`, or put the rig beside an asset as `.mpfbskel`"));
        }
    }
}

fn finding(file: &RigFile<'_>, fault: &LayoutFault, cx: &RuleCx<'_>) -> Finding {
    let at = |key: &str, message: String| {
        RULE.at(file.file, Place::key([key]), message)
            .key(key.to_owned())
    };
    match fault {
        LayoutFault::NotObject(found) => RULE
            .at(
                file.file,
                Place::File,
                format!("the file is {found}, expected an object of bones"),
            )
            .help("export the rig again from MPFB"),
        LayoutFault::HeaderWithoutBones(key) => {
            let near = file.definition().and_then(|rig| {
                rig.top_keys
                    .iter()
                    .find(|key| cx.suggestions.nearest(key, ["bones"]).is_some())
            });
            let help = match near {
                Some(near) => format!("did you mean `bones` instead of `{near}`?"),
                None => "put the bones into `bones`, or remove the keys of the header".to_owned(),
            };
            at(
                key,
                format!("`{key}` counts as a bone, as the file has no `bones`"),
            )
            .help(help)
        }
        LayoutFault::WithoutVersion => {
            at("bones", "the file has `bones`, but no `version`".to_owned())
                .help("add `\"version\": 110`")
        }
        LayoutFault::VersionType(found) => at(
            "version",
            format!("`version` is {found}, expected a number"),
        )
        .help("write 110 without quotes"),
        LayoutFault::TooNew(version) => at(
            "version",
            format!("`version` is {version}, newer than {NEWEST}"),
        )
        .help(format!("write {NEWEST}, or update MPFB")),
        LayoutFault::Skeleton => at(
            "joints",
            "the file has `joints`: it is a skeleton of MakeHuman".to_owned(),
        )
        .help("load the skeleton in MakeHuman, or make a rig of it in MPFB"),
    }
}
