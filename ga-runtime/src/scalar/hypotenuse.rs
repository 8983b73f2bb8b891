//! The hypotenuse of scalars that bring none of their own.

use super::Real;

/// `m √(1 + (n/m)²)`, where m is the larger magnitude.
#[inline]
pub(super) fn hypot<S: Real>(x: S, y: S) -> S {
    let (x, y) = (x.abs(), y.abs());
    // Where one is NaN, the smaller one is `y` and the larger one `x`, so that NaN is kept.
    let (larger, smaller) = (x.max(y), y.min(x));
    let is_regular = S::zero().less_than(larger) & larger.is_finite();
    let divisor = S::select(is_regular, larger, S::one());
    let ratio = S::select(is_regular, smaller / divisor, S::zero());
    larger * (S::one() + ratio * ratio).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_the_library() {
        let sizes = [0.0, 1e-310, 3e-200, 1.0, 4e-9, 0.75, 3e200, f64::MAX];
        for x in sizes {
            for y in sizes {
                let (found, expected) = (hypot(x, -y), x.hypot(y));
                let unit = (expected * f64::EPSILON).max(f64::MIN_POSITIVE * f64::EPSILON);
                let is_near = found == expected || (found - expected).abs() <= 2.0 * unit;
                assert!(is_near, "{x:e}, {y:e}: {found:e}, not {expected:e}");
            }
        }
        let infinity = f64::INFINITY;
        assert_eq!(
            (hypot(infinity, 1.0), hypot(0.0, -infinity)),
            (infinity, infinity)
        );
        assert!(hypot(f64::NAN, 1.0).is_nan() && hypot(1.0, f64::NAN).is_nan());
    }
}
