//! Names that some system cannot hold, or holds differently.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::named::differs_in_form;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::{Resolution, View};
use mhlint_source::file_name;

const LOST: &str = "does not find the file on a system that cannot hold its name";

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, LOST), (Makehuman1, LOST), (Mpfb, LOST)],
    docs: include_str!("unportable_name.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-unportable-name",
        Level::Warning,
        "a name that not every system supports",
    )
});

const RESERVED: [&str; 4] = ["con", "prn", "aux", "nul"];
const RESERVED_WITH_NUMBER: [&str; 2] = ["com", "lpt"];
const FORBIDDEN: [char; 8] = ['<', '>', ':', '"', '|', '?', '*', '\\'];

const DECOMPOSED: &str = "is written with separate accent marks";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let not_found = named_in_another_form(view);
    let faults = layer.walk_faults.iter().map(|fault| &fault.path);
    for path in layer.files.keys().chain(&layer.folders).chain(faults) {
        let name = file_name(path);
        if let Some(fault) = fault(name) {
            // That something names it in another form and does not find it is the worse news.
            if fault.what == DECOMPOSED && is_or_holds(&not_found, path) {
                continue;
            }
            let finding = RULE.in_layer(
                layer,
                path,
                format!("`{}` {}", name.escape_debug(), fault.what),
            );
            out.push(
                finding
                    .case(fault.case)
                    .help(format!("{}, and update the references to it", fault.edit)),
            );
        }
    }
}

/// Whether a path is that of a file, or of a folder of one.
fn is_or_holds(files: &BTreeSet<&str>, path: &str) -> bool {
    let folder = format!("{path}/");
    let below = files.range(folder.as_str()..).next();
    files.contains(path) || below.is_some_and(|file| file.starts_with(&folder))
}

/// Files whose names a reference of the checked layer writes in another form of accented letters.
fn named_in_another_form<'a>(view: &View<'a>) -> BTreeSet<&'a str> {
    let layers = view.layers();
    let own = view
        .references()
        .iter()
        .filter(|reference| layers.is_checked(reference.from));
    let files = own
        .filter(|reference| differs_in_form(reference))
        .filter_map(|reference| match reference.resolution {
            Resolution::CaseOnly(file) => Some(file.rel.as_str()),
            _ => None,
        });
    files.collect()
}

const NOWHERE: &str =
    "does not find it where a file names it: JSON and text files cannot contain such a name";
const REFUSED: &str = "does not find it on Windows, where it cannot be unpacked or checked out";
const CUT: &str = "does not find it on Windows, where it has another name";
const LIKE: &str = "finds it only where a reference writes the accents in the same way; copies \
    may get another name";

const UNNAMED: Case = &[
    (Makehuman2, Level::Warning, NOWHERE),
    (Makehuman1, Level::Warning, NOWHERE),
    (Mpfb, Level::Warning, NOWHERE),
];
const NOT_ON_WINDOWS: Case = &[
    (Makehuman2, Level::Warning, REFUSED),
    (Makehuman1, Level::Warning, REFUSED),
    (Mpfb, Level::Warning, REFUSED),
];
const SHORTENED: Case = &[
    (Makehuman2, Level::Warning, CUT),
    (Makehuman1, Level::Warning, CUT),
    (Mpfb, Level::Warning, CUT),
];
const IN_ANOTHER_FORM: Case = &[
    (Makehuman2, Level::Warning, LIKE),
    (Makehuman1, Level::Warning, LIKE),
    (Mpfb, Level::Warning, LIKE),
];

/// What is wrong with a name, what comes of it, and what to do.
struct Fault {
    what: String,
    case: Case,
    edit: &'static str,
}

/// What is wrong with a name, if anything.
fn fault(name: &str) -> Option<Fault> {
    let fault = |what: &str, case, edit| {
        Some(Fault {
            what: what.to_owned(),
            case,
            edit,
        })
    };
    if name.contains(char::REPLACEMENT_CHARACTER) {
        return fault(
            "is not valid Unicode",
            UNNAMED,
            "rename it with letters a to z and digits",
        );
    }
    if name.chars().any(char::is_control) {
        return fault(
            "contains a control character",
            UNNAMED,
            "rename it without the character",
        );
    }
    if let Some(character) = name.chars().find(|character| FORBIDDEN.contains(character)) {
        let what = format!("contains `{character}`, which Windows does not allow");
        return fault(&what, NOT_ON_WINDOWS, "rename it without the character");
    }
    if name.ends_with(['.', ' ']) {
        let what = "ends with a dot or space, which Windows removes";
        return fault(what, SHORTENED, "remove the dot or space at the end");
    }
    if is_reserved(name) {
        return fault(
            "is a reserved name on Windows",
            NOT_ON_WINDOWS,
            "give it another name",
        );
    }
    if is_decomposed(name) {
        return fault(
            DECOMPOSED,
            IN_ANOTHER_FORM,
            "rename it with letters without accents",
        );
    }
    None
}

fn is_reserved(name: &str) -> bool {
    let stem = name
        .split('.')
        .next()
        .unwrap_or_default()
        .trim_end()
        .to_lowercase();
    let numbered = || {
        let number = RESERVED_WITH_NUMBER
            .iter()
            .find_map(|word| stem.strip_prefix(word))?;
        matches!(number.as_bytes(), [b'1'..=b'9']).then_some(())
    };
    RESERVED.contains(&stem.as_str()) || numbered().is_some()
}

/// A Latin letter followed by a combining mark: nearly always there is one letter for both.
fn is_decomposed(name: &str) -> bool {
    let follows = name.chars().skip(1);
    name.chars().zip(follows).any(|(letter, mark)| {
        letter.is_ascii_alphabetic() && ('\u{300}'..'\u{370}').contains(&mark)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_windows_refuses_are_found() {
        for name in [
            "con",
            "NUL.target",
            "Com1.tar.gz",
            "a?b",
            "a.",
            "a ",
            "a\u{7}b",
            "Jo\u{308}rg",
            "a\\b",
            "lpt9 .x",
        ] {
            assert!(fault(name).is_some(), "{name}");
        }
        for name in [
            "console",
            "com0",
            "com10",
            "a.b",
            " a",
            "J\u{f6}rg",
            "nullify.target",
            "日本",
        ] {
            assert!(fault(name).is_none(), "{name}");
        }
    }
}
