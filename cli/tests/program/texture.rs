//! `nullcone texture`: models from rendered views, compared with the truth from other views.

use std::path::Path;

use ga_image::plane::Plane;
use ga_image::quality::Ssim;
use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// Runs the program with words of one line.
fn run(folder: &Path, line: &str) {
    assert_success(&nullcone(folder, line.split_whitespace()));
}

/// Renders eight views around a model, textures `mesh` from them alone, and returns the report.
fn texture(folder: &Path, model: &str, mesh: &str, more: &str) -> Value {
    run(
        folder,
        &format!(
            "render {model} --turntable 8 --shading unlit --size 480x480 --views views --out v.png"
        ),
    );
    let line = format!("texture {mesh} --views views/views.json --out t.glb --json {more}");
    let output = nullcone(folder, line.split_whitespace());
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The mean of SSIM, over the pixels that show the model, between a model and another from a view.
fn similarity(folder: &Path, model: &str, other: &str, camera: &str) -> f64 {
    let picture = |model: &str| {
        let out = "--shading unlit --size 480x480 --out p.png --buffers numbers";
        let words = ["render", model, "--camera", camera];
        assert_success(&nullcone(
            folder,
            words.into_iter().chain(out.split_whitespace()),
        ));
        let picture = ga_image::file::read(folder.join("p.png")).unwrap();
        let depth = ga_image::file::read(folder.join("numbers/depth.pfm")).unwrap();
        let depth: Plane<f32> = depth.to_grey(ga_image::grey::Luma::Bt601);
        (picture.to_rgb::<u8>(), depth)
    };
    let ((truth, depth), (found, _)) = (picture(model), picture(other));
    let map = Ssim::new(255.0).map(&truth, &found).unwrap();
    let shown = map.values().iter().zip(depth.values());
    let shown = shown.filter(|(_, depth)| depth.is_finite());
    let (sum, count) = shown.fold((0.0, 0.0), |(sum, count), (ssim, _)| {
        (sum + f64::from(*ssim), count + 1.0)
    });
    assert!(count > 1000.0);
    sum / count
}

/// Views that are none of the eight: from between them, from lower and from higher up.
const NINTH: [&str; 3] = [
    "eye 1.2,1.0,3.6 target 0,0.9,0 fov 32",
    "eye -3.2,0.6,1.5 target 0,0.9,0 fov 32",
    "eye 1.4,2.9,2.4 target 0,0.9,0 fov 32",
];

#[test]
fn a_person_looks_the_same_from_a_ninth_view() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    run(folder, "demo --figure --out .");
    let report = texture(folder, "model.obj", "model.obj", "--size 1024 --unwrap");
    assert_eq!(report["views"].as_array().unwrap().len(), 8);
    assert_eq!(report["unwrapped"], true);
    for camera in NINTH {
        let ssim = similarity(folder, "model.obj", "t.glb", camera);
        eprintln!("{camera}: {ssim:.4}");
        assert!(ssim >= 0.95, "{camera}: {ssim}");
    }
}

#[test]
fn a_cow_with_any_picture_looks_the_same_too() {
    let Some(spot) = shared("data/anim/spot.obj") else {
        return;
    };
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let text = std::fs::read_to_string(spot).unwrap();
    let kept = text
        .lines()
        .filter(|l| !l.starts_with("mtllib") && !l.starts_with("usemtl"));
    let lines: Vec<&str> = kept.collect();
    let painted = format!("mtllib cow.mtl\nusemtl paint\n{}\n", lines.join("\n"));
    std::fs::write(folder.join("cow.obj"), painted).unwrap();
    std::fs::write(folder.join("plain.obj"), lines.join("\n")).unwrap();
    std::fs::write(
        folder.join("cow.mtl"),
        "newmtl paint\nKd 1 1 1\nmap_Kd paint.png\n",
    )
    .unwrap();
    // Rings of several sizes in changing colours.
    let paint = Plane::from_fn(512, 512, |column, row| {
        let [u, v] = [column, row].map(|x| x as f64 / 512.0);
        let ring = |x: f64, y: f64, k: f64| (0.5 + 0.5 * (k * (u - x).hypot(v - y)).sin()) * 200.0;
        [
            ring(0.2, 0.3, 80.0),
            ring(0.7, 0.4, 130.0),
            ring(0.5, 0.9, 50.0),
        ]
        .map(|x| 30 + x as u8)
    });
    ga_image::file::write(folder.join("paint.png"), &paint).unwrap();
    texture(folder, "cow.obj", "plain.obj", "--size 1024 --unwrap");
    for camera in [
        "eye 1.5,0.6,-2.2 target 0,0,0 fov 40",
        "eye -2.4,0.2,1.2 target 0,0,0 fov 40",
    ] {
        let ssim = similarity(folder, "cow.obj", "t.glb", camera);
        eprintln!("{camera}: {ssim:.4}");
        assert!(ssim >= 0.95, "{camera}: {ssim}");
    }
}

