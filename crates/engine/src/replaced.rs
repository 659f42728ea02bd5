//! Fixes as texts that are replaced, for reports that hold them: only what is small, and not of too
//! many findings.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::error::Error;
use super::fix::{Texts, Work};
use super::load::{Side, sides};
use super::run::lint_sides;
use mhlint_config::Config;
use mhlint_diag::{Change, Edit, Finding, Fix, FixKind, Outcome, Replaced};
use mhlint_fix::Patch;
use mhlint_source::{Limits, Lines};

/// Findings whose fix is worked out, the gravest first: as many as a page shows.
const FIXES: usize = 5_000;
/// Places that all fixes together replace: they make some megabytes of a report.
const ALL_PLACES: usize = 20_000;
/// Bytes of a file up to which its fixes are worked out.
const FILE: u64 = 1 << 20;
/// Places that one fix replaces.
const PLACES: usize = 500;
/// Bytes that one fix writes.
const WRITTEN: usize = 1 << 12;

/// Checks as [`super::lint`] does, and fills [`Fix::replaced`] of safe fixes.
///
/// # Errors
/// As [`super::lint`].
pub fn lint_with_replacements(paths: &[PathBuf], options: &Config) -> Result<Outcome, Error> {
    let (now, before) = sides(paths, options)?;
    let mut outcome = lint_sides(&now, before.as_ref(), options)?;
    let chosen = chosen(&outcome.findings);
    if !chosen.is_empty() {
        let work = Work::new(&now, before.as_ref(), options, false);
        let by_file = by_file(&outcome.findings, &chosen, &work, &now);
        fill(&mut outcome.findings, by_file, &now, &options.limits);
    }
    Ok(outcome)
}

/// The findings whose fix is worked out, in their order.
fn chosen(findings: &[Finding]) -> Vec<usize> {
    let is_safe = |fix: &Fix| fix.kind == FixKind::Safe && fix.steps.len() <= PLACES;
    let fixable = findings
        .iter()
        .enumerate()
        .filter(|(_, finding)| finding.fix.as_ref().is_some_and(is_safe));
    let mut chosen: Vec<(usize, &Finding)> = fixable.collect();
    chosen.sort_by_key(|(_, finding)| std::cmp::Reverse(finding.level));
    let mut chosen: Vec<usize> = chosen.into_iter().take(FIXES).map(|(at, _)| at).collect();
    chosen.sort_unstable();
    chosen
}

/// The edits of findings, by number of the finding.
type Edits = Vec<(usize, Vec<Edit>)>;

/// The edits by file, so that the lines of each are looked for once.
fn by_file(
    findings: &[Finding],
    chosen: &[usize],
    work: &Work,
    now: &Side,
) -> BTreeMap<String, Edits> {
    let mut files: BTreeMap<String, Edits> = BTreeMap::new();
    let mut texts = Texts::default();
    let mut room = ALL_PLACES;
    for at in chosen {
        let Some(fix) = findings.get(*at).and_then(|finding| finding.fix.as_ref()) else {
            continue;
        };
        if !work
            .steps(fix)
            .iter()
            .all(|step| is_small(now, &step.path) && step.change != Change::Remove)
        {
            continue;
        }
        let patches = small(work.alone(now, fix, &mut texts)).unwrap_or_default();
        let places = patches.iter().map(|(_, edits)| edits.len()).sum();
        let Some(left) = room.checked_sub(places) else {
            break;
        };
        room = left;
        for (path, edits) in patches {
            files.entry(path).or_default().push((*at, edits));
        }
    }
    files
}

fn is_small(now: &Side, path: &str) -> bool {
    now.find(path)
        .and_then(|(tree, rel)| tree.entry(rel))
        .is_some_and(|entry| entry.size <= FILE)
}

/// What a fix does, if that is little.
fn small(patches: BTreeMap<String, Patch>) -> Option<Vec<(String, Vec<Edit>)>> {
    let mut small = Vec::new();
    for (path, patch) in patches {
        let Patch::Edits(edits) = patch else {
            return None;
        };
        small.push((path, joined(edits)));
    }
    let all = || small.iter().flat_map(|(_, edits)| edits);
    let written: usize = all().map(|edit| edit.text.len()).sum();
    (all().count() <= PLACES && written <= WRITTEN).then_some(small)
}

