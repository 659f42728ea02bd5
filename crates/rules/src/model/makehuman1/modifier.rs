//! Each modifier of a model has the name of a modifier that the program loads, with a value in its
//! range.

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::modifiers::meant::Meant;
use super::super::super::{Rule, RuleCx, did_you_mean, such};
use super::own;
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_discover::Kind;
use mhlint_formats::mhm::lines::Line;
use mhlint_formats::python_float;
use mhlint_repo::makehuman1::{KnownModifier, SavedModel, VARIABLES, Version, View, category};

const LOST: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with an exception at the line, and loads the model without it",
)];
const UNKNOWN: Case = &[(
    Makehuman1,
    Level::Warning,
    "loads the model without it, with a line in the log",
)];
const BLANK: Case = &[(
    Makehuman1,
    Level::Warning,
    "takes the first word for the name: loses the value, with a line in the log",
)];
const NAN: Case = &[(Makehuman1, Level::Warning, "sets the slider to its maximum")];
const LIMITED: Case = &[(Makehuman1, Level::Warning, "sets the slider to its limit")];
const REPEATED: Case = &[(Makehuman1, Level::Warning, "uses the last value")];
const UNBALANCED: Case = &[(
    Makehuman1,
    Level::Warning,
    "makes other values of them, which add up to 1",
)];

pub(in super::super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let known = Known::of(view);
    for model in own(view) {
        out.extend(broken(rule, model, &known));
        out.extend(blanks(rule, model, &known));
        out.extend(non_finite(rule, model, &known));
        out.extend(repeated(rule, model));
        if model.version != Version::Current || !known.is_whole {
            continue;
        }
        out.extend(out_of_range(rule, model, &known));
        out.extend(unbalanced(rule, model));
    }
    if known.is_whole {
        out.extend(unknown(rule, view, &known, cx));
    }
}

/// Names of macros whose variable is misspelt in their own file, in small letters.
fn misspelt(view: &View<'_>) -> impl Iterator<Item = String> {
    let of_macros = view.modifiers.all.iter().filter(|one| {
        let variable = one.modifier.variable.as_ref();
        variable.is_some_and(|variable| category(&variable.name).is_none())
    });
    of_macros.map(|one| one.name.to_ascii_lowercase())
}

/// The modifiers that the program has.
struct Known<'v, 'a> {
    by_name: BTreeMap<&'v str, &'v KnownModifier<'a>>,
    /// Names of the sliders for targets of the user.
    custom: BTreeSet<&'v str>,
    /// The length of the longest name in `custom`, in bytes.
    longest: usize,
    /// Names that sliders ask for. If such a modifier does not exist it is reported for the slider.
    asked: BTreeSet<&'v str>,
    /// Names of modifiers in older models.
    older: BTreeSet<&'v str>,
    /// Names of macros whose variable is misspelt in their own file, in small letters.
    misspelt: BTreeSet<String>,
    is_whole: bool,
}

impl<'v, 'a> Known<'v, 'a> {
    fn of(view: &'v View<'a>) -> Self {
        let tables = view
            .layers
            .system
            .into_iter()
            .flat_map(|system| system.files.values());
        let tables = tables
            .filter(|file| file.kind == Kind::ModifierMapping)
            .filter_map(|file| file.modifier_mapping());
        Self {
            by_name: view
                .modifiers
                .all
                .iter()
                .map(|one| (one.name.as_str(), one))
                .collect(),
            custom: view
                .targets
                .custom
                .iter()
                .map(|one| one.name.as_str())
                .collect(),
            longest: view
                .targets
                .custom
                .iter()
                .map(|one| one.name.len())
                .max()
                .unwrap_or_default(),
            asked: view.modifiers.with_slider(),
            older: tables
                .flat_map(|table| &table.rows)
                .map(|row| row.old.as_str())
                .collect(),
            misspelt: misspelt(view).collect(),
            is_whole: view.modifiers.is_whole(),
        }
    }

    fn has(&self, name: &str) -> bool {
        self.by_name.contains_key(name) || self.custom.contains(name)
    }

