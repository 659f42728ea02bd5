//! Settings by slider name, as models name sliders: from the command line, a `.mhm` or a JSON file.
//!
//! Values are not clamped, as in a `.mhm`; everything not named stands at its reset default
//! (`docs/loaders/makehuman2/models.md#modifiers`).

use std::path::Path;

use super::error::Error;
use super::files::{read_document, read_text, shown};
use super::opened::Evaluation;
use mhlint_diag::nearest;
use mhlint_eval::scene::Setting;
use mhlint_eval::settings::SliderSetting;
use mhlint_formats::python_float;
use mhlint_json::Node;
use mhlint_source::file_name;

impl Evaluation {
    /// The setting that `values` make on top of the defaults, in order: of several for one slider
    /// the last counts.
    ///
    /// # Errors
    /// A name that no slider has.
    pub fn setting(&self, values: &[SliderSetting]) -> Result<Setting, Error> {
        let mut setting = self.scene.defaults();
        for (name, value) in values {
            let (slider, sign) = self
                .slider(name)
                .map(|slider| (slider, 1.0))
                .or_else(|unknown| self.slider_of_character(name).ok_or(unknown))?;
            self.scene.set(&mut setting, slider, sign * value);
        }
        Ok(setting)
    }

    /// As a model file: names that no slider has are left out and given back.
    pub(super) fn model_setting(&self, values: &[SliderSetting]) -> (Setting, Vec<String>) {
        let mut setting = self.scene.defaults();
        let mut unknown = Vec::new();
        for (name, value) in values {
            match self.scene.slider(name) {
                Some(slider) => self.scene.set(&mut setting, slider, *value),
                None => unknown.push(name.clone()),
            }
        }
        (setting, unknown)
    }

    /// Place of a slider: by its pattern or its key in `modelling.json`, then the same without
    /// regard to case.
    fn slider(&self, name: &str) -> Result<usize, Error> {
        let by_key = |same: &dyn Fn(&str) -> bool| {
            let mut fitting = self
                .keys
                .iter()
                .filter(|(key, patterns)| patterns.len() == 1 && same(key));
            let only = fitting.next().filter(|_| fitting.next().is_none())?;
            self.scene.slider(only.1.first()?)
        };
        let by_pattern = || {
            let mut fitting = self
                .scene
                .sliders
                .iter()
                .filter(|slider| slider.pattern.eq_ignore_ascii_case(name));
            fitting
                .next()
                .filter(|_| fitting.next().is_none())
                .and_then(|slider| self.scene.slider(&slider.pattern))
        };
        let exact = self
            .scene
            .slider(name)
            .or_else(|| by_key(&|key| key == name));
        let found = exact
            .or_else(by_pattern)
            .or_else(|| by_key(&|key| key.eq_ignore_ascii_case(name)));
        found.ok_or_else(|| {
            let patterns = self
                .scene
                .sliders
                .iter()
                .map(|slider| slider.pattern.as_str());
            let known: Vec<&str> = patterns
                .chain(self.keys.iter().map(|(key, _)| key.as_str()))
                .collect();
            let nearest =
                nearest(name, known.iter().copied()).or_else(|| same_in_short(name, &known));
            Error::UnknownSlider {
                name: name.to_owned(),
                nearest: nearest.map(str::to_owned),
            }
        })
    }
}

/// The only slider whose name is most like it without folders and directions: `gendr` is
/// `macrodetails/Gender`, and `eyes/l-eye-bag-incr` is one side of `eyes/l-eye-bag-decr|incr`.
fn same_in_short<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let shorts: Vec<String> = known.iter().map(|known| short(known)).collect();
    let wanted = short(name);
    let names = || shorts.iter().map(String::as_str);
    let like = names()
        .find(|short| *short == wanted)
        .or_else(|| nearest(&wanted, names()));
    let mut fitting = known
        .iter()
        .zip(&shorts)
        .filter(|(_, short)| Some(short.as_str()) == like);
    fitting
        .next()
        .filter(|_| fitting.next().is_none())
        .map(|(known, _)| *known)
}

/// The last part of a name without what says a direction, in small letters.
fn short(name: &str) -> String {
    let last = file_name(name);
    let stem = match last.rsplit_once('-') {
        Some((stem, end)) if end.contains('|') || end == "incr" || end == "decr" => stem,
        _ => last,
    };
    stem.to_lowercase()
}

/// `NAME=VALUE`.
///
/// # Errors
/// No `=`, or a value that is no number.
pub fn parse_setting(text: &str) -> Result<SliderSetting, Error> {
    let fault = |reason: &str| Error::Setting {
        text: text.to_owned(),
        reason: reason.to_owned(),
    };
    let (name, value) = text
        .rsplit_once('=')
        .ok_or_else(|| fault("expected NAME=VALUE"))?;
    let value =
        python_float(value.trim().as_bytes()).ok_or_else(|| fault("the value is not a number"))?;
    if !value.is_finite() {
        return Err(fault("the value is not a finite number"));
    }
    Ok((name.trim().to_owned(), value))
}

