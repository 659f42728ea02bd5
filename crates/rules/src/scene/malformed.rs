//! A scene can be loaded.

use super::super::{Check, Rule, RuleCx, counted};
use super::FIRST;
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::pickle::{Break, Fault};
use mhlint_formats::scene::SceneFault;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `AttributeError` when the scene is chosen",
    )],
    docs: include_str!("malformed.md").trim_ascii_end(),
    ..RuleInfo::new("scene-malformed", Level::Error, "a scene cannot be loaded")
});

const AT_START: Case = &[(
    Makehuman1,
    Level::Error,
    "stops at start: only the splash picture stays on the screen",
)];
const NO_LIGHTS: Case = &[(
    Makehuman1,
    Level::Error,
    "logs a warning and shows a scene without lights",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_makehuman1() {
        out.extend(view.files().filter_map(finding));
    }
}

fn finding(file: &FileFacts) -> Option<Finding> {
    let fault = file.scene()?.fault.as_ref()?;
    let finding = RULE.at(file, Place::File, words(fault));
    let finding = match fault {
        SceneFault::Version(_) => finding.case(NO_LIGHTS),
        _ if file.rel == FIRST => finding.case(AT_START),
        _ => finding,
    };
    Some(finding.help(match fault {
        SceneFault::Version(_) => "save the scene again with the program of today",
        _ => "restore the file, or save the scene again with MakeHuman 1",
    }))
}

fn words(fault: &SceneFault) -> String {
    match fault {
        SceneFault::NoPickle => "not a scene: it does not begin as one".to_owned(),
        SceneFault::Pickle(at, fault) => format!(
            "the pickle cannot be read: {} at byte {at}",
            of_pickle(*fault)
        ),
        SceneFault::Ends(count, needed) => format!(
            "the file ends after {} of {needed}",
            counted(*count, "value")
        ),
        SceneFault::Version(found) => format!("its version is {found}, expected 5"),
        SceneFault::Value(what, expected, found) => {
            format!("{what} is {found}, expected {expected}")
        }
    }
}

fn of_pickle(fault: Fault) -> String {
    match fault {
        Fault::Break(Break::Truncated) => "it ends inside of an instruction".to_owned(),
        Fault::Break(Break::Unknown(code)) => format!("an unknown instruction ({code:#04x})"),
        Fault::Stack(name) => format!("`{name}` does not find what it works on"),
        Fault::Argument(name) => format!("`{name}` has an unusable value"),
        Fault::Refused(name) => format!("`{name}` is refused"),
        Fault::Protocol(number) => format!("protocol {number} does not exist"),
        Fault::Unbounded => "its values grow without bound".to_owned(),
    }
}
