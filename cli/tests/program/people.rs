//! `nullcone people`: the mannequin walks in front of three cameras and their films.

use std::path::Path;
use std::process::Output;

use ga_files::table::Table;
use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use ga_video::Frame;
use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

use crate::body_fit::{FRAMES, JOINTS, PLACE, RATE, in_views, seen_by, truth, views};
use crate::common::{assert_failure, assert_success, json, names, nullcone, number, text};

/// The size of the films, and of the pictures for which the cameras are.
const SIZE: [usize; 2] = [64, 36];
const CAMERA_SIZE: [f64; 2] = [1920.0, 1080.0];
/// The names of the views, of which the last has no film of its own.
const VIEWS: [&str; 3] = ["front", "left side", "back/top"];
/// Darker than everything that is drawn.
const WALL: [u8; 3] = [20, 40, 20];

/// Joints of three views, their cameras, and a film of a bare wall.
pub(crate) fn inputs() -> TempDir {
    let folder = tempdir().unwrap();
    let cameras = views(folder.path());
    let joints = in_views(&cameras, &VIEWS, 1.0, 0.05);
    std::fs::write(folder.path().join("joints.json"), joints).unwrap();
    write_film(&folder.path().join("wall.y4m"), FRAMES, SIZE);
    folder
}

fn write_film(path: &Path, frames: usize, size: [usize; 2]) {
    write_film_at(path, frames, size, RATE as u32);
}

fn write_film_at(path: &Path, frames: usize, [width, height]: [usize; 2], rate: u32) {
    let film = Film {
        frames_per_second: [rate, 1],
        ..Film::default()
    };
    let wall = Plane::filled(width, height, WALL);
    y4m::write(path, (0..frames).map(|_| wall.clone()), film).unwrap();
}

