//! The paper's leg against independent matrices, and there and back.

use ga_anim::kinematics::KinematicsError;
use ga_anim::leg::{Leg, LegAngles};
use ga_anim::skin::Method;
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::{Motor, Point, Rotor};
use proptest::prelude::*;
use serde_json::Value;

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|k| value[k].as_f64().expect("a number"))
}

fn near(what: &str, found: &[f64], expected: &[f64]) {
    for (a, b) in found.iter().zip(expected) {
        assert!(
            (a - b).abs() <= 1e-12,
            "{what}: {found:?} is not {expected:?}"
        );
    }
}

fn angles([hip_z, hip_y, hip_x, knee, ankle_x, ankle_z]: [f64; 6]) -> LegAngles {
    LegAngles {
        hip_z,
        hip_y,
        hip_x,
        knee,
        ankle_x,
        ankle_z,
    }
}

fn array(a: &LegAngles) -> [f64; 6] {
    [a.hip_z, a.hip_y, a.hip_x, a.knee, a.ankle_x, a.ankle_z]
}

#[test]
fn cases_of_the_oracle() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/leg.json"));
    let oracle: Value = serde_json::from_str(&text.expect("committed")).expect("JSON");
    let cases = oracle["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), 24);
    for case in cases {
        let [thigh, calf, foot] = numbers(&case["length"]);
        let leg = Leg::new(thigh, calf, foot).unwrap();
        let stated = numbers(&case["angles"]);
        let hip = Point::from(numbers::<3>(&case["hip"]));
        let pose = leg.forward(hip, &angles(stated)).unwrap();
        for (name, place) in [
            ("hip", pose.hip),
            ("knee", pose.knee),
            ("ankle", pose.ankle),
            ("toe", pose.toe),
        ] {
            near(name, &place.coordinates(), &numbers::<3>(&case[name]));
        }
        for (name, motion) in ["hip_matrix", "knee_matrix", "ankle_matrix"]
            .iter()
            .zip(pose.motions)
        {
            for (row, found) in motion.rotor().to_matrix().iter().enumerate() {
                near(name, found, &numbers::<3>(&case[name][row]));
            }
        }
        let number = |name: &str| case[name].as_f64().expect("a number");
        near(
            "knee angle",
            &[pose.knee_interior_angle()],
            &[number("knee_interior_angle")],
        );
        near(
            "distance",
            &[pose.hip_ankle_distance()],
            &[number("hip_ankle_distance")],
        );
        near(
            "inner product",
            &[pose.hip | pose.ankle],
            &[number("hip_ankle_squared_over_minus_2")],
        );
        // Each bone is the line through its joints: both lie on it.
        let joints = [pose.hip, pose.knee, pose.ankle, pose.toe];
        for (bone, ends) in pose.bones().iter().zip(joints.windows(2)) {
            near(
                "on bone",
                &[
                    bone.distance(ends[0]).unwrap(),
                    bone.distance(ends[1]).unwrap(),
                ],
                &[0.0, 0.0],
            );
        }
        let (place, found) = leg.inverse(&pose.motions, 1e-9).unwrap();
        near("hip again", &place.coordinates(), &hip.coordinates());
        near("angles again", &array(&found), &stated);
        let joints = [pose.hip, pose.knee, pose.ankle];
        let seen = leg.inverse_of_points(joints, pose.motions[2].rotor(), 1e-12);
        near("angles of the points", &array(&seen.unwrap()), &stated);
        // The knee of the oracle bends backwards, so it is found again by reaching with itself as
        // the pole.
        let reached = leg.reach(hip, pose.ankle, pose.knee).unwrap();
        near("reach", &array(&reached)[..4], &stated[..4]);
    }
}

fn ranges() -> impl Strategy<Value = [f64; 6]> {
    let whole = -3.1..3.1_f64;
    (
        whole.clone(),
        -1.5..1.5_f64,
        whole.clone(),
        whole.clone(),
        whole.clone(),
        whole,
    )
        .prop_map(|(a, b, c, d, e, f)| [a, b, c, d, e, f])
}

