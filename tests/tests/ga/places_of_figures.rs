//! `point` and `endpoints`: exactly over the prime field against figures built around known places,
//! and over f64 against plain coordinates.

use ga_runtime::Element;
use ga_runtime::cga3::{Circle, FlatPoint, Infinity, Point, RoundVector, Sphere};
use ga_runtime::scalar::{Field, Lanes};
use ga_runtime::testing::{Prime61, assert_close, exact_member, for_all};

mod compiled {
    #![deny(warnings)]
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        pub fn of_point(p: Point) -> Point { point(p) }
        pub fn of_vector(v: RoundVector) -> Point { point(v) }
        pub fn of_flat_point(f: FlatPoint) -> Point { f.point() }
        pub fn of_sphere(s: Sphere) -> Point { point(s) }
        pub fn of_circle(c: Circle) -> Point { point(c) }
        pub fn of_pair(p: PointPair) -> Point { point(p) }
        pub fn met(l: Line, e: Plane) -> Point { point(l & e) }
        /// The place of a moved point is the moved point; nothing is divided.
        pub fn moved(m: Motor, p: Point) -> Point { point(sandwich(m, p)) }
        /// A point may be used further as one.
        pub fn distance_squared(v: RoundVector, p: Point) -> Scalar { -2 * (point(v) | p) }
        pub fn ends(p: PointPair) -> (Point, Point) { endpoints(p) }
        pub fn hits(l: Line, s: Sphere) -> (Point, Point) { let (a, b) = endpoints(l & s); (a, b) }
        pub fn second(p: PointPair) -> Point { endpoints(p).1 }
        pub fn of_product(a: Point, b: Point, w: Scalar) -> [Point; 2] {
            let (first, second) = (w * (a ^ b)).endpoints();
            [first, second]
        }
    }
}

/// The same model with its vectors in another order, under other names and signs, another weight
/// and another scale: (n·o) = 2.
mod renamed {
    ga_runtime::algebra! {
        pub(crate) mod space {
            basis vn, va, vo, vb;
            metric va*va = 1, vb*vb = 4, vn*vo = 2;

            #[hull(Round)]
            struct Spot { vb, va, vn = (va*va + 4*vb*vb)/-12, vo = 3 }
            struct Round { vn, va, vo, vb }
            struct Pair { vna, vno, vnb, vao, vab, vob }
        }
    }

    ga_runtime::ga! { space;
        pub(crate) fn of_round(v: Round) -> Spot { point(v) }
        pub(crate) fn of_flat(a: Spot, w: Scalar) -> Spot { point((w * a) ^ vn) }
        pub(crate) fn of_pair(a: Spot, b: Spot, w: Scalar) -> Spot { point(w * (a ^ b)) }
        pub(crate) fn ends(p: Pair) -> [Spot; 2] { let (a, b) = endpoints(p); [a, b] }
        pub(crate) fn pair(a: Spot, b: Spot) -> Pair { a ^ b }
    }
}

/// The model in an orthogonal basis, where both further coefficients are derived.
mod orthogonal {
    ga_runtime::algebra! {
        pub(crate) mod plane {
            basis e1, e2, ep, em;
            signature 3, 1, 0;

            /// x + (x² − 1)/2 ep + (x² + 1)/2 em.
            #[hull(Round)]
            struct Place { e1, e2, ep = (e1*e1 + e2*e2 - 1)/2, em = (e1*e1 + e2*e2 + 1)/2 }
            struct Round { e1, e2, ep, em }
            struct Pair { e12, e1p, e2p, e1m, e2m, epm }
            struct Circle { e12p, e12m, e1pm, e2pm }
        }
    }

    ga_runtime::ga! { plane;
        pub(crate) fn of_round(v: Round) -> Place { point(v) }
        pub(crate) fn of_circle(c: Circle) -> Place { point(c) }
        pub(crate) fn of_pair(a: Place, b: Place, w: Scalar) -> Place { point(w * (a ^ b)) }
        pub(crate) fn of_flat(a: Place, w: Scalar) -> Place { point((w * a) ^ (ep + em)) }
        pub(crate) fn ends(a: Place, b: Place, w: Scalar) -> (Place, Place) { endpoints(w * (a ^ b)) }
        pub(crate) fn circle(a: Place, b: Place, c: Place) -> Circle { a ^ b ^ c }
    }
}

type Exact = Prime61;

