//! Recordings as files of every format, read again.

use ga_anim::bvh;
use ga_anim::clip::compressed;
use ga_anim::motion_file::{Contents, Format, Loss, MotionFile, Options, WriteOptions, Written};
use ga_anim::recording::{RecordedJoint, Recording, ScalarTrack};
use ga_anim::retarget::Source;
use ga_anim::transform::Transform;
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

/// What a recording becomes in a file and is when it is read again.
fn again(recording: &Recording, format: Format, like: Option<&MotionFile>) -> (Recording, Written) {
    let options = WriteOptions {
        name: "motion",
        like,
        ..WriteOptions::default()
    };
    let written = Written::new(recording, format, &options, |_, _| ()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let ending = match format {
        Format::Bvh => "bvh",
        Format::Gltf => "glb",
        Format::Clip => "clip",
    };
    let path = folder.path().join(format!("motion.{ending}"));
    std::fs::write(&path, written.encode().unwrap()).unwrap();
    let unit = (format != Format::Clip).then_some(written.metres_per_unit);
    let options = Options {
        metres_per_unit: unit,
        ..Options::default()
    };
    let read = MotionFile::read(&path, options).unwrap();
    (read.recording().unwrap(), written)
}

/// The greatest distance between joints of the same name in model space, and the greatest angle
/// between their rotations since rest.
fn apart(a: &Recording, b: &Recording) -> [f64; 2] {
    assert_eq!(a.frame_count(), b.frame_count());
    let place = |name: &str| b.joints().iter().position(|joint| joint.name == name);
    let places: Vec<usize> = a.joints().iter().map(|j| place(&j.name).unwrap()).collect();
    let mut greatest = [0.0_f64; 2];
    for frame in 0..a.frame_count() {
        let [of_a, of_b] = [a, b].map(|motion| motion.frames_of_joints(frame).unwrap());
        for (joint, &other) in places.iter().enumerate() {
            let (one, two) = (of_a[joint], of_b[other]);
            let way = |motor: Motor<f64>| Vector::from(motor.translator().displacement());
            let rotor = one.rotor().reverse() * two.rotor();
            let plane = Vector::new(rotor.e12(), rotor.e13(), rotor.e23()).length();
            let angle = 2.0 * plane.atan2(rotor.scalar().abs());
            greatest[0] = greatest[0].max(way(one).distance(way(two)));
            greatest[1] = greatest[1].max(angle);
        }
    }
    greatest
}

/// A recording of four joints, of which the last moves relative to its parent.
fn recording(rest: &[[f64; 3]], frames: &[(Vec<[f64; 3]>, [f64; 3])]) -> Recording {
    let parents = [None, Some(0), Some(0), Some(1)];
    let at = |place: [f64; 3], rotor| {
        Transform::from(Motor::from(Translator::from_displacement(place)) * rotor)
    };
    let joints = parents.iter().zip(rest).enumerate();
    let joints = joints.map(|(index, (&parent, &place))| RecordedJoint {
        name: format!("joint {index}"),
        parent,
        rest: at(place, Rotor::default()),
    });
    let mut locals = Vec::new();
    for (rotations, way) in frames {
        for (joint, &rotation) in rotations.iter().enumerate() {
            let rotor = Rotor::from_rotation_vector(rotation).unwrap();
            let place = match joint {
                0 => *way,
                3 => [0, 1, 2].map(|k| rest[3][k] + 0.1 * way[k]),
                _ => rest[joint],
            };
            locals.push(at(place, rotor));
        }
    }
    Recording::new(joints.collect(), 0.025, locals, vec![]).unwrap()
}

proptest! {
    #[test]
    fn a_recording_comes_back_from_every_format(
        rest in vec(uniform3(-1.0..1.0f64), 4),
        frames in vec((vec(uniform3(-3.0..3.0f64), 4), uniform3(-2.0..2.0f64)), 1..6),
    ) {
        let recording = recording(&rest, &frames);
        let (in_bvh, written) = again(&recording, Format::Bvh, None);
        prop_assert!(written.losses.is_empty(), "{:?}", written.losses);
        let [places, angles] = apart(&recording, &in_bvh);
        prop_assert!(places < 1e-12 && angles < 1e-12, "{places} {angles}");
        let (in_gltf, written) = again(&recording, Format::Gltf, None);
        prop_assert!(written.losses.is_empty(), "{:?}", written.losses);
        let [places, angles] = apart(&recording, &in_gltf);
        prop_assert!(places < 1e-6 && angles < 1e-6, "{places} {angles}");
        let (back, _) = again(&in_gltf, Format::Bvh, None);
        let [places, angles] = apart(&recording, &back);
        prop_assert!(places < 1e-6 && angles < 1e-6, "{places} {angles}");
        let (in_clip, _) = again(&recording, Format::Clip, None);
        let options = compressed::Options::default();
        let [places, angles] = apart(&recording, &in_clip);
        prop_assert!(places <= options.tolerance && angles <= options.tolerance / options.shell);
    }
}

#[test]
fn real_motion_capture_comes_back_and_keeps_its_form() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let file = MotionFile::read(&path, Options::default()).unwrap();
    assert_eq!(file.metres_per_unit(), 0.0254 / 0.45);
    let recording = file.recording().unwrap();
    let (same, written) = again(&recording, Format::Bvh, Some(&file));
    assert!(written.losses.is_empty());
    let [places, angles] = apart(&recording, &same);
    assert!(places < 1e-12 && angles < 1e-9, "{places} {angles}");
    let (Contents::Bvh(before), Contents::Bvh(after)) = (file.contents(), &written.contents) else {
        panic!("both are BVH");
    };
    for (before, after) in before.joints().iter().zip(after.joints()) {
        assert_eq!(before, after);
    }
    let (in_gltf, written) = again(&recording, Format::Gltf, Some(&file));
    assert!(
        matches!(written.losses[..], [Loss::EndSites { joints: 7 }]),
        "{:?}",
        written.losses
    );
    assert_eq!(in_gltf.frame_count(), recording.frame_count());
    let (back, _) = again(&in_gltf, Format::Bvh, None);
    let [places, angles] = apart(&recording, &back);
    assert!(places < 1e-6 && angles < 1e-6, "{places} {angles}");
}

