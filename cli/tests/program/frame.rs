//! What all commands have in common: options, verdicts, warnings and pages.

use std::path::Path;

use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, names, nullcone, text};

/// A tetrahedron with its faces outwards, and one of which a face is turned over.
const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\
                           f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const TURNED: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\
                      f 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn meshes() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("good.obj", TETRAHEDRON);
    write("turned.obj", TURNED);
    write("without.obj", &format!("mtllib nowhere.mtl\n{TETRAHEDRON}"));
    folder
}

/// The words of every command: the manual has a page of each.
fn commands() -> Vec<String> {
    let folder = tempdir().unwrap();
    let report = json(folder.path(), &["man", "--out", "man"]);
    let files = report["files"].as_array().unwrap();
    assert_eq!(files.len(), names(&folder.path().join("man")).len());
    let words = files.iter().map(|file| {
        let name = Path::new(file.as_str().unwrap()).file_stem().unwrap();
        name.to_str().unwrap().replace('-', " ")
    });
    words.collect()
}

#[test]
fn every_command_has_the_options_of_the_frame() {
    let commands = commands();
    for command in ["nullcone stereo pose", "nullcone draw", "nullcone man"] {
        assert!(commands.iter().any(|found| found == command), "{command}");
    }
    for command in commands {
        let words = command.split(' ').skip(1).chain(["--help"]);
        let help = nullcone(Path::new("."), words);
        assert_success(&help);
        let help = text(&help.stdout);
        for option in [
            "--json",
            "--report <",
            "-q, --quiet",
            "--strict",
            "--threads <",
        ] {
            let mut lines = help.lines().map(str::trim_start);
            let is_there = lines.any(|line| line.starts_with(option));
            assert!(is_there, "{command}: {option:?}");
        }
    }
}

#[test]
fn a_verdict_that_is_not_good_is_in_the_status_of_a_check() {
    let folder = meshes();
    for (file, verdict, status) in [("good.obj", "good", 0), ("turned.obj", "doubtful", 3)] {
        let run = |more: &[&str]| nullcone(folder.path(), [&["mesh", "info", file], more].concat());
        assert_success(&run(&[]));
        let checked = run(&["--check", "--json"]);
        assert_eq!(checked.status.code(), Some(status), "{file}");
        let report: Value = serde_json::from_slice(&checked.stdout).unwrap();
        assert_eq!(report["verdict"], verdict);
    }
}

