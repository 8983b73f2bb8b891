//! `nullcone stereo reconstruct`: points and surfaces of scenes that are known.

use std::path::Path;

use ga_camera::format::rig::encode;
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_files::Reading;
use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::format;
use ga_runtime::cga3::{Motor, Plane as Flat, Point, Rotor, Translator};
use ga_runtime::geometry::ray::Ray;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

const SIZE: [usize; 2] = [256, 192];

/// A tilted wall, and a board in front of it that both cameras see whole.
const WALL: [[f64; 3]; 2] = [[0.0, 0.0, 2.5], [0.25, -0.1, -1.0]];
const BOARD: [[f64; 3]; 2] = [[0.0, 0.0, 1.5], [0.0, 0.2, -1.0]];

fn is_on_board(point: Point<f64>) -> bool {
    let [x, y, _] = point.coordinates();
    (-0.25..0.3).contains(&x) && (-0.3..0.2).contains(&y)
}

fn plane([point, normal]: [[f64; 3]; 2]) -> Flat<f64> {
    Flat::from_point_normal(Point::from(point), normal)
}

/// Two cameras with distorted lenses, the right one rotated a little.
fn rig() -> StereoRig {
    let lens = RadialTangential::new(&[-0.12, 0.03, 4e-4, -6e-4, 0.0]).unwrap();
    let camera = |focal: f64, column: f64, world_to_camera| Camera {
        intrinsics: Intrinsics::new([focal, 1.01 * focal], [column, 94.3])
            .unwrap()
            .with_lens(lens),
        world_to_camera,
    };
    let rotor = Rotor::from_axis_angle([0.3, 1.0, 0.2], 0.03).unwrap();
    let motor = Translator::from_displacement([-0.12, 0.004, 0.003]) * rotor;
    StereoRig {
        left: camera(221.0, 128.4, Motor::default()),
        right: camera(223.0, 126.1, motor),
    }
}

/// Random levels that are smooth between the points of a grid, from 0 to 1.
fn noise(x: f64, y: f64) -> f64 {
    let level = |column: f64, row: f64| {
        let (column, row) = (column as i64 as u32, row as i64 as u32);
        let mixed = column.wrapping_mul(2_654_435_761) ^ row.wrapping_mul(2_246_822_519);
        f64::from((mixed ^ (mixed >> 13)).wrapping_mul(3_266_489_917) >> 8) / f64::from(1 << 24)
    };
    let (column, row) = (x.floor(), y.floor());
    let (right, down) = (x - column, y - row);
    let along = |row: f64| level(column, row) * (1.0 - right) + level(column + 1.0, row) * right;
    along(row) * (1.0 - down) + along(row + 1.0) * down
}

/// What a ray sees: a grey level.
fn seen(ray: Ray<f64>) -> f64 {
    let board = ray
        .first_hit(plane(BOARD))
        .filter(|hit| is_on_board(hit.point));
    let (hit, offset) = match board {
        Some(hit) => (Some(hit), 400.0),
        None => (ray.first_hit(plane(WALL)), 0.0),
    };
    let Some(hit) = hit else { return 0.0 };
    let [x, y, _] = hit.point.coordinates();
    let octaves = [15.0, 40.0].map(|rate| noise(rate * x + offset + 500.0, rate * y + 500.0));
    0.6 * octaves[0] + 0.4 * octaves[1]
}

fn view(camera: &Camera) -> Plane<[u8; 3]> {
    Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        let ray = camera.ray([column as f64, row as f64]).unwrap();
        let level = (20.0 + 215.0 * seen(ray)) as u8;
        [level, level, 255 - level]
    })
}

/// Both views and the file of the rig.
fn scene() -> TempDir {
    let folder = tempdir().unwrap();
    let rig = rig();
    for (name, camera) in [("left.png", rig.left), ("right.png", rig.right)] {
        std::fs::write(
            folder.path().join(name),
            png::encode(&view(&camera)).unwrap(),
        )
        .unwrap();
    }
    let text = encode(&rig, Some(SIZE)).unwrap();
    std::fs::write(folder.path().join("rig.yml"), text).unwrap();
    folder
}

