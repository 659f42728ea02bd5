//! The last lines: what was checked, and one sentence that says how it ended.

use super::{Paint, View, count, hang, phrase, printable};
use mhlint_diag::{Application, Finding, Level, Outcome, Scope, Summary, Unchecked, Verdict};

/// Names that a sentence holds, and errors that are named at the end.
const NAMED: usize = 3;

/// What was checked, and how many findings of each level there are.
pub(super) fn counts(outcome: &Outcome, view: &View<'_>) -> String {
    let line = format!(
        "{} in {} of {}",
        tally(outcome),
        files(&outcome.summary),
        roots(outcome).join(", ")
    );
    hang("", &printable(&line), view.width)
}

/// `1 error, 0 warnings, 0 infos`, and what is hidden.
pub(super) fn tally(outcome: &Outcome) -> String {
    let summary = &outcome.summary;
    let found = [
        (summary.error, "error"),
        (summary.warning, "warning"),
        (summary.info, "info"),
    ];
    let found = found.map(|(number, noun)| count(number, noun));
    let hidden = hidden(outcome).map(|(number, what)| format!("{number} {what}"));
    found
        .into_iter()
        .chain(hidden)
        .collect::<Vec<_>>()
        .join(", ")
}

/// How many findings are hidden, and by what.
pub(super) fn hidden(outcome: &Outcome) -> impl Iterator<Item = (usize, &'static str)> {
    let known = outcome.in_baseline;
    let all = [
        (known, "in the baseline"),
        (outcome.summary.suppressed.saturating_sub(known), "ignored"),
    ];
    all.into_iter().filter(|(number, _)| *number > 0)
}

/// `29 in the baseline and 1 ignored`.
fn apart_from(outcome: &Outcome) -> String {
    hidden(outcome)
        .map(|(number, what)| format!("{number} {what}"))
        .collect::<Vec<_>>()
        .join(" and ")
}

/// `86 files (344.3 kB)`.
pub(super) fn files(summary: &Summary) -> String {
    format!("{} ({})", count(summary.files, "file"), size(summary.bytes))
}

/// The checked data roots: path, application, base meshes. Not made harmless yet.
pub(super) fn roots(outcome: &Outcome) -> Vec<String> {
    outcome
        .roots
        .iter()
        .map(|root| {
            let bases = if root.bases.is_empty() {
                String::new()
            } else {
                format!(": {}", root.bases.join(", "))
            };
            format!("{} ({}{bases})", root.path, root.application)
        })
        .collect()
}

/// The verdict.
pub(super) fn sentence(outcome: &Outcome, view: &View<'_>) -> String {
    let paint = Paint { color: view.color };
    let text = hang("", &words(outcome, view), view.width);
    match (view.pass, outcome.has_at_least(Level::Error)) {
        (true, _) => paint.good(&text),
        (false, true) => paint.level(Level::Error, &text),
        (false, false) => paint.level(Level::Warning, &text),
    }
}

/// Where the first errors are, for who reads only the end of a long report.
pub(super) fn first_errors(outcome: &Outcome) -> Vec<String> {
    if outcome.findings.len() <= NAMED {
        return Vec::new();
    }
    let errors = || {
        outcome
            .findings
            .iter()
            .filter(|finding| finding.level == Level::Error)
    };
    let place = |finding: &Finding| {
        format!(
            "{}{}",
            phrase::path_of(finding),
            phrase::colons(&finding.location)
        )
    };
    let mut lines: Vec<String> = errors()
        .take(NAMED)
        .map(|finding| format!("{}: {}", place(finding), finding.rule))
        .collect();
    let left = errors().count().saturating_sub(NAMED);
    lines.extend((left > 0).then(|| format!("and {}", count(left, "more error"))));
    lines
}

/// The verdict without colour or line breaks.
pub(super) fn words(outcome: &Outcome, view: &View<'_>) -> String {
    if !outcome.is_whole() {
        return "No verdict: mhlint itself failed on this data.".to_owned();
    }
    if !outcome.checked_anything() {
        let what = outcome.nothing_in.first().and_then(|first| first.what);
        return format!("Nothing was checked: {}.", why_nothing(outcome, what));
    }
    let gone = gone(outcome);
    let Some(gravest) = Gravest::of(&outcome.findings) else {
        return match outcome.nothing_in.first() {
            Some(first) if !view.pass => format!(
                "No findings, but nothing was checked in `{}`.{gone}",
                first.path
            ),
            _ => format!("Passed: {}.{gone}", nothing_found(outcome)),
        };
    };
    let (number, harm, also) = (
        gravest.number(outcome),
        gravest.harm(outcome),
        gravest.also(),
    );
    // Settings concern no application: what is said then is that nothing else was found.
    let [failed, passed] = match (gravest.findings.is_empty(), gravest.level) {
        (true, _) => ["; ", "; "],
        (_, Level::Info) => [", ", ": "],
        _ => [". ", ": "],
    };
    if !view.pass {
        let (passing, too_many) = (passing(outcome), too_many(outcome, view));
        return format!("Failed: {number}{failed}{harm}.{passing}{also}{too_many}{gone}");
    }
    let whatever = if view.fail_on.is_none() {
        " (`fail-on` is `never`)"
    } else {
        ""
    };
    format!("Passed with {number}{whatever}{passed}{harm}.{also}{gone}")
}

