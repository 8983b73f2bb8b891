//! Derivatives of elementary functions and of geometry in floating point.

use core::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::{Motor, MotorGenerator, Point, Rotor, Translator};
use ga_runtime::scalar::{Dual, Field, Lanes, Mask, Real, Ring};
use nullcone_tests::plain::cross;
use proptest::prelude::*;

/// Functions of two variables that are smooth with moderate derivatives everywhere.
#[derive(Clone, Debug)]
enum Expression {
    X,
    Y,
    Constant(f64),
    Sum(Box<[Expression; 2]>),
    Product(Box<[Expression; 2]>),
    Sine(Box<Expression>),
    Cosine(Box<Expression>),
    /// `exp sin u`
    Exponential(Box<Expression>),
    /// `√(1 + u²)`
    Root(Box<Expression>),
    /// `ln(1 + u²)`
    Logarithm(Box<Expression>),
    /// `u/(1 + v²)`
    Quotient(Box<[Expression; 2]>),
    /// The angle of the point (1 + v², u).
    Angle(Box<[Expression; 2]>),
}

fn expression() -> impl Strategy<Value = Expression> {
    let leaf = prop_oneof![
        Just(Expression::X),
        Just(Expression::Y),
        (-1.0..1.0).prop_map(Expression::Constant)
    ];
    leaf.prop_recursive(3, 12, 2, |inner| {
        let one = || inner.clone().prop_map(Box::new);
        let two = || [inner.clone(), inner.clone()].prop_map(Box::new);
        prop_oneof![
            two().prop_map(Expression::Sum),
            two().prop_map(Expression::Product),
            one().prop_map(Expression::Sine),
            one().prop_map(Expression::Cosine),
            one().prop_map(Expression::Exponential),
            one().prop_map(Expression::Root),
            one().prop_map(Expression::Logarithm),
            two().prop_map(Expression::Quotient),
            two().prop_map(Expression::Angle),
        ]
    })
}

fn evaluate<S: Real>(expression: &Expression, x: S, y: S) -> S {
    let value = |inner: &Expression| evaluate(inner, x, y);
    let square = |u: S| S::one() + u * u;
    match expression {
        Expression::X => x,
        Expression::Y => y,
        Expression::Constant(number) => S::from_f64(*number),
        Expression::Sum(uv) => value(&uv[0]) + value(&uv[1]),
        Expression::Product(uv) => value(&uv[0]) * value(&uv[1]),
        Expression::Sine(u) => value(u).sin(),
        Expression::Cosine(u) => value(u).cos(),
        Expression::Exponential(u) => value(u).sin().exp(),
        Expression::Root(u) => square(value(u)).sqrt(),
        Expression::Logarithm(u) => square(value(u)).ln(),
        Expression::Quotient(uv) => value(&uv[0]) / square(value(&uv[1])),
        Expression::Angle(uv) => value(&uv[0]).atan2(square(value(&uv[1]))),
    }
}

/// The derivative by finite differences, with an error of order h⁶.
fn by_differences(function: impl Fn(f64) -> f64) -> f64 {
    let h = 1.0 / 256.0;
    let odd = |k: f64| function(k * h) - function(-k * h);
    (45.0 * odd(1.0) - 9.0 * odd(2.0) + odd(3.0)) / (60.0 * h)
}

fn close(found: f64, expected: f64, tolerance: f64) -> Result<(), TestCaseError> {
    let bound = tolerance * expected.abs().max(1.0);
    prop_assert!(
        (found - expected).abs() <= bound,
        "{found} instead of {expected}"
    );
    Ok(())
}

