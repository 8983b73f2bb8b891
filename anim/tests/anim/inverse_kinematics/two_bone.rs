use ga_anim::inverse_kinematics::{Reach, TwoBone, bend_limb};
use ga_anim::kinematics::KinematicsError;
use ga_anim::pose::Pose;
use ga_anim::skeleton::SkeletonError;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::{chain, points, vectors};

proptest! {
    #[test]
    fn a_limb_bends_as_the_law_of_cosines_says(
        root in points(2.0), target in points(2.0), pole in points(5.0),
        upper in 0.2..3.0_f64, lower in 0.2..3.0_f64, scale in -100..100_i32,
    ) {
        let unit = 10.0_f64.powi(scale);
        let aside = root.vector_to(pole).reject(root.vector_to(target));
        prop_assume!(aside.is_some_and(|aside| aside.length() > 1e-3));
        let aside = aside.unwrap() * unit;
        let [root, target, pole] = [root, target, pole]
            .map(|point| Point::from(point.coordinates().map(|x| x * unit)));
        let (upper, lower) = (upper * unit, lower * unit);
        let limb = TwoBone::new(upper, lower).unwrap();
        let way = root.vector_to(target);
        let distance = way.length();
        prop_assume!(distance > 1e-3 * unit);
        let bent = limb.solve(root, target, pole).unwrap();
        let along = way / distance;
        let near = |a: Point<f64>, b: Vector<f64>| Vector::from(a).distance(b) < 1e-12 * unit;
        let root_place = Vector::from(root);
        if distance > upper + lower {
            prop_assert!(near(bent.end, root_place + along * (upper + lower)));
            prop_assert!(near(bent.middle, root_place + along * upper));
            let Reach::TooFar { by } = bent.reach else { panic!("{bent:?}") };
            prop_assert!((by - (distance - upper - lower)).abs() < 1e-12 * unit);
        } else if distance < (upper - lower).abs() {
            prop_assert!(near(bent.end, root_place + along * (upper - lower).abs()));
            let middle = if upper > lower { upper } else { -upper };
            prop_assert!(near(bent.middle, root_place + along * middle));
            let Reach::TooClose { by } = bent.reach else { panic!("{bent:?}") };
            prop_assert!((by - ((upper - lower).abs() - distance)).abs() < 1e-12 * unit);
        } else {
            prop_assert_eq!((bent.reach, bent.end), (Reach::Exact, target));
            let foot = (distance * distance + upper * upper - lower * lower) / (2.0 * distance);
            let height = (upper * upper - foot * foot).max(0.0).sqrt();
            let expected = root_place + along * foot + aside.normalized().unwrap() * height;
            // Near the straight limb the height is a root of a difference.
            let within = 1e-14 * unit * unit / height.max(1e-8 * unit) + 1e-13 * unit;
            let error = Vector::from(bent.middle).distance(expected);
            prop_assert!(error < within * 10.0, "{error} at height {height}");
        }
        // The bones keep their lengths however they lie.
        prop_assert!((root.distance(bent.middle) - upper).abs() < 1e-13 * unit);
        prop_assert!((bent.middle.distance(bent.end) - lower).abs() < 1e-13 * unit);
    }

    #[test]
    fn rotors_take_the_bones_and_their_plane_along(
        from in [points(2.0), points(2.0), points(2.0)], target in points(2.0), pole in points(5.0),
    ) {
        let bones = [from[0].vector_to(from[1]), from[1].vector_to(from[2])];
        prop_assume!(bones[0].cross(bones[1]).length() > 1e-2);
        let limb = TwoBone::new(bones[0].length(), bones[1].length()).unwrap();
        prop_assume!(from[0].vector_to(target).cross(from[0].vector_to(pole)).length() > 1e-2);
        let bent = limb.solve(from[0], target, pole).unwrap();
        let rotors = bent.rotors_from(from).unwrap();
        let after = [bent.root.vector_to(bent.middle), bent.middle.vector_to(bent.end)];
        let rotated = |rotor: Rotor<f64>, v: Vector<f64>| Vector::from(rotor.transform(Point::from(v)));
        let normal = bones[0].cross(bones[1]).normalized().unwrap();
        let hinges = rotors.map(|rotor| rotated(rotor, normal));
        for k in 0..2 {
            prop_assert!(rotated(rotors[k], bones[k]).distance(after[k]) < 1e-12);
            prop_assert!(hinges[k].distance(hinges[0]) < 1e-10);
            prop_assert!(hinges[k].dot(after[k]).abs() < 1e-10);
        }
        // The joint bends to the same side about the hinge as before.
        prop_assert!(after[0].cross(after[1]).dot(hinges[0]) > -1e-10);
    }

    #[test]
    fn a_limb_of_a_skeleton_reaches_and_its_end_keeps_its_rotation(
        angles in prop::collection::vec(vectors(), 6), target in points(1.5), pole in points(5.0),
    ) {
        // A joint in between, and one beside.
        let skeleton = chain(&[
            [0.0, 2.0, 0.0], [0.1, 1.8, 0.1], [0.1, 1.5, 0.1], [0.2, 1.1, 0.2], [0.2, 0.3, 0.1], [0.2, 0.1, 0.4],
        ]);
        let rotors: Vec<_> = angles.iter().map(|v| Rotor::from_rotation_vector((*v).into()).unwrap()).collect();
        let before = Pose::from_rotors(&skeleton, Motor::default(), &rotors).unwrap();
        let mut pose = before.clone();
        let root = Point::from(before.bones(&skeleton).unwrap()[1][0]);
        prop_assume!(root.vector_to(target).cross(root.vector_to(pole)).length() > 1e-3);
        let reach = bend_limb(&skeleton, &mut pose, [1, 3, 4], target, Some(pole)).unwrap();
        let (old, new) = (before.motions(&skeleton).unwrap(), pose.motions(&skeleton).unwrap());
        let head = |motions: &[Motor<f64>], joint: usize| {
            motions[joint].transform(Point::from(skeleton.joints()[joint].head))
        };
        let missed = match reach {
            Reach::Exact => 0.0,
            Reach::TooFar { by } | Reach::TooClose { by } => by,
        };
        prop_assert!((head(&new, 4).distance(target) - missed).abs() < 1e-12);
        prop_assert!(head(&new, 1).distance(head(&old, 1)) < 1e-13);
        for joint in [0, 2, 5] {
            prop_assert_eq!(pose.joints[joint], before.joints[joint]);
        }
        for (a, b) in [(1, 3), (3, 4)] {
            let length = |motions: &[Motor<f64>]| head(motions, a).distance(head(motions, b));
            prop_assert!((length(&new) - length(&old)).abs() < 1e-13);
        }
        for (row, other) in new[4].rotor().to_matrix().iter().zip(old[4].rotor().to_matrix()) {
            prop_assert!(row.iter().zip(other).all(|(a, b): (&f64, f64)| (a - b).abs() < 1e-13));
        }
    }
}

