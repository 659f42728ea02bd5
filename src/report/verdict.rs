//! The last lines: what was looked at, and one sentence that says how it ended.

use super::{Paint, View, count, hang, phrase, printable};
use crate::diag::{Application, Finding, Level, Outcome, Scope, Summary, Unchecked};

/// Names that a sentence holds, and errors that are named at the end.
const NAMED: usize = 3;

/// What was checked, and how many findings of each level there are.
pub(super) fn counts(outcome: &Outcome, view: &View<'_>) -> String {
    let line = format!("{} in {} of {}", tally(outcome), files(&outcome.summary), roots(outcome).join(", "));
    hang("", &printable(&line), view.width)
}

/// `1 error, 0 warnings, 0 infos`, and what is hidden.
pub(super) fn tally(outcome: &Outcome) -> String {
    let summary = &outcome.summary;
    let found = [(summary.error, "error"), (summary.warning, "warning"), (summary.info, "info")];
    let found = found.map(|(number, noun)| count(number, noun));
    let hidden = hidden(outcome).map(|(number, what)| format!("{number} {what}"));
    found.into_iter().chain(hidden).collect::<Vec<_>>().join(", ")
}

/// How many findings are hidden, and by what.
pub(super) fn hidden(outcome: &Outcome) -> impl Iterator<Item = (usize, &'static str)> {
    let known = outcome.in_baseline;
    let all = [(known, "in the baseline"), (outcome.summary.suppressed.saturating_sub(known), "muted")];
    all.into_iter().filter(|(number, _)| *number > 0)
}

/// `29 findings in the baseline and 1 finding muted`.
fn beside(outcome: &Outcome) -> String {
    let parts: Vec<String> =
        hidden(outcome).map(|(number, what)| format!("{} {what}", count(number, "finding"))).collect();
    parts.join(" and ")
}

/// `86 files (344.3 kB)`.
pub(super) fn files(summary: &Summary) -> String {
    format!("{} ({})", count(summary.files, "file"), size(summary.bytes))
}

