//! Pictures of one name: of the sliders that MPFB brings, and those beside users' targets.

use std::collections::BTreeMap;

use super::super::Rule;
use mhlint_diag::{Finding, Place};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;
use mhlint_source::{extension, parent};

/// One finding for each picture that takes the place of another.
pub(super) fn findings(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let mut known: BTreeMap<String, &FileFacts> = BTreeMap::new();
    let of_system = view
        .layers
        .system
        .into_iter()
        .flat_map(|layer| layer.below("targets/_images"));
    let shipped = of_system
        .filter(|file| extension(&file.rel) == "png")
        .map(|file| {
            let stem = file.stem();
            (
                stem.strip_prefix("l-")
                    .or_else(|| stem.strip_prefix("r-"))
                    .unwrap_or(stem)
                    .to_owned(),
                file,
            )
        });
    let checked = view.layers.checked;
    let own = view
        .user_targets()
        .filter(|target| target.file.rel.starts_with("targets/"));
    let own = own.filter_map(|target| {
        let beside = |suffix: &str| {
            checked.file(&format!(
                "{}/{}.{suffix}",
                parent(&target.file.rel),
                target.name
            ))
        };
        Some((
            target.name.clone(),
            beside("thumb").or_else(|| beside("png"))?,
        ))
    });
    for (name, file) in shipped.chain(own) {
        let Some(other) = known
            .insert(name.clone(), file)
            .filter(|other| !std::ptr::eq(*other, file))
        else {
            continue;
        };
        let (told, other) = if view.layers.is_checked(file) {
            (file, other)
        } else {
            (other, file)
        };
        if view.layers.is_checked(told) {
            let message = format!(
                "is a picture for `{name}`, as {} is",
                view.layers.named(other)
            );
            let finding = rule.at(told, Place::File, message).key("picture");
            let finding = finding.related(other.path.clone(), Place::File, "the other picture");
            out.push(
                finding.help(
                    "remove one of the pictures, or rename one of the targets with its picture",
                ),
            );
        }
    }
}