    /// Whether a line names a target of the user with a blank in its name, at which the program
    /// cuts the name. Another rule reports that for the target.
    fn is_cut(&self, line: &Line) -> bool {
        let mut name = String::new();
        for word in &line.values {
            if !name.is_empty() {
                name.push(' ');
            }
            name.push_str(&word.text);
            if name.len() > self.longest {
                break;
            }
            if name.contains(' ') && self.custom.contains(name.as_str()) {
                return true;
            }
        }
        false
    }

    /// Whether the name belongs to a macro whose variable is misspelt in its own file.
    fn is_misspelt(&self, name: &str) -> bool {
        self.misspelt.contains(&name.to_ascii_lowercase())
    }

    /// The least and the greatest value of a modifier.
    fn range(&self, name: &str) -> Option<[f64; 2]> {
        let of_pair = |one: &KnownModifier<'_>| {
            let is_pair = one.modifier.variable.is_none() && one.modifier.tails.sides().is_some();
            [if is_pair { -1.0 } else { 0.0 }, 1.0]
        };
        let own = self.by_name.get(name).map(|one| of_pair(one));
        own.or_else(|| self.custom.contains(name).then_some([0.0, 1.0]))
    }
}

/// The lines of a model that set modifiers.
fn lines<'a>(model: &SavedModel<'a>) -> impl Iterator<Item = &'a Line> {
    model.lines.of("modifier")
}

fn value(line: &Line) -> Option<f64> {
    python_float(line.value(1).as_bytes())
}

fn place(line: &Line) -> Place {
    Place::Span(line.values.first().unwrap_or(&line.keyword).span.clone())
}

/// A finding on some lines of a model, placed at the first.
fn told(rule: &Rule, model: &SavedModel<'_>, faulty: &[&Line], message: String) -> Option<Finding> {
    let finding = rule.at(model.file, place(faulty.first()?), message);
    Some(finding.evidence(Evidence::of_cases(faulty.iter().map(|line| line.value(0)))))
}

/// A finding on lines without a name or without a number.
fn broken(rule: &Rule, model: &SavedModel<'_>, known: &Known<'_, '_>) -> Option<Finding> {
    // The program looks for the name first, so that the number of an unknown modifier does not
    // matter.
    let is_asked = |line: &&Line| {
        line.values.len() < 2
            || known.has(line.value(0))
            || !known.is_whole && name_with_blanks(line).is_none()
    };
    let faulty: Vec<&Line> = lines(model)
        .filter(is_asked)
        .filter(|line| value(line).is_none() && !known.is_cut(line))
        .collect();
    let first = faulty.first()?;
    let more = such(faulty.len(), "lines");
    let (message, help) = match first.values.len() {
        0 | 1 => (
            "`modifier` needs a name and a number".to_owned() + &more,
            "write both, or remove the line",
        ),
        _ => (
            format!("`{}` is not a number{more}", first.value(1)),
            "write the number with a decimal point",
        ),
    };
    // The name of every modifier is a group, `/` and a word. Without `/` the program finds no
    // modifier and does not read the number.
    let is_none = |line: &&Line| line.values.len() > 1 && !line.value(0).contains('/');
    let case = if faulty.iter().all(is_none) {
        UNKNOWN
    } else {
        LOST
    };
    told(rule, model, &faulty, message).map(|finding| finding.case(case).help(help))
}

/// The name of a modifier if it consists of several words, with a number behind them.
fn name_with_blanks(line: &Line) -> Option<String> {
    let is_number = |at: &usize| python_float(line.value(*at).as_bytes()).is_some();
    let end = (1..line.values.len())
        .find(is_number)
        .filter(|end| *end > 1)?;
    let words: Vec<&str> = line
        .values
        .iter()
        .take(end)
        .map(|word| &*word.text)
        .collect();
    Some(words.join(" ")).filter(|name| name.contains('/'))
}

