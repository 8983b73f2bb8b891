//! Parts that do not belong together.

use std::path::Path;

use tempfile::{TempDir, tempdir};

use super::{run, write_film};
use crate::common::{assert_failure, names, nullcone, text};

/// Three films of six frames, the last two of the same size in bytes.
fn films() -> TempDir {
    let folder = tempdir().unwrap();
    write_film(&folder.path().join("a.y4m"), [24, 16], &[0; 6]);
    write_film(&folder.path().join("b.y4m"), [24, 16], &[1; 6]);
    write_film(&folder.path().join("c.y4m"), [24, 16], &[2; 6]);
    folder
}

#[track_caller]
fn refused(folder: &Path, line: &str, parts: &[&str]) {
    assert_failure(&nullcone(folder, line.split_whitespace()), parts);
}

#[test]
fn gaps_overlaps_and_parts_of_other_work() {
    let folder = films();
    let folder = folder.path();
    for (frames, name) in [("0..2", 0), ("2..4", 1), ("4..6", 2), ("3..6", 3)] {
        let compare = "quality compare a.y4m b.y4m";
        run(
            folder,
            &format!("{compare} --frames {frames} --part {name}.json"),
        );
    }
    let merge = |parts: &str, words: &[&str]| {
        refused(folder, &format!("merge {parts} --out t.csv"), words);
        assert!(!folder.join("t.csv").exists());
    };
    run(folder, "merge 1.json 2.json 0.json --out v.json");
    merge("0.json 2.json", &["2..4", "2.json"]);
    merge("1.json 2.json", &["0..2", "1.json"]);
    merge("0.json 1.json", &["4..", "end"]);
    merge("0.json 1.json 3.json", &["1.json", "3.json", "3..4"]);

    run(
        folder,
        "quality compare a.y4m b.y4m --align-times --frames 4..6 --part option.json",
    );
    merge(
        "0.json 1.json option.json",
        &["option.json", "align-times", "false", "true"],
    );
    run(
        folder,
        "quality compare a.y4m c.y4m --frames 4..6 --part film.json",
    );
    merge(
        "0.json 1.json film.json",
        &["0.json", "film.json", "b.y4m", "c.y4m"],
    );
    // A film of the same name and size that has changed.
    std::fs::copy(folder.join("c.y4m"), folder.join("b.y4m")).unwrap();
    run(
        folder,
        "quality compare a.y4m b.y4m --frames 4..6 --part changed.json",
    );
    merge(
        "0.json 1.json changed.json",
        &["changed.json", "b.y4m", "another file"],
    );
}

#[test]
fn what_is_no_part_and_parts_of_other_versions() {
    let folder = films();
    let folder = folder.path();
    run(
        folder,
        "quality compare a.y4m b.y4m --frames 0.. --part all.json",
    );
    let part = std::fs::read_to_string(folder.join("all.json")).unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write("none.json", "{}");
    refused(
        folder,
        "merge none.json --out t.csv",
        &["none.json", "not a part"],
    );
    write(
        "later.json",
        &part.replace("\"nullcone_part\":1", "\"nullcone_part\":2"),
    );
    refused(
        folder,
        "merge later.json --out t.csv",
        &["later.json", "version 2"],
    );
    write("cut.json", &part[..part.len() / 2]);
    refused(folder, "merge cut.json --out t.csv", &["cut.json"]);
    let version = env!("CARGO_PKG_VERSION");
    write("old.json", &part.replace(version, "0.0.1"));
    refused(
        folder,
        "merge old.json all.json --out t.csv",
        &["0.0.1", version],
    );
    write(
        "other.json",
        &part.replace("quality compare", "quality fit"),
    );
    refused(folder, "merge other.json --out t.csv", &["quality fit"]);
    refused(folder, "merge a.y4m --out t.csv", &["a.y4m.json"]);
    refused(folder, "merge all.json --out t.png", &["t.png"]);
}

#[test]
fn frames_that_are_not_there() {
    let folder = films();
    let folder = folder.path();
    let compare = "quality compare a.y4m b.y4m";
    refused(
        folder,
        &format!("{compare} --frames 6..8 --part p.json"),
        &["6..8", "no such frame"],
    );
    let wrong = nullcone(
        folder,
        format!("{compare} --frames 3..3 --part p.json").split(' '),
    );
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("no frames"));
    // A film that breaks off gives no part.
    let bytes = std::fs::read(folder.join("b.y4m")).unwrap();
    std::fs::write(folder.join("b.y4m"), &bytes[..bytes.len() - 9]).unwrap();
    refused(
        folder,
        &format!("{compare} --frames 4..6 --part p.json"),
        &["b.y4m"],
    );
    assert_eq!(names(folder), ["a.y4m", "b.y4m", "c.y4m"]);
}

#[test]
fn films_of_other_kinds() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::fs::write(folder.join("m.obj"), cube).unwrap();
    let render = "render m.obj --size 16x12 --samples 1";
    refused(
        folder,
        &format!("{render} --turntable 4 --out f.png --frames 0..2"),
        &["f.png", "y4m"],
    );
    refused(
        folder,
        &format!("{render} --out f.y4m --frames 0..2"),
        &["--frames 0..2", "--film"],
    );
    refused(
        folder,
        &format!("{render} --turntable 4 --out f.y4m --frames 4..5"),
        &["4..5", "4"],
    );
    run(
        folder,
        &format!("{render} --turntable 4 --out f.y4m --frames 0..2"),
    );
    run(
        folder,
        &format!("{render} --turntable 4 --out g.y4m --frames 2..4"),
    );
    run(
        folder,
        &format!("{render} --turntable 4 --shading unlit --out h.y4m --frames 2..4"),
    );
    refused(
        folder,
        "merge f.y4m h.y4m --out w.y4m",
        &["f.y4m", "h.y4m", "shading", "unlit"],
    );
    // Patterns stand for films and what lies beside them.
    run(folder, "merge [fg].y4m* --out w.y4m");
    std::fs::write(folder.join("g.y4m"), b"YUV4MPEG2 W16 H12 F25:1\n").unwrap();
    refused(folder, "merge f.y4m g.y4m --out v.y4m", &["g.y4m", "bytes"]);
    assert!(!folder.join("v.y4m").exists());
}
