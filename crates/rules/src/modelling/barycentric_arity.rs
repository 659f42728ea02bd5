//! A triangle has three corners and three colours.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

const CANNOT_MIX: &str = "crashes with `ValueError` whenever the triangle slider moves: it mixes \
    three colours of three numbers each";
const MIXES_OTHERS: &str = "mixes the skin colour without the corners that have no colour";
/// Corners of the triangle slider; also parts of a colour.
const THREE: usize = 3;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `IndexError` at start")],
    docs: include_str!("barycentric_arity.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-barycentric-arity",
        Level::Error,
        "`barycentric` does not have exactly three patterns or colours",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let slider = bound.slider;
        if slider.barycentric.is_some() && slider.barycentric_len != THREE {
            let patterns = counted(slider.barycentric_len, "pattern");
            let message = format!(
                "`barycentric` of `{}` has {patterns} instead of 3",
                slider.key
            );
            out.push(finding(bound, "barycentric", message));
        }
        // What is no list of colours is reported by the schema.
        let Some(colours) = &slider.barycentric_colours else {
            continue;
        };
        if colours.len() != THREE {
            let count = counted(colours.len(), "colour");
            let message = format!(
                "`barycentric_diffuse` of `{}` has {count} instead of 3",
                slider.key
            );
            let effect = if colours.len() > THREE {
                "never uses the surplus colours"
            } else {
                MIXES_OTHERS
            };
            out.push(
                finding(bound, "barycentric_diffuse", message)
                    .level(Level::Warning)
                    .effect(effect),
            );
        } else if let Some(parts) = colours.iter().find(|parts| **parts != THREE) {
            let message = format!(
                "a colour of `{}` has {} instead of 3",
                slider.key,
                counted(parts, "number")
            );
            out.push(finding(bound, "barycentric_diffuse", message).effect(CANNOT_MIX));
        }
    }
}

fn finding(bound: &BoundSlider<'_>, member: &str, message: String) -> Finding {
    let key = bound.slider.key.as_str();
    RULE.at(bound.file, Place::pointer([key, member]), message)
        .key(format!("{key} {member}"))
        .help("write exactly three")
}
