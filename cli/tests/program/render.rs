//! `nullcone render`: what it writes, and how it tells what is wrong.

use std::path::Path;

use image::{Rgb, RgbImage};
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// A square of side 2 around the origin that faces +z, red on its left half.
const SQUARE: &str = "mtllib square.mtl\n\
    v -1 -1 0\nv 0 -1 0\nv 1 -1 0\nv -1 1 0\nv 0 1 0\nv 1 1 0\n\
    vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
    usemtl red\nf 1/1 2/2 5/3 4/4\nusemtl painted\nf 2/1 3/2 6/3 5/4\n";

const MATERIALS: &str = "newmtl red\nKd 1 0 0\nnewmtl painted\nKd 1 1 1\nmap_Kd paint.png\n";

/// 65 × 65 pixels at distance 4: u = 80 x/4 + 32 and v = −80 y/4 + 32, so a unit is 20 pixels.
const CAMERA: &str = r#"{"width": 65, "height": 65, "fx": 80, "fy": 80, "cx": 32, "cy": 32,
    "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 4]}"#;

/// A folder with the square, a picture that is green above and blue below, and the camera.
fn prepare(folder: &Path) {
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("square.mtl"), MATERIALS).unwrap();
    std::fs::write(folder.join("camera.json"), CAMERA).unwrap();
    let paint = |_, row| [Rgb([0, 255, 0]), Rgb([0, 0, 255])][usize::from(row >= 8u32)];
    RgbImage::from_fn(16, 16, paint)
        .save(folder.join("paint.png"))
        .unwrap();
}

#[test]
fn a_textured_square_is_where_its_camera_puts_it() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    let arguments = "render square.obj --camera camera.json --out p/p.png --shading unlit \
                     --samples 1 --background 000000 --buffers numbers";
    let output = nullcone(folder.path(), arguments.split_whitespace());
    assert_success(&output);
    assert!(text(&output.stdout).starts_with("wrote p/p.png (65 × 65, 4 triangles, "));
    let picture = image::open(folder.path().join("p/p.png"))
        .unwrap()
        .to_rgb8();
    assert_eq!(picture.dimensions(), (65, 65));
    let colour = |column, row| picture.get_pixel(column, row).0;
    assert_eq!(colour(14, 32), [255, 0, 0]);
    assert_eq!(colour(30, 50), [255, 0, 0]);
    assert_eq!(colour(34, 14), [0, 255, 0]);
    assert_eq!(colour(50, 50), [0, 0, 255]);
    for outside in [[10, 32], [54, 32], [32, 10], [32, 54]] {
        assert_eq!(colour(outside[0], outside[1]), [0; 3]);
    }

    let numbers = folder.path().join("numbers");
    assert_eq!(
        names(&numbers),
        [
            "depth.pfm",
            "distance.pfm",
            "identity.png",
            "material.png",
            "normal.pfm",
            "uv.pfm"
        ]
    );
    // PFM: a header of three lines, then rows from the bottom.
    let floats = |name: &str, channels: usize| {
        let bytes = std::fs::read(numbers.join(name)).unwrap();
        let data = bytes[bytes.len() - 65 * 65 * channels * 4..].to_vec();
        move |column: usize, row: usize, channel: usize| {
            let at = 4 * (((64 - row) * 65 + column) * channels + channel);
            f32::from_le_bytes(data[at..at + 4].try_into().unwrap())
        }
    };
    let (depth, distance) = (floats("depth.pfm", 1), floats("distance.pfm", 1));
    assert_eq!(depth(20, 20, 0), 4.0);
    assert_eq!(depth(5, 5, 0), f32::INFINITY);
    let away = (4f32 * 4.0 + 0.6 * 0.6 * 2.0).sqrt();
    assert!((distance(20, 20, 0) - away).abs() < 1e-6);
    // (44, 20) sees (0.6, 0.6): u = 0.6 on the right half, v = 0.8.
    let uv = floats("uv.pfm", 3);
    let here = [0, 1, 2].map(|channel| uv(44, 20, channel));
    assert!((here[0] - 0.6).abs() < 1e-6 && (here[1] - 0.8).abs() < 1e-6 && here[2] == 1.0);
    let identity = image::open(numbers.join("identity.png"))
        .unwrap()
        .to_rgb16();
    assert_eq!(identity.get_pixel(44, 46).0, [1, 0, 3]);
    assert_eq!(identity.get_pixel(3, 3).0, [0; 3]);
    let material = image::open(numbers.join("material.png"))
        .unwrap()
        .to_luma16();
    assert_eq!(material.get_pixel(20, 20).0, [1]);
    assert_eq!(material.get_pixel(44, 20).0, [2]);
}

