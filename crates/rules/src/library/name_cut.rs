//! A name or uuid of an asset is one word.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::mhclo::Entry;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lists the asset by the first word at the first start and by the whole name from the \
            second on: saved models lose it",
        ),
        (
            Makehuman1,
            "saves models that lose the asset: a line of a model is split at spaces",
        ),
    ],
    docs: include_str!("name_cut.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-name-cut",
        Level::Warning,
        "a name or uuid of an asset with several \
        words",
    )
});

const UUID: Case = &[(
    Makehuman2,
    Level::Warning,
    "reads the first word at the first start and the whole uuid from the second on: saved models lose the material chosen \
        for the asset",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(in_path(view, file));
    let is_listed = file.kind == Kind::Clothes && (view.layout().scans)(&file.rel);
    let Some(clothes) = file.clothes().filter(|_| is_listed) else {
        return;
    };
    let is_makehuman1 = view.is_makehuman1();
    for (keyword, taken) in [
        ("name", &clothes.scanned.name),
        ("uuid", &clothes.scanned.uuid),
    ] {
        let Some(entry) = clothes
            .last(keyword)
            .filter(|entry| entry.value.contains(' '))
        else {
            continue;
        };
        // With a colon it is another word to MakeHuman 1.
        if if is_makehuman1 {
            entry.has_colon
        } else {
            taken.is_none()
        } {
            continue;
        }
        let message = format!("the value of `{keyword}` has a space: `{}`", entry.value);
        let finding = RULE
            .at(file, Place::Span(entry.span.clone()), message)
            .key(keyword);
        out.push(match keyword {
            _ if entry.value.contains(" #") => {
                let bare = entry.value.split(" #").next().unwrap_or_default();
                finding.help(format!(
                    "move the comment to a line of its own: `{keyword} {bare}`"
                ))
            }
            "name" => finding.help(format!(
                "write `{keyword} {}`, and the new name in models that wear it",
                entry.value.replace(' ', "_")
            )),
            _ => finding
                .case(UUID)
                .help(format!("write `uuid {}`, without spaces", joined(entry))),
        });
    }
}

/// A uuid in one word: the first one, if that is whole, or all of them together.
fn joined(entry: &Entry) -> String {
    let is_whole = entry.word().len() == WHOLE_UUID && entry.word().matches('-').count() == 4;
    if is_whole {
        entry.word().to_owned()
    } else {
        entry.value.replace(' ', "")
    }
}

/// Letters of a uuid as programs write it.
const WHOLE_UUID: usize = 36;

/// A model names poses and skins by their paths.
fn in_path(view: &View<'_>, file: &FileFacts) -> Option<Finding> {
    let library = file
        .rel
        .split('/')
        .next()
        .filter(|_| view.is_makehuman1() && (view.layout().scans)(&file.rel))?;
    let what = match library {
        "poses" => "pose",
        "skins" => "skin",
        _ => return None,
    };
    let has_space = |path: &str| path.contains(char::is_whitespace);
    let mut folders = file
        .rel
        .match_indices('/')
        .filter_map(|(end, _)| file.rel.get(..end));
    let finding = match folders.find(|folder| has_space(folder)) {
        // However many lie in it, one name is at fault.
        Some(folder) => {
            let layer = view.layers().checked;
            let mut listed = layer
                .below(folder)
                .filter(|other| (view.layout().scans)(&other.rel));
            if listed.next().is_none_or(|first| first.path != file.path) {
                return None;
            }
            let count = counted(listed.count() + 1, what);
            let message = format!(
                "folder `{}` of {count} has a space in its name",
                layer.shown(folder)
            );
            RULE.in_layer(layer, folder, message)
                .help("rename the folder, and what is in it, without spaces")
        }
        None if has_space(&file.rel) => {
            let message = format!("the path of the {what} has a space: `{}`", file.shown());
            RULE.at(file, Place::File, message)
                .help("rename the file without spaces")
        }
        None => return None,
    };
    let effect = format!("saves models that lose the {what}: a line of a model is split at spaces");
    Some(finding.key("path").effect_in(view.application(), effect))
}
