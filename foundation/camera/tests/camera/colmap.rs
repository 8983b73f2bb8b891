//! Models of COLMAP, by the description of its files.

use std::path::Path;

use ga_camera::format::{self, CameraFile, CameraFileError, NamedCamera};
use ga_camera::{Intrinsics, RadialTangential};
use ga_runtime::cga3::Point;
use tempfile::tempdir;

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

/// The cameras or the error of a model in text.
fn model(cameras: &str, images: &str) -> Result<CameraFile, String> {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("cameras.txt"), cameras).unwrap();
    std::fs::write(folder.path().join("images.txt"), images).unwrap();
    let found = format::read(folder.path());
    found.map_err(|error| {
        let folder = folder.path().display().to_string();
        error.to_string().replace(&folder, "")
    })
}

const PINHOLE: &str = "# Cameras\n1 PINHOLE 640 480 500 500 320 240\n";

#[test]
fn lines_of_points_are_told_from_images() {
    // Comments may stand anywhere, and the last line of points may be missing.
    let images = "# Images\n\n1 1 0 0 0 0 0 0 1 a.png\n\n# between\n2 1 0 0 0 1 0 0 1 b.png\n1 2 3 4 5 -1\n\
                  3 1 0 0 0 2 0 0 1 c.png";
    let found = model(PINHOLE, images).unwrap();
    let names: Vec<&str> = found.cameras.iter().map(|camera| &*camera.name).collect();
    assert_eq!(names, ["a.png", "b.png", "c.png"]);
    let x = |k: usize| found.cameras[k].pose.unwrap().translator().displacement()[0];
    assert_eq!([x(0), x(1), x(2)], [0.0, 1.0, 2.0]);
    // Without lines of points, each second image would be one.
    for (images, line) in [
        ("1 1 0 0 0 0 0 0 1 a.png\n2 1 0 0 0 1 0 0 1 b.png\n", 2),
        (
            "1 1 0 0 0 0 0 0 1 a.png\n\n2 1 0 0 0 1 0 0 1 b.png\n1 2\n",
            4,
        ),
        ("1 1 0 0 0 0 0 0 1 a.png\n1 2 x\n", 2),
    ] {
        let error = model(PINHOLE, images).unwrap_err();
        let expected = format!("/images.txt: line {line}: `POINTS2D` is not a list of points");
        assert!(error.contains(&expected), "{error}");
    }
}

#[test]
fn faults_of_models_name_file_line_and_key() {
    let image = "1 1 0 0 0 0 0 0 1 a.png\n\n";
    for (cameras, images, expected) in [
        (
            PINHOLE,
            image.replacen("1 1 0", "1 0 0", 1),
            "/images.txt: line 1: `QW` is not the first of four numbers of a quaternion",
        ),
        (
            PINHOLE,
            image.replacen("1 a", "7 a", 1),
            "/images.txt: line 1: `a.png: CAMERA_ID` is not the number of a camera",
        ),
        (
            PINHOLE,
            image.replacen(" 1 a.png", "", 1),
            "/images.txt: line 1: there is no `CAMERA_ID`",
        ),
        (
            PINHOLE,
            image.replacen("0 0 1 a", "nan 0 1 a", 1),
            "/images.txt: line 1: `TY` has the value NaN, which is not finite",
        ),
        (
            "1 PINHOLE 640 480 500 500 320 240\n1 PINHOLE 640 480 400 400 320 240\n",
            image.to_owned(),
            "/cameras.txt: line 2: `camera 1` is given a second time",
        ),
        (
            "1 FISHEYE 640 480 500 500 320 240\n",
            image.to_owned(),
            "/cameras.txt: line 1: `MODEL` is \"FISHEYE\", which is not read",
        ),
        (
            "1 PINHOLE 640 480 500 500 320 240 0.1\n",
            image.to_owned(),
            "/cameras.txt: line 1: `PARAMS` is not the parameters of its model alone",
        ),
    ] {
        let error = model(cameras, &images).unwrap_err();
        assert!(error.contains(expected), "{error} does not say {expected}");
        assert!(
            !error.contains('\n') && !error.contains("differs"),
            "{error}"
        );
    }
}

/// A name with a line break would be a line of its own.
#[test]
fn names_that_are_no_words_are_not_written() {
    let intrinsics = Intrinsics::new([500.0; 2], [320.0, 240.0]).unwrap();
    for (name, is_written) in [
        ("a b.png", true),
        ("a\n2 1.png", false),
        ("a  b", false),
        ("", false),
    ] {
        let camera = NamedCamera::new(name, intrinsics).with_size(Some([640, 480]));
        let file = CameraFile::new(vec![camera.with_pose(Some(Default::default()))]);
        let encoded = format::encode_files("model", format::Format::Colmap, &file);
        assert_eq!(encoded.is_ok(), is_written, "{name:?}");
    }
}

/// Every prefix of a binary file is refused at the byte where it ends, in one line.
#[test]
fn binary_files_that_are_cut_are_refused() {
    let folder = tempdir().unwrap();
    let mut cameras = 1u64.to_le_bytes().to_vec();
    cameras.extend(5u32.to_le_bytes());
    cameras.extend(0i32.to_le_bytes());
    cameras.extend([640u64, 480].iter().flat_map(|side| side.to_le_bytes()));
    cameras.extend(
        [500.0f64, 320.0, 240.0]
            .iter()
            .flat_map(|x| x.to_le_bytes()),
    );
    let mut images = 1u64.to_le_bytes().to_vec();
    images.extend(3u32.to_le_bytes());
    let pose = [1.0f64, 0.0, 0.0, 0.0, 0.1, 0.2, 0.3];
    images.extend(pose.iter().flat_map(|x| x.to_le_bytes()));
    images.extend(5u32.to_le_bytes());
    images.extend(b"a.png\0");
    images.extend(1u64.to_le_bytes());
    images.extend([0u8; 24]);
    let read = |cameras: &[u8], images: &[u8]| {
        std::fs::write(folder.path().join("cameras.bin"), cameras).unwrap();
        std::fs::write(folder.path().join("images.bin"), images).unwrap();
        format::read(folder.path())
    };
    assert_eq!(read(&cameras, &images).unwrap().cameras[0].name, "a.png");
    for end in 8..cameras.len() {
        let error = read(&cameras[..end], &images).unwrap_err().to_string();
        assert!(
            error.contains("cameras.bin: byte ") && !error.contains('\n'),
            "{error}"
        );
    }
    for end in 0..images.len() {
        let error = read(&cameras, &images[..end]).unwrap_err().to_string();
        assert!(
            error.contains("images.bin: byte ") && !error.contains('\n'),
            "{error}"
        );
    }
    images.push(0);
    let error = read(&cameras, &images).unwrap_err().to_string();
    assert!(
        error.contains("more bytes follow than it announces"),
        "{error}"
    );
}
