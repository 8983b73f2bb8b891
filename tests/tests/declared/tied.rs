//! Motors in an orthogonal conformal basis, whose blades with ep and em are tied to each other.

use ga_runtime::testing::assert_close;
use orthogonal::{Even, Motor, Point};

ga_runtime::algebra! {
    /// Conformal space with ep² = 1 and em² = −1, where infinity is ep + em.
    mod orthogonal {
        basis e1, e2, e3, ep, em;
        signature 4, 1;

        /// A point.
        #[hull(Round)]
        #[facts(null)]
        struct Point {
            e1, e2, e3,
            ep = (e1*e1 + e2*e2 + e3*e3 - 1)/2,
            em = (e1*e1 + e2*e2 + e3*e3 + 1)/2
        }
        /// A vector.
        struct Round { e1, e2, e3, ep, em }
        /// A rigid motion.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Motor {
            scalar, e12, e13, e23, e1p, e2p, e3p, e123p,
            e1m = e1p, e2m = e2p, e3m = e3p, e123m = e123p
        }
        /// Sums of motions.
        struct Even { scalar, e12, e13, e23, e1p, e2p, e3p, e123p, e1m, e2m, e3m, e123m }

        products {
            geometric(Motor, Motor) -> Self;
            sandwich(Motor, Point) -> Self;
        }
    }
}

#[test]
fn motions_move_points() {
    // 1 − t ei/2 translates by t = (2, 4, −6).
    let translation = Motor::try_new(1.0, 0.0, 0.0, 0.0, -1.0, -2.0, 3.0, 0.0, 1e-15);
    let translation = translation.expect("a unit versor");
    let half = 0.5_f64.sqrt();
    // By 90° from e1 to e2.
    let rotation = Motor::try_new(half, -half, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-15);
    let rotation = rotation.expect("a unit versor");
    let motion = translation * rotation;
    let p = motion.sandwich(Point::new(1.0, 0.0, 5.0));
    assert_close!([p.e1(), p.e2(), p.e3()], [2.0, 5.0, -1.0], 1e-15);
    let [whole, other]: [Even<f64>; 2] = [motion.into(), motion.inverse().into()];
    assert_close!([whole.e1m, other.e2m], [whole.e1p, other.e2p], 1e-15);
    assert_eq!(
        Motor::try_new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1e-9),
        None
    );
}
