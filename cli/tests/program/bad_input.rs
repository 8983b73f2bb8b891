//! Bad input: one line that names what is wrong and where, status 1, and nothing written.

use tempfile::tempdir;

use crate::common::figure;
use crate::common::{assert_failure, nullcone};

const FRAMES: usize = 4;

/// Animates a figure of boxes, one of whose files holds something else, or with other options, and
/// expects it to fail without writing anything.
#[track_caller]
fn fails(replaced: &[(&str, &[u8])], options: &[&str], parts: &[&str]) {
    let folder = tempdir().unwrap();
    figure::write(folder.path(), FRAMES);
    for (name, contents) in replaced {
        std::fs::write(folder.path().join(name), contents).unwrap();
    }
    let mut arguments = vec![
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
        "new/out",
    ];
    for pair in options.chunks(2) {
        match arguments.iter().position(|argument| *argument == pair[0]) {
            Some(option) => arguments[option + 1] = pair[1],
            None => arguments.extend(pair),
        }
    }
    assert_failure(&nullcone(folder.path(), &arguments), parts);
    assert!(!folder.path().join("new").exists());
}

#[test]
fn missing_files() {
    for option in ["--mesh", "--rig", "--weights"] {
        fails(&[], &[option, "nowhere"], &["cannot read nowhere: "]);
    }
    fails(
        &[],
        &["--motion", "nowhere.bvh"],
        &["cannot read nowhere.bvh: "],
    );
    fails(
        &[],
        &["--motion", "nowhere"],
        &["nowhere: a motion is a file of the kind .bvh"],
    );
    fails(&[], &["--mesh", "."], &["cannot read .: "]);
}

#[test]
fn meshes() {
    let line = "g body\nv 0 0 0\nv 1 0 0\n";
    let with = |last: &str| format!("{line}{last}\n").into_bytes();
    for (last, parts) in [
        ("v 0 nan 0", ["mesh.obj: line 4", "nan"]),
        ("v 0 1e999 0", ["mesh.obj: line 4", "1e999"]),
        ("v 0 1", ["mesh.obj: line 4", "this one has 2"]),
        ("v 0 1 0\nf 1 2 9", ["mesh.obj: line 5", "refers to v 9"]),
        ("\u{0}\u{1}", ["mesh.obj: line 4", "not UTF-8 text"]),
    ] {
        fails(&[("mesh.obj", &with(last))], &[], &parts);
    }
    fails(
        &[("mesh.obj", b"\x89PNG\r\n\x1a\n\0\0\0\r\xff")],
        &[],
        &["mesh.obj: line 1"],
    );
    let points = with("v 0 1 0");
    let parts = ["mesh.obj: line 4", "without a face"];
    fails(&[("mesh.obj", &points)], &["--strict"], &parts);
    fails(&[("mesh.obj", b"")], &[], &["mesh.obj", "without a vertex"]);
}

#[test]
fn rigs() {
    let bone = |name: &str, parent: &str| {
        format!(
            r#""{name}": {{"head": {{"default_position": [0, 0, 0]}}, "tail": {{"default_position": [0, 0, 1]}}, "parent": "{parent}"}}"#
        )
    };
    for (rig, part) in [
        ("{}".to_owned(), "no joints"),
        ("[1, 2]".to_owned(), "line 1"),
        (figure::rig()[..99].to_owned(), "line 1"),
        (
            format!("{{{}}}", bone("a", "z")),
            "\"z\", which is not in the file",
        ),
        (
            format!("{{{},{}}}", bone("a", "b"), bone("b", "a")),
            "its own ancestor",
        ),
        ("\u{0}".to_owned(), "line 1"),
    ] {
        fails(&[("rig.json", rig.as_bytes())], &[], &["rig.json: ", part]);
    }
}

#[test]
fn weights() {
    let strange = figure::weights().replace("\"head\"", "\"tentacle\"");
    fails(
        &[("weights.json", strange.as_bytes())],
        &[],
        &["weights.json: ", "\"tentacle\""],
    );
    let beyond = figure::weights().replace("[0, 0.75]", "[75, 0.75]");
    fails(
        &[("weights.json", beyond.as_bytes())],
        &[],
        &["weights.json: ", "vertex 75", "75 vertices"],
    );
    let negative = figure::weights().replace("[3, 0.75]", "[3, -0.75]");
    fails(
        &[("weights.json", negative.as_bytes())],
        &[],
        &["weights.json: ", "vertex 3", "-0.75"],
    );
    let none = figure::weights().replace("[3, 0.75],", "");
    fails(
        &[("weights.json", none.as_bytes())],
        &[],
        &["weights.json: ", "vertex 3"],
    );
}

#[test]
fn motions() {
    let bvh = figure::bvh(FRAMES, false);
    let lines = bvh.lines().count();
    let cut = &bvh[..bvh.trim_end().rfind(' ').unwrap()];
    let line = format!("motion.bvh: line {lines}");
    fails(
        &[("motion.bvh", cut.as_bytes())],
        &[],
        &[&line, "27 numbers", "26"],
    );
    // One frame fewer than announced is a warning.
    let short = &bvh[..bvh.trim_end().rfind('\n').unwrap()];
    let short = &short[..short.rfind('\n').unwrap()];
    fails(
        &[("motion.bvh", short.as_bytes())],
        &["--strict"],
        &["motion.bvh: line", "4 frames and has 2"],
    );
    let count = bvh.replacen("CHANNELS 3", "CHANNELS 4", 1);
    fails(
        &[("motion.bvh", count.as_bytes())],
        &["--strict"],
        &["motion.bvh: line"],
    );
    fails(&[("motion.bvh", b"\xff\xfe")], &[], &["motion.bvh: line 1"]);
    let empty = figure::bvh(0, false);
    fails(
        &[("motion.bvh", empty.as_bytes())],
        &[],
        &["motion.bvh: the recording has no frames"],
    );
    // Neither the names nor the shape of the hierarchy are those of a body.
    let stranger = "HIERARCHY\nROOT rock\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\nJOINT stone\n{\n\
                    OFFSET 0 2 0\nCHANNELS 1 Xrotation\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0\n";
    fails(
        &[("motion.bvh", stranger.as_bytes())],
        &[],
        &["motion.bvh cannot move rig.json", "no two legs"],
    );
}

#[test]
fn ranges_and_numbers() {
    for (options, parts) in [
        (
            &["--from", "3", "--to", "2"][..],
            &["--from 3", "--to 2"][..],
        ),
        (&["--from", "4"], &["--from 4", "motion.bvh are 0 to 3"]),
        (&["--to", "9"], &["--to 9", "motion.bvh are 0 to 3"]),
        (&["--fps", "0"], &["--fps 0"]),
        (&["--fps", "-30"], &["--fps -30"]),
        (&["--fps", "nan"], &["--fps NaN"]),
        (&["--fps", "inf"], &["--fps inf"]),
        (&["--fps", "1001"], &["--fps 1001"]),
        (&["--metres-per-unit", "0"], &["--metres-per-unit 0"]),
        (&["--metres-per-unit", "-1"], &["--metres-per-unit -1"]),
        (&["--metres-per-unit", "nan"], &["--metres-per-unit NaN"]),
        (
            &["--metres-per-unit", "1e308"],
            &["mesh.obj with 1", "metres a unit"],
        ),
        (
            &["--group", "hat"],
            &["mesh.obj has no group \"hat\"", "body, guide"],
        ),
    ] {
        fails(&[], options, parts);
    }
}
