//! Elements of cga3 in the dense reference algebra, with all 32 coefficients.

use ga_runtime::Element;
use ga_runtime::cga3::Multivector;
use ga_runtime::dense::{self, Algebra, DenseError};

/// The dense form of each element.
///
/// # Errors
/// None for a declared algebra.
pub fn all<T: Element<Scalar = f64>>(
    elements: &[T],
) -> Result<Vec<dense::Multivector<f64>>, DenseError> {
    let metric = <Multivector<f64> as Element>::METRIC;
    let row = |row: &&[(i64, i64)]| row.iter().map(|&(n, d)| n as f64 / d as f64).collect();
    let algebra = Algebra::new(metric.iter().map(row).collect())?;
    let size = algebra.size();
    let coefficients =
        |element: &T| -> Vec<f64> { (0..size).map(|blade| element.coefficient(blade)).collect() };
    elements
        .iter()
        .map(|element| algebra.multivector(coefficients(element)))
        .collect()
}
