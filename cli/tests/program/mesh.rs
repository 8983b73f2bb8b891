//! `nullcone mesh`: what it says about meshes, and how it converts them.

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// A tetrahedron without one of its faces, one of whose materials is nowhere defined.
const OBJ: &str = "\
mtllib t.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 9 9 9
g floor
usemtl red
f 1 3 2
g walls
usemtl blue
f 1 2 4
f 2 3 4
";

const MTL: &str = "newmtl red\nKd 1 0 0\nmap_Kd red.png\n";

fn folder() -> tempfile::TempDir {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("t.obj"), OBJ).unwrap();
    std::fs::write(folder.path().join("t.mtl"), MTL).unwrap();
    folder
}

#[test]
fn info_counts_the_elements() {
    let folder = folder();
    let output = nullcone(folder.path(), ["mesh", "info", "t.obj", "--json"]);
    assert_success(&output);
    let info: Value = serde_json::from_slice(&output.stdout).unwrap();
    for (key, expected) in [
        ("vertices", 5),
        ("faces", 3),
        ("edges", 6),
        ("components", 1),
        ("euler_characteristic", 1),
        ("boundary_edges", 3),
        ("non_manifold_edges", 0),
        ("boundary_loops", 1),
        ("unreferenced_vertices", 1),
        ("duplicate_vertices", 0),
        ("degenerate_faces", 0),
        ("keyhole_faces", 0),
        ("concave_faces", 0),
        ("non_planar_faces", 0),
    ] {
        assert_eq!(info[key], expected, "{key}");
    }
    assert_eq!(info["oriented"], true);
    assert_eq!(info["bounds"]["max"], serde_json::json!([9.0, 9.0, 9.0]));
    assert_eq!(info["groups"][1]["name"], "walls");
    assert_eq!(info["materials"][1]["faces"], 2);
    assert_eq!(info["warnings"].as_array().unwrap().len(), 2);
    let warnings = text(&output.stderr);
    assert!(
        warnings.contains("warning: t.obj: line 11: no library defines"),
        "{warnings}"
    );
    assert!(
        warnings.contains("there is no picture red.png"),
        "{warnings}"
    );

    let output = nullcone(folder.path(), ["mesh", "info", "t.obj", "-q"]);
    assert_success(&output);
    assert!(output.stderr.is_empty());
    let table = text(&output.stdout);
    assert!(table.contains("\nboundary edges          3\n"), "{table}");
    assert!(
        table.contains("\ngroup                   walls, 2 faces\n"),
        "{table}"
    );
}

#[test]
fn conversion_keeps_what_both_formats_have() {
    let folder = folder();
    for (from, to) in [
        ("t.obj", "t.PLY"),
        ("t.PLY", "back.obj"),
        ("t.obj", "out/new.obj"),
    ] {
        let output = nullcone(folder.path(), ["mesh", "convert", from, to]);
        assert_success(&output);
        let library = to.strip_suffix("new.obj");
        let library = library.map(|folder| format!("wrote {folder}new.mtl\n"));
        let expected = format!("wrote {to}\n{}", library.unwrap_or_default());
        assert_eq!(text(&output.stdout), expected);
    }
    let back = std::fs::read_to_string(folder.path().join("back.obj")).unwrap();
    assert!(
        back.contains("v 0.0 0.0 1.0\n") && back.ends_with("f 2 3 4\n"),
        "{back}"
    );
    let binary = std::fs::read(folder.path().join("t.PLY")).unwrap();
    assert!(binary.starts_with(b"ply\nformat binary_little_endian 1.0\n"));
    let arguments = ["mesh", "convert", "t.obj", "text.ply", "--ascii"];
    assert_success(&nullcone(folder.path(), arguments));
    let ascii = std::fs::read_to_string(folder.path().join("text.ply")).unwrap();
    assert!(ascii.ends_with("3 1 2 3\n"), "{ascii}");
    // The picture is where it was.
    assert_eq!(names(&folder.path().join("out")), ["new.mtl", "new.obj"]);
    let library = std::fs::read_to_string(folder.path().join("out/new.mtl")).unwrap();
    assert!(library.contains("map_Kd ../red.png\n"), "{library}");
}

/// Files beside the output are replaced only if that is asked for.
#[test]
fn unrelated_files_stay() {
    let folder = folder();
    let convert = |arguments: &[&str]| {
        let arguments = [&["mesh", "convert"], arguments].concat();
        nullcone(folder.path(), arguments)
    };
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    std::fs::write(folder.path().join("t.mtl"), "newmtl red\nnewmtl blue\n").unwrap();
    for (output, beside) in [("m.obj", "m.mtl"), ("m.gltf", "m.bin")] {
        std::fs::write(folder.path().join(beside), "mine").unwrap();
        assert_failure(
            &convert(&["t.obj", output]),
            &[&format!("{beside} exists with other contents"), "--force"],
        );
        assert_eq!(read(beside), "mine");
        assert!(!folder.path().join(output).exists());
        let replaced = convert(&["t.obj", output, "--force"]);
        assert_success(&replaced);
        let expected = format!("wrote {output}\nwrote {beside}\n");
        assert_eq!(text(&replaced.stdout), expected);
        // The same contents do not conflict.
        assert_success(&convert(&["t.obj", output]));
    }
}

