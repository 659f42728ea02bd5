//! Faults of the lines of a material: one finding for all of a level in a file.

use super::super::Rule;
use mhlint_diag::{EXAMPLES, Evidence, Finding, Level, Place};
use mhlint_repo::Surface;

/// A line that is not as it should be.
pub(super) struct Fault {
    /// Its keyword, or what of it is at fault.
    pub(super) key: String,
    pub(super) place: Place,
    pub(super) level: Level,
    pub(super) message: String,
    pub(super) effect: String,
    pub(super) help: String,
}

/// The findings on the faults of one material. `several` says what they have in common.
pub(super) fn report(
    rule: &Rule,
    surface: &Surface<'_>,
    faults: Vec<Fault>,
    several: &str,
    out: &mut Vec<Finding>,
) {
    for level in [Level::Error, Level::Warning, Level::Info] {
        let own: Vec<&Fault> = faults.iter().filter(|fault| fault.level == level).collect();
        let Some(first) = own.first() else { continue };
        let message = match own.len() {
            1 => first.message.clone(),
            count => {
                let mut keys: Vec<String> =
                    own.iter().map(|fault| format!("`{}`", fault.key)).collect();
                keys.dedup();
                let more = keys.len().saturating_sub(NAMED);
                keys.truncate(NAMED);
                let more = if more > 0 {
                    format!(" and {more} more")
                } else {
                    String::new()
                };
                format!("{count} lines {several}: {}{more}", keys.join(", "))
            }
        };
        let finding = rule
            .at(surface.file, first.place.clone(), message)
            .level_in(surface.application, level);
        let finding = finding
            .effect_in(surface.application, effect(&own, first))
            .help(help(&own, first));
        let parts = own
            .iter()
            .map(|fault| (fault.key.clone(), &surface.file.path, fault.place.clone()));
        let finding = finding.key(level.to_string()).parts_at(parts);
        out.push(if own.len() > 1 {
            let evidence =
                Evidence::of_unnamed(own.iter().take(EXAMPLES).map(|fault| fault.message.clone()));
            finding.evidence(Evidence {
                count: own.len() as u64,
                ..evidence
            })
        } else {
            finding
        });
    }
}

/// What becomes of the lines, as far as it is the same for all of them.
fn effect(own: &[&Fault], first: &Fault) -> String {
    if own.len() == 1 {
        first.effect.clone()
    } else {
        first
            .effect
            .replace("ignores the line", "ignores the lines")
            .replace("reads it as", "reads them as")
    }
}

/// What to do about the lines. Where that differs it is said of a few of them.
fn help(own: &[&Fault], first: &Fault) -> String {
    if own.iter().all(|fault| fault.help == first.help) {
        return first.help.clone();
    }
    let mut told: Vec<String> = own
        .iter()
        .map(|fault| format!("for `{}`: {}", fault.key, fault.help))
        .collect();
    told.dedup();
    let more = told.len().saturating_sub(NAMED);
    told.truncate(NAMED);
    if more > 0 {
        told.push(format!("likewise {more} more"));
    }
    told.join("; ")
}

/// Keywords that a message names.
const NAMED: usize = 3;
