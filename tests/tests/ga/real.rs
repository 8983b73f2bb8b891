//! Functions of real numbers: exponentials, logarithms, norms and roots against closed forms.

use ga_runtime::cga3::{Motor, MotorGenerator, Point, Rotor, Translator};
use ga_runtime::testing::{assert_close, for_all, member, strategy};
use proptest::prelude::*;

mod spacetime {
    ga_runtime::algebra! {
        /// One basis vector of square 1, three of square −1.
        pub mod mostly_minus {
            basis g0, g1, g2, g3;
            signature 1, 3;
            struct Vector { g0, g1, g2, g3 }
            struct Boost { g01, g02, g03 }
            struct Turn { g12, g13, g23 }
            struct Even { scalar, g01, g02, g03, g12, g13, g23, g0123 }
            #[hull(Even)]
            #[facts(unit_versor)]
            struct Rotor { scalar, g01, g02, g03, g12, g13, g23, g0123 }
        }
    }
    ga_runtime::algebra! {
        /// Three basis vectors of square 1, one of square −1.
        pub mod mostly_plus {
            basis e1, e2, e3, e4;
            signature 3, 1;
            struct Vector { e1, e2, e3, e4 }
            struct Boost { e14, e24, e34 }
            struct Even { scalar, e12, e13, e23, e14, e24, e34, e1234 }
        }
    }
}

mod compiled {
    use super::spacetime;
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        pub fn exponential(b: MotorGenerator) -> Motor { exp(b) }
        pub fn logarithm(m: Motor) -> MotorGenerator { log(m) }
        pub fn round(m: Motor) -> Motor { exp(log(m)) }
        pub fn round_trip(b: MotorGenerator) -> MotorGenerator { b.exp().log() }
        pub fn screw(m: Motor, n: Motor, t: Scalar) -> Motor { m * exp(t * log(rev(m) * n)) }
        pub fn turned(angle: Scalar, p: Point) -> Point { sandwich(exp(-angle / 2 * e12), p) }
        pub fn translated(x: Scalar, p: Point) -> Point { sandwich(exp(-x / 2 * e1i), p) }
        pub fn scaled(length: Scalar, p: Point) -> RoundVector { sandwich(exp(length / 2 * eoi), p) }
        pub fn distance(p: Point, q: Point) -> Scalar { sqrt(abs(2 * (p | q))) }
        pub fn normalized(m: DualQuaternion) -> Motor { normalize(m) }
        pub fn unit_plane(p: Point, q: Point, r: Point) -> Plane { normalize(p ^ q ^ r ^ ei) }
        pub fn norms(p: Plane, q: Quaternion) -> [Scalar; 2] { [norm(p), q.norm()] }
        pub fn scalars(x: Scalar, y: Scalar) -> [Scalar; 9] {
            [sqrt(x), abs(y), sin(x), cos(x), atan2(y, x), ln(x), recip(y), exp(y), log(x)]
        }
    }

    ga! { spacetime::mostly_minus;
        pub fn boost(b: Boost) -> Rotor { exp(b) }
        pub fn turn(b: Turn) -> Rotor { exp(b) }
        pub fn boosted(b: Boost, x: Vector) -> Vector { sandwich(exp(b), x) }
        pub fn generator(b: Boost) -> Boost { log(exp(b)) }
    }

    ga! { super::spacetime::mostly_plus;
        pub fn boosted_plus(b: Boost, x: Vector) -> Vector { sandwich(exp(b), x) }
    }

    ga! { ga_runtime::pga3;
        pub fn projective(b: Line) -> Motor { exp(b) }
        pub fn projective_round(m: Motor) -> Motor { exp(log(m)) }
        pub fn projective_unit(m: MotorSum) -> Motor { normalize(m) }
    }
}

fn motors() -> impl Strategy<Value = Motor<f64>> + Clone {
    let axis = prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter("an axis", |a| a.iter().map(|x| x * x).sum::<f64>() > 0.01);
    (axis, -3.1..3.1_f64, prop::array::uniform3(-10.0..10.0_f64)).prop_map(|(axis, angle, t)| {
        Translator::from_displacement(t) * Rotor::from_axis_angle(axis, angle).expect("an axis")
    })
}

fn generators(size: f64) -> impl Strategy<Value = MotorGenerator<f64>> + Clone {
    member::<MotorGenerator<f64>>(strategy::float(size))
}

