//! Partners must name each other, the left one with `rsym` and the right one with `lsym`.

use super::super::{Check, Rule, RuleCx};
use super::{counterpart, with_patterns};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "mirrors the slider only one way, or to the wrong side",
    )],
    docs: include_str!("one_sided_symmetry.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-one-sided-symmetry",
        Level::Warning,
        "a left/right counterpart does not point back",
    )
});

const ALONE: &str = "write the pattern of the left/right counterpart, or remove the key from a \
    slider that has none";
const COUNTERPART: &str = "write the pattern of the left/right counterpart";

const ONE_WAY: &str = "mirrors changes of this slider to its counterpart, but not back";
const TO_ITSELF: &str = "mirrors the slider to itself: no other slider follows";
const WRONG_SIDE: &str = "copies the wrong side when the figure is made symmetric";

/// What mirrors is the targets of the partner.
const WITHOUT_TARGETS: &str = "crashes with `AttributeError` when the slider moves while symmetry \
    is on: its counterpart has no targets";

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in with_patterns(base).unwrap_or_default() {
        let Some((member, partner)) = counterpart(bound.slider) else {
            continue;
        };
        let Some(partner) = base.slider(partner) else {
            continue;
        };
        if let Some((message, effect, help)) = fault(base, bound, member, partner) {
            let key = bound.slider.key.as_str();
            let mut finding = RULE
                .at(bound.file, Place::pointer([key, member]), message)
                .key(key)
                .help(help);
            finding = finding.effect(effect);
            if has_no_targets(partner) {
                finding = finding.level(Level::Error);
            }
            if !std::ptr::eq(partner, bound) {
                finding = finding.related(
                    partner.file.path.clone(),
                    Place::key([&partner.slider.key]),
                    "the counterpart",
                );
            }
            out.push(finding);
        }
    }
}

fn fault(
    base: &Base<'_>,
    bound: &BoundSlider<'_>,
    member: &str,
    partner: &BoundSlider<'_>,
) -> Option<(String, &'static str, String)> {
    // The key that the partner has to use.
    let back = if member == "rsym" { "lsym" } else { "rsym" };
    let (own, other) = (bound.slider.key.as_str(), partner.slider.key.as_str());
    let names = bound.pattern.names();
    let pattern = names.first().map(String::as_str).unwrap_or_default();
    if std::ptr::eq(partner, bound) {
        let effect = if has_no_targets(partner) {
            WITHOUT_TARGETS
        } else {
            TO_ITSELF
        };
        return Some((
            format!("`{own}` is its own counterpart"),
            effect,
            ALONE.to_owned(),
        ));
    }
    if has_no_targets(partner) {
        let what = if partner.slider.barycentric.is_some() {
            "a triangle"
        } else {
            "a macro"
        };
        let message = format!("`{own}` has the counterpart `{other}`, which is {what}");
        return Some((message, WITHOUT_TARGETS, COUNTERPART.to_owned()));
    }
    if bound.slider.rsym.is_some() && bound.slider.lsym.is_some() {
        let help = "keep only `rsym` in a left slider, only `lsym` in a right one".to_owned();
        return Some((
            format!("`{own}` has both `rsym` and `lsym`; only `rsym` is read"),
            ONE_WAY,
            help,
        ));
    }
    let Some((its_member, its_partner)) = counterpart(partner.slider) else {
        // A misspelt key, or a value of a wrong type, is a finding of its own.
        let meant = counterpart(partner.as_meant()).is_some();
        if meant || partner.slider.has("rsym") || partner.slider.has("lsym") {
            return None;
        }
        let help = format!("add `\"{back}\": \"{pattern}\"` to `{other}`");
        return Some((
            format!("`{own}` has the counterpart `{other}`, which has none"),
            ONE_WAY,
            help,
        ));
    };
    if !names.iter().any(|name| name == its_partner) {
        // A name that leads nowhere, or to a third slider that does not point back, is the
        // partner's finding.
        let (_, third) = counterpart(base.slider(its_partner)?.slider)?;
        if !partner.pattern.names().iter().any(|name| name == third) {
            return None;
        }
        let help = format!("correct `{member}` here: `{other}` has a counterpart of its own");
        return Some((
            format!("`{own}` has the counterpart `{other}`, which names `{its_partner}`"),
            ONE_WAY,
            help,
        ));
    }
    if its_member == member {
        // Seen from both sides; told once.
        let side = if member == "rsym" { "left" } else { "right" };
        let help = format!("use `{back}` in one of them");
        let message = || {
            format!("`{own}` and `{other}` both have `{member}`, as if both were {side} sliders")
        };
        return (own < other).then(|| (message(), WRONG_SIDE, help));
    }
    let swapped = member == "rsym" && side_of(bound) == Some("r") && side_of(partner) == Some("l");
    swapped.then(|| {
        let help = "use `rsym` in the left slider, `lsym` in the right one".to_owned();
        (
            format!("`{own}` and `{other}` have `rsym` and `lsym` swapped"),
            WRONG_SIDE,
            help,
        )
    })
}

/// Whether a slider has nothing but macros to move.
fn has_no_targets(bound: &BoundSlider<'_>) -> bool {
    bound.slider.is_macro() && bound.slider.incr.is_none()
}

/// What the file name of the target has before its first `-`: `l` and `r` are sides.
fn side_of<'s>(bound: &BoundSlider<'s>) -> Option<&'s str> {
    let stem = bound.slider.incr.as_deref()?.rsplit('/').next()?;
    stem.split_once('-').map(|(side, _)| side)
}
