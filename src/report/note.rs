//! Notes, phases and steps of a run in words.

use crate::diag::{FailedStep, Note, Phase};

/// A phase, as `--timings` lists it.
pub const fn phase(phase: Phase) -> &'static str {
    match phase {
        Phase::Read => "read",
        Phase::Evaluation => "targets and evaluation",
        Phase::Rules => "rules",
        Phase::Places => "places",
    }
}

/// A step that failed, not made harmless yet.
pub(super) fn step(step: &FailedStep) -> String {
    match step {
        FailedStep::Evaluation { base } => format!("evaluation of `{base}`"),
        FailedStep::Places => "places of findings".to_owned(),
    }
}

/// One sentence, not made harmless yet.
pub fn note(note: &Note) -> String {
    match note {
        Note::SystemIsChecked { path } => format!("`--system` names the data to judge itself; {path} is judged"),
        Note::Compared { with, gone } => {
            let gone = match gone {
                0 => String::new(),
                1 => "; 1 finding is gone".to_owned(),
                more => format!("; {more} findings are gone"),
            };
            format!("compared with `{with}`: only what is new or worse is told{gone}")
        }
        Note::SettingsChanged { path } => {
            format!("`{path}` changed; both sides were checked with it as it is now")
        }
        Note::Unfinished { turns } => {
            format!("fixes did not come to an end in {turns} turns; run mhlint again for the rest")
        }
    }
}