/// Settings from a `.mhm` (its `modifier` lines) or a JSON file: an object of names and numbers, a
/// list of `[name, number]`, an object that has either as `modifiers`, or a saved character of
/// MPFB.
///
/// # Errors
/// A file that cannot be read, a line or member that is no setting.
pub fn read_settings(path: &Path) -> Result<Vec<SliderSetting>, Error> {
    if path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("mhm"))
    {
        return model_lines(&read_text(path)?).map_err(|reason| Error::file(shown(path), reason));
    }
    let document = read_document(path)?;
    if document.root.get("phenotype").is_some() {
        return character(&document.root).map_err(|reason| Error::file(shown(path), reason));
    }
    let settings = document.root.get("modifiers").unwrap_or(&document.root);
    modifiers(settings).map_err(|reason| Error::file(shown(path), reason))
}

/// Macro settings, races and targets of a saved character of MPFB. What it leaves out stands at its
/// default.
fn character(root: &Node) -> Result<Vec<SliderSetting>, String> {
    let phenotype = root
        .get("phenotype")
        .map(Node::effective_members)
        .unwrap_or_default();
    let number = |name: &str, node: Option<&Node>| {
        let value = node
            .and_then(Node::as_f64)
            .ok_or_else(|| format!("the value of `{name}` is not a number"))?;
        Ok((name.to_owned(), value))
    };
    let race = phenotype
        .iter()
        .filter(|member| &*member.key == "race")
        .flat_map(|member| member.node.effective_members());
    let settings = phenotype
        .iter()
        .filter(|member| &*member.key != "race")
        .copied()
        .chain(race);
    let targets = root
        .get("targets")
        .map(Node::elements)
        .unwrap_or_default()
        .iter()
        .map(|entry| {
            let name = entry
                .get("target")
                .and_then(Node::as_str)
                .ok_or("an entry of `targets` has no `target`")?;
            number(name, entry.get("value"))
        });
    settings
        .map(|member| number(&member.key, Some(&member.node)))
        .chain(targets)
        .collect()
}

/// Pairs of name and number from a JSON value.
pub(super) fn modifiers(node: &Node) -> Result<Vec<SliderSetting>, String> {
    let number = |name: &str, node: &Node| {
        node.as_f64()
            .map(|value| (name.to_owned(), value))
            .ok_or_else(|| format!("the value of `{name}` is not a number"))
    };
    if node.is_object() {
        return node
            .effective_members()
            .into_iter()
            .map(|member| number(&member.key, &member.node))
            .collect();
    }
    if !node.is_array() {
        return Err("expected settings as a list of [name, number] or an object".to_owned());
    }
    let pair = |(at, node): (usize, &Node)| match node.elements() {
        [name, value] => number(
            name.as_str()
                .ok_or_else(|| format!("setting {at} has no name"))?,
            value,
        ),
        _ => Err(format!("setting {at} is not a pair [name, number]")),
    };
    node.elements().iter().enumerate().map(pair).collect()
}

fn model_lines(text: &[u8]) -> Result<Vec<SliderSetting>, String> {
    let text = String::from_utf8_lossy(text);
    let mut settings = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["modifier", name, value] => {
                let value = python_float(value.as_bytes());
                let value =
                    value.ok_or_else(|| format!("line {number}: the value is not a number"))?;
                settings.push(((*name).to_owned(), value));
            }
            ["modifier", ..] => {
                return Err(format!(
                    "line {number}: expected `modifier`, a name and a value"
                ));
            }
            _ => {}
        }
    }
    Ok(settings)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_is_a_name_and_a_number() {
        assert_eq!(
            parse_setting("a/b-decr|incr=-0.5"),
            Ok(("a/b-decr|incr".to_owned(), -0.5))
        );
        assert!(parse_setting("a/b").is_err());
        assert!(parse_setting("a=much").is_err());
    }

    #[test]
    fn parts_of_a_name_are_enough_to_find_it() {
        let known = [
            "macrodetails/Gender",
            "macrodetails/Age",
            "eyes/l-eye-bag-decr|incr",
            "eyes/r-eye-bag-decr|incr",
        ];
        assert_eq!(same_in_short("gendr", &known), Some("macrodetails/Gender"));
        assert_eq!(
            same_in_short("eyes/l-eye-bag-incr", &known),
            Some("eyes/l-eye-bag-decr|incr")
        );
        assert_eq!(same_in_short("nose", &known), None);
    }

    #[test]
    fn a_saved_character_has_macros_and_targets() {
        let of = |text: &str| character(&mhlint_json::parse(text.as_bytes()).unwrap().root);
        let text = r#"{"phenotype": {"age": 0.2, "race": {"asian": 1}}, "targets": [{"target": "nose-up", "value": 0.5}]}"#;
        let expected = [("age", 0.2), ("asian", 1.0), ("nose-up", 0.5)];
        assert_eq!(
            of(text),
            Ok(expected
                .map(|(name, value)| (name.to_owned(), value))
                .to_vec())
        );
        assert!(of(r#"{"phenotype": {"age": "old"}}"#).is_err());
        assert!(of(r#"{"phenotype": {}, "targets": [{"value": 1}]}"#).is_err());
    }

    #[test]
    fn model_lines_are_taken_in_order() {
        let text = b"version v2.0.0\nmodifier a 0.5\n# modifier b 1\nmodifier a 5\n";
        assert_eq!(
            model_lines(text),
            Ok(vec![("a".to_owned(), 0.5), ("a".to_owned(), 5.0)])
        );
        assert!(model_lines(b"modifier a b 1").is_err());
    }
}
