//! Names in a zip that are not those of files: backslashes, links, one name twice.

use super::super::Rule;
use super::Packed;
use crate::diag::{Application::Makehuman2, Case, Evidence, Finding, Level};

const BACKSLASHES: Case =
    &[(Makehuman2, Level::Error, "on Linux and macOS, unpacks them as files at the top and imports none of them")];
const LINKS: Case = &[(Makehuman2, Level::Error, "imports a text with the path in place of each file")];
const TWICE: Case = &[(Makehuman2, Level::Warning, "imports the last of them; the others are lost")];

pub(super) fn report(rule: &Rule, pack: &Packed<'_>, out: &mut Vec<Finding>) {
    let import = pack.import;
    out.extend(of(rule, pack, &import.backslashes, BACKSLASHES).map(|(finding, first, count)| {
        let first = first.replace('/', "\\");
        let message = match count {
            1 => format!("`{first}` has `\\` between its folders"),
            _ => format!("{count} names have `\\` between their folders, first `{first}`"),
        };
        Finding { message, ..finding.key("backslash") }
            .help("pack with a program that writes `/`, such as 7-Zip or the file manager of the system")
    }));
    out.extend(of(rule, pack, &import.links, LINKS).map(|(finding, first, count)| {
        let message = match count {
            1 => format!("`{first}` is a symbolic link"),
            _ => format!("{count} members are symbolic links, first `{first}`"),
        };
        Finding { message, ..finding.key("link") }.help("pack the files that they lead to in their place")
    }));
    out.extend(of(rule, pack, &import.replaced, TWICE).map(|(finding, first, count)| {
        let message = match count {
            1 => format!("`{first}` is in the zip more than once, with different content"),
            _ => format!("{count} names are in the zip more than once with different content, first `{first}`"),
        };
        Finding { message, ..finding.key("twice") }.help("pack each file once")
    }));
}

/// A finding without words on all of these, if there are any.
fn of<'n>(rule: &Rule, pack: &Packed<'_>, names: &'n [String], case: Case) -> Option<(Finding, &'n str, usize)> {
    let first = names.first()?;
    let finding = pack.at(rule, "", String::new()).case(case).evidence(Evidence::of_cases(names));
    Some((finding, first, names.len()))
}
