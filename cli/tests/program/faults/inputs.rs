//! Small inputs of all commands, made once.

use std::fmt::Write as _;
use std::path::Path;
use std::sync::OnceLock;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use tempfile::TempDir;

use crate::common::{assert_success, figure, nullcone};
use crate::people;

/// The folder of the inputs.
pub(super) fn folder() -> &'static Path {
    static FOLDER: OnceLock<TempDir> = OnceLock::new();
    FOLDER.get_or_init(make).path()
}

fn make() -> TempDir {
    let folder = people::inputs();
    let path = folder.path();
    figure::write(path, 4);
    tables(path);
    pictures(path);
    films(path);
    boards(path);
    for line in [
        "animate --mesh mesh.obj --rig rig.json --weights weights.json --motion motion.bvh --out figure",
        "clip compress motion.bvh --tolerance 0.01 --shell 1 --out walk.clip",
        "mesh convert cube.obj cube.ply",
        "clip convert dance.glb --out person.bvh",
        "render cube.obj --turntable 3 --size 32x32 --views views --out turn.y4m",
        "quality compare a.y4m b.y4m --frames 0..2 --part 0.json",
        "quality compare a.y4m b.y4m --frames 2..4 --part 1.json",
    ] {
        if line.starts_with("clip convert") {
            let fit = "body fit --joints joints.json --views views.json --character mannequin --out dance.glb";
            assert_success(&nullcone(path, fit.split(' ')));
        }
        assert_success(&nullcone(path, line.split(' ')));
    }
    std::fs::rename(path.join("figure/model.glb"), path.join("hero.glb")).unwrap();
    folder
}

fn tables(folder: &Path) {
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    // Each face has a quarter of the texture.
    let mut cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n".to_owned();
    for (face, [a, b, c]) in [[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]]
        .iter()
        .enumerate()
    {
        let [x, y] = [0.5 * (face % 2) as f64, 0.5 * (face / 2) as f64];
        let [right, above] = [x + 0.45, y + 0.45];
        let _ = writeln!(cube, "vt {x} {y}\nvt {right} {y}\nvt {x} {above}");
        let _ = writeln!(cube, "f {a}/-3 {b}/-2 {c}/-1");
    }
    write("cube.obj", &cube);
    write(
        "functions.txt",
        "fn f(m: Motor, p: Point) -> Point { m * p * rev(m) }\n",
    );
    write("keys.csv", "t,x\n0,0\n1,1\n2,0.5\n");
    let scene = r#"{"elements": [{"name": "S", "sphere": {"centre": [0, 0, 0], "radius": 1}}]}"#;
    write("scene.json", scene);
    write("found.json", "{\"cuts\": [10, 40, 70]}");
    write("labels.csv", "11\n40\n90\n");
    let mut scores = "objective,subjective\n".to_owned();
    for row in 0..12 {
        let x = f64::from(row) / 11.0;
        let _ = writeln!(scores, "{x},{}", 1.0 + 4.0 / (1.0 + (4.0 - 8.0 * x).exp()));
    }
    write("scores.csv", &scores);
    write(
        "ratings.csv",
        "rater,A,B,C\nr1,2,3,4\nr2,1,3,5\nr3,2,4,4\nr4,2,3,5\n",
    );
    let mut points = String::new();
    for frame in 0..3 {
        let places = [[1, 1, 1], [9, 0, 1], [0, 9, 2], [3, 3, 9], [5, frame, 4]];
        let fields = places.map(|[x, y, z]| {
            let z = 0.01 * f64::from(z) + 0.1 * f64::from(frame);
            format!("{},{},{z}", 0.01 * f64::from(x), 0.01 * f64::from(y))
        });
        points += &(fields.join(",") + "\n");
    }
    write("points.csv", &points);
    let k = "[ [ 200, 0, 119.5 ], [ 0, 200, 89.5 ], [ 0, 0, 1 ] ]";
    let size = "%YAML:1.0\n---\nimage_width: 240\nimage_height: 180\n";
    write("camera.yml", &format!("{size}K: {k}\n"));
    let pose = "R: [ [ 1, 0, 0 ], [ 0, 1, 0 ], [ 0, 0, 1 ] ]\nT: [ -0.1, 0, 0 ]\n";
    write("rig.yml", &format!("{size}M1: {k}\nM2: {k}\n{pose}"));
}

