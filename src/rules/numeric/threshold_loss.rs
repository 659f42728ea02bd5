//! What the cut-off of small factors throws away.

use super::super::{Check, Rule, RuleCx};
use super::{percent, title, worded};
use crate::diag::{Application, Evidence, Finding, Level, OptionInfo, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::eval::settings::SliderSetting;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "applies so much less of the shape between the steps, and gives it to nobody",
        )],
        docs: "MakeHuman 2 multiplies the weights of all components of a macrodef and drops every combination whose product is \
            0.01 or less. What is dropped is not given to the others, so that between the steps a part of the shape is \
            missing. The more components, the more: at worst 2 % with two, 4 % with three, 8 % with four, 17 % with five, \
            36 % with six components of which each stands between two steps.\n\nReported is the macrodef that loses most, at \
            the worst setting found, once a `macro.json`. Nothing needs to be done; splitting a macrodef with many \
            components makes the loss smaller.",
        options: &[OptionInfo { name: "percent", default: 5.0, docs: "how much weight may be lost, in percent" }],
        ..RuleInfo::new("numeric-threshold-loss", Level::Info, "much weight is lost to the cut-off of small factors")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = body.macros else { return };
    let limit = cx.option(&RULE, "percent") / 100.0;
    let over = || measures.macros.losses.iter().filter(|(_, lost, _)| *lost > limit);
    let Some((number, lost, at)) = over().max_by(|a, b| a.1.total_cmp(&b.1)) else { return };
    let Some(macrodef) = macros.macrodefs.get(*number) else { return };
    let (title, share) = (title(macrodef), percent(*lost));
    let message = format!(
        "macrodef `{title}` loses {share} of its weight to the cut-off of factors up to 0.01, at {}",
        worded(at)
    );
    let named = |(number, lost, _): &(usize, f64, Vec<SliderSetting>)| {
        let name = macros.macrodefs.get(*number).map(super::title).unwrap_or_default();
        format!("{name}: {}", percent(*lost))
    };
    out.push(
        RULE.at(file, Place::pointer(["macrodef", &macrodef.index.to_string(), "comp"]), message)
            .key("loss")
            .parts(over().map(|(number, ..)| macros.macrodefs.get(*number).map(super::title).unwrap_or_default()))
            .help("nothing needs to be done; fewer components in a macrodef lose less")
            .evidence(Evidence::of_cases(over().map(named)).out_of(macros.macrodefs.len()).with_worst(*lost, title)),
    );
}