fn reconstruct(folder: &Path, arguments: &[&str]) -> Value {
    let begin = [
        "stereo",
        "reconstruct",
        "left.png",
        "right.png",
        "--rig",
        "rig.yml",
        "--json",
    ];
    let output = nullcone(folder, [&begin[..], arguments].concat());
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The points lie on the wall and on the board, in the frame of the left camera; few are beside.
#[test]
fn points_lie_on_the_planes_of_the_scene() {
    let folder = scene();
    let report = reconstruct(
        folder.path(),
        &["--out", "new/cloud.ply", "--axes", "camera"],
    );
    let (cloud, _) = format::read(folder.path().join("new/cloud.ply"), Reading::Tolerant).unwrap();
    assert_eq!(number(&report, "/points"), cloud.vertex_count() as f64);
    assert_eq!(number(&report, "/triangles"), 0.0);
    assert!((number(&report, "/baseline_metres") - rig().baseline()).abs() < 1e-9);
    assert!(number(&report, "/density") > 70.0, "{report}");
    let (wall, board) = (plane(WALL), plane(BOARD));
    let mut errors = Vec::new();
    let mut on_board = 0;
    for point in cloud.positions() {
        let errors_of_both = [wall, board].map(|plane| plane.distance_to(*point).unwrap());
        if is_on_board(*point) && errors_of_both[1] < errors_of_both[0] {
            on_board += 1;
            errors.push(errors_of_both[1]);
        } else {
            errors.push(errors_of_both[0]);
        }
    }
    errors.sort_unstable_by(f64::total_cmp);
    let part = |part: f64| errors[(part * errors.len() as f64) as usize];
    // A tenth of a pixel is a depth of 2 cm at the wall.
    assert!(
        part(0.5) < 0.015 && part(0.9) < 0.05,
        "{} {}",
        part(0.5),
        part(0.9)
    );
    assert!(on_board > errors.len() / 10);
}

/// The surface has the colours of the view and is cut between board and wall; glTF has y up.
#[test]
fn surfaces_are_cut_around_the_board() {
    let folder = scene();
    let arguments = [
        "--out",
        "model.glb",
        "--mode",
        "fast",
        "--max-disparity",
        "48",
    ];
    let report = reconstruct(folder.path(), &arguments);
    let (mesh, _) = format::read(folder.path().join("model.glb"), Reading::Tolerant).unwrap();
    assert_eq!(number(&report, "/triangles"), mesh.faces().len() as f64);
    assert!(mesh.faces().len() > 30_000, "{}", mesh.faces().len());
    let encoder = SrgbEncoder::new();
    for [red, green, blue, _] in mesh.colours().unwrap() {
        let light = [red, green, blue].map(|x| *x);
        let [red, green, blue] = encoder.encode(LinearColour::new(light[0], light[1], light[2]));
        // Both were rounded after the views were rectified.
        assert!(red == green && (255 - red).abs_diff(blue) <= 1);
    }
    let mut across = 0;
    for triangle in mesh.triangles() {
        let depths = triangle.map(|corner| -mesh.positions()[corner as usize].e3());
        let range = depths
            .iter()
            .fold(0.0_f64, |range, depth| range.max((depth - depths[0]).abs()));
        assert!(depths.iter().all(|depth| *depth > 0.0));
        across += usize::from(range > 0.3);
    }
    assert_eq!(across, 0);
    let report = reconstruct(
        folder.path(),
        &["--out", "t.glb", "--texture", "--step", "2"],
    );
    let (textured, _) = format::read(folder.path().join("t.glb"), Reading::Tolerant).unwrap();
    assert!(textured.texture_coordinates().is_some() && textured.colours().is_none());
    assert!(
        number(&report, "/points")
            < number(&report, "/width_px") * number(&report, "/height_px") / 4.0
    );
    let report = reconstruct(
        folder.path(),
        &["--out", "c.obj", "--cloud", "--far", "1.9"],
    );
    assert!(number(&report, "/farthest_metres") <= 1.9);
    assert_eq!(number(&report, "/triangles"), 0.0);
}

/// Views of parallel cameras with a focal length of 221 px, 10 cm apart, whose rows have these
/// disparities, with noise.
fn of_rows(disparity: impl Fn(usize) -> f64) -> TempDir {
    let folder = tempdir().unwrap();
    for (name, part, seed) in [("left.png", 0.0, 900), ("right.png", 1.0, 4000)] {
        let view = Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
            let x = column as f64 + part * disparity(row);
            let level = noise(0.35 * x + 300.0, 0.35 * row as f64 + 300.0);
            let grain = noise((column + seed) as f64, (3 * row + 5 * seed) as f64);
            [(30.0 + 170.0 * level + 30.0 * grain) as u8; 3]
        });
        std::fs::write(folder.path().join(name), png::encode(&view).unwrap()).unwrap();
    }
    let camera = "[[221, 0, 127.5], [0, 221, 95.5], [0, 0, 1]]";
    let rig = format!(
        "%YAML:1.0\n---\nM1: {camera}\nM2: {camera}\n\
         R: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nT: [[-0.1], [0], [0]]\n"
    );
    std::fs::write(folder.path().join("rig.yml"), rig).unwrap();
    folder
}

