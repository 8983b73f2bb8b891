//! Single precision: results are right up to a few rounding errors of f32.

use ga_runtime::{cga2, pga2, pga3, sta, vga2, vga3};
use nullcone_tests::plain::near_all;

/// A few times the rounding error of f32.
const TOLERANCE: f64 = 5e-7;

#[track_caller]
fn assert_single<const N: usize>(a: [f32; N], b: [f32; N]) {
    near_all(a.map(f64::from), b.map(f64::from), TOLERANCE);
}

#[test]
fn motors_of_space() {
    let axis = pga3::Line::from_point_direction([1.0_f32, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let screw = pga3::Motor::from_screw(axis, core::f32::consts::FRAC_PI_2, 0.5).unwrap();
    let image = screw.transform(pga3::Point::from([2.0, 0.0, 0.0]));
    assert_single(image.coordinates().unwrap(), [1.0, 1.0, 0.5]);
    let again = screw.log().exp();
    assert_single([again.e12(), again.e1230()], [screw.e12(), screw.e1230()]);
    let rotor = vga3::Rotor::from_axis_angle(vga3::Vector::new(0.0_f32, 3.0, 0.0), 1.25).unwrap();
    assert_single(rotor.log().normal(), [0.0, -0.625, 0.0]);
}

#[test]
fn motors_of_the_plane() {
    let turn = pga2::Motor::about([1.0_f32, 2.0], pga2::Rotor::from_angle(0.75).unwrap());
    let log = turn.log().unwrap();
    assert_single(log.coordinates().unwrap(), [1.0, 2.0]);
    let turn = cga2::Motor::about(
        cga2::Point::new(1.0_f32, 2.0),
        cga2::Rotor::from_angle(0.75).unwrap(),
    );
    assert_single(turn.centre().unwrap().coordinates(), [1.0, 2.0]);
    let rotor = vga2::Rotor::between(
        vga2::Vector::new(1.0_f32, 0.0),
        vga2::Vector::new(-1.0, 1e-4),
    )
    .unwrap();
    assert_single([rotor.angle()], [core::f32::consts::PI - 1e-4]);
    let [p, q, r] = [[3.0_f32, 0.0], [0.0, 1.0], [-3.0, 0.0]].map(cga2::Point::from);
    assert_single([cga2::Circle::through(p, q, r).radius().unwrap()], [5.0]);
}

#[test]
fn boosts() {
    let boost = sta::Rotor::from_velocity([0.0_f32, 0.6, 0.0]).unwrap();
    assert_single(boost.velocity(), [0.0, 0.6, 0.0]);
    assert_single(
        boost.log().unwrap().electric(),
        [0.0, 0.5 * 0.6_f32.atanh(), 0.0],
    );
    let field = sta::Bivector::from_fields([0.25_f32, 0.5, 0.0], [0.0, 0.25, 1.0]);
    let again = field.exp().unwrap().log().unwrap();
    assert_single(again.electric(), field.electric());
    assert_single(again.magnetic(), field.magnetic());
    assert!(sta::Rotor::from_velocity([1.0_f32, 0.0, 0.0]).is_err());
}