/// ` MakeHuman 2 passes.`: who is not concerned where another one fails.
fn passing(outcome: &Outcome) -> String {
    let of = |verdict| {
        outcome
            .applications
            .iter()
            .filter(move |one| one.verdict == verdict)
    };
    let passing: Vec<&str> = of(Verdict::Pass)
        .map(|one| one.application.title())
        .collect();
    match passing.split_last() {
        _ if of(Verdict::Fail).next().is_none() => String::new(),
        Some((last, [])) => format!(" {last} passes."),
        Some((last, others)) => format!(" {} and {last} pass.", others.join(", ")),
        None => String::new(),
    }
}

/// `no findings`, and where or apart from what.
fn nothing_found(outcome: &Outcome) -> String {
    let only = only(outcome);
    if let Some(compared) = &outcome.compared {
        return format!(
            "no new findings{only}, compared with `{}`",
            printable(&compared.with)
        );
    }
    if outcome.summary.suppressed > 0 {
        return format!("no findings{only} apart from {}", apart_from(outcome));
    }
    if only.is_empty() {
        "no findings".to_owned()
    } else {
        format!("no findings{only}; everything else was left out")
    }
}

/// ` 3 findings no longer occur. 1 finding is smaller than before.`
fn gone(outcome: &Outcome) -> String {
    // What of a baseline no longer occurs is a finding.
    let of_baseline = outcome
        .compared_with_baseline
        .as_ref()
        .map(|compared| [0, compared.smaller]);
    let compared = outcome
        .compared
        .as_ref()
        .map(|compared| [compared.gone, compared.smaller]);
    let [gone, smaller] = compared.or(of_baseline).unwrap_or_default();
    let gone = match gone {
        0 => String::new(),
        1 => " 1 finding no longer occurs.".to_owned(),
        more => format!(" {more} findings no longer occur."),
    };
    match smaller {
        0 => gone,
        1 => format!("{gone} 1 finding is smaller than before."),
        more => format!("{gone} {more} findings are smaller than before."),
    }
}

/// Why nothing was checked of PATHs, and what to give instead.
pub fn why_nothing(outcome: &Outcome, what: Option<Unchecked>) -> String {
    match what {
        Some(Unchecked::Outside) => format!(
            "these files are in no {} data folder; name the folder that contains `clothes/`, \
                `rigs/` or `target/`",
            titles(&outcome.looked_for)
        ),
        Some(Unchecked::Unused) => {
            "these files are parts of assets; name the folder that contains the assets".to_owned()
        }
        Some(_) => "there are no rules for files of these kinds yet".to_owned(),
        None if outcome
            .nothing_in
            .iter()
            .all(|one| one.path.to_lowercase().ends_with(".zip")) =>
        {
            "nothing in it can be read as an asset; in a pack assets are in folders such as \
                `clothes/`, `hair/` or `rigs/`"
                .to_owned()
        }
        None => format!(
            "no data of {} found; name the data folder ({}); folders whose names begin with a dot \
             are searched only if PATH names them",
            titles(&outcome.looked_for),
            signs(&outcome.looked_for)
        ),
    }
}

/// What data folders have, `MakeHuman 2: with …; MPFB: with …`.
fn signs(applications: &[Application]) -> String {
    let signs = applications.iter().map(|application| match application {
        Application::Makehuman2 => "MakeHuman 2: with `base/`, `target/` or `rigs/`",
        Application::Makehuman1 => "MakeHuman 1: with `targets/` and `modifiers/`",
        // Who asked for MPFB alone has what lies there checked as that of a user.
        Application::Mpfb if applications.len() == 1 => {
            "with `targets/target.json`; that of a user with `clothes/`, `skins/` or `custom/`"
        }
        Application::Mpfb => "MPFB: with `targets/target.json`; that of a user with `--app mpfb`",
    });
    signs.collect::<Vec<_>>().join("; ")
}

/// Where or by what alone something could be found, with a blank before it; empty where nothing was
/// left out.
fn only(outcome: &Outcome) -> String {
    let Scope {
        paths,
        excluded,
        bases,
        rules,
        without,
    } = &outcome.scope;
    let parts = [
        ("in", paths),
        ("outside", excluded),
        ("for the base mesh", bases),
        ("from the rules", rules),
        ("without the rules", without),
    ];
    let parts = parts.into_iter().filter(|(_, names)| !names.is_empty());
    let words: Vec<String> = parts
        .map(|(before, names)| format!(" {before} {}", printable(&listed(names))))
        .collect();
    words.concat()
}

