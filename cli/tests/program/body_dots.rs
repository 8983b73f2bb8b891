//! `nullcone body paint` and `body dots`: films of a character with dots on its skin, and back to
//! its motion.

use std::path::Path;

use ga_anim::character::Character;
use ga_anim::gltf::Player;
use ga_anim::motion_file::{Format, WriteOptions, Written};
use ga_anim::pose::Pose;
use ga_anim::recording::Recording;
use ga_character::Figure;
use ga_files::table::Table;
use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use ga_mannequin::{Human, skeleton, walk};
use ga_runtime::cga3::Point;
use ga_video::Frame;
use serde_json::{Value, json};
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, json, names, nullcone, number, text};

const FRAMES: usize = 8;
const RATE: f64 = 25.0;
const SIZE: [usize; 2] = [720, 640];
/// The figure is in the middle of what the cameras see.
const MIDDLE: [f64; 3] = [0.0, 0.9, 0.0];

/// A part of a stride as BVH.
fn write_walk(path: &Path) {
    let walk = walk(1);
    let poses = (0..FRAMES).map(|frame| walk.sample(0.2 + frame as f64 / RATE));
    let clip = ga_anim::clip::Clip::new(1.0 / RATE, poses.collect()).unwrap();
    let recording = Recording::from_clip(&skeleton(), &clip).unwrap();
    let options = WriteOptions::default();
    let written = Written::new(&recording, Format::Bvh, &options, |_, _| ()).unwrap();
    std::fs::write(path, written.encode().unwrap()).unwrap();
}

/// A camera that looks from a direction at the middle, with y up: 0 from the front, in radians.
fn camera(name: &str, angle: f64) -> Value {
    let (sin, cos) = angle.sin_cos();
    let eye = [MIDDLE[0] + 4.0 * sin, MIDDLE[1], MIDDLE[2] + 4.0 * cos];
    let rotation = [[cos, 0.0, -sin], [0.0, -1.0, 0.0], [-sin, 0.0, -cos]];
    let translation = rotation.map(|row| -(0..3).map(|k| row[k] * eye[k]).sum::<f64>());
    let [width, height] = SIZE;
    let principal = SIZE.map(|side| 0.5 * (side as f64 - 1.0));
    let lens = json!({"width": width, "height": height, "fx": 1000, "fy": 1000,
        "cx": principal[0], "cy": principal[1]});
    json!({"picture": format!("{name}.png"), "camera": lens,
        "rotation": rotation, "translation": translation})
}

/// Where the joints of a glTF file are in a frame, by their names.
fn joints(path: &Path, names: &[&str]) -> Vec<Vec<Point<f64>>> {
    let document = ga_mesh::gltf::read(path).unwrap();
    let player = Player::new(&document).unwrap();
    let nodes = names.iter().map(|name| {
        let is_named = |node: &ga_mesh::gltf::Node| node.name.as_deref() == Some(*name);
        document.nodes.iter().position(is_named).unwrap()
    });
    let nodes: Vec<usize> = nodes.collect();
    let frames = (0..FRAMES).map(|frame| {
        let pose = player.pose(Some(0), frame as f64 / RATE).unwrap();
        let place = |node: &usize| pose.world[*node].transform(Point::default());
        nodes.iter().map(place).collect()
    });
    frames.collect()
}

/// The pixel where a camera of `views.json` shows a point.
fn pixel(camera: &Value, point: Point<f64>) -> [f64; 2] {
    let at = |path: String| number(camera, &path);
    let point = point.coordinates();
    let [x, y, z] = [0, 1, 2].map(|row| {
        let turned = (0..3).map(|k| at(format!("/rotation/{row}/{k}")) * point[k]);
        turned.sum::<f64>() + at(format!("/translation/{row}"))
    });
    let [u, v] = [x / z, y / z].map(|part| 1000.0 * part);
    [u + at("/camera/cx".into()), v + at("/camera/cy".into())]
}

fn succeeds(folder: &Path, arguments: &[&str]) {
    assert_success(&nullcone(folder, arguments));
}

/// Films the dotted character as it walks, by two cameras a metre apart.
fn film_walk(path: &Path) -> [Value; 2] {
    write_walk(&path.join("walk.bvh"));
    let cameras = [camera("left", -0.125), camera("right", 0.125)];
    let views = json!({"views": &cameras}).to_string();
    std::fs::write(path.join("views.json"), views).unwrap();
    let retarget = ["clip", "retarget", "walk.bvh", "--target", "dotted.glb"];
    succeeds(path, &[&retarget[..], &["--out", "walking.glb"]].concat());
    for view in ["left", "right"] {
        let film = format!("{view}.y4m");
        let render = ["render", "walking.glb", "--camera", "views.json", "--view"];
        succeeds(path, &[&render[..], &[view, "--film", &film]].concat());
    }
    cameras
}

const DOTS: [&str; 6] = [
    "body",
    "dots",
    "left.y4m",
    "right.y4m",
    "--views",
    "views.json",
];

