//! Numbers with their units, in words.

/// Centimetres of a unit of length: the applications count in decimetres.
const CM_PER_UNIT: f64 = 10.0;

/// A length in centimetres.
pub(super) fn centimetres(units: impl Into<f64>) -> f64 {
    units.into() * CM_PER_UNIT
}

/// `2.5 cm`, of a length in metres.
pub(super) fn centimetres_of_metres(metres: f64) -> String {
    let cm = metres * 100.0;
    if cm.abs() < 0.1 {
        format!("{cm:.3} cm")
    } else {
        format!("{cm:.1} cm")
    }
}

/// A number as short as it can be read: `1.25`, `3e38`.
pub(super) fn short(number: f64) -> String {
    let size = number.abs();
    if !size.is_finite() || size == 0.0 || (1e-6..1e7).contains(&size) {
        // What a 32-bit float holds, without the digits that 64 bits add to it.
        #[expect(clippy::cast_possible_truncation, reason = "for people")]
        return (number as f32).to_string();
    }
    let text = format!("{number:.2e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    format!(
        "{}e{power}",
        digits.trim_end_matches('0').trim_end_matches('.')
    )
}

/// `900 bytes`, `16.3 kB`, `16.8 MB`.
pub(super) fn bytes(count: u64) -> String {
    let amount = count as f64;
    match count {
        0..=9_999 => super::counted(count, "byte"),
        10_000..=999_999 => format!("{:.1} kB", amount / 1e3),
        1_000_000..=999_999_999 => format!("{:.1} MB", amount / 1e6),
        _ => format!("{:.1} GB", amount / 1e9),
    }
}

/// A length in centimetres, behind it the number of the file: `1.3 cm (0.130)`.
pub(super) fn length(units: impl Into<f64>) -> String {
    let units = units.into();
    let cm = centimetres(units);
    if cm.abs() >= 1e7 {
        return format!("{} cm ({})", short(cm), short(units));
    }
    if cm.abs() < 0.1 {
        format!("{cm:.3} cm ({units:.4})")
    } else {
        format!("{cm:.1} cm ({units:.3})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_short_as_they_can_be_read() {
        let shown = [
            1.25,
            f64::from(1.001_f32),
            100.0,
            3e38,
            -2.5e-9,
            0.0,
            f64::INFINITY,
        ]
        .map(short);
        assert_eq!(
            shown,
            ["1.25", "1.001", "100", "3e38", "-2.5e-9", "0", "inf"]
        );
    }

    #[test]
    fn sizes_have_a_unit() {
        let shown = [1, 900, 16_329, 16_777_217, 5_000_000_000].map(bytes);
        assert_eq!(
            shown,
            ["1 byte", "900 bytes", "16.3 kB", "16.8 MB", "5.0 GB"]
        );
    }
}
