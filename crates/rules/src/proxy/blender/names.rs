//! What an asset names, and what it is known by (`docs/loaders/mpfb/clothes.md#mesh-of-an-asset`,
//! `docs/loaders/mpfb/clothes.md#other-effects-of-loading`,
//! `docs/loaders/mpfb/libraries.md#references-of-saved-characters`).

use super::super::keywords::corrected;
use super::super::{Text, is_unwalked, neighbours, texts};
use super::{at, whole};
use crate::cause::consequence::NO_MESH_NAMED;
use crate::{Rule, RuleCx, did_you_mean, meant_beside, shown};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place};
use mhlint_discover::{Kind, extension};
use mhlint_formats::mhclo::Entry;
use mhlint_repo::{Body, Reference, ReferenceKind, Resolution};

const NO_MESH: Case = &[(Mpfb, Level::Error, NO_MESH_NAMED)];

/// The mesh.
pub(in crate::proxy) fn mesh(
    rule: &Rule,
    body: &Body<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    for text in whole(body) {
        if text.clothes.flow.line_of("obj_file").is_none() {
            let add = "a line `obj_file` with the file name of the mesh";
            out.extend(unread(rule, &text, "obj_file", add).map(|found| found.case(NO_MESH)));
            continue;
        }
        let reference = text.worn.reference(ReferenceKind::AssetMesh);
        let Some((reference, what)) = reference.and_then(|one| Some((one, absent(body, one)?)))
        else {
            continue;
        };
        let message = format!("mesh `{}` {what}", reference.text);
        let near = cx
            .suggestions
            .nearest(reference.text, neighbours(body, &text, "obj"));
        let help = meant_beside(body.layers.checked, &reference.rel, None);
        let help =
            help.unwrap_or_else(|| did_you_mean(near, "correct the name, or restore the mesh"));
        out.push(
            rule.at(text.file, reference.place.clone(), message)
                .key(reference.text)
                .help(help),
        );
    }
}

const NONE: Case = &[(Mpfb, Level::Warning, "shows the asset without any material")];

/// The material. Proxies wear the skin.
pub(in crate::proxy) fn material(
    rule: &Rule,
    body: &Body<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    // One among other assets is not loaded at all (`library-wrong-folder`).
    let is_worn =
        |text: &Text<'_, '_>| !text.worn.is_topology() && extension(&text.file.rel) != "proxy";
    for text in whole(body).filter(is_worn) {
        if text.clothes.flow.line_of("material").is_none() {
            let add = "a line `material` with the name of a material";
            out.extend(unread(rule, &text, "material", add).map(|found| found.case(NONE)));
            continue;
        }
        let Some(reference) = text.worn.reference(ReferenceKind::AssetMaterial) else {
            continue;
        };
        let is_other =
            matches!(reference.resolution, Resolution::Found(file) if file.kind != Kind::Material);
        let Some(what) = absent(body, reference).or(is_other.then_some("is not a `.mhmat` file"))
        else {
            continue;
        };
        let message = format!("material `{}` {what}", reference.text);
        let near = cx
            .suggestions
            .nearest(reference.text, neighbours(body, &text, "mhmat"));
        let help = meant_beside(body.layers.checked, &reference.rel, None);
        let help =
            help.unwrap_or_else(|| did_you_mean(near, "correct the name, or add the material"));
        out.push(
            rule.at(text.file, reference.place.clone(), message)
                .key(reference.text)
                .help(help),
        );
    }
}

fn absent(body: &Body<'_>, reference: &Reference<'_>) -> Option<&'static str> {
    match reference.resolution {
        Resolution::Missing => Some("does not exist"),
        Resolution::Unusable if !is_unwalked(body, reference) => Some("cannot be opened as a file"),
        _ => None,
    }
}

/// A name or an identity.
pub(in crate::proxy) fn known_by(
    rule: &Rule,
    body: &Body<'_>,
    keyword: &'static str,
    out: &mut Vec<Finding>,
) {
    for text in whole(body).filter(|text| text.clothes.flow.line_of(keyword).is_none()) {
        out.extend(unread(rule, &text, keyword, &format!("a line `{keyword}`")));
    }
}

/// A keyword that is not read, in words: with a colon, where a section swallows it, or not there at
/// all. Behind a byte order mark it is another word, and the mark has a finding of its own.
fn unread(rule: &Rule, text: &Text<'_, '_>, keyword: &'static str, add: &str) -> Option<Finding> {
    if text.has_hidden(keyword) {
        return None;
    }
    let told = |place, message: String, help: String| {
        rule.at(text.file, place, message).key(keyword).help(help)
    };
    let own = |entry: &&Entry| &*entry.keyword == keyword && !entry.is_comment;
    Some(match text.clothes.entries.iter().find(own) {
        Some(entry) if entry.has_colon => {
            let message = format!("`{keyword}:` has a colon and is another word");
            told(
                Place::Span(entry.keyword_span.clone()),
                message,
                format!("write `{keyword}` without the colon"),
            )
        }
        Some(entry) => {
            let message =
                format!("`{keyword}` is directly behind a list of numbers, which swallows it");
            told(
                at(entry.line),
                message,
                "move the line above `verts`".to_owned(),
            )
        }
        None => match text.misspelt(keyword) {
            Some(entry) => {
                let message = format!("`{}` is not the keyword `{keyword}`", entry.keyword);
                told(
                    Place::Span(entry.keyword_span.clone()),
                    message,
                    format!("write `{}`", corrected(entry, keyword)),
                )
            }
            None => told(
                Place::File,
                format!("`{keyword}` is missing"),
                format!("add {add}"),
            ),
        },
    })
}

/// A licence that is recorded as another one.
pub(in crate::proxy) fn licence(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        // Of several lines the last counts.
        let is_licence = |entry: &&Entry| {
            entry.is_comment && &*entry.keyword == "license" && !entry.value.is_empty()
        };
        let Some(entry) = text.clothes.entries.iter().rfind(is_licence) else {
            continue;
        };
        let value = entry.value.to_lowercase();
        let recorded = if value.contains("by") {
            "CC-BY"
        } else if value.contains("apgl") {
            "AGPL"
        } else {
            "CC0"
        };
        let is_meant = match recorded {
            "CC0" => ["cc0", "cc-0", "cc 0", "public domain"]
                .iter()
                .any(|name| value.contains(name)),
            "AGPL" => true,
            // Its variants are licences of their own; and the word may be part of a sentence.
            _ => {
                let is_named = ["cc-by", "cc by", "ccby", "attribution"]
                    .iter()
                    .any(|name| value.contains(name));
                is_named
                    && !["-sa", "-nc", "-nd"]
                        .iter()
                        .any(|part| value.contains(part))
            }
        };
        if !is_meant {
            let shown = shown(&entry.value);
            let why = if recorded == "CC-BY" && !value.contains("cc-by") {
                ", because `by` stands in the line"
            } else {
                ""
            };
            let message = format!("licence `{shown}` is recorded as `{recorded}`{why}");
            let help = "write `# license CC0` or `# license CC-BY` if it is one of these; others \
                cannot be recorded";
            out.push(
                rule.at(text.file, Place::Span(entry.span.clone()), message)
                    .help(help),
            );
        }
    }
}
