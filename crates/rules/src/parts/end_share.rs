//! The most that the ends of the sliders reach.

use super::super::{Check, Rule, RuleCx};
use super::stretch::{checked, ranges, whole};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::cover::is_live;
use mhlint_eval::mpfb::shares::rounded;
use mhlint_formats::macro_parts::{Part, Setting};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "never shows the shape in full: a share of its neighbour stays at the end of the slider",
    )],
    docs: include_str!("end_share.md").trim_ascii_end(),
    counts: "ends of sliders",
    ..RuleInfo::new(
        "parts-end-share",
        Level::Info,
        "the end of a slider does not reach its shape in full",
    )
});

/// An end of a slider with the share that it reaches.
struct End<'p> {
    setting: &'p Setting,
    part: &'p Part,
    member: &'static str,
    name: &'p str,
    share: f64,
}

/// An end that reaches less is of no use: the bounds are not those of a slider.
const HALF: f64 = 0.5;
const MOST_LOST: Case = &[(
    Mpfb,
    Level::Warning,
    "never shows most of the shape, also on the default character",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    let all: Vec<End<'_>> = whole(parts).flat_map(ends).collect();
    let short: Vec<&End<'_>> = all.iter().filter(|end| end.share < 1.0).collect();
    let Some(worst) = short
        .iter()
        .min_by(|one, other| one.share.total_cmp(&other.share))
    else {
        return;
    };
    let others = match short.len() {
        1 => String::new(),
        count => format!(
            "; {} of {} ends do not reach their shape in full",
            count,
            all.len()
        ),
    };
    let (name, at) = (worst.setting.name(), worst.value());
    let message = format!(
        "`{name}` at {at} reaches {} % of `{}`{others}",
        percent(worst.share),
        worst.name
    );
    let place = Place::Pointer(worst.setting.pointer(worst.part, worst.member));
    let cases = short
        .iter()
        .map(|end| format!("{} {}", end.setting.name(), end.value()));
    let said = short.iter().map(|end| {
        format!(
            "{} {}: {} %",
            end.setting.name(),
            end.value(),
            percent(end.share)
        )
    });
    let evidence = Evidence::of_cases(cases)
        .showing(said.take(mhlint_diag::EXAMPLES))
        .out_of(all.len());
    let finding = RULE
        .at(parts.file, place, message)
        .key("ends")
        .evidence(evidence);
    out.push(if worst.share < HALF {
        finding
            .case(MOST_LOST)
            .help("write the bounds in the range of the slider, from 0 to 1")
    } else {
        finding.help(
            "leave it as it is unless the targets are made again; closer bounds, such as \
                -0.00001, reach the full shape",
        )
    });
}

/// The ends of a slider that a single part covers and names.
fn ends(setting: &Setting) -> impl Iterator<Item = End<'_>> {
    let ranges = ranges(setting);
    let end = move |value: f64, member: &'static str| {
        let is_there = |(lowest, highest): (f64, f64)| {
            is_live((lowest, highest)) && lowest < value && value < highest
        };
        let mut there = setting
            .parts
            .iter()
            .zip(&ranges)
            .filter(|(_, range)| is_there(**range));
        let (part, range) = there.next().filter(|_| there.next().is_none())?;
        let share = (value - range.0) / (range.1 - range.0);
        let (name, share) = if member == "lowest" {
            (&part.low, 1.0 - share)
        } else {
            (&part.high, share)
        };
        Some(End {
            setting,
            part,
            member,
            name: name.as_deref()?,
            share: rounded(share),
        })
    };
    [end(0.0, "lowest"), end(1.0, "highest")]
        .into_iter()
        .flatten()
}

impl End<'_> {
    fn value(&self) -> u8 {
        u8::from(self.member == "highest")
    }
}

/// A share in per cent, with the two decimals that four of the share leave.
fn percent(share: f64) -> f64 {
    (share * 10_000.0).round() / 100.0
}