fn leg() -> Leg {
    Leg::new(0.45, 0.41, 0.22).expect("lengths")
}

proptest! {
    #[test]
    fn angles_come_back(stated in ranges(), hip in prop::array::uniform3(-2.0..2.0_f64)) {
        let pose = leg().forward(Point::from(hip), &angles(stated)).unwrap();
        let (place, found) = leg().inverse(&pose.motions, 1e-9).unwrap();
        prop_assert!(place.distance(Point::from(hip)) < 1e-14);
        for (a, b) in array(&found).iter().zip(stated) {
            prop_assert!((a - b).abs() < 1e-12, "{found:?} is not {stated:?}");
        }
        // And the places come back from the angles that were found.
        let again = leg().forward(place, &found).unwrap();
        for (a, b) in [(pose.knee, again.knee), (pose.ankle, again.ankle), (pose.toe, again.toe)] {
            prop_assert!(a.distance(b) < 1e-12);
        }
    }

    #[test]
    fn the_lock_of_the_hip_loses_no_turn(stated in ranges(), digits in 1..17_i32, above in prop::bool::ANY) {
        let near = std::f64::consts::FRAC_PI_2 - 10.0_f64.powi(-digits);
        let mut stated = stated;
        stated[1] = if above { near } else { -near };
        let pose = leg().forward(Point::new(0.0, 0.0, 0.0), &angles(stated)).unwrap();
        let (place, found) = leg().inverse(&pose.motions, 1e-9).unwrap();
        let again = leg().forward(place, &found).unwrap();
        for (a, b) in pose.motions.iter().zip(again.motions) {
            for (row, other) in a.to_matrix().iter().zip(b.to_matrix()) {
                prop_assert!(row.iter().zip(other).all(|(x, y): (&f64, f64)| (x - y).abs() < 1e-14), "{stated:?}");
            }
        }
    }

    #[test]
    fn angles_come_back_from_points(stated in ranges(), hip in prop::array::uniform3(-2.0..2.0_f64)) {
        let mut stated = stated;
        stated[5] *= 0.5; // An ankle rolls by less than a quarter turn.
        let pose = leg().forward(Point::from(hip), &angles(stated)).unwrap();
        let found = leg().inverse_of_points([pose.hip, pose.knee, pose.ankle], pose.motions[2].rotor(), 1e-9).unwrap();
        // The hinge is seen as well as the leg or the foot is bent, and turns about y near the lock
        // are seen less well.
        let seen = stated[3].sin().abs().max(stated[4].cos().abs());
        let within = 1e-14 / (seen * stated[1].cos());
        for (a, b) in array(&found).iter().zip(stated) {
            prop_assert!((a - b).abs() < within, "{found:?} is not {stated:?}");
        }
    }

    #[test]
    fn places_come_back_from_any_angles(
        stated in ranges(),
        hip in prop::array::uniform3(-2.0..2.0_f64),
        straight in (-17..0_i32, -17..0_i32, prop::bool::ANY),
    ) {
        // Also with thigh, calf and foot all but in line, where the hinge does not show.
        let mut stated = stated;
        if straight.2 {
            stated[3] = 10.0_f64.powi(straight.0);
            stated[4] = std::f64::consts::FRAC_PI_2 - 10.0_f64.powi(straight.1);
        }
        let pose = leg().forward(Point::from(hip), &angles(stated)).unwrap();
        let found = leg().inverse_of_points([pose.hip, pose.knee, pose.ankle], pose.motions[2].rotor(), 1e-9).unwrap();
        let again = leg().forward(pose.hip, &found).unwrap();
        for (a, b) in [(pose.knee, again.knee), (pose.ankle, again.ankle), (pose.toe, again.toe)] {
            prop_assert!(a.distance(b) < 1e-12, "{found:?} from {stated:?}");
        }
        for (row, other) in pose.motions[2].to_matrix().iter().zip(again.motions[2].to_matrix()) {
            prop_assert!(row.iter().zip(other).all(|(x, y): (&f64, f64)| (x - y).abs() < 1e-12), "{found:?} from {stated:?}");
        }
    }

    #[test]
    fn a_bent_leg_reaches_where_it_is(stated in ranges(), digits in 0..9_i32, far in 0..4_i32, scale in -150..150_i32) {
        let bend = 10.0_f64.powi(-digits);
        let bent = LegAngles { knee: bend, ankle_x: 0.0, ankle_z: 0.0, ..angles(stated) };
        let hip = Point::new(10.0_f64.powi(far), 0.3, -0.2);
        let pose = leg().forward(hip, &bent).unwrap();
        let found = leg().reach(hip, pose.ankle, pose.motions[0].transform(Point::new(0.0, -0.4, 1.0))).unwrap();
        // What the coordinates of the ankle are rounded to is divided by the bend: the distance of
        // the ankle, 0.86, is 0.107 of the bend's square below that of a straight leg.
        let within = 5e-14 * 10.0_f64.powi(far) / (bend * stated[1].cos());
        for (a, b) in array(&found).iter().zip(array(&bent)) {
            prop_assert!((a - b).abs() < within, "{found:?} is not {bent:?}");
        }
        // The unit of length does not matter.
        let unit = 10.0_f64.powi(scale);
        let other = Leg::new(0.45 * unit, 0.41 * unit, 0.22 * unit).unwrap();
        let pose = other.forward(Point::default(), &bent).unwrap();
        let pole = pose.motions[0].transform(Point::new(0.0, -0.4 * unit, unit));
        let found = other.reach(pose.hip, pose.ankle, pole).unwrap();
        for (a, b) in array(&found).iter().zip(array(&bent)) {
            prop_assert!((a - b).abs() < within, "{found:?} is not {bent:?}");
        }
    }

    #[test]
    fn a_stretched_leg_reaches_where_it_is(stated in ranges(), hip in prop::array::uniform3(-2.0..2.0_f64)) {
        let straight = LegAngles { knee: 0.0, ..angles(stated) };
        let pose = leg().forward(Point::from(hip), &straight).unwrap();
        let pole = pose.motions[0].transform(Point::new(0.0, -0.4, 1.0));
        let found = leg().reach(pose.hip, pose.ankle, pole).unwrap();
        let again = leg().forward(pose.hip, &found).unwrap();
        // The bend may be as much as the square root of what is lost in the distance; the ankle
        // loses no more than that itself.
        prop_assert!(again.ankle.distance(pose.ankle) < 1e-14 && found.knee.abs() < 1e-6);
        // A pole in line with the leg shows no side.
        let along = pose.motions[0].transform(Point::new(0.0, -2.0, 0.0));
        prop_assert!(matches!(leg().reach(pose.hip, pose.ankle, along), Err(KinematicsError::LegPole)));
    }

    #[test]
    fn the_ankle_reaches_its_target(
        hip in prop::array::uniform3(-1.0..1.0_f64),
        offset in prop::array::uniform3(-0.6..0.6_f64),
        pole in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let target: [f64; 3] = std::array::from_fn(|k| hip[k] + offset[k]);
        let [hip, target, pole] = [hip, target, pole].map(Point::from);
        let distance = hip.distance(target);
        match leg().reach(hip, target, pole) {
            Ok(found) => {
                let pose = leg().forward(hip, &found).unwrap();
                prop_assert!(pose.ankle.distance(target) < 1e-14, "{found:?}");
                prop_assert!((0.0..=std::f64::consts::PI).contains(&found.knee));
                // In the plane of the pole, and on its side.
                let aside = ga_runtime::cga3::Line::through(hip, target);
                let (foot, base) = (aside.foot(pose.knee).unwrap(), aside.foot(pole).unwrap());
                let side = |p: Point<f64>, q: Point<f64>| -> [f64; 3] {
                    std::array::from_fn(|k| p.coordinates()[k] - q.coordinates()[k])
                };
                let (a, b) = (side(pose.knee, foot), side(pole, base));
                let together: f64 = (0..3).map(|k| a[k] * b[k]).sum();
                let sizes = pose.knee.distance(foot) * pole.distance(base);
                prop_assert!((together - sizes).abs() <= 1e-12);
            }
            Err(KinematicsError::LegUnreachable { distance: stated, least, most }) => {
                prop_assert_eq!(stated, distance);
                prop_assert!(distance < least || distance > most);
            }
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        }
    }
}

