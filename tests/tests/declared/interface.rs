//! The interface of declared types besides their products.

#![allow(clippy::float_cmp, reason = "the examples are exact")]
#![allow(
    clippy::default_constructed_unit_structs,
    reason = "that there is a default is tested"
)]

use ga_runtime::Element;
use ga_runtime::products::{Commutator, RightContraction, Sandwich, ScalarProduct};
use ga_runtime::testing::{for_all, strategy};
use line::{All, Even, Infinity, Motion, Pair, Point, Shift, Vector, Wedge};

ga_runtime::algebra! {
    /// Conformal geometry of the line.
    mod line {
        basis e1, eo, ei;
        metric e1*e1 = 1, eo*ei = -1;

        /// The point at infinity.
        struct Infinity { ei = 1 }
        /// The point x.
        #[hull(Vector)]
        #[facts(null, weight(eo))]
        struct Point { e1, eo = 1, ei = e1*e1/2 }
        /// A vector.
        struct Vector { e1, eo, ei }
        /// A pair of points, with the vectors of its blades in unusual orders.
        struct Pair { eio, e1o, ei1 }
        /// A multiple of the pseudoscalar.
        struct Space { e1oi }
        /// A translation.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Shift { scalar = 1, e1i }
        /// Any even unit versor.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Motion { scalar, e1o, e1i, eoi }
        /// An element of even grade.
        struct Even { scalar, e1o, e1i, eoi }
        /// A general multivector.
        struct All { scalar, e1, eo, ei, e1o, e1i, eoi, e1oi }
        /// A type with the name of a product.
        struct Wedge { eoi }

        products {
            geometric(Vector, Vector) -> Even;
            geometric(Motion, Motion) -> Motion;
            wedge({Point, Vector}, {Point, Vector, Infinity}) -> Pair;
            left_contraction(Vector, Vector) -> Scalar;
            right_contraction(Pair, Vector) -> Vector;
            scalar_product(Pair, Pair) -> Scalar;
            commutator(Pair, Pair) -> Pair;
            vee(Pair, Pair) -> Vector;
            wedge(Pair, Infinity) -> Space;
            sandwich(Shift, Point) -> Self;
            sandwich(Motion, {Vector, Pair}) -> Self;
        }
    }
}

mod products {
    ga_runtime::testing::product_tests!(super::line);
}

#[test]
fn coefficients_are_read_by_blade() {
    const POINT: Point<f64> = Point::new(3.0);
    assert_eq!((POINT.e1(), POINT.eo(), POINT.ei()), (3.0, 1.0, 4.5));
    // 1 + b e1i is a unit versor for every b, so nothing needs checking.
    let shift = Shift::new(-0.5);
    assert_eq!((shift.scalar(), shift.e1i()), (1.0, -0.5));
    let Vector { e1, eo, ei } = Vector::from(POINT);
    assert_eq!([e1, eo, ei], [3.0, 1.0, 4.5]);
}

#[test]
fn types_are_as_large_as_what_they_store() {
    assert_eq!(size_of::<Infinity>(), 0);
    assert_eq!(size_of::<Point<f32>>(), 4);
    assert_eq!(size_of::<Pair<f32>>(), 12);
    assert_eq!(size_of::<Motion<f64>>(), 32);
}

#[test]
fn blades_are_written_as_declared() {
    let pair = Pair::new(1.0, -2.0, 0.5);
    assert_eq!(pair.to_string(), "eio - 2 e1o + 0.5 ei1");
    assert_eq!(format!("{pair:.2}"), "1.00 eio - 2.00 e1o + 0.50 ei1");
    assert_eq!(
        format!("{pair:?}"),
        "Pair { eio: 1.0, e1o: -2.0, ei1: 0.5 }"
    );
    assert_eq!(Point::new(2).e1().to_string(), "2");
    assert_eq!(Point::new(2.0).to_string(), "2 e1 + eo + 2 ei");
    assert_eq!(Even::new(-1, 0, 0, 3).to_string(), "-1 + 3 eoi");
    assert_eq!(Vector::<f64>::default().to_string(), "0");
}

