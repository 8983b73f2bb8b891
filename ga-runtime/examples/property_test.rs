//! Property tests as a crate that uses ga-runtime would write them: with the dense reference,
//! the exact scalar and the strategies of `ga_runtime::testing`.
//!
//! In such a crate the functions below would be in `tests/` under `#[test]`, with these
//! lines in Cargo.toml:
//!
//! ```toml
//! [dev-dependencies]
//! ga-runtime = { version = "0.1", features = ["testing"] }
//! ```
//!
//! Run it with `cargo run -p ga-runtime --example property_test --features testing`.

use ga_runtime::Element;
use ga_runtime::cga3::{Plane, Point};
use ga_runtime::scalar::Prime61;
use ga_runtime::testing::{algebra_of, assert_close, cga3, exact_member, for_all, to_dense};

ga_runtime::algebra! {
    /// The projective algebra of the plane, where lines are vectors and points are bivectors.
    mod pga2 {
        basis e1, e2, e0;
        signature 2, 0, 1;
        /// The line `a x + b y + c = 0`.
        struct Line { e1, e2, e0 }
        /// A point with a weight.
        struct Point { e12, e10, e20 }
        products {
            wedge(Line, Line) -> Point;
            left_contraction(Line, Point) -> Line;
        }
    }
}

// One line tests every declared product against the dense reference, exactly.
#[cfg(test)]
mod declared {
    ga_runtime::testing::product_tests!(super::pga2);
}

// The functions to test.
ga_runtime::ga! { pga2;
    /// The foot of the perpendicular from a point to a line, times the line's square.
    fn foot(point: Point, line: Line) -> Point { (line | point) ^ line }
}
ga_runtime::ga! { ga_runtime::cga3;
    /// The mirror image of a point in a plane, as a point with a weight.
    fn mirrored(plane: Plane, point: Point) -> RoundVector { sandwich(dual(plane), point) }
}

/// A compiled function equals its formula, evaluated by the reference algebra, which shares no code
/// with the compiler. Over the prime field nothing is rounded, so the two are exactly equal.
#[cfg_attr(test, test)]
fn compiled_function_equals_its_formula() {
    let algebra = algebra_of::<Prime61>(<pga2::Line<Prime61> as Element>::METRIC);
    let operands = (
        exact_member::<pga2::Point<_>>(),
        exact_member::<pga2::Line<_>>(),
    );
    for_all(operands, |(point, line)| {
        let (p, l) = (to_dense(&algebra, &point), to_dense(&algebra, &line));
        assert_eq!(to_dense(&algebra, &foot(point, line)), (&l | &p) ^ &l);
    });
}

/// The foot of the perpendicular is on the line. A line l and a point P are incident where `l ∧ P`
/// is zero.
#[cfg_attr(test, test)]
fn foot_is_on_the_line() {
    let algebra = algebra_of::<Prime61>(<pga2::Line<Prime61> as Element>::METRIC);
    let operands = (
        exact_member::<pga2::Point<_>>(),
        exact_member::<pga2::Line<_>>(),
    );
    for_all(operands, |(point, line)| {
        let incidence = to_dense(&algebra, &line) ^ to_dense(&algebra, &foot(point, line));
        assert_eq!(incidence, algebra.zero());
    });
}

/// In floating point, with random points and planes and with special positions: the image is as far
/// behind the plane as the point is in front of it, on the same perpendicular.
#[cfg_attr(test, test)]
fn mirror_image_is_across_the_plane() {
    let operands = (cga3::planes(10.0), cga3::points(10.0));
    for_all(operands, |(plane, point): (Plane<f64>, Point<f64>)| {
        let image = mirrored(plane, point)
            .centre()
            .expect("a plane has a weight");
        let [before, behind] =
            [point, image].map(|p| plane.signed_distance(p).expect("a plane has a weight"));
        // Relative to the size of the configuration, since a distance may be zero.
        assert_close!(behind, -before, 1e-12, 20.0);
        assert_close!(point.distance(image), 2.0 * before.abs(), 1e-12, 20.0);
    });
}

fn main() {
    let tests: [(&str, fn()); 3] = [
        (
            "a compiled function equals its formula",
            compiled_function_equals_its_formula,
        ),
        ("the foot is on the line", foot_is_on_the_line),
        (
            "a mirror image is on the other side of the plane",
            mirror_image_is_across_the_plane,
        ),
    ];
    for (name, test) in tests {
        test();
        println!("{name}: holds");
    }
}