#[test]
fn views_show_the_whole_model() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    for (camera, wide) in [
        ("front", true),
        ("three-quarter", true),
        ("eye 0,0,4 target 0,0,0 fov 40", true),
        ("eye 0,4,0.01 target 0,0,0 up 0,0,-1 fov 40", false),
    ] {
        let arguments = ["render", "square.obj", "--camera", camera];
        let more = "--size 80x60 --out p.png --background #000000 -q";
        let output = nullcone(
            folder.path(),
            arguments.into_iter().chain(more.split_whitespace()),
        );
        assert_success(&output);
        assert!(output.stdout.is_empty());
        let picture = image::open(folder.path().join("p.png")).unwrap().to_rgb8();
        assert_eq!(picture.dimensions(), (80, 60));
        let seen = picture.pixels().filter(|pixel| pixel.0 != [0; 3]).count();
        assert_eq!(seen > 1000, wide, "{camera}: {seen}");
        let border = |column, row| picture.get_pixel(column, row).0 == [0; 3];
        assert!((0..80).all(|column| border(column, 0)), "{camera}");
    }
}

#[test]
fn a_picture_that_is_missing_is_named() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    std::fs::remove_file(folder.path().join("paint.png")).unwrap();
    let output = nullcone(folder.path(), ["render", "square.obj", "--out", "p.png"]);
    assert_success(&output);
    let warning = text(&output.stderr);
    assert!(
        warning.contains("painted") && warning.contains("paint.png"),
        "{warning}"
    );
    std::fs::write(folder.path().join("paint.png"), "no picture").unwrap();
    let output = nullcone(folder.path(), ["render", "square.obj", "--out", "q.png"]);
    assert_failure(&output, &["square.obj", "painted", "paint.png"]);
    assert!(!folder.path().join("q.png").exists());
}

#[test]
fn a_turntable_sees_both_sides() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    for out in ["turn.png", "turn.y4m"] {
        let arguments = "render square.obj --camera front --size 40x40 --turntable 4 \
                         --shading unlit --background 000000 --out";
        let arguments = arguments.split_whitespace().chain([out]);
        assert_success(&nullcone(folder.path(), arguments));
    }
    let bytes = std::fs::read(folder.path().join("turn.png")).unwrap();
    let chunks = |name: &[u8]| bytes.windows(4).filter(|window| *window == name).count();
    assert_eq!((chunks(b"acTL"), chunks(b"fcTL")), (1, 4));

    let bytes = std::fs::read(folder.path().join("turn.y4m")).unwrap();
    let film = ga_image::y4m::Reader::new(&bytes).unwrap();
    let colours = film.film().colours;
    let frames: Vec<_> = film.map(|frame| frame.unwrap().to_rgb(colours)).collect();
    assert_eq!(frames.len(), 4);
    // The red half is on the left from the front, on the right from behind; from the sides the
    // square is a line.
    let red = |frame: usize, column| {
        let [red, green, blue] = frames[frame].get(column, 20).unwrap();
        red > 200 && green < 60 && blue < 60
    };
    assert!(red(0, 10) && !red(0, 30) && !red(2, 10) && red(2, 30));
    assert!([1, 3].iter().all(|&side| !red(side, 10) && !red(side, 30)));
}

