//! Numbers as Python's `int()` and `float()` read them, which is what all loaders use.
//!
//! Beyond plain decimals: underscores between digits, a leading `+`, `nan`, `inf`, digits of other
//! scripts. A decimal comma and hexadecimal are rejected.

/// Zeros of the digit blocks that people really type numbers in.
const OTHER_ZEROS: [char; 8] = [
    '\u{660}', '\u{6f0}', '\u{966}', '\u{9e6}', '\u{e50}', '\u{ff10}', '\u{17e0}', '\u{1040}',
];

/// A number as the applications store it: float32.
#[expect(
    clippy::cast_possible_truncation,
    reason = "stored as float32, as the application does"
)]
#[inline]
pub(super) fn stored(number: f64) -> f32 {
    number as f32
}

/// Python's `int(token)`. Beyond 64 bits the value saturates.
pub fn python_int(token: &[u8]) -> Option<i64> {
    let text = plain_digits(token)?;
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, text.strip_prefix('+').unwrap_or(&text)),
    };
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    Some(
        digits
            .parse::<i64>()
            .unwrap_or(i64::MAX)
            .saturating_mul(sign),
    )
}

/// Python's `float(token)`: also `nan`, `inf` and `infinity`; overflow gives infinity.
pub fn python_float(token: &[u8]) -> Option<f64> {
    let text = plain_digits(token)?;
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(&text);
    if unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return fast_float2::parse::<f64, _>(text.strip_prefix('+').unwrap_or(&text)).ok();
    }
    match unsigned.to_ascii_lowercase().as_str() {
        "nan" => Some(f64::NAN),
        "inf" | "infinity" => Some(if text.starts_with('-') {
            f64::NEG_INFINITY
        } else {
            f64::INFINITY
        }),
        _ => None,
    }
}

/// The token with underscores between digits removed and foreign digits made plain.
fn plain_digits(token: &[u8]) -> Option<String> {
    let text = std::str::from_utf8(token).ok()?;
    let plain: Vec<char> = text.chars().map(plain_digit).collect();
    let mut out = String::with_capacity(plain.len());
    for (at, character) in plain.iter().enumerate() {
        if *character != '_' {
            out.push(*character);
            continue;
        }
        let digit = |index: Option<usize>| {
            index
                .and_then(|index| plain.get(index))
                .is_some_and(char::is_ascii_digit)
        };
        if !digit(at.checked_sub(1)) || !digit(Some(at + 1)) {
            return None;
        }
    }
    Some(out)
}

fn plain_digit(character: char) -> char {
    if character.is_ascii() {
        return character;
    }
    let code = u32::from(character);
    OTHER_ZEROS
        .iter()
        .map(|zero| code.wrapping_sub(u32::from(*zero)))
        .find(|value| *value < 10)
        .and_then(|value| char::from_digit(value, 10))
        .unwrap_or(character)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn integers_as_python_reads_them() {
        for (token, value) in [
            ("12", Some(12)),
            ("-3", Some(-3)),
            ("+5", Some(5)),
            ("1_0", Some(10)),
            ("007", Some(7)),
            ("٣", Some(3)),
            ("99999999999999999999", Some(i64::MAX)),
            ("1.0", None),
            ("_1", None),
            ("1__0", None),
            ("0x10", None),
            ("", None),
            ("-", None),
            ("\u{feff}1", None),
        ] {
            assert_eq!(python_int(token.as_bytes()), value, "{token}");
        }
    }

    #[test]
    fn floats_as_python_reads_them() {
        for (token, value) in [
            (".119", Some(0.119)),
            ("-.775", Some(-0.775)),
            ("+2", Some(2.0)),
            ("1_0.5", Some(10.5)),
            ("1e400", Some(f64::INFINITY)),
            ("-Infinity", Some(f64::NEG_INFINITY)),
            ("5.", Some(5.0)),
            ("1,5", None),
            ("0x1", None),
            (".", None),
            ("e5", None),
            ("nano", None),
        ] {
            assert_eq!(python_float(token.as_bytes()), value, "{token}");
        }
        assert!(python_float(b"NaN").unwrap().is_nan());
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(token in proptest::collection::vec(any::<u8>(), 0..20)) {
            if python_int(&token).is_some() {
                prop_assert!(python_float(&token).is_some());
            }
        }

        #[test]
        fn written_numbers_come_back(value in any::<f64>(), integer in any::<i32>()) {
            prop_assert_eq!(python_float(format!("{value:e}").as_bytes()).map(f64::to_bits), Some(value.to_bits()).filter(|_| !value.is_nan()).or(Some(f64::NAN.to_bits())));
            prop_assert_eq!(python_int(integer.to_string().as_bytes()), Some(i64::from(integer)));
        }
    }
}
