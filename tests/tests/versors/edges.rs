//! Edge cases of versors and maps: signs, singular matrices, full rotations, numbers near the end
//! of their range.

use ga_runtime::Element;
use ga_runtime::cga3::{
    Bivector, DualPlane, Even, EvenVersor, Motor, MotorGenerator, OddVersor, Point, Rotor,
    Similarity, Translator, Transversor,
};
use ga_runtime::geometry::motion::{MotorSpline, SplineError};
use ga_runtime::geometry::{Affine, NotConformal, RotationPath, velocity_sum};
use ga_runtime::{pga3, sta, vga3};
use nullcone_tests::plain::{cross, dot, largest};
use proptest::prelude::*;

/// The largest difference of coefficients, relative to the largest of the second but at least 1.
fn deviation(a: EvenVersor<f64>, b: EvenVersor<f64>) -> f64 {
    let blades = EvenVersor::<f64>::BLADES;
    let size = blades
        .iter()
        .fold(1.0_f64, |most, &blade| most.max(b.coefficient(blade).abs()));
    let off = |&blade: &usize| (a.coefficient(blade) - b.coefficient(blade)).abs() / size;
    largest(blades.iter().map(off))
}

#[test]
fn logarithms_near_minus_one_survive_a_round_trip() {
    let place = [0.3, -0.4, 0.5];
    for size in [1e-8, 1e-6, 1e-5, 1e-3, 0.1] {
        for place in [place, [1.0, 0.0, 0.0], [0.0; 3]] {
            let there = EvenVersor::from(Motor::from(Translator::from_displacement(place)));
            let bend = Transversor::from_vector([size, 0.2 * size, -0.3 * size]);
            let versor = -(there * EvenVersor::from(bend) * there.reverse());
            let again = versor.log().exp().expect("finite");
            assert!(
                deviation(again, versor) < 1e-9,
                "bend {size} about {place:?}: {}",
                deviation(again, versor)
            );
            let root = versor.sqrt().expect("finite");
            assert!(
                deviation(root * root, versor) < 1e-9,
                "root of bend {size} about {place:?}"
            );
        }
    }
    for shift in [1e-12, 1e-6, 1.0, 1e3] {
        let versor = -EvenVersor::from(Motor::from(Translator::from_displacement([
            shift,
            0.0,
            0.5 * shift,
        ])));
        let again = versor.log().exp().expect("finite");
        assert!(
            deviation(again, versor) < 1e-9,
            "shift {shift}: {}",
            deviation(again, versor)
        );
    }
}

#[test]
fn two_rotations_whose_angles_add_to_a_full_one_survive_a_round_trip() {
    for share in [0.01, 0.1, 0.7, 1.3] {
        // Rotations in the commuting planes e12 and e3∧(eo − ½ei), by angles that add up to 2π.
        let other = std::f64::consts::PI - share;
        let generator = Bivector {
            e12: share,
            e3o: other,
            e3i: -0.5 * other,
            ..Bivector::default()
        };
        let versor = generator.exp().expect("finite");
        let again = versor.log().exp().expect("finite");
        assert!(
            deviation(again, versor) < 1e-9,
            "share {share}: {}",
            deviation(again, versor)
        );
    }
}

#[test]
fn a_rotor_from_a_matrix_goes_the_short_way() {
    for axis in 0..3 {
        for step in -40..=40 {
            let angle = f64::from(step) * 0.157;
            let mut n = [0.1, -0.2, 0.15];
            n[axis] = 1.0;
            let rotor = Rotor::from_axis_angle(n, angle).expect("an axis");
            let again = Rotor::from_matrix(rotor.to_matrix()).expect("a rotation");
            assert!(
                again.scalar() >= 0.0,
                "{angle} about {axis}: {}",
                again.scalar()
            );
            assert_eq!(again.path(), RotationPath::Short);
            let motor = Translator::from_displacement([1.0, 2.0, 3.0]) * rotor;
            assert!(
                Motor::from_matrix(motor.to_matrix())
                    .expect("a motion")
                    .scalar()
                    >= 0.0
            );
        }
    }
}

