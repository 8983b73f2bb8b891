//! Numbers as text that comes back exactly.

/// A number with a point, as OpenCV writes elements of matrices: `0.` or 17 digits with an exponent
/// of two digits or more.
pub(super) fn exact(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e15 {
        // Not −0.
        return format!("{}.", value + 0.0);
    }
    let text = format!("{value:.16e}");
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    let (sign, digits) = match exponent.strip_prefix('-') {
        Some(digits) => ('-', digits),
        None => ('+', exponent),
    };
    format!("{mantissa}e{sign}{digits:0>2}")
}

/// A number with a point and as few digits as come back exactly, which every reader of YAML, TOML
/// and JSON takes for one: `0.0`, `1.0e-07`.
pub(in crate::format) fn plain(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    let point = if mantissa.contains('.') { "" } else { ".0" };
    let (sign, digits) = match exponent.strip_prefix('-') {
        Some(digits) => ('-', digits),
        None => ('+', exponent),
    };
    format!("{mantissa}{point}e{sign}{digits:0>2}")
}

/// Such numbers behind each other.
pub(in crate::format) fn list(values: &[f64], separator: &str) -> String {
    let values: Vec<String> = values.iter().map(|value| plain(*value)).collect();
    values.join(separator)
}
