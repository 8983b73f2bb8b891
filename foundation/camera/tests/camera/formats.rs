//! Files of cameras of all formats: what they say by OpenCV, what comes back, and what is refused.

use std::path::Path;

use ga_camera::format::{
    self, CameraFile, CameraFileError, Format, NamedCamera, Omission, encode_files,
};
use ga_camera::{Fisheye, Intrinsics, LensModel, RadialTangential};
use ga_runtime::cga3::{Motor, Point};
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde::Deserialize;
use tempfile::tempdir;

use super::{motor, vector};

#[derive(Deserialize)]
struct Case {
    name: String,
    format: String,
    text: String,
    cameras: Vec<Seen>,
}

#[derive(Deserialize)]
struct Seen {
    name: String,
    size: Option<[usize; 2]>,
    posed: bool,
    points: Vec<[f64; 3]>,
    pixels: Vec<[f64; 2]>,
}

fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    format::decode(text.as_bytes(), Path::new("folder"))
}

fn assert_seen(camera: &NamedCamera, seen: &Seen, case: &str) {
    assert_eq!(camera.name, seen.name, "{case}");
    assert_eq!(camera.size, seen.size, "{case}");
    assert_eq!(camera.pose.is_some(), seen.posed, "{case}");
    let mut posed = camera.clone();
    posed.pose.get_or_insert(Motor::default());
    let posed = posed.camera().unwrap();
    for (point, expected) in seen.points.iter().zip(&seen.pixels) {
        let pixel = posed.project(Point::from(*point)).unwrap();
        let apart = (pixel[0] - expected[0]).hypot(pixel[1] - expected[1]);
        assert!(apart < 1e-9, "{case}: {} is {apart} px off", camera.name);
    }
}

#[test]
fn files_of_all_formats_say_what_opencv_sees() {
    let cases: Vec<Case> = serde_json::from_str(include_str!("../data/formats.json")).unwrap();
    let folder = tempdir().unwrap();
    let path = folder.path().join("file");
    for case in cases {
        // The contents tell the format, not the name.
        std::fs::write(&path, &case.text).unwrap();
        let read = format::read_with_format(&path);
        let (format, file) = read.unwrap_or_else(|error| panic!("{}: {error}", case.name));
        assert_eq!(format.word(), case.format, "{}", case.name);
        assert_eq!(file.cameras.len(), case.cameras.len(), "{}", case.name);
        for (camera, seen) in file.cameras.iter().zip(&case.cameras) {
            assert_seen(camera, seen, &case.name);
        }
    }
}

/// Qualisys' calibration of a film, and where OpenCV's `projectPoints` sees a point with the rows
/// of its `transform` as right, up and backwards.
#[test]
fn the_calibration_of_qualisys_is_read() {
    let Some(calibration) = shared("data/people/calibration.qca.txt") else {
        return;
    };
    let (format, found) = format::read_with_format(calibration).unwrap();
    assert_eq!(format, Format::Qualisys);
    let expected = [
        ("cam01", [998.924_902_571_941_2, 648.295_458_442_256_3]),
        ("cam02", [90.761_496_816_345_75, 502.292_562_388_388_5]),
        ("cam03", [180.842_555_761_811_64, 411.895_845_818_177_7]),
        ("cam04", [658.452_939_586_494_7, 308.399_190_198_322_8]),
    ];
    assert_eq!(found.cameras.len(), expected.len());
    for (camera, (name, pixel)) in found.cameras.iter().zip(expected) {
        assert_eq!(
            (camera.name.as_str(), camera.size),
            (name, Some([1088, 1920]))
        );
        let seen = camera.camera().unwrap();
        let seen = seen.project(Point::new(0.3, -0.4, 1.6)).unwrap();
        let apart = (seen[0] - pixel[0]).hypot(seen[1] - pixel[1]);
        assert!(apart < 1e-9, "{name} is {apart} px off");
    }
}

