//! Files of cameras and rigs: OpenCV's own, round trips, and what is wrong with others.

use std::path::Path;

use ga_camera::format::storage::Storage;
use ga_camera::format::{self, CameraFile, CameraFileError, NamedCamera, Rectified};
use ga_camera::rig::{RectifiedRig, StereoRig};
use ga_camera::{Camera, CameraError, Fisheye, Intrinsics, Lens, RadialTangential};
use nullcone_shared_data::shared;
use proptest::prelude::*;

use super::{motor, vector};

fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    format::decode(text.as_bytes(), Path::new("folder"))
}

fn rig(text: &str) -> StereoRig {
    decode(text).unwrap().rig(&[]).unwrap()
}

fn lens() -> impl Strategy<Value = Lens> {
    let coefficients = || prop::collection::vec(-0.3..0.3, 14);
    prop_oneof![
        Just(Lens::Pinhole),
        (coefficients(), prop::sample::select(vec![4, 5, 8, 12, 14]))
            .prop_map(|(all, count)| { RadialTangential::new(&all[..count]).unwrap().into() }),
    ]
}

fn fisheye() -> impl Strategy<Value = Lens> {
    prop::array::uniform4(-0.1..0.1).prop_map(|k| Fisheye::new(&k).unwrap().into())
}

fn intrinsics(lens: impl Strategy<Value = Lens>) -> impl Strategy<Value = Intrinsics> {
    (100.0..2000.0, 100.0..2000.0, vector(700.0), lens).prop_map(|(fx, fy, c, lens)| {
        Intrinsics::new([fx, fy], [c[0], c[1]])
            .unwrap()
            .with_lens(lens)
    })
}

fn size() -> impl Strategy<Value = Option<[usize; 2]>> {
    prop::option::of([1usize..9000, 1usize..9000])
}

