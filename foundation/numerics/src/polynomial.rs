//! Real roots of polynomials in one unknown, for minimal problems.

/// Leading coefficients below this part of the largest count as zero: their roots are far beyond
/// those of interest.
const NEGLIGIBLE: f64 = 1e-14;
/// A minimum or maximum whose value is below this part of the sum of the terms counts as a root.
const DOUBLE_ROOT: f64 = 1e-10;

/// The real roots of `Σ cₖ xᵏ`, rising. A double root may be there once or twice; none for a
/// constant, or where a coefficient is not finite.
///
/// Between neighbouring extrema, which are the roots of the derivative, there is at most one root.
/// So the derivatives are solved from the linear one up, each root by Newton steps within its
/// bracket.
///
/// ```
/// use ga_numerics::polynomial::real_roots;
/// // x³ − x = x (x − 1) (x + 1)
/// let roots = real_roots(&[0.0, -1.0, 0.0, 1.0]);
/// assert_eq!(roots.len(), 3);
/// for (root, truth) in roots.iter().zip([-1.0, 0.0, 1.0]) {
///     assert!((root - truth).abs() < 1e-15);
/// }
/// ```
#[must_use]
pub fn real_roots(coefficients: &[f64]) -> Vec<f64> {
    let largest = coefficients
        .iter()
        .fold(0.0, |most: f64, c| most.max(c.abs()));
    if !coefficients.iter().all(|c| c.is_finite()) || largest == 0.0 {
        return Vec::new();
    }
    let is_large = |c: &f64| c.abs() > NEGLIGIBLE * largest;
    let degree = coefficients.iter().rposition(is_large).unwrap_or(0);
    let mut derivatives = vec![coefficients[..=degree].to_vec()];
    for _ in 1..degree {
        let last = &derivatives[derivatives.len() - 1];
        let next = last.iter().enumerate().skip(1);
        let next = next.map(|(k, c)| k as f64 * c).collect();
        derivatives.push(next);
    }
    if degree == 0 {
        return Vec::new();
    }
    let mut roots = Vec::new();
    for polynomial in derivatives.iter().rev() {
        roots = roots_between(polynomial, &roots);
    }
    roots
}

/// The roots of a polynomial by its extrema.
fn roots_between(polynomial: &[f64], extrema: &[f64]) -> Vec<f64> {
    let leading = polynomial[polynomial.len() - 1];
    let largest = polynomial
        .iter()
        .fold(0.0, |most: f64, c| most.max((c / leading).abs()));
    // Cauchy's bound of the roots.
    let bound = 1.0 + largest;
    let mut ends = vec![-bound];
    ends.extend(extrema.iter().copied().filter(|x| x.abs() < bound));
    ends.push(bound);
    let mut roots = Vec::new();
    for pair in ends.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        let (at_low, at_high) = (evaluate(polynomial, low).0, evaluate(polynomial, high).0);
        if at_low * at_high < 0.0 || at_high == 0.0 {
            roots.push(root_within(polynomial, low, high));
        } else if high < bound && touches(polynomial, high) {
            roots.push(high);
        }
    }
    roots
}

/// Whether a polynomial is zero at an extremum up to rounding.
fn touches(polynomial: &[f64], x: f64) -> bool {
    let terms = polynomial
        .iter()
        .rev()
        .fold(0.0, |sum, c| sum * x.abs() + c.abs());
    evaluate(polynomial, x).0.abs() <= DOUBLE_ROOT * terms
}

/// A polynomial and its derivative at a place.
fn evaluate(polynomial: &[f64], x: f64) -> (f64, f64) {
    let step = |(value, slope): (f64, f64), c: &f64| (value * x + c, slope * x + value);
    polynomial.iter().rev().fold((0.0, 0.0), step)
}

/// The root in a bracket with a change of sign, by Newton's method where it stays in the bracket,
/// and by bisection elsewhere.
fn root_within(polynomial: &[f64], mut low: f64, mut high: f64) -> f64 {
    const STEPS: usize = 200;
    let rises = evaluate(polynomial, high).0 > 0.0 || evaluate(polynomial, low).0 < 0.0;
    let mut x = 0.5 * (low + high);
    for _ in 0..STEPS {
        let (value, slope) = evaluate(polynomial, x);
        if value == 0.0 {
            return x;
        }
        if (value > 0.0) == rises {
            high = x;
        } else {
            low = x;
        }
        let newton = x - value / slope;
        let next = match newton > low && newton < high {
            true => newton,
            false => 0.5 * (low + high),
        };
        if (next - x).abs() <= f64::EPSILON * x.abs() {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients of the polynomial with these roots.
    fn with_roots(roots: &[f64]) -> Vec<f64> {
        let mut product = vec![1.0];
        for root in roots {
            let mut next = vec![0.0; product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                next[k] -= c * root;
                next[k + 1] += c;
            }
            product = next;
        }
        product
    }

    /// About x = 1000 the terms of (x − 1000)² add up to 4 · 10⁶.
    #[test]
    fn a_minimum_that_rounding_may_lift_from_zero_is_a_root() {
        for (lifted, count) in [(0.0, 1), (2e-4, 1), (8e-4, 0)] {
            let roots = real_roots(&[1e6 + lifted, -2000.0, 1.0]);
            assert!(roots.len().min(1) == count, "{lifted}: {roots:?}");
            assert!(roots.iter().all(|root| (root - 1000.0).abs() < 1e-3));
        }
    }

    #[test]
    fn the_roots_of_a_product_of_linear_factors_are_found() {
        let roots = [-3.5, -1.0, -0.25, 0.5, 0.75, 2.0, 4.0];
        for count in 1..=roots.len() {
            let found = real_roots(&with_roots(&roots[..count]));
            assert_eq!(found.len(), count, "{found:?}");
            for (found, root) in found.iter().zip(roots) {
                assert!((found - root).abs() < 1e-9, "{found} {root}");
            }
        }
    }

    #[test]
    fn a_double_root_is_found_and_a_pair_of_complex_roots_is_not() {
        let found = real_roots(&with_roots(&[1.5, 1.5, -2.0]));
        assert!(found.iter().any(|x| (x - 1.5).abs() < 1e-6), "{found:?}");
        assert!(found.iter().any(|x| (x + 2.0).abs() < 1e-9), "{found:?}");
        assert!(real_roots(&[1.0, 0.0, 1.0]).is_empty());
        assert_eq!(real_roots(&[1.0, 0.0, 1.0, 1.0]).len(), 1);
    }

    #[test]
    fn a_constant_has_no_roots() {
        assert!(real_roots(&[]).is_empty() && real_roots(&[2.0, 0.0]).is_empty());
        assert!(real_roots(&[f64::NAN, 1.0]).is_empty());
    }
}