#[test]
fn skin_follows_its_segments() {
    let bent = LegAngles {
        knee: 1.2,
        hip_x: -0.4,
        ..LegAngles::default()
    };
    let pose = leg().forward(Point::new(0.0, 1.0, 0.0), &bent).unwrap();
    let points = [[0.05, -0.2, 0.0], [0.0, -0.45, 0.05], [0.0, -0.86, 0.1]].map(Point::from);
    let weights = SkinWeights::new(
        3,
        [vec![(0, 1.0)], vec![(0, 0.5), (1, 0.5)], vec![(2, 1.0)]],
    )
    .unwrap();
    for method in [Method::Linear, Method::Motor] {
        let moved = pose.skin(&points, &weights, method).unwrap();
        assert!(moved[0].distance(pose.motions[0].transform(points[0])) < 1e-15);
        assert!(moved[2].distance(pose.motions[2].transform(points[2])) < 1e-15);
        // Half way between thigh and calf by either blend lies in the plane of the leg.
        assert!(moved[1].e1().abs() < 1e-15);
    }
    // The blend of both motors turns the kneecap about the knee by half the bend.
    let kneecap = pose.skin(&points, &weights, Method::Motor).unwrap()[1];
    let half = leg()
        .forward(pose.hip, &LegAngles { knee: 0.6, ..bent })
        .unwrap();
    assert!(kneecap.distance(half.motions[1].transform(points[1])) < 1e-14);
}

