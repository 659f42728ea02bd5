//! Numbers of a material must be numbers.

use super::super::{Check, Rule, RuleCx, shown};
use super::blender;
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhmat::{Line, Value, Word};
use mhlint_formats::python_int;
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `ValueError` when the material is used",
        ),
        (Makehuman1, "does not put the asset on, or show the skin"),
        (Mpfb, "fails with an exception when it reads the material"),
    ],
    docs: include_str!("value_type.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-type",
        Level::Error,
        "a value of a material that is not a number",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return blender::values(&RULE, view, out);
    }
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let lines = surface
            .material
            .lines
            .iter()
            .filter(|line| loader::reads(surface.application, line.keyword.name));
        let faults = lines.filter_map(|line| fault(surface, line)).collect();
        report(
            &RULE,
            surface,
            faults,
            "have values that are not numbers",
            out,
        );
    }
}

fn fault(surface: &Surface<'_>, line: &Line) -> Option<Fault> {
    let keyword = line.keyword.name;
    let mut words = line.words.iter();
    let is_wrong = |word: &&Word| word.number().is_none();
    let crash = || loader::crash(surface, "ValueError");
    let is_1 = loader::is_1(surface.application);
    let (word, level, effect) = match line.keyword.value {
        Value::Colour => (words.take(3).find(is_wrong)?, Level::Error, crash()),
        Value::Number if is_1 && matches!(keyword, "diffuseIntensity" | "specularIntensity") => {
            return None;
        }
        Value::Number => (words.next().filter(is_wrong)?, Level::Error, crash()),
        // A word alone is the name of a file; what its uniform makes of it has a finding of its
        // own.
        Value::Parameter if is_1 => {
            let is_list = keyword == "shaderParam" && line.count > 2;
            (
                words.skip(1).find(is_wrong).filter(|_| is_list)?,
                Level::Error,
                crash(),
            )
        }
        Value::Parameter if line.word(0) == "AdditiveShading" => {
            (words.nth(1).filter(is_wrong)?, Level::Error, crash())
        }
        Value::Whole => {
            let is_last = surface
                .material
                .last(keyword)
                .is_some_and(|last| std::ptr::eq(last, line));
            let word = words
                .next()
                .filter(|word| is_last && python_int(word.text.as_bytes()).is_none())?;
            (
                word,
                Level::Warning,
                "reads it as 0: the texture keeps its colours".to_owned(),
            )
        }
        _ => return None,
    };
    let of = if line.keyword.value == Value::Parameter {
        line.word(0)
    } else {
        keyword
    };
    let whole = if line.keyword.value == Value::Whole {
        "whole "
    } else {
        ""
    };
    Some(Fault {
        key: of.to_owned(),
        place: Place::Span(word.span.clone()),
        level,
        message: format!("`{}` of `{of}` is not a {whole}number", shown(&word.text)),
        effect,
        help: help(line, &word.text),
    })
}

fn help(line: &Line, text: &str) -> String {
    if line.keyword.value == Value::Parameter && line.word(0).ends_with("Texture") {
        return "rename the picture without spaces, and write nothing behind its name".to_owned();
    }
    let is_colour = line.keyword.value == Value::Colour;
    let plain = text.trim_end_matches('%');
    let with_point = plain.replacen(',', ".", 1);
    match with_point.parse::<f64>() {
        Ok(number) if text.ends_with('%') => {
            format!("write `{}` in place of `{}`", number / 100.0, shown(text))
        }
        Ok(_) if !is_colour || !text.ends_with(',') => {
            format!("write `{with_point}` in place of `{}`", shown(text))
        }
        _ if line.keyword.value == Value::Whole => "write 0, 1 or 2".to_owned(),
        _ if is_colour => {
            "write red, green and blue as three numbers between 0 and 1, with spaces between them"
                .to_owned()
        }
        _ => "write a number, with a decimal point".to_owned(),
    }
}
