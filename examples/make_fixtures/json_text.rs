//! JSON as text in two layouts: as a person would write it, and as `MakeHuman` 2 writes its
//! generated files.

use std::fmt::Write;

use serde_json::Value;

/// Longest line; what fits is kept on one line.
const WIDTH: usize = 120;

/// Objects and lists are spread over lines only when they do not fit into one; lists of plain
/// values and of pairs are filled like a paragraph.
pub(crate) fn by_hand(value: &Value) -> String {
    let mut text = String::new();
    write_value(&mut text, value, 0, true);
    text.push('\n');
    text
}

/// Python's `json.dump(…, indent=4, sort_keys=True)`, which writes no final line end
/// (`docs/loaders/makehuman2/text-and-json.md#json`).
pub(crate) fn by_program(value: &Value) -> String {
    let text = serde_json::to_string_pretty(&sorted(value))
        .expect("invariant: a value in memory can be written");
    let lines: Vec<_> = text.lines().map(double_indent).collect();
    lines.join("\n")
}

/// `serde_json` indents by two blanks, Python was told four.
fn double_indent(line: &str) -> String {
    let blanks = line.len() - line.trim_start().len();
    " ".repeat(blanks) + line
}

fn sorted(value: &Value) -> Value {
    match value {
        Value::Object(map) => {
            let mut entries: Vec<_> = map
                .iter()
                .map(|(key, value)| (key.clone(), sorted(value)))
                .collect();
            entries.sort_by(|a, b| a.0.cmp(&b.0));
            Value::Object(entries.into_iter().collect())
        }
        Value::Array(items) => items.iter().map(sorted).collect(),
        other => other.clone(),
    }
}

fn write_value(text: &mut String, value: &Value, depth: usize, spread: bool) {
    let line = one_line(value);
    let column = text.len() - text.rfind('\n').map_or(0, |at| at + 1);
    if !spread && column + line.len() < WIDTH {
        text.push_str(&line);
        return;
    }
    match value {
        Value::Object(map) => {
            let last = map.len().saturating_sub(1);
            text.push_str("{\n");
            for (at, (key, item)) in map.iter().enumerate() {
                indent(text, depth + 1);
                let _ = write!(text, "{}: ", Value::from(key.as_str()));
                write_value(text, item, depth + 1, false);
                text.push_str(if at == last { "\n" } else { ",\n" });
            }
            indent(text, depth);
            text.push('}');
        }
        Value::Array(items) if items.iter().any(Value::is_object) => write_list(text, items, depth),
        Value::Array(items) => write_filled(text, items, depth),
        _ => text.push_str(&line),
    }
}

fn write_list(text: &mut String, items: &[Value], depth: usize) {
    text.push_str("[\n");
    for (at, item) in items.iter().enumerate() {
        indent(text, depth + 1);
        write_value(text, item, depth + 1, false);
        text.push_str(if at + 1 == items.len() { "\n" } else { ",\n" });
    }
    indent(text, depth);
    text.push(']');
}

fn write_filled(text: &mut String, items: &[Value], depth: usize) {
    text.push_str("[\n");
    let mut line = String::new();
    for (at, item) in items.iter().enumerate() {
        let word = one_line(item) + if at + 1 == items.len() { "" } else { "," };
        if !line.is_empty() && depth * 4 + line.len() + word.len() + 6 > WIDTH {
            end_line(text, &mut line, depth);
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(&word);
    }
    end_line(text, &mut line, depth);
    indent(text, depth);
    text.push(']');
}

fn end_line(text: &mut String, line: &mut String, depth: usize) {
    indent(text, depth + 1);
    text.push_str(line);
    text.push('\n');
    line.clear();
}

fn one_line(value: &Value) -> String {
    match value {
        Value::Object(map) if map.is_empty() => "{}".to_owned(),
        Value::Object(map) => {
            let entries: Vec<_> = map
                .iter()
                .map(|(key, item)| format!("{}: {}", Value::from(key.as_str()), one_line(item)))
                .collect();
            format!("{{ {} }}", entries.join(", "))
        }
        Value::Array(items) => format!(
            "[{}]",
            items.iter().map(one_line).collect::<Vec<_>>().join(", ")
        ),
        other => other.to_string(),
    }
}

fn indent(text: &mut String, depth: usize) {
    text.push_str(&"    ".repeat(depth));
}