#[test]
fn what_is_not_determined_is_an_error() {
    let limb = TwoBone::new(1.0, 1.0).unwrap();
    let (root, target) = (Point::default(), Point::new(0.0, 1.0, 0.0));
    let at = |y: f64| Point::new(0.0, y, 0.0);
    for pole in [at(3.0), at(-2.0), at(0.0)] {
        assert_eq!(limb.solve(root, target, pole), Err(KinematicsError::Pole));
    }
    assert_eq!(
        limb.solve(root, root, at(1.0)),
        Err(KinematicsError::Folded)
    );
    // A straight limb needs no pole.
    for target in [at(2.0), at(2.5)] {
        let straight = limb.solve(root, target, at(1.0)).unwrap();
        assert_eq!(straight.middle, at(1.0));
        assert_eq!(straight.normal, Vector::default());
    }
    assert_eq!(
        TwoBone::new(1.0, 0.0),
        Err(KinematicsError::Length {
            bone: 1,
            length: 0.0
        })
    );
    assert!(TwoBone::new(f64::NAN, 1.0).is_err());
    let nowhere = Point::new(0.0, f64::NAN, 0.0);
    let message = |root, target, pole| limb.solve(root, target, pole).unwrap_err().to_string();
    assert!(message(nowhere, target, at(1.0)).starts_with("the root is not finite"));
    assert!(message(root, nowhere, at(1.0)).starts_with("the target is not finite"));
    assert!(message(root, target, nowhere).starts_with("the pole"));
}

#[test]
fn faults_of_a_limb_name_its_joints() {
    let skeleton = chain(&[[0.0; 3], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0]]);
    let target = Point::new(0.5, 1.0, 0.0);
    let bend =
        |limb, target| bend_limb(&skeleton, &mut Pose::rest(4), limb, target, None).unwrap_err();
    assert_eq!(
        bend([0, 1, 2], target),
        KinematicsError::ZeroLengthBone { joint: "b".into() }
    );
    assert_eq!(
        bend([0, 3, 2], target),
        KinematicsError::NotBelow {
            below: "c".into(),
            above: "d".into()
        }
    );
    assert_eq!(
        bend([0, 1, 4], target),
        KinematicsError::NoJoint {
            index: 4,
            joints: 4
        }
    );
    let on_line = Point::new(0.0, 1.5, 0.0);
    assert_eq!(bend([0, 2, 3], on_line), KinematicsError::Pole);
    let nowhere = Point::new(f64::INFINITY, 0.0, 0.0);
    assert!(matches!(
        bend([0, 2, 3], nowhere),
        KinematicsError::NotFinite { .. }
    ));
    let wrong = bend_limb(&skeleton, &mut Pose::rest(3), [0, 2, 3], target, None);
    assert_eq!(
        wrong,
        Err(KinematicsError::Skeleton(SkeletonError::PoseLength {
            expected: 4,
            found: 3
        }))
    );
}