proptest! {
    #[test]
    fn cameras_come_back_exactly(
        intrinsics in prop_oneof![intrinsics(lens()), intrinsics(fisheye())],
        size in size(),
    ) {
        let text = format::camera::storage(&intrinsics, size).encode();
        let again = decode(&text).unwrap();
        let expected = NamedCamera::new("camera", intrinsics).with_size(size);
        prop_assert_eq!(again.cameras, [expected], "{}", text);
    }

    #[test]
    fn cameras_and_views_come_back_from_json(
        intrinsics in prop_oneof![intrinsics(lens()), intrinsics(fisheye())],
        (size, skew) in ([1usize..9000, 1usize..9000], prop_oneof![Just(0.0), -3.0..3.0]),
        pose in prop::option::of((vector(1.0), -3.0..3.0, vector(2.0))),
        depths in [prop::option::of(0.1..1.0), prop::option::of(5.0..9.0)],
    ) {
        let mut camera = NamedCamera::new("camera", intrinsics).with_skew(skew);
        camera.size = Some(size);
        camera.pose = pose.map(|(axis, angle, along)| motor(axis, angle, along));
        [camera.near, camera.far] = depths;
        let again = decode(&format::json::encode(&camera).unwrap()).unwrap();
        prop_assert!(is_same(&again.cameras[0], &camera), "{again:?}");

        camera.picture = Some("folder/a.png".into());
        let text = format::json::encode_views(&[camera.clone()], Path::new("folder"));
        match text {
            Ok(text) => {
                camera.name = "a.png".to_owned();
                prop_assert!(is_same(&decode(&text).unwrap().cameras[0], &camera));
            }
            Err(error) => {
                prop_assert!(camera.pose.is_none());
                let is_pose = matches!(error, CameraFileError::NoPose { .. });
                prop_assert!(is_pose, "{error}");
            }
        }
    }

    #[test]
    fn rectified_rigs_come_back(
        (f, c) in ([100.0..2000.0, 100.0..2000.0], [0.0..900.0, 0.0..900.0, 0.0..900.0]),
        baseline in 0.01..2.0,
        (size, disparities) in (size(), prop::option::of(1usize..500)),
    ) {
        let camera = |column| Intrinsics::new(f, [column, c[2]]).unwrap();
        let rig = RectifiedRig::new(camera(c[0]), camera(c[1]), baseline).unwrap();
        let rectified = Rectified { rig, disparities };
        let again = decode(&format::middlebury::encode(&rectified, size)).unwrap();
        let found = again.rectified.unwrap();
        prop_assert_eq!(found.rig.left(), rig.left());
        prop_assert_eq!(found.rig.right(), rig.right());
        prop_assert!((found.rig.baseline() / baseline - 1.0).abs() < 1e-15);
        prop_assert_eq!(found.disparities, disparities);
        for camera in &again.cameras {
            prop_assert_eq!(camera.size, size);
        }
        // The cameras of the list are the two of the rectified rig.
        let listed = again.rig(&[]).unwrap();
        prop_assert_eq!(listed.right.intrinsics, rig.right());
        prop_assert!((listed.baseline() / baseline - 1.0).abs() < 1e-14);
    }

    #[test]
    fn rigs_come_back(
        cameras in prop_oneof![
            (intrinsics(lens()), intrinsics(lens())),
            (intrinsics(fisheye()), intrinsics(fisheye())),
        ],
        pose in (vector(1.0), -3.0..3.0, vector(2.0)),
        size in size(),
    ) {
        let camera = |intrinsics, world_to_camera| Camera { intrinsics, world_to_camera };
        let identity = motor([1.0, 0.0, 0.0], 0.0, [0.0; 3]);
        let rig = StereoRig {
            left: camera(cameras.0, identity),
            right: camera(cameras.1, motor(pose.0, pose.1, pose.2)),
        };
        let file = decode(&format::rig::encode(&rig, size).unwrap()).unwrap();
        prop_assert!(file.cameras.iter().all(|camera| camera.size == size));
        let again = file.rig(&[]).unwrap();
        prop_assert_eq!(again.left, rig.left);
        prop_assert_eq!(again.right.intrinsics, rig.right.intrinsics);
        let (a, b) = (again.left_to_right().motor.to_matrix(), rig.left_to_right().motor.to_matrix());
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            prop_assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in "[-%:\\[\\]{}#&*!|>'\"0-9a-eM \n.,]{0,60}") {
        _ = Storage::decode(text.as_bytes());
        _ = decode(&text);
        _ = decode(&format!("%YAML:1.0\nM1: {text}"));
        _ = decode(&format!("cam0=[{text}"));
        _ = decode(&format!("{{\"views\": [{text}"));
    }
}

/// Whether cameras are equal but for rounding in their poses.
fn is_same(a: &NamedCamera, b: &NamedCamera) -> bool {
    let poses = match (a.pose, b.pose) {
        (None, None) => true,
        (Some(p), Some(q)) => {
            let (p, q) = (p.to_matrix(), q.to_matrix());
            let mut pairs = p.iter().flatten().zip(q.iter().flatten());
            pairs.all(|(p, q)| (p - q).abs() < 1e-14)
        }
        _ => false,
    };
    poses && a.clone().with_pose(None) == b.clone().with_pose(None)
}

#[test]
fn cameras_of_opencv_are_read() {
    let Some(path) = shared("data/vision/opencv/left_intrinsics.yml") else {
        return;
    };
    let file = format::read(path).unwrap();
    let camera = file.one(None).unwrap();
    let intrinsics = camera.intrinsics().unwrap();
    assert_eq!(camera.size, Some([640, 480]));
    assert_eq!(intrinsics.focal(), [535.915_733_961_632; 2]);
    assert_eq!(
        intrinsics.principal(),
        [342.283_154_733_083_73, 235.570_829_097_881_73]
    );
    let found = intrinsics.lens().coefficients();
    assert_eq!(found[0], -0.266_372_609_096_606_8);
    assert_eq!(found[4], 0.238_391_530_808_784_86);
    assert!(found[5..].iter().all(|x| *x == 0.0));
}

