//! Inverses and defaults of types that do not contain the identity, and the normalisation of large
//! and small elements.

use std::marker::PhantomData;

use ga_runtime::scalar::Lanes;
use ga_runtime::testing::{for_all, strategy};
use plane::{Even, HalfTurn, Mirror, Turn, Vector};

ga_runtime::algebra! {
    /// The Euclidean plane, with its lines as vectors.
    mod plane {
        basis e1, e2, e0;
        signature 2, 0, 1;

        /// The line `a x + b y + c = 0` as `a e1 + b e2 + c e0`.
        struct Vector { e1, e2, e0 }
        /// A reflection.
        #[hull(Vector)]
        #[facts(unit_versor)]
        struct Mirror { e1, e2, e0 }
        /// The rotation by 180° about a point.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct HalfTurn { e12 = 1, e10, e20 }
        /// A rotation about the origin.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Turn { scalar, e12 }
        /// An element of even grade.
        struct Even { scalar, e12, e10, e20 }

        products {
            geometric(HalfTurn, {HalfTurn, Even}) -> Even;
            geometric(Mirror, Mirror) -> Even;
            sandwich(Mirror, Vector) -> Self;
        }
    }
}

mod products {
    ga_runtime::testing::product_tests!(super::plane);
}

/// Whether a type has a default: the inherent constant takes precedence over that of the trait
/// where its bound holds.
struct Probe<T>(PhantomData<T>);

trait HasNoDefault {
    const HAS_DEFAULT: bool = false;
}

impl<T> HasNoDefault for Probe<T> {}

impl<T: Default> Probe<T> {
    const HAS_DEFAULT: bool = true;
}

#[test]
fn defaults_are_members() {
    let defaults = [
        Probe::<Mirror<f64>>::HAS_DEFAULT,
        Probe::<HalfTurn<f64>>::HAS_DEFAULT,
        Probe::<Turn<f64>>::HAS_DEFAULT,
        Probe::<Vector<f64>>::HAS_DEFAULT,
    ];
    assert_eq!(defaults, [false, true, true, true]);
    assert_eq!(Turn::default(), Turn::new_unchecked(1, 0));
    assert_eq!(HalfTurn::default(), HalfTurn::new(0, 0));
}

#[test]
fn inverses_leave_a_type_that_reversing_leaves() {
    for_all((strategy::prime(), strategy::prime()), |(e10, e20)| {
        let turn = HalfTurn::new(e10, e20);
        let inverse: Even<_> = turn.inverse();
        assert_eq!(
            turn * inverse,
            Even::new(1.into(), 0.into(), 0.into(), 0.into())
        );
    });
}

#[test]
fn elements_without_an_inverse_in_one_lane_have_none() {
    let lanes = |first, second| Lanes::from_array([first, second]);
    let vector = |length| Vector::new(length, lanes(0.0, 0.0), lanes(0.0, 0.0));
    assert_eq!(vector(lanes(2.0, 0.0)).try_inverse(), None);
    assert_eq!(
        vector(lanes(2.0, 4.0)).try_inverse(),
        Some(vector(lanes(0.5, 0.25)))
    );
}

#[test]
fn sizes_do_not_matter_to_normalisation() {
    for exponent in -300..=300 {
        let size = 10_f64.powi(exponent);
        let mirror = Mirror::normalize(Vector::new(3.0 * size, -4.0 * size, 7.0 * size));
        let mirror = mirror.expect("a direction");
        let expected = [0.6, -0.8, 1.4];
        let found = [mirror.e1(), mirror.e2(), mirror.e0()];
        for (found, expected) in found.into_iter().zip(expected) {
            let deviation: f64 = found - expected;
            assert!(
                deviation.abs() <= 1e-15 * expected.abs(),
                "1e{exponent}: {found}"
            );
        }
    }
}