/// The checked data roots: path, application, base meshes. Not made harmless yet.
pub(super) fn roots(outcome: &Outcome) -> Vec<String> {
    let checked = outcome.checked();
    checked
        .map(|root| {
            let bases = if root.bases.is_empty() { String::new() } else { format!(": {}", root.bases.join(", ")) };
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
    let errors = || outcome.findings.iter().filter(|finding| finding.level == Level::Error);
    let place = |finding: &Finding| format!("{}{}", phrase::path(&finding.path), phrase::colons(&finding.location));
    let mut lines: Vec<String> =
        errors().take(NAMED).map(|finding| format!("{}: {}", place(finding), finding.rule)).collect();
    let left = errors().count().saturating_sub(NAMED);
    lines.extend((left > 0).then(|| format!("and {}", count(left, "more error"))));
    lines
}

/// The verdict without colour or line breaks.
pub(super) fn words(outcome: &Outcome, view: &View<'_>) -> String {
    let summary = &outcome.summary;
    if !outcome.is_whole() {
        return "No verdict: mhlint itself failed on these data.".to_owned();
    }
    if !outcome.checked_anything() {
        let what = outcome.nothing_in.first().and_then(|first| first.what);
        return format!("Nothing was checked: {}.", why_nothing(outcome, what));
    }
    let only = only(outcome);
    let gone = gone(outcome);
    if let (true, Some(compared)) = (outcome.findings.is_empty(), &outcome.compared) {
        return format!("Nothing new found{only}, compared with `{}`.{gone}", printable(&compared.with));
    }
    if outcome.findings.is_empty() && summary.suppressed > 0 {
        return format!("Nothing found{only} beside {}.", beside(outcome));
    }
    if outcome.findings.is_empty() && !only.is_empty() {
        return format!("Nothing found{only}; what else there is was left out.");
    }
    if outcome.findings.is_empty() {
        let who = applications(outcome, &[]);
        let (where_, all) =
            if outcome.not_checked.is_empty() { ("", "all of it") } else { (" in what was checked", "it") };
        return format!("Nothing found{where_}: as far as the rules reach, {who} loads {all} as it was written.");
    }
    let harm = harm(outcome);
    let new = if outcome.compared.is_some() { " new" } else { "" };
    if !view.pass {
        return format!("Failed. {harm}{}{gone}", too_many(outcome, view));
    }
    match view.fail_on {
        Some(limit) => format!("Passed: nothing{new} at or above {limit}. {harm}{gone}"),
        None => format!("Passed, whatever was found (`fail-on` is never). {harm}{gone}"),
    }
}

/// ` 3 findings are gone.`
fn gone(outcome: &Outcome) -> String {
    match outcome.compared.as_ref().map_or(0, |compared| compared.gone) {
        0 => String::new(),
        1 => " 1 finding is gone.".to_owned(),
        more => format!(" {more} findings are gone."),
    }
}

/// Why nothing was checked of PATHs, and what to give instead.
pub(crate) fn why_nothing(outcome: &Outcome, what: Option<Unchecked>) -> String {
    match what {
        Some(Unchecked::Application) => {
            let others = outcome.roots.iter().filter(|root| !root.checked);
            let others: Vec<Application> = others.map(|root| root.application).collect();
            format!("this version does not check data of {} yet", titles(&others))
        }
        Some(_) => "no rule is about files of these kinds yet".to_owned(),
        None => format!(
            "no data of {} were found; give the folder that holds `base/`, `target/`, `contarget/` or `rigs/`",
            titles(&outcome.looked_for)
        ),
    }
}

/// Where or by what alone something could be found, with a blank before it; empty where nothing was left out.
fn only(outcome: &Outcome) -> String {
    let Scope { paths, excluded, bases, rules, without } = &outcome.scope;
    let parts = [
        ("in", paths),
        ("outside of", excluded),
        ("on the base mesh", bases),
        ("by the rules", rules),
        ("without the rules", without),
    ];
    let parts = parts.into_iter().filter(|(_, names)| !names.is_empty());
    let words: Vec<String> = parts.map(|(before, names)| format!(" {before} {}", printable(&listed(names)))).collect();
    words.concat()
}

/// `a`, `b`, `c` and 2 more.
fn listed(names: &[String]) -> String {
    let shown: Vec<String> = names.iter().take(NAMED).map(|name| format!("`{name}`")).collect();
    let more = match names.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    shown.join(", ") + &more
}

/// What the gravest findings on assets mean. Those on the settings of mhlint concern no application.
fn harm(outcome: &Outcome) -> String {
    let (settings, assets): (Vec<&Finding>, Vec<&Finding>) = outcome.findings.iter().partition(|one| one.is_upkeep());
    let Some(worst) = assets.iter().map(|finding| finding.level).max() else {
        let (found, only) = (about_settings(&settings), only(outcome));
        let data = if only.is_empty() { " in the data" } else { &only };
        return match (&outcome.compared, outcome.summary.suppressed) {
            (Some(_), _) => format!("{found}; nothing new found{data}."),
            (None, 0) => format!("{found}; nothing found{data}."),
            (None, _) => format!("{found}; nothing found{data} beside {}.", beside(outcome)),
        };
    };
    let gravest: Vec<&Finding> = assets.into_iter().filter(|finding| finding.level == worst).collect();
    let who = applications(outcome, &gravest);
    let number = count(gravest.len(), worst.word());
    let harm = match worst {
        Level::Error => format!("{number}: {who} would crash, or refuse or lose something."),
        Level::Warning => format!("{number}: {who} loads it, but does something else than was written."),
        Level::Info => format!("{number}: harmless in {who} today."),
    };
    let also: Vec<&Finding> = settings.into_iter().filter(|finding| finding.level >= worst).collect();
    if also.is_empty() { harm } else { format!("{harm} Besides, {}.", about_settings(&also)) }
}

/// `1 warning about the settings of mhlint`, by the gravest.
fn about_settings(findings: &[&Finding]) -> String {
    let worst = findings.iter().map(|finding| finding.level).max().unwrap_or(Level::Info);
    let number = findings.iter().filter(|finding| finding.level == worst).count();
    format!("{} about the settings of mhlint", count(number, worst.word()))
}

fn too_many(outcome: &Outcome, view: &View<'_>) -> String {
    match view.max_warnings {
        Some(limit) if outcome.summary.warning > limit => {
            format!(" More than the {} that `max-warnings` allows.", count(limit, "warning"))
        }
        _ => String::new(),
    }
}

/// The applications that the gravest findings are about, or whose data were checked.
fn applications(outcome: &Outcome, gravest: &[&Finding]) -> String {
    let mut named: Vec<Application> =
        gravest.iter().flat_map(|finding| finding.breaks.iter().map(|one| one.application)).collect();
    if named.is_empty() {
        named.extend(outcome.checked().map(|root| root.application));
    }
    named.sort_unstable();
    named.dedup();
    titles(&named)
}

fn titles(applications: &[Application]) -> String {
    applications.iter().map(|application| application.title()).collect::<Vec<_>>().join(" or ")
}

fn size(bytes: u64) -> String {
    match bytes {
        0..1_000 => format!("{bytes} bytes"),
        1_000..1_000_000 => format!("{}.{} kB", bytes / 1_000, bytes % 1_000 / 100),
        _ => format!("{}.{} MB", bytes / 1_000_000, bytes % 1_000_000 / 100_000),
    }
}
