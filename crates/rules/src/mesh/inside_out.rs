//! The faces of an asset look outwards.

use super::super::cause::worn::meshes;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Confidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lights the asset from its inner side, and exports it inside out",
        ),
        (
            Makehuman1,
            "shows the inner side of the asset, lit from the wrong side",
        ),
        (
            Mpfb,
            "puts the asset on with its faces looking inwards: backface culling hides it, and \
                exports are inside out",
        ),
    ],
    docs: include_str!("inside_out.md").trim_ascii_end(),
    ..RuleInfo::new(
        "mesh-inside-out",
        Level::Warning,
        "all faces of an asset look inwards",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_inside_out = |path: &str| {
        measures
            .worn
            .get(path)
            .is_some_and(|measure| measure.is_inside_out)
    };
    for (_, file, _) in meshes(body, |worn, _| is_inside_out(&worn.file.path)) {
        let finding = RULE.at(file, Place::File, "all faces look inwards");
        let help = "turn the faces over, in Blender with Mesh > Normals > Recalculate Outside, \
            and export the mesh again";
        out.push(finding.confidence(Confidence::Medium).help(help));
    }
}
