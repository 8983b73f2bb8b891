//! Files of cameras and rigs: OpenCV's own, round trips, and what is wrong with others.

use ga_camera::format::calib::{Calib, CalibError};
use ga_camera::format::camera::CameraFile;
use ga_camera::format::rig::RigFile;
use ga_camera::format::yaml::{Matrix, Storage, YamlError};
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, CameraError, Fisheye, Intrinsics, Lens, RadialTangential};
use nullcone_shared_data::shared;
use proptest::prelude::*;

use super::{motor, vector};

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
        let file = CameraFile { intrinsics, size };
        let again = CameraFile::decode(file.encode().as_bytes()).unwrap();
        prop_assert_eq!(again, file, "{}", file.encode());
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
        let file = RigFile { rig, size };
        let again = RigFile::decode(file.encode().unwrap().as_bytes()).unwrap();
        prop_assert_eq!(again.size, size);
        prop_assert_eq!(again.rig.left, rig.left);
        prop_assert_eq!(again.rig.right.intrinsics, rig.right.intrinsics);
        let (a, b) = (again.rig.left_to_right().motor.to_matrix(), rig.left_to_right().motor.to_matrix());
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            prop_assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
    }

    #[test]
    fn numbers_and_texts_come_back(
        numbers in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::ZERO, 1..20),
        text in "\\PC{0,20}",
    ) {
        let mut storage = Storage::default();
        storage.set_matrix("m", Matrix::new(1, numbers.len(), numbers.clone()).unwrap());
        storage.set_number("n", numbers[0]);
        storage.set_text("t", &text);
        let encoded = storage.encode();
        let again = Storage::decode(encoded.as_bytes()).unwrap();
        let matrix = again.matrix("m").unwrap().unwrap();
        prop_assert_eq!(matrix.values(), numbers.as_slice());
        prop_assert_eq!(again.number("n").unwrap(), Some(numbers[0]));
        prop_assert_eq!(again.text("t").unwrap(), Some(text));
        // What was read is written as it was read.
        let third = Storage::decode(again.encode().as_bytes()).unwrap();
        prop_assert_eq!(third.matrix("m").unwrap(), again.matrix("m").unwrap());
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in "[-%:\\[\\]{}#&*!|>'\"0-9a-eM \n.,]{0,60}") {
        _ = Storage::decode(text.as_bytes());
        _ = RigFile::decode(format!("%YAML:1.0\nM1: {text}").as_bytes());
        _ = Calib::decode(text.as_bytes());
        _ = Calib::decode(format!("cam0=[{text}").as_bytes());
    }
}

#[test]
fn cameras_of_opencv_are_read() {
    let Some(path) = shared("data/vision/opencv/left_intrinsics.yml") else {
        return;
    };
    let file = CameraFile::read(path).unwrap();
    assert_eq!(file.size, Some([640, 480]));
    assert_eq!(file.intrinsics.focal(), [535.915_733_961_632; 2]);
    assert_eq!(
        file.intrinsics.principal(),
        [342.283_154_733_083_73, 235.570_829_097_881_73]
    );
    let found = file.intrinsics.lens().coefficients();
    assert_eq!(found[0], -0.266_372_609_096_606_8);
    assert_eq!(found[4], 0.238_391_530_808_784_86);
    assert!(found[5..].iter().all(|x| *x == 0.0));
}

#[test]
fn the_intrinsics_of_opencvs_rig_are_read() {
    let Some(path) = shared("data/vision/opencv/intrinsics.yml") else {
        return;
    };
    // It has no R and T, which OpenCV writes to a file of their own.
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(matches!(
        RigFile::decode(text.as_bytes()),
        Err(YamlError::Missing { name: "T", .. })
    ));
    let error = RigFile::read(&path).unwrap_err().to_string();
    assert!(
        error.contains("intrinsics.yml: there is no `T`, and none of `t`"),
        "{error}"
    );
    let more = format!("{text}R: [ 0.01, -0.02, 0.03 ]\nT: [ -3.3, 0.04, 0.05 ]\n");
    let rig = RigFile::decode(more.as_bytes()).unwrap().rig;
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

fn refused(text: &str, from: &str, to: &str) -> YamlError {
    assert!(text.contains(from), "{from}");
    RigFile::decode(text.replacen(from, to, 1).as_bytes()).unwrap_err()
}

#[test]
fn what_is_wrong_with_a_rig_is_named_with_its_line() {
    let rig = RigFile::decode(RIG.as_bytes()).unwrap();
    assert_eq!((rig.rig.baseline(), rig.size), (0.1, None));
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
        error("rows: 3\n   cols: 3", "rows: 9\n   cols: 1"),
        "line 3: `M1` has 9 × 1 values, not 3 × 3"
    );
    assert_eq!(
        error("500., 0.", "five, 0."),
        "line 7: `M1` is not a number"
    );
    assert_eq!(error("M2:", "M1:"), "line 8: `M1` is given a second time");
    assert_eq!(
        error("M2:", "N2:"),
        "there is no `M2`, and none of `K2`, `cameraMatrix2`, `camera_matrix_2`"
    );
}