#[test]
fn vectors_and_flat_points() {
    let operands = (exact_member::<Point<_>>(), exact_member::<RoundVector<_>>());
    for_all(operands, |(p, v): (Point<Exact>, RoundVector<Exact>)| {
        assert_eq!(compiled::of_point(p), p);
        // w p + α ei, with α and w from the other vector.
        let round = RoundVector::from(p) * v.eo + infinity(v.ei);
        if v.eo.is_invertible() {
            assert_eq!(compiled::of_vector(round), p);
            let flat: FlatPoint<Exact> = (p ^ Infinity) * v.eo;
            assert_eq!(compiled::of_flat_point(flat), p);
            let q = Point::new(v.e1, v.e2, v.e3);
            let difference = p.e1() - v.e1;
            let [dy, dz] = [p.e2() - v.e2, p.e3() - v.e3];
            let truth = difference * difference + dy * dy + dz * dz;
            assert_eq!(compiled::distance_squared(round, q), truth);
        }
    });
}

/// The round that a sum is.
fn from_sum<T: Element<Scalar = Exact>>(sum: impl Element<Scalar = Exact>) -> T {
    T::from_coefficients_unchecked(&mut |blade| sum.coefficient(blade))
}

#[test]
fn rounds_have_their_centres() {
    let operands = (
        exact_member::<Point<_>>(),
        exact_member::<RoundVector<_>>(),
        exact_member::<RoundVector<_>>(),
    );
    for_all(
        operands,
        |(c, v, u): (Point<Exact>, RoundVector<Exact>, RoundVector<Exact>)| {
            if !v.eo.is_invertible() || !u.e1.is_invertible() {
                return;
            }
            // The dual sphere about c, times a weight, and a plane through c.
            let dual = RoundVector::from(c) * v.eo + infinity(v.ei);
            let sphere: Sphere<Exact> = from_sum(dual.undual());
            assert_eq!(compiled::of_sphere(sphere), c);
            let through = |n: RoundVector<Exact>| {
                let distance = n.e1 * c.e1() + n.e2 * c.e2() + n.e3 * c.e3();
                RoundVector::new(n.e1, n.e2, n.e3, Exact::from(0), distance)
            };
            let circle: Circle<Exact> = from_sum((dual ^ through(u)).undual());
            assert_eq!(compiled::of_circle(circle), c);
            // The dual of a circle has its centre, too.
            assert_eq!(compiled::of_pair(from_sum(dual ^ through(u))), c);
        },
    );
    // The middle of two points.
    for_all(
        (exact_member::<Point<_>>(), exact_member::<Point<_>>()),
        |(p, q): (Point<Exact>, Point<Exact>)| {
            if p != q {
                let half = Exact::from_ratio(1, 2);
                let middle = [p.e1() + q.e1(), p.e2() + q.e2(), p.e3() + q.e3()];
                let middle = Point::from(middle.map(|x| x * half));
                assert_eq!(compiled::of_pair(p ^ q), middle);
                assert_eq!(compiled::of_pair((q ^ p) * Exact::from(7)), middle);
            }
        },
    );
}

/// A multiple of the vector of infinity.
fn infinity(factor: Exact) -> RoundVector<Exact> {
    let zero = Exact::from(0);
    RoundVector::new(zero, zero, zero, zero, factor)
}

#[test]
fn a_line_meets_a_plane_in_a_point() {
    let [a, b] = [[1.0, 2.0, 3.0], [3.0, 2.0, 7.0]].map(Point::from);
    let plane = Point::new(0.0, 0.0, 5.0) ^ Point::new(1.0, 0.0, 5.0) ^ Point::new(0.0, 1.0, 5.0);
    let (line, plane) = (a ^ b ^ Infinity, plane ^ Infinity);
    assert_close!(compiled::met(line, plane), Point::new(2.0, 2.0, 5.0), 1e-12);
}

#[test]
fn pairs_have_their_ends_in_order() {
    for (a, b) in [
        ([1.0, 2.0, 3.0], [4.0, -2.0, 3.0]),
        ([0.0; 3], [1.0, 0.0, 0.0]),
        ([-3.0, 5.0, 0.5], [0.25, 0.0, 1.0]),
    ] {
        let (a, b) = (Point::from(a), Point::from(b));
        for weight in [1.0, 0.25, 8.0] {
            let (first, second) = compiled::ends((a ^ b) * weight);
            assert_close!(first, a, 1e-12);
            assert_close!(second, b, 1e-12);
            let (first, second) = compiled::ends((a ^ b) * -weight);
            assert_close!(first, b, 1e-12);
            assert_close!(second, a, 1e-12);
            let [first, second] = compiled::of_product(a, b, weight);
            assert_close!(first, a, 1e-12);
            assert_close!(second, b, 1e-12);
            assert_close!(compiled::second((a ^ b) * weight), b, 1e-12);
        }
        // As the library has them.
        let [first, second] = (a ^ b).endpoints().expect("two points");
        assert_close!(first, a, 1e-12);
        assert_close!(second, b, 1e-12);
    }
}

