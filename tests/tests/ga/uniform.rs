//! Uniform operands: a struct holds the work on them, and its method does the rest.

use ga_runtime::cga3::{Motor, Point, Quadvector, Rotor, RoundVector, Translator};
use ga_runtime::scalar::{Dual, Lanes};
use ga_runtime::testing::{assert_close, exact_member, for_all, member, strategy};

mod compiled {
    #![deny(warnings, missing_docs)]
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        /// A motion of points.
        pub fn moving(uniform m: Motor, p: Point) -> Point { m * p * reverse(m) }
        /// The same without a uniform operand.
        pub fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }
        /// There may be several uniform operands, in any place.
        pub fn scaled_join(a: Quadvector, uniform n: Scalar, b: Quadvector, uniform c: [RoundVector; 2]) -> (Quadvector, Scalar) {
            let part = (c[0] | c[1]) * (n + 1);
            (part * a - b, (dual(b) | c[0]) + n * n)
        }
        /// The uniform operand needs no work of its own.
        pub fn untouched(uniform n: Scalar, x: Scalar) -> Scalar { x + n }
        /// All operands uniform.
        pub fn all_of_it(uniform n: Scalar, uniform m: Scalar) -> Scalar { n * m + 1 }
        /// A name of several words, as a raw identifier; the operand `uniform` is not a mark.
        pub fn r#match(uniform uniform: Scalar, x: Scalar) -> Scalar { uniform * uniform * x }
        /// An operand named `uniform` without a mark.
        pub fn plain(uniform: Scalar) -> Scalar { uniform + 1 }
        /// A function with uniform operands may be called by another of the block.
        pub fn calling(m: Motor, p: Point) -> Scalar { moving(m, p) | eo }
    }
}

#[test]
fn stages_together_are_the_function() {
    for_all(
        (exact_member::<Motor<_>>(), exact_member::<Point<_>>()),
        |(m, p)| {
            assert_eq!(compiled::moving(m).apply(p), compiled::moved(m, p));
            assert_eq!(compiled::moving(m).apply(p), m.transform(p));
            assert_eq!(compiled::calling(m, p), m.transform(p).ei() * (-1).into());
        },
    );
    let a = Quadvector::new(1, 2, 3, 4, 5);
    let b = Quadvector::new(2, 0, 1, -1, 3);
    let c = [
        RoundVector::new(1, 2, 3, 1, 0),
        RoundVector::new(2, 2, 2, 0, 1),
    ];
    // (e1 + 2 e2 + 3 e3 + eo) · (2 e1 + 2 e2 + 2 e3 + ei) = 12 − 1.
    let (sphere, _) = compiled::scaled_join(4, c).apply(a, b);
    assert_eq!(sphere, a * 55 - b);
    assert_eq!(compiled::untouched(3).apply(4), 7);
    assert_eq!(compiled::all_of_it(3, 4).apply(), 13);
    assert_eq!(compiled::r#match(3).apply(4), 36);
    assert_eq!(compiled::plain(3), 4);
}

#[test]
fn the_scalar_of_a_stage_may_change() {
    let motor: Motor<f64> = Translator::from_displacement([1.0, 2.0, 3.0])
        * Rotor::from_axis_angle([1.0, 1.0, 0.0], 0.7).expect("an axis");
    let moving = compiled::moving(motor);
    let points = [[1.0, 0.5, 2.0], [0.0, -3.0, 1.0]];
    let lanes = moving.map(|x| Lanes::from_array([x, x]));
    let coordinate = |k: usize| Lanes::from_array(points.map(|p| p[k]));
    let moved = lanes.apply(Point::new(coordinate(0), coordinate(1), coordinate(2)));
    let moved = moved.coordinates().map(|c| c.to_array());
    for (k, point) in points.iter().enumerate() {
        let truth = motor.transform(Point::from(*point)).coordinates();
        assert_close!([0, 1, 2].map(|axis| moved[axis][k]), truth, 1e-14);
    }
    // Moved along x, a point moves by the first column of the rotation.
    let constant = Dual::<f64, 1>::constant;
    let p = Point::new(Dual::variable(1.0), constant(0.5), constant(2.0));
    let slope = moving
        .map(constant)
        .apply(p)
        .coordinates()
        .map(Dual::derivative);
    let matrix = motor.to_matrix();
    assert_close!(slope, [matrix[0][0], matrix[1][0], matrix[2][0]], 1e-14);
}

#[test]
fn a_stage_is_copied_compared_and_shown() {
    let motors = member::<Motor<f64>>(strategy::float(0.9));
    for_all(motors, |m| {
        let moving = compiled::moving(m);
        let copy = moving;
        assert_eq!(moving, copy);
        assert!(format!("{copy:?}").starts_with("Moving"));
    });
}

mod without_work {
    ga_runtime::ga! { ga_runtime::cga3;
        /// A translation leaves a direction unchanged, so that there is no work before the call.
        pub fn unmoved(uniform t: Translator, d: Direction) -> Direction { sandwich(t, d) }
    }
}

#[test]
fn uniform_operands_may_leave_no_work() {
    use ga_runtime::cga3::{Direction, Translator};
    let unmoved = without_work::unmoved(Translator::from_displacement([1.0, 2.0, 3.0]));
    let direction = Direction::new(1.0, -1.0, 0.5);
    assert_eq!(unmoved.apply(direction), direction);
}