/// The number of pixels of a picture that are not black.
fn drawn(folder: &Path, arguments: &str) -> usize {
    let arguments = format!("render {arguments} --background 000000 --size 40x40 --out drawn.png");
    assert_success(&nullcone(folder, arguments.split_whitespace()));
    let picture = image::open(folder.join("drawn.png")).unwrap().to_rgb8();
    picture.pixels().filter(|pixel| pixel.0 != [0; 3]).count()
}

#[test]
fn lines_and_points_alone_are_drawn() {
    let folder = tempdir().unwrap();
    let line = "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\n";
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    write("line.obj", format!("{line}l 1 2\n"));
    write("points.obj", format!("{line}p 1 2 3\n"));
    // Two pixels wide and about 37 long; discs of five pixels.
    let line = drawn(folder.path(), "line.obj --camera front");
    assert!((70..140).contains(&line), "{line}");
    let points = drawn(folder.path(), "points.obj --camera front");
    assert!((45..110).contains(&points), "{points}");
}

#[test]
fn the_backs_of_gltf_faces_are_seen_if_they_have_two_sides() {
    let folder = tempdir().unwrap();
    let square = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let square = ga_mesh::obj::decode(square).unwrap();
    for (double_sided, back) in [(false, 0), (true, 1)] {
        let material = ga_mesh::Material {
            double_sided,
            ..ga_mesh::Material::named("paper")
        };
        let mesh = square.clone().with_materials(vec![material], vec![Some(0)]);
        let mesh = mesh.unwrap();
        ga_mesh::format::write(folder.path().join("a.glb"), &mesh, &Default::default()).unwrap();
        ga_mesh::format::write(folder.path().join("a.obj"), &mesh, &Default::default()).unwrap();
        // The second of two pictures of a turntable is that from behind.
        for (model, seen) in [("a.glb", [1, back]), ("a.obj", [1, 1])] {
            let arguments = format!(
                "render {model} --camera front --turntable 2 --size 40x40 --shading unlit \
                 --background 000000 --out turn.y4m"
            );
            assert_success(&nullcone(folder.path(), arguments.split_whitespace()));
            let bytes = std::fs::read(folder.path().join("turn.y4m")).unwrap();
            let film = ga_image::y4m::Reader::new(&bytes).unwrap();
            let colours = film.film().colours;
            for (frame, seen) in film.zip(seen) {
                let picture = frame.unwrap().to_rgb(colours);
                let bright = picture.get(20, 20).unwrap()[0] > 200;
                assert_eq!(bright, seen == 1, "{model} {double_sided}");
            }
        }
    }
}

