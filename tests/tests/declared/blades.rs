//! Types whose members are blades: their constructors, their products and what functions know.

use ga_runtime::cga3;
use ga_runtime::ga;
use ga_runtime::scalar::Prime61;
use ga_runtime::testing::{exact_member, for_all, to_dense};

ga_runtime::algebra! {
    /// Conformal geometry in which lines and point pairs are blades.
    pub(crate) mod figures {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        struct Infinity { ei = 1 }
        #[hull(Vector)]
        #[facts(null)]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }
        struct Vector { e1, e2, e3, eo, ei }
        struct Sphere { e123o, e123i, e12oi, e13oi, e23oi }
        #[hull(AnyPair)]
        #[facts(blade)]
        struct Pair { e12, e13, e23, e1o, e2o, e3o, e1i, e2i, e3i, eoi }
        struct AnyPair { e12, e13, e23, e1o, e2o, e3o, e1i, e2i, e3i, eoi }
        #[hull(AnyCircle)]
        #[facts(blade)]
        struct Circle { e123, e12o, e13o, e23o, e12i, e13i, e23i, e1oi, e2oi, e3oi }
        struct AnyCircle { e123, e12o, e13o, e23o, e12i, e13i, e23i, e1oi, e2oi, e3oi }
        #[hull(AnyLine)]
        #[facts(blade)]
        struct Line { e12i, e31i, e23i, e1oi, e2oi, e3oi }
        struct AnyLine { e12i, e31i, e23i, e1oi, e2oi, e3oi }
        #[hull(AnyEven)]
        #[facts(unit_versor)]
        struct Motor { scalar, e12, e13, e23, e1i, e2i, e3i, e123i }
        struct AnyEven { scalar, e12, e13, e23, e1i, e2i, e3i, e123i }
        /// A line whose direction has the coefficient 1 at e3.
        #[hull(AnyLine)]
        #[facts(blade)]
        struct Steep { e12i, e31i, e23i, e1oi, e2oi, e3oi = 1 }

        products {
            wedge(Point, Point) -> Pair;
            wedge(Pair, Point) -> Circle;
            wedge(Pair, Infinity) -> Line;
            vee(Line, Sphere) -> Pair;
            vee(Circle, Sphere) -> Pair;
            dual(Circle) -> Pair;
            scalar_product(Pair, Pair) -> Scalar;
            geometric(AnyLine, AnyLine);
            sandwich(Motor, {Pair, Circle, Line}) -> Self;
        }
    }
}

mod products {
    ga_runtime::testing::product_tests!(super::figures);
}

mod compiled {
    use super::ga;

    ga! { super::figures;
        /// The square of a blade is a scalar.
        pub fn square(x: Pair) -> Scalar { x * x }
        pub fn square_of_meet(l: Line, s: Sphere) -> Scalar { let x: Pair = l & s; x * x }
        pub fn inverted(c: Circle) -> Circle { inverse(c) }
        pub fn unit(l: Line) -> Line { normalize(l) }
        pub fn ends(l: Line, s: Sphere) -> (Point, Point) { endpoints(l & s) }
    }

    ga! { ga_runtime::cga3;
        pub fn marked_inverse(blade c: Circle) -> Circle { inverse(c) }
        pub fn marked_squares(uniform blade x: [PointPair; 2], blade l: Line, s: Sphere) -> Scalar {
            marked_square(x[0]) + x[1] * x[1] + marked_square(l & s)
        }
        fn marked_square(blade x: PointPair) -> Scalar { x * x }
        /// A mark is a name where it stands for an operand.
        pub fn names(blade: Scalar, uniform: Scalar) -> Scalar { blade - uniform }
    }
}

#[test]
fn random_members_are_blades() {
    fn square_is_scalar<T>()
    where
        T: ga_runtime::Element<Scalar = Prime61> + std::fmt::Debug,
    {
        let algebra = ga_runtime::testing::algebra_of::<Prime61>(T::METRIC);
        for_all(exact_member::<T>(), |x| {
            let x = to_dense(&algebra, &x);
            assert!(!x.is_zero());
            assert_eq!(x.geometric(&x).grades().iter().max().unwrap_or(&0), &0);
            assert!(x.wedge(&x).is_zero());
        });
    }
    square_is_scalar::<figures::Pair<_>>();
    square_is_scalar::<figures::Circle<_>>();
    square_is_scalar::<figures::Line<_>>();
    square_is_scalar::<figures::Steep<_>>();
}