#[test]
fn the_intrinsics_of_opencvs_rig_are_read() {
    let Some(path) = shared("data/vision/opencv/intrinsics.yml") else {
        return;
    };
    // It has no R and T, which OpenCV writes to a file of their own: two cameras without poses.
    let text = std::fs::read_to_string(&path).unwrap();
    let file = format::read(&path).unwrap();
    assert_eq!(
        file.side(0).unwrap().intrinsics().unwrap().focal()[0],
        534.803_268_450_513_1
    );
    assert!(matches!(
        file.rig(&[]),
        Err(CameraFileError::NoPose { name }) if name == "left"
    ));
    assert!(matches!(
        decode(&format!("{text}R: [ 0.01, -0.02, 0.03 ]\n")),
        Err(CameraFileError::Missing { place, .. }) if place.key == "T"
    ));
    let more = format!("{text}R: [ 0.01, -0.02, 0.03 ]\nT: [ -3.3, 0.04, 0.05 ]\n");
    let rig = rig(&more);
    assert_eq!(rig.left.intrinsics.focal()[0], 534.803_268_450_513_1);
    assert_eq!(rig.right.intrinsics.principal()[1], 242.053_245_733_766);
    let rotation = rig.left_to_right().motor.rotor().to_rotation_vector();
    assert!((rotation[2] - 0.03).abs() < 1e-15);
    let translation = rig.left_to_right().motor.translator().displacement();
    for (found, expected) in translation.into_iter().zip([-3.3, 0.04, 0.05]) {
        assert!((found - expected).abs() < 1e-15);
    }
}

const RIG: &str = "%YAML:1.0
---
M1: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]
M2: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ -0.1, 0., 0. ]
";

fn refused(text: &str, from: &str, to: &str) -> CameraFileError {
    assert!(text.contains(from), "{from}");
    decode(&text.replacen(from, to, 1)).unwrap_err()
}

#[test]
fn what_is_wrong_with_a_rig_is_named_with_its_line() {
    assert_eq!(rig(RIG).baseline(), 0.1);
    assert_eq!(decode(RIG).unwrap().cameras[0].size, None);
    let error = |from, to| refused(RIG, from, to).to_string();
    assert_eq!(
        error("-0.1, 0., 0.", "0., 0., 0."),
        "line 18: `T` is zero, so the cameras are at the same place"
    );
    assert_eq!(
        error("-0.1, 0.", "-0.1, .Nan"),
        "line 22: `T` has the value NaN, which is not finite"
    );
    assert_eq!(
        error("-0.1, 0.,", "-0.1,"),
        "line 18: `T` has 2 values, not 3 × 1"
    );
    assert_eq!(
        error("rows: 3", "rows: 2"),
        "line 3: `M1` has 9 values, not 2 × 3"
    );
    assert_eq!(
        error("rows: 3", "rows: 2.5"),
        "line 4: `M1` is not a matrix with whole rows and cols"
    );
    assert_eq!(
        error("0., 0., 1. ]\nM2", "0., 1. ]\nM2"),
        "line 3: `M1` has 8 values, not 3 × 3"
    );
    assert_eq!(
        error("500., 0.", "five, 0."),
        "line 7: `M1` is not a number"
    );
    assert_eq!(error("M2:", "M1:"), "line 8: `M1` is given a second time");
    assert_eq!(
        error("M2:", "N2:"),
        "there is no `M2`, and none of `K2`, `cameraMatrix2`, `camera_matrix2`, `mtx2`, \
         `intrinsic_matrix2`"
    );
}

#[test]
fn what_is_no_camera_of_a_rig_is_refused() {
    let negative = refused(RIG, "[ 500.", "[ -500.");
    assert!(
        matches!(
            &negative,
            CameraFileError::Camera { place, error }
                if place.line == Some(3) && matches!(**error, CameraError::Intrinsics { .. })
        ),
        "{negative}"
    );
    let skewed = refused(RIG, "500., 0., 320.", "500., 0.5, 320.");
    assert!(matches!(
        skewed,
        CameraFileError::Camera { error, .. }
            if matches!(*error, CameraError::Matrix { row: 0, column: 1, .. })
    ));
    let distorted = refused(RIG, "M2:", "D1: [ 0.1, 0.2, 0.3 ]\nM2:");
    assert!(matches!(
        distorted,
        CameraFileError::Camera { error, .. }
            if matches!(*error, CameraError::CoefficientCount { found: 3, .. })
    ));
    let size = refused(RIG, "M1:", "image_width: 640.5\nimage_height: 480\nM1:");
    assert!(matches!(
        size,
        CameraFileError::Size { place, value: 640.5 } if place.line == Some(3)
    ));
    let half = refused(RIG, "M1:", "image_width: 640\nM1:");
    assert!(matches!(
        half,
        CameraFileError::Missing { place, .. } if place.key == "image_height"
    ));
}