#[test]
fn bad_input_is_named() {
    assert!(matches!(
        Leg::new(0.4, 0.0, 0.2),
        Err(KinematicsError::LegLength {
            segment: "calf",
            ..
        })
    ));
    assert!(matches!(
        Leg::new(f64::NAN, 0.4, 0.2),
        Err(KinematicsError::LegLength {
            segment: "thigh",
            ..
        })
    ));
    let origin = Point::new(0.0, 0.0, 0.0);
    let wrong = LegAngles {
        ankle_z: f64::INFINITY,
        ..LegAngles::default()
    };
    assert!(matches!(
        leg().forward(origin, &wrong),
        Err(KinematicsError::LegAngle {
            angle: "ankle_z",
            ..
        })
    ));
    let nowhere = Point::new(f64::NAN, 0.0, 0.0);
    assert!(matches!(
        leg().forward(nowhere, &LegAngles::default()),
        Err(KinematicsError::LegPlace { place: "hip", .. })
    ));
    let below = Point::new(0.0, -0.5, 0.0);
    assert!(matches!(
        leg().reach(origin, below, Point::new(0.0, 3.0, 0.0)),
        Err(KinematicsError::LegPole)
    ));
    assert!(matches!(
        leg().reach(origin, origin, below),
        Err(KinematicsError::LegUnreachable { .. })
    ));
    let rest = leg().rest();
    let seen = |ankle, foot| leg().inverse_of_points([rest[0], rest[1], ankle], foot, 1e-9);
    let level = Rotor::default();
    assert!(seen(rest[2], level).is_ok());
    assert!(matches!(
        seen(Point::new(0.0, -0.9, 0.0), level),
        Err(KinematicsError::LegBone {
            segment: "calf",
            ..
        })
    ));
    assert!(matches!(
        seen(nowhere, level),
        Err(KinematicsError::LegPlace { place: "ankle", .. })
    ));
    // Thigh and calf show a hinge along z, and the foot is not across that.
    let tilted = Rotor::from_axis_angle([0.0, 1.0, 0.0], 1.0).unwrap();
    assert!(matches!(
        seen(Point::new(0.41, -0.45, 0.0), tilted),
        Err(KinematicsError::LegNotHinged { joint: "ankle", .. })
    ));
    // The calf is bent to the side a little, and the hinge is that of the foot.
    let (sine, cosine) = 0.01_f64.sin_cos();
    let aside = Point::new(0.41 * sine, -0.45 - 0.41 * cosine, 0.0);
    assert!(
        matches!(seen(aside, level), Err(KinematicsError::LegNotHinged { joint: "knee", angle }) if (angle.abs() - 0.01).abs() < 1e-12)
    );
    let mut motions = [Motor::default(); 3];
    motions[1] = Motor::about(
        Point::new(0.0, -0.45, 0.0),
        Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.3).unwrap(),
    );
    motions[2] = motions[1];
    assert!(matches!(
        leg().inverse(&motions, 1e-9),
        Err(KinematicsError::LegNotHinged { joint: "knee", .. })
    ));
    motions[1] = Motor::from(ga_runtime::cga3::Translator::from_displacement([
        0.1, 0.0, 0.0,
    ]));
    assert!(matches!(
        leg().inverse(&motions, 1e-9),
        Err(KinematicsError::LegApart { joint: "knee", .. })
    ));
}

