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
        assert_eq!(text(&output.stdout), format!("wrote {to}\n"));
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
        &["t.stl: the name of a mesh file"],
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
