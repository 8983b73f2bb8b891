//! Primitives in direct and dual form: constructed, read back, classified and moved.

use ga_runtime::Element;
use ga_runtime::cga3::{
    Bivector, Circle, Direction, DualCircle, DualDirection, DualFlatPoint, DualPlane,
    DualPointPair, DualSphere, FlatPoint, Infinity, Line, Motor, Multivector, Plane, Point,
    PointPair, Quadvector, RoundVector, Similarity, Sphere, Trivector,
};
use ga_runtime::geometry::Kind;
use ga_runtime::products::Sandwich;
use ga_runtime::testing::{Prime61, assert_close, member, strategy};
use nullcone_tests::plain::{along, dot, unit, vector};
use proptest::prelude::*;

fn some_across(n: [f64; 3]) -> [f64; 3] {
    let least = (0..3)
        .min_by(|&a, &b| n[a].abs().total_cmp(&n[b].abs()))
        .expect("three");
    let mut e = [0.0; 3];
    e[least] = 1.0;
    let v = along(e, -dot(e, n), n);
    v.map(|x| x / dot(v, v).sqrt())
}

proptest! {
    #[test]
    fn a_pair_gives_back_its_points(p in vector(5.0), q in vector(5.0)) {
        let gap = along(p, -1.0, q);
        prop_assume!(dot(gap, gap) > 0.01);
        let pair = PointPair::through(Point::from(p), Point::from(q));
        let [a, b] = pair.endpoints().expect("real");
        assert_close!(a.coordinates(), p, 1e-11, 5.0);
        assert_close!(b.coordinates(), q, 1e-11, 5.0);
        assert_close!(pair.centre().expect("a pair").coordinates(), along(p, 1.0, q).map(|x| x / 2.0), 1e-12, 5.0);
        assert_close!(pair.radius_squared().expect("a pair"), dot(gap, gap) / 4.0, 1e-12, 100.0);
        assert_close!(pair.square(), (dot(gap, gap) / 2.0).powi(2), 1e-12, 1e4);
        assert_close!(pair.attitude().vector(), along(q, -1.0, p), 1e-15, 10.0);
        prop_assert!(pair.carrier().distance(Point::from(p)).expect("a line") < 1e-11);
        prop_assert_eq!(pair.kind(1e-12), Kind::Real);
    }

    #[test]
    fn multiples_of_a_pair_have_the_same_points(p in vector(5.0), q in vector(5.0), factor in 0.01..100.0) {
        let gap = along(p, -1.0, q);
        prop_assume!(dot(gap, gap) > 0.01);
        let pair = PointPair::through(Point::from(p), Point::from(q));
        let [a, b] = (pair * factor).endpoints().expect("real");
        assert_close!([a.coordinates(), b.coordinates()].concat(), [p, q].concat(), 1e-11, 5.0);
        let [a, b] = (pair * -factor).endpoints().expect("real");
        assert_close!([a.coordinates(), b.coordinates()].concat(), [q, p].concat(), 1e-11, 5.0);
    }

    #[test]
    fn pairs_by_centre_and_squared_radius(c in vector(5.0), d in unit(), squared in -4.0..4.0_f64) {
        let pair = PointPair::from_centre_axis_radius_squared(Point::from(c), d, squared).expect("a pair");
        assert_close!(pair.centre().expect("a centre").coordinates(), c, 1e-12, 5.0);
        assert_close!(pair.radius_squared().expect("a pair"), squared, 1e-12, 100.0);
        assert_close!(pair.unit_direction().expect("an axis"), d, 1e-14, 1.0);
        prop_assume!(squared.abs() > 1e-12);
        prop_assert_eq!(pair.endpoints().is_some(), squared > 0.0);
        if squared > 1e-6 {
            // The wedge of the two points is the pair times their distance.
            let r = squared.sqrt();
            let [p, q] = [-r, r].map(|t| Point::from(along(c, t, d)));
            let difference = (p ^ q) - pair * (2.0 * r);
            let size: Vec<f64> = PointPair::<f64>::BLADES.iter().map(|&blade| difference.coefficient(blade)).collect();
            assert_close!(size, vec![0.0; 10], 1e-12, 1000.0);
        }
        // The container is the sphere about the same centre; its dual σ has σ·P = 0, so that it
        // holds the pair.
        let container = pair.container().expect("a pair");
        assert_close!(container.centre().expect("a sphere").coordinates(), c, 1e-12, 5.0);
        assert_close!(container.radius_squared().expect("a sphere"), squared, 1e-11, 100.0);
        let direct = Multivector::from(container.dual()) | Multivector::from(pair);
        let size: Vec<f64> = (0..32).map(|blade| direct.coefficient(blade)).collect();
        assert_close!(size, vec![0.0; 32], 1e-11, 1000.0);
    }

    #[test]
    fn circles_by_centre_and_squared_radius(c in vector(5.0), n in unit(), squared in -4.0..4.0_f64) {
        let circle = Circle::from_centre_normal_radius_squared(Point::from(c), n, squared).expect("a circle");
        assert_close!(circle.centre().expect("a centre").coordinates(), c, 1e-12, 5.0);
        assert_close!(circle.radius_squared().expect("a circle"), squared, 1e-12, 100.0);
        assert_close!(circle.unit_normal().expect("a normal"), n, 1e-14, 1.0);
        let axis = circle.axis().expect("an axis");
        prop_assert!(axis.distance(Point::from(c)).expect("a line") < 1e-12);
        assert_close!(axis.direction(), n, 1e-14, 1.0);
        assert_close!(circle.attitude().normal(), circle.carrier().normal(), 0.0, 1.0);
        assert_close!(circle.container().expect("a circle").radius_squared().expect("a sphere"), squared, 1e-11, 100.0);
        if squared > 1e-6 {
            let on = Point::from(along(c, squared.sqrt(), some_across(n)));
            let outside = Multivector::from(circle ^ on);
            let size: Vec<f64> = (0..32).map(|blade| outside.coefficient(blade)).collect();
            assert_close!(size, vec![0.0; 32], 1e-11, 1000.0);
        }
    }

    #[test]
    fn kinds_do_not_depend_on_weight(c in vector(2.0), n in unit(), squared in -2.0..2.0_f64, weight in 1e-3..1e3_f64) {
        prop_assume!(squared.abs() > 1e-9);
        let expected = if squared > 0.0 { Kind::Real } else { Kind::Imaginary };
        let point = Point::from(c);
        let pair = PointPair::from_centre_axis_radius_squared(point, n, squared).expect("a pair");
        let circle = Circle::from_centre_normal_radius_squared(point, n, squared).expect("a circle");
        let sphere = Sphere::from_centre_radius_squared(point, squared);
        for factor in [weight, -weight] {
            prop_assert_eq!((pair * factor).kind(1e-12), expected);
            prop_assert_eq!((circle * factor).kind(1e-12), expected);
            prop_assert_eq!((sphere * factor).kind(1e-12), expected);
            prop_assert_eq!((pair * factor).dual().kind(1e-12), expected);
            prop_assert_eq!((circle * factor).dual().kind(1e-12), expected);
            prop_assert_eq!((sphere * factor).dual().kind(1e-12), expected);
        }
        let (tangent, contact) = (PointPair::tangent(point, n), Circle::tangent(point, n));
        prop_assert_eq!((tangent.expect("a direction") * weight).kind(1e-12), Kind::Tangent);
        prop_assert_eq!((contact.expect("a normal") * weight).kind(1e-12), Kind::Tangent);
        prop_assert_eq!((Sphere::from_centre_radius_squared(point, 0.0) * weight).kind(1e-12), Kind::Tangent);
        prop_assert_eq!(Bivector::from(point ^ Infinity).kind(1e-12), Kind::Flat);
        prop_assert_eq!(Bivector::from(Direction::from_vector(n)).kind(1e-12), Kind::Free);
        prop_assert_eq!(Trivector::from(Line::from_point_direction(point, n)).kind(1e-12), Kind::Flat);
        prop_assert_eq!(Trivector::from(DualDirection::from_normal(n)).kind(1e-12), Kind::Free);
        prop_assert_eq!(Quadvector::from(Plane::from_point_normal(point, n)).kind(1e-12), Kind::Flat);
        prop_assert_eq!((Line::from_point_direction(point, n) * weight).kind(1e-12), Kind::Flat);
        prop_assert_eq!((Line::from_point_direction(point, n) * weight).dual().kind(1e-12), Kind::Flat);
        prop_assert_eq!((Plane::from_point_normal(point, n) * -weight).kind(1e-12), Kind::Flat);
        prop_assert_eq!((Plane::from_point_normal(point, n) * -weight).dual().kind(1e-12), Kind::Flat);
        prop_assert_eq!(FlatPoint::from(point).kind(1e-12), Kind::Flat);
    }

    #[test]
    fn what_touches_has_radius_zero(c in vector(10.0), n in unit(), r in 0.5..10.0_f64, weight in 0.1..10.0_f64) {
        let point = Point::from(c);
        let tangent = PointPair::tangent(point, n).expect("a direction") * weight;
        let ends = tangent.endpoints().expect("a real pair");
        prop_assert_eq!(ends[0], ends[1]);
        assert_close!(ends[0].coordinates(), c, 1e-13, 100.0);
        prop_assert_eq!((Circle::tangent(point, n).expect("a normal") * weight).radius(), Some(0.0));
        prop_assert_eq!((Sphere::from_centre_radius(point, 0.0) * weight).radius(), Some(0.0));
        // Meets that touch: a sphere with a tangent plane and a tangent line, and two spheres that
        // touch from outside.
        let sphere = Sphere::from_centre_radius(point, r) * weight;
        let foot = Point::from(along(c, r, n));
        let circle = sphere & Plane::from_point_normal(foot, n);
        // The rounding error of a product is relative to the size of its operands.
        let size = 1e-13 * (dot(c, c) + r * r) * (1.0 + dot(c, c) / (r * r));
        let is_zero = |squared: Option<f64>| squared.expect("a round").abs() < size;
        prop_assert!(is_zero(circle.radius_squared()));
        assert_close!(circle.centre().expect("a circle").coordinates(), foot.coordinates(), 1e-12, 100.0);
        let pair = sphere & Line::from_point_direction(foot, some_across(n));
        prop_assert!(is_zero(pair.radius_squared()));
        let other = Sphere::from_centre_radius(Point::from(along(c, 3.0 * r, n)), 2.0 * r);
        prop_assert!(is_zero((sphere & other).radius_squared()));
    }

    #[test]
    fn kinds_are_told_far_away_and_in_single_precision(n in unit(), exponent in -2.0..4.0_f64, ratio in 0.1..0.9_f64) {
        let distance = 10_f64.powf(exponent);
        let c = n.map(|x| x * distance);
        let across = some_across(n);
        fn check<S: ga_runtime::scalar::Real<Mask = bool>>(c: [f64; 3], n: [f64; 3], r: f64, tolerance: f64) {
            let of = |v: [f64; 3]| v.map(S::from_f64);
            let (point, r, tolerance) = (Point::from(of(c)), S::from_f64(r), S::from_f64(tolerance));
            assert_eq!(Sphere::from_centre_radius(point, r).kind(tolerance), Kind::Real);
            let circle = Circle::from_centre_normal_radius(point, of(n), r).expect("a circle");
            assert_eq!(circle.kind(tolerance), Kind::Real);
            let pair = PointPair::from_centre_axis_radius_squared(point, of(n), r * r).expect("a pair");
            assert_eq!(pair.kind(tolerance), Kind::Real);
            assert_eq!(Line::from_point_direction(point, of(n)).kind(tolerance), Kind::Flat);
            assert_eq!(Plane::from_point_normal(point, of(n)).kind(tolerance), Kind::Flat);
            assert_eq!(FlatPoint::from(point).kind(tolerance), Kind::Flat);
        }
        check::<f32>(c, across, ratio * distance, 1e-5);
        check::<f64>(c.map(|x| x * 1e3), across, ratio * distance * 1e3, 1e-12);
    }

    #[test]
    fn both_forms_hold_the_same_points(
        sphere in member::<Sphere<Prime61>>(strategy::prime()),
        vectors in prop::array::uniform3(member::<DualSphere<Prime61>>(strategy::prime())),
        point in member::<Point<Prime61>>(strategy::prime()),
    ) {
        // x ∧ X is the dual of x·X, up to the sign of the grade, for every form.
        let x = Multivector::from(point);
        let circle = (vectors[0] ^ vectors[1]).undual();
        let pair = (vectors[0] ^ vectors[1] ^ vectors[2]).undual();
        prop_assert_eq!((x ^ Multivector::from(sphere)).dual(), x | Multivector::from(sphere.dual()));
        prop_assert_eq!((x ^ Multivector::from(circle)).dual(), x | Multivector::from(circle.dual()));
        prop_assert_eq!((x ^ Multivector::from(pair)).dual(), x | Multivector::from(pair.dual()));
        // The wedge of dual forms is the meet.
        let [a, b, c] = vectors.map(DualSphere::undual);
        prop_assert_eq!(a & b, circle);
        prop_assert_eq!(a & b & c, pair);
    }

    #[test]
    fn attitudes_are_contractions_with_infinity(
        p in member::<Point<Prime61>>(strategy::prime()),
        q in member::<Point<Prime61>>(strategy::prime()),
        r in member::<Point<Prime61>>(strategy::prime()),
    ) {
        let infinity = Multivector::from(Infinity);
        let attitude = |flat: Multivector<Prime61>| -(infinity | flat);
        let (line, plane) = (p ^ q ^ Infinity, p ^ q ^ r ^ Infinity);
        prop_assert_eq!(Multivector::from(line.attitude()), attitude(line.into()));
        prop_assert_eq!(Multivector::from((p ^ q).attitude()), attitude(line.into()));
        prop_assert_eq!(Multivector::from(plane.attitude()), attitude(plane.into()));
        prop_assert_eq!(Multivector::from((p ^ q ^ r).attitude()), attitude(plane.into()));
        prop_assert_eq!(DualDirection::from_normal(plane.normal()), plane.attitude());
    }

    #[test]
    fn dual_forms_move_as_what_they_stand_for(
        motor in member::<Motor<Prime61>>(strategy::prime()),
        similarity in member::<Similarity<Prime61>>(strategy::prime()),
        mirror in member::<RoundVector<Prime61>>(strategy::prime()),
        sphere in member::<DualSphere<Prime61>>(strategy::prime()),
        circle in member::<DualCircle<Prime61>>(strategy::prime()),
        pair in member::<DualPointPair<Prime61>>(strategy::prime()),
        flat in member::<DualFlatPoint<Prime61>>(strategy::prime()),
        free in member::<DualDirection<Prime61>>(strategy::prime()),
    ) {
        fn check<V, X>(versor: V, x: X)
        where
            V: Element<Scalar = Prime61> + Sandwich<X, Output = X> + Into<Multivector<Prime61>>,
            X: Element<Scalar = Prime61> + Into<Multivector<Prime61>>,
        {
            // An odd versor acts on the grade involution.
            let is_odd = V::BLADES.iter().all(|blade| blade.count_ones() % 2 == 1);
            let x_whole: Multivector<Prime61> = x.into();
            let argument = if is_odd { x_whole.involute() } else { x_whole };
            let expected: Multivector<Prime61> = Sandwich::sandwich(versor.into(), argument);
            assert_eq!(Sandwich::sandwich(versor, x).into(), expected);
        }
        check(motor, sphere);
        check(motor, circle);
        check(motor, pair);
        check(motor, flat);
        check(motor, free);
        check(similarity, sphere);
        check(similarity, circle);
        check(similarity, pair);
        check(similarity, flat);
        check(similarity, free);
        check(mirror, RoundVector::from(sphere));
        check(mirror, Bivector::from(circle));
        check(mirror, Trivector::from(pair));
    }
}

