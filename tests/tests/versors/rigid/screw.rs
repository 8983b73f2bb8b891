//! Screws of motions: found, built, and absent.

use std::f64::consts::PI;

use ga_runtime::cga3::{Dilator, Line, Motor, Point, Rotor, Translator};
use ga_runtime::geometry::Screw;
use nullcone_tests::plain::{Vector, largest_difference, motor_coefficients, motor_of};

use super::screw;

#[test]
fn screws_of_special_motions() {
    let origin = Point::<f64>::default();
    let check = |motor: Motor<f64>, direction: Vector, angle: f64, displacement: f64| {
        let found = motor.screw().expect("finite");
        let error = largest_difference(found.axis.direction(), direction);
        assert!(error <= 1e-15, "{motor}: {found:?}");
        assert!(
            found.axis.distance(origin).expect("a line") <= 1e-15,
            "{motor}: {found:?}"
        );
        assert!((found.angle - angle).abs() <= 1e-15, "{motor}: {found:?}");
        assert!(
            (found.displacement - displacement).abs() <= 1e-15,
            "{motor}: {found:?}"
        );
        let again = found.to_motor().expect("finite");
        assert!(
            largest_difference(motor_coefficients(again), motor_coefficients(motor))
                <= 1e-15 * (1.0 + displacement.abs()),
            "{motor}"
        );
    };
    let one = Motor::<f64>::default();
    let shift = Motor::from(Translator::from_displacement([0.0, 3.0, 4.0]));
    check(one, [0.0, 0.0, 1.0], 0.0, 0.0);
    check(shift, [0.0, 0.6, 0.8], 0.0, 5.0);
    check(-one, [0.0, 0.0, -1.0], 2.0 * PI, 0.0);
    let half = Rotor::from_axis_angle([0.0, 0.0, 1.0], PI).expect("an axis");
    check(half.into(), [0.0, 0.0, 1.0], PI, 0.0);
    check(-Motor::from(half), [0.0, 0.0, -1.0], PI, 0.0);
    // The negative of a translator: about its axis, in one direction or the other.
    let found = (-shift).screw().expect("finite");
    assert!((found.displacement.abs() - 5.0).abs() <= 1e-14);
    assert!(
        (found.angle - 2.0 * PI).abs() <= 1e-15
            && found.axis.distance(origin).expect("a line") <= 1e-15
    );
    assert!(
        largest_difference(
            motor_coefficients(found.to_motor().expect("finite")),
            motor_coefficients(-shift)
        ) <= 1e-14
    );
    // Almost a full rotation, about an axis away from the origin.
    let almost = screw([1.0, 2.0, 0.0], [0.0, 0.0, 1.0], 2.0 * PI - 1e-6, 0.5);
    let found = motor_of(almost).screw().expect("finite");
    let support = found.axis.support().expect("a line").coordinates();
    assert!(
        largest_difference(support, [1.0, 2.0, 0.0]) <= 1e-9
            && (found.displacement - 0.5).abs() <= 1e-9
    );
    assert!(
        largest_difference(
            motor_coefficients(found.to_motor().expect("finite")),
            almost
        ) <= 1e-9
    );
    // Small rotations about near and far axes; beyond the precision of the scalar they are
    // translations.
    for angle in [1e-3, 1e-8, 1e-100, 1e-200] {
        for far in [1.0, 1e8, 1e100] {
            let given = screw([far, 0.0, 0.0], [0.0, 0.0, 1.0], angle, 1.0);
            let found = motor_of(given).screw().expect("finite");
            let support = found.axis.support().expect("a line").coordinates();
            // A large translation along the axis rounds off a much smaller one perpendicular to it.
            if far * angle > 1e-8 {
                assert!((support[0] / far - 1.0).abs() <= 1e-7, "{angle:e}, {far:e}");
            }
        }
    }
    let beyond = Motor::new_unchecked(1.0, 0.0, 0.0, 1e-300, 0.0, 1e100, 0.0, 0.0);
    let found = beyond.screw().expect("finite");
    assert_eq!((found.angle, found.displacement), (0.0, 2e100));
}

#[test]
fn what_is_not_a_screw_gives_none() {
    let base = screw([1.0, 2.0, 3.0], [0.6, 0.0, 0.8], 1.0, 0.5);
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..8 {
            let mut given = base;
            given[place] = wrong;
            assert_eq!(motor_of(given).screw(), None, "{wrong} at {place}");
        }
        let axis = Line::from_point_direction(Point::default(), [0.0, 0.0, 1.0]);
        let bent = Line::from_point_direction(Point::default(), [0.0, wrong, 1.0]);
        for (axis, angle, displacement) in
            [(axis, wrong, 1.0), (axis, 1.0, wrong), (bent, 1.0, 1.0)]
        {
            let screw = Screw {
                axis,
                angle,
                displacement,
            };
            assert_eq!((screw.to_motor(), screw.generator()), (None, None));
        }
        assert_eq!(Rotor::from_rotation_vector([0.0, wrong, 1.0]), None);
        assert_eq!(
            (Dilator::exp(wrong), Dilator::default().powf(wrong)),
            (None, None)
        );
    }
    let nowhere = Line::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let screw = Screw {
        axis: nowhere,
        angle: 1.0,
        displacement: 1.0,
    };
    assert_eq!((screw.to_motor(), screw.generator()), (None, None));
    assert_eq!(
        Screw {
            angle: 0.0,
            ..screw
        }
        .pitch(),
        None
    );
    assert_eq!((Dilator::exp(711.0), Dilator::exp(-711.0)), (None, None));
    let large = Dilator::from_factor(1e300).expect("positive");
    assert_eq!(large.powf(3.0), None);
}