/// The bytes of a grey picture whose pixels look random, displaced by columns and rows.
fn noise(right: u64, down: u64) -> Vec<u8> {
    let mut bytes = b"P5 320 240 255\n".to_vec();
    for row in 0..240 {
        for column in 0..320 {
            // Squares of 4 × 4 pixels, so that there are corners.
            let [x, y] = [(column + right) / 4, (row + down) / 4];
            let mut hash = x.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ y.wrapping_mul(0xc2b2_ae3d);
            hash = (hash ^ (hash >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            bytes.push((hash >> 40) as u8);
        }
    }
    bytes
}

#[test]
fn a_pair_is_checked() {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("left.pgm", &noise(0, 0));
    write("right.pgm", &noise(8, 0));
    write("low.pgm", &noise(8, 6));
    for (right, status) in [("right.pgm", 0), ("low.pgm", 3)] {
        let arguments = ["stereo", "diagnose", "left.pgm", right, "--check"];
        let output = nullcone(folder.path(), arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{right}: {message}");
    }
}

#[test]
fn the_next_command_is_said_where_its_files_are_known() {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("left one.pgm", &noise(0, 0));
    write("right.pgm", &noise(8, 0));
    let run = |more: &[&str]| {
        let command = [
            "stereo",
            "match",
            "left one.pgm",
            "right.pgm",
            "--out",
            "d.pfm",
        ];
        let arguments = [&command[..], &["--max-disparity", "16"], more].concat();
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        text(&output.stdout).to_owned()
    };
    assert!(!run(&[]).contains("next: "));
    write("rig.yml", b"");
    let next = "\nnext: nullcone stereo reconstruct 'left one.pgm' right.pgm --rig rig.yml \
                --out model.glb\n";
    assert!(run(&[]).ends_with(next), "{}", run(&[]));
    assert_eq!(run(&["--quiet"]), "");
    assert!(!run(&["--json"]).contains("next: "));
}

#[test]
fn a_report_has_the_values_of_a_command_without_a_page_of_its_own() {
    let folder = meshes();
    let arguments = ["mesh", "info", "turned.obj", "--report", "page.html", "-q"];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    assert!(output.stderr.is_empty());
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    for part in [
        "nullcone mesh info",
        "The result is doubtful.",
        "turned.obj: the faces at 3 edges have opposite orientations",
        "<td>inconsistent_edges</td><td>3</td>",
        "<td>bounds.max</td><td>1.0, 1.0, 1.0</td>",
    ] {
        assert!(page.contains(part), "{part:?} is not in {page}");
    }
    // The page is an output as any other.
    let arguments = ["mesh", "info", "good.obj", "--report", "page.txt"];
    assert_failure(&nullcone(folder.path(), arguments), &["--report", ".html"]);
}

#[test]
fn warnings_are_in_json() {
    let folder = meshes();
    let report = json(folder.path(), &["mesh", "info", "without.obj"]);
    let warnings = report["warnings"].as_array().unwrap();
    assert_eq!(warnings.len(), 1);
    assert_eq!(warnings[0]["kind"], "missing_part");
    assert_eq!(warnings[0]["file"], "without.obj");
    let message = warnings[0]["message"].as_str().unwrap();
    assert!(message.contains("nowhere.mtl"), "{message}");
    // Commands that can warn have the key without warnings too.
    let report = json(folder.path(), &["mesh", "info", "good.obj"]);
    assert_eq!(report["warnings"], json!([]));
    let quiet = nullcone(folder.path(), ["mesh", "info", "without.obj", "--quiet"]);
    assert!(quiet.stderr.is_empty());
}

#[test]
fn commands_that_make_something_say_in_json_what() {
    let folder = meshes();
    let made = json(folder.path(), &["completions", "bash"]);
    assert_eq!(made["shell"], "bash");
    let script = nullcone(folder.path(), ["completions", "bash"]);
    assert_eq!(made["script"], text(&script.stdout));
    let arguments = ["--levels", "1", "--out", "fine.obj"];
    let made = json(
        folder.path(),
        &[&["mesh", "subdivide", "good.obj"], &arguments[..]].concat(),
    );
    // 4 vertices and 6 edges become vertices, and each of 4 triangles four.
    assert_eq!(
        (&made["vertices"], &made["faces"]),
        (&json!(10), &json!(16))
    );
    assert_eq!(made["files"], json!(["fine.obj"]));
    let made = json(folder.path(), &["render", "good.obj", "--out", "a.png"]);
    assert_eq!(made["triangles"], 4);
    assert_eq!(made["files"], json!(["a.png"]));
}

#[test]
fn a_page_does_not_replace_an_input() {
    let folder = tempdir().unwrap();
    let camera = "%YAML:1.0\n---\nK: [[500, 0, 160], [0, 500, 120], [0, 0, 1]]\n";
    for (name, bytes) in [("a.pgm", noise(0, 0)), ("b.pgm", noise(8, 0))] {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    std::fs::write(folder.path().join("a.html"), camera).unwrap();
    let arguments = [
        "stereo", "pose", "a.pgm", "b.pgm", "--camera", "a.html", "--report", "a.html",
    ];
    let message = "it is the input a.html, which would be lost";
    assert_failure(
        &nullcone(folder.path(), arguments),
        &["--report a.html", message],
    );
    let kept = std::fs::read_to_string(folder.path().join("a.html")).unwrap();
    assert_eq!(kept, camera);
}

#[test]
fn what_is_known_of_an_input_is_said_where_the_command_fails() {
    let folder = meshes();
    std::fs::write(folder.path().join("tags"), "no tags").unwrap();
    let arguments = [
        "mesh",
        "subdivide",
        "without.obj",
        "--levels",
        "1",
        "--creases",
        "tags",
        "--out",
        "f.obj",
    ];
    let output = nullcone(folder.path(), arguments);
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert!(message.starts_with("warning: without.obj: "), "{message}");
    assert!(
        message.contains("nowhere.mtl") && message.contains("error: tags"),
        "{message}"
    );
    let quiet = nullcone(folder.path(), [&arguments[..], &["--quiet"]].concat());
    assert!(text(&quiet.stderr).starts_with("error: "));
}

#[test]
fn a_command_without_anything_to_make_has_wrong_arguments() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("keys.csv"), "0,1\n1,2\n").unwrap();
    let output = nullcone(folder.path(), ["curve", "keys.csv"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        text(&output.stderr).contains("--out"),
        "{}",
        text(&output.stderr)
    );
}

#[test]
fn words_that_mean_something_mean_it_whatever_lies_in_the_folder() {
    let folder = meshes();
    let draw = || {
        let arguments = ["render", "good.obj", "--camera", "front", "--out", "a.png"];
        assert_success(&nullcone(folder.path(), arguments));
        std::fs::read(folder.path().join("a.png")).unwrap()
    };
    let before = draw();
    std::fs::create_dir(folder.path().join("front")).unwrap();
    assert_eq!(draw(), before);
    let contour = ["contour", "a.png", "--view", "left", "--out", "c.svg"];
    let output = nullcone(folder.path(), contour);
    assert_failure(&output, &["--view left: it is about the cameras of --rig"]);
}
