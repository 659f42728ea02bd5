//! Targets that MPFB asks for and that are not there.

use super::super::cause::differing;
use super::super::{Check, Rule, RuleCx, did_you_mean, enumerated};
use super::name_patterns::patterns_of;
use super::stretch::checked;
use super::wanted::{are_of_default, lost_names, missing};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::loops::{LOOPS, names};
use mhlint_repo::mpfb::{Parts, Request, View};
use mhlint_source::{file_name, parent};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails where a setting comes near them: the whole macro shape disappears, and no such \
            character can be made",
    )],
    docs: include_str!("missing_target.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "parts-missing-target",
        Level::Error,
        "a target that the macro settings need \
        does not exist",
    )
});

const NO_CHARACTER: &str =
    "fails at every new character: the default one needs a target that is missing";

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    let missing: Vec<&Request<'_>> = missing(parts).collect();
    let Some(first) = missing.first() else { return };
    let (mut counts, mut patterns) = (Vec::new(), Vec::new());
    for (number, own) in LOOPS.iter().enumerate() {
        let of_loop: Vec<&Request<'_>> = missing
            .iter()
            .copied()
            .filter(|one| one.number == number)
            .collect();
        if !of_loop.is_empty() {
            let all = parts
                .requests
                .iter()
                .filter(|one| one.number == number && one.is_reachable)
                .count();
            counts.push(format!("{} of {all} {}", of_loop.len(), own.title));
            patterns.extend(patterns_of(own, &own.names(parts.settings), &of_loop));
        }
    }
    let message = match missing.as_slice() {
        [only] => format!("the macro target `{}` does not exist", file_of(only)),
        many => format!(
            "{} macro targets do not exist ({})",
            many.len(),
            counts.join(", ")
        ),
    };
    let evidence = Evidence::of_groups(patterns, missing.len() as u64)
        .naming(missing.iter().map(|one| &one.target));
    let all = parts.requests.iter().filter(|one| one.is_reachable).count();
    let finding = RULE
        .at(parts.file, Place::Pointer(place(parts)), message)
        .key("targets");
    let finding = if are_of_default(parts, &missing) {
        finding.effect(NO_CHARACTER)
    } else {
        finding
    };
    out.push(
        finding
            .evidence(evidence.out_of(all))
            .help(help(parts, first, cx)),
    );
}

/// Where the only name is written of which no target is there; else the settings as a whole.
fn place(parts: &Parts<'_>) -> String {
    let lost = lost_names(parts);
    let only = lost
        .first()
        .filter(|_| lost.len() == 1)
        .and_then(|(place, name)| {
            let setting = parts
                .settings
                .settings
                .iter()
                .find(|setting| setting.place == *place)?;
            setting.parts.iter().find_map(|part| {
                let is_name = |own: &Option<String>| own.as_deref() == Some(*name);
                let member = if is_name(&part.low) {
                    "low"
                } else {
                    Some("high").filter(|_| is_name(&part.high))?
                };
                Some(setting.pointer(part, member))
            })
        });
    only.unwrap_or_else(|| "/macrotargets".to_owned())
}

fn file_of(request: &Request<'_>) -> String {
    format!("{}.target.gz", request.target)
}

/// The target beside a missing one that nobody asks for and whose name is nearly that of it.
fn renamed<'p>(
    parts: &'p Parts<'_>,
    missing: &Request<'_>,
    cx: &RuleCx<'_>,
) -> Option<&'p FileFacts> {
    let folder = parent(&missing.rel);
    let beside = || {
        parts
            .layer
            .below(folder)
            .filter(|file| parent(&file.rel) == folder && !parts.asks_for(file))
    };
    let near = cx
        .suggestions
        .nearest_file(&missing.rel, beside().map(|file| file.rel.as_str()))?;
    beside().find(|file| file.rel == near)
}

fn help(parts: &Parts<'_>, first: &Request<'_>, cx: &RuleCx<'_>) -> String {
    let lost = lost_names(parts);
    if let Some((place, name)) = lost.first().copied().filter(|_| lost.len() == 1) {
        let setting = parts
            .settings
            .settings
            .iter()
            .find(|setting| setting.place == place);
        let known = setting.map(names).unwrap_or_default();
        let others = known
            .iter()
            .map(|name| name.text)
            .filter(|other| *other != name);
        // Files may be there for a name that is no longer written.
        let unnamed = parts
            .layer
            .below(parent(&first.rel))
            .filter_map(|file| parts.unknown_word(&file.rel));
        let unnamed = unnamed
            .filter(|(own, _)| *own == place)
            .map(|(_, word)| word);
        let near = cx.suggestions.nearest(name, others.chain(unnamed));
        return did_you_mean(near, format!("correct `{name}`, or add its targets"));
    }
    if let Some(other) = parts.layer.file_ignoring_case(&first.rel) {
        let (is, right) = differing(&other.rel, &first.rel);
        return format!("rename `{is}` to `{right}`: capitals matter");
    }
    if let Some(plain) = first
        .rel
        .strip_suffix(".gz")
        .and_then(|plain| parts.layer.file(plain))
    {
        return format!(
            "pack `{}` with gzip: MPFB loads only `.target.gz`",
            plain.rel
        );
    }
    if let Some(other) = renamed(parts, first, cx) {
        let (is, right) = (other.file_name(), file_name(&first.rel));
        return format!("did you mean `{is}`? Rename it to `{right}`");
    }
    let lost: Vec<String> = lost.iter().map(|(_, name)| format!("`{name}`")).collect();
    if lost.is_empty() {
        "add the targets".to_owned()
    } else {
        format!("add the targets of {}", enumerated(&lost))
    }
}
