//! The two angles of two circles: against tangents, blades, and maps that keep them.

use std::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::{Circle, Infinity, Line, Multivector, Point, Transversor};
use ga_runtime::geometry::relation::CircleAngles;
use nullcone_tests::plain::*;
use proptest::prelude::*;

/// The cosines, the first at least zero; above 1 for circles that are apart.
fn cosines(a: Circle<f64>, b: Circle<f64>) -> [f64; 2] {
    match a.angle_to(b).expect("two circles") {
        CircleAngles::Linked(angles) => angles.map(f64::cos),
        CircleAngles::Apart { distance, angle } => [distance.cosh(), angle.cos()],
    }
}

fn linked(a: Circle<f64>, b: Circle<f64>) -> [f64; 2] {
    match a.angle_to(b) {
        Some(CircleAngles::Linked(angles)) => angles,
        other => panic!("{other:?}"),
    }
}

fn apart(a: Circle<f64>, b: Circle<f64>) -> [f64; 2] {
    match a.angle_to(b) {
        Some(CircleAngles::Apart { distance, angle }) => [distance, angle],
        other => panic!("{other:?}"),
    }
}

/// The circle through x with a unit tangent there, and its centre in a direction that need not be
/// perpendicular to it.
fn through(x: Vector, tangent: Vector, towards: Vector, r: f64) -> Circle<f64> {
    let arm = unit_of(along(towards, -dot(towards, tangent), tangent));
    circle(along(x, r, arm), cross(tangent, arm), r)
}

proptest! {
    /// The invariants of the unit dual blades, which are products of cosines and of sines.
    #[test]
    fn both_angles_are_those_of_the_blades(
        c in vector(3.0), d in vector(3.0), n in unit(), m in unit(), r in 0.3..3.0_f64, s in 0.3..3.0_f64,
    ) {
        let (a, b) = (circle(c, n, r), circle(d, m, s));
        let unit = |circle: Circle<f64>| {
            let dual = Multivector::from(circle.dual());
            dual * (-dual.scalar_product(dual)).sqrt().recip()
        };
        let (x, y) = (unit(a), unit(b));
        let wedge = x ^ y;
        let [first, second] = cosines(a, b);
        let size = first.abs().max(1.0);
        near(first * second, -x.scalar_product(y), 1e-9 * size);
        let sines = (1.0 - first * first) * (1.0 - second * second);
        near(sines, wedge.scalar_product(wedge), 1e-8 * size * size);
        prop_assert!(first >= second.abs() - 1e-12);
        // Symmetric, by dual forms too, and the opposite circle has the supplement as the second.
        near_all(cosines(b, a), [first, second], 1e-10 * size);
        prop_assert_eq!(a.dual().angle_to(b), a.angle_to(b));
        prop_assert_eq!(a.angle_to(b.dual()), a.angle_to(b));
        near_all(cosines(-a, b), [first, -second], 1e-10 * size);
    }

    /// Circles through a point: the angle of their tangents.
    #[test]
    fn crossing_circles_have_the_angle_of_their_tangents(
        x in vector(2.0), u in unit(), v in unit(), to in unit(), other in unit(), r in 0.3..3.0_f64, s in 0.3..3.0_f64,
    ) {
        prop_assume!(length(cross(u, to)) > 0.1 && length(cross(v, other)) > 0.1);
        let (a, b) = (through(x, u, to, r), through(x, v, other, s));
        let angle = length(cross(u, v)).atan2(dot(u, v));
        prop_assume!(angle > 0.05 && angle < PI - 0.05);
        let [first, second] = cosines(a, b);
        near(first, 1.0, 1e-10);
        near(second, angle.cos(), 1e-9);
    }

    /// A special conformal map, a translation and a rotation keep both angles.
    #[test]
    fn conformal_maps_keep_them(
        c in vector(2.0), d in vector(2.0), n in unit(), m in unit(), r in 0.3..2.0_f64, s in 0.3..2.0_f64, k in vector(0.3),
    ) {
        let map = Transversor::from_vector(k);
        let image = |centre: Vector, normal: Vector, radius: f64| {
            let points = [0.0, 2.0, 4.0].map(|angle| {
                let image = map.transform(point(on_circle(centre, normal, radius, angle)));
                image.centre().expect("a finite point")
            });
            Circle::through(points[0], points[1], points[2])
        };
        let found = cosines(image(c, n, r), image(d, m, s));
        let expected = cosines(circle(c, n, r), circle(d, m, s));
        near_all(found, expected, 1e-7 * expected[0].max(1.0).powi(2));
    }

    /// Circles about one axis: cosh d = (r² + s² + h²)/(2 r s), from the half plane of r and h.
    #[test]
    fn circles_about_one_axis_have_the_distance_of_the_half_plane(
        c in vector(3.0), n in unit(), r in 0.3..3.0_f64, s in 0.3..3.0_f64, h in -3.0..3.0_f64,
    ) {
        let (a, b) = (circle(c, n, r), circle(along(c, h, n), n, s));
        let cosine = (r * r + s * s + h * h) / (2.0 * r * s);
        prop_assume!(cosine > 1.001);
        let [distance, angle] = apart(a, b);
        near(distance.cosh(), cosine, 1e-10 * cosine);
        near(angle, 0.0, 1e-5);
        near(apart(a, -b)[1], PI, 1e-5);
    }
}