#[test]
fn bad_input_leaves_nothing() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    let cloud = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                 property float z\nend_header\n0 0 0\n";
    std::fs::write(folder.path().join("cloud.ply"), cloud).unwrap();
    let nothing = r#"{"asset": {"version": "2.0"}}"#;
    std::fs::write(folder.path().join("nothing.gltf"), nothing).unwrap();
    let before = names(folder.path());
    let fails = |arguments: &[&str], parts: &[&str]| {
        let output = nullcone(folder.path(), [&["render"], arguments].concat());
        assert_failure(&output, parts);
        assert_eq!(names(folder.path()), before);
    };
    fails(
        &["square.obj", "--out", "p.jpg"],
        &["--out p.jpg", ".png, .y4m or .mp4"],
    );
    fails(
        &["nothing.gltf", "--out", "p.png"],
        &["nothing.gltf", "no triangle, line or point"],
    );
    fails(
        &["cloud.ply", "--out", "p.png"],
        &["cloud.ply", "nothing to look at"],
    );
    fails(&["none.obj", "--out", "p.png"], &["none.obj"]);
    let with = |more: &[&str], parts: &[&str]| {
        fails(&[&["square.obj", "--out", "p.png"], more].concat(), parts);
    };
    for size in ["80", "0x5"] {
        let output = nullcone(
            folder.path(),
            ["render", "square.obj", "--out", "p.png", "--size", size],
        );
        assert_eq!(output.status.code(), Some(2), "{size}");
        assert!(
            text(&output.stderr).contains("two numbers from 1"),
            "{size}"
        );
    }
    with(&["--turntable", "0"], &["--turntable 0"]);
    with(&["--samples", "9"], &["supersampling"]);
    with(&["--background", "grey"], &["--background grey"]);
    with(
        &["--camera", "behind"],
        &["--camera behind", "three-quarter"],
    );
    with(
        &["--camera", "eye 1,2 target 0,0,0 fov 3"],
        &["eye 1,2 has 2 numbers"],
    );
    with(
        &["--camera", "eye 1,2,3 target 0,0,x fov 3"],
        &["\"x\" after target"],
    );
    with(&["--camera", "eye 1,2,3 fov 3"], &["the target is missing"]);
    with(&["--camera", "eye 1,2,3 target 1,2,3 fov 3"], &["coincide"]);
    with(
        &["--camera", "eye 1,2,3 target 0,0,0 fov 180"],
        &["field of view"],
    );
    // The model is named where its camera or its picture cannot be made.
    with(&["--samples", "9"], &["square.obj", "supersampling"]);
    with(
        &["--camera", "camera.json", "--size", "64x65"],
        &["--size 64x65", "65x65"],
    );
    with(&["--buffers", "square.obj"], &["square.obj is a file"]);
    with(
        &["--turntable", "1000", "--size", "1037x1037"],
        &["--turntable 1000", "1037x1037", "1075369000", "1073741824"],
    );
}

#[test]
fn faults_of_a_camera_file_are_named() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    for (from, to, part) in [
        ("\"fx\": 80", "\"fx\": 0", "focal length"),
        ("\"fx\": 80, ", "", "there is no `fx`"),
        ("[0, -1, 0]", "[0, 1, 0]", "`rotation` is not a rotation"),
        ("4]}", "4], \"far\": 0}", "far depth"),
        ("\"cx\"", "\"c\"", "`c` is not a key"),
    ] {
        let bad = CAMERA.replace(from, to);
        assert_ne!(bad, CAMERA);
        std::fs::write(folder.path().join("camera.json"), bad).unwrap();
        let arguments = "render square.obj --camera camera.json --out p.png";
        let output = nullcone(folder.path(), arguments.split_whitespace());
        assert_failure(&output, &["camera.json", part]);
    }
    assert!(!folder.path().join("p.png").exists());
}

#[test]
fn a_picture_that_cannot_be_written_leaves_no_buffers() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    std::fs::create_dir(folder.path().join("p.png")).unwrap();
    std::fs::write(folder.path().join("depth.pfm"), "earlier").unwrap();
    let before = names(folder.path());
    for buffers in ["numbers", "."] {
        let arguments = "render square.obj --size 40x40 --out p.png --buffers";
        let arguments = arguments.split_whitespace().chain([buffers]);
        assert_failure(&nullcone(folder.path(), arguments), &["p.png"]);
        assert_eq!(names(folder.path()), before);
        let depth = std::fs::read(folder.path().join("depth.pfm")).unwrap();
        assert_eq!(depth, b"earlier");
    }
}

#[test]
fn a_picture_and_its_buffers_may_share_a_folder_but_not_a_name() {
    let folder = tempdir().unwrap();
    prepare(folder.path());
    let run = |out: &str| {
        let arguments = "render square.obj --size 40x40 --buffers together --out";
        nullcone(folder.path(), arguments.split_whitespace().chain([out]))
    };
    let before = names(folder.path());
    assert_failure(
        &run("./together/identity.png"),
        &["identity.png", "--buffers"],
    );
    assert_eq!(names(folder.path()), before);
    assert_success(&run("./together/p.png"));
    let written = names(&folder.path().join("together"));
    assert_eq!(written.len(), 7);
    assert!(written.contains(&"p.png".into()) && written.contains(&"depth.pfm".into()));
}
