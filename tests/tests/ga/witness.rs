//! How the compiler decides that a result is of a type: independent of which random points it
//! draws.

use ga_runtime::cga3::{Point, Quaternion};
use ga_runtime::testing::assert_close;

mod compiled {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        /// Twelve roots, each of which half of all residues do not have.
        pub fn distances(q: Point, p: [Point; 12]) -> [Scalar; 12] {
            [
                between(q, p[0]), between(q, p[1]), between(q, p[2]), between(q, p[3]),
                between(q, p[4]), between(q, p[5]), between(q, p[6]), between(q, p[7]),
                between(q, p[8]), between(q, p[9]), between(q, p[10]), between(q, p[11]),
            ]
        }
        fn between(p: Point, q: Point) -> Scalar { sqrt(-2 * (p | q)) }

        /// A sum of squares has a root, so the quotient is a unit versor.
        pub fn by_the_norm(q: Quaternion) -> Rotor { q / norm(q) }
        pub fn by_the_root(q: Quaternion) -> Rotor { q / sqrt(q.scalar * q.scalar - (grade(q, 2) | grade(q, 2))) }

        /// 3 and −2 have no roots among the residues.
        pub fn roots(a: Scalar) -> Scalar { a * sqrt(3) + sqrt(abs(-2)) }
        pub fn constants(a: Scalar) -> Scalar { a * abs(-0.5) + abs(3 - 10) * norm(2 * e12) + abs(0 * a) + sqrt(4) }
    }
}

#[test]
fn many_roots_may_be_drawn() {
    let p = std::array::from_fn(|k| Point::new(f64::from(u8::try_from(k).unwrap_or(0)), 0.0, 0.0));
    let truth: [f64; 12] = std::array::from_fn(|k| f64::from(u8::try_from(k).unwrap_or(0)));
    assert_eq!(compiled::distances(Point::new(0.0, 0.0, 0.0), p), truth);
}

#[test]
fn quaternions_over_their_norm_are_rotors() {
    let q = Quaternion::new(1.0, 2.0, 4.0, 2.0);
    for r in [compiled::by_the_norm(q), compiled::by_the_root(q)] {
        assert_close!(
            [r.scalar(), r.e12(), r.e13(), r.e23()],
            [0.2, 0.4, 0.8, 0.4],
            1e-15
        );
    }
}

#[test]
fn functions_of_constants() {
    assert_eq!(compiled::constants(3.0), 1.5 + 14.0 + 2.0);
    assert_close!(
        compiled::roots(2.0),
        2.0 * 3.0_f64.sqrt() + 2.0_f64.sqrt(),
        1e-15
    );
}
