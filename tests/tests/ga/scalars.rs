//! One function over every scalar, with the weakest trait bound that its body needs.

use ga_runtime::Element;
use ga_runtime::cga3::{Motor, Point, Rotor, RoundVector, Translator};
use ga_runtime::scalar::{Dual, Field, Lanes, Real, Ring};
use ga_runtime::testing::{Prime61, assert_close};

mod compiled {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        pub fn of_ring(a: RoundVector, b: Line) -> Plane { a ^ b }
        pub fn of_field(a: RoundVector, b: RoundVector) -> RoundVector { a / (b | b) - b / 3 }
        pub fn of_real(a: RoundVector) -> Scalar { sqrt(a | a) }
        pub fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }
        pub fn distance_squared(p: Point, q: Point) -> Scalar { -2 * (p | q) }
        pub fn distance(p: Point, q: Point) -> Scalar { sqrt(-2 * (p | q)) }
        pub fn turned(angle: Scalar, p: Point) -> Point {
            let r = cos(angle / 2) - sin(angle / 2) * e12;
            r * p * rev(r)
        }
        pub fn wave(x: Scalar, y: Scalar) -> Scalar { exp(x) * cos(y) + abs(y) + ln(x) * recip(y) + atan2(y, x) }
    }
}

/// The same element over another scalar, coefficient by coefficient.
fn over<T: Element, U: Element>(element: T, change: impl Fn(T::Scalar) -> U::Scalar) -> U {
    U::from_coefficients_unchecked(&mut |blade| change(element.coefficient(blade)))
}

/// The bounds are minimal: these functions compile over any scalar with the needed operations.
mod bounds {
    use super::{Field, Real, Ring, RoundVector, compiled};
    use ga_runtime::cga3::{Line, Plane};

    pub(super) fn ring<S: Ring>(a: RoundVector<S>, b: Line<S>) -> Plane<S> {
        compiled::of_ring(a, b)
    }
    pub(super) fn field<S: Field>(a: RoundVector<S>) -> RoundVector<S> {
        compiled::of_field(a, a)
    }
    pub(super) fn real<S: Real>(a: RoundVector<S>) -> S {
        compiled::of_real(a)
    }
}

#[test]
fn integers_and_the_prime_field() {
    let a = RoundVector::new(1_i64, 2, 3, 1, 7);
    let line = ga_runtime::cga3::Line::new(1_i64, -2, 3, 4, 5, -6);
    let truth = a ^ line;
    assert_eq!(bounds::ring(a, line), truth);

    let b: RoundVector<Prime61> = over(RoundVector::new(1_i64, 2, 3, 1, 6), Prime61::from);
    // b² = 1 + 4 + 9 − 2 · 6 = 2.
    let factor = Prime61::from_ratio(1, 2) - Prime61::from_ratio(1, 3);
    assert_eq!(bounds::field(b), b * factor);
    assert_eq!(
        bounds::real(RoundVector::new(3.0, 4.0, 12.0, 0.0, 5.0)),
        13.0
    );
    assert_eq!(
        compiled::distance_squared(Point::new(1, 2, 3), Point::new(2, 4, 5)),
        9
    );
}

#[test]
fn single_and_double_precision_and_lanes_agree() {
    let motor = |x: f64| -> Motor<f64> {
        Translator::from_displacement([x, 2.0, -1.0])
            * Rotor::from_axis_angle([1.0, 2.0, 2.0], x).expect("an axis")
    };
    let points = [
        [1.0, 0.5, 2.0],
        [0.0, -3.0, 1.0],
        [4.0, 4.0, 4.0],
        [0.1, 0.2, 0.3],
    ];
    let angles = [0.1, 1.0, 2.0, 3.0];
    let truth: [[f64; 3]; 4] = std::array::from_fn(|k| {
        motor(angles[k])
            .transform(Point::from(points[k]))
            .coordinates()
    });
    for k in 0..4 {
        let double = compiled::moved(motor(angles[k]), Point::from(points[k]));
        assert_close!(double.coordinates(), truth[k], 1e-14);
        #[allow(clippy::cast_possible_truncation)]
        let single = compiled::moved(
            over(motor(angles[k]), |x| x as f32),
            over(Point::from(points[k]), |x| x as f32),
        );
        assert_close!(single.coordinates().map(f64::from), truth[k], 1e-6);
    }
    let lanes = |k: usize| Lanes::from_array(points.map(|p| p[k]));
    let motors = angles.map(motor);
    let together = Motor::from_coefficients_unchecked(&mut |blade| {
        Lanes::from_array(motors.map(|m| m.coefficient(blade)))
    });
    let moved = compiled::moved(together, Point::new(lanes(0), lanes(1), lanes(2)));
    let moved = moved.coordinates().map(|c| c.to_array());
    for k in 0..4 {
        assert_close!([0, 1, 2].map(|axis| moved[axis][k]), truth[k], 1e-14);
    }
}

#[test]
fn derivatives_are_those_of_the_closed_forms() {
    // d|p − q|/dx = (x − q₁)/|p − q|.
    let q = over(Point::new(1.0, 2.0, 3.0), Dual::<f64, 1>::constant);
    let constant = Dual::<f64, 1>::constant;
    let p = Point::new(Dual::variable(4.0), constant(6.0), constant(3.0));
    let distance = compiled::distance(p, q);
    assert_close!([distance.value, distance.derivative()], [5.0, 0.6], 1e-15);

    // A rotation about z: d/dt (cos t, sin t, 0) = (−sin t, cos t, 0).
    let start = over(Point::new(1.0, 0.0, 0.0), constant);
    let turned = compiled::turned(Dual::variable(0.7), start).coordinates();
    let (sine, cosine) = 0.7_f64.sin_cos();
    assert_close!(turned.map(|x| x.value), [cosine, sine, 0.0], 1e-15);
    assert_close!(turned.map(Dual::derivative), [-sine, cosine, 0.0], 1e-15);

    let (x, y) = (1.3_f64, -0.4_f64);
    let truth = x.exp() * y.cos() + 0.4 + x.ln() / y + y.atan2(x);
    assert_close!(compiled::wave(x, y), truth, 1e-14);
    let slope = x.exp() * y.cos() + 1.0 / (x * y) - y / (x * x + y * y);
    assert_close!(
        compiled::wave(Dual::variable(x), constant(y)).derivative(),
        slope,
        1e-14
    );
}
