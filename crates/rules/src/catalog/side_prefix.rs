//! Each slot holds the target of its side and of its end.

use super::super::{Check, Rule, RuleCx};
use super::{checked, key, place, sliders};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_formats::target_catalog::Category;
use mhlint_repo::mpfb::{View, pair};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently moves the left/right counterpart, or in the other direction",
    )],
    docs: include_str!("side_prefix.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-side-prefix",
        Level::Warning,
        "a slot holds the target of another side or end",
    )
});

const OTHER_SIDE: Case = &[(
    Mpfb,
    Level::Warning,
    "silently moves the left/right counterpart",
)];
const ONE_END: Case = &[(
    Mpfb,
    Level::Warning,
    "silently moves the same way in both directions",
)];
const OTHER_WAY: Case = &[(
    Mpfb,
    Level::Warning,
    "silently moves the other way: up where it should go down",
)];

const SIDES: [(&str, &str); 3] = [("left", "r-"), ("right", "l-"), ("unsided", "")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for (section, category) in sliders(&catalog) {
        let Some((slot, message, case)) = SIDES
            .iter()
            .find_map(|(side, other)| fault(category, side, other))
        else {
            continue;
        };
        let finding = RULE.at(
            catalog.file,
            place(section, Some(category), &["opposites", &slot]),
            message,
        );
        let help = if case == ONE_END {
            "name the target of each end"
        } else {
            "exchange the names in the slots"
        };
        out.push(finding.key(key(section, category)).case(case).help(help));
    }
}

/// The first slot of a side with another's target, and what is wrong with it.
fn fault(category: &Category, side: &str, other_side: &str) -> Option<(String, String, Case)> {
    let slots = ["negative", "positive"].map(|end| format!("{end}-{side}"));
    let [negative, positive] = slots.each_ref().map(|slot| category.slot(slot));
    let of_other_side = |stem: &&str| !other_side.is_empty() && stem.starts_with(other_side);
    for (slot, stem) in slots.iter().zip([negative, positive]) {
        if let Some(stem) = stem.filter(of_other_side) {
            return Some((
                slot.clone(),
                format!(
                    "`{slot}` of `{}` holds `{stem}`, the left/right counterpart",
                    category.name
                ),
                OTHER_SIDE,
            ));
        }
    }
    let (negative, positive, [_, slot]) = (negative?, positive?, slots);
    if negative == positive {
        return Some((
            slot,
            format!("both ends of `{}` are `{negative}`", category.name),
            ONE_END,
        ));
    }
    let (_, down, up) = pair(&category.name)?;
    let ends_in = |stem: &str, word: &str| {
        stem.strip_suffix(word)
            .is_some_and(|rest| rest.ends_with('-'))
    };
    let is_swapped = ends_in(positive, down) || ends_in(negative, up);
    is_swapped.then(|| {
        let message = format!(
            "the ends of `{}` are exchanged: `{positive}` is the positive one",
            category.name
        );
        (slot, message, OTHER_WAY)
    })
}