#[test]
fn singular_matrices_have_no_inverse() {
    let singular = [
        [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]],
        [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 1.0, 7.0]],
        [[0.1, 0.2, 0.3], [0.2, 0.4, 0.6], [0.3, 0.7, 0.1]],
        [[1.0, 2.0, 3.0], [0.0; 3], [3.0, 1.0, 7.0]],
        [[0.0, 2.0, 3.0], [0.0, 4.0, 1.0], [0.0, 1.0, 7.0]],
    ];
    for linear in singular {
        let map = Affine::new(linear, [0.0; 3]);
        assert_eq!(map.inverse(), None, "{linear:?}");
        assert_eq!(
            Motor::try_from(map).err(),
            Some(NotConformal::Singular),
            "{linear:?}"
        );
    }
    // Regular, though the determinant is beyond the range of the scalar.
    let thin = Affine::scaling([1.0_f64, 1e-200, 1e-200])
        .inverse()
        .expect("regular");
    assert_eq!(thin.linear[0], [1.0, 0.0, 0.0]);
    assert!((thin.linear[1][1] / 1e200 - 1.0).abs() < 1e-15);
    let single = Affine::scaling([1.0_f32, 1e-25, 1e-25])
        .inverse()
        .expect("regular");
    assert!((single.linear[2][2] / 1e25 - 1.0).abs() < 1e-6);
    let columns = Affine::new(
        [[1.0_f64, 1e-20, 0.0], [1.0, 2e-20, 0.0], [0.0, 0.0, 1.0]],
        [0.0; 3],
    );
    let inverse = columns.inverse().expect("regular");
    assert!((inverse.linear[1][1] / 1e20 - 1.0).abs() < 1e-12);
}

proptest! {
    #[test]
    fn inverses_undo(entries in prop::array::uniform9(-2.0..2.0_f64), scales in prop::array::uniform3(-30.0..30.0_f64)) {
        let mut linear = [[0.0; 3]; 3];
        for (k, entry) in entries.into_iter().enumerate() {
            linear[k / 3][k % 3] = entry * 10_f64.powf(scales[k / 3]);
        }
        let [a, b, c] = linear.map(|row| {
            let size = row.iter().map(|x| x * x).sum::<f64>().sqrt();
            row.map(|x| x / size)
        });
        prop_assume!(dot(a, cross(b, c)).abs() > 0.01);
        let map = Affine::new(linear, [0.0; 3]);
        let both = map.inverse().expect("regular") * map;
        for (k, row) in both.linear.into_iter().enumerate() {
            for (l, entry) in row.into_iter().enumerate() {
                prop_assert!((entry - f64::from(u8::from(k == l))).abs() < 1e-11, "{both:?}");
            }
        }
    }

    #[test]
    fn fixed_points_stay_near_the_factor_one(exponent in -15.0..-1.0_f64, angle in 0.5..5.5_f64, t in prop::array::uniform2(-2.0..2.0_f64)) {
        let turn = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).expect("an axis");
        let factor = 1.0 + 10_f64.powf(exponent);
        let similarity = Similarity::from_parts([t[0], t[1], 0.0], turn, factor).expect("a similarity");
        let fixed = similarity.fixed_point().expect("no plain motion");
        let image = Affine::from(similarity).transform(fixed);
        prop_assert!(image.distance(fixed) < 1e-13, "{} at {factor}", image.distance(fixed));
    }

    #[test]
    fn lines_perpendicular_to_a_plane_have_no_projection(k in 1..1000_i32) {
        let n = [0.1 * f64::from(k) + 0.1, 0.2, 0.7];
        let plane = pga3::Plane::from_normal_distance(n, 1.0);
        let line = pga3::Line::from_point_direction([1.0, 2.0, 3.0], n);
        prop_assert_eq!(plane.project(line), None);
    }

    #[test]
    fn sums_of_velocities_stay_below_light(a in -16.0..-1.0_f64, b in -16.0..-1.0_f64, n in prop::array::uniform3(-1.0..1.0_f64), m in prop::array::uniform3(-1.0..1.0_f64)) {
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        prop_assume!(length(n) > 0.1 && length(m) > 0.1);
        let speed = |v: [f64; 3], s: f64| v.map(|x| x / length(v) * (1.0 - 10_f64.powf(s)));
        let Ok(sum) = velocity_sum(speed(n, a), speed(m, b)) else {
            return Ok(());
        };
        prop_assert!(velocity_sum(sum, [0.0; 3]).is_ok(), "{sum:?}");
    }
}

