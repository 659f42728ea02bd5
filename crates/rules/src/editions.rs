//! What one version of an application does with a fault, where the words for all of them name
//! several (`docs/loaders/versions.md#where-loaders-differ`,
//! `docs/loaders/makehuman2/program.md#newer-program`).

use mhlint_diag::{Application, Application::Makehuman2, Finding};
use mhlint_repo::View;

/// A part of a consequence that is not that of all versions.
struct Differing {
    application: Application,
    /// The words where the version is not known.
    any: &'static str,
    /// The words of versions before others, the oldest first.
    before: &'static [(&'static str, &'static str)],
    /// The words of the newest.
    newest: &'static str,
}

const DIFFERING: [Differing; 3] = [
    Differing {
        application: Makehuman2,
        any: super::cause::consequence::NOT_SCANNED,
        before: &[
            ("2026-08-05", "logs a line and does not list the file"),
            (
                "2026-08-20",
                "crashes at start with `AttributeError` while scanning the assets",
            ),
        ],
        newest: "logs a line and does not list the file",
    },
    Differing {
        application: Makehuman2,
        any: "the glTF export crashes up to 2026-08-05 for a model with a skeleton, newer ones \
            leave out the weights",
        before: &[(
            "2026-08-20",
            "the glTF export crashes for a model with a skeleton",
        )],
        newest: "the glTF export leaves out the weights",
    },
    Differing {
        application: Makehuman2,
        any: ", up to 2026-08-05 also in the glTF export",
        before: &[("2026-08-20", " and in the glTF export")],
        newest: "",
    },
];

/// Words the consequences for the version that the data are of, or that is asked for.
pub fn word_for_version(view: &View<'_>, findings: &mut [Finding]) {
    let Some(version) = view.version() else {
        return;
    };
    let own = DIFFERING
        .iter()
        .filter(|one| one.application == view.application());
    for Differing {
        any,
        before,
        newest,
        ..
    } in own
    {
        let words = before
            .iter()
            .find(|(other, _)| version.is_before(other))
            .map_or(*newest, |(_, words)| *words);
        let effects = findings.iter_mut().flat_map(|finding| &mut finding.breaks);
        for one in effects.filter(|one| one.effect.contains(any)) {
            one.effect = one.effect.replace(any, words);
        }
    }
}
