//! Outputs against outputs: the largest deviation of every quantity.
//!
//! Lists of names come in no particular order and are compared by name.

use serde_json::{Value, json};

use super::inputs;
use super::roots::use_of;
use super::tolerance::{AT_THRESHOLD, Tolerance};
use super::{CaseReport, Kind};
use mhlint_discover::Kind::Weights;
use mhlint_json::Node;

/// A case against what the file says.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Base and name.
    pub name: String,
    /// The largest deviation of each quantity, in the order of the file.
    pub deviations: Vec<Deviation>,
    /// What differs in other ways than by a number.
    pub differences: Vec<String>,
    /// Why the case could not be computed.
    pub failure: Option<String>,
}

/// The largest deviation of a quantity.
#[derive(Debug, Clone)]
pub struct Deviation {
    /// Name of the field.
    pub quantity: String,
    /// The largest deviation; infinite where only one number is finite.
    pub worst: f64,
    /// What is allowed.
    pub limit: f64,
    /// Where it is.
    pub at: String,
}

impl Comparison {
    /// Whether everything agrees within the tolerances.
    pub fn agrees(&self) -> bool {
        self.failure.is_none()
            && self.differences.is_empty()
            && self.deviations.iter().all(Deviation::is_allowed)
    }
}

impl Deviation {
    /// Whether it is within its tolerance.
    pub fn is_allowed(&self) -> bool {
        self.worst <= self.limit
    }
}

pub(super) fn compare(kind: &Kind, case: &Node, report: &CaseReport) -> Comparison {
    let comparison = Comparison {
        name: report.name.clone(),
        deviations: Vec::new(),
        differences: Vec::new(),
        failure: report.outputs.as_ref().err().map(ToString::to_string),
    };
    let scale = inputs::field(case, "scale_factor")
        .and_then(Node::as_f64)
        .unwrap_or(1.0);
    let mut comparer = Comparer {
        kind,
        of_asset: is_of_asset(kind, case),
        scale,
        comparison,
    };
    let is_list = case.is_array();
    if let Ok(found) = &report.outputs {
        match expected(case) {
            Some(Value::Object(expected)) if !expected.is_empty() => {
                for (key, expected) in &expected {
                    match found.get(key).map(|found| {
                        if is_list {
                            in_order(found)
                        } else {
                            found.clone()
                        }
                    }) {
                        Some(found) => comparer.field(key, expected, &found),
                        None => comparer.differ(format!("`{key}` is expected, but not computed")),
                    }
                }
                if let Some(Value::String(error)) = found
                    .get("error")
                    .filter(|_| !expected.contains_key("error"))
                {
                    comparer.differ(format!(
                        "`{error}` instead of outputs: {}",
                        report.notes.join("; ")
                    ));
                }
            }
            _ => comparer.differ("the case has no outputs to compare with".to_owned()),
        }
    }
    comparer.comparison
}

/// The outputs of a case. One that is a list has its input first, then the key of a group and the
/// values behind it.
fn expected(case: &Node) -> Option<Value> {
    let plain = |node: &Node| node.plain(&Value::Null);
    match case.elements() {
        [_, key, values] => Some(json!({ "key": in_order(&plain(key)), "values": plain(values) })),
        _ => case.get("outputs").map(plain),
    }
}

/// Words whose order counts, as one.
fn in_order(words: &Value) -> Value {
    let all = words
        .as_array()
        .map(|words| words.iter().filter_map(Value::as_str).collect::<Vec<_>>());
    all.map_or_else(|| words.clone(), |all| Value::from(all.join("-")))
}

/// Weights for the mesh of an asset may have an entry more or less at the threshold.
fn is_of_asset(kind: &Kind, case: &Node) -> bool {
    let file = case
        .get("inputs")
        .and_then(|inputs| inputs.get("file"))
        .and_then(Node::as_str);
    file.is_some_and(|file| {
        use_of(file, kind.application).is_none_or(|use_of| use_of.kind != Weights)
    })
}

struct Comparer<'a> {
    kind: &'a Kind,
    of_asset: bool,
    /// Units of the mesh that one of its file comes to.
    scale: f64,
    comparison: Comparison,
}

