//! Files of meshes and motions that deviate from their formats: read with warnings that name the
//! line, by every command that reads them, and refused with `--strict`.

use std::path::Path;

use serde_json::{Value, json as value};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, figure, json, nullcone, text};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
/// A fault of each kind that needs no other file: its lines, and what is said of it.
const FAULTS: [(&str, &str, u64); 4] = [
    ("f 1/1/ 2/2/ 3/3/", "corner_form", 7),
    (
        "f 1/1 2/2 3/3\nt crease 2/1/0 0 1 3.0",
        "unknown_statement",
        8,
    ),
    ("f 1/1/1 2/2/1 3/3/1", "no_normals", 7),
    ("f 1/1 2/2 3/3\nf 1 2", "short_face", 8),
];

fn folder_with(files: &[(&str, &[u8])]) -> TempDir {
    let folder = tempdir().unwrap();
    for (name, contents) in files {
        std::fs::write(folder.path().join(name), contents).unwrap();
    }
    folder
}

/// A command succeeds with this warning, in JSON and on standard error, and is refused with
/// `--strict`.
#[track_caller]
fn assert_tolerated(folder: &Path, words: &[&str], file: &str, kind: &str, line: u64) {
    let report = json(folder, words);
    let is_it = |warning: &&Value| warning["kind"] == kind;
    let warning = report["warnings"].as_array().unwrap().iter().find(is_it);
    let warning = warning.unwrap_or_else(|| panic!("{words:?}: {report}"));
    assert_eq!(warning["file"], file, "{words:?}");
    assert_eq!(warning["line"], line, "{words:?}");
    let output = nullcone(folder, words);
    assert_success(&output);
    let message = format!(
        "warning: {file}: {}\n",
        warning["message"].as_str().unwrap()
    );
    assert!(text(&output.stderr).contains(&message), "{words:?}");
    let strict = nullcone(folder, words.iter().chain(&["--strict"]));
    assert_failure(&strict, &[&format!("{file}: line {line}: ")]);
}

#[test]
fn meshes() {
    for (lines, kind, line) in FAULTS {
        let mesh = format!("{TRIANGLE}{lines}\n");
        let fine = format!("{TRIANGLE}f 1/1 2/2 3/3\n");
        let folder = folder_with(&[("a.obj", mesh.as_bytes()), ("fine.obj", fine.as_bytes())]);
        for words in [
            &["mesh", "info", "a.obj"][..],
            &["mesh", "convert", "a.obj", "b.ply"],
            &["mesh", "convert", "a.obj", "b.glb"],
            &[
                "mesh",
                "subdivide",
                "a.obj",
                "--levels",
                "1",
                "--out",
                "c.obj",
            ],
            &["render", "a.obj", "--size", "16x16", "--out", "a.png"],
            &[
                "mesh", "bake", "--fine", "a.obj", "--coarse", "fine.obj", "--maps", "normal",
                "--size", "16", "--out", "baked",
            ],
        ] {
            assert_tolerated(folder.path(), words, "a.obj", kind, line);
        }
        let report = json(folder.path(), &["mesh", "info", "a.obj"]);
        assert_eq!(
            (&report["vertices"], &report["faces"]),
            (&value!(3), &value!(1))
        );
        let fine = json(folder.path(), &["mesh", "info", "fine.obj"]);
        assert_eq!(fine["warnings"], value!([]));
    }
}

#[test]
fn libraries_of_materials_are_named_with_their_lines() {
    let mesh = format!("mtllib b.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let library = "newmtl\nKd 1 0 0\nnewmtl m\nKd 1 0 0\n";
    let folder = folder_with(&[("a.obj", mesh.as_bytes()), ("b.mtl", library.as_bytes())]);
    let report = json(folder.path(), &["mesh", "info", "a.obj"]);
    let expected = value!([{
        "kind": "no_name",
        "message": "line 1: a newmtl line has a name, but this one has none; the material is left out",
        "file": "b.mtl",
        "line": 1,
    }]);
    assert_eq!(report["warnings"], expected);
    let strict = nullcone(folder.path(), ["mesh", "info", "a.obj", "--strict"]);
    assert_failure(&strict, &["a.obj: line 1: b.mtl: line 1: "]);
}

#[test]
fn motions() {
    let motion = figure::bvh(6, false);
    let line = 1 + motion
        .lines()
        .position(|line| line.contains("Frames: 6"))
        .unwrap() as u64;
    let motion = motion.replace("Frames: 6", "Frames:6");
    let folder = tempdir().unwrap();
    figure::write(folder.path(), 6);
    std::fs::write(folder.path().join("a.bvh"), motion).unwrap();
    for words in [
        &["clip", "sample", "a.bvh", "--times", "0"][..],
        &[
            "clip",
            "compress",
            "a.bvh",
            "--tolerance",
            "0.01",
            "--shell",
            "1",
            "--out",
            "a.clip",
        ],
        &[
            "clip", "resample", "a.bvh", "--rate", "10", "--out", "b.clip",
        ],
        &["clip", "mirror", "a.bvh", "--out", "c.clip"],
        &[
            "clip",
            "blend",
            "a.bvh",
            "a.bvh",
            "--weights",
            "0.5,0.5",
            "--out",
            "d.clip",
        ],
        &[
            "clip",
            "retarget",
            "a.bvh",
            "--target",
            "motion.bvh",
            "--out",
            "e.bvh",
        ],
        &[
            "animate",
            "--mesh",
            "mesh.obj",
            "--rig",
            "rig.json",
            "--weights",
            "weights.json",
            "--motion",
            "a.bvh",
            "--out",
            "animated",
        ],
    ] {
        assert_tolerated(folder.path(), words, "a.bvh", "missing_blank", line);
    }
}

#[test]
fn the_mesh_of_a_figure_has_its_warnings_too() {
    let folder = tempdir().unwrap();
    figure::write(folder.path(), 4);
    let mesh = std::fs::read_to_string(folder.path().join("mesh.obj")).unwrap();
    std::fs::write(folder.path().join("mesh.obj"), format!("vw 1 0.5\n{mesh}")).unwrap();
    let words = [
        "animate",
        "--mesh",
        "mesh.obj",
        "--rig",
        "rig.json",
        "--weights",
        "weights.json",
        "--motion",
        "motion.bvh",
        "--out",
        "animated",
    ];
    assert_tolerated(folder.path(), &words, "mesh.obj", "unknown_statement", 1);
}