#[test]
fn elements_are_seen_in_rising_order() {
    let pair = Pair::new(1, 2, 3);
    // eio = −eoi, and ei1 = −e1i.
    let coefficients = [0b110, 0b011, 0b101, 0b111].map(|blade| pair.coefficient(blade));
    assert_eq!(coefficients, [-1, 2, -3, 0]);
    assert_eq!(<Pair<i64> as Element>::BLADES, [0b110, 0b011, 0b101]);
    assert_eq!(
        Pair::from_coefficients_unchecked(&mut |blade| pair.coefficient(blade)),
        pair
    );
    assert_eq!(line::BASIS, ["e1", "eo", "ei"]);
    assert_eq!(line::METRIC[1], [(0, 1), (0, 1), (-1, 1)]);
    let flags = [
        (
            <Point<f64> as Element>::IS_UNIT_VERSOR,
            <Point<f64> as Element>::IS_FREE,
        ),
        (
            <Shift<f64> as Element>::IS_UNIT_VERSOR,
            <Shift<f64> as Element>::IS_FREE,
        ),
        (
            <Motion<f64> as Element>::IS_UNIT_VERSOR,
            <Motion<f64> as Element>::IS_FREE,
        ),
    ];
    assert_eq!(flags, [(false, true), (true, true), (true, false)]);
}

#[test]
fn sums_leave_a_type_only_where_they_must() {
    let (p, q) = (Point::new(3.0), Point::new(1.0));
    assert_eq!(p - q, Vector::new(2.0, 0.0, 4.0));
    assert_eq!(p + q, Vector::new(4.0, 2.0, 5.0));
    assert_eq!(-p, Vector::new(-3.0, -1.0, -4.5));
    assert_eq!(p * 2.0, Vector::new(6.0, 2.0, 9.0));
    assert_eq!(2.0 * p, p * 2.0);
    assert_eq!(p / 2.0, Vector::new(1.5, 0.5, 2.25));

    let motion = Motion::new_unchecked(1_i64, 0, 5, 0);
    let negative: Motion<i64> = -motion;
    assert_eq!([negative.scalar(), negative.e1i()], [-1, -5]);
    let negative: Even<f64> = -Shift::new(5.0);
    assert_eq!([negative.scalar, negative.e1i], [-1.0, -5.0]);
    assert_eq!(motion.reverse().e1i(), -5, "the reverse of a motion is one");
    assert_eq!(Shift::new(5).reverse().e1i(), -5);

    let mut pair = Pair::new(1.0_f32, 2.0, 3.0);
    pair += Pair::new(1.0, 1.0, 1.0);
    pair -= Pair::new(0.0, 0.0, 4.0);
    pair *= 2.0;
    assert_eq!(pair, Pair::new(4.0, 6.0, 0.0));
    assert_eq!(0.5_f32 * pair, Pair::new(2.0, 3.0, 0.0));
}

#[test]
fn defaults_are_the_origin_the_identity_and_zero() {
    assert_eq!(Point::<f64>::default(), Point::new(0.0));
    assert_eq!(Motion::<i64>::default(), Motion::new_unchecked(1, 0, 0, 0));
    assert_eq!(Shift::<i64>::default(), Shift::new(0));
    assert_eq!(Even::<i64>::default(), Even::new(0, 0, 0, 0));
    assert_eq!(Infinity, Infinity::default());
}

#[test]
fn conversions_are_lossless_or_say_what_they_keep() {
    let point = Point::new(3.0);
    assert_eq!(
        All::from(point),
        All::new(0.0, 3.0, 1.0, 4.5, 0.0, 0.0, 0.0, 0.0)
    );
    let all = All::from(Pair::new(1, 2, 3));
    assert_eq!(all, All::new(0, 0, 0, 0, 2, -3, -1, 0));
    assert_eq!(all.extract_pair(), Pair::new(1, 2, 3));
    assert_eq!(all.extract_even(), Even::new(0, 2, -3, -1));
    assert_eq!(Pair::new(1, 2, 3).extract_wedge(), Wedge::new(-1));
    assert_eq!(Even::from(Shift::new(7)), Even::new(1, 0, 7, 0));
    assert_eq!(Motion::from(Shift::new(7)).e1i(), 7);
}

