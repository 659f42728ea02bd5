//! The fast path of the target parser: the plain row, and numbers short enough to be exact in f64.
//!
//! Gets bytes at the beginning of a line, returns the row and the bytes consumed, or nothing for
//! any line that is written otherwise; then the slow path decides. Both must agree on every row.

use crate::stored;
use crate::target::Row;

/// The plain row `INDEX X Y Z`, single blanks, at most nine digits a number: nearly every line of
/// every shipped target. Gives the row and the bytes consumed, or nothing for any other line.
pub(super) fn fast_row(text: &[u8]) -> (Option<Row>, usize) {
    let mut at = 0;
    let mut index = 0_u32;
    while let Some(digit) = text
        .get(at)
        .map(|byte| byte.wrapping_sub(b'0'))
        .filter(|digit| *digit < 10)
    {
        index = index.wrapping_mul(10).wrapping_add(u32::from(digit));
        at += 1;
    }
    if at == 0 || at > 9 {
        return (None, 0);
    }
    let mut delta = [0.0; 3];
    for part in &mut delta {
        if text.get(at) != Some(&b' ') {
            return (None, 0);
        }
        let Some((value, length)) = fast_decimal(text.get(at + 1..).unwrap_or_default()) else {
            return (None, 0);
        };
        *part = value;
        at += 1 + length;
    }
    match (text.get(at), text.get(at + 1)) {
        (None, _) => (Some((index, delta)), at),
        (Some(b'\r'), Some(b'\n')) => (Some((index, delta)), at + 2),
        (Some(b'\n' | b'\r'), _) => (Some((index, delta)), at + 1),
        _ => (None, 0),
    }
}

const POWERS: [f64; 10] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

/// A decimal of at most nine digits. Mantissa and power of ten are exact in f64, so the quotient is
/// the correctly rounded value, as in Python.
fn fast_decimal(text: &[u8]) -> Option<(f32, usize)> {
    let negative = text.first() == Some(&b'-');
    let mut at = usize::from(negative);
    let mut mantissa = 0_u32;
    let mut digits = 0_usize;
    let mut point = None;
    loop {
        match text.get(at) {
            Some(byte @ b'0'..=b'9') => {
                mantissa = mantissa
                    .wrapping_mul(10)
                    .wrapping_add(u32::from(byte - b'0'));
                digits += 1;
            }
            Some(b'.') if point.is_none() => point = Some(digits),
            _ => break,
        }
        at += 1;
    }
    if digits == 0 || digits > 9 {
        return None;
    }
    let value = f64::from(mantissa) / POWERS.get(digits - point.unwrap_or(digits))?;
    Some((stored(if negative { -value } else { value }), at))
}
