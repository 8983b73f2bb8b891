//! `nullcone mesh bake`: files, report and errors.

use ga_image::picture::Picture;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// A square of two triangles, and a square that rises by 0.01 from the left to the right, from red
/// to green.
const COARSE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
const FINE: &str = "v 0 0 0 1 0 0\nv 1 0 0.01 0 1 0\nv 1 1 0.01 0 1 0\nv 0 1 0 1 0 0\nf 1 2 3 4\n";

fn folder() -> TempDir {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("coarse.obj"), COARSE).unwrap();
    std::fs::write(folder.path().join("fine.obj"), FINE).unwrap();
    let with_coordinates = COARSE
        .replace("f 1 2 3\nf 1 3 4", "f 1/1 2/2 3/3\nf 1/1 3/3 4/4")
        .replace("f 1/1 2", "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2");
    std::fs::write(folder.path().join("own.obj"), with_coordinates).unwrap();
    folder
}

fn bake(folder: &TempDir, more: &[&str]) -> std::process::Output {
    let command = [
        "mesh", "bake", "--fine", "fine.obj", "--out", "out", "--json",
    ];
    nullcone(folder.path(), command.iter().chain(more))
}

fn picture(folder: &TempDir, name: &str) -> Picture {
    ga_image::file::read(folder.path().join("out").join(name)).unwrap()
}

#[test]
fn maps_of_own_coordinates_show_the_fine_mesh() {
    let folder = folder();
    let maps = "normal,displacement,colour,occlusion";
    let arguments = [
        "--coarse", "own.obj", "--size", "64", "--maps", maps, "--rays", "8",
    ];
    let output = bake(&folder, &arguments);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["unwrapped"], false);
    assert_eq!(report["charts"], 1);
    assert_eq!(report["utilisation"], 1.0);
    assert_eq!(report["flipped"], 0);
    assert_eq!(report["overlapping"], 0);
    assert!((report["stretch"].as_f64().unwrap() - 1.0).abs() < 1e-12);
    for step in [
        "read",
        "atlas",
        "hierarchy",
        "normal",
        "displacement",
        "colour",
        "occlusion",
    ] {
        assert!(report["seconds"][step].as_f64().unwrap() >= 0.0, "{step}");
    }

    // The middle of a texel in column c is at x = (c + 0.5) / 64, where the height is 0.01 x.
    let range = |end: &str| report["displacement"][end].as_f64().unwrap();
    let (minimum, maximum) = (range("minimum"), range("maximum"));
    assert!((minimum - 0.01 * 0.5 / 64.0).abs() < 1e-6, "{minimum}");
    assert!((maximum - 0.01 * 63.5 / 64.0).abs() < 1e-6, "{maximum}");
    let Picture::Grey16(heights) = picture(&folder, "displacement.png") else {
        panic!("displacement has 16 bits");
    };
    for column in 0..64 {
        let share = f64::from(heights.get(column, 20).unwrap()) / 65_535.0;
        assert!(
            (share - column as f64 / 63.0).abs() < 2e-4,
            "{column}: {share}"
        );
    }

    // The normal (−0.01, 0, 1), and light that goes linearly from red to green.
    let Picture::Rgb8(normals) = picture(&folder, "normal.png") else {
        panic!("normals are RGB");
    };
    assert_eq!(normals.get(31, 31), Some([126, 128, 255]));
    let Picture::Rgb8(colours) = picture(&folder, "colour.png") else {
        panic!("colours are RGB");
    };
    let [red, green, blue] = colours.get(31, 40).unwrap();
    assert!(red.abs_diff(188) <= 2 && green.abs_diff(188) <= 2 && blue == 0);
    let Picture::Grey8(open) = picture(&folder, "occlusion.png") else {
        panic!("occlusion is grey");
    };
    assert!(open.values().iter().all(|&share| share == 255));
}

#[test]
fn an_atlas_is_made_where_there_are_no_coordinates_or_on_demand() {
    let folder = folder();
    for arguments in [
        &["--coarse", "coarse.obj"][..],
        &["--coarse", "own.obj", "--unwrap"],
    ] {
        let size = ["--size", "64", "--margin", "2"];
        let output = bake(&folder, &[arguments, &size].concat());
        assert_success(&output);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["unwrapped"], true);
        let utilisation = report["utilisation"].as_f64().unwrap();
        assert!(utilisation > 0.7 && utilisation < 1.0, "{utilisation}");
    }
    let files = [
        "coarse.glb",
        "coarse.mtl",
        "coarse.obj",
        "colour.png",
        "displacement.png",
        "normal.png",
    ];
    assert_eq!(names(&folder.path().join("out")), files);

    let (document, _, images) = gltf::import(folder.path().join("out/coarse.glb")).unwrap();
    let material = document.materials().next().unwrap();
    assert!(material.normal_texture().is_some());
    assert!(
        material
            .pbr_metallic_roughness()
            .base_color_texture()
            .is_some()
    );
    assert_eq!((images[0].width, images[0].height), (64, 64));
    let library = std::fs::read_to_string(folder.path().join("out/coarse.mtl")).unwrap();
    assert!(library.contains("map_Kd colour.png"), "{library}");
    let mesh = ga_mesh::obj::read(folder.path().join("out/coarse.obj")).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.faces().len()), (4, 2));
    let coordinates = mesh.texture_coordinates().unwrap();
    assert!(coordinates.corners.iter().all(Option::is_some));
}

