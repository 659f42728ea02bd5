//! A topology stands for the skin.

use super::super::{Check, Rule, RuleCx};
use super::{Text, sections, texts};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "draws the body as well: both meshes show, one in the other",
    )],
    docs: include_str!("topology.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-topology",
        Level::Warning,
        "a topology that cannot stand for the skin",
    )
});

const MATERIAL: Case = &[(
    Makehuman2,
    Level::Warning,
    "never uses the material: the topology wears the skin",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body).filter(|text| text.worn.is_topology() && !text.reading.stops()) {
        let is_told = sections::misspelt_list(&text).is_some();
        if text.clothes.deleted.is_empty() && !is_told && text.reading.last("obj_file").is_some() {
            let finding = RULE.at(
                text.file,
                Place::File,
                "`delete_verts` is missing: the topology does not hide the skin",
            );
            out.push(
                finding
                    .key("delete_verts")
                    .help("add `delete_verts` with the vertices of the skin, such as `0 - 99`"),
            );
        }
        out.extend(material(&text));
    }
}

fn material(text: &Text<'_, '_>) -> Option<Finding> {
    let entry = text.reading.last("material")?;
    let finding = RULE.at(
        text.file,
        Place::Span(entry.word_span()),
        "a topology has no material of its own",
    );
    Some(
        finding
            .key("material")
            .case(MATERIAL)
            .help("remove the line, and use a skin for its look"),
    )
}