/// A library of materials that an input refers to is an input, also beside an output.
#[test]
fn the_library_of_an_input_stays() {
    let folder = folder();
    let place = |name: &str| folder.path().join(name);
    std::fs::copy(place("t.obj"), place("other.obj")).unwrap();
    std::fs::write(place("t.mtl"), "newmtl red\nnewmtl blue\n").unwrap();
    let before = [place("t.obj"), place("t.mtl")].map(|path| std::fs::read(path).unwrap());
    for command in [
        &["convert", "other.obj", "t.obj", "--force"][..],
        &["subdivide", "other.obj", "--levels", "1", "--out", "t.obj"],
    ] {
        let output = nullcone(folder.path(), [&["mesh"], command].concat());
        assert_failure(&output, &["t.mtl", "a part of the input other.obj"]);
        let after = [place("t.obj"), place("t.mtl")].map(|path| std::fs::read(path).unwrap());
        assert_eq!(after, before);
    }
    // A library that nothing refers to is replaced, as any other file that is written.
    std::fs::write(place("new.mtl"), "newmtl mine\n").unwrap();
    let subdivide = [
        "mesh",
        "subdivide",
        "t.obj",
        "--levels",
        "1",
        "--out",
        "new.obj",
    ];
    assert_success(&nullcone(folder.path(), subdivide));
    let library = std::fs::read_to_string(place("new.mtl")).unwrap();
    assert!(
        library.contains("newmtl red") && !library.contains("mine"),
        "{library}"
    );
}

#[test]
fn absolute_paths_of_pictures_become_relative() {
    let folder = folder();
    let place = folder.path().join("red.png");
    let library = format!("newmtl red\nmap_Kd {}\n", place.display());
    std::fs::write(folder.path().join("t.mtl"), library).unwrap();
    std::fs::write(&place, "picture").unwrap();
    let arguments = ["mesh", "convert", "t.obj", "m.gltf"];
    assert_success(&nullcone(folder.path(), arguments));
    let json = std::fs::read_to_string(folder.path().join("m.gltf")).unwrap();
    assert!(json.contains("\"uri\":\"red.png\""), "{json}");
    let arguments = ["mesh", "convert", "m.gltf", "back.obj"];
    assert_success(&nullcone(folder.path(), arguments));
}

/// The faces of a cube from a file that splits its vertices are connected.
#[test]
fn a_cube_with_normals_is_closed_in_every_format() {
    let folder = tempdir().unwrap();
    let mut cube = String::new();
    for index in 0..8 {
        cube += &format!("v {} {} {}\n", index & 1, index >> 1 & 1, index >> 2);
    }
    for normal in ["-1 0 0", "1 0 0", "0 -1 0", "0 1 0", "0 0 -1", "0 0 1"] {
        cube += &format!("vn {normal}\n");
    }
    let faces = [
        "1 5 7 3", "2 4 8 6", "1 2 6 5", "3 7 8 4", "1 3 4 2", "5 6 8 7",
    ];
    for (face, normal) in faces.into_iter().zip(1..) {
        let corners = face.split(' ').map(|vertex| format!(" {vertex}//{normal}"));
        cube += &format!("f{}\n", corners.collect::<String>());
    }
    std::fs::write(folder.path().join("cube.obj"), cube).unwrap();
    for arguments in [
        &["mesh", "convert", "cube.obj", "cube.glb"][..],
        &[
            "mesh",
            "subdivide",
            "cube.glb",
            "--levels",
            "1",
            "--out",
            "fine.obj",
        ],
    ] {
        assert_success(&nullcone(folder.path(), arguments));
    }
    for name in ["cube.obj", "cube.glb", "fine.obj"] {
        let output = nullcone(folder.path(), ["mesh", "info", name, "--json"]);
        let info: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(
            (&info["components"], &info["genus"]),
            (&1.into(), &0.into())
        );
        assert_eq!(info["closed"], true, "{name}");
    }
}

#[test]
fn bad_input_leaves_nothing() {
    let folder = folder();
    let before = names(folder.path());
    let fails = |arguments: &[&str], parts: &[&str]| {
        assert_failure(&nullcone(folder.path(), arguments), parts);
    };
    fails(
        &["mesh", "info", "t.mtl"],
        &["t.mtl: the name of a mesh file must end in .obj"],
    );
    fails(
        &["mesh", "convert", "t.obj", "t.stl"],
        &["OUT t.stl: its name must end in .glb, .gltf, .obj or .ply"],
    );
    fails(&["mesh", "info", "no.ply"], &["cannot read no.ply: "]);
    assert_eq!(names(folder.path()), before);
    let broken = |name: &str, contents: &str, message: &str| {
        std::fs::write(folder.path().join(name), contents).unwrap();
        let output = nullcone(folder.path(), ["mesh", "convert", name, "new.ply"]);
        assert_failure(&output, &[name, message]);
        assert!(!folder.path().join("new.ply").exists());
    };
    broken(
        "a.obj",
        "v 0 0 nan\n",
        "line 1: \"nan\" is not a finite number",
    );
    broken(
        "b.obj",
        "v 0 0 0\nf 1 1 2\n",
        "line 2: \"2\" refers to v 2, but there are 1",
    );
    broken("c.obj", "", "line 1: the file ends without a vertex");
    broken(
        "d.ply",
        "ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\n\
         property float y\nproperty float z\nend_header\n",
        "line 3: 1000000000 elements vertex need at least 6000000000 bytes",
    );
    std::fs::write(folder.path().join("t.mtl"), "newmtl red\nKd red\n").unwrap();
    fails(
        &["mesh", "info", "t.obj"],
        &["t.obj: line 1: t.mtl: line 2: \"red\" is not a number"],
    );
}