#[test]
fn a_document_keeps_everything_but_the_motion() {
    let Some(path) = shared("data/anim/gltf/cesium_man.gltf") else {
        return;
    };
    let file = MotionFile::read(&path, Options::default()).unwrap();
    let recording = file.recording().unwrap();
    let (same, written) = again(&recording, Format::Gltf, Some(&file));
    assert!(written.losses.is_empty(), "{:?}", written.losses);
    let [places, angles] = apart(&recording, &same);
    assert!(places < 1e-6 && angles < 1e-6, "{places} {angles}");
    let (Contents::Gltf(before), Contents::Gltf(after)) = (file.contents(), &written.contents)
    else {
        panic!("both are glTF");
    };
    assert_eq!(before.meshes, after.meshes);
    assert_eq!(before.skins, after.skins);
    assert_eq!(before.materials, after.materials);
    let (in_bvh, written) = again(&recording, Format::Bvh, Some(&file));
    let [places, _] = apart(&recording, &in_bvh);
    assert!(places < 1e-6, "{places}");
    let kinds: Vec<&str> = written.losses.iter().map(Loss::kind).collect();
    assert!(kinds.contains(&"meshes_left_out"), "{kinds:?}");
}

#[test]
fn what_a_format_does_not_hold_is_listed() {
    let rest = Transform::from_parts(
        Vector::new(0.0, 1.0, 0.0),
        Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.5).unwrap(),
        Vector::new(1.0, 1.0, 1.0),
    );
    let scaled = Transform {
        scale: Vector::new(2.0, 2.0, 2.0),
        ..rest
    };
    let joint = |name: &str, parent| RecordedJoint {
        name: name.into(),
        parent,
        rest,
    };
    let joints = vec![joint("a", None), joint("b\n", Some(0)), joint("b", Some(1))];
    let track = ScalarTrack {
        name: "smile".into(),
        values: vec![0.0, 1.0],
    };
    let locals = vec![rest, rest, rest, rest, scaled, rest];
    let recording = Recording::new(joints, 0.1, locals, vec![track]).unwrap();
    let options = WriteOptions::default();
    let written = Written::new(&recording, Format::Bvh, &options, |_, _| ()).unwrap();
    let kinds: Vec<&str> = written.losses.iter().map(Loss::kind).collect();
    let scale = written
        .losses
        .iter()
        .find(|loss| loss.kind() == "scale_left_out")
        .unwrap();
    assert_eq!((scale.joint(), scale.frame()), (Some("b\n"), Some(1)));
    for kind in [
        "scale_left_out",
        "joint_axes_left_out",
        "tracks_left_out",
        "joint_renamed",
    ] {
        assert!(kinds.contains(&kind), "{kind} is not in {kinds:?}");
    }
    // The scaled joint moves the one below it.
    let (read, _) = {
        let text = written.encode().unwrap();
        let motion = bvh::decode(&text).unwrap();
        (Recording::from_bvh(&motion, 1.0).unwrap(), ())
    };
    let place = |recording: &Recording, joint: usize| {
        let frames = recording.frames_of_joints(1).unwrap();
        Vector::from(frames[joint].translator().displacement())
    };
    for joint in 0..3 {
        assert!(place(&read, joint).distance(place(&recording, joint)) < 1e-12);
    }
    let far = {
        let mut locals = recording.locals().to_vec();
        locals[0] = Transform::from(Motor::from(Translator::from_displacement([
            900.3, 0.0, 0.0,
        ])));
        Recording::new(recording.joints().to_vec(), 0.1, locals, vec![]).unwrap()
    };
    let written = Written::new(&far, Format::Gltf, &options, |_, _| ()).unwrap();
    assert!(
        matches!(written.losses[..], [Loss::Precision { .. }]),
        "{:?}",
        written.losses
    );
}
