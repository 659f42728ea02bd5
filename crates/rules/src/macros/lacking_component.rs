//! A `comp` with more or fewer components than all names of its definition have parts.

use super::super::{Rule, counted};
use super::holders::Holders;
use super::listing::{Listing, Slip};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::macro_json::Macrodef;
use mhlint_repo::FileFacts;

/// If all names have more or fewer parts than `comp` has components, `comp` is wrong.
pub(super) fn finding(
    rule: &Rule,
    file: &FileFacts,
    holders: &Holders<'_>,
    macrodef: &Macrodef,
    listing: &Listing<'_>,
) -> Option<Finding> {
    let (parts, meant) = lacking(holders, listing)?;
    let names = || listing.strangers.iter().map(|stranger| &stranger.link.name);
    let message = format!(
        "`comp` has {}, but each name has {} (`{}` and {} more)",
        counted(macrodef.components.len(), "component"),
        counted(parts, "part"),
        names().next()?,
        names().count() - 1
    );
    let help = match meant {
        Some(meant) => format!("change `comp` to `[\"{}\"]`", meant.join("\", \"")),
        None => {
            "list one component in `comp` for each part of the names, in the same order".to_owned()
        }
    };
    let place = Place::pointer(["macrodef", &macrodef.index.to_string(), "comp"]);
    let finding = rule
        .at(file, place, message)
        .key(format!("{}/length", macrodef.components.join("-")))
        .help(help);
    let effect = "never applies the macrodef: its components generate none of the listed names";
    Some(
        finding
            .effect(effect)
            .evidence(Evidence::of_cases(names()).out_of(macrodef.links.len())),
    )
}

/// How many parts the names have, and the components that their parts are values of, where that is
/// clear.
fn lacking<'a>(
    holders: &Holders<'a>,
    listing: &Listing<'_>,
) -> Option<(usize, Option<Vec<&'a str>>)> {
    let Slip::Parts(parts) = &listing.strangers.first()?.slip else {
        return None;
    };
    let is_like_it = |slip: &Slip| matches!(slip, Slip::Parts(other) if other == parts);
    let are_all = listing.found.is_empty()
        && listing
            .strangers
            .iter()
            .all(|stranger| is_like_it(&stranger.slip));
    if !are_all || *parts == 0 || listing.strangers.len() < 2 {
        return None;
    }
    if *parts > MOST_PARTS {
        return Some((*parts, None));
    }
    let meant = (0..*parts)
        .map(|part| component_of(holders, listing, part))
        .collect();
    Some((*parts, meant))
}

/// Parts of a name for which components are looked for: nobody has more components.
const MOST_PARTS: usize = 64;

/// The only component that has the parts at one place of all names as values.
fn component_of<'a>(holders: &Holders<'a>, listing: &Listing<'_>, part: usize) -> Option<&'a str> {
    let names = listing.strangers.iter();
    let tokens: Vec<&str> = names
        .filter_map(|stranger| stranger.link.name.split('-').nth(part))
        .collect();
    let mut fitting = holders.of_all(&tokens);
    fitting
        .next()
        .filter(|_| fitting.next().is_none())
        .map(|component| component.name.as_str())
}
