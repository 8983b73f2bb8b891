//! `nullcone draw`: what it writes, and how it tells what is wrong.

use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

const SCENE: &str =
    r#"{"title": "S", "elements": [{"name": "S", "sphere": {"centre": [0, 0, 0], "radius": 1}}]}"#;

#[test]
fn a_picture_and_a_page() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("scene.json"), SCENE).unwrap();
    for (out, begin) in [("a/s.svg", "<svg "), ("s.html", "<!DOCTYPE html>")] {
        let output = nullcone(folder.path(), ["draw", "scene.json", "--out", out]);
        assert_success(&output);
        assert_eq!(text(&output.stdout), format!("wrote {out}\n"));
        let written = std::fs::read_to_string(folder.path().join(out)).unwrap();
        assert!(written.starts_with(begin));
        // Nothing is said on request, and the same is written again.
        let output = nullcone(folder.path(), ["draw", "scene.json", "--out", out, "-q"]);
        assert!(output.stdout.is_empty());
        assert_eq!(
            std::fs::read_to_string(folder.path().join(out)).unwrap(),
            written
        );
    }
}

#[test]
fn bad_input_leaves_nothing() {
    let folder = tempdir().unwrap();
    let fails = |scene: &str, out: &str, parts: &[&str]| {
        std::fs::write(folder.path().join("scene.json"), scene).unwrap();
        let output = nullcone(folder.path(), ["draw", "scene.json", "--out", out]);
        assert_failure(&output, parts);
        assert_eq!(names(folder.path()), ["scene.json"]);
    };
    fails(SCENE, "s.png", &["--out s.png", ".svg, .html or .htm"]);
    fails(
        "{\n\"element\": []}",
        "s.svg",
        &["scene.json: unknown field `element`", "line 2"],
    );
    let radius = SCENE.replace("\"radius\": 1", "\"radius\": -2");
    fails(
        &radius,
        "new/s.html",
        &["scene.json: element 0 (`S`): `radius` is -2"],
    );
    let output = nullcone(folder.path(), ["draw", "nowhere.json", "--out", "s.svg"]);
    assert_failure(&output, &["cannot read nowhere.json: "]);
}