/// The way of the mannequin, of a character of a file, whose dots are discs on its skin.
#[test]
fn another_character_is_found_again_by_its_dots() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let write = |name: &str, character: Character| {
        let figure = Figure::new("own", character);
        let joints = figure.character.skeleton.len();
        let rest = ga_anim::clip::Clip::new(1.0, vec![Pose::rest(joints)]).unwrap();
        let (glb, _) = ga_character::gltf::encode(&figure, &rest, "rest").unwrap();
        std::fs::write(path.join(name), glb).unwrap();
    };
    let human = Character::from(Human::new());
    write("own.glb", human.clone());
    write("doll.glb", human.clone().scaled(0.1).unwrap());
    write("giant.glb", human.scaled(100.0).unwrap());

    let own = ["--character", "own.glb"];
    let paint = ["body", "paint", "--out", "dotted.glb"];
    let painted = json(path, &[&paint[..], &own].concat());
    assert_eq!(painted["character"], "own");
    assert!(number(&painted, "/dots") > 300.0);
    film_walk(path);
    let found = json(path, &[&DOTS[..], &own, &["--out", "joints.json"]].concat());
    assert_eq!(found["verdict"], "good", "{}", found["warnings"]);
    let names: Vec<&str> = found["joints"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(Value::as_str)
        .collect();
    let truth = joints(&path.join("walking.glb"), &names);
    let people = [
        "people",
        "--joints",
        "joints.json",
        "--views",
        "views.json",
        "--up",
        "y",
    ];
    let out = ["--floor", "0", "--out", "person"];
    json(path, &[&people[..], &own, &out].concat());
    let error = mpjpe(&path.join("person/joints.csv"), &names, &truth);
    assert!(error < 0.01, "{error} m");

    // The dots of the mannequin are in other places.
    let mannequin = [&DOTS[..], &["--out", "no.json"]].concat();
    assert_failure(&nullcone(path, mannequin), &["not recognised"]);
    std::fs::write(path.join("bare.gltf"), r#"{"asset": {"version": "2.0"}}"#).unwrap();
    for (file, part) in [
        ("doll.glb", "room for"),
        ("giant.glb", "175.0 m"),
        ("bare.gltf", "skin"),
        ("none.glb", "No such file"),
    ] {
        let paint = ["body", "paint", "--out", "no.glb", "--character", file];
        assert_failure(&nullcone(path, paint), &[file, part]);
        let dots = [&DOTS[..], &["--out", "no.json", "--character", file]].concat();
        assert_failure(&nullcone(path, dots), &[file, part]);
    }
}

#[test]
fn films_of_dots_become_the_motion_again() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let painted = json(path, &["body", "paint", "--out", "dotted.glb"]);
    assert!(number(&painted, "/dots") > 400.0);
    let cameras = film_walk(path);
    let dots = [&DOTS[..], &["--out", "joints.json"]].concat();
    let found = json(path, &dots);
    assert_eq!(found["verdict"], "good", "{}", found["warnings"]);
    assert_eq!(found["frames"], FRAMES);
    assert_eq!(found["frames_per_second"], RATE);
    assert_eq!(found["frames_without_joints"], 0);

    let file: Value =
        serde_json::from_slice(&std::fs::read(path.join("joints.json")).unwrap()).unwrap();
    assert_eq!(file["frames_per_second"], RATE);
    let all: Vec<&str> = file["joints"]
        .as_array()
        .unwrap()
        .iter()
        .map(|n| n.as_str().unwrap())
        .collect();
    let truth = joints(&path.join("walking.glb"), &all);
    pixels_are_near_the_joints(&file, &cameras, &truth);

    let people = ["people", "left.y4m", "right.y4m", "--joints", "joints.json"];
    let world = ["--views", "views.json", "--up", "y", "--floor", "0"];
    let out = ["--no-overlay", "--out", "person"];
    json(path, &[&people[..], &world, &out].concat());
    let error = mpjpe(&path.join("person/joints.csv"), &all, &truth);
    assert!(error < 0.01, "{error} m");

    // One thread finds the same.
    let one = ["--out", "one.json"];
    let mut program = crate::common::program(path);
    program
        .env("RAYON_NUM_THREADS", "1")
        .args(&dots[..dots.len() - 2])
        .args(one);
    assert_success(&program.output().unwrap());
    let [one, several] =
        ["one.json", "joints.json"].map(|name| std::fs::read(path.join(name)).unwrap());
    assert!(one == several);
    other_films(path);
}