/// Of a field of the sensor, whose corner moves the principal point.
#[test]
fn fields_of_qualisys_move_the_principal_point() {
    let Some(path) = shared("data/people/calibration.qca.txt") else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let whole = decode(&text).unwrap();
    let field = text
        .replace("left=\"0\"", "left=\"100\"")
        .replace("top=\"0\"", "top=\"40\"");
    assert_ne!(field, text);
    let field = decode(&field).unwrap();
    for (whole, field) in whole.cameras.iter().zip(&field.cameras) {
        let [a, b] = [whole, field].map(|camera| camera.intrinsics().unwrap().principal());
        assert!((a[0] - b[0] - 100.0).abs() < 1e-9 && (a[1] - b[1] - 40.0).abs() < 1e-9);
        assert_eq!(field.size, Some([988, 1880]));
    }
}

/// Each camera is farther from the one before; cam10 and cam11 stand before cam2.
#[test]
fn chains_of_kalibr_go_by_numbers() {
    let mut names: Vec<usize> = (0..12).collect();
    names.sort_by_key(ToString::to_string);
    let camera = |number: usize| {
        let step = match number {
            0 => String::new(),
            _ => format!(
                "  T_cn_cnm1: [[1, 0, 0, -{number}], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n"
            ),
        };
        format!(
            "cam{number}:\n  camera_model: pinhole\n  intrinsics: [500, 500, 320, 240]\n  \
             distortion_model: radtan\n  distortion_coeffs: [0.1, 0, 0, 0]\n{step}"
        )
    };
    let text: String = names.into_iter().map(camera).collect();
    let found = decode(&text).unwrap();
    for (number, camera) in found.cameras.iter().enumerate() {
        assert_eq!(camera.name, format!("cam{number}"));
        let [x, y, z] = camera.pose.unwrap().translator().displacement();
        let expected = -((number * (number + 1) / 2) as f64);
        assert!(
            (x - expected).abs() < 1e-12 && y.abs() + z.abs() < 1e-12,
            "{number}: {x}"
        );
    }
}

/// Where a camera stands in its world.
fn centre(camera: &NamedCamera) -> [f64; 3] {
    let to_world = camera.pose.unwrap().reverse();
    to_world.transform(Point::new(0.0, 0.0, 0.0)).coordinates()
}

/// The grey cameras of KITTI are 54 cm apart by its paper; the right one has the fourth number
/// −f b. Cameras before and after rectification stand at the same places of one world.
#[test]
fn rigs_of_kitti_have_their_baselines() {
    let text = "P0: 7.215377e+02 0 6.095593e+02 0 0 7.215377e+02 1.728540e+02 0 0 0 1 0\n\
                P1: 7.215377e+02 0 6.095593e+02 -3.875744e+02 0 7.215377e+02 1.728540e+02 0 0 0 1 0\n";
    let file = decode(text).unwrap();
    let [x, y, z] = centre(&file.cameras[1]);
    assert!((x - 387.5744 / 721.5377).abs() < 1e-12 && y == 0.0 && z == 0.0);
    assert!((0.53..0.55).contains(&file.rig(&[]).unwrap().baseline()));

    let cases: Vec<Case> = serde_json::from_str(include_str!("../data/formats.json")).unwrap();
    let turned = "calib_cam_to_cam.txt whose rectification turns";
    let case = cases.iter().find(|case| case.name == turned).unwrap();
    let file = decode(&case.text).unwrap();
    for number in ["00", "01"] {
        let [a, b] = ["P_rect_", "K_"].map(|kind| {
            let camera = file.camera(&format!("{kind}{number}")).unwrap();
            centre(camera)
        });
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-12), "{a:?} {b:?}");
    }
    // |T_01| is the baseline of any pair.
    let expected = 0.54_f64.hypot(0.004).hypot(0.01);
    for pair in [
        ["K_00", "K_01"],
        ["P_rect_00", "P_rect_01"],
        ["P_rect_00", "K_01"],
    ] {
        let rig = file.rig(&pair.map(str::to_owned)).unwrap();
        assert!((rig.baseline() - expected).abs() < 1e-12, "{pair:?}");
    }
}

