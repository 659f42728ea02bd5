//! A name or uuid of an asset is one word.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::Kind;
use mhlint_formats::mhclo::Entry;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
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
    "reads the first word at the first start and the whole uuid from the second on: saved models \
     lose the material chosen for the asset",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    in_paths(view, out);
    for file in view.files() {
        in_text(view, file, out);
    }
}

fn in_text(view: &View<'_>, file: &FileFacts, out: &mut Vec<Finding>) {
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
fn in_paths(view: &View<'_>, out: &mut Vec<Finding>) {
    if !view.is_makehuman1() {
        return;
    }
    let listed = view
        .files()
        .filter(|file| (view.layout().scans)(&file.rel) && has_space(&file.rel));
    // However many lie in a folder, one name is at fault.
    let by_name = grouped(listed.map(|file| (name_at_fault(&file.rel), file)));
    out.extend(
        by_name
            .into_iter()
            .filter_map(|(name, files)| of_name(view, name, &files)),
    );
}

fn has_space(path: &str) -> bool {
    path.contains(char::is_whitespace)
}

/// The first folder with a space in its name, or else the file.
fn name_at_fault(rel: &str) -> &str {
    rel.match_indices('/')
        .filter_map(|(end, _)| rel.get(..end))
        .find(|folder| has_space(folder))
        .unwrap_or(rel)
}

fn of_name(view: &View<'_>, name: &str, files: &[&FileFacts]) -> Option<Finding> {
    let file = files.first()?;
    let what = match name.split('/').next()? {
        "poses" => "pose",
        "skins" => "skin",
        _ => return None,
    };
    let finding = if name == file.rel {
        let message = format!("the path of the {what} has a space: `{}`", file.shown());
        RULE.at(file, Place::File, message)
            .help("rename the file without spaces")
    } else {
        let layer = view.layers().checked;
        let message = format!(
            "folder `{}` of {} has a space in its name",
            layer.shown(name),
            counted(files.len(), what)
        );
        RULE.in_layer(layer, name, message)
            .help("rename the folder, and what is in it, without spaces")
    };
    let effect = format!("saves models that lose the {what}: a line of a model is split at spaces");
    Some(finding.key("path").effect_in(view.application(), effect))
}
