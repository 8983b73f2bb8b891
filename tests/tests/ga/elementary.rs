//! Elementary functions and powers in `ga!`, against values from 60 digits.

use core::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::scalar::{Dual, Lanes, Real};
use ga_runtime::vga3::Vector;

mod compiled {
    ga_runtime::ga! { ga_runtime::cga3;
        pub fn tangent(x: Scalar) -> Scalar { tan(x) }
        pub fn arc_sine(x: Scalar) -> Scalar { asin(x) }
        pub fn arc_cosine(x: Scalar) -> Scalar { acos(x) }
        pub fn hyperbolic(x: Scalar) -> [Scalar; 3] { [sinh(x), cosh(x), tanh(x)] }
        pub fn hypotenuse(x: Scalar, y: Scalar) -> Scalar { hypot(x, y) }
        pub fn roots(x: Scalar) -> [Scalar; 2] { [pow(x, 1/2), pow(x, 1/3)] }
        pub fn powers(x: Scalar) -> [Scalar; 2] { [x.pow(-3), pow(x, 1.25)] }
        pub fn one(x: Scalar) -> Scalar { pow(x, 0) }
        /// The law of cosines.
        pub fn third(a: Scalar, b: Scalar, c: Scalar) -> Scalar {
            sqrt(pow(a, 2) + b*b - 2*a*b*cos(c))
        }
        pub fn circumference(r: Scalar) -> Scalar { 2 * pi * r }
        pub fn turned(n: Rotor) -> Rotor { pow(n, 5) }
        pub fn turned_back(m: Motor) -> Motor { pow(m, -3) }
        /// In any Lorentz frame `cosh² − sinh² = 1`, as the compiler knows.
        pub fn one_of_rapidity(x: Scalar) -> Scalar { cosh(x)*cosh(x) - sinh(x)*sinh(x) }
    }
    ga_runtime::ga! { ga_runtime::vga3;
        pub fn cubed(v: Vector) -> Vector { pow(v, 3) }
        pub fn inverse_cubed(v: Vector) -> Vector { pow(v, -3) }
    }
    ga_runtime::ga! { ga_runtime::cga3;
        /// Here the name is that of an operand.
        pub fn own(pi: Scalar) -> Scalar { pi + 1 }
    }
}

/// The value of a function of that name.
fn value<S: Real>(name: &str, x: S) -> S {
    match name {
        "tan" => compiled::tangent(x),
        "asin" => compiled::arc_sine(x),
        "acos" => compiled::arc_cosine(x),
        "sinh" => compiled::hyperbolic(x)[0],
        "cosh" => compiled::hyperbolic(x)[1],
        "tanh" => compiled::hyperbolic(x)[2],
        "square root" => compiled::roots(x)[0],
        "cube root" => compiled::roots(x)[1],
        "to the -3" => compiled::powers(x)[0],
        "to the 5/4" => compiled::powers(x)[1],
        other => panic!("no function {other}"),
    }
}

#[test]
#[allow(
    clippy::approx_constant,
    reason = "the table is as the other computation gave it"
)]
fn functions_are_accurate_to_a_few_units() {
    // Values computed with 60 digits.
    for (name, x, expected) in [
        ("asin", 0.9999999999999991, 1.570796284648048),
        ("asin", 0.9999999999, 1.5707821846586878),
        ("asin", -0.9999999999990905, -1.5707949780957442),
        ("asin", 0.5, 0.5235987755982989),
        ("asin", -0.75, -0.848062078981481),
        ("asin", 1e-09, 1e-09),
        ("asin", 1.0, 1.5707963267948966),
        ("acos", 0.9999999999999991, 4.2146848510894035e-08),
        ("acos", 0.9999999999, 1.4142136208911564e-05),
        ("acos", -0.9999999999990905, 3.1415913048906408),
        ("acos", 0.5, 1.0471975511965979),
        ("acos", -0.75, 2.4188584057763776),
        ("acos", 1e-09, 1.5707963257948967),
        ("acos", 1.0, 0.0),
        ("sinh", 1e-20, 1e-20),
        ("sinh", -1e-09, -1e-09),
        ("sinh", 0.001, 0.001000000166666675),
        ("sinh", 0.5, 0.5210953054937474),
        ("sinh", -1.0, -1.1752011936438014),
        ("sinh", 3.0, 10.017874927409903),
        ("sinh", 20.0, 242582597.70489514),
        ("sinh", 700.0, 5.0711602736750225e+303),
        ("cosh", 1e-20, 1.0),
        ("cosh", -1e-09, 1.0),
        ("cosh", 0.001, 1.0000005000000416),
        ("cosh", 0.5, 1.1276259652063807),
        ("cosh", -1.0, 1.5430806348152437),
        ("cosh", 3.0, 10.067661995777765),
        ("cosh", 20.0, 242582597.70489514),
        ("cosh", 700.0, 5.0711602736750225e+303),
        ("tanh", 1e-20, 1e-20),
        ("tanh", -1e-09, -1e-09),
        ("tanh", 0.001, 0.0009999996666668),
        ("tanh", 0.5, 0.46211715726000974),
        ("tanh", -1.0, -0.7615941559557649),
        ("tanh", 3.0, 0.9950547536867305),
        ("tanh", 20.0, 1.0),
        ("tanh", 700.0, 1.0),
        ("tanh", 1000.0, 1.0),
        ("tan", 1e-20, 1e-20),
        ("tan", 1.0, 1.5574077246549023),
        ("tan", -3.0, 0.1425465430742778),
        ("tan", 1.5707963267948966, 1.633123935319537e+16),
        ("tan", 100.0, -0.5872139151569291),
        ("square root", 2.0, 1.4142135623730951),
        ("square root", 1e-300, 1e-150),
        ("cube root", 2.0, 1.2599210498948732),
        ("cube root", 1000.0, 10.0),
        ("cube root", 0.001, 0.1),
        ("to the -3", 2.0, 0.125),
        ("to the -3", -0.3, -37.03703703703704),
        ("to the -3", 1e+50, 9.999999999999997e-151),
        ("to the 5/4", 2.0, 2.378414230005442),
        ("to the 5/4", 1e-10, 3.1622776601683797e-13),
        ("to the 5/4", 1e+40, 1e+50),
    ] {
        let found = value(name, x);
        // A root of three is exp(ln x/3), which rounds the logarithm.
        let error = (found - expected).abs() / expected.abs().max(f64::MIN_POSITIVE);
        assert!(
            error <= 4.0 * f64::EPSILON,
            "{name} of {x}: {found}, not {expected}"
        );
        // The same in lanes.
        assert_eq!(
            value(name, Lanes::from_array([x, x]))[1].to_bits(),
            found.to_bits()
        );
    }
}

