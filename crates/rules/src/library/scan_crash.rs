//! One file can keep a library from being listed.

use super::super::cause::consequence::STOPS_AT_START;
use super::super::cause::library::empty_uuid;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;
use mhlint_repo::{Surface, Wearer};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "lists nothing of this library")],
    docs: include_str!("scan_crash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-scan-crash",
        Level::Error,
        "a file that keeps its whole library from being listed",
    )
});

const HELP: &str = "write the value, or remove the line";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .worn()
        .iter()
        .filter(|worn| view.layers.is_checked(worn.file));
    for (worn, clothes) in own.filter_map(|worn| Some((worn, worn.clothes()?))) {
        let Some(entry) = empty_uuid(clothes) else {
            continue;
        };
        out.push(
            RULE.at(
                worn.file,
                Place::Span(entry.keyword_span.clone()),
                "`uuid` has no value",
            )
            .help(HELP),
        );
    }
    let skins = view
        .surfaces()
        .iter()
        .filter(|surface| surface.wearer == Wearer::Skin);
    for surface in skins.filter(|surface| view.layers.is_checked(surface.file)) {
        let Some(line) = surface
            .material
            .lines_of("name")
            .find(|line| line.count == 0)
        else {
            continue;
        };
        let finding = RULE
            .at(surface.file, Surface::place(line), "`name` has no value")
            .key("name")
            .help(HELP);
        out.push(if surface.is_first {
            finding.effect(STOPS_AT_START)
        } else {
            finding
        });
    }
}
