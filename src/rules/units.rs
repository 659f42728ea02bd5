//! Numbers with their units, in words.

/// Centimetres of a unit of length: the applications count in decimetres.
const CM_PER_UNIT: f64 = 10.0;

/// A length in centimetres.
pub(super) fn centimetres(units: impl Into<f64>) -> f64 {
    units.into() * CM_PER_UNIT
}

/// A length in centimetres, behind it the number of the file: `1.3 cm (0.130)`.
pub(super) fn length(units: impl Into<f64>) -> String {
    let units = units.into();
    let cm = centimetres(units);
    if cm.abs() < 0.1 { format!("{cm:.3} cm ({units:.4})") } else { format!("{cm:.1} cm ({units:.3})") }
}
