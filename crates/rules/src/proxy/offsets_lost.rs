//! Offsets that the archive of an asset does not keep.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "puts the asset on without its offsets from the second start on",
    )],
    docs: include_str!("offsets_lost.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-offsets-lost",
        Level::Warning,
        "offsets that the archive of an asset does not keep",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Nothing is compiled in the data of the program.
    if body.layers.checks_system() {
        return;
    }
    for text in texts(body).filter(|text| !text.reading.stops()) {
        let rows = &text.clothes.rows;
        // Without a uuid, and with `uvLayer`, no archive is made.
        let is_compiled =
            text.reading.last("uuid").is_some() && text.reading.last("uvLayer").is_none();
        if !is_compiled || !rows.has_offsets || rows.has_shares {
            continue;
        }
        let verts = text
            .clothes
            .entries
            .iter()
            .find(|entry| &*entry.keyword == "verts");
        let place = verts.map_or(Place::File, |entry| Place::Line(entry.line));
        let finding = RULE.at(
            text.file,
            place,
            "the rows have offsets, but each row uses only one vertex",
        );
        out.push(finding.help("export the asset with three vertices per row"));
    }
}