/// What each format that is written can hold.
fn rigs() -> impl Strategy<Value = CameraFile> {
    let coefficients = prop::collection::vec(-0.2..0.2, 5);
    let lens = prop_oneof![
        Just(ga_camera::Lens::Pinhole),
        coefficients.prop_map(|k| RadialTangential::new(&k).unwrap().into()),
        prop::array::uniform4(-0.1..0.1).prop_map(|k| Fisheye::new(&k).unwrap().into()),
    ];
    let camera =
        (100.0..2000.0, 100.0..2000.0, vector(700.0), lens).prop_map(|(fx, fy, c, lens)| {
            let plain = Intrinsics::new([fx, fy], [c[0], c[1]]).unwrap();
            plain.with_lens(lens)
        });
    let pose = prop::option::weighted(0.7, (vector(1.0), -3.0..3.0, vector(2.0)));
    let cameras = prop::collection::vec((camera, pose), 1..4);
    (cameras, 1usize..9000, 1usize..9000).prop_map(|(cameras, width, height)| {
        let cameras = cameras.into_iter().enumerate();
        let cameras = cameras.map(|(index, (intrinsics, pose))| {
            NamedCamera::new(format!("cam{index}"), intrinsics)
                .with_size(Some([width, height]))
                .with_pose(pose.map(|(axis, angle, along)| motor(axis, angle, along)))
        });
        CameraFile::new(cameras.collect())
    })
}

/// Whether a format has no room for such cameras, none of which stand side by side.
fn is_refused(format: Format, file: &CameraFile) -> bool {
    let cameras = &file.cameras;
    let count = cameras.len();
    let models = cameras
        .iter()
        .map(|camera| camera.intrinsics().unwrap().lens().model());
    let models: Vec<LensModel> = models.collect();
    let has = |model| models.contains(&model);
    let posed = cameras
        .iter()
        .filter(|camera| camera.pose.is_some())
        .count();
    match format {
        Format::OpenCv | Format::OpenCvXml | Format::OpenCvJson => {
            count > 2 || (has(LensModel::Fisheye) && models.iter().any(|m| *m != models[0]))
        }
        Format::Ros => count > 1,
        // All have k3 but for pinholes and fisheyes.
        Format::Kalibr => has(LensModel::RadialTangential),
        Format::Kitti => has(LensModel::Fisheye) || (count > 1 && posed < count),
        Format::Json => count > 1 && posed < count,
        Format::Colmap => 0 < posed && posed < count,
        Format::Anipose => false,
        Format::Middlebury | Format::Qualisys | Format::Transforms => true,
    }
}