/// Edits side by side as one: rows that are removed mostly follow one another.
fn joined(edits: Vec<Edit>) -> Vec<Edit> {
    let mut joined: Vec<Edit> = Vec::new();
    for edit in edits {
        match joined
            .last_mut()
            .filter(|last| last.range.end == edit.range.start)
        {
            Some(last) => {
                last.range.end = edit.range.end;
                last.text.extend(edit.text);
            }
            None => joined.push(edit),
        }
    }
    joined
}

/// Gives every finding its texts. A fix of which one file has no characters to be counted has none
/// at all.
fn fill(findings: &mut [Finding], files: BTreeMap<String, Edits>, now: &Side, limits: &Limits) {
    let mut replaced: BTreeMap<usize, Option<Vec<Replaced>>> = BTreeMap::new();
    for (path, edits) in files {
        let found = now
            .find(&path)
            .and_then(|(tree, rel)| tree.read(tree.entry(rel)?, limits).ok());
        let bytes = found.filter(|bytes| is_plain(bytes)).unwrap_or_default();
        let lines = (!bytes.is_empty()).then(|| Lines::of(&bytes));
        for (at, edits) in edits {
            let texts = lines.as_ref().and_then(|lines| {
                edits
                    .into_iter()
                    .map(|edit| text(&path, lines, edit))
                    .collect()
            });
            let all = replaced.entry(at).or_insert_with(|| Some(Vec::new()));
            *all = all
                .take()
                .zip(texts)
                .map(|(mut all, texts): (Vec<Replaced>, Vec<Replaced>)| {
                    all.extend(texts);
                    all
                });
        }
    }
    for (at, texts) in replaced {
        if let Some(fix) = findings
            .get_mut(at)
            .and_then(|finding| finding.fix.as_mut())
        {
            fix.replaced = texts.unwrap_or_default();
        }
    }
}

/// Whether lines and columns mean the same to everyone. What is packed is no text, and a byte order
/// mark counts as a character for some.
fn is_plain(bytes: &[u8]) -> bool {
    std::str::from_utf8(bytes).is_ok() && !bytes.starts_with("\u{feff}".as_bytes())
}

fn text(path: &str, lines: &Lines<'_>, edit: Edit) -> Option<Replaced> {
    let [from, to] = [edit.range.start, edit.range.end].map(|offset| {
        let position = lines.position(offset);
        [position.line, position.column]
    });
    Some(Replaced {
        path: path.to_owned(),
        from,
        to,
        text: String::from_utf8(edit.text).ok()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Level, Place, RuleInfo};

    #[test]
    fn neighbours_are_one_edit() {
        let edits = joined(vec![
            Edit::removal(0..3),
            Edit::replacement(3..5, "a"),
            Edit::removal(6..7),
        ]);
        assert_eq!(edits, [Edit::replacement(0..5, "a"), Edit::removal(6..7)]);
    }

    #[test]
    fn large_fixes_are_left_out() {
        let patch =
            |edits: Vec<Edit>| small(BTreeMap::from([("a".to_owned(), Patch::Edits(edits))]));
        let apart = |count: usize| {
            (0..count)
                .map(|at| Edit::removal(2 * at..2 * at + 1))
                .collect()
        };
        assert!(patch(apart(PLACES)).is_some() && patch(apart(PLACES + 1)).is_none());
        let long = |length: usize| vec![Edit::replacement(0..1, "x".repeat(length))];
        assert!(patch(long(WRITTEN)).is_some() && patch(long(WRITTEN + 1)).is_none());
        assert!(small(BTreeMap::from([("a".to_owned(), Patch::Remove)])).is_none());
    }

    #[test]
    fn the_gravest_are_chosen_in_their_order() {
        let finding = |number: usize| {
            let level = if number > FIXES {
                Level::Error
            } else {
                Level::Info
            };
            let fix = Fix::new(FixKind::Safe, "do it").step("a", Change::Element("/0".to_owned()));
            Finding::new(&RuleInfo::new("a-rule", level, ""), "a", Place::File, "it").fix(fix)
        };
        let chosen = chosen(&(0..FIXES + 3).map(finding).collect::<Vec<_>>());
        assert_eq!(
            (chosen.len(), chosen[FIXES - 3], chosen[FIXES - 1]),
            (FIXES, FIXES - 3, FIXES + 2)
        );
    }

    #[test]
    fn texts_that_are_counted_in_more_than_one_way_are_left_out() {
        assert!(is_plain("\u{e4}\n".as_bytes()));
        assert!(!is_plain(b"\xe4\n") && !is_plain(b"\xef\xbb\xbfa") && !is_plain(&[0x1f, 0x8b, 8]));
    }
}
