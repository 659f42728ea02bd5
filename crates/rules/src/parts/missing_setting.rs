//! What MPFB looks up in `macro.json` by its key, and does not find.

use super::super::cause::schema::stands_for;
use super::super::{Check, Rule, RuleCx, are, enumerated};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_parts::Absent;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "crashes with `KeyError` whenever a character is made: none can be made",
    )],
    docs: include_str!("missing_setting.md").trim_ascii_end(),
    counts: "keys",
    ..RuleInfo::new(
        "parts-missing-setting",
        Level::Error,
        "a macro setting, or a key of a part, is missing",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = view
        .parts
        .as_ref()
        .filter(|parts| view.layers.is_checked(parts.file))
    else {
        return;
    };
    let is_of_part = |absent: &&Absent| !matches!(absent.owner.as_str(), "" | "/macrotargets");
    let (of_parts, settings): (Vec<&Absent>, Vec<&Absent>) =
        parts.settings.absent.iter().partition(is_of_part);
    if let Some(first) = settings.first() {
        let keys: Vec<String> = settings
            .iter()
            .map(|absent| format!("`{}`", absent.key))
            .collect();
        let message = format!("{} {} missing", enumerated(&keys), are(keys.len()));
        out.push(finding(parts.file, first, &settings, message, "settings"));
    }
    if let Some(first) = of_parts.first() {
        let others = if of_parts.len() > 1 {
            format!(" ({} such keys)", of_parts.len())
        } else {
            String::new()
        };
        let message = format!("{} has no `{}`{others}", owner(&first.owner), first.key);
        out.push(finding(parts.file, first, &of_parts, message, "parts"));
    }
}

fn finding(
    file: &FileFacts,
    first: &Absent,
    all: &[&Absent],
    message: String,
    key: &str,
) -> Finding {
    let meant = file.schema.unknown.iter().find(|unknown| {
        let is_beside = unknown
            .pointer
            .rsplit_once('/')
            .is_some_and(|(owner, _)| owner == first.owner);
        is_beside && stands_for(unknown, first.key)
    });
    let help = match meant {
        Some(meant) => format!("did you mean `{}` instead of `{}`?", first.key, meant.key),
        None => format!("add `{}`", first.key),
    };
    let names = all
        .iter()
        .map(|absent| format!("{}/{}", absent.owner, absent.key));
    let finding = RULE
        .at(file, Place::Pointer(first.owner.clone()), message)
        .key(key)
        .help(help);
    finding.evidence(Evidence::of_cases(names))
}

/// `parts[1]` of `age` for `/macrotargets/age/parts/1`.
fn owner(pointer: &str) -> String {
    let steps: Vec<String> = mhlint_diag::steps(pointer).collect();
    match steps
        .iter()
        .map(String::as_str)
        .collect::<Vec<_>>()
        .as_slice()
    {
        [_, setting, _, part] => format!("parts[{part}] of `{setting}`"),
        [.., last] => format!("`{last}`"),
        [] => "the file".to_owned(),
    }
}