/// What one view shows further left, the other shows further right where the views are exchanged.
#[test]
fn exchanged_views_are_told() {
    for (sign, kind) in [(1.0, None), (-1.0, Some("views_exchanged"))] {
        let folder = of_rows(|row| sign * if row < 96 { 8.0 } else { 15.0 });
        let arguments = ["--out", "m.ply", "--max-disparity", "48"];
        let report = reconstruct(folder.path(), &arguments);
        assert_eq!(report["warnings"][0]["kind"].as_str(), kind, "{report}");
        let verdict = if kind.is_none() { "good" } else { "doubtful" };
        assert_eq!(report["verdict"], verdict);
    }
}

/// A wall at 40 baselines, which is a disparity of 5.5 px, and a sky whose disparities are noise
/// around 0: without a bound, the scene would be hundreds of metres deep.
#[test]
fn depths_that_noise_decides_are_not_drawn() {
    let folder = of_rows(|row| if row < 96 { 0.5 } else { 5.5 });
    let found = |more: &[&str]| reconstruct(folder.path(), &[&["--out", "m.ply"], more].concat());
    let bounded = found(&[]);
    // A quarter is 1 px: 221 · 0.1 / 1 = 22.1 m.
    assert!(number(&bounded, "/farthest_metres") <= 22.1, "{bounded}");
    assert!((number(&bounded, "/median_metres") - 22.1 / 5.5).abs() < 0.2);
    let left_out = number(&bounded, "/left_out_by_depth_deviation");
    let all = found(&["--depth-deviation", "inf"]);
    assert!(number(&all, "/farthest_metres") > 200.0, "{all}");
    assert_eq!(number(&all, "/left_out_by_depth_deviation"), 0.0);
    assert!(left_out > 1000.0);
    assert_eq!(
        number(&all, "/points"),
        number(&bounded, "/points") + left_out
    );
    let strict = found(&["--depth-deviation", "0.05"]);
    assert!(number(&strict, "/farthest_metres") <= 4.42, "{strict}");
}

