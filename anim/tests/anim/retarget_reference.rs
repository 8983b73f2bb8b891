//! Retargeting without trust in the pose in which rotations are zero: recordings of one motion that
//! are written with other axes of their joints.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use ga_anim::bvh::Bvh;
use ga_anim::recording::{RecordedJoint, Recording};
use ga_anim::retarget::{FoundReference, Options, Reference, Retarget, Source, UpAxis};
use ga_anim::skeleton::Skeleton;
use ga_anim::transform::Transform;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

/// A recording of the cases, in its own unit.
fn case(path: &str) -> Option<Bvh> {
    Some(ga_anim::bvh::read(shared(&format!("cases/motion/{path}"))?).unwrap())
}

fn places(source: &dyn Source, frame: usize) -> Vec<Vector<f64>> {
    let frames = source.frames_of_joints(frame).unwrap();
    frames
        .iter()
        .map(|motor| motor.transform(Point::default()).into())
        .collect()
}

/// The places of the target's joints in a frame.
fn heads(retarget: &Retarget, target: &Skeleton, frame: usize) -> Vec<Vector<f64>> {
    let bones = retarget.pose(frame).unwrap().bones(target).unwrap();
    bones.into_iter().map(|[head, _]| head.into()).collect()
}

/// The largest difference between two recordings of all places after transfer to a skeleton.
fn difference(sources: [&dyn Source; 2], target: &Skeleton, options: &Options) -> f64 {
    let both = sources.map(|source| Retarget::new(source, target, options).unwrap());
    let mut largest: f64 = 0.0;
    for frame in 0..sources[0].frame_count() {
        let [a, b] = both.each_ref().map(|one| heads(one, target, frame));
        for (a, b) in a.into_iter().zip(b) {
            largest = largest.max(a.distance(b));
        }
    }
    largest
}

/// Two files of one motion: one stands at rest, in the other all bones lie along one axis.
#[test]
fn a_motion_is_the_same_whatever_the_axes_of_its_joints() {
    let Some((upright, along)) =
        case("rest-not-upright/upright.bvh").zip(case("rest-not-upright/along_x.bvh"))
    else {
        return;
    };
    let target = upright.skeleton().unwrap();
    let options = Options {
        target_motion: Some(&upright),
        keeps_height: true,
        ..Options::default()
    };
    let retarget = Retarget::new(&along, &target, &options).unwrap();
    assert_eq!(retarget.reference(), FoundReference::Motion);
    for frame in 0..along.frame_count() {
        let found = heads(&retarget, &target, frame);
        for (found, wanted) in found.into_iter().zip(places(&upright, frame)) {
            // The file has six digits.
            assert!(
                found.distance(wanted) < 1e-3,
                "frame {frame}: {found:?} {wanted:?}"
            );
        }
    }
}

#[test]
fn a_recording_comes_back_from_its_own_skeleton() {
    for path in [
        "rest-not-upright/upright.bvh",
        "rest-not-upright/along_x.bvh",
        "onto-itself/upright.bvh",
    ] {
        let Some(motion) = case(path) else { return };
        let target = motion.skeleton().unwrap();
        let options = Options {
            target_motion: Some(&motion),
            keeps_height: true,
            ..Options::default()
        };
        let retarget = Retarget::new(&motion, &target, &options).unwrap();
        let clip = retarget.clip(0..=motion.frame_count() - 1).unwrap();
        let recording = Recording::from_clip(&target, &clip).unwrap();
        let (again, losses) = Bvh::from_recording(&recording, 1.0, Some((&motion, 1.0)));
        assert!(losses.is_empty(), "{losses:?}");
        for frame in 0..motion.frame_count() {
            for (found, wanted) in places(&again, frame)
                .into_iter()
                .zip(places(&motion, frame))
            {
                assert!(
                    found.distance(wanted) < 1e-9,
                    "{path} {frame}: {found:?} {wanted:?}"
                );
            }
        }
    }
}

/// A person whose bones all lie along x where the rotations are zero stands upright.
#[test]
fn a_person_stands_whatever_the_pose_at_zero() {
    let Some((standing, upright)) =
        case("zero-pose/standing.bvh").zip(case("rest-not-upright/upright.bvh"))
    else {
        return;
    };
    let target = upright.skeleton().unwrap();
    let retarget = Retarget::new(&standing, &target, &Options::default()).unwrap();
    assert_eq!(retarget.reference(), FoundReference::Motion);
    for frame in 0..standing.frame_count() {
        let heads = heads(&retarget, &target, frame);
        let [hips, head] = ["Hips", "Head"].map(|name| heads[target.index(name).unwrap()]);
        let angle = (head - hips).angle(Vector::new(0.0, 1.0, 0.0)).unwrap();
        assert!(angle.to_degrees() < 0.1, "frame {frame}: {angle}");
    }
}