#[test]
fn constructors_check_the_relations() {
    use figures::{Circle, Line, Pair, Steep};
    // e1∧e2 + eo∧ei is not a blade: its square has a part of grade 4.
    let zero = 0.0;
    let sum = |e12: f64, eoi: f64| {
        Pair::try_new(
            e12, zero, zero, zero, zero, zero, zero, zero, zero, eoi, 1e-9,
        )
    };
    assert!(sum(1.0, 0.0).is_some() && sum(0.0, 1.0).is_some() && sum(1.0, 1e-10).is_some());
    assert!(sum(1.0, 1.0).is_none() && sum(1.0, f64::NAN).is_none());
    assert!(sum(f64::INFINITY, 0.0).is_none());
    // The direction (1, 2, 2) and a moment that is perpendicular to it, or not.
    let line = |e12i: f64| Line::try_new(e12i, 2.0, -2.0, 1.0, 2.0, 2.0, 1e-9);
    assert!(line(-1.0).is_some() && line(3.0).is_none());
    let steep = |e12i: f64| Steep::try_new(e12i, 2.0, -2.0, 1.0, 2.0, 1e-9);
    assert!(steep(-2.0).is_some() && steep(-1.0).is_none());
    // Three points make a circle; its coefficients pass, and not with one of them changed.
    let [p, q, r] = [[1.0, 2.0, 3.0], [0.0, 1.0, -1.0], [2.0, 2.0, 0.5]]
        .map(|[x, y, z]: [f64; 3]| figures::Point::new(x, y, z));
    let c = p ^ q ^ r;
    let again = |change: f64| {
        Circle::try_new(
            c.e123() + change,
            c.e12o(),
            c.e13o(),
            c.e23o(),
            c.e12i(),
            c.e13i(),
            c.e23i(),
            c.e1oi(),
            c.e2oi(),
            c.e3oi(),
            1e-9,
        )
    };
    assert_eq!(again(0.0), Some(c));
    assert_eq!(again(0.01), None);
}

#[test]
fn functions_know_that_they_are_blades() {
    type Any = figures::Pair<Prime61>;
    let algebra = ga_runtime::testing::algebra_of::<Prime61>(<Any as ga_runtime::Element>::METRIC);
    for_all(exact_member::<Any>(), |x| {
        let dense = to_dense(&algebra, &x);
        assert_eq!(compiled::square(x), dense.scalar_product(&dense));
    });
    let operands = (
        exact_member::<figures::Line<Prime61>>(),
        exact_member::<figures::Sphere<Prime61>>(),
    );
    for_all(operands, |(l, s)| {
        let met = to_dense(&algebra, &l).vee(&to_dense(&algebra, &s));
        assert_eq!(compiled::square_of_meet(l, s), met.scalar_product(&met));
    });
    for_all(exact_member::<figures::Circle<Prime61>>(), |c| {
        let inverse = to_dense(&algebra, &compiled::inverted(c));
        assert_eq!(to_dense(&algebra, &c).geometric(&inverse), algebra.one());
        let dense = to_dense(&algebra, &c);
        let plain = cga3_circle(&dense);
        assert_eq!(
            to_dense(&algebra, &compiled::marked_inverse(plain)),
            inverse
        );
    });
}

fn cga3_circle(dense: &ga_runtime::dense::Multivector<Prime61>) -> cga3::Circle<Prime61> {
    ga_runtime::Element::from_coefficients_unchecked(&mut |blade| dense.coefficient(blade))
}

#[test]
fn a_line_meets_a_sphere_in_two_points() {
    let point = |x: f64, y: f64, z: f64| figures::Point::new(x, y, z);
    let line = (point(0.0, 0.0, 0.0) ^ point(0.0, 0.0, 1.0)) ^ figures::Infinity;
    // Radius 3 about (0, 0, 5).
    let on = [
        [3.0, 0.0, 5.0],
        [0.0, 3.0, 5.0],
        [-3.0, 0.0, 5.0],
        [0.0, 0.0, 8.0],
    ];
    let [a, b, c, d] = on.map(cga3::Point::from);
    let sphere = cga3::Quadvector::from(cga3::Sphere::through(a, b, c, d));
    let sphere = figures::Sphere {
        e123o: sphere.e123o,
        e123i: sphere.e123i,
        e12oi: sphere.e12oi,
        e13oi: sphere.e13oi,
        e23oi: sphere.e23oi,
    };
    let (first, second) = compiled::ends(line, sphere);
    let mut heights = [first.e3(), second.e3()];
    heights.sort_by(f64::total_cmp);
    assert!((heights[0] - 2.0).abs() < 1e-12 && (heights[1] - 8.0).abs() < 1e-12);
    let unit = compiled::unit(line);
    assert!((unit.e3oi().abs() - 1.0).abs() < 1e-15);
    assert_eq!(compiled::names(3, 1), 2);
}

/// A line has a moment perpendicular to its direction.
#[test]
fn elements_that_are_no_blades_are_not_converted() {
    use figures::{AnyLine, Line};
    use ga_runtime::NotMember;

    let across = AnyLine::new(1e9_f64, 0.0, 0.0, 1e9, 0.0, 0.0);
    let line = Line::try_from(across).expect("a line");
    assert_eq!((line.e12i(), line.e1oi()), (1e9, 1e9));
    assert_eq!(line.to_string().parse(), Ok(line));
    let along = AnyLine::new(1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let error = Line::try_from(along).expect_err("a moment along the direction");
    assert_eq!(error, NotMember::NotBlade { type_name: "Line" });
    assert!(Line::try_from_element(along, 2.0).is_ok());
}
