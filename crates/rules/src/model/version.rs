//! MakeHuman 1 reads a model as its version says, and does not read every version.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::Makehuman1, Case, Finding, Level, Place, RuleInfo, Version as Edition,
};
use mhlint_repo::makehuman1::{SavedModel, Version, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails at the version, and leaves the default human: no clothes, no name, no tags",
    )],
    docs: include_str!("version.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-version",
        Level::Error,
        "a model with a version that MakeHuman 1 does not read",
    )
});

const BLANK: Case = &[(
    Makehuman1,
    Level::Error,
    "fails at the blank line, and loads nothing of what follows",
)];
const NO_SKELETON: Case = &[(
    Makehuman1,
    Level::Warning,
    "loads the model without its skeleton",
)];
const RENAMED: Case = &[(Makehuman1, Level::Warning, "takes the tags for the name")];
const HELP: &str = "write `version v1.3.0`, or the version of the program that saved the model";
const OF_MAKEHUMAN2: &str =
    "move the model to `models` of MakeHuman 2: MakeHuman 1 has other modifiers and assets";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for model in view
        .models
        .iter()
        .filter(|model| view.layers.is_checked(model.file))
    {
        let encoding = &model.file.encoding;
        // Empty models, and a version behind a byte order mark, are reported by other rules.
        let is_hidden = encoding.byte_order_mark
            && encoding
                .marked_words
                .first()
                .is_some_and(|word| &**word == "version");
        if encoding.blank || encoding.only_comments || encoding.lfs_pointer || is_hidden {
            continue;
        }
        out.extend(newer(model, view.layers.version(Makehuman1)).or_else(|| finding(model)));
    }
}

/// A finding if a newer program than the one at hand saved the model. MakeHuman 1.0 does not
/// compare the versions (`docs/loaders/versions.md#loaders-of-makehuman-1`).
fn newer(model: &SavedModel<'_>, own: Option<Edition>) -> Option<Finding> {
    let own = own.filter(|own| !own.is_before("1.1"))?;
    let line = model.lines.last("version")?;
    let number = line.text.strip_prefix('v')?.get(..3)?;
    if !own.is_before(number) {
        return None;
    }
    let message = format!("`{}` is newer than the program, {}", line.text, own.title());
    let help = "save the model with that version of the program, or ask for the one that saved it \
        (`--app makehuman1@1.3`)";
    Some(
        RULE.at(model.file, Place::Span(line.span.clone()), message)
            .key("newer")
            .help(help),
    )
}

fn finding(model: &SavedModel<'_>) -> Option<Finding> {
    let told = |place, message: String, help: &str| RULE.at(model.file, place, message).help(help);
    let at_line = |keyword: &str| {
        let line = model.lines.of(keyword).next_back();
        line.map_or(Place::File, |line| Place::Span(line.keyword.span.clone()))
    };
    let blank = |version: &str| {
        let line = model.lines.blank?;
        let message = format!("a blank line, which the reader of version {version} does not take");
        Some(
            told(Place::Line(line), message, "remove the blank line")
                .key("blank")
                .case(BLANK),
        )
    };
    match model.version {
        Version::Current => None,
        Version::Missing if model.file.model().is_some_and(|model| !model.has_keyword) => {
            let message = "no line begins with a keyword of models".to_owned();
            Some(told(
                Place::File,
                message,
                "restore the model: this file is something else, such as a web page",
            ))
        }
        Version::Missing => {
            let near = model
                .lines
                .all
                .iter()
                .find(|line| line.keyword.text.eq_ignore_ascii_case("version"));
            let place = near.map_or(Place::File, |line| Place::Span(line.keyword.span.clone()));
            let message = match near {
                Some(line) if &*line.keyword.text == "version" => {
                    "`version` has no value".to_owned()
                }
                Some(line) => format!(
                    "the model has `{}` in place of a line `version`",
                    line.keyword.text
                ),
                None => "the model has no line `version`".to_owned(),
            };
            Some(told(place, message, HELP))
        }
        Version::Refused(word) if word.text.starts_with("v2.") => {
            let message = format!("`{}` is a version of MakeHuman 2", word.text);
            Some(told(Place::Span(word.span.clone()), message, OF_MAKEHUMAN2))
        }
        Version::Refused(word) => {
            let message = format!("`{}` is not a version of models that is read", word.text);
            let message = if word.text.starts_with('v') {
                message
            } else {
                format!("{message}: it begins with `v`")
            };
            Some(told(Place::Span(word.span.clone()), message, HELP))
        }
        Version::First(_) => blank("1.0").or_else(|| {
            model.lines.last("skeleton")?;
            let message = "the skeleton of a model of version 1.0 is not read".to_owned();
            let finding = told(
                at_line("skeleton"),
                message,
                "save the model with the program of today",
            );
            Some(finding.key("skeleton").case(NO_SKELETON))
        }),
        Version::Second(_) => blank("1.1").or_else(|| {
            model.lines.last("name").and(model.lines.last("tags"))?;
            let message = "in a model of version 1.1 the tags are the name".to_owned();
            let finding = told(
                at_line("tags"),
                message,
                "write the version of the program that saved the model",
            );
            Some(finding.key("tags").case(RENAMED))
        }),
    }
}
