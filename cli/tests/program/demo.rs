//! `nullcone demo`, run as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::sync::OnceLock;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{
    FILES, assert_failure, assert_success, contents, extent, heights, names, nullcone, number,
    program, report, text,
};

/// The output of one run for all tests that only look at it, and the folder it wrote.
fn demo() -> &'static (Output, PathBuf) {
    static DEMO: OnceLock<(Output, PathBuf)> = OnceLock::new();
    DEMO.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("demo");
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        let output = nullcone(&folder, ["demo"]);
        assert_success(&output);
        (output, folder.join("out"))
    })
}

#[test]
fn it_writes_four_files_and_says_so() {
    let (output, out) = demo();
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
    assert_eq!(names(out), FILES);
    for name in FILES {
        assert!(text(&output.stdout).contains(name));
    }
    let report = report(out);
    for (index, name) in ["model.obj", "model.glb", "sheet.png"].iter().enumerate() {
        let file = &report["files"][index];
        assert_eq!(file["name"], *name);
        let bytes = std::fs::metadata(out.join(name)).unwrap().len();
        assert_eq!(file["bytes"].as_u64(), Some(bytes));
    }
    let sheet = image::open(out.join("sheet.png")).unwrap();
    assert_eq!(
        number(&report, "/files/2/pixels/0"),
        f64::from(sheet.width())
    );
    assert_eq!(
        number(&report, "/files/2/pixels/1"),
        f64::from(sheet.height())
    );
}

#[test]
fn the_person_is_whole_and_upright() {
    let (_, out) = demo();
    let report = report(out);
    let heights = heights(&std::fs::read_to_string(out.join("model.obj")).unwrap());
    assert_eq!(number(&report, "/figure/vertices"), heights.len() as f64);
    assert!((number(&report, "/figure/height_metres") - extent(&heights)).abs() < 1e-12);
    assert!((1.7..1.8).contains(&extent(&heights)));

    let checks = |name: &str| number(&report, &format!("/animation/checks/{name}"));
    assert!(checks("bone_length_deviation_max_metres") < 1e-12);
    assert!(checks("lowest_vertex_min_metres") > -0.01);
    assert!(checks("lowest_vertex_max_metres") < 0.01);
    assert!(checks("trunk_from_upright_max_degrees") < 5.0);
    assert!(checks("linear_to_motor_blend_max_metres") < 0.02);
    assert!(checks("linear_to_motor_blend_mean_metres") > 0.0);
}

#[test]
fn the_model_walks_one_way_in_a_viewer() {
    let (_, out) = demo();
    let report = report(out);
    let (document, buffers, _) = gltf::import(out.join("model.glb")).unwrap();
    let skin = document.skins().next().unwrap();
    assert_eq!(
        skin.joints().count() as f64,
        number(&report, "/figure/joints")
    );
    let animation = document.animations().next().unwrap();
    let hips = animation.channels().find_map(|channel| {
        if channel.target().node().name() != Some("Hips") {
            return None;
        }
        let reader = channel.reader(|buffer| Some(&buffers[buffer.index()]));
        let times: Vec<f32> = reader.read_inputs()?.collect();
        match reader.read_outputs()? {
            gltf::animation::util::ReadOutputs::Translations(places) => {
                Some((times, places.collect::<Vec<_>>()))
            }
            _ => None,
        }
    });
    let (times, places) = hips.expect("the hips move");
    let duration = number(&report, "/animation/duration_seconds");
    assert!((f64::from(*times.last().unwrap()) - duration).abs() < 1e-5);
    assert_eq!(times.len() as f64, number(&report, "/animation/frames"));
    assert!(places.windows(2).all(|pair| pair[1][2] > pair[0][2]));
    // People walk at 1.2 to 1.5 metres a second.
    let way = f64::from(places.last().unwrap()[2] - places[0][2]);
    assert!(
        (1.0..1.6).contains(&(way / duration)),
        "{way} m in {duration} s"
    );
}

fn joint_error(report: &Value, which: &str) -> f64 {
    number(
        report,
        &format!("/two_views/{which}/mean_per_joint_position_error_metres"),
    )
}