#[test]
fn what_is_no_rotation_of_a_rig_is_refused() {
    let scaled = refused(
        RIG,
        "1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT",
        "1., 0., 0., 0., 1.1, 0., 0., 0., 1. ]\nT",
    );
    let CameraFileError::Rotation { place, deviation } = scaled else {
        panic!("{scaled}");
    };
    assert_eq!(place.line, Some(13));
    assert!((deviation - 0.1).abs() < 1e-12);
    let mirrored = refused(
        RIG,
        "1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT",
        "-1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT",
    );
    assert!(matches!(mirrored, CameraFileError::Rotation { .. }));
}

#[test]
fn a_rotation_of_few_digits_is_replaced_by_the_nearest() {
    let (sine, cosine) = 0.3_f64.sin_cos();
    let rotation = format!(
        "{cosine:.5}, 0., {sine:.5}, 0., 1., 0., {:.5}, 0., {cosine:.5} ]\nT",
        -sine
    );
    let text = RIG.replacen("1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT", &rotation, 1);
    let [x, y, z] = rig(&text)
        .left_to_right()
        .motor
        .rotor()
        .to_rotation_vector();
    assert!(
        x.abs() < 1e-15 && z.abs() < 1e-15 && (y - 0.3).abs() < 1e-5,
        "{y}"
    );
}

#[test]
fn a_rig_of_two_kinds_of_lenses_is_not_written() {
    let mixed = StereoRig {
        left: Camera {
            intrinsics: Intrinsics::new([1.0, 1.0], [0.0, 0.0]).unwrap(),
            world_to_camera: motor([1.0, 0.0, 0.0], 0.0, [0.0; 3]),
        },
        right: Camera {
            intrinsics: Intrinsics::new([1.0, 1.0], [0.0, 0.0])
                .unwrap()
                .with_lens(Fisheye::new(&[0.0; 4]).unwrap()),
            world_to_camera: motor([1.0, 0.0, 0.0], 0.0, [-1.0, 0.0, 0.0]),
        },
    };
    assert!(matches!(
        format::rig::encode(&mixed, None),
        Err(CameraFileError::MixedLenses)
    ));
}

#[test]
fn the_calibration_of_eth3d_is_read() {
    let Some(path) = shared("data/vision/stereo/eth3d_terrace/calib.txt") else {
        return;
    };
    let file = format::read(path).unwrap();
    let calib = file.rectified.unwrap();
    assert_eq!(file.cameras[0].size, Some([713, 434]));
    assert_eq!(calib.disparities, Some(713));
    assert_eq!(calib.rig.left().focal(), [711.499; 2]);
    assert_eq!(calib.rig.baseline(), 0.059_943_2);
    assert_eq!(calib.rig.disparity_offset(), 0.0);
}