#[test]
fn what_is_no_camera_of_a_rig_is_refused() {
    let negative = refused(RIG, "[ 500.", "[ -500.");
    assert!(
        matches!(
            &negative,
            YamlError::Camera { line: 3, error, .. }
                if matches!(**error, CameraError::Intrinsics { .. })
        ),
        "{negative}"
    );
    let skewed = refused(RIG, "500., 0., 320.", "500., 0.5, 320.");
    assert!(matches!(
        skewed,
        YamlError::Camera { error, .. }
            if matches!(*error, CameraError::Matrix { row: 0, column: 1, .. })
    ));
    let distorted = refused(RIG, "M2:", "D1: [ 0.1, 0.2, 0.3 ]\nM2:");
    assert!(matches!(
        distorted,
        YamlError::Camera { error, .. }
            if matches!(*error, CameraError::CoefficientCount { found: 3, .. })
    ));
    let size = refused(RIG, "M1:", "image_width: 640.5\nimage_height: 480\nM1:");
    assert!(matches!(
        size,
        YamlError::Size {
            line: 3,
            value: 640.5,
            ..
        }
    ));
    let half = refused(RIG, "M1:", "image_width: 640\nM1:");
    assert!(matches!(
        half,
        YamlError::Missing {
            name: "image_height",
            ..
        }
    ));
}

#[test]
fn what_is_no_rotation_of_a_rig_is_refused() {
    let scaled = refused(
        RIG,
        "1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT",
        "1., 0., 0., 0., 1.1, 0., 0., 0., 1. ]\nT",
    );
    let YamlError::Rotation {
        line: 13,
        deviation,
        ..
    } = scaled
    else {
        panic!("{scaled}");
    };
    assert!((deviation - 0.1).abs() < 1e-12);
    let mirrored = refused(
        RIG,
        "1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT",
        "-1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT",
    );
    assert!(matches!(mirrored, YamlError::Rotation { .. }));
}

#[test]
fn a_rotation_of_few_digits_is_replaced_by_the_nearest() {
    let (sine, cosine) = 0.3_f64.sin_cos();
    let rotation = format!(
        "{cosine:.5}, 0., {sine:.5}, 0., 1., 0., {:.5}, 0., {cosine:.5} ]\nT",
        -sine
    );
    let text = RIG.replacen("1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT", &rotation, 1);
    let rig = RigFile::decode(text.as_bytes()).unwrap().rig;
    let [x, y, z] = rig.left_to_right().motor.rotor().to_rotation_vector();
    assert!(
        x.abs() < 1e-15 && z.abs() < 1e-15 && (y - 0.3).abs() < 1e-5,
        "{y}"
    );
}

#[test]
fn no_values_and_values_with_any_name_come_back() {
    let empty = Storage::default().encode();
    assert_eq!(
        Storage::decode(empty.as_bytes()).unwrap(),
        Storage::default()
    );
    for name in ["- a", "a: b", ")M1", "#", "---", "\"", "a b", "1"] {
        let mut storage = Storage::default();
        storage.set_number(name, 1.5);
        let back = Storage::decode(storage.encode().as_bytes()).unwrap();
        assert_eq!(back.number(name).unwrap(), Some(1.5), "{name:?}");
    }
}