#[test]
fn degenerate_blades_are_named() {
    let (p, q, r) = (
        Point::new(1.0, 2.0, 3.0),
        Point::new(2.0, 3.0, 4.0),
        Point::new(4.0, 5.0, 6.0),
    );
    let none = PointPair::through(p, p);
    assert_eq!(
        (none.kind(1e-12), none.centre(), none.endpoints()),
        (Kind::Zero, None, None)
    );
    // Three points on a line have no circle; their product has no weight.
    let line = Circle::through(p, q, r);
    assert_eq!(
        (line.kind(1e-12), line.centre(), line.radius(), line.axis()),
        (Kind::Zero, None, None, None)
    );
    assert_eq!(Circle::through(p, q, q).kind(1e-12), Kind::Zero);
    // Four points on a plane, four on a circle.
    let square = [
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
    ]
    .map(Point::from);
    let [a, b, c, d] = square;
    assert_eq!(Sphere::through(a, b, c, d).kind(1e-12), Kind::Zero);
    let far = Point::new(5.0, 0.0, 0.0);
    let plane = Sphere::through(a, b, c, far);
    assert_eq!(
        (plane.kind(1e-12), plane.centre(), plane.radius_squared()),
        (Kind::Zero, None, None)
    );
    // A sphere that contains only the point at infinity.
    assert_eq!(
        Quadvector::new(0.0, 1.0, 0.0, 0.0, 0.0).kind(1e-12),
        Kind::Free
    );
    // The sum of two skew point pairs is not a blade.
    let pair = (p ^ q) + (Point::new(0.0, 0.0, 1.0) ^ Point::new(-1.0, 5.0, 2.0));
    assert_eq!(pair.kind(1e-12), Kind::NotABlade);
    assert_eq!(pair.undual().kind(1e-12), Kind::NotABlade);
    // Flats whose place is at infinity, and a sum of two skew lines.
    assert_eq!(FlatPoint::new(1.0, 2.0, 3.0, 0.0).kind(1e-12), Kind::Free);
    assert_eq!(
        Line::new(1.0, 2.0, 3.0, 0.0, 0.0, 0.0).kind(1e-12),
        Kind::Free
    );
    assert_eq!(Plane::new(2.0, 0.0, 0.0, 0.0).kind(1e-12), Kind::Free);
    assert_eq!(
        (Plane::from_point_normal(p, [0.0, 0.0, 1.0])
            & Plane::from_point_normal(q, [0.0, 0.0, 1.0]))
        .kind(1e-12),
        Kind::Free
    );
    let skew = Line::from_point_direction(Point::default(), [1.0, 0.0, 0.0])
        + Line::from_point_direction(Point::new(0.0, 0.0, 1.0), [0.0, 1.0, 0.0]);
    assert_eq!(skew.kind(1e-12), Kind::NotABlade);
    assert_eq!(FlatPoint::from(p).to_point(), Some(p));
    assert_eq!(
        DualPlane::new(0.0, 0.0, 2.0, 6.0).undual().support(),
        Some(Point::new(0.0, 0.0, 3.0))
    );
    assert_eq!(Plane::new(1.0, 0.0, 0.0, 0.0).support(), None);
}

