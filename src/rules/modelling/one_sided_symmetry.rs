//! Partners must name each other, the left one with `rsym` and the right one with `lsym`.

use super::super::{Check, Rule, RuleCx};
use super::with_patterns;
use crate::diag::{Application, Case, Finding, Level, Place, RuleInfo};
use crate::formats::modelling::Slider;
use crate::repo::makehuman2::{Base, BoundSlider, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "mirrors the slider in one direction only, or to the wrong side")],
        docs: "A left slider names its right partner with `rsym`, and the right one its left partner with `lsym`. Of an entry that \
            has both only `rsym` is read.\n\nIf the partner does not point back, changes of one side are mirrored \
            and those of the other are not. If the sides are swapped, \"make symmetric\" copies the wrong way. A partner that is a macro, or a corner of a triangle, has no targets to \
            mirror: with symmetry switched on, the program stops with an AttributeError as soon as the slider moves (an error).\n\nLet both \
            name each other, each with the key of its own side.",
        ..RuleInfo::new("modelling-one-sided-symmetry", Level::Warning, "a symmetric partner does not point back")
    },
    check: Check::Makehuman2(run),
};

/// What mirrors is the targets of the partner.
const WITHOUT_TARGETS: Case = &[(
    Application::Makehuman2,
    Level::Error,
    "stops with an AttributeError when the slider moves while symmetry is on: its partner has no targets",
)];

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in with_patterns(base).unwrap_or_default() {
        let Some(link) = Link::of(bound) else { continue };
        let Some(partner) = base.slider(link.partner) else { continue };
        if let Some((message, help)) = fault(base, bound, &link, partner) {
            let key = bound.slider.key.as_str();
            let mut finding = RULE.at(bound.file, Place::pointer([key, link.member]), message).key(key).help(help);
            if has_no_targets(partner) {
                finding = finding.case(WITHOUT_TARGETS);
            }
            if !std::ptr::eq(partner, bound) {
                finding = finding.related(partner.file.path.clone(), Place::key([&partner.slider.key]), "the partner");
            }
            out.push(finding);
        }
    }
}

/// The link that is read: `rsym` before `lsym`.
struct Link<'s> {
    member: &'static str,
    partner: &'s str,
}

impl<'s> Link<'s> {
    fn of(bound: &'s BoundSlider<'_>) -> Option<Self> {
        Self::of_slider(bound.slider)
    }

    fn of_slider(slider: &'s Slider) -> Option<Self> {
        let right = slider.rsym.as_deref().map(|partner| Self { member: "rsym", partner });
        right.or_else(|| slider.lsym.as_deref().map(|partner| Self { member: "lsym", partner }))
    }

    /// The key that the partner has to use.
    fn back(&self) -> &'static str {
        if self.member == "rsym" { "lsym" } else { "rsym" }
    }
}

fn fault(
    base: &Base<'_>,
    bound: &BoundSlider<'_>,
    link: &Link<'_>,
    partner: &BoundSlider<'_>,
) -> Option<(String, String)> {
    let (own, other) = (bound.slider.key.as_str(), partner.slider.key.as_str());
    let names = bound.pattern.names();
    let pattern = names.first().map(String::as_str).unwrap_or_default();
    if std::ptr::eq(partner, bound) {
        return Some((format!("`{own}` is its own partner"), "name the slider of the other side".to_owned()));
    }
    if has_no_targets(partner) {
        let what = if partner.slider.barycentric.is_some() { "a triangle" } else { "a macro" };
        let help = "name the slider of the other side".to_owned();
        return Some((format!("`{own}` has the partner `{other}`, which is {what}"), help));
    }
    if bound.slider.rsym.is_some() && bound.slider.lsym.is_some() {
        let help = "a left slider has `rsym` only, a right slider `lsym` only".to_owned();
        return Some((format!("`{own}` has both `rsym` and `lsym`; only `rsym` is read"), help));
    }
    let Some(back) = Link::of(partner) else {
        // A misspelt key, or a value of a wrong type, is a finding of its own.
        let meant = Link::of_slider(partner.as_meant()).is_some();
        if meant || partner.slider.has("rsym") || partner.slider.has("lsym") {
            return None;
        }
        let help = format!("add `\"{}\": \"{pattern}\"` to `{other}`", link.back());
        return Some((format!("`{own}` has the partner `{other}`, which has none"), help));
    };
    if !names.iter().any(|name| name == back.partner) {
        // A name that leads nowhere, or to a third slider that does not point back, is the partner's finding.
        let third = base.slider(back.partner).and_then(Link::of)?;
        if !partner.pattern.names().iter().any(|name| name == third.partner) {
            return None;
        }
        let help = format!("write `\"{}\": \"{pattern}\"` in `{other}`, or correct the partner here", link.back());
        return Some((format!("`{own}` has the partner `{other}`, whose partner is `{}`", back.partner), help));
    }
    if back.member == link.member {
        // Seen from both sides; told once.
        let side = if link.member == "rsym" { "left" } else { "right" };
        let help = format!("one of them must use `{}`", link.back());
        return (own < other).then(|| (format!("`{own}` and `{other}` both say that they are the {side} one"), help));
    }
    let swapped = link.member == "rsym" && side_of(bound) == Some('r') && side_of(partner) == Some('l');
    swapped.then(|| {
        let help = "the left slider has `rsym`, the right one `lsym`".to_owned();
        (format!("`{own}` and `{other}` have their sides swapped"), help)
    })
}

/// Whether a slider has nothing but macros to move.
fn has_no_targets(bound: &BoundSlider<'_>) -> bool {
    bound.slider.is_macro() && bound.slider.incr.is_none()
}

/// The side that the file name of the target begins with.
fn side_of(bound: &BoundSlider<'_>) -> Option<char> {
    let stem = bound.slider.incr.as_deref()?.rsplit('/').next()?;
    let (side, _) = stem.split_once('-')?;
    match side {
        "l" => Some('l'),
        "r" => Some('r'),
        _ => None,
    }
}
