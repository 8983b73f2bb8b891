//! `nullcone mesh subdivide`: what it writes, and how it tells what is wrong.

use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// A square with texture coordinates and a group.
const SQUARE: &str = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n\
    vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\ng lid\nf 1/1 2/2 3/3 4/4\n";
const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn a_square_is_refined_with_what_it_carries() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("square.obj"), SQUARE).unwrap();
    let run = |more: &[&str]| {
        let basic = [
            "mesh",
            "subdivide",
            "square.obj",
            "--levels",
            "1",
            "--out",
            "fine.obj",
        ];
        let output = nullcone(folder.path(), basic.iter().chain(more));
        assert_success(&output);
        assert_eq!(
            text(&output.stdout),
            "wrote fine.obj: 9 vertices, 4 faces\n"
        );
        std::fs::read_to_string(folder.path().join("fine.obj")).unwrap()
    };
    // Corners of the boundary go to 3/4 v + 1/8 (a + b); the edges are numbered by their ends.
    let first = run(&[]);
    let vertices: Vec<&str> = first
        .lines()
        .filter(|line| line.starts_with("v "))
        .collect();
    assert_eq!(
        vertices,
        [
            "v 0.5 0.5 0.0",
            "v 3.5 0.5 0.0",
            "v 3.5 3.5 0.0",
            "v 0.5 3.5 0.0",
            "v 2.0 0.0 0.0",
            "v 0.0 2.0 0.0",
            "v 4.0 2.0 0.0",
            "v 2.0 4.0 0.0",
            "v 2.0 2.0 0.0",
        ]
    );
    assert!(first.contains("\ng lid\nf 1/1 5/5 9/9 6/6\n"), "{first}");
    assert!(
        first.contains("\nvt 0.0 0.0\n") && first.contains("\nvt 0.5 0.0\n"),
        "{first}"
    );
    // The same is written again.
    assert_eq!(run(&["--scheme", "catmull-clark"]), first);

    let kept = run(&["--boundary", "edge-and-corner"]);
    assert!(kept.starts_with("v 0.0 0.0 0.0\nv 4.0 0.0 0.0\n"), "{kept}");
    // Sharp vertices are counted from 0.
    std::fs::write(folder.path().join("tags"), "corner 1 inf # stays\n").unwrap();
    let sharp = run(&["--creases", "tags", "--crease-method", "chaikin"]);
    assert!(
        sharp.starts_with("v 0.5 0.5 0.0\nv 4.0 0.0 0.0\nv 3.5 3.5 0.0\n"),
        "{sharp}"
    );
}

#[test]
fn triangles_are_refined_by_loops_scheme() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("in.obj"), TETRAHEDRON).unwrap();
    let basic = [
        "mesh",
        "subdivide",
        "in.obj",
        "-q",
        "--out",
        "fine.obj",
        "--levels",
    ];
    let faces_of = |more: &[&str]| {
        let output = nullcone(folder.path(), basic.iter().chain(more));
        assert_success(&output);
        assert!(output.stdout.is_empty());
        let fine = std::fs::read_to_string(folder.path().join("fine.obj")).unwrap();
        fine.lines().filter(|line| line.starts_with("f ")).count()
    };
    assert_eq!(faces_of(&["2"]), 64);
    assert_eq!(faces_of(&["2", "--scheme", "catmull-clark"]), 48);
    assert_eq!(faces_of(&["0"]), 4);
}

#[test]
fn bad_input_leaves_nothing() {
    let folder = tempdir().unwrap();
    let write = |name: &str, contents: &str| {
        std::fs::write(folder.path().join(name), contents).unwrap();
    };
    write("square.obj", SQUARE);
    write("in.obj", TETRAHEDRON);
    write(
        "fin.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
    );
    write("tags", "crease 0 1 2\ncrease 0 9 1\n");
    write("corners", "\n\ncorner 4 1\n");
    write("words", "crease 0 1\n");
    let before = names(folder.path());
    let fails = |arguments: &[&str], parts: &[&str]| {
        let output = nullcone(folder.path(), ["mesh", "subdivide"].iter().chain(arguments));
        assert_failure(&output, parts);
        assert_eq!(names(folder.path()), before);
    };
    let to = ["--out", "new/fine.obj", "--levels", "1"];
    let with = |more: &[&'static str]| -> Vec<&str> { [more, &to].concat() };
    fails(
        &with(&["square.obj", "--scheme", "loop"]),
        &["square.obj: face 0 has 4 corners"],
    );
    fails(
        &with(&["fin.obj"]),
        &["fin.obj: 3 faces meet at the edge between vertices 0 and 1"],
    );
    fails(&with(&["nowhere.obj"]), &["cannot read nowhere.obj: "]);
    fails(
        &with(&["in.obj", "--creases", "tags"]),
        &["tags: line 2: no edge joins vertices 0 and 9"],
    );
    fails(
        &with(&["in.obj", "--creases", "corners"]),
        &["corners: line 3: ", "vertex 4"],
    );
    fails(
        &with(&["in.obj", "--creases", "words"]),
        &["words: line 1: expected \"crease a b"],
    );
    let levels = ["in.obj", "--out", "fine.obj", "--levels", "40"];
    fails(&levels, &["--levels 40 would give", "faces"]);
    fails(
        &["in.obj", "--out", "fine.stl", "--levels", "1"],
        &["--out fine.stl", ".obj, .glb, .gltf or .ply"],
    );
}