/// Cameras of every format in OpenCV's and back: what OpenCV's does not hold is said.
#[test]
fn cameras_of_every_format_come_back_from_opencvs() {
    let cases: Vec<Case> = serde_json::from_str(include_str!("../data/formats.json")).unwrap();
    let folder = tempdir().unwrap();
    let write = |files: &[(std::path::PathBuf, String)]| {
        for (path, text) in files {
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
    };
    let mut formats = Vec::new();
    for case in cases {
        let path = folder.path().join("in");
        std::fs::write(&path, &case.text).unwrap();
        let (from, mut file) = format::read_with_format(&path).unwrap();
        file.cameras.truncate(2);
        let models = file
            .cameras
            .iter()
            .map(|camera| camera.intrinsics().unwrap().lens().model());
        let fisheyes = models.filter(|model| *model == LensModel::Fisheye).count();
        if fisheyes > 0 && fisheyes < file.cameras.len() {
            let error = encode_files("out.yml", Format::OpenCv, &file).unwrap_err();
            assert!(
                matches!(error, CameraFileError::MixedLenses),
                "{}: {error}",
                case.name
            );
            file.cameras.truncate(1);
        }
        let out = folder.path().join("out.yml");
        let encoded = encode_files(&out, Format::OpenCv, &file).unwrap();
        write(&encoded.files);
        let (_, again) = format::read_with_format(&out).unwrap();
        assert_same(&again, &file, &encoded.omissions, &case.name);
        formats.push(from);

        let back = folder.path().join("back");
        let encoded = match encode_files(&back, from, &again) {
            Ok(encoded) => encoded,
            Err(error) => {
                assert!(
                    matches!(error, CameraFileError::ReadOnly(_)) && !from.is_written(),
                    "{}: {error}",
                    case.name
                );
                continue;
            }
        };
        write(&encoded.files);
        let (found, third) = format::read_with_format(&back).unwrap();
        assert_eq!(found, from, "{}", case.name);
        assert_same(&third, &again, &encoded.omissions, &case.name);
    }
    for format in Format::ALL {
        let is_folder = format.names_in_folder().is_some();
        let has_own_cases = is_folder || [Format::Json, Format::Middlebury].contains(&format);
        assert!(formats.contains(&format) || has_own_cases, "{format:?}");
    }
}

/// Cameras are equal but for rounding and what is said to be left out.
fn assert_same(found: &CameraFile, expected: &CameraFile, omissions: &[Omission], case: &str) {
    let omits = |what: &str| omissions.iter().any(|found| found.what.contains(what));
    assert_eq!(found.cameras.len(), expected.cameras.len(), "{case}");
    let first = expected.cameras[0].pose.filter(|_| omits("places"));
    for (found, expected) in found.cameras.iter().zip(&expected.cameras) {
        let [a, b] = [found, expected].map(|camera| camera.intrinsics().unwrap());
        assert_eq!(a.lens(), b.lens(), "{case}");
        for (p, q) in a.parameters().into_iter().zip(b.parameters()) {
            assert!((p - q).abs() <= 1e-12 * q.abs().max(1.0), "{case}: {p} {q}");
        }
        assert!(found.size == expected.size || omits("sizes"), "{case}");
        // Names that are those of cameras without names are not kept.
        let has_name = !["camera", "left", "right"].contains(&expected.name.as_str());
        assert!(
            !has_name || found.name == expected.name || omits("names"),
            "{case}"
        );
        let pose = expected
            .pose
            .map(|pose| pose * first.unwrap_or_default().reverse());
        match (found.pose, pose) {
            _ if omits("poses") => {}
            (None, None) => {}
            // A camera in the origin of its world is where one without a pose is.
            (Some(p), None) | (None, Some(p)) => assert_eq!(p, Motor::default(), "{case}"),
            (Some(p), Some(q)) => {
                let (p, q) = (p.to_matrix(), q.to_matrix());
                let mut pairs = p.iter().flatten().zip(q.iter().flatten());
                assert!(pairs.all(|(p, q)| (p - q).abs() < 1e-12), "{case}");
            }
        }
    }
}

/// Names are texts of any kind, though not in COLMAP's files.
#[test]
fn names_with_any_characters_come_back() {
    let intrinsics = Intrinsics::new([500.0; 2], [320.0, 240.0]).unwrap();
    for name in [
        "\u{7f}",
        "a\"b\\c",
        "a: b # c",
        "[x]",
        "\t\u{85}é\u{1f600}",
        "yes",
        "1",
    ] {
        let camera = NamedCamera::new(name, intrinsics).with_size(Some([640, 480]));
        let file = CameraFile::new(vec![camera.with_pose(Some(Motor::default()))]);
        for format in [Format::Anipose, Format::Ros] {
            let encoded = encode_files("out", format, &file).unwrap();
            let again = decode(&encoded.files[0].1).unwrap();
            assert_eq!(again.cameras[0].name, name, "{format:?}");
        }
    }
}

/// What Middlebury's file says of rectified pictures is kept by none but its own.
#[test]
fn marks_of_rectified_pictures_are_said_to_be_left_out() {
    let text = "cam0=[500 0 320; 0 500 240; 0 0 1]\ncam1=[500 0 325; 0 500 240; 0 0 1]\ndoffs=5\n\
                baseline=100\nwidth=640\nheight=480\nndisp=64\n";
    let file = decode(text).unwrap();
    let omitted = |format| {
        let encoded = encode_files("out", format, &file).unwrap();
        let omissions = encoded.omissions.iter().map(|omission| omission.what);
        omissions.collect::<Vec<_>>()
    };
    let [marks, bounds] = ["marks of rectified pictures", "bounds of disparities"];
    assert_eq!(omitted(Format::Middlebury), [""; 0]);
    assert_eq!(omitted(Format::OpenCv), [marks, bounds]);
    assert_eq!(omitted(Format::Kitti), ["sizes of pictures", bounds]);
}

/// Middlebury's format has a baseline and no poses.
#[test]
fn middleburys_format_takes_only_views_side_by_side() {
    let intrinsics = Intrinsics::new([500.0; 2], [320.0, 240.0]).unwrap();
    let view = |name: &str, pose| {
        let camera = NamedCamera::new(name, intrinsics).with_size(Some([640, 480]));
        camera.with_pose(Some(pose))
    };
    let pair = |right| {
        let file = CameraFile::new(vec![view("left", Motor::default()), view("right", right)]);
        encode_files("out", Format::Middlebury, &file)
    };
    let y = [0.0, 1.0, 0.0];
    let text = &pair(motor(y, 0.0, [-0.25, 0.0, 0.0])).unwrap().files[0].1;
    assert!(text.contains("baseline=250"), "{text}");
    for (angle, displacement) in [
        (1e-6, [-0.25, 0.0, 0.0]),
        (0.0, [-0.25, 1e-6, 0.0]),
        (0.0, [-0.25, 0.0, -1e-6]),
    ] {
        let error = pair(motor(y, angle, displacement)).unwrap_err();
        assert!(
            matches!(error, CameraFileError::NotRectified { .. }),
            "{error}"
        );
    }
}

proptest! {
    #[test]
    fn what_is_written_comes_back(file in rigs()) {
        let folder = tempdir().unwrap();
        for format in Format::ALL {
            let path = folder.path().join(format.word());
            let encoded = encode_files(&path, format, &file);
            prop_assert_eq!(encoded.is_err(), is_refused(format, &file), "{:?} {:?}", format, encoded);
            let Ok(encoded) = encoded else { continue };
            for (path, text) in &encoded.files {
                std::fs::create_dir_all(path.parent().unwrap()).unwrap();
                std::fs::write(path, text).unwrap();
            }
            let (found, again) = format::read_with_format(&path).unwrap();
            prop_assert_eq!(found, format);
            assert_same(&again, &file, &encoded.omissions, format.word());
        }
    }

    /// Files that are cut, or in which some bytes are others, are read or refused in one line.
    #[test]
    fn no_fault_of_a_file_makes_a_reader_panic(
        case in 0usize..64,
        cut in 0.0..1.5,
        faults in prop::collection::vec((0.0..1.0, prop::sample::select(b"0-[]{}:=\"<>/.,e \n\0x".to_vec())), 0..4),
    ) {
        let cases: Vec<Case> =
            serde_json::from_str(include_str!("../data/formats.json")).unwrap();
        let mut bytes = cases[case % cases.len()].text.clone().into_bytes();
        let length = bytes.len() as f64;
        for (place, byte) in faults {
            bytes[(place * length) as usize] = byte;
        }
        bytes.truncate((cut * length) as usize);
        match format::decode(&bytes, Path::new("nowhere")) {
            Ok(file) => for camera in &file.cameras {
                let pose = camera.pose.map(|pose| pose.to_matrix());
                let numbers = pose.iter().flatten().flatten();
                prop_assert!(numbers.into_iter().all(|x| x.is_finite()));
            },
            Err(error) => prop_assert!(!error.to_string().contains('\n'), "{}", error),
        }
    }
}
