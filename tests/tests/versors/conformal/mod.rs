//! General conformal versors: exponential and logarithm, roots and powers, reflections and
//! inversions, how they act.

mod action;
mod nearest;

use std::f64::consts::PI;
use std::iter;

use ga_runtime::cga3::{
    Bivector, Dilator, EvenVersor, MotorGenerator, Point, Rotor, Translator, Transversor, Trivector,
};
use ga_runtime::testing::{algebra_of, to_dense};
use ga_runtime::{Element, dense};
use nullcone_tests::oracle;
use nullcone_tests::plain::largest;
use nullcone_tests::random::SplitMix64;
use serde_json::Value;

/// `exp b` by its series in the dense reference: scaling, 24 terms, squaring.
fn series(bivector: &Bivector<f64>) -> dense::Multivector<f64> {
    let algebra = algebra_of(Bivector::<f64>::METRIC);
    let bivector = to_dense(&algebra, bivector);
    let size = bivector
        .coefficients()
        .iter()
        .fold(0.0_f64, |m, x| m.max(x.abs()));
    let halvings = (size.max(1.0).log2().ceil() as i32) + 3;
    let small = bivector.scale(0.5_f64.powi(halvings));
    let mut sum = algebra.one();
    for n in (1..=24).rev() {
        sum = algebra.one() + small.scale(1.0 / f64::from(n)).geometric(&sum);
    }
    for _ in 0..halvings {
        sum = sum.geometric(&sum);
    }
    sum
}

fn numbers<T: Element<Scalar = f64>>(element: &T) -> Vec<f64> {
    T::BLADES.iter().map(|&b| element.coefficient(b)).collect()
}

fn size<T: Element<Scalar = f64>>(element: &T) -> f64 {
    largest(numbers(element).iter().copied())
}

/// The largest difference of two coefficients, relative to the largest coefficient.
fn deviation<T: Element<Scalar = f64>>(found: &T, expected: &T) -> f64 {
    let (a, b) = (numbers(found), numbers(expected));
    let worst = largest(a.iter().zip(&b).map(|(a, b)| a - b));
    let scale = size(expected);
    if worst == 0.0 { 0.0 } else { worst / scale }
}

fn bivector(c: [f64; 10]) -> Bivector<f64> {
    let [a, b, c, d, e, f, g, h, i, j] = c;
    Bivector::new(a, b, c, d, e, f, g, h, i, j)
}

fn random_bivector(n: &mut SplitMix64) -> Bivector<f64> {
    bivector([(); 10].map(|()| n.within(1.0)))
}

/// The distance of a bivector from the end of the principal branch, where the half angles of its
/// rotations add up to π.
fn room(b: Bivector<f64>) -> f64 {
    let wedge = b.wedge(b);
    let (s, square) = (b.scalar_product(b), wedge.scalar_product(wedge));
    let turn = if square > 0.0 {
        s - square.sqrt()
    } else {
        (s - (s * s - square).sqrt()) / 2.0
    };
    PI - (-turn).max(0.0).sqrt()
}

/// Bivectors of all kinds: of any size, logarithms of the special versors, and bivectors close to
/// those.
fn family(kind: usize, n: &mut SplitMix64) -> Bivector<f64> {
    let spread = 10_f64.powf(-3.0 * n.within(1.0).abs());
    let angle = 3.0 * n.within(1.0);
    let [x, y, z] = n.vector(1.0);
    let turn = MotorGenerator::new(x * angle, y * angle, z * angle, 0.0, 0.0, 0.0);
    let [x, y, z] = n.vector(1.0).map(|x| 10.0 * x);
    let shift = MotorGenerator::new(0.0, 0.0, 0.0, x, y, z);
    let scaling = bivector([
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        3.0 * n.within(1.0),
    ]);
    let bend = Transversor::from_vector(n.vector(1.0)).log();
    // Rotations by equal angles in e12 and in the orthogonal Euclidean plane.
    let equal = bivector([
        angle / 2.0,
        0.0,
        0.0,
        0.0,
        0.0,
        angle / 2.0,
        0.0,
        0.0,
        angle / 4.0,
        0.0,
    ]);
    match kind {
        0 => random_bivector(n),
        1 => random_bivector(n) * 3.0,
        2 => random_bivector(n) * 6.0,
        3 => random_bivector(n) * 10_f64.powf(-150.0 + 150.0 * n.within(1.0)),
        4 => turn.into(),
        5 => shift.into(),
        6 => scaling,
        7 => bend,
        8 => Bivector::from(turn + shift),
        9 => Bivector::from(turn + shift) + scaling,
        10 => Bivector::from(turn) + bend,
        11 => equal,
        12 => Bivector::from(turn) + random_bivector(n) * spread,
        13 => Bivector::from(shift) + random_bivector(n) * spread,
        14 => scaling + random_bivector(n) * spread,
        15 => bend + random_bivector(n) * spread,
        16 => equal + random_bivector(n) * spread,
        17 => Bivector::from(turn + shift) + random_bivector(n) * (spread * 1e-6),
        _ => equal + random_bivector(n) * (spread * 1e-8),
    }
}