/// The arguments for films with these names, into `out`. Where the floor is and which way is up are
/// given, so that joints are where the truth has them.
fn arguments<'a>(films: &'a [&'a str], more: &'a [&'a str]) -> Vec<&'a str> {
    let given = ["--joints", "joints.json", "--views", "views.json"];
    let ground = ["--up", "y", "--floor", "-0.9", "--out", "out"];
    [&["people"], films, &given, &ground, more].concat()
}

pub(crate) fn people(folder: &Path, films: &[&str], more: &[&str]) -> Output {
    nullcone(folder, arguments(films, more))
}

/// The kinds of warnings of a report, each with the view that it names, without those of feet: the
/// ankle of the walk rolls over its foot.
fn kinds(report: &Value) -> Vec<(String, Value)> {
    let warnings = report["warnings"].as_array().unwrap().iter();
    let kind = |warning: &Value| warning["kind"].as_str().unwrap().to_owned();
    warnings
        .filter(|warning| warning["kind"] != "sliding_foot")
        .map(|warning| (kind(warning), warning["view"].clone()))
        .collect()
}

fn frames(path: &Path) -> Vec<Plane<[u8; 3]>> {
    let mut source = ga_video::open(path).unwrap();
    let (mut frame, mut all) = (Frame::default(), Vec::new());
    while source.read(&mut frame).unwrap() {
        all.push(frame.to_rgb(source.properties().colours));
    }
    all
}

/// The ending of films with the body over them.
const ENDING: &str = match cfg!(feature = "mp4") {
    true => "mp4",
    false => "y4m",
};

#[test]
fn films_become_a_character_files_and_a_report() {
    let folder = inputs();
    let path = folder.path();
    let films = ["wall.y4m", "wall.y4m", "wall.y4m"];
    let found = json(path, &arguments(&films, &[]));
    let overlays = ["back_top", "front", "left_side"];
    let overlays = overlays.map(|view| format!("overlay-{view}.{ENDING}"));
    let mut expected = [
        &["character.glb", "joints.csv", "joints.trc", "motion.bvh"].map(str::to_owned)[..],
        &overlays,
        &["report.html", "report.json"].map(str::to_owned),
    ]
    .concat();
    assert_eq!(names(&path.join("out")), expected);
    let mut files: Vec<&str> = found["files"]
        .as_array()
        .unwrap()
        .iter()
        .map(|file| file.as_str().unwrap().strip_prefix("out/").unwrap())
        .collect();
    files.sort_unstable();
    expected.sort();
    assert_eq!(files, expected);
    let kept: Value =
        serde_json::from_slice(&std::fs::read(path.join("out/report.json")).unwrap()).unwrap();
    assert_eq!(kept, found);

    assert_eq!(kinds(&found), []);
    assert_eq!(found["frames"], FRAMES);
    assert_eq!(found["frames_per_second"], RATE);
    assert_eq!(found["up"], json!([0.0, 1.0, 0.0]));
    assert_eq!(found["floor"], -0.9);
    for (index, name) in VIEWS.iter().enumerate() {
        let view = &found["views"][index];
        assert_eq!(view["name"], *name);
        assert_eq!(view["joints_seen"], FRAMES * JOINTS.len());
        assert!(number(view, "/reprojection_median_px") < 0.2);
        assert!(number(view, "/rotation_degrees") < 0.1);
        assert_eq!(view["frames_with_exchanged_sides"], json!([]));
        assert_eq!(view["film"], "wall.y4m");
    }
    let bones = found["bones"].as_array().unwrap();
    let bone = bones.iter().find(|bone| bone["joint"] == "LeftFoot");
    let [knee, ankle] = ["LeftLowerLeg", "LeftFoot"].map(|name| place(name, 0));
    let shin = distance(knee, ankle);
    let found_shin = number(bone.unwrap(), "/length_metres");
    assert!((found_shin - shin).abs() < 0.004, "{found_shin} {shin}");

    joints_are_where_the_walk_has_them(path);
    for (view, camera) in [("front", 0), ("left_side", 1), ("back_top", 2)] {
        let drawn = frames(&path.join(format!("out/overlay-{view}.{ENDING}")));
        assert_eq!(drawn.len(), FRAMES);
        let camera = views(path)[camera];
        bodies_are_over_the_wall(&drawn, &camera);
    }
    let motion = json(path, &["clip", "info", "out/motion.bvh"]);
    assert_eq!(motion["frames"], FRAMES);
    let page = std::fs::read_to_string(path.join("out/report.html")).unwrap();
    for part in ["The result is", "left side", "LeftFoot", "people wall.y4m"] {
        assert!(page.contains(part), "{part}");
    }
    // Three films with a picture for each frame.
    assert_eq!(page.matches("data:image/jpeg").count(), 3 * FRAMES);
}

fn place(joint: &str, frame: usize) -> [f64; 3] {
    truth()[frame][JOINTS.iter().position(|name| *name == joint).unwrap()]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}

/// The tables have the places of the truth, above the floor.
fn joints_are_where_the_walk_has_them(path: &Path) {
    let csv = std::fs::read(path.join("out/joints.csv")).unwrap();
    let csv = Table::with_names(&csv).unwrap();
    assert_eq!(csv.len(), FRAMES);
    let column = |name: &str| csv.column(name).unwrap();
    let value = |row: usize, column: usize| csv.number(row, column).unwrap().unwrap();
    for (frame, truth) in truth().iter().enumerate() {
        assert_eq!(value(frame, column("frame")), frame as f64);
        let time = value(frame, column("time_seconds"));
        assert!((time - frame as f64 / RATE).abs() < 1e-12);
        for (name, [x, y, z]) in JOINTS.iter().zip(truth) {
            let found = ["x", "y", "z"].map(|axis| value(frame, column(&format!("{name}_{axis}"))));
            let error = distance(found, [*x, y - PLACE[1], *z]);
            assert!(error < 0.005, "{name} in frame {frame}: {error} m");
        }
    }

    let trc = std::fs::read(path.join("out/joints.trc")).unwrap();
    let rows: Vec<Vec<&str>> = text(&trc)
        .lines()
        .map(|line| line.split('\t').collect())
        .collect();
    let (markers, rate) = ((csv.names().len() - 2) / 3, RATE.to_string());
    assert_eq!(rows[0], ["PathFileType", "4", "(X/Y/Z)", "joints.trc"]);
    assert_eq!(rows[1][2..5], ["NumFrames", "NumMarkers", "Units"]);
    let (frames, markers) = (FRAMES.to_string(), markers.to_string());
    assert_eq!(
        rows[2],
        [&rate, &rate, &frames, &markers, "mm", &rate, "1", &frames]
    );
    assert_eq!(rows[3][..3], ["Frame#", "Time", "Hips"]);
    assert_eq!(rows[4][2..6], ["X1", "Y1", "Z1", "X2"]);
    for (frame, cells) in rows[5..].iter().enumerate() {
        let numbers: Vec<f64> = cells.iter().map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(numbers.len(), csv.names().len());
        assert_eq!(numbers[0], (frame + 1) as f64);
        assert!((numbers[1] - value(frame, 1)).abs() < 1e-12);
        for (column, millimetres) in numbers.iter().enumerate().skip(2) {
            assert!((millimetres - 1e3 * value(frame, column)).abs() < 1e-6);
        }
    }
    assert_eq!(rows.len(), 5 + FRAMES);
}

/// Where the camera sees the chest, a picture is not the wall; in the corners it is.
fn bodies_are_over_the_wall(drawn: &[Plane<[u8; 3]>], camera: &[[f64; 4]; 3]) {
    let differs = |picture: &Plane<[u8; 3]>, column: usize, row: usize| {
        let pixel = picture.get(column, row).unwrap();
        pixel.iter().zip(WALL).any(|(a, b)| a.abs_diff(b) > 40)
    };
    for (frame, picture) in drawn.iter().enumerate() {
        assert_eq!([picture.width(), picture.height()], SIZE);
        let seen = seen_by(camera, place("Chest", frame));
        let [column, row] = [0, 1].map(|k| {
            let place = (seen[k] + 0.5) * SIZE[k] as f64 / CAMERA_SIZE[k];
            place as usize
        });
        assert!(differs(picture, column, row), "frame {frame}: {seen:?}");
        for (column, row) in [(1, 1), (SIZE[0] - 2, 1), (1, SIZE[1] - 2)] {
            assert!(!differs(picture, column, row), "frame {frame}");
        }
    }
}

#[test]
fn what_films_lack_is_said() {
    let folder = inputs();
    let path = folder.path();
    write_film(&path.join("short.y4m"), FRAMES - 3, SIZE);
    write_film(&path.join("square.y4m"), FRAMES, [40, 40]);
    let output = people(path, &["short.y4m", "square.y4m"], &["--json", "--check"]);
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["verdict"], "doubtful");
    let expected = [
        ("film_length", "front"),
        ("film_size", "left side"),
        ("no_film", "back/top"),
    ];
    let expected = expected.map(|(kind, view)| (kind.to_owned(), json!(view)));
    assert_eq!(kinds(&found), expected);
    let mut warnings = found["warnings"].as_array().unwrap().iter();
    let length = warnings.find(|warning| warning["kind"] == "film_length");
    assert_eq!(length.unwrap()["file"], "short.y4m");
    let drawn = frames(&path.join(format!("out/overlay-front.{ENDING}")));
    assert_eq!(drawn.len(), FRAMES - 3);
    assert_eq!(found["views"][2]["film"], Value::Null);

    // Without films there are no overlays, and nothing is wrong.
    let output = people(path, &[], &["--report", "page.html"]);
    assert_success(&output);
    assert!(text(&output.stdout).contains("none were given"));
    let page = std::fs::read(path.join("page.html")).unwrap();
    assert!(text(&page).contains("no films were given"));
    assert_eq!(page, std::fs::read(path.join("out/report.html")).unwrap());

    // The page of the folder may be asked for by its name, however that is written.
    let output = people(path, &[], &["--report", "./out/report.html"]);
    assert_success(&output);
    let page = std::fs::read(path.join("out/report.html")).unwrap();
    assert!(text(&page).contains("no films were given"));
    // The film of the first run is not of this one.
    let warnings = text(&output.stderr);
    let left_side = format!("overlay-left_side.{ENDING}");
    for part in ["of an earlier run", &left_side, "overlay-front"] {
        assert!(warnings.contains(part), "{warnings}");
    }
    let output = people(path, &["wall.y4m"], &["--json"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let warnings = found["warnings"].as_array().unwrap().iter();
    let earlier: Vec<&Value> = warnings
        .filter(|warning| warning["kind"] == "earlier_films")
        .collect();
    assert_eq!(earlier.len(), 1);
    let message = earlier[0]["message"].as_str().unwrap();
    assert!(message.contains(&left_side) && !message.contains("overlay-front"));
    assert!(path.join("out").join(left_side).exists());
}

/// The joints of `joints.json`, changed by a function, in another file.
fn changed(folder: &Path, name: &str, change: impl FnOnce(&mut Value)) {
    let joints = std::fs::read_to_string(folder.join("joints.json")).unwrap();
    let mut joints: Value = serde_json::from_str(&joints).unwrap();
    change(&mut joints);
    std::fs::write(folder.join(name), joints.to_string()).unwrap();
}

#[test]
fn a_film_of_another_rate_and_a_view_of_somebody_else_are_named() {
    let folder = inputs();
    let path = folder.path();
    write_film_at(&path.join("fast.y4m"), FRAMES, SIZE, 2 * RATE as u32);
    // In one view the detector followed a person who stands beside.
    changed(path, "other.json", |joints| {
        for joint in joints["views"][1]["frames"].as_array_mut().unwrap() {
            for pixel in joint.as_array_mut().unwrap() {
                pixel[0] = json!(pixel[0].as_f64().unwrap() - 300.0);
            }
        }
    });
    let given = [
        "people",
        "fast.y4m",
        "--joints",
        "other.json",
        "--views",
        "views.json",
    ];
    let more = ["--no-overlay", "--out", "out", "--json", "--check"];
    let output = nullcone(path, [&given[..], &more].concat());
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["verdict"], "doubtful");
    let kinds = kinds(&found);
    for (kind, view) in [("bad_view", "left side"), ("film_rate", "front")] {
        let expected = (kind.to_owned(), json!(view));
        assert!(kinds.contains(&expected), "{kind}: {kinds:?}");
    }
}

/// A detector's joints have no rate, but the film has.
#[test]
fn the_rate_is_that_of_the_film_where_the_joints_have_none() {
    let folder = inputs();
    let path = folder.path();
    changed(path, "joints.json", |joints| {
        joints.as_object_mut().unwrap().remove("frames_per_second");
    });
    let found = json(path, &arguments(&["wall.y4m"], &["--no-overlay"]));
    assert_eq!(found["frames_per_second"], RATE);
    let names = names(&path.join("out"));
    assert!(
        !names.iter().any(|name| name.starts_with("overlay")),
        "{names:?}"
    );
}

#[test]
fn nothing_is_written_after_an_error() {
    let folder = inputs();
    let path = folder.path();
    let fails = |films: &[&str], more: &[&str], parts: &[&str]| {
        assert_failure(&people(path, films, more), parts);
        assert!(!path.join("out").exists(), "{films:?} {more:?}");
    };
    fails(&["wall.y4m"; 4], &[], &["wall.y4m", "4 films", "3 views"]);
    fails(&["none.y4m"], &[], &["none.y4m", "No such file"]);
    fails(&["joints.json"], &[], &["joints.json", "not a video"]);
    fails(&[], &["--fps", "0"], &["--fps 0"]);
    fails(&[], &["--deviation", "-1"], &["--deviation -1"]);
    std::fs::write(path.join("empty.y4m"), "YUV4MPEG2 W64 H36 F25:1 C444\n").unwrap();
    fails(&["empty.y4m"], &[], &["empty.y4m", "no frames"]);
    let of = |joints: &str, parts: &[&str]| {
        let given = [
            "people",
            "--joints",
            joints,
            "--views",
            "views.json",
            "--out",
            "out",
        ];
        assert_failure(&nullcone(path, given), parts);
        assert!(!path.join("out").exists(), "{joints}");
    };
    changed(path, "shorter.json", |joints| {
        joints["views"][2]["frames"].as_array_mut().unwrap().pop();
    });
    of(
        "shorter.json",
        &["shorter.json", "\"back/top\"", "19 frames"],
    );
    changed(path, "more.json", |joints| {
        let mut other = joints["views"][0].clone();
        other["name"] = json!("other");
        joints["views"].as_array_mut().unwrap().push(other);
    });
    of("more.json", &["views.json", "4 views", "3 cameras"]);
    // The film breaks off, which is seen before anything is fitted.
    let film = std::fs::read(path.join("wall.y4m")).unwrap();
    std::fs::write(path.join("cut.y4m"), &film[..film.len() - 9]).unwrap();
    fails(&["cut.y4m"], &[], &["cut.y4m", "ends within frame 19"]);
    // Its second picture is of another size, which is seen while the film is drawn.
    std::fs::create_dir(path.join("pictures")).unwrap();
    for (number, side) in [(0, 20), (1, 21)] {
        let picture = Plane::filled(side, side, WALL);
        let file = path.join(format!("pictures/{number}.png"));
        ga_image::file::write(file, &picture).unwrap();
    }
    fails(&["pictures"], &[], &["1.png", "21 × 21"]);
    for wrong in ["--up=w", "--up=0,0,0"] {
        let output = people(path, &[], &[wrong]);
        assert_eq!(output.status.code(), Some(2), "{wrong}");
    }
    // A folder that is read is not written into.
    let out = ["--out", "pictures"];
    let output = nullcone(path, {
        let given = [
            "people",
            "pictures",
            "--joints",
            "joints.json",
            "--views",
            "views.json",
        ];
        [&given[..], &out].concat()
    });
    assert_failure(&output, &["pictures", "the folder"]);
}
