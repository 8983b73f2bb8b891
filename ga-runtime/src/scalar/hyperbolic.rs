//! The hyperbolic functions of scalars that bring none of their own.

use super::{Real, versor_exponential};

/// `sinh x = x S(x²)`, where S is accurate near zero. `√x²` is |x| exactly.
#[inline]
pub(super) fn sinh<S: Real>(x: S) -> S {
    x * versor_exponential(x * x).1
}

/// `cosh x = C(x²)`.
#[inline]
pub(super) fn cosh<S: Real>(x: S) -> S {
    versor_exponential(x * x).0
}

/// `tanh x = x S(x²)/C(x²)`.
#[inline]
pub(super) fn tanh<S: Real>(x: S) -> S {
    // 1 − tanh x is 2 e⁻²ˣ, which double precision does not see from 19 on; sinh and cosh do not
    // overflow there.
    let limit = S::from_integer(40);
    let bounded = x.min(limit).max(-limit);
    let (cosine, sine, _) = versor_exponential(bounded * bounded);
    bounded * sine / cosine
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the functions of the standard library, in units of the last place.
    #[test]
    fn they_are_those_of_the_library() {
        let near = |found: f64, expected: f64, what: &str| {
            let unit = (expected.abs() * f64::EPSILON).max(f64::MIN_POSITIVE);
            assert!(
                found == expected || (found - expected).abs() <= 4.0 * unit,
                "{what}: {found:e}, not {expected:e}"
            );
        };
        for size in [
            0.0, 1e-300, 1e-20, 1e-8, 0.1, 0.9, 1.1, 5.0, 19.0, 41.0, 700.0, 1e3,
        ] {
            for x in [size, -size] {
                near(sinh(x), x.sinh(), &format!("sinh {x}"));
                near(cosh(x), x.cosh(), &format!("cosh {x}"));
                near(tanh(x), x.tanh(), &format!("tanh {x}"));
            }
        }
        assert!(tanh(f64::NAN).is_nan());
        assert_eq!((tanh(f64::INFINITY), tanh(f64::NEG_INFINITY)), (1.0, -1.0));
    }
}