#[test]
fn lines_enter_and_leave_spheres() {
    let sphere = Sphere::from_centre_radius_squared(Point::new(0.0, 0.0, 5.0), 9.0);
    let along = |x: f64| Point::new(x, 0.0, 0.0) ^ Point::new(x, 0.0, 1.0) ^ Infinity;
    let (leaves, enters) = compiled::hits(along(0.0), sphere);
    let heights = [enters.e3(), leaves.e3()];
    assert!((heights[0] - 2.0).abs() < 1e-12 && (heights[1] - 8.0).abs() < 1e-12);
    // A line that misses has no real ends.
    let (missed, _) = compiled::hits(along(4.0), sphere);
    assert!(missed.e3().is_nan());
    // A tangent has the same point twice.
    let tangent = compiled::hits(along(3.0), sphere);
    assert_close!(tangent.0, Point::new(3.0, 0.0, 5.0), 1e-12);
    assert_close!(tangent.1, Point::new(3.0, 0.0, 5.0), 1e-12);
    // In lanes.
    let lanes = |values: [f64; 2]| Lanes::from_array(values);
    let zero = Lanes::splat(0.0);
    let pair =
        Point::new(lanes([1.0, 2.0]), zero, zero) ^ Point::new(zero, lanes([3.0, 4.0]), zero);
    let (first, second) = compiled::ends(pair);
    assert_close!(first.e1().to_array()[1], 2.0, 1e-12);
    assert_close!(second.e2().to_array()[0], 3.0, 1e-12);
}

#[test]
fn other_names_and_weights_do_as_well() {
    use renamed::space::{Round, Spot};
    let operands = (exact_member::<Spot<_>>(), exact_member::<Round<_>>());
    for_all(operands, |(p, v): (Spot<Exact>, Round<Exact>)| {
        let q = Spot::new(v.vb, v.va);
        if !v.vo.is_invertible() || p == q {
            return;
        }
        let round = Round::new(
            p.vn() * v.vo + v.vn,
            p.va() * v.vo,
            p.vo() * v.vo,
            p.vb() * v.vo,
        );
        assert_eq!(renamed::of_round(round), p);
        assert_eq!(renamed::of_flat(p, v.vo), p);
        let half = Exact::from_ratio(1, 2);
        let middle = Spot::new((p.vb() + q.vb()) * half, (p.va() + q.va()) * half);
        assert_eq!(renamed::of_pair(p, q, v.vo), middle);
    });
    let (a, b) = (Spot::new(1.0_f64, 2.0), Spot::new(-0.5, 3.0));
    let [first, second] = renamed::ends(renamed::pair(a, b));
    for (found, truth) in [(first, a), (second, b)] {
        let error = (found.va() - truth.va()).abs() + (found.vb() - truth.vb()).abs();
        assert!(error < 1e-12, "{found:?}");
    }
}

#[test]
fn an_orthogonal_basis_does_as_well() {
    use orthogonal::plane::{Place, Round};
    let (a, b, c) = (
        Place::new(1.0, 2.0),
        Place::new(4.0, -2.0),
        Place::new(-2.5, -1.5),
    );
    let close = |found: Place<f64>, x: f64, y: f64| {
        assert!(
            (found.e1() - x).abs() < 1e-12 && (found.e2() - y).abs() < 1e-12,
            "{found:?}"
        );
    };
    for weight in [1.0, 3.0, -0.5] {
        close(orthogonal::of_pair(a, b, weight), 2.5, 0.0);
        close(orthogonal::of_flat(a, weight), 1.0, 2.0);
        let (mut first, mut second) = orthogonal::ends(a, b, weight);
        if weight < 0.0 {
            std::mem::swap(&mut first, &mut second);
        }
        close(first, 1.0, 2.0);
        close(second, 4.0, -2.0);
        // w (P + α N) with N = ep + em.
        let round = Round::new(a.e1(), a.e2(), a.ep() + 0.7, a.em() + 0.7) * weight;
        close(orthogonal::of_round(round), 1.0, 2.0);
    }
    // The circle about (1, −2) with radius 3 does not go through the points; that through them has
    // its centre at the same distance from each.
    let centre = orthogonal::of_circle(orthogonal::circle(a, b, c));
    let distance = |p: Place<f64>| (p.e1() - centre.e1()).hypot(p.e2() - centre.e2());
    assert!((distance(a) - distance(b)).abs() < 1e-12);
    assert!((distance(a) - distance(c)).abs() < 1e-12);
}
