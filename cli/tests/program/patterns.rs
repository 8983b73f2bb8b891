//! Lists of files: names come before patterns, and numbers in names count as numbers.

use std::path::Path;

use ga_image::file;
use ga_image::plane::Plane;
use tempfile::tempdir;

use crate::common::{assert_failure, json, nullcone};

/// A bright square in a dark picture of this width.
fn write_square(path: &Path, width: usize) {
    let square = Plane::from_fn(width, 20, |column, row| {
        if (5..12).contains(&column) && (5..12).contains(&row) {
            220u8
        } else {
            30
        }
    });
    file::write(path, &square).unwrap();
}

#[test]
fn a_picture_whose_name_has_brackets_is_found_by_its_name() {
    let folder = tempdir().unwrap();
    let inside = folder.path().join("br[1]");
    std::fs::create_dir(&inside).unwrap();
    write_square(&inside.join("left [8].png"), 21);
    write_square(&inside.join("left 8.png"), 23);
    let width = |name: &str| json(folder.path(), &["contour", name])["width_px"].clone();
    assert_eq!(width("br[1]/left [8].png"), 21);
    assert_eq!(width("br[1]/left 8.png"), 23);
    // Without a file of the name it is a pattern.
    std::fs::remove_file(inside.join("left [8].png")).unwrap();
    assert_eq!(width("br[1]/left [8].png"), 23);
    for (name, message) in [
        ("br[1]/right*.png", "right*.png\" matches no file"),
        ("left [8.png", "left [8.png"),
    ] {
        assert_failure(
            &nullcone(folder.path(), ["contour", name]),
            &["IMAGE", message],
        );
    }
    write_square(&inside.join("left 9.png"), 23);
    write_square(&inside.join("left 10.png"), 23);
    let three = nullcone(folder.path(), ["contour", "br[1]/left*.png"]);
    assert_failure(&three, &["IMAGE", "not 3 pictures"]);
}

#[test]
fn films_of_a_pattern_come_in_the_order_of_their_numbers() {
    let folder = tempdir().unwrap();
    let mut film = b"YUV4MPEG2 W16 H16 F25:1 C420jpeg\n".to_vec();
    film.extend(b"FRAME\n");
    film.extend([90; 16 * 16 * 3 / 2]);
    for name in ["shot10.y4m", "shot9.y4m", "shot[9].y4m", "last.y4m"] {
        std::fs::write(folder.path().join(name), &film).unwrap();
    }
    let films = |names: &[&str]| -> Vec<String> {
        let arguments = [&["video", "statistics"], names].concat();
        let report = json(folder.path(), &arguments);
        let clips = report["clips"].as_array().unwrap().iter();
        let names = clips.filter_map(|clip| clip["file"].as_str().map(str::to_owned));
        names.collect()
    };
    assert_eq!(films(&["shot?*0.y4m"]), ["shot10.y4m"]);
    assert_eq!(
        films(&["last.y4m", "shot[9].y4m", "shot[0-9]*.y4m"]),
        ["last.y4m", "shot[9].y4m", "shot9.y4m", "shot10.y4m"]
    );
    let none = nullcone(folder.path(), ["video", "statistics", "scene*.y4m"]);
    assert_failure(&none, &["FILE", "scene*.y4m", "matches no file"]);
    // A name is not a pattern.
    let missing = nullcone(folder.path(), ["video", "statistics", "scene.y4m"]);
    assert_failure(&missing, &["scene.y4m", "No such file"]);
}

#[test]
fn motions_of_a_pattern_are_blended_by_their_numbers() {
    let folder = tempdir().unwrap();
    let motion = |x: f64| {
        format!(
            "HIERARCHY\nROOT Hips\n{{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition \
             Zposition Zrotation Xrotation Yrotation\n  End Site\n  {{\n    OFFSET 0 1 0\n  }}\n}}\n\
             MOTION\nFrames: 2\nFrame Time: 0.04\n{x} 0 0 0 0 0\n{x} 0 0 0 0 0\n"
        )
    };
    std::fs::write(folder.path().join("take 2.bvh"), motion(2.0)).unwrap();
    std::fs::write(folder.path().join("take 10.bvh"), motion(10.0)).unwrap();
    let blend = [
        "clip",
        "blend",
        "take*.bvh",
        "--weights",
        "1,0",
        "--out",
        "mean.clip",
    ];
    let report = json(folder.path(), &blend);
    assert_eq!(report["file"], "take 2.bvh, take 10.bvh");
    let one = nullcone(
        folder.path(),
        [
            "clip",
            "blend",
            "take 1*",
            "--weights",
            "1",
            "--out",
            "one.clip",
        ],
    );
    assert_eq!(one.status.code(), Some(2));
}
