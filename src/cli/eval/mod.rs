//! `mhlint eval`: numbers that the application would show, for anyone to check.

mod args;
mod base;
mod cases;
mod fit;
mod mpfb;
mod weights;
mod write;

use std::io::Write;

use serde_json::{Map, Value};

pub(super) use args::EvalCommand;

use super::exit::{Exit, Failure};
use args::{BaseArgs, SettingArgs};
use mhlint_engine::open_base;
use mhlint_evaluate::{
    Error, Evaluation, Setting, SliderSetting, object, parse_setting, read_settings,
};

/// Runs one of the commands.
pub(super) fn run(
    command: &EvalCommand,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<Exit, Failure> {
    match command {
        EvalCommand::Macros(args) => base::macros(args, out),
        EvalCommand::Modifiers(args) => base::modifiers(args, out),
        EvalCommand::Mesh(args) => base::mesh(args, out),
        EvalCommand::Skeleton(args) => base::skeleton(args, out),
        EvalCommand::Rig(args) => mpfb::rig(args, out),
        EvalCommand::Weights(args) => weights::run(args, out),
        EvalCommand::Skin(args) if args.choice.rig.is_some() => mpfb::skin(args, out),
        EvalCommand::Skin(args) => base::skin(args, out),
        EvalCommand::Fit(args) => fit::run(args, out),
        EvalCommand::Cases(args) => return cases::run(args, out, err),
    }?;
    Ok(Exit::Clean)
}

/// A base with its setting, and both as `inputs`.
struct Opened {
    evaluation: Evaluation,
    setting: Setting,
    /// The sliders that were set, in order.
    values: Vec<SliderSetting>,
    inputs: Map<String, Value>,
}

fn open(args: &BaseArgs) -> Result<Opened, Error> {
    open_root(&args.root, &args.setting)
}

fn open_root(root: &std::path::Path, args: &SettingArgs) -> Result<Opened, Error> {
    let evaluation = open_base(root, args.system.as_deref(), args.base.as_deref())?;
    let mut values = args
        .settings
        .as_deref()
        .map(read_settings)
        .transpose()?
        .unwrap_or_default();
    for text in &args.set {
        values.push(parse_setting(text)?);
    }
    let setting = evaluation.setting(&values)?;
    let modifiers: Vec<Value> = values
        .iter()
        .map(|(name, value)| serde_json::json!([name, value]))
        .collect();
    let inputs = object([
        ("base", Value::from(evaluation.base())),
        ("modifiers", Value::from(modifiers)),
    ]);
    Ok(Opened {
        evaluation,
        setting,
        values,
        inputs,
    })
}

/// `mhlint-eval/1`: kind, inputs and outputs.
fn document(kind: &str, inputs: Map<String, Value>, outputs: Map<String, Value>) -> Vec<u8> {
    let whole = object([
        ("format", Value::from("mhlint-eval/1")),
        ("kind", Value::from(kind)),
        ("inputs", Value::Object(inputs)),
        ("outputs", Value::Object(outputs)),
    ]);
    let mut text = String::new();
    lay_out(&Value::Object(whole), 1, &mut text);
    text.push('\n');
    text.into_bytes()
}

/// Levels of objects that get a line for each member; below, everything stands in one line.
const OPEN_LEVELS: usize = 3;

/// JSON that people can read, too: vectors and matrices stay in one line.
fn lay_out(value: &Value, level: usize, out: &mut String) {
    let indent = "  ".repeat(level);
    let close = "  ".repeat(level - 1);
    match value {
        Value::Object(members) if level <= OPEN_LEVELS && !members.is_empty() => {
            for (place, (key, member)) in members.iter().enumerate() {
                let before = if place == 0 { "{" } else { "," };
                out.extend([
                    before,
                    "\n",
                    &indent,
                    &Value::from(key.as_str()).to_string(),
                    ": ",
                ]);
                lay_out(member, level + 1, out);
            }
            out.extend(["\n", &close, "}"]);
        }
        Value::Array(elements)
            if level <= OPEN_LEVELS && elements.iter().any(|e| e.is_array() || e.is_object()) =>
        {
            for (place, element) in elements.iter().enumerate() {
                let before = if place == 0 { "[" } else { "," };
                out.extend([before, "\n", &indent, &element.to_string()]);
            }
            out.extend(["\n", &close, "]"]);
        }
        other => out.push_str(&other.to_string()),
    }
}