#[test]
fn null_bivectors_of_spacetime_survive_a_round_trip() {
    for size in [1e-3_f64, 1.0, 1e2, 1e4, 1e6, 1e7] {
        // Electric and magnetic parts that are perpendicular and of equal magnitude: a plane wave.
        // Powers of two keep it exactly null.
        let size = 2_f64.powi(size.log2().round() as i32);
        let (e, b) = ([size, 0.0, 0.0], [0.0, size, 0.0]);
        let wave = sta::Bivector::from_fields(e, b);
        let rotor = sta::Rotor::new_unchecked(
            1.0, wave.g10, wave.g20, wave.g30, wave.g32, wave.g13, wave.g21, 0.0,
        );
        let log = rotor.log().expect("a logarithm");
        for (found, expected) in [(log.electric(), e), (log.magnetic(), b)] {
            for (x, y) in found.into_iter().zip(expected) {
                assert!((x - y).abs() <= 1e-12 * size, "{size}: {x} is not {y}");
            }
        }
    }
    // The same with coefficients that round.
    for size in [1e4_f64, 1e6, 1e7] {
        let (n, m) = (
            [0.6 * size, 0.8 * size, 0.0],
            [-0.8 * size, 0.6 * size, 0.0],
        );
        let wave = sta::Bivector::from_fields(n, m);
        let rotor = sta::Rotor::new_unchecked(
            1.0, wave.g10, wave.g20, wave.g30, wave.g32, wave.g13, wave.g21, 0.0,
        );
        let log = rotor.log().expect("a logarithm");
        for (x, y) in log
            .electric()
            .into_iter()
            .chain(log.magnetic())
            .zip(n.into_iter().chain(m))
        {
            assert!((x - y).abs() <= 1e-12 * size, "{size}: {x} is not {y}");
        }
    }
}

#[test]
fn similarities_are_repaired() {
    let step = Similarity::from_parts(
        [0.001, 0.0, 0.002],
        Rotor::from_axis_angle([1.0, 2.0, 3.0], 0.01_f32).expect("an axis"),
        1.0,
    )
    .expect("a similarity");
    let mut drifted =
        Even::from(Similarity::from_parts([0.0; 3], Rotor::default(), 1.0_f32).expect("one"));
    for _ in 0..100_000 {
        drifted *= Even::from(step);
    }
    let whole = |v: Even<f32>| (v * v.reverse()).scalar;
    assert!((whole(drifted) - 1.0).abs() > 1e-5, "no drift to repair");
    let repaired = Similarity::normalize(drifted).expect("near a similarity");
    assert!((whole(repaired.into()) - 1.0).abs() < 1e-5);
    assert!((repaired.factor() - 1.0).abs() < 0.1);
    assert_eq!(Similarity::<f64>::normalize(Even::default()), None);
    assert_eq!(
        Similarity::normalize(Even {
            scalar: f64::NAN,
            ..Even::default()
        }),
        None
    );
}

#[test]
fn numbers_near_the_end_of_the_range() {
    let rotor = vga3::Bivector::new(1.7e308_f64, 1.7e308, 0.0).exp();
    assert!(rotor.scalar().is_finite() && rotor.e12().is_finite() && rotor.e13().is_finite());
    assert!(
        vga3::Bivector::new(f64::NAN, 0.0, 0.0)
            .exp()
            .scalar()
            .is_nan()
    );
    let mirror = OddVersor::reflection(DualPlane::new(1e-310, 0.0, 0.0, 0.0)).expect("a plane");
    let image = mirror
        .transform_point(Point::new(2.0, 1.0, 0.0))
        .expect("finite");
    assert_eq!(image, Point::new(-2.0, 1.0, 0.0));
    let still = MotorGenerator::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let keys = [
        (0.0, Motor::default(), still),
        (1e-310, Motor::default(), still),
    ];
    assert!(matches!(
        MotorSpline::with_velocities(&keys),
        Err(SplineError::OutOfRange { index: 0 })
    ));
    let long = MotorSpline::through(&[
        (0.0_f64, Motor::default()),
        (
            1e308,
            Motor::from(Translator::from_displacement([1.0, 0.0, 0.0])),
        ),
        (
            1.7e308,
            Motor::from(Translator::from_displacement([1.7, 0.0, 0.0])),
        ),
    ])
    .expect("in range");
    let way = long
        .evaluate(0.5e308)
        .expect("a time")
        .translator()
        .displacement();
    assert!((way[0] - 0.5).abs() < 1e-12, "{way:?}");
}