/// `a`, `b`, `c` and 2 more.
fn listed(names: &[String]) -> String {
    let shown: Vec<String> = names
        .iter()
        .take(NAMED)
        .map(|name| format!("`{name}`"))
        .collect();
    let more = match names.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    shown.join(", ") + &more
}

/// The gravest findings on assets, or where there is none those on the settings of mhlint, which
/// concern no application.
struct Gravest<'a> {
    level: Level,
    findings: Vec<&'a Finding>,
    /// Those on settings that are as grave.
    settings: Vec<&'a Finding>,
}

impl<'a> Gravest<'a> {
    fn of(findings: &'a [Finding]) -> Option<Self> {
        let (settings, assets): (Vec<&Finding>, Vec<&Finding>) =
            findings.iter().partition(|one| one.is_upkeep());
        let worst = |findings: &[&Finding]| findings.iter().map(|finding| finding.level).max();
        let of_assets = worst(&assets);
        let level = of_assets.or(worst(&settings))?;
        let assets = assets
            .into_iter()
            .filter(|finding| finding.level == level)
            .collect();
        let settings = settings
            .into_iter()
            .filter(|finding| finding.level >= level)
            .collect();
        Some(Self {
            level,
            findings: assets,
            settings,
        })
    }

    /// `2 new warnings`.
    fn number(&self, outcome: &Outcome) -> String {
        if self.findings.is_empty() {
            return about_settings(&self.settings);
        }
        let new = if outcome.compared.is_some() {
            "new "
        } else {
            ""
        };
        count(self.findings.len(), &format!("{new}{}", self.level))
    }

    /// What they mean, without a full stop.
    fn harm(&self, outcome: &Outcome) -> String {
        let named = applications(outcome, &self.findings);
        let who = joined(
            &named,
            if self.level == Level::Error {
                "or"
            } else {
                "and"
            },
        );
        let of_all = |one, several| if named.len() == 1 { one } else { several };
        match self.level {
            _ if self.findings.is_empty() => nothing_found(outcome),
            Level::Error => format!("{who} would crash, reject a file or lose data"),
            Level::Warning => {
                format!(
                    "{who} {} the data, but the result differs from the files",
                    of_all("loads", "load")
                )
            }
            Level::Info => format!("{who} {} the right result today", of_all("shows", "show")),
        }
    }

    /// Those on settings, beside others.
    fn also(&self) -> String {
        match self.settings.as_slice() {
            [] => String::new(),
            _ if self.findings.is_empty() => String::new(),
            settings => format!(" Also {}.", about_settings(settings)),
        }
    }
}

/// `1 warning about mhlint's settings`, by the gravest.
fn about_settings(findings: &[&Finding]) -> String {
    let worst = findings
        .iter()
        .map(|finding| finding.level)
        .max()
        .unwrap_or(Level::Info);
    let number = findings
        .iter()
        .filter(|finding| finding.level == worst)
        .count();
    format!("{} about mhlint's settings", count(number, worst.word()))
}

fn too_many(outcome: &Outcome, view: &View<'_>) -> String {
    match view.max_warnings {
        Some(limit) if outcome.summary.warning > limit => {
            format!(" `max-warnings` allows {limit}.")
        }
        _ => String::new(),
    }
}

/// The applications that the gravest findings are about, or whose data were checked.
fn applications(outcome: &Outcome, gravest: &[&Finding]) -> Vec<Application> {
    let mut named: Vec<Application> = gravest
        .iter()
        .flat_map(|finding| finding.breaks.iter().map(|one| one.application))
        .collect();
    if named.is_empty() {
        named.extend(outcome.roots.iter().map(|root| root.application));
    }
    named.sort_unstable();
    named.dedup();
    named
}

fn titles(applications: &[Application]) -> String {
    joined(applications, "or")
}

/// `MakeHuman 2, MakeHuman 1 or MPFB`.
fn joined(applications: &[Application], word: &str) -> String {
    let titles: Vec<&str> = applications
        .iter()
        .map(|application| application.title())
        .collect();
    match titles.split_last() {
        Some((last, others)) if !others.is_empty() => {
            format!("{} {word} {last}", others.join(", "))
        }
        _ => titles.concat(),
    }
}

fn size(bytes: u64) -> String {
    match bytes {
        0..1_000 => format!("{bytes} bytes"),
        1_000..1_000_000 => format!("{}.{} kB", bytes / 1_000, bytes % 1_000 / 100),
        _ => format!("{}.{} MB", bytes / 1_000_000, bytes % 1_000_000 / 100_000),
    }
}
