//! The weights that an asset names, and those beside it that MPFB reads
//! (`docs/loaders/mpfb/clothes.md#lines`, `docs/loaders/mpfb/clothes.md#files-beside-an-asset`).

use super::super::{Text, texts};
use crate::Rule;
use mhlint_diag::{Finding, Place};
use mhlint_repo::{Body, FileFacts};
use mhlint_source::parent;

/// What an asset names for its weights.
struct Named<'v> {
    place: Place,
    word: &'v str,
    file: Option<&'v FileFacts>,
}

fn named<'v>(body: &Body<'v>, text: &Text<'_, 'v>) -> Option<Named<'v>> {
    let is_meant = |entry: &&mhlint_formats::mhclo::Entry| {
        entry.keyword.starts_with("vertexboneweights")
            && !entry.has_colon
            && !entry.word().is_empty()
    };
    let entry = text.clothes.entries.iter().rev().find(is_meant)?;
    let word = entry.word();
    let file = body
        .layers
        .checked
        .file(&format!("{}/{word}", parent(&text.file.rel)));
    Some(Named {
        place: Place::Span(entry.word_span()),
        word,
        file,
    })
}

/// Names that lead nowhere.
pub(in crate::proxy) fn missing(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let Some(named) = named(body, &text).filter(|named| named.file.is_none()) else {
            continue;
        };
        let folder = body.layers.checked.shown(parent(&text.file.rel));
        let message = format!("bone weights `{}` do not exist in `{folder}`", named.word);
        let finding = rule.at(text.file, named.place, message).key(named.word);
        out.push(finding.help("correct the name, restore the file, or remove the line"));
    }
}

/// Names of files that are there, and are not those which MPFB reads.
pub(in crate::proxy) fn other(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let Some((file, named)) = named(body, &text).and_then(|named| Some((named.file?, named)))
        else {
            continue;
        };
        let stem = text.file.stem();
        let is_beside = |name: &str| {
            name.strip_prefix(stem)
                .is_some_and(|rest| rest.starts_with('.'))
        };
        if is_beside(file.file_name()) && parent(&file.rel) == parent(&text.file.rel) {
            continue;
        }
        let wanted = format!("{stem}.mhw");
        let own = body
            .layers
            .checked
            .file(&format!("{}/{wanted}", parent(&text.file.rel)));
        let (message, help) = match own {
            Some(_) => (
                format!(
                    "`{}` is named for the bone weights, and `{wanted}` is read",
                    named.word
                ),
                format!("name `{wanted}` in the line, if its weights are meant"),
            ),
            None => (
                format!(
                    "`{}` is named for the bone weights, and `{wanted}` is looked for",
                    named.word
                ),
                format!(
                    "call the file `{wanted}`, put it beside the asset, and write that name in \
                        the line"
                ),
            ),
        };
        let finding = rule.at(text.file, named.place, message).key(named.word);
        out.push(
            finding
                .related(own.unwrap_or(file).path.clone(), Place::File, "the weights")
                .help(help),
        );
    }
}