/// A generic function calls by traits what the inherent methods do.
fn by_traits<S, V, P, M>(vector: V, pair: P, motion: M) -> (V, S, P, P)
where
    P: Copy
        + RightContraction<V, Output = V>
        + ScalarProduct<P, Output = S>
        + Commutator<P, Output = P>,
    M: Copy + Sandwich<P, Output = P>,
{
    (
        pair.right_contraction(vector),
        pair.scalar_product(pair),
        motion.sandwich(pair).commutator(pair),
        motion.sandwich(pair),
    )
}

#[test]
fn methods_traits_and_operators_are_one() {
    let number = || strategy::prime();
    let triple = || (number(), number(), number());
    for_all((triple(), triple(), triple()), |(a, b, c)| {
        let [a, b] = [a, b].map(|(e1, eo, ei)| Vector::new(e1, eo, ei));
        let (p, q) = (Pair::new(c.0, c.1, c.2), a ^ b);
        assert_eq!(a.geometric(b), a * b);
        assert_eq!(a.wedge(b), q);
        assert_eq!(a.left_contraction(b), a | b);
        assert_eq!(p.vee(q), p & q);
        assert_eq!(q.wedge(Infinity), q ^ Infinity);
        // Any product of two vectors is a versor, though not a unit one; the sandwich does not
        // check it.
        let Even {
            scalar,
            e1o,
            e1i,
            eoi,
        } = a * b;
        let motion = Motion::new_unchecked(scalar, e1o, e1i, eoi);
        assert_eq!(motion.sandwich(p), motion.transform(p));
        let moved = motion.sandwich(p);
        let expected = (
            p.right_contraction(a),
            p.scalar_product(p),
            moved.commutator(p),
            moved,
        );
        assert_eq!(by_traits(a, p, motion), expected);
    });
}

#[test]
fn inverses() {
    let coordinate = || strategy::nonzero_prime();
    for_all(
        (coordinate(), coordinate(), coordinate()),
        |(e1, eo, ei)| {
            let vector = Vector::new(e1, eo, ei);
            let square = vector | vector;
            let Some(inverse) = vector.try_inverse() else {
                assert_eq!(square, 0.into());
                return;
            };
            assert_eq!(
                vector * inverse,
                Even::new(1.into(), 0.into(), 0.into(), 0.into())
            );
        },
    );
    assert_eq!(
        Vector::from(Point::new(3.0)).try_inverse(),
        None,
        "points are null"
    );
    let motion = Motion::try_new(1.25, 0.0, 0.0, 0.75, 0.0).expect("eoi² = 1");
    assert_eq!(motion * motion.inverse(), Motion::default());
}

#[test]
fn unit_versors_are_checked() {
    let scaling = |scalar: f64, eoi, tolerance| Motion::try_new(scalar, 0.0, 0.0, eoi, tolerance);
    assert!(scaling(1.25, 0.75, 0.0).is_some());
    assert!(scaling(1.25, 0.75 + 1e-6, 1e-6).is_none());
    assert!(scaling(1.25, 0.75 + 1e-6, 2e-6).is_some());
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
        assert_eq!(scaling(wrong, 0.75, 1.0), None);
        assert_eq!(scaling(0.75, wrong, f64::INFINITY), None);
    }
    assert_eq!(scaling(1.25, 0.75, f64::NAN), None, "no tolerance at all");
    assert_eq!(scaling(2.0, 0.0, -1.0), None);

    assert_eq!(
        Motion::normalize(Even::new(2.5, 0.0, 0.0, 1.5)),
        scaling(1.25, 0.75, 0.0)
    );
    let none = [
        Even::default(),
        Even::new(0.0, 0.0, 0.0, 1.0),
        Even::new(1.0, 0.0, 0.0, 1.0),
        Even::new(f64::NAN, 0.0, 0.0, 0.0),
        Even::new(f64::INFINITY, 0.0, 0.0, 0.0),
    ];
    assert_eq!(none.map(Motion::normalize), [None; 5], "no positive norm");
}
