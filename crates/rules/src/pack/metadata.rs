//! The list of a pack of MPFB is one that its loader takes, where it looks for it.

use super::super::unfit::findings;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use mhlint_discover::{Kind, extension};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails with `AttributeError` when the assets of the pack are asked for",
    )],
    docs: include_str!("metadata.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pack-metadata",
        Level::Error,
        "a list of a pack that its loader does not take or find",
    )
});

const LISTED_TOO: Case = &[(
    Mpfb,
    Level::Warning,
    "lists it as another pack: every name with `.json` in it counts",
)];
const NOT_READ: Case = &[(Mpfb, Level::Error, "does not know the pack")];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::PackMetadata) {
        let Some(pack) = file.pack_metadata() else {
            continue;
        };
        out.extend(findings(&RULE, file, &pack.stops, cx).map(|(_, finding)| finding));
        if pack.stops.all().is_empty() && extension(&file.rel) != "json" {
            let message = format!("`{}` counts as a pack of its own", file.file_name());
            let finding = RULE
                .at(file, Place::File, message)
                .key("copy")
                .case(LISTED_TOO);
            out.push(finding.help("move it out of `packs`, or remove it"));
        }
    }
    out.extend(view.layers.checked.below("packs").filter_map(unread));
}

/// A list that has the right place or name, but not both.
fn unread(file: &FileFacts) -> Option<Finding> {
    if !extension(&file.rel).eq_ignore_ascii_case("json") {
        return None;
    }
    let (message, help) = if file.rel.matches('/').count() > 1 {
        (
            format!("`{}` is in a folder below `packs`", file.file_name()),
            "move it to `packs` itself",
        )
    } else if file.kind != Kind::PackMetadata {
        (
            format!(
                "`{}` must end in `.json`: capitals matter",
                file.file_name()
            ),
            "write the suffix in small letters",
        )
    } else {
        return None;
    };
    Some(
        RULE.at(file, Place::File, message)
            .key("place")
            .case(NOT_READ)
            .help(help),
    )
}
