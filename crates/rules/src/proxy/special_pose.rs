//! A pose for the feet costs the pose of the figure.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::mhclo::Entry;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `TypeError` at every slider while the asset is worn without another pose, and \
            shows the whole pose of the file",
    )],
    docs: include_str!("special_pose.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-special-pose",
        Level::Warning,
        "an asset with a pose of its own",
    )
});

const CUT: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put the asset on: `IndexError` when it reads the line",
)];
const UNUSED: Case = &[(
    Makehuman1,
    Level::Info,
    "keeps the line and does not use it",
)];
const MISSING: Case = &[(
    Makehuman1,
    Level::Warning,
    "logs an error when the asset is put on",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let is_one = |entry: &&Entry| {
            &*entry.keyword == "special_pose" && !entry.is_comment && !entry.has_colon
        };
        let mut lines = text.clothes.entries.iter().filter(is_one);
        let is_cut = |entry: &Entry| {
            entry
                .value
                .split(' ')
                .filter(|word| !word.is_empty())
                .count()
                < 2
        };
        let Some(first) = lines
            .clone()
            .find(|entry| is_cut(entry))
            .or_else(|| lines.next())
        else {
            continue;
        };
        let place = Place::Span(first.keyword_span.clone());
        out.push(if is_cut(first) {
            let finding = RULE
                .at(text.file, place, "`special_pose` needs a kind and a file")
                .key("words");
            finding
                .case(CUT)
                .help("remove the line, or write `special_pose foot` and the name of a `.bvh`")
        } else {
            shown(
                body,
                RULE.at(text.file, place, "").help("remove the line"),
                &first.value,
            )
        });
    }
}

/// The finding on a line that can be read.
fn shown(body: &Body<'_>, mut finding: Finding, value: &str) -> Finding {
    let mut words = value.split_whitespace();
    let (kind, name) = (
        words.next().unwrap_or_default(),
        words.next().unwrap_or_default(),
    );
    if kind != FEET {
        finding.message = format!("`special_pose {kind}`: no other kind than `{FEET}` is used");
        return finding.case(UNUSED);
    }
    let is_there = |folder: &str| {
        let rel = if folder.is_empty() {
            name.to_owned()
        } else {
            format!("{folder}/{name}")
        };
        body.layers
            .strongest_first()
            .any(|layer| layer.file(&rel).is_some())
    };
    if body.layers.system.is_some() && !is_there(FOLDER) && !is_there("") {
        finding.message = format!("the pose `{name}` of `special_pose` does not exist");
        return finding.case(MISSING);
    }
    finding.message = format!("`special_pose {value}` replaces the pose of the whole figure");
    finding
}

/// The kind of poses that is used, and where they are.
const FEET: &str = "foot";
const FOLDER: &str = "special_poses/foot";