#[test]
fn calibrations_of_middlebury() {
    // Motorcycle in full size.
    let text = "cam0=[3979.911 0 1244.772; 0 3979.911 1019.507; 0 0 1]\n\
                cam1=[3979.911 0 1369.115; 0 3979.911 1019.507; 0 0 1]\n\
                doffs=124.343\nbaseline=193.001\nwidth=2964\nheight=2000\nndisp=280\nisint=0\n\
                vmin=31\nvmax=257\ndyavg=0.918\ndymax=1.516\n";
    let calib = decode(text).unwrap().rectified.unwrap();
    assert!((calib.rig.disparity_offset() - 124.343).abs() < 1e-9);
    let depth = calib.rig.depth(202.0).unwrap();
    assert!((depth - 3979.911 * 0.193001 / (202.0 + 124.343)).abs() < 1e-12);
    let error = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        decode(&text.replacen(from, to, 1)).unwrap_err().to_string()
    };
    assert_eq!(error("baseline=193.001\n", ""), "there is no `baseline`");
    assert_eq!(
        error("baseline=193.001", "baseline=0"),
        "line 4: the baseline is 0 m, which is not positive and finite"
    );
    assert_eq!(
        error("baseline=193.001", "baseline=far"),
        "line 4: `baseline` is not a number"
    );
    assert_eq!(
        error("doffs=124.343", "doffs"),
        "line 3: not of the form key=value"
    );
    assert_eq!(
        error("height=", "width="),
        "line 6: `width` is given a second time"
    );
    assert!(error("doffs=124.343", "doffs=12").starts_with("line 3: `doffs` is 12, and"));
    assert!(error("0 0 1]", "0 0 1 0]").starts_with("line 1: `cam0` is not a matrix"));
    assert!(error("cam0=[3979.911", "cam0=[-3979.911").starts_with("line 1: `cam0`: focal"));
    assert!(error("cam0=[3979.911", "cam0=[nan").starts_with("line 1: `cam0`: focal"));
    assert!(error("cam1=[3979.911", "cam1=[3979").starts_with("line 2: the focal lengths"));
    let not_text = format::decode(b"\xff", Path::new("")).unwrap_err();
    assert!(matches!(not_text, CameraFileError::NotText { line: 1 }));
}

/// The time for many names grows with their number, not with its square.
#[test]
fn a_name_given_twice_is_found_among_many() {
    const COUNT: usize = 200_000;
    let names = |separator: &str| -> String {
        let names = (0..COUNT).map(|k| format!("n{k}{separator}1\n"));
        names.collect()
    };
    let yaml = format!("{}n7: 2\n", names(": "));
    let is_seventh = |error: &CameraFileError| {
        let place = match error {
            CameraFileError::Duplicate(place) => place,
            _ => panic!("{error}"),
        };
        (place.line, place.key.as_str()) == (Some(COUNT + 1), "n7")
    };
    assert!(is_seventh(&decode(&yaml).unwrap_err()));
    let calib = format!("{}n7=2\n", names("="));
    assert!(is_seventh(&decode(&calib).unwrap_err()));
}

#[test]
fn the_cameras_of_views_are_chosen_by_their_number_and_names() {
    let intrinsics = Intrinsics::new([500.0; 2], [320.0, 240.0]).unwrap();
    let camera = |name: &str| NamedCamera::new(name, intrinsics).with_size(Some([640, 480]));
    let file = |names: &[&str]| CameraFile {
        cameras: names.iter().map(|name| camera(name)).collect(),
        rectified: None,
    };
    let [one, two, three] = [&["a"][..], &["a", "b"], &["a", "b", "c"]].map(file);
    let chosen = |file: &CameraFile, names| {
        let found = file.of_two_views(names).ok()?;
        Some(found.map(|camera| camera.name.clone()).join(" "))
    };
    for (file, names, expected) in [
        (&one, [None, None], Some("a a")),
        (&two, [None, None], Some("a b")),
        (&two, [Some("b"), None], Some("b b")),
        (&two, [None, Some("a")], Some("a a")),
        (&two, [Some("b"), Some("a")], Some("b a")),
        (&three, [None, None], None),
        (&three, [None, Some("b")], None),
        (&three, [Some("c"), None], Some("c c")),
    ] {
        assert_eq!(chosen(file, names).as_deref(), expected, "{names:?}");
    }
    let side = |file: &CameraFile| file.side(1).map(|camera| camera.name.clone()).ok();
    assert_eq!(side(&one).as_deref(), Some("a"));
    assert_eq!(side(&two).as_deref(), Some("b"));
    assert_eq!(side(&three), None);

    let check = |size| camera("a").check_size(size, Path::new("p.png"), Path::new("c.json"));
    assert_eq!(check([640, 480]), Ok(()));
    assert_eq!(
        check([640, 481]).unwrap_err().to_string(),
        "p.png has 640 × 481 pixels, and c.json is for 640 × 480"
    );
}
