//! Every keyword needs its value, and a colour three numbers.

use super::super::{Check, Rule, RuleCx, counted};
use super::blender;
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_formats::mhmat::{Line, Value};
use mhlint_repo::{Surface, View, Wearer};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when the material is used",
        ),
        (Makehuman1, "does not put the asset on, or show the skin"),
        (Mpfb, "fails with an exception when it reads the material"),
    ],
    docs: include_str!("arity.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-arity",
        Level::Error,
        "a keyword of a material with too few values",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return blender::arity(&RULE, view, out);
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
            "have too few or too many values",
            out,
        );
    }
}

fn fault(surface: &Surface<'_>, line: &Line) -> Option<Fault> {
    let keyword = line.keyword.name;
    let is_1 = loader::is_1(surface.application);
    let (message, level, effect, help) = match line.keyword.value {
        // An empty one of a skin has a finding of its own (`library-scan-crash`).
        Value::Text
            if is_1 && line.count == 0 && keyword == "name" && surface.wearer != Wearer::Skin =>
        {
            (
                "`name` has no value".to_owned(),
                Level::Error,
                crash(surface),
                WRITE.to_owned(),
            )
        }
        Value::Text if is_1 => return None,
        Value::Text if line.count == 0 => valueless_text(keyword),
        Value::Text => return None,
        Value::Colour => colour(surface, line)?,
        Value::Parameter if line.count == 1 => (
            format!("`{keyword} {}` has no value", line.word(0)),
            Level::Error,
            crash(surface),
            WRITE.to_owned(),
        ),
        _ if line.count == 0 => (
            format!("`{keyword}` has no value"),
            Level::Error,
            crash(surface),
            WRITE.to_owned(),
        ),
        Value::Number if line.number_at(1).is_some() && !is_1 => (
            format!("`{keyword}` has more than one number"),
            Level::Info,
            "ignores all numbers but the first".to_owned(),
            "write one number, with a decimal point".to_owned(),
        ),
        _ => return None,
    };
    let place = Surface::place(line);
    Some(Fault {
        key: keyword.to_owned(),
        place,
        level,
        message,
        effect,
        help,
    })
}

const WRITE: &str = "write the value, or remove the line";

fn crash(surface: &Surface<'_>) -> String {
    loader::crash(surface, "IndexError")
}

fn valueless_text(keyword: &str) -> (String, Level, String, String) {
    let (level, effect) = match keyword {
        "name" => (Level::Warning, "shows the material without a name"),
        "tag" => (Level::Warning, "adds an empty tag"),
        _ => (Level::Info, "shows no description"),
    };
    (
        format!("`{keyword}` has no value"),
        level,
        effect.to_owned(),
        WRITE.to_owned(),
    )
}

/// A colour with another number of numbers than three. Of several lines the last counts, but to
/// `MakeHuman` 1 each.
fn colour(surface: &Surface<'_>, line: &Line) -> Option<(String, Level, String, String)> {
    let keyword = line.keyword.name;
    let is_read = loader::is_1(surface.application) && line.count < 3;
    let is_read = is_read
        || surface
            .material
            .last(keyword)
            .is_some_and(|last| std::ptr::eq(last, line));
    let are_numbers = (0..line.count.min(3)).all(|at| line.number_at(at).is_some());
    if !is_read || !are_numbers {
        return None;
    }
    match line.count {
        3 => None,
        4.. => line.number_at(3).map(|_| {
            let message = format!("`{keyword}` has more than three numbers");
            (
                message,
                Level::Info,
                "ignores the fourth number".to_owned(),
                "write red, green and blue".to_owned(),
            )
        }),
        count => {
            let (level, effect) = short_colour(surface, keyword);
            let message = format!("`{keyword}` has {} instead of 3", counted(count, "number"));
            Some((
                message,
                level,
                effect,
                "write red, green and blue, each between 0 and 1".to_owned(),
            ))
        }
    }
}

/// What reads the third number of a colour (worn 2.1).
fn short_colour(surface: &Surface<'_>, keyword: &str) -> (Level, String) {
    if loader::is_1(surface.application) {
        return (Level::Error, crash(surface));
    }
    let lacks = |keyword| surface.has(keyword) == Some(false);
    let error = |effect: String| (Level::Error, effect);
    match keyword {
        "diffuseColor" if lacks("diffuseTexture") => error(format!(
            "crashes with `IndexError` {} and in the glTF and OBJ exports; {}",
            loader::when(surface),
            loader::models(surface)
        )),
        "diffuseColor" | "specularColor" | "emissiveColor" => {
            error("crashes with `IndexError` in the OBJ export".to_owned())
        }
        "ambientColor" if loader::is_phong(surface) && lacks("aomapTexture") => {
            error(crash(surface))
        }
        "glassColor"
            if loader::number(surface, "transmission").is_some_and(|share| share > 0.0)
                && lacks("diffuseTexture") =>
        {
            error("crashes with `IndexError` in the glTF export".to_owned())
        }
        _ => (
            Level::Info,
            "does not read the colour of this material".to_owned(),
        ),
    }
}