impl Comparer<'_> {
    fn differ(&mut self, what: String) {
        self.comparison.differences.push(what);
    }

    fn field(&mut self, key: &str, expected: &Value, found: &Value) {
        if self.kind.by_bone && key == "bones" {
            return self.bones(expected, found);
        }
        self.value(key, key, &by_name(expected), &by_name(found));
    }

    /// `quantity` is the innermost name that says what a number is, `at` where it is.
    fn value(&mut self, quantity: &str, at: &str, expected: &Value, found: &Value) {
        match (expected, found) {
            (Value::Object(expected), Value::Object(found)) => {
                for (key, expected) in expected {
                    let at = format!("{at}/{key}");
                    let Some(found) = found.get(key) else {
                        self.differ(format!("`{at}` is expected, but not computed"));
                        continue;
                    };
                    self.member(quantity, &at, expected, found);
                }
                for key in found.keys().filter(|key| !expected.contains_key(*key)) {
                    self.differ(format!("`{at}/{key}` is computed, but not expected"));
                }
            }
            (Value::Array(expected), Value::Array(found)) if expected.len() == found.len() => {
                for (place, (expected, found)) in expected.iter().zip(found).enumerate() {
                    self.value(quantity, &format!("{at}/{place}"), expected, found);
                }
            }
            (Value::Array(expected), Value::Array(found)) => {
                self.differ(format!(
                    "`{at}` has {} elements, {} expected",
                    found.len(),
                    expected.len()
                ));
            }
            (Value::Number(_) | Value::Null, Value::Number(_) | Value::Null) => {
                let tolerance = self.kind.tolerance(quantity, self.scale);
                self.number(quantity, at, tolerance, expected.as_f64(), found.as_f64());
            }
            (expected, found) if expected == found => {}
            (expected, found) => self.differ(format!(
                "`{at}` is {}, {} expected",
                short(found),
                short(expected)
            )),
        }
    }

    /// A member of an object; the fields of a bone are quantities of their own.
    fn member(&mut self, quantity: &str, at: &str, expected: &Value, found: &Value) {
        let (Value::Object(fields), Value::Object(here)) = (expected, found) else {
            return self.value(quantity, at, expected, found);
        };
        for (key, expected) in fields {
            match here.get(key) {
                Some(found) => self.value(key, &format!("{at}/{key}"), expected, found),
                None => self.differ(format!("`{at}/{key}` is missing here")),
            }
        }
    }

    fn number(
        &mut self,
        quantity: &str,
        at: &str,
        tolerance: Tolerance,
        expected: Option<f64>,
        found: Option<f64>,
    ) {
        let worst = tolerance.deviation(expected, found);
        let deviations = &mut self.comparison.deviations;
        let limit = tolerance.limit();
        let new = Deviation {
            quantity: quantity.to_owned(),
            worst,
            limit,
            at: at.to_owned(),
        };
        match deviations
            .iter_mut()
            .find(|known| known.quantity == quantity)
        {
            // A NaN never gets here: it is no number in JSON.
            Some(known) if worst > known.worst => *known = new,
            Some(_) => {}
            None => deviations.push(new),
        }
    }

    /// Bones with number of entries and sum of weights.
    fn bones(&mut self, expected: &Value, found: &Value) {
        let (Value::Object(expected), Value::Object(found)) = (expected, found) else {
            return self.differ("`bones` is not an object".to_owned());
        };
        for (bone, expected) in expected {
            let at = format!("bones/{bone}");
            let pair = |value: &Value| Some((value.get(0)?.as_i64()?, value.get(1)?.as_f64()));
            let (Some((count, sum)), Some((count_here, sum_here))) =
                (pair(expected), found.get(bone).and_then(pair))
            else {
                self.differ(format!("`{at}` is expected, but not computed"));
                continue;
            };
            if self.of_asset && count.abs_diff(count_here) == 1 {
                self.number(
                    "bone sum at the threshold",
                    &at,
                    AT_THRESHOLD,
                    sum,
                    sum_here,
                );
                continue;
            }
            if count != count_here {
                self.differ(format!("`{at}` has {count_here} entries, {count} expected"));
            }
            self.number(
                "bone sum",
                &at,
                self.kind.tolerance("bone sum", self.scale),
                sum,
                sum_here,
            );
        }
        for bone in found.keys().filter(|bone| !expected.contains_key(*bone)) {
            self.differ(format!("`bones/{bone}` is computed, but not expected"));
        }
    }
}

/// Lists of names, and of pairs that begin with a name, sorted; all others as they are.
fn by_name(value: &Value) -> Value {
    let Value::Array(elements) = value else {
        return value.clone();
    };
    let mut elements: Vec<Value> = elements.iter().map(by_name).collect();
    let key = |value: &Value| -> Option<(String, f64)> {
        match value {
            Value::String(name) => Some((name.clone(), 0.0)),
            Value::Array(pair) => match pair.as_slice() {
                [Value::String(name), rest] => Some((name.clone(), rest.as_f64().unwrap_or(0.0))),
                _ => None,
            },
            _ => None,
        }
    };
    if elements.iter().all(|element| key(element).is_some()) {
        elements.sort_by(|a, b| {
            let (a, b) = (key(a).unwrap_or_default(), key(b).unwrap_or_default());
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
    }
    Value::Array(elements)
}

fn short(value: &Value) -> String {
    value.to_string().chars().take(60).collect()
}
