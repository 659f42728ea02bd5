//! A base with sliders and without `target_cat.json`.

use super::super::Rule;
use mhlint_diag::{Finding, Level, Place};
use mhlint_repo::makehuman2::{Base, View};

/// The sliders are there, but nothing that shows them.
pub(super) fn finding(rule: &Rule, view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let absent = [
        base.categories.contarget.file(),
        base.categories.system.file(),
    ]
    .iter()
    .all(Option::is_none);
    let (file, modelling) = base.modelling.winner()?;
    let rel = format!("target/{}/target_cat.json", base.name);
    // Written with other capitals it is a finding of its own.
    let misnamed = view
        .layers
        .strongest_first()
        .any(|layer| layer.file_ignoring_case(&rel).is_some());
    // Only system data can prove that there is none.
    let is_proven = view.layers.system.is_some() && !view.layers.is_one_root();
    if !absent || misnamed || !is_proven || modelling.sliders.is_empty() {
        return None;
    }
    let message = match modelling.sliders.len() {
        1 => "target_cat.json is missing, so the only slider is never shown".to_owned(),
        count => format!("target_cat.json is missing, so none of the {count} sliders is shown"),
    };
    let help = "add a target_cat.json with an item for every group of the sliders";
    // Generated sliders go with generated categories, which are written anew.
    let level = if modelling.sliders.iter().all(|slider| slider.user) {
        Level::Warning
    } else {
        Level::Error
    };
    Some(rule.at(file, Place::File, message).level(level).help(help))
}
