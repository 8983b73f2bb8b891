//! Files of cameras of all formats: what they say by OpenCV, what comes back, and what is refused.

use std::path::Path;

use ga_camera::format::{self, CameraFile, CameraFileError, Format, NamedCamera, encode_files};
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

fn message(text: &str) -> String {
    decode(text).unwrap_err().to_string()
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

/// The first camera of Qualisys' calibration of a film, and what another program made of it.
#[test]
fn the_calibration_of_qualisys_is_read() {
    let (Some(calibration), Some(views)) = (
        shared("data/people/calibration.qca.txt"),
        shared("data/people/views.json"),
    ) else {
        return;
    };
    let (format, found) = format::read_with_format(calibration).unwrap();
    assert_eq!(format, Format::Qualisys);
    let expected = format::read(views).unwrap();
    assert_eq!(found.cameras.len(), 4);
    for (found, expected) in found.cameras.iter().zip(&expected.cameras) {
        assert_eq!(found.size, Some([1088, 1920]));
        let [a, b] = [found, expected].map(|camera| camera.camera().unwrap());
        for point in [[0.0, 0.0, 1.0], [0.3, -0.4, 1.6], [-0.5, 0.2, 0.1]] {
            let point = Point::from(point);
            let [p, q] = [a, b].map(|camera| camera.project(point).unwrap());
            assert!((p[0] - q[0]).hypot(p[1] - q[1]) < 1e-9, "{}", found.name);
        }
    }
    assert_eq!(found.cameras[2].name, "cam03");
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

#[test]
fn lenses_are_those_that_are_stated() {
    let opencv =
        "%YAML:1.0\n---\nfisheye_model: 1\ncamera_matrix: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n";
    let error = decode(opencv).unwrap_err().to_string();
    assert!(error.contains("distortion_coefficients"), "{error}");
    // Six radial terms are not those of a fisheye.
    let rational = "fx: 500\nfy: 500\ncx: 320\ncy: 240\nk1: 0.1\nk2: 0.2\nk3: 0.3\nk4: 0.4\n\
                    k5: 0.5\nk6: 0.6\n";
    let found = decode(rational).unwrap().cameras[0].intrinsics().unwrap();
    assert_eq!(
        found.lens().coefficients()[..8],
        [0.1, 0.2, 0.0, 0.0, 0.3, 0.4, 0.5, 0.6]
    );
    // 640 in hexadecimal.
    let toml = "[cam_0]\nsize = [0x280, 480]\nmatrix = [[500.0, 0, 320], [0, 500, 240], [0, 0, 1]]\n\
                distortions = [0.1, 0, 0, 0, 0]\nrotation = [0, 0, 0]\ntranslation = [0, 0, 1]\n";
    assert_eq!(decode(toml).unwrap().cameras[0].size, Some([640, 480]));
}

const CAMERAS: &str = "# Camera list\n1 OPENCV 640 480 500 501 320.5 240.5 -0.1 0.02 0.001 0.002\n\
                       7 SIMPLE_RADIAL 640 480 400 320 240 0.05\n";
const IMAGES: &str = "# Image list\n3 0.7071067811865476 0 0.7071067811865476 0 0.5 0 3 1 a.png\n\
                      1.5 2.5 -1 3.5 4.5 7\n4 1 0 0 0 0 0 0 7 sub/b c.png\n\n";

#[test]
fn models_of_colmap_are_read_as_text_and_as_bytes() {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("cameras.txt", CAMERAS.as_bytes());
    let alone = format::read(folder.path()).unwrap();
    assert_eq!(alone.cameras[1].name, "7");
    assert!(alone.cameras[1].pose.is_none());
    write("images.txt", IMAGES.as_bytes());
    let text = format::read(folder.path()).unwrap();
    let names: Vec<&str> = text.cameras.iter().map(|camera| &*camera.name).collect();
    assert_eq!(names, ["a.png", "sub/b c.png"]);
    // (x, y, z) = (2 + 0.5, 0.3, −1 + 3) for a rotation by 90° about y.
    let plain = NamedCamera::new(
        "",
        Intrinsics::new([500.0, 501.0], [320.0, 240.0])
            .unwrap()
            .with_lens(RadialTangential::new(&[-0.1, 0.02, 0.001, 0.002]).unwrap()),
    );
    let expected = plain
        .intrinsics()
        .unwrap()
        .project(Point::new(2.5, 0.3, 2.0))
        .unwrap();
    let seen = text.cameras[0]
        .camera()
        .unwrap()
        .project(Point::new(1.0, 0.3, 2.0))
        .unwrap();
    assert!(
        (0..2).all(|k| (seen[k] - expected[k]).abs() < 1e-9),
        "{seen:?}"
    );
    let second = text.cameras[1].intrinsics().unwrap();
    assert_eq!(
        (second.focal(), second.principal()),
        ([400.0; 2], [319.5, 239.5])
    );
    assert_eq!(second.lens().coefficients()[..3], [0.05, 0.0, 0.0]);

    let mut cameras = 2u64.to_le_bytes().to_vec();
    let mut device = |id: u32, model: i32, parameters: &[f64]| {
        cameras.extend(id.to_le_bytes());
        cameras.extend(model.to_le_bytes());
        cameras.extend([640u64, 480].iter().flat_map(|side| side.to_le_bytes()));
        cameras.extend(parameters.iter().flat_map(|x| x.to_le_bytes()));
    };
    device(
        1,
        4,
        &[500.0, 501.0, 320.5, 240.5, -0.1, 0.02, 0.001, 0.002],
    );
    device(7, 2, &[400.0, 320.0, 240.0, 0.05]);
    let mut images = 2u64.to_le_bytes().to_vec();
    let mut image = |id: u32, pose: [f64; 7], camera: u32, name: &str, points: u64| {
        images.extend(id.to_le_bytes());
        images.extend(pose.iter().flat_map(|x| x.to_le_bytes()));
        images.extend(camera.to_le_bytes());
        images.extend(name.as_bytes().iter().chain(&[0]));
        images.extend(points.to_le_bytes());
        images.extend((0..24 * points).map(|_| 1u8));
    };
    let half = std::f64::consts::FRAC_1_SQRT_2;
    image(3, [half, 0.0, half, 0.0, 0.5, 0.0, 3.0], 1, "a.png", 2);
    image(4, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 7, "sub/b c.png", 0);
    let binary = tempdir().unwrap();
    let path = |name: &str| binary.path().join(name);
    std::fs::write(path("cameras.bin"), &cameras).unwrap();
    std::fs::write(path("images.bin"), &images).unwrap();
    assert_eq!(format::read(binary.path()).unwrap(), text);
    // A file that ends early says where.
    for end in [9, 20, 90, cameras.len() - 1] {
        let error = format::decode(&cameras[..end], Path::new(""))
            .unwrap_err()
            .to_string();
        assert!(error.contains("cameras.bin: it ends here"), "{error}");
    }
    let picture = format::decode(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", Path::new("")).unwrap_err();
    assert!(
        matches!(picture, CameraFileError::NotText { line: 1 }),
        "{picture}"
    );
    std::fs::write(path("images.bin"), &images[..images.len() - 9]).unwrap();
    let error = format::read(binary.path()).unwrap_err().to_string();
    assert!(error.contains("images.bin"), "{error}");
}

#[test]
fn four_coefficients_without_a_mark_are_asked_for() {
    let unmarked = "camera_matrix: [[45.5, 0, 94.5], [0, 45.5, 61.5], [0, 0, 1]]\n\
                    distortion_coefficients: [0.003, 0.0272, -0.0268, 0.0079]\n";
    let json = r#"{"width": 190, "height": 124, "fx": 45.5, "fy": 45.5, "cx": 94.5, "cy": 61.5,
        "distortion": [0.003, 0.0272, -0.0268, 0.0079]}"#;
    for text in [unmarked, json] {
        let file = decode(text).unwrap();
        let error = file.cameras[0].intrinsics().unwrap_err().to_string();
        assert!(
            error.contains("has 4 numbers") && error.contains("--lens fisheye"),
            "{error}"
        );
        let lens = |model| {
            let file = file.clone().with_lens_model(Some(model)).unwrap();
            file.cameras[0].intrinsics().unwrap().lens()
        };
        let k = [0.003, 0.0272, -0.0268, 0.0079];
        assert_eq!(lens(LensModel::Fisheye), Fisheye::new(&k).unwrap().into());
        let radial = RadialTangential::new(&k).unwrap();
        assert_eq!(lens(LensModel::RadialTangential), radial.into());
    }
    // What is stated stays, and cannot be changed.
    for (mark, model) in [
        ("fisheye_model: 1", LensModel::Fisheye),
        ("fisheye: true", LensModel::Fisheye),
        ("distortion_model: plumb_bob", LensModel::RadialTangential),
        ("fisheye_model: 0", LensModel::RadialTangential),
    ] {
        let file = decode(&format!("{unmarked}{mark}\n")).unwrap();
        assert_eq!(
            file.cameras[0].intrinsics().unwrap().lens().model(),
            model,
            "{mark}"
        );
        let other = match model {
            LensModel::Fisheye => LensModel::RadialTangential,
            _ => LensModel::Fisheye,
        };
        let error = file.with_lens_model(Some(other)).unwrap_err().to_string();
        assert!(error.contains("in the file"), "{error}");
    }
    // Nothing is unclear of five numbers, of none, and of zeros.
    for numbers in ["[0.1, 0, 0, 0, 0]", "[]", "[0, 0, 0, 0]"] {
        let text = unmarked.replace("[0.003, 0.0272, -0.0268, 0.0079]", numbers);
        decode(&text).unwrap().cameras[0].intrinsics().unwrap();
    }
}

#[test]
fn faults_name_key_and_line() {
    let kalibr = "cam0:\n  camera_model: pinhole\n  intrinsics: [525.25, 526.5, 319.5, 239.5]\n  \
                  distortion_model: radtan\n  distortion_coeffs: [-0.37, 0.24, 0.001, -0.002]\n  \
                  resolution: [640, 480]\n";
    let kitti = "P0: 721.5 0 609.5 0 0 721.5 172.8 0 0 0 1 0\n";
    let toml = "[cam_0]\nsize = [640, 480]\nmatrix = [[500.0, 0, 320], [0, 500, 240], [0, 0, 1]]\n\
                distortions = [0.1, 0, 0, 0, 0]\nrotation = [0, 0, 0]\ntranslation = [0, 0, 1]\n";
    let xml = "<?xml version=\"1.0\"?>\n<opencv_storage>\n<K type_id=\"opencv-matrix\">\n<rows>3</rows>\
               <cols>3</cols><dt>d</dt>\n<data>\n5. 0. 3. 0. 5. 2. 0. 0. 1.</data></K>\n\
               </opencv_storage>\n";
    let ros = "width: 640\nheight: 480\ndistortion_model: plumb_bob\nd: [0.1, 0, 0, 0, 0]\n\
               k: [5, 0, 3, 0, 5, 2, 0, 0, 1]\n";
    let colmap = "# Cameras\n1 PINHOLE 640 480 500 500 320 240\n";
    for text in [kalibr, kitti, toml, xml, ros, colmap] {
        decode(text).unwrap();
    }
    for (text, from, to, expected) in [
        (
            kalibr,
            "pinhole",
            "omni",
            "line 2: `cam0.camera_model` is \"omni\", which is not read",
        ),
        (
            kalibr,
            "radtan",
            "fov",
            "line 4: `cam0.distortion_model` is \"fov\"",
        ),
        (
            kalibr,
            "526.5, ",
            "",
            "line 3: `cam0.intrinsics` has 3 × 1 values, not four",
        ),
        (
            kalibr,
            "  intrinsics: [525.25, 526.5, 319.5, 239.5]\n",
            "",
            "line 2: there is no `cam0.intrinsics`",
        ),
        (
            kalibr,
            "0.24",
            "x",
            "line 5: `cam0.distortion_coeffs` is not a number",
        ),
        (
            kitti,
            "609.5",
            "six",
            "line 1: `P0` is not a list of numbers",
        ),
        (
            kitti,
            " 1 0\n",
            " 1\n",
            "line 1: `P0` has 1 × 11 values, not 3 × 4",
        ),
        (kitti, "721.5", "-721.5", "line 1: `P0`: focal lengths"),
        (toml, "320]", "320, 7]", "line 3: `cam_0.matrix`"),
        (toml, "= [0, 0, 1]", "=", "line 6: not TOML"),
        (
            toml,
            "rotation = [0, 0, 0]\n",
            "",
            "line 1: there is no `cam_0.rotation`",
        ),
        (toml, "matrix", "matrox", "there is no `matrix`"),
        (
            xml,
            "0. 0. 1.",
            "0. 1.",
            "line 3: `K` has 8 values, not 3 × 3",
        ),
        (xml, "</K>", "", "line 7: not XML"),
        (xml, "5. 0. 3.", "5. 0. three", "`K` is not a number"),
        (
            ros,
            "plumb_bob",
            "thin_prism",
            "line 3: `distortion_model` is \"thin_prism\"",
        ),
        (ros, "k: [5", "k: [0", "line 5: `k`: focal lengths"),
        (
            ros,
            "width: 640\n",
            "width: 640\nbinning_x: 2\n",
            "line 2: the picture has fewer pixels",
        ),
        (
            colmap,
            "PINHOLE",
            "FOV",
            "line 2: `MODEL` is \"FOV\", which is not read",
        ),
        (colmap, " 240\n", "\n", "line 2: there is no `PARAMS`"),
        (
            colmap,
            "640",
            "0",
            "line 2: `WIDTH` is 0, not a number of pixels",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let found = message(&changed);
        assert!(found.contains(expected), "{found} does not say {expected}");
    }
    // Messages that are printed again say the same; others do not.
    decode(&format!("{ros}---\n{ros}---\n")).unwrap();
    let other = ros.replace("k: [5", "k: [6");
    let found = message(&format!("{ros}---\n{other}"));
    assert!(
        found.starts_with("line 7: a second document begins here"),
        "{found}"
    );
    let found = message("<html></html>");
    assert!(found.contains("there is no `camera_matrix`"), "{found}");
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

proptest! {
    #[test]
    fn what_is_written_comes_back(file in rigs()) {
        let folder = tempdir().unwrap();
        for format in Format::ALL {
            let path = folder.path().join(format.word());
            let Ok(encoded) = encode_files(&path, format, &file) else { continue };
            for (path, text) in &encoded.files {
                std::fs::create_dir_all(path.parent().unwrap()).unwrap();
                std::fs::write(path, text).unwrap();
            }
            let (found, again) = format::read_with_format(&path).unwrap();
            prop_assert_eq!(found, format);
            prop_assert_eq!(again.cameras.len(), file.cameras.len());
            let omits = |what: &str| encoded.omissions.iter().any(|found| found.what.contains(what));
            let all = again.cameras.iter().zip(&file.cameras);
            for (again, camera) in all {
                let [a, b] = [again, camera].map(|camera| camera.intrinsics().unwrap());
                prop_assert_eq!(a.lens(), b.lens(), "{:?}", format);
                let pairs = a.parameters().into_iter().zip(b.parameters());
                for (p, q) in pairs {
                    prop_assert!((p - q).abs() <= 1e-12 * q.abs().max(1.0), "{:?} {} {}", format, p, q);
                }
                prop_assert!(again.size == camera.size || omits("sizes"), "{:?}", format);
                prop_assert!(again.name == camera.name || omits("names"), "{:?}", format);
                let first = file.cameras[0].pose.filter(|_| omits("places"));
                let expected = camera.pose.map(|pose| pose * first.unwrap_or_default().reverse());
                match (again.pose, expected) {
                    _ if omits("poses") => {}
                    (Some(p), Some(q)) => {
                        let (p, q) = (p.to_matrix(), q.to_matrix());
                        let mut pairs = p.iter().flatten().zip(q.iter().flatten());
                        prop_assert!(pairs.all(|(p, q)| (p - q).abs() < 1e-12), "{:?}", format);
                    }
                    // The projection of one camera has a place, though nothing is known of it.
                    (Some(p), None) => prop_assert_eq!(p, Motor::default(), "{:?}", format),
                    // A camera in the origin of its world is where one without a pose is.
                    (None, Some(q)) => prop_assert!(
                        q == Motor::default(),
                        "{:?}", format
                    ),
                    (None, None) => {}
                }
            }
        }
    }

    /// Files that are cut, or in which some bytes are others, are read or refused in one line.
    #[test]
    fn no_fault_of_a_file_makes_a_reader_panic(
        case in 0usize..21,
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
