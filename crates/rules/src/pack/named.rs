//! Names in a zip that are not those of files: backslashes, links, one name twice.

use super::super::Rule;
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Evidence, Finding, Level,
};
use mhlint_discover::Refusal;
use mhlint_repo::{Layer, Pack};

const BACKSLASHES: Case = &[
    (
        Makehuman2,
        Level::Error,
        "on Linux and macOS, unpacks them as files at the top and imports none of them",
    ),
    (
        Mpfb,
        Level::Error,
        "on Linux and macOS, unpacks them as files at the top, where no list shows them",
    ),
];
const REFUSED: Case = &[(
    Mpfb,
    Level::Error,
    "on Linux and macOS, rejects the zip: no name begins with `packs/`. The mode FIX cannot \
        repair it",
)];
const LINKS: Case = &[
    (
        Makehuman2,
        Level::Error,
        "imports a text with the path in place of each file",
    ),
    (
        Mpfb,
        Level::Error,
        "unpacks a text with the path in place of each file",
    ),
];
const TWICE: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "imports the last of them; the others are lost",
    ),
    (
        Mpfb,
        Level::Warning,
        "unpacks the last of them; the others are lost",
    ),
];

pub(super) fn report(rule: &Rule, layer: &Layer, pack: &Pack, out: &mut Vec<Finding>) {
    let names = &pack.names;
    out.extend(
        of(rule, layer, &names.backslashes, BACKSLASHES).map(|(finding, first, count)| {
            let first = first.replace('/', "\\");
            let message = match count {
                1 => format!("`{first}` has `\\` between its folders"),
                _ => format!("{count} names have `\\` between their folders, first `{first}`"),
            };
            let is_refused = pack.refusal == Some(Refusal::Backslashes);
            let finding = if is_refused {
                finding.case(REFUSED)
            } else {
                finding
            };
            Finding {
                message,
                ..finding.key("backslash")
            }
            .help(
                "pack with a program that writes `/`, such as 7-Zip or the file manager of the \
                system",
            )
        }),
    );
    out.extend(
        of(rule, layer, &names.links, LINKS).map(|(finding, first, count)| {
            let message = match count {
                1 => format!("`{first}` is a symbolic link"),
                _ => format!("{count} members are symbolic links, first `{first}`"),
            };
            Finding {
                message,
                ..finding.key("link")
            }
            .help("pack the files that they lead to in their place")
        }),
    );
    out.extend(
        of(rule, layer, &names.replaced, TWICE).map(|(finding, first, count)| {
            let message = match count {
                1 => format!("`{first}` is in the zip more than once, with different content"),
                _ => format!(
                    "{count} names are in the zip more than once with different content, \
                first `{first}`"
                ),
            };
            Finding {
                message,
                ..finding.key("twice")
            }
            .help("pack each file once")
        }),
    );
}

/// A finding without words on all of these, if there are any.
fn of<'n>(
    rule: &Rule,
    layer: &Layer,
    names: &'n [String],
    case: Case,
) -> Option<(Finding, &'n str, usize)> {
    let first = names.first()?;
    let finding = rule
        .in_layer(layer, "", String::new())
        .case(case)
        .evidence(Evidence::of_cases(names));
    Some((finding, first, names.len()))
}