/// A finding on names with blanks, of which the program takes the first word for the name. Names of
/// targets of the user are reported by another rule.
fn blanks(rule: &Rule, model: &SavedModel<'_>, known: &Known<'_, '_>) -> Option<Finding> {
    let is_blank = |line: &&Line| {
        !known.has(line.value(0)) && !known.is_cut(line) && name_with_blanks(line).is_some()
    };
    let faulty: Vec<&Line> = lines(model).filter(is_blank).collect();
    let name = name_with_blanks(faulty.first()?)?;
    let message = format!(
        "modifier `{name}` has a blank in its name{}",
        such(faulty.len(), "lines")
    );
    let finding = told(rule, model, &faulty, message)?
        .key("blank")
        .case(BLANK);
    let finding = finding.evidence(Evidence::of_cases(
        faulty.iter().filter_map(|line| name_with_blanks(line)),
    ));
    Some(
        finding.help(
            "remove the line, or name the modifier without blanks where it is made, and here",
        ),
    )
}

fn non_finite(rule: &Rule, model: &SavedModel<'_>, known: &Known<'_, '_>) -> Option<Finding> {
    let is_bad = |line: &&Line| value(line).is_some_and(f64::is_nan) && known.has(line.value(0));
    let faulty: Vec<&Line> = lines(model).filter(is_bad).collect();
    let message = format!(
        "the value of `{}` is NaN{}",
        faulty.first()?.value(0),
        such(faulty.len(), "lines")
    );
    let finding = told(rule, model, &faulty, message)?
        .key("non-finite")
        .case(NAN);
    Some(finding.help("write a number, or remove the line"))
}

fn out_of_range(rule: &Rule, model: &SavedModel<'_>, known: &Known<'_, '_>) -> Option<Finding> {
    let is_outside = |line: &&Line| {
        let range = known
            .range(line.value(0))
            .zip(value(line).filter(|value| !value.is_nan()));
        range.is_some_and(|([least, most], value)| value < least || value > most)
    };
    let faulty: Vec<&Line> = lines(model).filter(is_outside).collect();
    let first = faulty.first()?;
    let ([least, most], value) = known.range(first.value(0)).zip(value(first))?;
    let more = such(faulty.len(), "lines");
    let message = format!(
        "`{}` is set to {value}, outside {least} to {most}{more}",
        first.value(0)
    );
    let finding = told(rule, model, &faulty, message)?
        .key("range")
        .case(LIMITED);
    let of_percent = value / 100.0;
    let help = if value.abs() >= 2.0 && (least..=most).contains(&of_percent) {
        format!("write {of_percent} if you meant per cent")
    } else {
        format!("write a value from {least} to {most}")
    };
    Some(finding.help(help))
}

/// A finding on a modifier that stands in two lines with different values.
fn repeated(rule: &Rule, model: &SavedModel<'_>) -> Option<Finding> {
    let mut known: BTreeMap<&str, &Line> = BTreeMap::new();
    let mut lost = Vec::new();
    for line in lines(model).filter(|line| value(line).is_some()) {
        let earlier = known.insert(line.value(0), line);
        lost.extend(
            earlier
                .filter(|earlier| earlier.value(1) != line.value(1))
                .map(|earlier| (earlier, line)),
        );
    }
    let (first, other) = lost.first()?;
    let message = format!(
        "`{}` is set more than once{}",
        first.value(0),
        such(lost.len(), "lines")
    );
    let finding = rule
        .at(model.file, place(other), message)
        .key("repeated")
        .case(REPEATED);
    let finding = finding.related(model.file.path.clone(), place(first), "set here before");
    let evidence = Evidence::of_cases(lost.iter().map(|(line, _)| line.value(0)));
    Some(
        finding
            .evidence(evidence)
            .help("remove the lines that do not count"),
    )
}