#[test]
fn a_tolerance_of_nan_is_never_met() {
    let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
    assert_eq!(sphere.kind(f64::NAN), Kind::Real);
    let circle = Circle::from_centre_normal_radius(Point::default(), [0.0, 0.0, 1.0], 1.0);
    assert_eq!(circle.expect("a circle").kind(f64::NAN), Kind::Real);
    let general = circle.map(Trivector::from);
    assert_eq!(general.expect("a circle").kind(f64::NAN), Kind::NotABlade);
}

#[test]
fn small_rounds_in_single_precision_keep_their_radius() {
    for size in [1e-3_f32, 1e-5, 1e-7, 1e-8] {
        let [p, q, r] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        let [p, q, r] = [p, q, r].map(|x: [f32; 3]| Point::from(x.map(|x| x * size)));
        let radius = Circle::through(p, q, r).radius().expect("a circle");
        assert!((radius / size - 1.0).abs() < 1e-6, "{size}: {radius}");
    }
}

#[test]
fn numbers_that_are_not_finite_give_none() {
    let axis = [0.0, 0.0, 1.0];
    let q = Point::new(1.0, 2.0, 3.0);
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        let p = Point::new(bad, 0.0, 0.0);
        let pair = PointPair::through(p, q);
        assert_eq!(
            (pair.kind(1e-12), pair.endpoints(), pair.centre()),
            (Kind::NotABlade, None, None)
        );
        assert!(pair.radius().is_none() && pair.container().is_none());
        assert_eq!(
            PointPair::from_centre_axis_radius_squared(p, axis, 1.0),
            None
        );
        assert_eq!(
            Circle::from_centre_normal_radius_squared(p, axis, 1.0),
            None
        );
        assert_eq!(
            Circle::through(p, q, Point::default()).kind(1e-12),
            Kind::NotABlade
        );
        assert_eq!(
            Sphere::from_centre_radius(p, 1.0).kind(1e-12),
            Kind::NotABlade
        );
        assert_eq!(PointPair::tangent(q, [bad, 0.0, 0.0]), None);
        assert_eq!(Line::from_direction_moment([bad, 0.0, 0.0], [0.0; 3]), None);
        assert_eq!(Line::from_direction_moment(axis, [bad, 0.0, 0.0]), None);
        assert_eq!(Circle::tangent(q, [0.0, bad, 0.0]), None);
    }
    // The square of a distance of 1e200 is beyond the range, the centre of a round is not.
    let far = Point::new(1e200, 0.0, 0.0);
    let sphere = Sphere::from_centre_radius(far, 1.0);
    assert_eq!((sphere.centre(), sphere.radius()), (Some(far), Some(1.0)));
    assert_eq!(PointPair::through(far, q).endpoints(), None);
    assert_eq!(PointPair::through(far, q).centre(), None);
    assert_eq!(
        PointPair::tangent(Point::new(1.0, 2.0, 3.0), [0.0; 3]),
        None
    );
    assert_eq!(Line::from_direction_moment([0.0; 3], [1.0, 0.0, 0.0]), None);
}

#[test]
fn single_precision_far_from_the_origin() {
    let (p, q) = (
        Point::new(1e4_f32, 5e3, -1e4),
        Point::new(1e4 + 1.0, 5e3, -1e4),
    );
    let pair = PointPair::through(p, q);
    assert_eq!(pair.attitude().vector(), [1.0, 0.0, 0.0]);
    let centre = pair.centre().expect("a pair").coordinates();
    assert_eq!(centre, [1e4 + 0.5, 5e3, -1e4]);
    assert_eq!(pair.endpoints(), Some([p, q]));
}