/// A scene with files beside it that cannot be used with its views or its rig.
fn scene_with_faulty_files() -> TempDir {
    let folder = scene();
    let at = |name: &str| folder.path().join(name);
    let small = Plane::filled(40, 30, [90u8; 3]);
    std::fs::write(at("small.png"), png::encode(&small).unwrap()).unwrap();
    let flat = Plane::filled(SIZE[0], SIZE[1], [90u8; 3]);
    std::fs::write(at("flat.png"), png::encode(&flat).unwrap()).unwrap();
    let left = std::fs::read(at("left.png")).unwrap();
    std::fs::write(at("broken.png"), &left[..200]).unwrap();
    std::fs::write(at("broken.yml"), "%YAML:1.0\n---\nM1: [1, 2\n").unwrap();
    std::fs::write(at("half.yml"), "%YAML:1.0\n---\nwidth: 3\n").unwrap();
    let camera = "[[221, 0, 127.5], [0, 221, 95.5], [0, 0, 1]]";
    let parallel = format!(
        "%YAML:1.0\n---\nM1: {camera}\nM2: {camera}\n\
         R: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nT: [[-0.1], [0], [0]]\n"
    );
    std::fs::write(at("parallel.yml"), parallel).unwrap();
    let write = |name: &str, right: Motor<f64>, size: [usize; 2]| {
        let mut rig = rig();
        rig.right.world_to_camera = right;
        let size = Some(size);
        std::fs::write(at(name), encode(&rig, size).unwrap()).unwrap();
    };
    let right = rig().right.world_to_camera;
    write("same.yml", rig().left.world_to_camera, SIZE);
    write("large.yml", right, [640, 480]);
    write("exchanged.yml", right.reverse(), SIZE);
    let ahead = Translator::from_displacement([0.0, 0.0, -0.1]);
    write("ahead.yml", ahead.into(), SIZE);
    let half_turn = Rotor::from_axis_angle([1.0, 0.0, 0.0], std::f64::consts::PI).unwrap();
    write("behind.yml", half_turn * right, SIZE);
    folder
}

#[test]
fn bad_input_writes_nothing() {
    let folder = scene_with_faulty_files();
    let before = names(folder.path());
    for (arguments, message) in [
        ("left.png small.png --rig rig.yml", "differ in size"),
        ("small.png small.png --rig rig.yml", "256 × 192"),
        ("broken.png right.png --rig rig.yml", "broken.png"),
        ("none.png right.png --rig rig.yml", "none.png"),
        ("left.png right.png --rig none.yml", "none.yml"),
        ("left.png right.png --rig broken.yml", "line"),
        ("left.png right.png --rig half.yml", "M1"),
        ("left.png right.png --rig same.yml", "at the same place"),
        ("left.png right.png --rig large.yml", "640 × 480"),
        (
            "left.png right.png --rig exchanged.yml",
            "the views are exchanged",
        ),
        ("left.png right.png --rig ahead.yml", "before or behind it"),
        ("left.png right.png --rig behind.yml", "look too far apart"),
        // Without disparities, the rays of all pairs are parallel.
        ("left.png left.png --rig parallel.yml", "none of the 49152"),
        ("left.png right.png --rig rig.yml --out m.stl", "m.stl"),
        ("left.png right.png --rig rig.yml --near 90", "none of the"),
        (
            "left.png right.png --rig rig.yml --depth-deviation 0",
            "relative deviation of depths of 0",
        ),
        (
            "left.png right.png --rig rig.yml --out m.ply --texture",
            "the format holds no pictures; --texture needs .glb, .gltf or .obj",
        ),
    ] {
        let mut all = vec!["stereo", "reconstruct"];
        all.extend(arguments.split(' '));
        if !all.contains(&"--out") {
            all.extend(["--out", "m.glb"]);
        }
        assert_failure(&nullcone(folder.path(), &all), &[message]);
        assert_eq!(names(folder.path()), before, "{arguments}");
    }
    // What is known of the views is said before the error.
    let flat = "stereo reconstruct flat.png flat.png --rig parallel.yml --out m.glb";
    let output = nullcone(folder.path(), flat.split(' '));
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    let [warning, error] = [0, 1].map(|line| message.lines().nth(line).unwrap());
    assert!(
        warning.starts_with("warning: 0.00 % of the pixels"),
        "{message}"
    );
    assert!(error.contains("none of the 49152 pixels"), "{message}");
    assert_eq!(names(folder.path()), before);
}