/// A z-up recording stands as one with y up.
#[test]
fn the_vertical_is_found_from_the_motion() {
    let Some((z_up, upright)) = case("z-up/zup.bvh").zip(case("rest-not-upright/upright.bvh"))
    else {
        return;
    };
    let target = upright.skeleton().unwrap();
    let options = Options::default();
    let retarget = Retarget::new(&z_up, &target, &options).unwrap();
    assert_eq!(retarget.found_up_axis().unwrap().axis, UpAxis::Z);
    for frame in 0..z_up.frame_count() {
        let heads = heads(&retarget, &target, frame);
        let [hips, head] = ["Hips", "Head"].map(|name| heads[target.index(name).unwrap()]);
        let angle = (head - hips).angle(Vector::new(0.0, 1.0, 0.0)).unwrap();
        assert!(angle.to_degrees() < 20.0, "frame {frame}: {angle}");
    }
}

/// A recording whose joints have other axes: every rotation and every bone is expressed in them.
fn with_axes(recording: &Recording, axes: &[Rotor<f64>]) -> Recording {
    let parents = recording.parents();
    let changed = |joint: usize, local: &Transform<f64>| {
        let above = parents[joint].map_or(Rotor::default(), |parent| axes[parent]);
        Transform::from(Motor::from(above.reverse()) * local.motor * Motor::from(axes[joint]))
    };
    let joints = recording.joints().iter().enumerate();
    let joints = joints.map(|(index, joint)| RecordedJoint {
        name: joint.name.clone(),
        parent: joint.parent,
        // At rest all joints have the axes of the model, so that bones point elsewhere.
        rest: Transform::from(Motor::from(changed(index, &joint.rest).motor.translator())),
    });
    let count = parents.len();
    let locals = recording.locals().iter().enumerate();
    let locals = locals.map(|(index, local)| changed(index % count, local));
    Recording::new(
        joints.collect(),
        recording.frame_time(),
        locals.collect(),
        Vec::new(),
    )
    .unwrap()
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(16))]
    /// A walk of a person on a character, written with random axes of all joints.
    #[test]
    fn random_axes_make_no_difference(
        angles in proptest::collection::vec(proptest::array::uniform3(-3.0..3.0f64), 64),
        other in proptest::collection::vec(proptest::array::uniform3(-3.0..3.0f64), 64),
    ) {
        let Some(upright) = case("rest-not-upright/upright.bvh") else { return Ok(()) };
        let recording = Recording::from_bvh(&upright, 0.01).unwrap();
        let [a, b] = [angles, other].map(|angles| {
            let axes = angles.into_iter().map(|v| Rotor::from_rotation_vector(v).unwrap());
            with_axes(&recording, &axes.collect::<Vec<_>>())
        });
        let target = recording.to_skeleton().unwrap();
        let found = difference([&a, &b], &target, &Options::default());
        proptest::prop_assert!(found < 1e-9, "{found}");
        // With the same pose of reference, the pose in which rotations are zero does not matter.
        let options = Options { reference: Reference::Frame(3), ..Options::default() };
        let found = difference([&a, &b], &target, &options);
        proptest::prop_assert!(found < 1e-9, "{found}");
    }
}

