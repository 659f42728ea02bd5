//! What an archive of targets holds is what its text says.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx, and_more};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::target::PACKED_PART;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "takes the number from the archive, where it has gone around",
    )],
    docs: include_str!("overflow.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "archive-overflow",
        Level::Error,
        "a number of a target does not fit into the archive",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let known = view
        .targets
        .archive
        .as_ref()
        .filter(|archive| archive.unused.is_none());
    let Some(archive) = known.filter(|_| view.layers.checks_system()) else {
        return;
    };
    let of_member = |(name, own): (&String, &mhlint_formats::npz::targets::PackedTarget)| {
        let file = view.layers.checked.file(&format!("{name}.target"))?;
        let facts = file.target()?;
        let (line, vertex, part) = facts.beyond_sixteen_bits?;
        // Other numbers are those of another text.
        (own.content == Some(facts.thousandths)).then_some((file, line, vertex, part))
    };
    let found: Vec<(&FileFacts, u32, i64, f32)> = archive
        .content
        .targets
        .iter()
        .filter_map(of_member)
        .collect();
    let Some((file, line, vertex, part)) = found.first() else {
        return;
    };
    let more = and_more(found.len(), "target");
    let message = if part.abs() >= PACKED_PART {
        format!(
            "vertex {vertex} moves by {}, and in `targets.npz` by {}{more}",
            length(*part),
            length(around(*part))
        )
    } else {
        format!(
            "vertex {vertex} is vertex {} in `targets.npz`{more}",
            vertex.rem_euclid(1 << 16)
        )
    };
    let finding = RULE.at(file, Place::Line(*line), message).related(
        archive.file.path.clone(),
        Place::File,
        "the archive",
    );
    let finding = finding.evidence(Evidence::of_cases(found.iter().map(|(file, ..)| &file.rel)));
    out.push(finding.help(
        "make the displacement smaller, or delete `targets.npz` and `images.list`: then \
                the texts are read",
    ));
}

/// What becomes of a number of decimetres in 16 bits of thousandths.
fn around(part: f32) -> f32 {
    let range = 2.0 * PACKED_PART;
    (part + PACKED_PART).rem_euclid(range) - PACKED_PART
}