/// A finding on races that do not add up to 1: the program changes them so that they do. A race
/// that is not set counts as a third (`docs/loaders/makehuman1/macros.md#races`).
fn unbalanced(rule: &Rule, model: &SavedModel<'_>) -> Option<Finding> {
    let races: Vec<&str> = VARIABLES
        .iter()
        .skip(VARIABLES.len() - 3)
        .copied()
        .collect();
    let race = |line: &Line| {
        races
            .iter()
            .find(|race| line.value(0).rsplit('/').next() == Some(**race))
            .copied()
    };
    let set: Vec<(&str, &Line)> = lines(model)
        .filter_map(|line| Some((race(line)?, line)))
        .collect();
    let (_, first) = set.first()?;
    let mut values: BTreeMap<&str, f64> = races.iter().map(|race| (*race, 1.0 / 3.0)).collect();
    values.extend(
        set.iter()
            .filter_map(|(race, line)| Some((*race, value(line)?.clamp(0.0, 1.0)))),
    );
    let sum: f64 = values.values().sum();
    // Values are saved with six decimals.
    if (sum - 1.0).abs() < 1e-3 {
        return None;
    }
    let missing: Vec<&str> = races
        .iter()
        .copied()
        .filter(|race| set.iter().all(|(own, _)| own != race))
        .collect();
    let help = match missing.as_slice() {
        [] => "write values that add up to 1".to_owned(),
        missing => format!(
            "write lines for {}, and values that add up to 1",
            missing.join(" and ")
        ),
    };
    let message = format!("African, Asian and Caucasian add up to {sum:.3}, expected 1");
    let finding = rule
        .at(model.file, place(first), message)
        .key("races")
        .case(UNBALANCED);
    Some(finding.help(help))
}

/// Findings on modifiers that do not exist. Modifiers that the same models set are one finding.
fn unknown(rule: &Rule, view: &View<'_>, known: &Known<'_, '_>, cx: &RuleCx<'_>) -> Vec<Finding> {
    let meant = Meant::of(view, cx);
    let all = own(view).flat_map(|model| lines(model).map(move |line| (model, line)));
    let lost = all.filter(|(model, line)| {
        let name = line.value(0);
        let is_older = model.version != Version::Current && known.older.contains(name);
        line.values.len() > 1
            && !known.has(name)
            && !known.asked.contains(name)
            && !is_older
            && !known.is_cut(line)
            && name_with_blanks(line).is_none()
    });
    // If the name is wrong where the modifier is defined, it is reported there.
    let lost = lost.filter(|(_, line)| {
        meant.modifier(line.value(0), cx).is_none() && !known.is_misspelt(line.value(0))
    });
    let by_name = grouped(lost.map(|(model, line)| (line.value(0), (model, line))));
    let models = |lines: &[(&SavedModel<'_>, &Line)]| -> Vec<String> {
        lines
            .iter()
            .map(|(model, _)| model.file.path.clone())
            .collect()
    };
    let by_models = grouped(by_name.into_values().map(|lines| (models(&lines), lines)));
    by_models
        .into_values()
        .filter_map(|names| unknown_in(rule, view, &names, cx))
        .collect()
}

fn unknown_in(
    rule: &Rule,
    view: &View<'_>,
    names: &[Vec<(&SavedModel<'_>, &Line)>],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let lines = names.first()?;
    let (model, first) = lines.first()?;
    let name = first.value(0);
    let models = such(lines.len(), "models");
    let message = match names.len() {
        1 => format!("modifier `{name}` does not exist{models}"),
        count => format!("{count} modifiers do not exist, first `{name}`{models}"),
    };
    let custom = view.targets.custom.iter().map(|one| one.name.as_str());
    let near = cx
        .suggestions
        .nearest(name, view.modifiers.names().chain(custom));
    let all = names
        .iter()
        .flatten()
        .map(|(model, line)| (line.value(0), &model.file.path, place(line)));
    let finding = rule
        .at(model.file, place(first), message)
        .key("unknown")
        .parts_at(all)
        .case(UNKNOWN);
    let evidence = Evidence::of_cases(names.iter().flatten().map(|(_, line)| line.value(0)));
    let otherwise =
        "write the full name of a modifier, such as `head/head-oval`, or remove the line";
    Some(
        finding
            .evidence(evidence)
            .help(did_you_mean(near, otherwise)),
    )
}