/// Two files of one motion, of which one stands at rest and in the other all bones lie along one
/// axis, have one mirror image.
#[test]
fn a_mirror_image_is_the_same_whatever_the_axes_of_the_joints() {
    let Some((upright, along)) =
        case("rest-not-upright/upright.bvh").zip(case("rest-not-upright/along_x.bvh"))
    else {
        return;
    };
    let x = Vector::new(1.0, 0.0, 0.0);
    let [upright, along] =
        [upright, along].map(|motion| Recording::from_bvh(&motion, 0.01).unwrap());
    let [image, other] = [&upright, &along].map(|recording| recording.mirrored(x).unwrap());
    let names = Source::names(&upright);
    for frame in 0..upright.frame_count() {
        let before = places(&upright, frame);
        let [a, b] = [&image, &other].map(|recording| places(recording, frame));
        for (joint, name) in names.iter().enumerate() {
            let counterpart = match name.strip_prefix("Left") {
                Some(rest) => format!("Right{rest}"),
                None => name.replace("Right", "Left"),
            };
            let counterpart = names
                .iter()
                .position(|other| *other == counterpart)
                .unwrap();
            let truth = before[counterpart] - x * (2.0 * before[counterpart].e1);
            assert!(a[joint].distance(truth) < 1e-12, "{name} in frame {frame}");
            // The file has six digits.
            assert!(b[joint].distance(truth) < 1e-5, "{name} in frame {frame}");
        }
    }
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(16))]
    /// With random axes of all joints, every joint is where the reflected one is.
    #[test]
    fn random_axes_have_the_same_mirror_image(
        angles in proptest::collection::vec(proptest::array::uniform3(-3.0..3.0f64), 64),
    ) {
        let Some(upright) = case("rest-not-upright/upright.bvh") else { return Ok(()) };
        let recording = Recording::from_bvh(&upright, 0.01).unwrap();
        let axes = angles.into_iter().map(|v| Rotor::from_rotation_vector(v).unwrap());
        let other = with_axes(&recording, &axes.collect::<Vec<_>>());
        let x = Vector::new(1.0, 0.0, 0.0);
        let [image, found] = [&recording, &other].map(|recording| recording.mirrored(x).unwrap());
        let back = found.mirrored(x).unwrap();
        for frame in 0..recording.frame_count() {
            let pairs = places(&image, frame).into_iter().zip(places(&found, frame));
            for (truth, found) in pairs {
                proptest::prop_assert!(found.distance(truth) < 1e-5, "{}", found.distance(truth));
            }
            let pairs = places(&other, frame).into_iter().zip(places(&back, frame));
            for (truth, found) in pairs {
                proptest::prop_assert!(found.distance(truth) < 1e-9);
            }
        }
    }
}

/// In a recording whose zero pose is no person, the End Site says where the top of the head is: a
/// head that is bent forwards by 29° is so on a body that holds it upright at rest.
#[test]
fn the_end_site_says_how_a_head_is_held() {
    let Some(path) = shared("cases/motion/rest-not-upright/along_x.bvh") else {
        return;
    };
    let Some(upright) = case("rest-not-upright/upright.bvh") else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let bent: f64 = 0.5;
    // The bones of this file lie along x at rest, and the head's z axis points forwards.
    let head = text.find("JOINT Head").unwrap();
    let (before, after) = text.split_at(head);
    let top = format!(
        "OFFSET {} 0.000000 {}",
        18.0 * bent.cos(),
        18.0 * bent.sin()
    );
    let end = after.find("End Site").unwrap();
    let after = format!(
        "{}{}",
        &after[..end],
        after[end..].replacen("OFFSET 0.000000 0.000000 0.000000", &top, 1)
    );
    let motion = ga_anim::bvh::decode(format!("{before}{after}").as_bytes()).unwrap();
    let target = upright.skeleton().unwrap();
    let retarget = Retarget::new(&motion, &target, &Options::default()).unwrap();
    assert_eq!(retarget.reference(), FoundReference::Motion);
    let head = motion.index("Head").unwrap();
    for frame in 0..motion.frame_count() {
        let pose = retarget.pose(frame).unwrap().motions(&target).unwrap();
        let ours = pose[target.index("Head").unwrap()].rotor();
        let ours: Vector<f64> = ours
            .transform(Direction::from(Vector::new(0.0, 1.0, 0.0)))
            .into();
        let there = motion.end_site_positions(frame).unwrap()[head].unwrap();
        let there =
            Vector::from(there) - Vector::from(motion.joint_positions(frame).unwrap()[head]);
        let angle = ours.angle(there).unwrap().to_degrees();
        // By the neck it would be 29°. One frame in four, in which the head looks to a side, says
        // otherwise.
        assert!(angle < 10.0, "frame {frame}: {angle}");
    }
}

/// A target that stands upright in its motion alone takes a given frame of the source: the source
/// moves as itself where that is the frame of the same pose.
#[test]
fn a_given_frame_is_the_pose_of_a_target_that_does_not_stand_at_rest() {
    let Some((upright, along)) =
        case("rest-not-upright/upright.bvh").zip(case("rest-not-upright/along_x.bvh"))
    else {
        return;
    };
    let target = along.skeleton().unwrap();
    let deviation = |reference| {
        let options = Options {
            target_motion: Some(&along),
            reference: Reference::Frame(reference),
            keeps_height: true,
            ..Options::default()
        };
        let retarget = Retarget::new(&upright, &target, &options).unwrap();
        let frames = (0..upright.frame_count()).flat_map(|frame| {
            let found = heads(&retarget, &target, frame);
            found.into_iter().zip(places(&upright, frame))
        });
        frames
            .map(|(found, wanted)| found.distance(wanted))
            .fold(0.0, f64::max)
    };
    let least = (0..upright.frame_count())
        .map(deviation)
        .fold(f64::INFINITY, f64::min);
    // The file has six digits.
    assert!(least < 1e-3, "{least}");
}
