//! Rectification against OpenCV, against its own definition, and against points that are known.

use ga_camera::rig::StereoRig;
use ga_camera::rig::{RectifiedRig, RigError};
use ga_camera::{Intrinsics, RadialTangential};
use ga_image::plane::Plane;
use ga_runtime::cga3::Point;
use ga_vision::ViewGeometryError;
use ga_vision::rectification::{Rectification, RectificationOptions, Undistortion};
use serde_json::Value;

use nullcone_shared_data::json::{matrix, numbers};
use nullcone_shared_data::shared;

fn truth() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/rectification.json");
    let text = std::fs::read_to_string(path).expect("the data is committed");
    serde_json::from_str(&text).expect("JSON")
}

fn distorted(k: &Value, d: &Value) -> Intrinsics {
    let coefficients: Vec<f64> = d
        .as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect();
    let lens = RadialTangential::new(&coefficients).unwrap();
    Intrinsics::from_matrix(matrix(k)).unwrap().with_lens(lens)
}

fn compare_rotations(found: &Rectification, record: &Value) {
    for (motor, key) in [(found.left.motor, "R1"), (found.right.motor, "R2")] {
        let (own, expected) = (motor.rotor().to_matrix(), matrix(&record[key]));
        for (a, b) in own.iter().flatten().zip(expected.iter().flatten()) {
            assert!((a - b).abs() < 1e-12, "{key}: {own:?} {expected:?}");
        }
    }
}

/// Focal lengths and principal points, and entries 0,3 of P2 and 3,3 of Q.
fn compare_cameras(found: &Rectification, record: &Value, tolerance: f64) {
    let close = |a: f64, b: f64| {
        assert!(
            (a - b).abs() < tolerance * (1.0 + b.abs()),
            "{a} {b} {record}"
        );
    };
    for (camera, key) in [(found.rig.left(), "P1"), (found.rig.right(), "P2")] {
        let entry = |row: usize, column: usize| record[key][row][column].as_f64().unwrap();
        close(camera.focal()[0], entry(0, 0));
        close(camera.focal()[1], entry(1, 1));
        close(camera.principal()[0], entry(0, 2));
        close(camera.principal()[1], entry(1, 2));
    }
    let shifted = record["P2"][0][3].as_f64().unwrap();
    close(-found.rig.baseline() * found.rig.left().focal()[0], shifted);
    let q = record["Q"][3][3].as_f64().unwrap();
    close(found.rig.disparity_offset() / found.rig.baseline(), q);
}

#[test]
fn rigs_of_the_oracle_are_rectified_alike() {
    for record in truth()["rigs"].as_array().unwrap() {
        let camera = |key: &str| Intrinsics::from_matrix(matrix(&record[key])).unwrap();
        let (rotation, translation) = (matrix(&record["R"]), numbers(&record["t"]));
        let rig = StereoRig::from_matrices(camera("K1"), camera("K2"), rotation, translation);
        let rig = rig.unwrap();
        let cases = &record["stereoRectify_zero_disparity_640x480"];
        for (key, alpha) in [("-1", None), ("0", Some(0.0))] {
            let options = RectificationOptions {
                alpha,
                ..RectificationOptions::default()
            };
            let found = Rectification::new(&rig, [640, 480], options).unwrap();
            compare_rotations(&found, &cases[key]);
            // OpenCV computes the corners in single precision.
            compare_cameras(&found, &cases[key], 1e-6);
        }
    }
}

fn distorted_rig(truth: &Value) -> StereoRig {
    let record = &truth["rectify"];
    StereoRig::from_matrices(
        distorted(&truth["K"], &record["D1"]),
        distorted(&record["K2"], &record["D2"]),
        matrix(&record["R"]),
        numbers(&record["T"]),
    )
    .unwrap()
}

