//! What is said of a motion must be written so that it is found.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::meta::{Misspelt, Name};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "ignores the line"),
        (Makehuman1, "ignores the line"),
    ],
    docs: include_str!("meta.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-meta",
        Level::Warning,
        "a `.meta` of which a line is not read",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_makehuman1 = view.is_makehuman1();
    let is_read =
        file.kind == Kind::MotionMeta && (is_makehuman1 || (view.layout().scans)(&file.rel));
    let Some(meta) = file.meta().filter(|_| is_read) else {
        return;
    };
    let stem = file.rel.strip_suffix("meta").unwrap_or(&file.rel);
    let layer = view.layers().checked;
    // Unity keeps one beside each file, under its whole name.
    if layer.file(stem.trim_end_matches('.')).is_some() {
        return;
    }
    let has = |suffix: &str| layer.file(&format!("{stem}{suffix}")).is_some();
    if is_makehuman1 {
        // Capitals make no difference to it, and any letters are kept.
        let is_unknown =
            |one: &&Misspelt| one.word.ends_with(':') || one.word.eq_ignore_ascii_case("tags");
        if layer.file_ignoring_case(&format!("{stem}bvh")).is_none() && !has("bvh") {
            return out.push(orphan(view, file));
        }
        let misspelt = meta.misspelt.as_ref().filter(is_unknown);
        return out.extend(misspelt.map(|misspelt| unread(view, file, misspelt)));
    }
    // Beside a pose nobody reads it, and nobody misses it.
    if !has("bvh") {
        // One with other capitals has a finding of its own.
        let is_misnamed = layer.file_ignoring_case(&format!("{stem}bvh")).is_some();
        out.extend((!has("mhpose") && !is_misnamed).then(|| orphan(view, file)));
        return;
    }
    out.extend(
        meta.misspelt
            .as_ref()
            .map(|misspelt| unread(view, file, misspelt)),
    );
    out.extend(meta.name.as_ref().and_then(|name| cut(view, file, name)));
}

fn orphan(view: &View<'_>, file: &FileFacts) -> Finding {
    let message = format!("there is no `{}.bvh` beside it", file.stem());
    let finding = RULE
        .at(file, Place::File, message)
        .key("orphan")
        .effect_in(view.application(), "never reads it");
    finding.help("give it the name of the motion that it describes, or remove it")
}

fn unread(view: &View<'_>, file: &FileFacts, misspelt: &Misspelt) -> Finding {
    let Misspelt {
        word,
        meant,
        line,
        count,
    } = misspelt;
    let message = match count {
        1 => format!("`{word}` is not recognised, expected `{meant}`"),
        count => format!(
            "`{word}` is not recognised, expected `{meant}` ({})",
            counted(count, "such line")
        ),
    };
    let effect = match *meant {
        "name" => "ignores such lines: the motion has the name of its file",
        "tag" => "ignores the line: the motion has no such tag",
        _ => "ignores the line: the motion has no author",
    };
    RULE.at(file, Place::Line(*line), message)
        .key("keyword")
        .effect_in(view.application(), effect)
        .help(format!("write `{meant}`"))
}

fn cut(view: &View<'_>, file: &FileFacts, name: &Name) -> Option<Finding> {
    let Name {
        written,
        listed,
        line,
    } = name;
    let (message, effect) = if listed.is_empty() {
        (
            "the name has no ASCII letter".to_owned(),
            "lists the motion with an empty name",
        )
    } else if listed.chars().count() < written.to_lowercase().chars().count() {
        (
            format!("the name is cut to `{listed}`: only ASCII letters are kept"),
            "lists the motion under the cut name",
        )
    } else {
        return None;
    };
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .key("name")
        .effect_in(view.application(), effect);
    Some(finding.help("write the name with plain letters, without accents"))
}
