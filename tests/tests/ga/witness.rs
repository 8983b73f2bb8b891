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

        /// Twenty-one roots over seven operands: no point is found at which all are residues.
        pub fn all_pairs(p: [Point; 7]) -> [Scalar; 21] {
            [
                between(p[0], p[1]), between(p[0], p[2]), between(p[0], p[3]), between(p[0], p[4]),
                between(p[0], p[5]), between(p[0], p[6]), between(p[1], p[2]), between(p[1], p[3]),
                between(p[1], p[4]), between(p[1], p[5]), between(p[1], p[6]), between(p[2], p[3]),
                between(p[2], p[4]), between(p[2], p[5]), between(p[2], p[6]), between(p[3], p[4]),
                between(p[3], p[5]), between(p[3], p[6]), between(p[4], p[5]), between(p[4], p[6]),
                between(p[5], p[6]),
            ]
        }

        /// Eighteen roots over one operand, and the last step needs the squares of them.
        pub fn product_of_roots(a: Scalar) -> Rotor {
            let r = sqrt(a + 1) * sqrt(a + 2) * sqrt(a + 3) * sqrt(a + 4) * sqrt(a + 5) * sqrt(a + 6);
            let s = sqrt(a + 7) * sqrt(a + 8) * sqrt(a + 9) * sqrt(a + 10) * sqrt(a + 11) * sqrt(a + 12);
            let t = sqrt(a + 13) * sqrt(a + 14) * sqrt(a + 15) * sqrt(a + 16) * sqrt(a + 17);
            let x = r * s * t;
            (x + e12) / sqrt(x * x + 1)
        }

        /// A root of a root, besides others.
        pub fn nested(a: Scalar) -> Scalar {
            sqrt(1 + sqrt(2 + sqrt(3 + a))) * sqrt(3)
        }

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
fn roots_of_shared_operands_need_no_point_where_all_are_residues() {
    let p: [_; 7] =
        std::array::from_fn(|k| Point::new(f64::from(u8::try_from(k * k).unwrap_or(0)), 0.0, 0.0));
    let mut truth = Vec::new();
    for i in 0..7_i32 {
        truth.extend((i + 1..7).map(|j| f64::from(j * j - i * i)));
    }
    assert_eq!(compiled::all_pairs(p).to_vec(), truth);

    // The product of 1 … 17 under the root.
    let x = (1..=17).map(f64::from).product::<f64>().sqrt();
    let r = compiled::product_of_roots(0.0);
    let size = x.hypot(1.0);
    assert_close!([r.scalar(), r.e12()], [x / size, 1.0 / size], 1e-14);
    assert_close!(
        compiled::nested(1.0),
        (1.0 + 2.0_f64).sqrt() * 3.0_f64.sqrt(),
        1e-14
    );
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
