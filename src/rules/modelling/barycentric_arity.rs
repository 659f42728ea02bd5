//! A triangle has three corners and three colours.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, BoundSlider, View};

/// Corners of the triangle slider; also parts of a colour.
const THREE: usize = 3;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError at start")],
        docs: "`barycentric` makes a triangle slider: exactly three patterns, one for each corner. `barycentric_diffuse` gives each corner a \
            colour: three colours of three numbers.\n\nWith any other number of patterns MakeHuman 2 stops at start. Colours that are \
            missing cannot be mixed; surplus ones are never used (a warning).\n\nGive exactly three of each.",
        ..RuleInfo::new("modelling-barycentric-arity", Level::Error, "`barycentric` or its colours are not three")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let slider = bound.slider;
        if slider.barycentric.is_some() && slider.barycentric_len != THREE {
            let message =
                format!("`barycentric` of `{}` has {} patterns instead of 3", slider.key, slider.barycentric_len);
            out.push(finding(bound, "barycentric", message));
        }
        // What is no list of colours is reported by the schema.
        let Some(colours) = &slider.barycentric_colours else { continue };
        if colours.len() != THREE {
            let message =
                format!("`barycentric_diffuse` of `{}` has {} colours instead of 3", slider.key, colours.len());
            out.push(coloured(bound, message, colours.len() > THREE));
        } else if let Some(parts) = colours.iter().find(|parts| **parts != THREE) {
            let message = format!("a colour of `{}` has {parts} numbers instead of 3", slider.key);
            out.push(coloured(bound, message, *parts > THREE));
        }
    }
}

fn finding(bound: &BoundSlider<'_>, member: &str, message: String) -> Finding {
    let key = bound.slider.key.as_str();
    RULE.at(bound.file, Place::pointer([key, member]), message)
        .key(format!("{key} {member}"))
        .help("give exactly three")
}

fn coloured(bound: &BoundSlider<'_>, message: String, surplus: bool) -> Finding {
    let finding = finding(bound, "barycentric_diffuse", message);
    if surplus {
        return finding.level(Level::Warning).effect("never uses what is beyond three");
    }
    finding.effect("cannot mix the skin colour of a skin without diffuse texture")
}
