//! Numbers of a material must be within their range.

use super::super::{Check, Rule, RuleCx, shown};
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{
    Application::{self, Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use mhlint_formats::mhmat::{Line, Value};
use mhlint_formats::python_int;
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "uses another number"),
        (Makehuman1, "uses another number"),
    ],
    docs: include_str!("range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-range",
        Level::Warning,
        "a number of a material outside its range",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let material = surface.material;
        let is_last = |line: &&Line| {
            material
                .last(line.keyword.name)
                .is_some_and(|last| std::ptr::eq(last, *line))
        };
        let lines = material
            .lines
            .iter()
            .filter(|line| loader::reads(surface.application, line.keyword.name));
        // Of several lines the last counts.
        let faults = lines
            .filter_map(|line| Some((line, words(surface.application, line)?)))
            .filter(|(line, _)| is_last(line));
        // Beside a texture MakeHuman 2 shows the texture alone (`material-tinted-texture`).
        let is_tint = |line: &Line| {
            line.keyword.name == "diffuseColor"
                && !loader::is_1(surface.application)
                && material.last("diffuseTexture").is_some()
        };
        let white =
            "write `1.0 1.0 1.0`: beside `diffuseTexture` MakeHuman 2 shows the texture alone";
        let fault = |(line, (effect, help)): (&Line, (String, String))| Fault {
            key: line.keyword.name.to_owned(),
            place: Surface::place(line),
            level: Level::Warning,
            message: format!(
                "`{} {}` is outside {}",
                line.keyword.name,
                short(line),
                limits(surface.application, line)
            ),
            effect,
            help: if is_tint(line) {
                white.to_owned()
            } else {
                help
            },
        };
        report(
            &RULE,
            surface,
            faults.map(fault).collect(),
            "have numbers outside their range",
            out,
        );
    }
}

fn short(line: &Line) -> String {
    let words = if line.keyword.value == Value::Colour {
        3
    } else {
        1
    };
    let text: Vec<&str> = line
        .words
        .iter()
        .take(words)
        .map(|word| &*word.text)
        .collect();
    shown(&text.join(" "))
}

fn limits(application: Application, line: &Line) -> String {
    let (low, high) = match line.keyword.value {
        Value::Whole => (0.0, 2.0),
        _ => loader::range(application, line.keyword.name).unwrap_or((0.0, 1.0)),
    };
    if high.is_finite() {
        format!("{low} to {high}")
    } else {
        format!("{low} and more")
    }
}

/// Consequence and help, if a number is out of range.
fn words(application: Application, line: &Line) -> Option<(String, String)> {
    match line.keyword.value {
        Value::Whole => match python_int(line.word(0).as_bytes())? {
            0..=2 => None,
            3.. => Some((
                "reads it as 0: the texture keeps its colours".to_owned(),
                "write 0, 1 or 2".to_owned(),
            )),
            _ => Some((
                "does nothing with it: the texture keeps its colours".to_owned(),
                "write 0, 1 or 2".to_owned(),
            )),
        },
        Value::Number => {
            let (low, high) = loader::range(application, line.keyword.name)?;
            let number = line
                .number_at(0)
                .filter(|number| !(low..=high).contains(number))?;
            let used = if number < low { low } else { high };
            let help = if high.is_finite() {
                format!("write a number from {low} to {high}")
            } else {
                "write 0 or more".to_owned()
            };
            Some((format!("uses {used} instead"), help))
        }
        Value::Colour => {
            let numbers: Vec<f64> = (0..3).filter_map(|at| line.number_at(at)).collect();
            let is_outside =
                numbers.len() == 3 && numbers.iter().any(|number| !(0.0..=1.0).contains(number));
            let is_byte = numbers.iter().all(|number| (0.0..=255.0).contains(number))
                && numbers.iter().any(|one| *one > 2.0);
            let help = if is_byte {
                let scaled: Vec<String> = numbers
                    .iter()
                    .map(|number| format!("{:.3}", number / 255.0))
                    .collect();
                format!(
                    "write `{}`: the same colour on a scale from 0 to 1",
                    scaled.join(" ")
                )
            } else {
                "write red, green and blue from 0 to 1".to_owned()
            };
            let effect = if loader::is_1(application) {
                "limits each number to the range from 0 to 1: the surface gets a wrong colour"
            } else {
                "does not limit the colour: the surface gets a wrong colour"
            };
            is_outside.then(|| (effect.to_owned(), help))
        }
        _ => None,
    }
}
