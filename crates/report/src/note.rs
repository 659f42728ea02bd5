//! Notes, phases and steps of a run in words.

use mhlint_diag::{FailedStep, Note, Phase};

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
        Note::SystemIsChecked { path } => {
            format!("`--system` names the checked folder itself; {path} is checked")
        }
        Note::StandsAlone { path, application } => {
            format!(
                "{path} is the data of {application} itself, and was checked without those of \
                    `--system`"
            )
        }
        Note::NothingFor { applications } => {
            let titles: Vec<&str> = applications
                .iter()
                .map(|application| application.title())
                .collect();
            format!(
                "nothing was checked for {}: no PATH has the layout of its data",
                titles.join(", ")
            )
        }
        Note::Compared { with, gone } => {
            let gone = match gone {
                0 => String::new(),
                1 => "; 1 finding no longer occurs".to_owned(),
                more => format!("; {more} findings no longer occur"),
            };
            format!("compared with `{with}`: only new or worse findings are reported{gone}")
        }
        Note::SettingsChanged { path } => {
            format!("`{path}` changed; both sides were checked with its current settings")
        }
        Note::Unfinished { turns } => {
            format!("fixes did not settle in {turns} rounds; run mhlint again for the rest")
        }
    }
}
