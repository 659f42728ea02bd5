//! Rows are in the order of the vertices.

use super::super::{Check, Rule, RuleCx};
use super::{is_told_by_scale, measured, numbering};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "draws the asset crumpled: its faces join vertices that do not belong together",
        ),
        (
            Makehuman1,
            "draws the asset crumpled: its faces join vertices that do not belong together",
        ),
        (
            Mpfb,
            "puts the asset on crumpled: its faces join vertices that do not belong together",
        ),
    ],
    docs: include_str!("rows_reordered.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-rows-reordered",
        Level::Warning,
        "rows in another order than the vertices of the OBJ",
    )
});

const MIRRORED: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "lights the asset from its inner side, and exports it inside out",
    ),
    (
        Makehuman1,
        Level::Warning,
        "shows the inner side of the asset, lit from the wrong side",
    ),
    (
        Mpfb,
        Level::Warning,
        "puts the asset on with its faces looking inwards: backface culling hides it, and exports \
            are inside out",
    ),
];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (text, measure) in measured(body, measures) {
        let Some(disorder) = measure
            .shape
            .disorder
            .filter(|_| !is_told_by_scale(body, &text))
        else {
            continue;
        };
        let mesh = text
            .worn
            .mesh()
            .map_or("its OBJ", |(file, _)| file.file_name());
        let longer = disorder.longer;
        let message = if disorder.is_mirrored {
            format!("fitted, the asset is the mirror image of `{mesh}`, and its faces look inwards")
        } else if longer >= 1.05 {
            format!(
                "fitted, the faces join other places than in `{mesh}`: their edges are \
                    {longer:.1} times as long"
            )
        } else {
            format!("fitted, the asset has another shape than in `{mesh}`")
        };
        let help = "export the OBJ and the .mhclo together, after the last change of the mesh";
        let help = match measure.shape.numbering {
            _ if disorder.is_mirrored => {
                "export the OBJ and the .mhclo together, without mirroring the mesh between them"
            }
            Some(other) => numbering(other),
            None => help,
        };
        let finding = RULE
            .at(text.file, Place::Line(text.clothes.line_of(0)), message)
            .help(help);
        out.push(if disorder.is_mirrored {
            finding.case(MIRRORED)
        } else {
            finding
        });
    }
}