const KINDS: usize = 19;

#[test]
fn exponentials_and_logarithms_undo_each_other() {
    let mut n = SplitMix64(1);
    for k in 0..100_000 {
        let kind = k % KINDS;
        let b = family(kind, &mut n);
        let versor = b.exp().expect("in range");
        let log = versor.log();
        let again = log.exp().expect("in range");
        // At the end of the principal branch a small change of V changes the plane of rotation.
        let conditioning = 1.0 / room(log).min(1.0);
        let found = deviation(&again, &versor);
        assert!(
            found <= 1e-12 * conditioning,
            "exp log, {kind}: {found:e} for {b:?}"
        );
        let conditioning = 1.0 / room(b).min(1.0);
        if room(b) > 1e-3 {
            let found = deviation(&log, &b);
            assert!(
                found <= 1e-13 * conditioning,
                "log exp, {kind}: {found:e} for {b:?}"
            );
        }
    }
}

#[test]
fn exponentials_are_those_of_the_series() {
    let algebra = algebra_of(Bivector::<f64>::METRIC);
    let mut n = SplitMix64(2);
    for k in 0..20 * KINDS {
        let b = family(k % KINDS, &mut n);
        let versor = b.exp().expect("in range");
        let expected = series(&b);
        let scale = size(&versor);
        let difference = to_dense(&algebra, &versor) - expected;
        let worst = difference
            .coefficients()
            .iter()
            .fold(0.0_f64, |m, x| m.max(x.abs()));
        assert!(worst <= 1e-12 * scale, "{}: {worst:e} for {b:?}", k % KINDS);
    }
}

fn element<T: Element<Scalar = f64>>(value: &Value) -> T {
    let list = value.as_array().expect("a list of coefficients");
    T::from_coefficients_unchecked(&mut |blade| list[blade].as_f64().expect("a number"))
}

#[test]
fn versors_of_another_library() {
    let complete = oracle::complete().map(|all| all["geometry"].clone());
    for source in iter::once(oracle::extract("ga/geometry.json")).chain(complete) {
        for record in source["versors"].as_array().expect("records") {
            let versor: EvenVersor<f64> = element(&record["versor"]);
            let b: Bivector<f64> = element(&record["bivector"]);
            assert!(deviation(&b.exp().expect("in range"), &versor) <= 1e-14);
            assert!(deviation(&versor.log().exp().expect("in range"), &versor) <= 1e-13);
            assert!(deviation(&versor.log(), &b) <= 1e-13 / room(b).min(1.0));
            let list = record["point"].as_array().expect("a point");
            let [x, y, z] = [0, 1, 2].map(|k| list[k].as_f64().expect("a number"));
            let image = versor.transform(Point::new(x, y, z));
            assert!(deviation(&image, &element(&record["image"])) <= 1e-13);
            let circle: Trivector<f64> = element(&record["circle"]);
            let image = versor.transform(circle);
            assert!(deviation(&image, &element(&record["circle_image"])) <= 1e-12);
        }
    }
}

#[test]
fn rigid_motions_have_the_logarithm_that_they_have_as_motors() {
    let mut n = SplitMix64(3);
    for _ in 0..1000 {
        let turn =
            Rotor::from_axis_angle(n.vector(1.0), PI * (1.0 + n.within(1.0))).expect("an axis");
        let motor = Translator::from_displacement(n.vector(1.0).map(|x| 5.0 * x)) * turn;
        let expected = Bivector::from(motor.log());
        let found = EvenVersor::from(motor).log();
        let conditioning = 1.0 / room(expected).min(1.0);
        let found = deviation(&found, &expected);
        assert!(found <= 1e-12 * conditioning, "{found:e} for {motor:?}");
    }
}

#[test]
fn tiny_bivectors_keep_their_digits() {
    let mut n = SplitMix64(4);
    for exponent in (8..=300).step_by(4) {
        let b = random_bivector(&mut n) * 10_f64.powi(-exponent);
        let log = b.exp().expect("in range").log();
        assert!(deviation(&log, &b) <= 1e-15, "1e-{exponent}");
    }
}

/// Versors that act as the identity, or whose full rotations may be in any plane.
fn on_the_edge() -> Vec<(&'static str, EvenVersor<f64>)> {
    let one = EvenVersor::<f64>::default();
    let shift = Translator::from_displacement([3.0, -4.0, 0.5]);
    let bend = Transversor::from_vector([0.3, 0.5, -0.7]);
    let growth = Dilator::from_factor(5.0).expect("positive");
    let half = PI / 2.0;
    // Rotations by 180° in e12 and in the plane of e3 and eo − ½ei, which has a positive square.
    let both = bivector([half, 0.0, 0.0, 0.0, 0.0, half, 0.0, 0.0, -half / 2.0, 0.0]);
    let other = bivector([half, 0.0, 0.0, 0.0, 0.0, -half, 0.0, 0.0, half / 2.0, 0.0]);
    vec![
        ("−1", -one),
        ("minus a shift", -EvenVersor::from(shift)),
        ("minus a bend", -EvenVersor::from(bend)),
        ("minus a scaling", -EvenVersor::from(growth)),
        (
            "minus a translation and scaling",
            -EvenVersor::from(shift * growth),
        ),
        ("two half turns", both.exp().expect("in range")),
        (
            "two half turns the other way",
            other.exp().expect("in range"),
        ),
    ]
}