#[test]
fn every_choice_of_picture_is_that_of_opencv() {
    let truth = truth();
    let rig = distorted_rig(&truth);
    let cases = truth["rectify"]["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 16);
    for case in cases {
        let alpha = case["alpha"].as_f64().unwrap();
        let size = numbers::<2>(&case["size"]).map(|x| x as usize);
        let options = RectificationOptions {
            zero_disparity: case["zero_disparity"].as_bool().unwrap(),
            alpha: (alpha >= 0.0).then_some(alpha),
            size: (size != [0, 0]).then_some(size),
        };
        let found = Rectification::new(&rig, [640, 480], options).unwrap();
        compare_rotations(&found, case);
        let truth = &case["converged"];
        let close = |a: f64, b: &Value| assert!((a - b.as_f64().unwrap()).abs() < 1e-7, "{a} {b}");
        for (camera, key) in [(found.rig.left(), "left"), (found.rig.right(), "right")] {
            close(camera.focal()[0], &truth["focal"]);
            close(camera.focal()[1], &truth["focal"]);
            close(camera.principal()[0], &truth[key][0]);
            close(camera.principal()[1], &truth[key][1]);
        }
        for (own, key) in found.valid.iter().zip(["roi1", "roi2"]) {
            let expected = numbers::<4>(&case[key]);
            let own = [own.left, own.top, own.width, own.height];
            for (a, b) in own.into_iter().zip(expected) {
                assert!((a as f64 - b).abs() <= 1.0, "{own:?} {expected:?}");
            }
        }
    }
}

#[test]
fn the_map_is_that_of_opencv() {
    let truth = truth();
    let options = RectificationOptions::default();
    let found = Rectification::new(&distorted_rig(&truth), [640, 480], options).unwrap();
    // A picture whose samples are their own places shows the map.
    let places = Plane::from_fn(640, 480, |column, row| [column as f32, row as f32]);
    let mapped = found.left_map().warped(&places, [-1.0; 2]).unwrap();
    let mut compared = 0;
    for row in truth["map_of_first_case"].as_array().unwrap() {
        let [column, line, x, y] = numbers::<4>(row);
        if !(0.0..=639.0).contains(&x) || !(0.0..=479.0).contains(&y) {
            continue;
        }
        let [u, v] = mapped.get(column as usize, line as usize).unwrap();
        assert!((f64::from(u) - x).abs() < 1e-3 && (f64::from(v) - y).abs() < 1e-3);
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn undistorted_pictures_are_those_of_opencv() {
    let truth = truth();
    let camera = distorted(&truth["K"], &truth["rectify"]["D1"]);
    for case in truth["optimal_new_camera_matrix"].as_array().unwrap() {
        let alpha = case["alpha"].as_f64();
        let found = Undistortion::new(camera, [640, 480], alpha).unwrap();
        let expected = numbers::<4>(&case["converged"]);
        let ([fx, fy], [cx, cy]) = (found.target.focal(), found.target.principal());
        for (a, b) in [fx, fy, cx, cy].into_iter().zip(expected) {
            assert!((a - b).abs() < 1e-7, "{:?} {expected:?}", found.target);
        }
    }
    // What the camera sees of a point is where the pinhole sees it.
    let found = Undistortion::new(camera, [640, 480], None).unwrap();
    let map = found.map();
    let places = Plane::from_fn(640, 480, |column, row| [column as f32, row as f32]);
    let mapped = map.warped(&places, [-1.0; 2]).unwrap();
    let point = Point::new(-0.3, 0.2, 1.0);
    let [u, v] = found.target.project(point).unwrap();
    let expected = camera.project(point).unwrap();
    let [x, y] = mapped.get(u.round() as usize, v.round() as usize).unwrap();
    assert!((f64::from(x) - expected[0]).abs() < 1.0 && (f64::from(y) - expected[1]).abs() < 1.0);
}

#[test]
fn depths_of_the_oracle() {
    let Some(path) = nullcone_shared_data::shared("oracle/vision/seed1/truth.json") else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let truth: Value = serde_json::from_str(&text).unwrap();
    let record = &truth["disparity_depth"];
    let number = |key: &str| record["calib"][key].as_f64().unwrap();
    let focal = [number("f"); 2];
    let left = Intrinsics::new(focal, [number("cx"), number("cy")]).unwrap();
    let right = Intrinsics::new(focal, [number("cx") + number("doffs"), number("cy")]).unwrap();
    let rig = RectifiedRig::new(left, right, 1e-3 * number("baseline_mm")).unwrap();
    let rows = record["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 100);
    for row in rows {
        let number = |key: &str| row[key].as_f64().unwrap();
        let found = rig.point([number("x"), number("y")], number("d")).unwrap();
        let expected = Point::new(number("X"), number("Y"), number("Z")).coordinates();
        for (a, b) in found.coordinates().into_iter().zip(expected) {
            assert!((1e3 * a - b).abs() < 1e-9 * number("Z"), "{a} {b}");
        }
    }
}

fn camera() -> Intrinsics {
    Intrinsics::new([500.0, 500.0], [320.0, 240.0]).unwrap()
}

#[test]
fn rigs_that_cannot_be_rectified() {
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let rectify = |translation, size, options| {
        let rig = StereoRig::from_matrices(camera(), camera(), identity, translation).unwrap();
        Rectification::new(&rig, size, options).unwrap_err()
    };
    let (size, options) = ([640, 480], RectificationOptions::default());
    assert_eq!(
        rectify([0.0; 3], size, options),
        ViewGeometryError::Baseline(0.0)
    );
    for t in [[0.0, 0.0, 0.2], [0.0, 0.01, -0.2]] {
        let forward = rectify(t, size, options);
        assert!(matches!(forward, ViewGeometryError::Forward([_, _, z]) if z == -t[2]));
    }
    let exchanged = rectify([0.2, 0.0, 0.0], size, options);
    assert!(matches!(exchanged, ViewGeometryError::Exchanged([x, ..]) if x == -0.2));
    let side = [-0.2, 0.0, 0.0];
    assert_eq!(
        rectify(side, [640, 1], options),
        ViewGeometryError::Size([640, 1])
    );
    // The maps of such pictures would have 64 GiB.
    let large = RectificationOptions {
        size: Some([65_535, 65_535]),
        ..options
    };
    assert_eq!(
        rectify(side, size, large),
        ViewGeometryError::Size([65_535, 65_535])
    );
    for alpha in [-0.1, 1.1, f64::NAN] {
        let options = RectificationOptions {
            alpha: Some(alpha),
            ..options
        };
        assert!(matches!(
            rectify(side, size, options),
            ViewGeometryError::Alpha(_)
        ));
    }
    // Cameras that look to opposite sides.
    let back = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
    let rig = StereoRig::from_matrices(camera(), camera(), back, [-0.2, 0.0, 0.0]).unwrap();
    assert!(Rectification::new(&rig, size, options).is_err());
}

#[test]
fn rigs_that_are_not_rectified() {
    let other = Intrinsics::new([501.0, 500.0], [320.0, 240.0]).unwrap();
    assert!(matches!(
        RectifiedRig::new(camera(), other, 0.1),
        Err(RigError::Focal { .. })
    ));
    let lower = Intrinsics::new([500.0, 500.0], [320.0, 241.0]).unwrap();
    assert!(matches!(
        RectifiedRig::new(camera(), lower, 0.1),
        Err(RigError::Rows {
            left: 240.0,
            right: 241.0
        })
    ));
    for baseline in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let refused = RectifiedRig::new(camera(), camera(), baseline);
        assert!(matches!(refused, Err(RigError::Baseline(_))));
    }
    let lens = RadialTangential::new(&[0.1, 0.0, 0.0, 0.0]).unwrap();
    assert!(matches!(
        RectifiedRig::new(camera(), camera().with_lens(lens), 0.1),
        Err(RigError::Lens { view: "right" })
    ));
    let rig = RectifiedRig::new(camera(), camera(), 0.1).unwrap();
    for disparity in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        assert_eq!(rig.depth(disparity), None, "{disparity}");
        assert_eq!(rig.point([1.0, 2.0], disparity), None);
    }
    assert_eq!(rig.disparity(-1.0), None);
    assert_eq!(
        Undistortion::new(camera(), [0, 5], None),
        Err(ViewGeometryError::UndistortionSize([0, 5]))
    );
    assert!(matches!(
        Undistortion::new(camera(), [64, 48], Some(2.0)),
        Err(ViewGeometryError::Alpha(2.0))
    ));
}

/// The corners of a wide fisheye's picture look nearly across its axis.
#[test]
fn wide_fisheyes_are_centred_as_by_opencv() {
    let Some(path) = shared("cases/vision/rectify-wide-principal/rig.yml") else {
        return;
    };
    let rig = ga_camera::format::read(path)
        .unwrap()
        .named_rig(&[])
        .unwrap()
        .rig;
    // By cv2.fisheye.stereoRectify of OpenCV 5.0.0 with balance 0, whose focal length is 270.29 px:
    // principal points without and with equal columns, from the middle of the picture. Its sides
    // are half a pixel farther out there, where a pixel is an eightieth wide.
    for (zero_disparity, columns) in [
        (false, [368.31, 285.80].map(|x: f64| (x - 320.0) / 270.29)),
        (true, [(327.05 - 320.0) / 270.29; 2]),
    ] {
        let options = RectificationOptions {
            zero_disparity,
            ..RectificationOptions::default()
        };
        let found = Rectification::new(&rig, [640, 480], options).unwrap();
        for (camera, column) in [found.rig.left(), found.rig.right()]
            .into_iter()
            .zip(columns)
        {
            let ([fx, fy], [cx, cy]) = (camera.focal(), camera.principal());
            assert!(((cx - 319.5) / fx - column).abs() < 5e-3, "{cx} {column}");
            assert!(((cy - 239.5) / fy + 0.0024).abs() < 5e-3, "{cy}");
        }
    }
}
