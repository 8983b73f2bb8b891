//! Drawn rotors, translators, motors and similarities.

use ga_runtime::cga3::{Dilator, Motor, Point, Rotor, Translator};
use ga_runtime::testing::{assert_close, cga3};
use nullcone_tests::plain::length;

use super::{SIZE, assert_share, drawn, share};

/// The deviation of a motor's coefficients from `⟨M ~M⟩ = 1` and the Study condition.
fn off_unit(m: &Motor<f64>) -> f64 {
    let norm = m.scalar().powi(2) + m.e12().powi(2) + m.e13().powi(2) + m.e23().powi(2);
    let study = m.scalar() * m.e123i() - m.e12() * m.e3i() + m.e13() * m.e2i() - m.e23() * m.e1i();
    (norm - 1.0).abs().max(study.abs() / SIZE)
}

#[test]
fn rotors_rotate_in_every_direction() {
    let rotors: Vec<Rotor<f64>> = drawn(cga3::rotors());
    assert!(rotors.iter().all(|&r| off_unit(&r.into()) < 1e-14));
    let still = Rotor::default();
    // 0, and angles so small that the cosine is 1 and the square is zero.
    assert!(share(&rotors, |r| *r == still) > 0.02);
    assert!(share(&rotors, |r| *r != still && r.scalar() == 1.0) > 0.1);
    assert!(share(&rotors, |r| r.scalar() == -1.0) > 0.02);
    assert!(share(&rotors, |r| r.scalar().abs() < 1e-16) > 0.02);
    assert!(share(&rotors, |r| (1e-14..1e-6).contains(&r.scalar().abs())) > 0.08);
    assert!(share(&rotors, |r| r.scalar() < -0.1) > 0.2);
    let singles: Vec<Rotor<f32>> = drawn(cga3::rotors());
    assert!(singles.iter().all(|r| off_unit(&r.map_to_f64()) < 1e-6));
}

#[test]
fn translators_translate_within_the_cube() {
    let shifts: Vec<Translator<f64>> = drawn(cga3::translators(SIZE));
    assert!(
        shifts
            .iter()
            .flat_map(|t| t.displacement())
            .all(|x| x.abs() <= SIZE)
    );
    assert!(share(&shifts, |t| t.displacement() == [0.0; 3]) > 0.1);
}

#[test]
fn motors_are_of_every_kind() {
    let motors: Vec<Motor<f64>> = drawn(cga3::motors(SIZE));
    let worst = motors.iter().map(off_unit).fold(0.0, f64::max);
    assert!(worst < 1e-14, "a motor is off by {worst}");
    let bivector = |m: &Motor<f64>| length([m.e12(), m.e13(), m.e23()]);
    let shift = |m: &Motor<f64>| length([m.e1i(), m.e2i(), m.e3i()]);
    for sign in [1.0, -1.0] {
        let is_sign = |m: &Motor<f64>| m.scalar() == sign && bivector(m) == 0.0 && shift(m) == 0.0;
        assert!(share(&motors, is_sign) > 0.05);
        let is_shift = |m: &Motor<f64>| m.scalar() == sign && bivector(m) == 0.0 && shift(m) > 0.0;
        assert!(share(&motors, is_shift) > 0.05);
    }
    let turns = |m: &Motor<f64>| bivector(m) > 1e-3;
    let slides = |m: &Motor<f64>| m.e123i().abs() > 1e-9;
    assert!(share(&motors, |m| turns(m) && shift(m) > 1e-3 && !slides(m)) > 0.05);
    assert!(share(&motors, |m| turns(m) && slides(m)) > 0.3);
    // The distances of points do not change.
    let points: Vec<[Point<f64>; 2]> = drawn(cga3::point_configurations(SIZE));
    for (motor, [p, q]) in motors.iter().zip(points) {
        let after = motor.transform(p).distance(motor.transform(q));
        assert_close!(p.distance(q), after, 1e-13, 4.0 * SIZE);
    }
}

#[test]
fn dilators_and_similarities_scale() {
    let dilators: Vec<Dilator<f64>> = drawn(cga3::dilators(100.0));
    assert!(
        dilators
            .iter()
            .all(|d| (0.00999..100.001).contains(&d.factor()))
    );
    assert_share(&dilators, 1.0 / 24.0, |d| d.factor() == 1.0);
    assert_share(&dilators, 1.0 / 24.0, |d| d.factor() > 99.999);
    assert_share(&dilators, 1.0 / 24.0, |d| d.factor() < 0.01001);
    assert_share(&dilators, 0.125, |d| {
        (d.factor() - 1.0).abs() < 2e-9 && d.factor() != 1.0
    });

    // All distances grow by one factor.
    let similarities = drawn(cga3::similarities::<f64>(SIZE, 100.0));
    let mut grown = Vec::new();
    for similarity in similarities {
        let corners = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 0.0, 4.0]].map(Point::from);
        let [p, q, r] = corners.map(|p| {
            similarity
                .transform(p)
                .centre()
                .expect("a point has a weight")
        });
        let factor = p.distance(q) / 3.0;
        assert!((0.0099..101.0).contains(&factor));
        assert_close!(q.distance(r), 5.0 * factor, 1e-10, 10.0 + factor);
        grown.push(factor);
    }
    assert!(
        share(&grown, |factor| *factor > 2.0) > 0.2 && share(&grown, |factor| *factor < 0.5) > 0.2
    );
}

trait MapToF64 {
    fn map_to_f64(&self) -> Motor<f64>;
}

impl MapToF64 for Rotor<f32> {
    fn map_to_f64(&self) -> Motor<f64> {
        let [s, a, b, c] = [self.scalar(), self.e12(), self.e13(), self.e23()].map(f64::from);
        Motor::new_unchecked(s, a, b, c, 0.0, 0.0, 0.0, 0.0)
    }
}