#[test]
fn full_rotations_have_logarithms() {
    let log = (-EvenVersor::<f64>::default()).log();
    assert_eq!(
        log,
        Bivector {
            e12: PI,
            ..Bivector::default()
        }
    );
    let mut n = SplitMix64(5);
    for (what, versor) in on_the_edge() {
        for k in 0..500 {
            let frame = if k == 0 {
                EvenVersor::default()
            } else {
                random_bivector(&mut n).exp().expect("in range")
            };
            let moved = frame * versor * frame.reverse();
            let again = moved.log().exp().expect("in range");
            let found = deviation(&again, &moved);
            let bound = if k == 0 { 1e-15 } else { 1e-11 };
            assert!(found <= bound, "{what}, {k}: {found:e}, {moved:?}");
        }
    }
}

#[test]
fn bivectors_that_are_not_finite_have_no_exponential() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
        for place in 0..10 {
            let b = bivector(
                [0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map(|k| if k == place { bad } else { 0.25 }),
            );
            assert_eq!(b.exp(), None, "{bad} at {place}");
        }
    }
    // cosh 800 is beyond the range, a translation by 1e300 is not.
    assert_eq!(
        bivector([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 800.0]).exp(),
        None
    );
    let far = Translator::from_displacement([1e300, 0.0, 0.0]);
    let generator = bivector([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5e300, 0.0, 0.0, 0.0]);
    assert_eq!(generator.exp(), Some(far.into()));
    let versor = EvenVersor::from(far);
    assert_eq!(versor.log(), generator);
    assert_eq!(versor.powf(f64::NAN), None);
    assert_eq!(EvenVersor::default().powf(f64::INFINITY), None);
    for bad in [f64::NAN, f64::INFINITY] {
        for place in EvenVersor::<f64>::BLADES {
            let versor = EvenVersor::from_coefficients_unchecked(&mut |blade| {
                if blade == *place { bad } else { 0.0 }
            });
            assert!(numbers(&versor.log()).iter().all(|x| x.is_nan()));
            assert_eq!(
                [
                    versor.sqrt(),
                    versor.powf(0.5),
                    versor.interpolate(versor, 0.5)
                ],
                [None; 3]
            );
        }
    }
}

#[test]
fn single_precision() {
    let mut n = SplitMix64(6);
    for k in 0..2000 {
        let b = family(k % KINDS, &mut n);
        let narrow = |b: Bivector<f64>| {
            Bivector::<f32>::from_coefficients_unchecked(&mut |blade| b.coefficient(blade) as f32)
        };
        if k % KINDS == 2 || room(b) < 0.3 {
            continue;
        }
        let b = narrow(b);
        let log = b.exp().expect("in range").log();
        let wide = |b: Bivector<f32>| {
            Bivector::<f64>::from_coefficients_unchecked(&mut |blade| b.coefficient(blade).into())
        };
        let found = deviation(&wide(log), &wide(b));
        assert!(found <= 5e-5, "{}: {found:e} for {b:?}", k % KINDS);
    }
}

#[test]
fn roots_powers_and_the_way_between() {
    let mut n = SplitMix64(7);
    for k in 0..50 * KINDS {
        let b = family(k % KINDS, &mut n);
        if room(b) < 0.1 || k % KINDS == 2 {
            continue;
        }
        let versor = b.exp().expect("in range");
        let root = versor.sqrt().expect("in range");
        assert!(deviation(&(root * root), &versor) <= 1e-12);
        assert!(deviation(&root, &(b * 0.5).exp().expect("in range")) <= 1e-12);
        let third = versor.powf(1.0 / 3.0).expect("in range");
        assert!(deviation(&(third * third * third), &versor) <= 1e-12);
        let backwards = versor.powf(-1.0).expect("in range");
        assert!(deviation(&backwards, &versor.inverse()) <= 1e-12);

        let start = random_bivector(&mut n).exp().expect("in range");
        let end = start * (b * 0.5).exp().expect("in range");
        let quarter = start.interpolate(end, 0.25).expect("in range");
        let expected = start * (b * 0.125).exp().expect("in range");
        // The short way rotates by 180° at most.
        if room(b * 0.5) > PI / 2.0 {
            assert!(deviation(&quarter, &expected) <= 1e-11);
            assert!(
                deviation(&start.interpolate(-end, 0.25).expect("in range"), &expected) <= 1e-11
            );
        }
        assert!(deviation(&start.interpolate(end, 0.0).expect("in range"), &start) <= 1e-15);
    }
}
