//! `nullcone demo` as a whole: what it finds in its own pictures, measured anew by what these were
//! made of.

use std::path::{Path, PathBuf};

use ga_anim::gltf::Player;
use ga_files::table::Table;
use ga_runtime::cga3::Point;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{
    assert_failure, assert_success, names, nullcone, number, program, report, text,
};

const FRAMES: usize = 25;
const RATE: f64 = 25.0;

/// All files below a folder, with their names from there.
fn files(folder: &Path, below: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    for name in names(&folder.join(below)) {
        let path = below.join(name);
        if folder.join(&path).is_dir() {
            all.extend(files(folder, &path));
        } else {
            let bytes = std::fs::read(folder.join(&path)).unwrap();
            all.push((path, bytes));
        }
    }
    all
}

/// The mean distance of the joints of a table from those of the figure that was filmed, in metres.
fn mean_error(out: &Path) -> f64 {
    let document = ga_mesh::gltf::read(out.join("film/person.glb")).unwrap();
    let player = Player::new(&document).unwrap();
    let bytes = std::fs::read(out.join("person/joints.csv")).unwrap();
    let table = Table::with_names(&bytes).unwrap();
    assert_eq!(table.len(), FRAMES);
    let skin = &document.skins[0];
    let (mut sum, mut count) = (0.0, 0);
    for frame in 0..FRAMES {
        let pose = player.pose(Some(0), frame as f64 / RATE).unwrap();
        for &joint in &skin.joints {
            let name = document.nodes[joint].name.as_deref().unwrap();
            let place = ["x", "y", "z"].map(|axis| {
                let column = table.column(&format!("{name}_{axis}")).unwrap();
                table.number(frame, column).unwrap().unwrap()
            });
            let truth = pose.world[joint].transform(Point::default());
            sum += truth.distance(Point::from(place));
            count += 1;
        }
    }
    assert!(count > 20 * FRAMES);
    sum / count as f64
}

/// One run on all cores and one on a single one, which must be the same.
#[test]
fn everything_is_found_again_from_the_pictures_alone() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("demo");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let output = nullcone(&folder, ["demo"]);
    assert_success(&output);
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
    assert_eq!(names(&folder), ["out"]);
    let out = folder.join("out");
    let found = report(&out);

    // The cameras are 18 cm apart and have focal lengths of 1000 px; squares have sides of 6 cm.
    let calibrated = "/steps/calibration/values";
    let of_rig = |key: &str| number(&found, &format!("{calibrated}/{key}"));
    assert!((of_rig("baseline_metres") - 0.18).abs() < 0.001);
    assert!((of_rig("left/focal_px/0") - 1000.0).abs() < 5.0);
    assert!((of_rig("square_edge_mean_metres") - 0.06).abs() < 0.005 * 0.06);
    let error = mean_error(&out);
    assert!(error < 0.015, "{error} m");
    let stated = number(&found, "/scores/mean_per_joint_position_error_millimetres");
    assert!((1e3 * error - stated).abs() < 0.01, "{error} {stated}");
    assert!(number(&found, "/scores/aligned_error_millimetres") < 12.0);
    assert!(number(&found, "/steps/evaluation/values/bad_2") < 8.0);
    // The disc on the wall has a radius of 22 cm.
    let radius = number(&found, "/steps/contour/values/circle/radius_metres");
    assert!((radius - 0.22).abs() < 0.003, "{radius}");
    for (film, is_green) in [("comfort.json", false), ("aligned.json", true)] {
        let summary: Value =
            serde_json::from_slice(&std::fs::read(out.join(film)).unwrap()).unwrap();
        assert_eq!(summary["verdict"] == "good", is_green, "{film}");
    }

    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    for part in [
        "All five goals are reached",
        "57.20",
        "85.23",
        "27654",
        "16.8 s",
    ] {
        assert!(page.contains(part), "{part}");
    }
    // Nothing is loaded but the times.
    assert_eq!(page.matches("<script src=").count(), 1);
    assert!(page.contains("<script src=\"times.js\">"));
    let times = std::fs::read_to_string(out.join("times.js")).unwrap();
    assert!(times.contains("\"dots\""));

    let other = folder.join("other");
    std::fs::create_dir(&other).unwrap();
    let output = nullcone(
        &other,
        ["--quiet", "demo", "--threads", "1", "--out", "a/b"],
    );
    assert_success(&output);
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    let [one, several] = [other.join("a/b"), out].map(|folder| files(&folder, Path::new("")));
    assert_eq!(one.len(), several.len());
    for ((name, one), (same, several)) in one.iter().zip(&several) {
        assert_eq!(name, same);
        assert!(
            one == several || name == Path::new("times.js"),
            "{name:?} differs"
        );
    }
    std::fs::remove_dir_all(other).unwrap();
}

/// A signal while it works leaves nothing; neither does a place that cannot be written to.
#[test]
fn what_is_not_finished_leaves_nothing() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "kept").unwrap();
    assert_failure(
        &nullcone(folder.path(), ["demo", "--out", "file/below"]),
        &["file/below"],
    );
    assert_eq!(names(folder.path()), ["file"]);
    #[cfg(unix)]
    {
        let mut child = program(folder.path()).args(["-q", "demo"]).spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_secs(6));
        let interrupt = std::process::Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status();
        assert!(interrupt.unwrap().success());
        assert_eq!(child.wait().unwrap().code(), Some(130));
        assert_eq!(names(folder.path()), ["file"]);
    }
}
