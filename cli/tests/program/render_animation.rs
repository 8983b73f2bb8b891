//! `nullcone render` of animated models: where they are in pictures and films, by closed forms.

use std::path::Path;

use ga_image::plane::Plane;
use ga_mesh::gltf::{
    self, Animation, CameraElement, Channel, Document, Interpolation, Keys, MaterialElement, Mesh,
    MorphTarget, Node, Primitive, Projection, Scene, Transform,
};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, names, nullcone, program, text};

/// 65 × 65 pixels at distance 4: u = 80 x/4 + 32 and v = −80 y/4 + 32, so a unit is 20 pixels.
const CAMERA: &str = r#"{"width": 65, "height": 65, "fx": 80, "fy": 80, "cx": 32, "cy": 32,
    "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 4]}"#;

/// Half of the side of the square.
const HALF: f32 = 0.24;

fn moved(node: usize, keys: Keys) -> Channel {
    Channel {
        node,
        times: vec![0.0, 2.0],
        interpolation: Interpolation::Linear,
        keys,
        extras: None,
    }
}

/// A white square, at x = t/2 − 1/2 at the time t, whose upper edge a morph target raises by t/2;
/// a camera that sees it as [`CAMERA`] does at first and moves by t/2; and a square that is not in
/// the scene.
fn document() -> Document {
    let square = Primitive {
        positions: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| [x * HALF, y * HALF, 0.0])
            .to_vec(),
        indices: Some(vec![0, 1, 2, 0, 2, 3]),
        targets: vec![MorphTarget {
            positions: vec![[0.0; 3], [0.0; 3], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            ..MorphTarget::default()
        }],
        material: Some(0),
        ..Primitive::default()
    };
    let place = |translation| Transform::Decomposed {
        translation,
        rotation: [0.0, 0.0, 0.0, 1.0],
        scale: [1.0; 3],
    };
    let camera = CameraElement {
        name: Some("lens".to_owned()),
        projection: Projection::Perspective {
            aspect_ratio: Some(0.5),
            vertical_angle: 2.0 * (65.0f32 / 160.0).atan(),
            near: 0.1,
            far: None,
        },
        extras: None,
    };
    let go = |name: &str, channels| Animation {
        name: Some(name.to_owned()),
        channels,
        ..Animation::default()
    };
    Document {
        scene: Some(0),
        scenes: vec![Scene {
            nodes: vec![0, 1],
            ..Scene::default()
        }],
        nodes: vec![
            Node {
                mesh: Some(0),
                ..Node::default()
            },
            Node {
                name: Some("tripod".to_owned()),
                camera: Some(0),
                transform: place([0.0, 0.0, 4.0]),
                ..Node::default()
            },
            Node {
                mesh: Some(0),
                transform: place([-1.0, -1.0, 0.0]),
                ..Node::default()
            },
        ],
        meshes: vec![Mesh {
            primitives: vec![square],
            ..Mesh::default()
        }],
        materials: vec![MaterialElement {
            unlit: true,
            double_sided: true,
            ..MaterialElement::default()
        }],
        cameras: vec![camera],
        animations: vec![
            go("still", vec![moved(0, Keys::Weights(vec![0.0, 0.0]))]),
            go(
                "go",
                vec![
                    moved(
                        0,
                        Keys::Translation(vec![[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]),
                    ),
                    moved(0, Keys::Weights(vec![0.0, 1.0])),
                    moved(1, Keys::Translation(vec![[0.0, 0.0, 4.0], [1.0, 0.0, 4.0]])),
                ],
            ),
        ],
        ..Document::default()
    }
}

/// A folder with the model as `square.glb`, whose animation `go` takes two seconds, and the camera.
pub(crate) fn folder() -> TempDir {
    let folder = tempdir().unwrap();
    gltf::write(folder.path().join("square.glb"), &document()).unwrap();
    std::fs::write(folder.path().join("camera.json"), CAMERA).unwrap();
    folder
}

/// Runs the command in black with one sample for each pixel.
#[track_caller]
fn render(folder: &Path, arguments: &str) {
    let arguments = format!("render square.glb --samples 1 --background 000000 {arguments}");
    assert_success(&nullcone(folder, arguments.split_whitespace()));
}

/// The frames of a film.
fn frames(folder: &Path, name: &str) -> Vec<Plane<[u8; 3]>> {
    let bytes = std::fs::read(folder.join(name)).unwrap();
    let film = ga_image::y4m::Reader::new(&bytes).unwrap();
    let colours = film.film().colours;
    film.map(|frame| frame.unwrap().to_rgb(colours)).collect()
}

/// The least and the greatest column and row that are not black, all pixels between which are not.
#[track_caller]
fn seen(picture: &Plane<[u8; 3]>) -> [[usize; 2]; 2] {
    let (width, height) = (picture.width(), picture.height());
    let places = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
    let white = places.filter(|&[column, row]| picture.get(column, row).unwrap()[1] > 128);
    let white: Vec<[usize; 2]> = white.collect();
    let range = |axis: usize| {
        let values = || white.iter().map(|place| place[axis]);
        [values().min().unwrap(), values().max().unwrap()]
    };
    let [columns, rows] = [range(0), range(1)];
    let area = (columns[1] + 1 - columns[0]) * (rows[1] + 1 - rows[0]);
    assert_eq!(white.len(), area, "{columns:?} {rows:?}");
    [columns, rows]
}

/// The columns and rows of the square at a time, seen from x = `eye`.
fn known(time: f64, eye: f64) -> [[usize; 2]; 2] {
    let half = f64::from(HALF);
    let (middle, upper) = (time / 2.0 - 0.5 - eye, half + time / 2.0);
    // The middles of pixels are at whole numbers.
    let within = |low: f64, high: f64| [low.ceil() as usize, high.floor() as usize];
    let columns = within(32.0 + 20.0 * (middle - half), 32.0 + 20.0 * (middle + half));
    [columns, within(32.0 - 20.0 * upper, 32.0 + 20.0 * half)]
}

#[test]
fn a_moving_square_is_where_the_closed_form_has_it() {
    let folder = folder();
    let folder = folder.path();
    for animation in ["go", "1"] {
        for time in [0.0, 0.3, 1.0, 1.7, 2.0] {
            let out = format!("--animation {animation} --time {time} --out p.png");
            render(folder, &format!("--camera camera.json {out}"));
            let picture = ga_image::file::read(folder.join("p.png")).unwrap();
            assert_eq!(seen(&picture.to_rgb()), known(time, 0.0), "{time}");
            // The camera of the document moves with the time.
            for node in ["tripod", "lens", "1"] {
                render(folder, &format!("--camera-node {node} --size 65x65 {out}"));
                let picture = ga_image::file::read(folder.join("p.png")).unwrap();
                assert_eq!(seen(&picture.to_rgb()), known(time, time / 2.0), "{time}");
            }
        }
    }
    // Without an animation the nodes stand; the first animation is the default of a time.
    let at_rest = [[28, 36], [28, 36]];
    for more in [
        "",
        "--animation rest",
        "--time 1",
        "--animation still --time 9",
    ] {
        render(folder, &format!("--camera camera.json {more} --out p.png"));
        let picture = ga_image::file::read(folder.join("p.png")).unwrap();
        assert_eq!(seen(&picture.to_rgb()), at_rest, "{more}");
    }
    // A camera states the form of its picture.
    render(folder, "--camera-node tripod --out p.png");
    let picture = ga_image::file::read(folder.join("p.png")).unwrap();
    assert_eq!([picture.width(), picture.height()], [360, 720]);
}

#[test]
fn a_film_has_the_pictures_of_its_times() {
    let folder = folder();
    let folder = folder.path();
    let camera = "--camera camera.json --animation go";
    render(folder, &format!("{camera} --film film.y4m --rate 2"));
    let film = std::fs::read(folder.join("film.y4m")).unwrap();
    assert!(film.starts_with(b"YUV4MPEG2 W65 H65 F2:1 "));
    let film = frames(folder, "film.y4m");
    assert_eq!(film.len(), 5);
    for (number, frame) in film.iter().enumerate() {
        let time = number as f64 / 2.0;
        assert_eq!(seen(frame), known(time, 0.0));
        render(folder, &format!("{camera} --time {time} --out still.y4m"));
        assert_eq!(*frame, frames(folder, "still.y4m")[0]);
    }
    let moving = "--camera-node tripod --size 65x65 --animation go";
    render(
        folder,
        &format!("{moving} --film moving.y4m --rate 10 --from 0.5 --to 1.2"),
    );
    let film = frames(folder, "moving.y4m");
    assert_eq!(film.len(), 8);
    for (number, frame) in film.iter().enumerate() {
        let time = 0.5 + number as f64 / 10.0;
        assert_eq!(seen(frame)[0], known(time, time / 2.0)[0]);
    }
    render(folder, &format!("{camera} --film film.png --rate 4"));
    let bytes = std::fs::read(folder.join("film.png")).unwrap();
    let chunks = |name: &[u8]| bytes.windows(4).filter(|window| *window == name).count();
    assert_eq!((chunks(b"acTL"), chunks(b"fcTL")), (1, 9));
}

#[test]
fn a_camera_at_a_side_sees_the_whole_film() {
    let folder = folder();
    let folder = folder.path();
    let film = "--animation go --size 64x48 --camera front --film film.y4m --camera-out c.json";
    render(folder, film);
    let film = frames(folder, "film.y4m");
    assert_eq!(film.len(), 51);
    let ends = [&film[0], &film[50]].map(seen);
    // The whole film is 1.48 wide and high; 48 rows without the border of 8 % hold that.
    assert_eq!(ends, [[[10, 23], [32, 45]], [[40, 53], [2, 45]]]);
    for frame in &film {
        let [columns, rows] = seen(frame);
        assert!(columns[0] > 0 && columns[1] < 63 && rows[0] > 0 && rows[1] < 47);
    }
    // The camera that was written sees the same.
    render(
        folder,
        "--animation go --time 2 --camera c.json --out last.y4m",
    );
    assert_eq!(frames(folder, "last.y4m")[0], film[50]);
}

#[test]
fn a_film_is_the_same_on_any_number_of_threads() {
    let folder = folder();
    for threads in ["1", "3"] {
        let film = format!("{threads}.y4m");
        let mut command = program(folder.path());
        command.env("RAYON_NUM_THREADS", threads);
        command.args("render square.glb --animation go --size 80x60 --ground".split(' '));
        assert_success(
            &command
                .args(["--rate", "4", "--film", &film])
                .output()
                .unwrap(),
        );
    }
    let [one, three] =
        ["1.y4m", "3.y4m"].map(|name| std::fs::read(folder.path().join(name)).unwrap());
    assert!(one == three);
}

#[test]
fn what_was_drawn_is_said() {
    let folder = folder();
    let film = "render square.glb --animation go --size 40x30 --rate 2 --film f.png";
    let film: Vec<&str> = film.split(' ').collect();
    let report = json(folder.path(), &film);
    for (key, value) in [
        ("out", "f.png".into()),
        ("pictures", 5.into()),
        ("animation", 1.into()),
        ("animation_name", "go".into()),
        ("time_seconds", 0.0.into()),
        ("duration_seconds", 2.0.into()),
        ("frames_per_second", serde_json::Value::from(2.0)),
    ] {
        assert_eq!(report[key], value, "{key}");
    }
    let output = nullcone(folder.path(), &film);
    let said = text(&output.stdout);
    assert!(
        said.contains("5 pictures of animation 1 (go), 2 in a second"),
        "{said}"
    );
    // A time beyond the animation has the pose of its end, and is warned of.
    let late = "render square.glb --animation go --time 3 --size 40x30 --out p.png";
    let late: Vec<&str> = late.split(' ').collect();
    let report = json(folder.path(), &late);
    assert_eq!(report["warnings"][0]["kind"], "time_out_of_range");
    let warning = report["warnings"][0]["message"].as_str().unwrap();
    assert!(warning.contains("from 0 to 2 s"), "{warning}");
    assert_eq!(
        json(folder.path(), &film)["warnings"],
        serde_json::json!([])
    );
}

#[test]
fn what_cannot_be_drawn_is_named() {
    let folder = folder();
    let folder = folder.path();
    std::fs::write(
        folder.join("corner.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .unwrap();
    let mut parallel = document();
    parallel.animations.clear();
    parallel.cameras[0].projection = Projection::Orthographic {
        half_width: 1.0,
        half_height: 1.0,
        near: 0.1,
        far: 9.0,
    };
    gltf::write(folder.join("parallel.glb"), &parallel).unwrap();
    std::fs::write(folder.join("film.y4m"), "earlier").unwrap();
    let before = names(folder);
    for (arguments, parts) in [
        (
            "square.glb --animation 2 --film film.y4m",
            &["there is no animation 2", "0 (still), 1 (go)"][..],
        ),
        ("square.glb --animation run --out p.png", &["animation run"]),
        ("square.glb --time inf --out p.png", &["--time inf"]),
        ("square.glb --film film.y4m --rate 0", &["--rate 0"]),
        ("square.glb --film film.y4m --rate nan", &["--rate NaN"]),
        ("square.glb --film film.y4m --to inf", &["--to inf"]),
        (
            "square.glb --film film.y4m --from 1 --to 0.5",
            &["--from 1", "--to 0.5"],
        ),
        (
            "square.glb --film film.y4m --from 3",
            &["--from 3", "ends at 2 s"],
        ),
        ("square.glb --film film.y4m --to 1e9", &["100000 pictures"]),
        (
            "square.glb --film film.gif",
            &["film.gif", ".png, .y4m or .mp4"],
        ),
        (
            "square.glb --film film.y4m --animation rest",
            &["no animation"],
        ),
        (
            "square.glb --camera-node eye --out p.png",
            &["eye", "1 (tripod)"],
        ),
        (
            "square.glb --camera-node 0 --out p.png",
            &["0", "1 (tripod)"],
        ),
        (
            "corner.obj --camera-node 0 --out p.png",
            &["corner.obj", "glTF"],
        ),
        ("corner.obj --time 1 --out p.png", &["corner.obj", "glTF"]),
        (
            "parallel.glb --film film.y4m",
            &["parallel.glb", "no animation"],
        ),
        (
            "parallel.glb --camera-node 1 --out p.png",
            &["node 1", "parallel projection"],
        ),
    ] {
        let arguments = format!("render {arguments}");
        assert_failure(&nullcone(folder, arguments.split(' ')), parts);
        assert_eq!(names(folder), before, "{arguments}");
    }
    assert_eq!(std::fs::read(folder.join("film.y4m")).unwrap(), b"earlier");
}