/// Derivatives against closed forms.
#[test]
fn derivatives_are_those_of_calculus() {
    for x in [0.3, -0.7, 0.999_999] {
        let slope = |name: &str| value(name, Dual::<f64>::variable(x)).derivative();
        let leg = ((1.0 - x) * (1.0 + x)).sqrt();
        let others = [
            ("tan", 1.0 / x.cos().powi(2)),
            ("asin", 1.0 / leg),
            ("acos", -1.0 / leg),
            ("sinh", x.cosh()),
            ("cosh", x.sinh()),
            ("tanh", 1.0 / x.cosh().powi(2)),
            ("to the -3", -3.0 / x.powi(4)),
        ];
        let roots = [
            ("square root", 0.5 / x.abs().sqrt()),
            ("cube root", x.abs().powf(-2.0 / 3.0) / 3.0),
            ("to the 5/4", 1.25 * x.abs().sqrt().sqrt()),
        ];
        let roots = roots.into_iter().filter(|_| x > 0.0);
        for (name, expected) in others.into_iter().chain(roots) {
            let found = slope(name);
            let error = (found - expected).abs() / expected.abs();
            assert!(error < 1e-14, "{name} at {x}: {found}, not {expected}");
        }
    }
}

#[test]
fn hypotenuses_do_not_overflow() {
    for (x, y, expected) in [
        (3.0, 4.0, 5.0),
        (3e200, 4e200, 5e200),
        (-3e-200, 4e-200, 5e-200),
        (0.0, 0.0, 0.0),
        (0.0, -2.0, 2.0),
        (f64::INFINITY, 1.0, f64::INFINITY),
    ] {
        let found = compiled::hypotenuse(x, y);
        assert!(
            (found - expected).abs() <= 1e-15 * expected || found == expected,
            "{found}"
        );
    }
    assert_eq!(compiled::hypotenuse(3e30_f32, 4e30), 5e30);
}

/// Outside of their domains functions are NaN, as roots of negative numbers are.
#[test]
fn what_has_no_value_is_nan() {
    for name in ["asin", "acos"] {
        assert!(value(name, 1.0 + f64::EPSILON).is_nan() && value(name, -2.0_f64).is_nan());
    }
    assert!(value("square root", -1.0_f64).is_nan() && value("cube root", -1.0_f64).is_nan());
    assert_eq!(
        (value("square root", 0.0), value("cube root", 0.0)),
        (0.0, 0.0)
    );
    assert_eq!(compiled::one(f64::NAN), 1.0);
}

#[test]
fn formulas_are_those_of_textbooks() {
    assert!((compiled::third(3.0, 4.0, FRAC_PI_2) - 5.0).abs() < 1e-15);
    assert_eq!(compiled::circumference(0.5), PI);
    assert_eq!(compiled::one_of_rapidity(40.0), 1.0);
    assert_eq!(compiled::own(2.0), 3.0);
}

/// Powers of versors against products one after the other.
#[test]
fn versors_are_multiplied() {
    let turn = Rotor::from_axis_angle([0.0, 0.6, 0.8], 0.4_f64).unwrap();
    let five = compiled::turned(turn);
    let expected = Rotor::from_axis_angle([0.0, 0.6, 0.8], 2.0).unwrap();
    assert!((five * expected.reverse()).scalar() > 1.0 - 1e-14);

    let motor = Translator::from_displacement([1.0, -2.0, 0.5]) * turn;
    let back: Motor<f64> = compiled::turned_back(motor) * motor * motor * motor;
    let coefficients = back.coefficients().skip(1);
    assert!(coefficients.fold(0.0, |sum, (_, x)| sum + x.abs()) < 1e-13);

    let v = Vector::new(1.0, 2.0, -2.0);
    assert_eq!(compiled::cubed(v), v * 9.0);
    let inverse = compiled::inverse_cubed(v) * 81.0;
    assert!((inverse - v).norm_squared() < 1e-28);
}
