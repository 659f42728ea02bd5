//! Lines with too few words: each fails and is lost alone.

use super::super::super::Rule;
use super::super::short_lines::finding;
use super::own;
use crate::diag::Finding;
use crate::formats::mhm::{CATEGORIES, ShortLine};
use crate::formats::mhm_lines::Line;
use crate::repo::makehuman1::View;

pub(in super::super) fn faults(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for model in own(view) {
        let short: Vec<ShortLine> = model.lines.all.iter().filter_map(short).collect();
        let effect = "fails with `IndexError` at the line, and loads the model without it";
        out.extend(finding(rule, model.file, &short).map(|finding| finding.effect(effect)));
    }
}

fn short(line: &Line) -> Option<ShortLine> {
    let needed = match &*line.keyword.text {
        "camera" => 7,
        "material" => 3,
        "skeleton" | "pose" | "expression" | "skinMaterial" | "subdivide" | "clothesHideFaces" => 2,
        category if CATEGORIES.contains(&category) => 2,
        _ => 0,
    };
    let found = 1 + line.values.len();
    (found < needed).then(|| ShortLine { keyword: line.keyword.clone(), found, needed })
}