#[test]
fn what_is_not_such_yaml() {
    let error = |bytes: &[u8]| Storage::decode(bytes).unwrap_err();
    assert_eq!(error(b"a: 1\nb: \xff"), YamlError::NotText { line: 2 });
    assert_eq!(error(b"<?xml version=\"1.0\"?>"), YamlError::Xml);
    assert!(matches!(
        error(b"just words"),
        YamlError::Unsupported { line: 1, .. }
    ));
    assert!(matches!(error(b""), YamlError::Unsupported { .. }));
    assert!(matches!(
        error(b"%YAML:1.0\na: [ 1, 2\nb: 3"),
        YamlError::Syntax { line: 2.., .. }
    ));
    assert!(matches!(
        error(b"a: &x 1\nb: *x\n"),
        YamlError::Unsupported { line: 2, .. }
    ));
    assert!(matches!(
        error(b"a: 1\n---\nb: 2\n"),
        YamlError::Unsupported { .. }
    ));
    let deep = format!("a: {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(matches!(
        error(deep.as_bytes()),
        YamlError::Unsupported { .. } | YamlError::Syntax { .. }
    ));
    // Sizes that would overflow are compared with the values before anything is allocated.
    let huge = "a: { rows: 4294967295, cols: 4294967295, dt: \"4294967295d\", data: [ 1 ] }";
    let storage = Storage::decode(huge.as_bytes()).unwrap();
    assert!(matches!(
        storage.matrix("a"),
        Err(YamlError::ValueCount { found: 1, .. })
    ));
    assert!(matches!(
        Storage::decode(b"a: x").unwrap().number("a"),
        Err(YamlError::Type { line: 1, .. })
    ));
    let mixed = RigFile {
        rig: StereoRig {
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
        },
        size: None,
    };
    assert_eq!(mixed.encode(), Err(YamlError::MixedLenses));
}

#[test]
fn the_calibration_of_eth3d_is_read() {
    let Some(path) = shared("data/vision/stereo/eth3d_terrace/calib.txt") else {
        return;
    };
    let calib = Calib::read(path).unwrap();
    assert_eq!(calib.size, Some([713, 434]));
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
    let calib = Calib::decode(text.as_bytes()).unwrap();
    assert!((calib.rig.disparity_offset() - 124.343).abs() < 1e-9);
    let depth = calib.rig.depth(202.0).unwrap();
    assert!((depth - 3979.911 * 0.193001 / (202.0 + 124.343)).abs() < 1e-12);
    let error = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        Calib::decode(text.replacen(from, to, 1).as_bytes())
            .unwrap_err()
            .to_string()
    };
    assert_eq!(error("baseline=193.001\n", ""), "there is no baseline");
    assert_eq!(
        error("baseline=193.001", "baseline=0"),
        "line 4: the baseline is 0 m, which is not positive and finite"
    );
    assert_eq!(
        error("baseline=193.001", "baseline=far"),
        "line 4: baseline is not a number"
    );
    assert_eq!(
        error("doffs=124.343", "doffs"),
        "line 3: not of the form key=value"
    );
    assert_eq!(
        error("height=", "width="),
        "line 6: width is given a second time"
    );
    assert!(error("doffs=124.343", "doffs=12").starts_with("line 3: doffs is 12, and"));
    assert!(error("0 0 1]", "0 0 1 0]").starts_with("line 1: cam0 is not a matrix"));
    assert!(error("cam0=[3979.911", "cam0=[-3979.911").starts_with("line 1: cam0: focal"));
    assert!(error("cam0=[3979.911", "cam0=[nan").starts_with("line 1: cam0: focal"));
    assert!(error("cam1=[3979.911", "cam1=[3979").starts_with("line 2: the focal lengths"));
    assert!(matches!(Calib::decode(b"\xff"), Err(CalibError::NotText)));
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
    let error = RigFile::decode(yaml.as_bytes()).unwrap_err();
    assert!(
        matches!(&error, YamlError::Duplicate { line, name } if *line == COUNT + 1 && name == "n7"),
        "{error}"
    );
    let calib = format!("{}n7=2\n", names("="));
    let error = Calib::decode(calib.as_bytes()).unwrap_err();
    assert!(
        matches!(&error, CalibError::Duplicate { line, key } if *line == COUNT + 1 && key == "n7"),
        "{error}"
    );
}
