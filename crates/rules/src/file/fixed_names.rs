//! Files that are looked for by fixed names, such as `base.json`.

use super::super::Rule;
use super::super::cause::consequence::{Damage, consequence};
use mhlint_diag::{Finding, Level, Place};
use mhlint_repo::View;
use mhlint_source::file_name;

/// Findings on those with other capitals.
pub(super) fn findings(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    for file in layer
        .files
        .values()
        .filter(|file| !view.is_generated(&file.rel))
    {
        let Some(right) = (view.layout().misnamed)(&file.rel, &|rel| layer.file(rel).is_some())
        else {
            continue;
        };
        let (name, wanted) = (file.file_name(), file_name(&right));
        let message = format!("`{name}` must be named `{wanted}`");
        let loss = consequence(view, &right, Damage::Absent);
        let level = loss.map_or(Level::Error, |loss| loss.level);
        let effect = loss.and_then(|loss| loss.effect);
        let effect = effect.map_or_else(
            || format!("silently treats `{wanted}` as missing"),
            str::to_owned,
        );
        let finding = rule
            .at(file, Place::File, message)
            .key("name")
            .help(format!("rename it to `{wanted}`"));
        let finding = finding.level_in(view.application(), level);
        out.push(finding.effect_in(view.application(), format!("on Linux, {effect}")));
    }
}