#[test]
fn nothing_is_written_where_the_bake_fails() {
    let folder = folder();
    std::fs::write(
        folder.path().join("flat.obj"),
        "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n",
    )
    .unwrap();
    for (arguments, message) in [
        (
            &["--coarse", "flat.obj"][..],
            "flat.obj: no texture: all 1 faces are degenerate",
        ),
        (&["--coarse", "missing.obj"], "missing.obj"),
        (
            &["--coarse", "coarse.obj", "--size", "8", "--margin", "9"],
            "do not fit",
        ),
        (
            &["--coarse", "coarse.obj", "--distance=-1"],
            "coarse.obj: the cage distance is -1",
        ),
    ] {
        assert_failure(&bake(&folder, arguments), &[message]);
        assert!(!folder.path().join("out").exists(), "{arguments:?}");
    }
    for arguments in [["--maps", "gloss"], ["--size", "0"], ["--size", "8193"]] {
        let output = bake(
            &folder,
            &[&["--coarse", "coarse.obj"], &arguments[..]].concat(),
        );
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(arguments[0]));
        assert!(!folder.path().join("out").exists(), "{arguments:?}");
    }
}

/// A fine square with texture coordinates from 0 to 2 along u, whose material has a picture.
fn with_picture(folder: &TempDir, material: &str) {
    let fine = "mtllib fine.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
                vt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    std::fs::write(folder.path().join("fine.obj"), fine).unwrap();
    let material = format!("newmtl paint\n{material}\n");
    std::fs::write(folder.path().join("fine.mtl"), material).unwrap();
}

fn baked_colours(folder: &TempDir) -> (ga_image::plane::Plane<[u8; 3]>, String) {
    let arguments = [
        "--coarse",
        "own.obj",
        "--size",
        "16",
        "--maps",
        "colour",
        "--distance",
        "0.1",
    ];
    let output = bake(folder, &arguments);
    assert_success(&output);
    let colours = picture(folder, "colour.png").to_rgb::<u8>();
    (colours, text(&output.stderr).to_owned())
}

#[test]
fn a_missing_picture_of_the_fine_mesh_leaves_its_base_colour() {
    let folder = folder();
    with_picture(&folder, "Kd 1 0 0\nmap_Kd paint.png");
    let (colours, messages) = baked_colours(&folder);
    assert!(colours.values().iter().all(|&colour| colour == [255, 0, 0]));
    let warning = "paint.png; the surface is shown without it";
    assert_eq!(messages.matches(warning).count(), 1, "{messages}");
    std::fs::write(folder.path().join("paint.png"), "no picture").unwrap();
    let output = bake(&folder, &["--coarse", "own.obj"]);
    assert_failure(&output, &["fine.obj", "paint", "paint.png"]);
}

#[test]
fn the_picture_of_the_fine_mesh_goes_on_beyond_its_edges_as_its_material_says() {
    let folder = folder();
    let columns = |column, _| [[255u8, 0, 0], [0, 0, 255]][column / 2];
    let paint = ga_image::plane::Plane::from_fn(4, 1, columns);
    let paint = ga_image::png::encode(&paint).unwrap();
    std::fs::write(folder.path().join("paint.png"), paint).unwrap();
    // The coordinate u of column c is (c + 0.5) / 8, so that the picture ends before column 8.
    for (option, beyond) in [("-clamp on ", [0, 0, 255]), ("", [255, 0, 0])] {
        with_picture(&folder, &format!("Kd 1 1 1\nmap_Kd {option}paint.png"));
        let (colours, _) = baked_colours(&folder);
        assert_eq!(colours.get(1, 8), Some([255, 0, 0]));
        assert_eq!(colours.get(6, 8), Some([0, 0, 255]));
        assert_eq!(colours.get(10, 8), Some(beyond), "{option}");
    }
}

#[test]
fn pictures_with_16_bits_are_baked_at_their_depth() {
    let folder = folder();
    let paint = ga_image::plane::Plane::filled(4, 4, [0x46cb_u16; 3]);
    let paint = ga_image::png::encode(&paint).unwrap();
    std::fs::write(folder.path().join("paint.png"), paint).unwrap();
    with_picture(&folder, "Kd 0.5 0.5 0.5\nmap_Kd paint.png");
    // Half the light of 0x46cb / 65535 is code 49.3 of 255; that of the nearest code with 8 bits,
    // 71, is 49.7.
    let (colours, _) = baked_colours(&folder);
    assert!(colours.values().iter().all(|&colour| colour == [49; 3]));
}

/// The library of the coarse mesh lies where that of the result would be written.
#[test]
fn the_library_of_the_coarse_mesh_stays() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("out")).unwrap();
    let library = folder.path().join("out/coarse.mtl");
    std::fs::write(&library, "newmtl paint\n").unwrap();
    let low = format!("mtllib coarse.mtl\nusemtl paint\n{COARSE}");
    std::fs::write(folder.path().join("out/low.obj"), low).unwrap();
    let output = bake(&folder, &["--coarse", "out/low.obj", "--size", "16"]);
    assert_failure(&output, &["coarse.mtl", "a part of the input out/low.obj"]);
    assert_eq!(std::fs::read(&library).unwrap(), b"newmtl paint\n");
    assert_eq!(names(&folder.path().join("out")), ["coarse.mtl", "low.obj"]);
}

/// Scans and exports often have vertices that no face uses.
#[test]
fn a_vertex_without_a_face_does_not_matter() {
    let folder = folder();
    for name in ["coarse.obj", "own.obj", "fine.obj"] {
        let path = folder.path().join(name);
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, text + "v 9 9 9\n").unwrap();
    }
    for coarse in ["coarse.obj", "own.obj"] {
        let output = bake(
            &folder,
            &["--coarse", coarse, "--size", "16", "--maps", "normal"],
        );
        assert_success(&output);
    }
}