/// Blocks of random grey of three pixels.
fn grey(column: usize, row: usize) -> u8 {
    let hash = (column / 3 * 7919 + row / 3 * 104_729 + 17) * 2_654_435_761 % 4_294_967_296;
    (hash >> 12) as u8
}

fn pictures(folder: &Path) {
    let write = |name: &str, picture: &Plane<u8>| {
        ga_image::file::write(folder.join(name), picture).unwrap();
    };
    for (side, shift) in [("left", 0), ("right", 4)] {
        let view = Plane::from_fn(48, 32, |u, v| grey(u + shift, v));
        write(&format!("small-{side}.png"), &view);
        // Large blocks and small ones at three depths, so that the views show more than a plane.
        let view = Plane::from_fn(240, 180, |u, v| {
            let [u, v] = [u + shift * (1 + v / 60), v];
            grey(u * 3 / 7, v * 3 / 7) / 2 + grey(u * 3 / 19, v * 3 / 19) / 2
        });
        write(&format!("{side}.png"), &view);
    }
    let blob = |u: usize, v: usize| match (5..14).contains(&u) && (5..14).contains(&v) {
        true => 220,
        false => 30,
    };
    write("blob.png", &Plane::from_fn(24, 20, blob));
    for name in ["d.pfm", "truth.pfm"] {
        let map = Plane::from_fn(6, 4, |u, v| 1.0 + (u + v) as f32);
        ga_image::file::write(folder.join(name), &map).unwrap();
    }
}

fn films(folder: &Path) {
    let write = |name: &str, [width, height]: [usize; 2], shift: usize| {
        let frames = (0..4).map(|frame| {
            Plane::from_fn(width, height, |u, v| {
                [grey(u + frame + shift, v) / 2 + 40; 3]
            })
        });
        y4m::write(folder.join(name), frames, Film::default()).unwrap();
    };
    write("a.y4m", [32, 24], 0);
    write("b.y4m", [32, 24], 1);
    write("left.y4m", [160, 96], 0);
    write("right.y4m", [160, 96], 3);
}

/// A board of 6 × 5 squares of 0.1 m with a border, as two cameras 0.1 m apart see it. Rays of
/// several places of a pixel are averaged, as a lens does.
fn boards(folder: &Path) {
    const PARTS: usize = 3;
    const ANGLES: [[f64; 2]; 4] = [[0.3, 0.1], [-0.3, 0.25], [0.1, -0.4], [-0.2, -0.25]];
    for (view, [x, y]) in ANGLES.into_iter().enumerate() {
        let ([sx, cx], [sy, cy]) = ([x.sin(), x.cos()], [y.sin(), y.cos()]);
        // The axes of the board in the camera, and its middle.
        let axes = [
            [cy, sx * sy, -cx * sy],
            [0.0, cx, sx],
            [sy, -sx * cy, cx * cy],
        ];
        for (name, right) in [("left", 0.0), ("right", 0.1)] {
            let middle = [
                0.04 * (view as f64 - 1.5) - right,
                0.02 * (1.5 - view as f64),
                1.1,
            ];
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let level = |u: f64, v: f64| {
                let ray = [(u - 119.5) / 260.0, (v - 89.5) / 260.0, 1.0];
                let scale = dot(axes[2], middle) / dot(axes[2], ray);
                let place: [f64; 3] = std::array::from_fn(|k| scale * ray[k] - middle[k]);
                let [a, b] = [
                    dot(axes[0], place) / 0.1 + 3.0,
                    dot(axes[1], place) / 0.1 + 2.5,
                ];
                let is_inside = (0.0..6.0).contains(&a) && (0.0..5.0).contains(&b);
                match is_inside && (a.floor() + b.floor()) % 2.0 == 0.0 {
                    true => 30.0,
                    false => 220.0,
                }
            };
            let picture = Plane::from_fn(240, 180, |column, row| {
                let parts = (0..PARTS * PARTS).map(|part| {
                    let [i, j] =
                        [part % PARTS, part / PARTS].map(|k| (k as f64 + 0.5) / PARTS as f64 - 0.5);
                    level(column as f64 + i, row as f64 + j)
                });
                (parts.sum::<f64>() / (PARTS * PARTS) as f64) as u8
            });
            ga_image::file::write(folder.join(format!("{name}{view}.png")), &picture).unwrap();
        }
    }
}