#[test]
fn links_of_a_chain() {
    let ring = circle(O, Z, 1.0);
    near_all(
        linked(ring, circle(X, Y, 1.0)),
        [PI / 3.0, FRAC_PI_2],
        1e-15,
    );
    // Great circles of the 3-sphere in stereographic projection: the unit ring is the plane of the
    // first two axes. The image of another plane, spanned by (cos α, 0, sin α, 0) and
    // (0, cos β, 0, sin β), is the circle through the images of three of its points.
    for [alpha, beta] in [[0.3_f64, 0.7], [0.5, 0.5], [0.2, 1.5], [1.0, 2.0]] {
        let on = |angle: f64| {
            let (sine, cosine) = angle.sin_cos();
            let below = 1.0 - beta.sin() * sine;
            let place = [
                alpha.cos() * cosine,
                beta.cos() * sine,
                alpha.sin() * cosine,
            ];
            Point::from(place.map(|x| x / below))
        };
        let other = Circle::through(on(0.1), on(2.0), on(4.0));
        near_all(linked(ring, other), [alpha, beta], 1e-12);
    }
}

#[test]
fn special_positions() {
    let ring = circle(O, Z, 1.0);
    // The same, and the opposite orientation.
    assert_eq!(linked(ring, ring), [0.0, 0.0]);
    near_all(linked(ring, -ring), [0.0, PI], 1e-15);
    // Tangent in a plane, from outside: the tangents point opposite ways.
    near_all(
        linked(ring, circle([3.0, 0.0, 0.0], Z, 2.0)),
        [0.0, PI],
        1e-7,
    );
    near_all(
        linked(ring, circle([-1.0, 0.0, 0.0], Z, 2.0)),
        [0.0, 0.0],
        1e-7,
    );
    // Crossing at right angles in a plane, and in two.
    near_all(
        linked(ring, circle([2.0_f64.sqrt(), 0.0, 0.0], Z, 1.0)),
        [0.0, FRAC_PI_2],
        1e-7,
    );
    near_all(linked(ring, circle(O, X, 1.0)), [0.0, FRAC_PI_2], 1e-15);
    // Concentric, and side by side: Coxeter's inversive distance.
    near_all(apart(ring, circle(O, Z, 2.0)), [2.0_f64.ln(), 0.0], 1e-15);
    let side = apart(ring, circle([4.0, 0.0, 0.0], Z, 1.0));
    near_all(side, [7.0_f64.acosh(), PI], 1e-12);
    // Nearly the same: the distance keeps its digits.
    let close = apart(ring, circle(O, Z, 1.0 + 1e-6));
    near(close[0] / 1e-6, 1.0, 1e-5);
    // Far from the origin they still touch.
    let far = |x: f64| circle([1e4 + x, 1e4, 0.0], Z, 1.0);
    near_all(linked(far(0.0), far(2.0)), [0.0, PI], 1e-2);
}

#[test]
fn what_is_not_a_circle_has_no_two_angles() {
    let ring = circle(O, Z, 1.0);
    assert_eq!(ring.angle_to(circle(O, X, 0.0)), None);
    assert_eq!(circle(O, X, 0.0).angle_to(ring), None);
    assert_eq!(ring.angle_to(circle_of_square(O, X, -1.0)), None);
    let line: Line<f64> = point(O) ^ Point::new(1.0, 0.0, 0.0) ^ Infinity;
    assert_eq!(ring.angle_to(ring * 0.0), None);
    // Between a line or a plane and a circle there is one angle.
    near(ring.angle_to(line).unwrap(), 0.0, 0.0);
    near(line.angle_to(ring).unwrap(), 0.0, 0.0);
    near(ring.angle_to(plane(O, X)).unwrap(), FRAC_PI_2, 1e-15);
}