fn coordinates() -> impl Strategy<Value = [f64; 3]> {
    [-10.0..10.0, -10.0..10.0, -10.0..10.0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn random_functions(expression in expression(), x in -1.0_f64..1.0, y in -1.0_f64..1.0) {
        let [a, b] = Dual::variables([x, y]);
        let dual = evaluate(&expression, a, b);
        prop_assert_eq!(dual.value.to_bits(), evaluate(&expression, x, y).to_bits());
        close(dual.derivatives[0], by_differences(|h| evaluate(&expression, x + h, y)), 1e-6)?;
        close(dual.derivatives[1], by_differences(|h| evaluate(&expression, x, y + h)), 1e-6)?;
    }

    #[test]
    fn elementary_functions(x in 0.01_f64..20.0, y in -20.0_f64..20.0, dx in -3.0_f64..3.0, dy in -3.0_f64..3.0) {
        let (a, b) = (Dual::new(x, [dx]), Dual::new(y, [dy]));
        let radius_squared = x * x + y * y;
        for (found, expected) in [
            (a.sqrt(), dx / (2.0 * x.sqrt())),
            (a.ln(), dx / x),
            (b.exp(), dy * y.exp()),
            (b.sin(), dy * y.cos()),
            (b.cos(), -dy * y.sin()),
            (b.abs(), dy * y.signum()),
            (b.atan2(a), (x * dy - y * dx) / radius_squared),
            (a.atan2(b), (y * dx - x * dy) / radius_squared),
            (b.sinh(), dy * y.cosh()),
            (b.cosh(), dy * y.sinh()),
            (b.tanh(), dy / y.cosh().powi(2)),
            (a.hypot(b), (x * dx + y * dy) / x.hypot(y)),
            (b / a, (dy * x - y * dx) / (x * x)),
            (a.recip(), -dx / (x * x)),
            (a.max(b), if y > x { dy } else { dx }),
            (a.min(b), if y < x { dy } else { dx }),
        ] {
            close(found.derivative(), expected, 1e-14)?;
        }
    }

    /// For all inputs the value is that of the plain number, and the derivative is not NaN where
    /// value and derivative are finite.
    #[test]
    fn values_are_those_of_plain_numbers(x in prop::num::f64::ANY, y in prop::num::f64::ANY) {
        let [a, b] = Dual::variables([x, y]);
        for (dual, plain) in [
            (a + b, x + y), (a - b, x - y), (a * b, x * y), (a / b, x / y), (-a, -x), (a.recip(), 1.0 / x),
            (a.sqrt(), x.sqrt()), (a.abs(), x.abs()), (a.sin(), x.sin()), (a.cos(), x.cos()), (a.exp(), x.exp()),
            (a.ln(), x.ln()), (a.atan2(b), x.atan2(y)), (a.max(b), Real::max(x, y)), (a.min(b), Real::min(x, y)),
            (a.sinh(), x.sinh()), (a.cosh(), x.cosh()), (a.tanh(), x.tanh()), (a.hypot(b), x.hypot(y)),
            (a.mul_add(b, a), Ring::mul_add(x, y, x)),
        ] {
            prop_assert!(dual.value.to_bits() == plain.to_bits() || dual.value.is_nan() && plain.is_nan());
        }
        prop_assert_eq!(a.less_than(b), x < y);
        for dual in [a.sqrt(), a.abs(), a.sin(), a.exp(), a.ln(), a.atan2(b), a.sinh(), a.cosh(), a.tanh(), a.hypot(b)] {
            let has_nan = dual.derivatives.iter().any(|d| d.is_nan());
            prop_assert!(!has_nan || x.is_nan() || y.is_nan() || dual.value.is_nan(), "{dual:?} of {x}, {y}");
            prop_assert_eq!(Real::is_finite(dual), dual.value.is_finite() && dual.derivatives.iter().all(|d| d.is_finite()));
        }
    }

    #[test]
    fn second_derivatives(x in -3.0_f64..3.0) {
        let at = Dual::variable(Dual::variable(x));
        let (sine, square) = (at.sin(), (at * at).exp());
        close(sine.derivative().derivative(), -x.sin(), 1e-15)?;
        close(square.derivative().derivative(), (2.0 + 4.0 * x * x) * (x * x).exp(), 1e-14)?;
        let angle = at.atan2(Dual::one());
        close(angle.derivative().derivative(), -2.0 * x / (1.0 + x * x).powi(2), 1e-14)?;
    }

    #[test]
    fn lanes_of_duals_and_duals_of_lanes(x in prop::array::uniform4(-2.0_f64..2.0), y in prop::array::uniform4(-2.0_f64..2.0), expression in expression()) {
        let [a, b] = Dual::variables([Lanes::from_array(x), Lanes::from_array(y)]);
        let whole = evaluate(&expression, a, b);
        let alone = [0, 1, 2, 3].map(|k| Dual::variables([x[k], y[k]]));
        let lanes = evaluate(
            &expression,
            Lanes::from_array(alone.map(|[a, _]| a)),
            Lanes::from_array(alone.map(|[_, b]| b)),
        );
        for k in 0..4 {
            let one = evaluate(&expression, alone[k][0], alone[k][1]);
            prop_assert_eq!(lanes[k], one);
            prop_assert_eq!(Dual::new(whole.value[k], whole.derivatives.map(|d| d[k])), one);
        }
    }

    #[test]
    fn gradient_of_a_distance(p in coordinates(), q in coordinates()) {
        let distance = Point::from(Dual::variables(p)).distance(Point::from(q.map(Dual::constant)));
        let length = (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
        for k in 0..3 {
            close(distance.derivatives[k], (p[k] - q[k]) / length, 1e-12)?;
        }
    }

    /// A rotation at unit speed about an axis n moves points with velocity n × x'.
    #[test]
    fn velocity_of_a_rotation(axis in coordinates(), angle in -6.0..6.0, point in coordinates()) {
        let length = axis.map(|n| n * n).iter().sum::<f64>().sqrt();
        prop_assume!(length > 1e-3);
        let rotor = Rotor::from_axis_angle(axis.map(Dual::constant), Dual::variable(angle)).expect("an axis");
        let moved = rotor.transform(Point::from(point.map(Dual::constant))).coordinates();
        let (n, x) = (axis.map(|n| n / length), moved.map(|x| x.value));
        let expected = cross(n, x);
        for k in 0..3 {
            close(moved[k].derivative(), expected[k], 1e-12)?;
        }
    }

    /// `exp(tG)` moves by its generator at every t, the start included, where the angle is zero.
    #[test]
    fn velocity_of_a_screw(g in coordinates(), h in coordinates(), point in coordinates(), t in prop_oneof![Just(0.0), 0.01..0.2]) {
        let generator = MotorGenerator::new(g[0], g[1], g[2], h[0], h[1], h[2]);
        let dual = MotorGenerator::new(generator.e12, generator.e13, generator.e23, generator.e1i, generator.e2i, generator.e3i);
        let motor: Motor<Dual<f64>> = scaled(dual, Dual::variable(t)).exp();
        let moved = motor.transform(Point::from(point.map(Dual::constant))).coordinates();
        // G = −½ B − ½ v ei has the velocity v − x·B, the angular velocity being the dual of B in
        // space.
        let [x, y, z] = moved.map(|x| x.value);
        let [b12, b13, b23] = g.map(|b| -2.0 * b);
        let expected = [
            -2.0 * h[0] - b12 * y - b13 * z,
            -2.0 * h[1] + b12 * x - b23 * z,
            -2.0 * h[2] + b13 * x + b23 * y,
        ];
        for k in 0..3 {
            close(moved[k].derivative(), expected[k], 1e-10)?;
        }
    }
}

fn scaled(generator: MotorGenerator<f64>, factor: Dual<f64>) -> MotorGenerator<Dual<f64>> {
    let [a, b, c, d, e, f] = [
        generator.e12,
        generator.e13,
        generator.e23,
        generator.e1i,
        generator.e2i,
        generator.e3i,
    ]
    .map(|x| Dual::constant(x) * factor);
    MotorGenerator::new(a, b, c, d, e, f)
}

#[test]
fn singular_points_give_what_the_table_says() {
    let infinity = f64::INFINITY;
    let moving = |x: f64| Dual::new(x, [3.0, -2.0, 0.0]);
    assert_eq!(
        moving(0.0).sqrt(),
        Dual::new(0.0, [infinity, -infinity, 0.0])
    );
    assert_eq!(
        moving(-0.0).sqrt(),
        Dual::new(-0.0, [infinity, -infinity, 0.0])
    );
    assert_eq!(
        moving(0.0).ln(),
        Dual::new(-infinity, [infinity, -infinity, 0.0])
    );
    assert_eq!(moving(0.0).abs(), Dual::constant(0.0));
    assert_eq!(
        moving(0.0).atan2(moving(0.0)),
        Dual::new(0.0, [infinity, infinity, 0.0])
    );
    for out_of_domain in [moving(-1.0).sqrt(), moving(-1.0).ln()] {
        assert!(out_of_domain.value.is_nan());
        assert!(out_of_domain.derivatives[..2].iter().all(|d| d.is_nan()));
        assert!(!Real::is_finite(out_of_domain));
    }
    let quotient = moving(1.0) / moving(0.0);
    assert!(quotient.value == infinity && !Real::is_finite(quotient));
    assert_eq!(
        moving(1.0).max(Dual::constant(1.0)).derivatives,
        moving(1.0).derivatives
    );
    // At infinity the angle is constant.
    assert_eq!(moving(1.0).atan2(moving(infinity)), Dual::constant(0.0));
    assert_eq!(
        moving(infinity).atan2(moving(1.0)),
        Dual::constant(FRAC_PI_2)
    );
    assert_eq!(
        Dual::variable(0.0).atan2(Dual::constant(-2.0)),
        Dual::new(PI, [-0.5])
    );
}

#[test]
fn constants_have_zero_derivatives() {
    let resting = Dual::<f64, 2>::constant(0.0);
    for x in [resting.sqrt(), resting.ln(), resting.atan2(resting)] {
        assert_eq!(x.derivatives, [0.0; 2]);
    }
    let nothing = Point::from(Dual::variables([1.0, 2.0, 3.0]));
    assert_eq!(nothing.distance(nothing), Dual::constant(0.0));
    let [x, y] = Dual::variables([0.0, 0.0]);
    assert_eq!((x * x + y * y).sqrt(), Dual::constant(0.0));
}

#[test]
fn second_derivatives_see_what_starts_to_move() {
    let at = Dual::variable(Dual::variable(0.0_f64));
    assert_eq!((at * at).sin().derivative().derivative(), 2.0);
    assert_eq!((at * at).exp().derivative().derivative(), 2.0);
    assert_eq!((at * at).atan2(Dual::one()).derivative().derivative(), 2.0);
    assert_eq!(at.abs().derivative().derivative(), 0.0);
    assert!((at * at).sqrt().derivative().derivative().is_nan());
}

#[test]
fn comparisons_look_at_values() {
    let (a, b) = (Dual::new(1.0_f64, [5.0]), Dual::new(1.0, [-5.0]));
    assert!(!a.less_than(b) && !b.less_than(a) && a != b);
    assert_eq!([Real::max(a, b), Real::min(a, b)], [a, a]);
    assert!(!Dual::new(0.0, [1.0]).is_invertible() && Dual::new(0.0, [1.0]) != Dual::zero());
    assert!(!Dual::new(0.0_f64, [1.0]).is_zero() && Dual::<f64, 3>::zero().is_zero());
    assert!(!Real::is_finite(Dual::new(0.0, [f64::NAN])));
    let mask = Dual::new(Lanes::from_array([0.0, 1.0]), [Lanes::splat(2.0)])
        .less_than(Dual::constant(Lanes::splat(0.5)));
    assert!(mask.any() && !mask.all() && mask[0]);
}

#[test]
fn singular_lanes_stay_alone() {
    let x = Dual::variable(Lanes::from_array([4.0, 0.0, -1.0]));
    let root = x.sqrt();
    assert_eq!(root.derivative().to_array()[..2], [0.25, f64::INFINITY]);
    assert!(root.value[2].is_nan() && root.derivative()[2].is_nan());
    assert_eq!(root.is_finite().to_array(), [true, false, false]);
}

#[test]
fn text() {
    assert_eq!(Dual::variable(1.5).to_string(), "(1.5 + 1 ε)");
    assert_eq!(Dual::new(1, [-2, 3]).to_string(), "(1 - 2 ε1 + 3 ε2)");
    assert_eq!(format!("{:.2}", Dual::new(1.0, [0.5])), "(1.00 + 0.50 ε)");
    let shift = Translator::from_displacement([Dual::variable(2.0), Dual::zero(), Dual::zero()]);
    assert_eq!(
        format!("{shift}").split(" e1i").next(),
        Some("(1 + 0 ε) + (-1 - 0.5 ε)")
    );
    assert_eq!(Dual::<f64, 2>::from(3.0), Dual::constant(3.0));
    assert_eq!(Dual::<f64, 2>::default(), Dual::zero());
}

#[test]
fn exponentials_of_large_boosts_are_large_and_not_nan() {
    use ga_runtime::scalar::versor_exponential;

    // e⁷¹⁰ is too large for a float, and its half is not.
    let a = 710.0_f64;
    let (c, s, slope) = versor_exponential(Dual::variable(a * a));
    let truth = a - 2.0_f64.ln();
    for (found, logarithm) in [
        (c.value, truth),
        (s.value, truth - a.ln()),
        (slope.value, truth + ((a - 1.0) / (2.0 * a * a * a)).ln()),
        // C′ = S/2.
        (c.derivative(), truth - (2.0 * a).ln()),
        (s.derivative(), slope.value.ln()),
    ] {
        assert!((found.ln() - logarithm).abs() < 1e-12, "{found:e}");
    }
    for x in [1e6, 1e12, 1e308] {
        let (c, s, slope) = versor_exponential(Dual::variable(x));
        for found in [c, s, slope] {
            assert_eq!(found.value, f64::INFINITY, "at {x:e}");
            assert!(found.derivative() > 1e200, "at {x:e}: {found}");
        }
        let (c, s, slope) = versor_exponential(Dual::<f64>::constant(x));
        for found in [c, s, slope] {
            assert_eq!(found, Dual::new(f64::INFINITY, [0.0]), "at {x:e}");
        }
    }
    for x in [1e5_f32, 1e38, f32::INFINITY] {
        assert_eq!(
            versor_exponential(x),
            (f32::INFINITY, f32::INFINITY, f32::INFINITY)
        );
    }
    // The lanes beside are not changed.
    let (c, _, slope) = versor_exponential(Lanes::from_array([1e6, 1.0]));
    let alone = versor_exponential(1.0_f64);
    assert_eq!([c.to_array()[1], slope.to_array()[1]], [alone.0, alone.2]);
    assert_eq!([c.to_array()[0], slope.to_array()[0]], [f64::INFINITY; 2]);
}