#[test]
fn a_leg_all_in_line_gives_its_turn_to_the_hip() {
    // The foot points down along the calf and has turned by 0.4 about it: seen from the rest, a
    // turn of the whole leg about y.
    let stated = angles([0.0, 0.4, 0.0, 0.0, std::f64::consts::FRAC_PI_2, 0.0]);
    let pose = leg().forward(Point::new(0.1, 0.2, 0.3), &stated).unwrap();
    let joints = [pose.hip, pose.knee, pose.ankle];
    let found = leg()
        .inverse_of_points(joints, pose.motions[2].rotor(), 1e-9)
        .unwrap();
    near("in line", &array(&found), &array(&stated));
    // The same places by the ankle's turn about the foot: the hip has it nevertheless.
    let turned = angles([0.0, 0.0, 0.0, 0.0, std::f64::consts::FRAC_PI_2, -0.4]);
    let pose = leg().forward(pose.hip, &turned).unwrap();
    let joints = [pose.hip, pose.knee, pose.ankle];
    let found = leg()
        .inverse_of_points(joints, pose.motions[2].rotor(), 1e-9)
        .unwrap();
    near("turned", &[found.ankle_z], &[0.0]);
    near("turned", &[found.hip_y.abs()], &[0.4]);
}

#[test]
fn a_knee_that_bends_the_wrong_way_is_negative() {
    let stated = angles([0.1, 0.2, -0.3, -0.05, 0.1, 0.2]);
    let pose = leg().forward(Point::default(), &stated).unwrap();
    let joints = [pose.hip, pose.knee, pose.ankle];
    let found = leg()
        .inverse_of_points(joints, pose.motions[2].rotor(), 1e-9)
        .unwrap();
    near("knee", &array(&found), &array(&stated));
}

#[test]
fn a_stretched_leg_and_a_locked_hip() {
    let origin = Point::new(0.0, 0.0, 0.0);
    let stretched = leg()
        .reach(
            origin,
            Point::new(0.0, 0.0, 0.86),
            Point::new(0.0, 1.0, 0.0),
        )
        .unwrap();
    let pose = leg().forward(origin, &stretched).unwrap();
    assert!(pose.ankle.distance(Point::new(0.0, 0.0, 0.86)) < 1e-14 && stretched.knee.abs() < 1e-7);
    for sign in [1.0, -1.0] {
        let locked = angles([0.3, sign * std::f64::consts::FRAC_PI_2, 0.2, 0.5, 0.1, -0.2]);
        let pose = leg().forward(origin, &locked).unwrap();
        let (_, found) = leg().inverse(&pose.motions, 1e-9).unwrap();
        let again = leg().forward(origin, &found).unwrap();
        assert!(again.toe.distance(pose.toe) < 1e-12);
    }
}
