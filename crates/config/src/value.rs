//! Single values of the file: what is there, what is wanted.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeInteger, DeValue};

use mhlint_diag::{Level, nearest};

/// A value with its place.
pub(super) type Value<'i> = Spanned<DeValue<'i>>;

/// What is wrong with a value: where, what, and what to do.
pub(super) type Wrong = (Range<usize>, String, String);

/// `TEXT` of the key `name`.
pub(super) fn text<'v>(name: &str, value: &'v Value<'_>) -> Result<&'v str, Wrong> {
    value
        .get_ref()
        .as_str()
        .ok_or_else(|| wrong(name, value, "a string in quotes"))
}

/// A list of texts with their places.
pub(super) fn texts<'v>(
    name: &str,
    value: &'v Value<'_>,
) -> Result<Vec<(&'v str, Range<usize>)>, Wrong> {
    let wanted = "a list of strings";
    let Some(list) = value.get_ref().as_array() else {
        return Err(wrong(name, value, wanted));
    };
    let each = list.iter().map(|item| match item.get_ref().as_str() {
        Some(text) => Ok((text, item.span())),
        None => Err(wrong(
            &format!("an element of `{name}`"),
            item,
            "a string in quotes",
        )),
    });
    each.collect()
}

/// A whole number that is not negative.
pub(super) fn number(name: &str, value: &Value<'_>) -> Result<usize, Wrong> {
    let whole = value.get_ref().as_integer().and_then(integer);
    whole
        .and_then(|whole| usize::try_from(whole).ok())
        .ok_or_else(|| wrong(name, value, "a whole number, 0 or more"))
}

/// A whole number up to `most`.
pub(super) fn number_to(most: usize, name: &str, value: &Value<'_>) -> Result<usize, Wrong> {
    let wanted = || wrong(name, value, &format!("a whole number from 0 to {most}"));
    number(name, value)
        .ok()
        .filter(|number| *number <= most)
        .ok_or_else(wanted)
}

/// A finite number that is not negative: limits and shares all are.
pub(super) fn real(name: &str, value: &Value<'_>) -> Result<f64, Wrong> {
    let number = match value.get_ref() {
        DeValue::Integer(whole) => integer(whole).map(|whole| whole as f64),
        DeValue::Float(real) => real.as_str().replace('_', "").parse().ok(),
        _ => None,
    };
    let sound = number.filter(|number: &f64| number.is_finite() && *number >= 0.0);
    sound.ok_or_else(|| wrong(name, value, "a finite number, 0 or more"))
}

/// `true` or `false`.
pub(super) fn flag(name: &str, value: &Value<'_>) -> Result<bool, Wrong> {
    value
        .get_ref()
        .as_bool()
        .ok_or_else(|| wrong(name, value, "`true` or `false`"))
}

/// A level, `None` for the word `none_word`.
pub(super) fn level(
    name: &str,
    value: &Value<'_>,
    none_word: &str,
) -> Result<Option<Level>, Wrong> {
    match value.get_ref().as_str() {
        Some("error") => Ok(Some(Level::Error)),
        Some("warning") => Ok(Some(Level::Warning)),
        Some("info") => Ok(Some(Level::Info)),
        Some(word) if word == none_word => Ok(None),
        word => {
            let wanted = format!("one of \"error\", \"warning\", \"info\", \"{none_word}\"");
            let (span, message, help) = wrong(name, value, &wanted);
            let near = word.and_then(|word| nearest(word, ["error", "warning", "info", none_word]));
            Err((
                span,
                message,
                near.map_or(help, |near| format!("did you mean \"{near}\"?")),
            ))
        }
    }
}

/// Says what is there and what is wanted.
pub(super) fn wrong(name: &str, value: &Value<'_>, wanted: &str) -> Wrong {
    let name = if name.contains('`') {
        name.to_owned()
    } else {
        format!("`{name}`")
    };
    let help = format!("write {wanted}");
    (
        value.span(),
        format!("{name} is {}, expected {wanted}", shown(value.get_ref())),
        help,
    )
}

fn shown(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => format!(
            "the string \"{}\"",
            text.chars().take(40).collect::<String>()
        ),
        DeValue::Integer(number) => format!("the number {}", number.as_str()),
        DeValue::Float(number) => format!("the number {}", number.as_str()),
        DeValue::Boolean(flag) => format!("`{flag}`"),
        DeValue::Datetime(day) => format!("the date {day}"),
        DeValue::Array(_) => "a list".to_owned(),
        DeValue::Table(_) => "a table".to_owned(),
    }
}

/// A text as it is quoted in a message: one that goes on and on is cut.
pub(super) fn shortened(text: &str) -> String {
    const MOST: usize = 100;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

fn integer(number: &DeInteger<'_>) -> Option<i64> {
    i64::from_str_radix(&number.as_str().replace('_', ""), number.radix()).ok()
}