/// Each view has nearly all joints in all frames, near to where the camera shows the true ones.
fn pixels_are_near_the_joints(file: &Value, cameras: &[Value], truth: &[Vec<Point<f64>>]) {
    for (index, camera) in cameras.iter().enumerate() {
        let (frames, mut count) = (file["views"][index]["frames"].as_array().unwrap(), 0);
        assert_eq!(frames.len(), FRAMES);
        for (frame, truth) in frames.iter().zip(truth) {
            let joints = frame.as_array().unwrap().iter().zip(truth);
            for (joint, truth) in joints.filter(|(joint, _)| !joint.is_null()) {
                count += 1;
                let expected = pixel(camera, *truth);
                let [u, v] = [0, 1].map(|k| number(joint, &format!("/{k}")) - expected[k]);
                assert!(u.hypot(v) < 4.0, "{joint} {expected:?}");
                let deviation = number(joint, "/2");
                assert!((0.01..4.0).contains(&deviation), "{joint}");
            }
        }
        assert!(10 * count >= 9 * FRAMES * truth[0].len(), "{count}");
    }
}

/// The mean distance of joints of a table from true ones, in metres.
fn mpjpe(path: &Path, names: &[&str], truth: &[Vec<Point<f64>>]) -> f64 {
    let csv = std::fs::read(path).unwrap();
    let csv = Table::with_names(&csv).unwrap();
    assert_eq!(csv.len(), truth.len());
    let mut sum = 0.0;
    for (frame, truth) in truth.iter().enumerate() {
        for (name, truth) in names.iter().zip(truth) {
            let place = ["x", "y", "z"].map(|axis| {
                let column = csv.column(&format!("{name}_{axis}")).unwrap();
                csv.number(frame, column).unwrap().unwrap()
            });
            sum += truth.distance(Point::from(place));
        }
    }
    sum / (truth.len() * names.len()) as f64
}

fn frames(path: &Path) -> Vec<Plane<[u8; 3]>> {
    let mut source = ga_video::open(path).unwrap();
    let (mut frame, mut all) = (Frame::default(), Vec::new());
    while source.read(&mut frame).unwrap() {
        all.push(frame.to_rgb(source.properties().colours));
    }
    all
}

/// Films in which the body is not always seen, or that do not fit together.
fn other_films(path: &Path) {
    let wall = Plane::filled(SIZE[0], SIZE[1], [90; 3]);
    let write = |name: &str, pictures: &[&Plane<[u8; 3]>]| {
        let pictures = pictures.iter().map(|picture| (*picture).clone());
        y4m::write(path.join(name), pictures, Film::default()).unwrap();
    };
    let [left, right] = ["left.y4m", "right.y4m"].map(|name| frames(&path.join(name)));
    write("gap-left.y4m", &[&wall, &wall, &left[0]]);
    write("gap-right.y4m", &[&wall, &right[1], &right[0], &right[1]]);
    write("wall.y4m", &[&wall]);
    write("bare.y4m", &[&wall]);
    let square = Plane::filled(64, 64, [90; 3]);
    write("square.y4m", &[&square]);
    let arguments = |films: [&'static str; 2], out: &'static str| {
        let views = ["--views", "views.json", "--out", out];
        [&["body", "dots"], &films[..], &views].concat()
    };

    let gap = arguments(["gap-left.y4m", "gap-right.y4m"], "gap.json");
    let output = nullcone(path, gap.iter().chain(&["--json", "--check"]));
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["verdict"], "failed");
    assert_eq!(found["frames"], 3);
    assert_eq!(found["frames_without_joints"], 2);
    let [first, second] = [0, 1].map(|index| found["warnings"][index].clone());
    assert_eq!(first["kind"], "not_recognised");
    assert_eq!([&first["frame"], &first["count"]], [0, 2]);
    let message = first["message"].as_str().unwrap();
    assert!(
        message.contains("the view gap-left shows no dots"),
        "{message}"
    );
    assert_eq!(second["kind"], "film_length");
    assert_eq!(second["view"], "gap-left");
    assert_eq!(second["frame"], 3);
    let file: Value =
        serde_json::from_slice(&std::fs::read(path.join("gap.json")).unwrap()).unwrap();
    let is_seen = |frame: usize| {
        let joints = file["views"][1]["frames"][frame].as_array().unwrap();
        joints.iter().any(|joint| !joint.is_null())
    };
    assert_eq!([0, 1, 2].map(is_seen), [false, false, true]);

    let before = names(path);
    let fails = |films: [&'static str; 2], parts: &[&str]| {
        assert_failure(&nullcone(path, arguments(films, "no.json")), parts);
        assert_eq!(names(path), before);
    };
    fails(["wall.y4m", "wall.y4m"], &["wall.y4m", "twice"]);
    fails(
        ["wall.y4m", "bare.y4m"],
        &["not recognised", "the view wall shows no dots"],
    );
    fails(
        ["square.y4m", "wall.y4m"],
        &["square.y4m", "64 × 64", "720 × 640"],
    );
    fails(["none.y4m", "left.y4m"], &["none.y4m", "No such file"]);
    let one = [
        "body",
        "dots",
        "left.y4m",
        "--views",
        "views.json",
        "--out",
        "no.json",
    ];
    assert_failure(&nullcone(path, one), &["left.y4m", "two views"]);
    assert_eq!(names(path), before);
}