/// A folder with a square of side 2 that faces +z, and a view of it.
fn square(folder: &Path) {
    let mesh = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
    std::fs::write(folder.join("square.obj"), mesh).unwrap();
    let line = "render square.obj --size 64x64 --views views --camera-out c.json --out p.png \
                --camera front";
    run(folder, line);
}

#[test]
fn views_and_cameras_are_written_as_they_are_read() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    square(folder);
    assert_eq!(names(&folder.join("views")), ["view-000.png", "views.json"]);
    let first = std::fs::read(folder.join("p.png")).unwrap();
    assert_eq!(
        std::fs::read(folder.join("views/view-000.png")).unwrap(),
        first
    );
    // The same picture with the camera from the file.
    run(folder, "render square.obj --camera c.json --out q.png");
    assert_eq!(std::fs::read(folder.join("q.png")).unwrap(), first);
    let views = std::fs::read(folder.join("views/views.json")).unwrap();
    let views: Value = serde_json::from_slice(&views).unwrap();
    assert_eq!(views["views"][0]["picture"], "view-000.png");
    assert_eq!(views["views"][0]["camera"]["cx"], 31.5);
}

#[test]
fn nothing_is_written_where_a_view_is_wrong() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    square(folder);
    std::fs::write(folder.join("points.obj"), "v 0 0 0\np 1\n").unwrap();
    let good = std::fs::read_to_string(folder.join("views/views.json")).unwrap();
    let fails = |mesh: &str, views: &str, more: &str, parts: &[&str]| {
        std::fs::write(folder.join("views/views.json"), views).unwrap();
        let line = format!("texture {mesh} --views views/views.json --out t.glb {more}");
        assert_failure(&nullcone(folder, line.split_whitespace()), parts);
        assert!(!folder.join("t.glb").exists());
    };
    fails("points.obj", &good, "", &["points.obj", "no triangles"]);
    let other = good.replace("\"width\": 64", "\"width\": 65");
    let parts = ["view-000.png", "64 × 64 pixels", "65 × 64"];
    fails("square.obj", &other, "", &parts);
    let missing = good.replace("view-000.png", "none.png");
    fails("square.obj", &missing, "", &["none.png"]);
    let without = good.replace("\"fx\"", "\"f\"");
    fails(
        "square.obj",
        &without,
        "",
        &["views.json", "view 0", "camera.f"],
    );
    fails("square.obj", "{}", "", &["views.json", "`views`"]);
    // The camera stands behind what it should see.
    let mut away: Value = serde_json::from_str(&good).unwrap();
    let camera = &mut away["views"][0]["camera"];
    let depth = camera["translation"][2].as_f64().unwrap();
    camera["translation"][2] = (-depth).into();
    fails(
        "square.obj",
        &away.to_string(),
        "",
        &["view-000.png", "does not see the mesh"],
    );
    fails("square.obj", &good, "--size 4", &["do not fit into 4 × 4"]);

    let line = "texture square.obj --views views/views.json --out t.ply";
    assert_failure(
        &nullcone(folder, line.split_whitespace()),
        &["--out t.ply: its name must end in .glb, .gltf or .obj"],
    );
    std::fs::write(folder.join("views/views.json"), &good).unwrap();
    let line = "texture square.obj --views views/views.json --out t.glb --size 64";
    let output = nullcone(folder, line.split_whitespace());
    assert_success(&output);
    assert!(text(&output.stdout).starts_with("t.glb: 64 texels a side, a new atlas of 1 charts"));
}
