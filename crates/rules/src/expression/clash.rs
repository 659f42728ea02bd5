//! Every expression has a slider of its own.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo, grouped};
use mhlint_discover::Kind;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{View, identifier};
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "makes a slider for only one of them")],
    docs: include_str!("clash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "expression-clash",
        Level::Error,
        "two expressions with one slider",
    )
});

const EITHER: Case = &[(
    Mpfb,
    Level::Warning,
    "takes either of them for a saved character that names it",
)];
const HIDDEN: Case = &[(
    Mpfb,
    Level::Warning,
    "reads the expression of that path in its own data",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut first_of: BTreeMap<String, &FileFacts> = BTreeMap::new();
    // Its own data come first.
    let system = view
        .layers
        .system
        .filter(|system| !std::ptr::eq(*system, view.layers.checked));
    for layer in system.into_iter().chain([view.layers.checked]) {
        for file in layer
            .below("expressions")
            .filter(|file| file.kind == Kind::FaceExpression)
        {
            let first = *first_of
                .entry(identifier("expr", &file.rel))
                .or_insert(file);
            if std::ptr::eq(first, file) || !view.layers.is_checked(file) {
                continue;
            }
            let finding = if first.rel == file.rel {
                let message = format!("{} has the same path", view.layers.named(first));
                RULE.at(file, Place::File, message).key("path").case(HIDDEN)
            } else {
                RULE.at(
                    file,
                    Place::File,
                    format!("has the slider of {}, too", view.layers.named(first)),
                )
                .key("slider")
            };
            let finding = finding.related(first.path.clone(), Place::File, "the other expression");
            out.push(
                finding
                    .between([first.path.as_str(), file.path.as_str()])
                    .help("rename one of them"),
            );
        }
    }
    out.extend(same_names(view));
}

/// Files of one name in folders of one name, as saved characters know them.
fn same_names(view: &View<'_>) -> Vec<Finding> {
    let own = view
        .own(Kind::FaceExpression)
        .filter(|file| file.rel.matches('/').count() > 1);
    let name = |file: &FileFacts| {
        (
            file_name(file.folder()).to_owned(),
            file.file_name().to_owned(),
        )
    };
    let by_name = grouped(own.map(|file| (name(file), file)));
    let several = by_name.into_iter().filter_map(|((folder, name), files)| {
        let [first, .., last] = files.as_slice() else {
            return None;
        };
        let message = format!(
            "`{folder}/{name}` is also the name of {}",
            view.layers.named(first)
        );
        let finding = RULE
            .at(last, Place::File, message)
            .key("reference")
            .case(EITHER)
            .help("rename one of them");
        let finding = finding.related(first.path.clone(), Place::File, "the other expression");
        Some(finding.between([first.path.as_str(), last.path.as_str()]))
    });
    several.collect()
}
