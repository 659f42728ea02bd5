//! Lines with too few words. Each of them is lost, and the other lines are loaded.

use super::super::super::Rule;
use super::super::short_lines::finding;
use super::own;
use mhlint_diag::{Finding, Place};
use mhlint_formats::mhm::lines::Line;
use mhlint_formats::mhm::{CATEGORIES, ShortLine};
use mhlint_formats::python_float;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

pub(in super::super) fn faults(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for model in own(view) {
        let short: Vec<ShortLine> = model.lines.all.iter().filter_map(short).collect();
        let effect = "fails with `IndexError` at the line, and loads the model without it";
        out.extend(finding(rule, model.file, &short).map(|finding| finding.effect(effect)));
        out.extend(
            model
                .lines
                .of("camera")
                .filter_map(|line| camera(rule, model.file, line)),
        );
    }
}

/// A finding if one of the first six values of a line `camera` is not a number.
fn camera(rule: &Rule, file: &FileFacts, line: &Line) -> Option<Finding> {
    let numbers = line.values.get(..6)?;
    let word = numbers
        .iter()
        .find(|word| python_float(word.text.as_bytes()).is_none())?;
    let message = format!("`{}` of `camera` is not a number", word.text);
    let finding = rule
        .at(file, Place::Span(word.span.clone()), message)
        .key("camera");
    let finding =
        finding.effect("fails with `ValueError` at the line, and loads the model without it");
    Some(finding.help("write six numbers with decimal points, or remove the line"))
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
    (found < needed).then(|| ShortLine {
        keyword: line.keyword.clone(),
        found,
        needed,
    })
}
