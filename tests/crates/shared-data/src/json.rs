//! Numbers in JSON, as the truths of tests have them.

use serde_json::Value;

/// A list of N numbers.
///
/// # Panics
///
/// Where it is not such a list.
#[must_use]
pub fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|k| value[k].as_f64().expect("a number"))
}

/// A list of lists of N numbers.
///
/// # Panics
///
/// Where it is not such a list.
#[must_use]
pub fn rows<const N: usize>(value: &Value) -> Vec<[f64; N]> {
    let rows = value.as_array().expect("rows");
    rows.iter().map(numbers).collect()
}

/// A matrix with three rows of three numbers.
///
/// # Panics
///
/// Where it is not such a matrix.
#[must_use]
pub fn matrix(value: &Value) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| numbers(&value[row]))
}
