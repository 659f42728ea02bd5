//! What each data folder was taken for, and why, where that is not plain.

use super::count;
use mhlint_diag::{Application, Outcome, PlaceKind, RootSummary, Sign, Speaks, Version};

/// Data folders that are named.
const NAMED: usize = 4;

/// A line for each data folder that may have been meant otherwise; with `full` for all. Not made
/// harmless yet.
pub(super) fn lines(outcome: &Outcome, full: bool) -> Vec<String> {
    let roots: Vec<&RootSummary> = outcome
        .roots
        .iter()
        .filter(|root| is_worth_a_line(root, full))
        .collect();
    let named = if full { roots.len() } else { NAMED };
    let mut lines: Vec<String> = roots.iter().take(named).map(|root| line(root)).collect();
    let more = roots.len().saturating_sub(named);
    lines.extend((more > 0).then(|| {
        format!(
            "`--full` says what {} were taken for.",
            count(more, "more data folder")
        )
    }));
    lines
}

/// What is certainly the data of a program, and new, needs no word.
fn is_worth_a_line(root: &RootSummary, full: bool) -> bool {
    let identity = &root.identity;
    let is_old = identity.version.is_some_and(|version| !version.is_newest());
    let is_special = matches!(identity.kind, Some(PlaceKind::Partial | PlaceKind::Release));
    !identity.evidence.is_empty() && (full || !identity.is_certain || is_old || is_special)
}

fn line(root: &RootSummary) -> String {
    let identity = &root.identity;
    let signs = |speaks: Speaks| {
        identity
            .evidence
            .iter()
            .filter(move |sign| sign.speaks == speaks)
    };
    let own: Vec<&str> = signs(Speaks::For).map(|sign| sign.sign.as_str()).collect();
    let against = signs(Speaks::Against).map(
        |Sign {
             application, sign, ..
         }| format!("; not {application}: {sign}"),
    );
    let what = what(root.application, identity.kind, identity.version);
    format!(
        "`{}` was taken for {what}: {}{}.",
        root.path,
        own.join(", "),
        against.collect::<String>()
    )
}

/// `the folder of a user of MakeHuman 1`.
fn what(application: Application, kind: Option<PlaceKind>, version: Option<Version>) -> String {
    let whose = version.map_or_else(|| application.to_string(), Version::title);
    match kind {
        Some(PlaceKind::Program) | None => format!("the data of {whose}"),
        Some(PlaceKind::Release) => format!("the compiled data of {whose}"),
        Some(PlaceKind::Partial) => format!("a part of the data of {whose}"),
        Some(PlaceKind::User) => format!("a user's folder of {whose}"),
        Some(PlaceKind::Pack) => format!("a pack for {whose}"),
        Some(PlaceKind::Asset) => format!("an asset for {whose}"),
        Some(PlaceKind::Loose) => format!("files for {whose}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::Identity;

    #[test]
    fn a_line_says_what_speaks_for_one_and_against_others() {
        let sign = |application, speaks, sign: &str| Sign {
            application,
            speaks,
            sign: sign.to_owned(),
        };
        let evidence = vec![
            sign(Application::Makehuman1, Speaks::For, "custom/"),
            sign(Application::Makehuman1, Speaks::For, ".mhpxy"),
            sign(Application::Makehuman2, Speaks::Against, "no base.json"),
        ];
        let identity = Identity {
            kind: Some(PlaceKind::User),
            evidence,
            ..Identity::default()
        };
        let root = |identity: Identity| RootSummary {
            path: "mine".to_owned(),
            application: Application::Makehuman1,
            bases: Vec::new(),
            identity,
        };
        let of = |roots: Vec<RootSummary>, full| {
            lines(
                &Outcome {
                    roots,
                    ..Outcome::default()
                },
                full,
            )
        };
        let expected = "`mine` was taken for a user's folder of MakeHuman 1: custom/, .mhpxy; not \
            MakeHuman 2: no base.json.";
        assert_eq!(of(vec![root(identity.clone())], false), [expected]);
        let certain = Identity {
            kind: Some(PlaceKind::Program),
            is_certain: true,
            ..identity.clone()
        };
        assert_eq!(of(vec![root(certain.clone())], false), Vec::<String>::new());
        assert_eq!(of(vec![root(certain.clone())], true).len(), 1);
        let old = Identity {
            version: Version::named(Application::Makehuman1, "1.1"),
            ..certain
        };
        assert!(of(vec![root(old)], false)[0].contains("the data of MakeHuman 1.1"));
        let many = of(vec![root(identity); 6], false);
        assert_eq!(
            many.last().unwrap(),
            "`--full` says what 2 more data folders were taken for."
        );
    }
}