#[test]
fn exponentials_are_those_of_the_geometry() {
    for_all(generators(1.5), |b| {
        assert_close!(compiled::exponential(b), b.exp(), 1e-14);
    });
    for power in [-300, -200, -160, -100, -17, -8, -5, -4, -3, -2, -1] {
        for_all(generators(10.0_f64.powi(power)), |b| {
            let found = compiled::exponential(b);
            assert_close!(found, b.exp(), 1e-15);
            // To first order exp B = 1 + B, the angle to its own precision.
            if power < -10 {
                assert_close!(
                    [found.e12(), found.e13(), found.e23()],
                    [b.e12, b.e13, b.e23],
                    1e-15
                );
            }
        });
    }
    let none = MotorGenerator::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(compiled::exponential(none), Motor::default());
}

#[test]
fn logarithms_are_those_of_the_geometry() {
    for_all(motors(), |m| {
        assert_close!(compiled::logarithm(m), m.log(), 1e-13);
        assert_close!(compiled::round(m), m, 1e-14);
    });
    let none = compiled::logarithm(Motor::<f64>::default());
    assert_eq!(none, MotorGenerator::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
}

#[test]
fn logarithms_undo_exponentials_of_any_size() {
    for power in [-300, -160, -100, -17, -8, -4, -2, -1, 0] {
        let size = 10.0_f64.powi(power);
        for_all(generators(size), |b| {
            assert_close!(compiled::round_trip(b), b, 1e-13, size);
        });
    }
}

#[test]
fn rotations_by_180_and_360_degrees() {
    for axis in [[1.0, 0.0, 0.0], [0.0, 0.6, 0.8], [-0.48, 0.6, 0.64]] {
        for angle in [
            std::f64::consts::PI,
            -std::f64::consts::PI,
            std::f64::consts::PI - 1e-9,
            std::f64::consts::TAU - 1e-3,
        ] {
            let turn = Rotor::from_axis_angle(axis, angle).expect("an axis");
            let m: Motor<f64> = Translator::from_displacement([1.0, -2.0, 3.0]) * turn;
            // Near a full rotation the logarithm amplifies errors by up to 2π/10⁻³.
            assert_close!(compiled::round(m), m, 2e-12);
        }
    }
    let pure = Translator::from_displacement([3.0, -1.0, 2.0]);
    assert_close!(compiled::round(Motor::from(pure)), Motor::from(pure), 1e-15);
}

#[test]
fn screws_interpolate() {
    for_all((motors(), motors(), 0.0..1.0_f64), |(m, n, t)| {
        let found = compiled::screw(m, n, t);
        let start = compiled::screw(m, n, 0.0);
        assert_close!(start, m, 1e-13);
        assert_close!(compiled::screw(m, n, 1.0), n, 1e-12);
        // The motion for t followed by that for 1 − t is the whole motion.
        let rest = compiled::screw(found, n, 1.0);
        assert_close!(rest, n, 1e-12);
    });
}

#[test]
fn rotors_translators_and_dilators() {
    let p = Point::new(1.0, 2.0, 3.0);
    for angle in [0.0, 1e-300, 1e-9, 0.3, 2.0, -7.0] {
        let (sine, cosine) = f64::sin_cos(angle);
        let truth = [cosine - 2.0 * sine, sine + 2.0 * cosine, 3.0];
        assert_close!(compiled::turned(angle, p).coordinates(), truth, 1e-14);
        assert_close!(
            compiled::translated(angle, p).coordinates(),
            [1.0 + angle, 2.0, 3.0],
            1e-14
        );
        let scaled = compiled::scaled(angle, p);
        let size = if scaled.eo > 1.0 {
            angle.abs()
        } else {
            -angle.abs()
        };
        assert_close!([scaled.e1, scaled.e2, scaled.e3], [1.0, 2.0, 3.0], 1e-14);
        assert_close!(
            [scaled.eo, scaled.ei],
            [size.exp(), 7.0 * (-size).exp()],
            1e-13
        );
    }
}

/// Rapidity and direction: with `φ = 2|b|`, `t' = t cosh φ + x sinh φ` along the direction, up to
/// its sign.
#[test]
fn boosts_are_hyperbolic() {
    use spacetime::{mostly_minus, mostly_plus};
    for rapidity in [0.0, 1e-200, 1e-9, 0.1, 1.0, 5.0] {
        let (cosh, sinh) = (f64::cosh(rapidity), f64::sinh(rapidity));
        let half = mostly_minus::Boost::new(-rapidity / 2.0, 0.0, 0.0);
        // exp(−φ/2 g01) g0 exp(φ/2 g01) = g0 exp(φ g01) = cosh φ g0 + sinh φ g1, as g0 g01 = g1.
        let moved = compiled::boosted(half, mostly_minus::Vector::new(1.0, 0.0, 2.0, 3.0));
        assert_close!(
            [moved.g0, moved.g1, moved.g2, moved.g3],
            [cosh, sinh, 2.0, 3.0],
            1e-13
        );
        let rotor = compiled::boost(half);
        assert_close!(
            [rotor.scalar(), rotor.g01()],
            [(rapidity / 2.0).cosh(), -(rapidity / 2.0).sinh()],
            1e-14
        );
        let back = compiled::generator(half);
        assert_close!(back, half, 1e-14, rapidity.max(f64::MIN_POSITIVE));
        // e4 e14 = e1 and e4² = −1: exp(−φ/2 e14) e4 exp(φ/2 e14) = cosh φ e4 + sinh φ (e4 e14)
        // with e4 e1 e4 = e1.
        let half = mostly_plus::Boost::new(-rapidity / 2.0, 0.0, 0.0);
        let moved = compiled::boosted_plus(half, mostly_plus::Vector::new(0.0, 2.0, 3.0, 1.0));
        assert_close!(
            [moved.e1, moved.e2, moved.e3, moved.e4],
            [sinh, 2.0, 3.0, cosh],
            1e-13
        );
    }
    let turn = compiled::turn(mostly_minus::Turn::new(0.7, 0.0, 0.0));
    assert_close!(
        [turn.scalar(), turn.g12()],
        [0.7_f64.cos(), 0.7_f64.sin()],
        1e-15
    );
}

#[test]
fn projective_motions() {
    let lines = member::<ga_runtime::pga3::Line<f64>>(strategy::float(1.2));
    for_all(lines, |b| {
        let m = compiled::projective(b);
        assert_close!(compiled::projective_round(m), m, 1e-13);
        // Half the motion twice is the motion.
        let half = compiled::projective(b * 0.5);
        assert_close!(half * half, m, 1e-14);
    });
}

#[test]
fn normalized_motors_satisfy_both_conditions() {
    for_all(
        (motors(), 0.1..10.0_f64, -1.0..1.0_f64),
        |(m, size, shear)| {
            // (n + p e123i)^(1/2) m, with which every even element of the motions begins.
            let mut sum = m * size;
            assert_close!(compiled::normalized(sum), m, 1e-13);
            let [x, y, z, w] = [sum.scalar, sum.e12, sum.e13, sum.e23];
            // m times (1 + shear e123i): e123i commutes with all even elements of the motions.
            sum.e123i += shear * x;
            sum.e1i -= shear * w;
            sum.e2i += shear * z;
            sum.e3i -= shear * y;
            assert_close!(compiled::normalized(sum), m, 1e-12);
        },
    );
    let [a, b, c] = [[0.0_f64; 3], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point::from);
    let plane = compiled::unit_plane(a, b, c);
    assert_close!(
        [plane.e123i, plane.e12oi.abs(), plane.e13oi, plane.e23oi],
        [0.0, 1.0, 0.0, 0.0],
        1e-15,
        1.0
    );
}

#[test]
fn scalar_functions() {
    let (x, y) = (2.5_f64, -0.75_f64);
    let truth = [
        x.sqrt(),
        y.abs(),
        x.sin(),
        x.cos(),
        y.atan2(x),
        x.ln(),
        1.0 / y,
        y.exp(),
        x.ln(),
    ];
    assert_close!(compiled::scalars(x, y), truth, 1e-15);
    let [p, q] = [[1.0, 2.0, 3.0], [4.0, 6.0, 3.0]].map(Point::from);
    assert_close!(compiled::distance(p, q), 5.0, 1e-15);
    let plane = ga_runtime::cga3::Plane::new(9.0, 2.0, 3.0, 6.0);
    let quaternion = ga_runtime::cga3::Quaternion::new(1.0, 2.0, 4.0, 2.0);
    assert_close!(compiled::norms(plane, quaternion), [7.0, 5.0], 1e-15);
}