#[test]
fn two_cameras_find_the_joints() {
    let report = report(&demo().1);
    assert!(joint_error(&report, "noise_free") <= 1e-9);

    // A pixel is s = D/f metres at the distance D. Two rays at the angle α to either side of the
    // axis between the cameras, each shifted across by independent noise of standard deviation s,
    // cross with these deviations in depth, aside and in height.
    let place = |name: &str| -> [f64; 3] {
        serde_json::from_value(report["two_views"][name].clone()).unwrap()
    };
    let (eye, target) = (place("left_camera_metres"), place("target_metres"));
    let distance = (0..3)
        .map(|k| (eye[k] - target[k]).powi(2))
        .sum::<f64>()
        .sqrt();
    let s = distance / number(&report, "/two_views/focal_length_pixels");
    let alpha = 0.5 * number(&report, "/two_views/angle_degrees").to_radians();
    let depth = s / (2f64.sqrt() * alpha.sin());
    let aside = s / (2f64.sqrt() * alpha.cos());
    let height = s / 2f64.sqrt();
    // Not less than the mean of the error in depth alone, not more than the root of the mean square
    // of all; 5 % for the joints' distances.
    let least = depth * (2.0 / std::f64::consts::PI).sqrt();
    let most = (depth * depth + aside * aside + height * height).sqrt();
    let found = joint_error(&report, "one_pixel_noise");
    assert!(
        found > 0.95 * least && found < 1.05 * most,
        "{least} {found} {most}"
    );
    for which in ["noise_free", "one_pixel_noise"] {
        let found = &report["two_views"][which];
        assert_eq!(found["all_in_front_of_both_cameras"], true);
        assert_eq!(found["all_inside_both_pictures"], true);
    }
}

#[test]
fn a_second_run_writes_the_same_bytes_on_any_number_of_threads_and_is_quiet_if_asked() {
    let folder = tempdir().unwrap();
    let mut command = program(folder.path());
    command
        .args(["--quiet", "demo", "--out", "a/b"])
        .env("RAYON_NUM_THREADS", "1");
    let output = command.output().unwrap();
    assert_success(&output);
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    let (first, second) = (contents(&demo().1), contents(&folder.path().join("a/b")));
    assert_eq!(first.len(), second.len());
    for (a, b) in first.iter().zip(&second) {
        assert!(a == b, "{} differs", a.0);
    }
}

#[test]
fn another_seed_is_other_noise_and_standard_output_may_be_closed() {
    let folder = tempdir().unwrap();
    let mut command = program(folder.path());
    command.args(["demo", "--seed", "2"]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_success(&output);
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));

    let [one, two] = [&demo().1, &folder.path().join("out")].map(|out| report(out));
    assert_eq!(
        joint_error(&one, "noise_free"),
        joint_error(&two, "noise_free")
    );
    assert_ne!(
        joint_error(&one, "one_pixel_noise"),
        joint_error(&two, "one_pixel_noise")
    );
}

#[test]
fn what_cannot_be_written_leaves_everything_as_it_was() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "kept").unwrap();
    assert_failure(
        &nullcone(folder.path(), ["demo", "--out", "file"]),
        &["cannot make the folder file"],
    );
    assert_failure(
        &nullcone(folder.path(), ["demo", "--out", "file/below"]),
        &["cannot make the folder file/below"],
    );
    assert_eq!(names(folder.path()), ["file"]);

    let out = folder.path().join("out");
    std::fs::create_dir_all(out.join("report.json")).unwrap();
    std::fs::write(out.join("model.obj"), "kept").unwrap();
    assert_failure(
        &nullcone(folder.path(), ["demo"]),
        &["cannot write out/report.json", "a folder of that name"],
    );
    assert_eq!(names(&out), ["model.obj", "report.json"]);
    assert_eq!(std::fs::read(out.join("model.obj")).unwrap(), b"kept");
}

#[test]
fn wrong_usage_has_a_status_of_its_own() {
    let folder = tempdir().unwrap();
    for arguments in [&[][..], &["dance"], &["demo", "--seed", "x"], &["animate"]] {
        let output = nullcone(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(!output.stderr.is_empty());
    }
    for arguments in [&["--help"][..], &["--version"], &["animate", "--help"]] {
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        assert!(text(&output.stdout).contains("nullcone"));
    }
    assert!(names(folder.path()).is_empty());
}
