//! Where an odd radial function is monotone, and its inverse there.

use ga_numerics::polynomial::real_roots;

/// How often the inverse is refined. Bisection alone needs fewer steps for the bits of a double.
const STEPS: usize = 200;

/// The least positive root of a polynomial, given its coefficients in rising order; infinity where
/// there is none.
pub(super) fn least_positive_root(coefficients: &[f64]) -> f64 {
    let roots = real_roots(coefficients);
    let positive = roots.into_iter().find(|root| *root > 0.0);
    positive.unwrap_or(f64::INFINITY)
}

/// The place x in [0, `limit`) at which a function with value 0 at 0 takes a value, where the
/// function rises throughout; `None` where it stays below. `function` gives value and slope.
///
/// Newton's method, with bisection wherever a step leaves the bracket.
pub(super) fn inverse(
    target: f64,
    limit: f64,
    function: impl Fn(f64) -> (f64, f64),
) -> Option<f64> {
    if target == 0.0 {
        return Some(0.0);
    }
    let mut low = 0.0;
    let mut high = upper_bracket(target, limit, &function)?;
    let mut x = target.min(0.5 * (low + high));
    for _ in 0..STEPS {
        let (value, slope) = function(x);
        if value == target {
            break;
        }
        if value < target {
            low = x;
        } else {
            high = x;
        }
        let step = (target - value) / slope;
        let mut next = x + step;
        if !(next > low && next < high) {
            next = 0.5 * (low + high);
        }
        if (next - x).abs() <= f64::EPSILON * x || next <= low || next >= high {
            x = next;
            break;
        }
        x = next;
    }
    (x < limit).then_some(x)
}

/// A place up to `limit` at which the function is at least `target`.
fn upper_bracket(target: f64, limit: f64, function: &impl Fn(f64) -> (f64, f64)) -> Option<f64> {
    let mut high = target.max(1.0);
    while high < limit && high < 1e100 {
        if function(high).0 >= target {
            return Some(high);
        }
        high *= 2.0;
    }
    (limit.is_finite() && function(limit).0 >= target).then_some(limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_root_is_found() {
        // (x − 0.25)(x − 3)(x + 2), and 4 (x − 8)(x − 5).
        assert!((least_positive_root(&[1.5, -5.75, -1.25, 1.0]) - 0.25).abs() < 1e-15);
        assert!((least_positive_root(&[160.0, -52.0, 4.0]) - 5.0).abs() < 1e-14);
        assert_eq!(least_positive_root(&[1.0, 0.0, 1.0]), f64::INFINITY);
        assert_eq!(least_positive_root(&[1.0]), f64::INFINITY);
        assert_eq!(least_positive_root(&[1.0, 0.0, 0.0]), f64::INFINITY);
    }

    #[test]
    fn the_inverse_of_a_rising_function() {
        let cubic = |x: f64| (x - x.powi(3) / 3.0, 1.0 - x * x);
        for x in [1e-9, 0.1, 0.5, 0.9, 0.999] {
            let found = inverse(cubic(x).0, 1.0, cubic).expect("below the limit");
            assert!((found - x).abs() < 1e-15 / cubic(x).1, "{x}: {found}");
        }
        assert_eq!(inverse(0.7, 1.0, cubic), None);
        // A function that stays below 1.
        let bounded = |x: f64| (x / (1.0 + x), 1.0 / (1.0 + x).powi(2));
        assert_eq!(inverse(1.5, f64::INFINITY, bounded), None);
    }
}
