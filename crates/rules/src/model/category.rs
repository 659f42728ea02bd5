//! The word in front of an asset in a model is its category.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::unparted::{Unparted, unparted};
use super::{makehuman1, own};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo, nearest,
};
use mhlint_formats::mhm::{CATEGORIES, WornLine};
use mhlint_repo::makehuman2::{Asset, Base, SavedModel, View};

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, cx, out| makehuman1::keyword::faults(&RULE, view, cx, out),
    |_, _, _| {},
)
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "ignores the line: the asset is missing"),
        (Makehuman1, "ignores the line, with a warning in the log"),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("category.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-category",
        Level::Error,
        "a model puts an asset on under an unknown or another category",
    )
});

const NO_LABEL: Case = &[(Makehuman2, Level::Info, "ignores the line")];
const NOT_SET: Case = &[(
    Makehuman2,
    Level::Warning,
    "silently ignores the line: what it sets is missing",
)];

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for saved in own(view, base) {
        let asset = |line: &WornLine| view.library.worn(base.name, &line.name.text, &line.uuid);
        out.extend(
            saved
                .model
                .unknown
                .iter()
                .filter_map(|line| unknown(saved, line, asset(line))),
        );
        let worn = saved
            .model
            .worn
            .iter()
            .filter_map(|line| Some((line, asset(line)?)));
        let other =
            worn.filter(|(line, asset)| *asset.category != *line.category.text && asset.is_worn());
        out.extend(other.map(|(line, asset)| misplaced(saved, line, asset)));
        out.extend(several_hairs(saved));
        out.extend(unparted(&saved.model.lines).map(|one| without_blank(saved, &one)));
    }
}

/// A finding on an unknown keyword that was meant for an asset. Applications skip unknown keywords.
fn unknown(saved: &SavedModel<'_>, line: &WornLine, asset: Option<&Asset<'_>>) -> Option<Finding> {
    let (word, name) = (&*line.category.text, &*line.name.text);
    let near = nearest(word, CATEGORIES);
    let asset =
        asset.filter(|asset| asset.is_worn() && (asset.uuid == *line.uuid || near.is_some()));
    let meant = asset
        .map(|asset| asset.category)
        .or_else(|| near.filter(|_| is_uuid(&line.uuid)))?;
    let message = format!("`{word}` is not a category, so `{name}` is not worn");
    let finding = RULE.at(saved.file, Place::Span(line.category.span.clone()), message);
    Some(
        finding
            .key(format!("{word} {name}"))
            .help(did_you_mean(Some(meant), "write the category")),
    )
}

/// A finding on a keyword that is joined with its value to one word, so that no application knows
/// it.
fn without_blank(saved: &SavedModel<'_>, one: &Unparted<'_>) -> Finding {
    let word = &one.line.keyword;
    let finding = RULE
        .at(saved.file, Place::Span(word.span.clone()), one.message())
        .key(&*word.text)
        .help(one.help());
    match (one.is_worn(), one.is_label()) {
        (true, _) => finding,
        (false, true) => finding.case(NO_LABEL),
        (false, false) => finding.case(NOT_SET),
    }
}

/// A finding on several lines `hair`: the panel of the application allows only one hair.
fn several_hairs(saved: &SavedModel<'_>) -> Option<Finding> {
    let hairs: Vec<&WornLine> = saved
        .model
        .worn
        .iter()
        .filter(|line| &*line.category.text == "hair")
        .collect();
    let [_, second, ..] = hairs.as_slice() else {
        return None;
    };
    let message = format!("the model has {} lines `hair`, expected one", hairs.len());
    let finding = RULE
        .at(
            saved.file,
            Place::Span(second.category.span.clone()),
            message,
        )
        .key("hair");
    let finding = finding
        .evidence(Evidence::of_cases(
            hairs.iter().map(|line| &*line.name.text),
        ))
        .level(Level::Warning);
    Some(
        finding
            .effect("wears all of them, although the panel allows one")
            .help("keep one of the lines"),
    )
}

/// Whether a word has the form that programs give to uuids.
fn is_uuid(word: &str) -> bool {
    word.len() == 36
        && word
            .bytes()
            .all(|byte| byte.is_ascii_hexdigit() || byte == b'-')
}

fn misplaced(saved: &SavedModel<'_>, line: &WornLine, asset: &Asset<'_>) -> Finding {
    let (word, name) = (&*line.category.text, &*line.name.text);
    let message = format!(
        "`{name}` is worn as `{word}`, but lies in `{}`",
        asset.category
    );
    let finding = RULE
        .at(saved.file, Place::Span(line.category.span.clone()), message)
        .level(Level::Warning);
    let finding = finding.key(format!("{word} {name}")).effect(format!(
        "wears it as `{word}`, which decides how it is exported; the panel lists it under `{}`",
        asset.category
    ));
    let help = match (word, asset.category) {
        // The line must not be changed to `clothes`, because the asset would be exported in another
        // way.
        ("hair", "clothes") => "move the asset to `hair`".to_owned(),
        (_, category) => format!("write `{category}`, or move the asset to `{word}`"),
    };
    finding
        .related(asset.file.path.clone(), Place::File, "the asset")
        .help(help)
}
