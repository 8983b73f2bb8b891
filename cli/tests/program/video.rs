//! `nullcone video`: clips whose cuts are known.

use std::path::Path;
use std::process::Stdio;

use ga_image::file;
use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use nullcone_shared_data::shared;
use serde_json::{Value, json};
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, number, program, text};

/// Three pictures for 30 frames each, at 25 frames in a second: stripes, checks, and rings from
/// which the camera moves away.
fn write_clip(path: &Path) {
    let frames = (0..90usize).map(|index| {
        Plane::from_fn(128, 72, |column, row| {
            let (x, y) = (column + 2 * (index % 30), row);
            let level = match index / 30 {
                0 => 60 + 120 * (column / 16 % 2),
                1 => 30 + 150 * ((column / 32 + row / 12) % 2),
                _ => 40 + (x * x + 3 * y * y) / 150 % 180,
            } as u8;
            [level, level / 2 + 40, 200 - level / 2]
        })
    });
    y4m::write(path, frames, Film::default()).unwrap();
}

fn json_of(folder: &Path, arguments: &[&str]) -> Value {
    let output = nullcone(folder, arguments);
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn key_frames_are_reported_and_written() {
    let folder = tempdir().unwrap();
    write_clip(&folder.path().join("clip.y4m"));
    let arguments = [
        "video",
        "keyframes",
        "clip.y4m",
        "--json",
        "--out",
        "keys",
        "--contact-sheet",
        "sheet.png",
        "--plot",
        "plot.svg",
        "--scenes",
        "scenes.csv",
        "--scenes",
        "scenes.edl",
        "--report",
        "report.html",
    ];
    let report = json_of(folder.path(), &arguments);
    let keys: Vec<&String> = report.as_object().unwrap().keys().collect();
    let expected = [
        "cuts",
        "dissolves",
        "fades",
        "flashes",
        "frames",
        "key_frames",
        "shots",
    ];
    let mut sorted = keys.clone();
    sorted.sort();
    assert_eq!(sorted, expected);
    assert_eq!(report["frames"], 90);
    assert_eq!(report["cuts"], json!([30, 60]));
    assert_eq!(report["dissolves"], json!([]));
    assert_eq!(report["fades"], json!([]));
    let shots = json!([
        {"start": 0, "end": 30, "background": "static"},
        {"start": 30, "end": 60, "background": "static"},
        {"start": 60, "end": 90, "background": "dynamic"},
    ]);
    assert_eq!(report["shots"], shots);
    let indices = report["key_frames"].as_array().unwrap().iter();
    let indices: Vec<u64> = indices.map(|key| key["index"].as_u64().unwrap()).collect();
    assert!(
        [0, 30, 60].iter().all(|index| indices.contains(index)),
        "{indices:?}"
    );
    assert!((number(&report, "/key_frames/1/time") - 1.2).abs() < 1e-9);
    assert_eq!(report["key_frames"][0]["reason"], "shot");

    let pictures = names(&folder.path().join("keys"));
    let expected: Vec<String> = indices
        .iter()
        .map(|i| format!("frame_{i:06}.png"))
        .collect();
    assert_eq!(pictures, expected);
    let picture = file::read(folder.path().join("keys/frame_000030.png")).unwrap();
    assert_eq!([picture.width(), picture.height()], [128, 72]);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(read("scenes.csv").lines().count(), 4);
    assert!(
        read("scenes.csv")
            .contains("\n2,30,60,00:00:01:05,00:00:02:10,30,static,1.200000,2.400000,25/1\n")
    );
    assert!(read("scenes.edl").contains("003  AX       V     C        00:00:02:10 00:00:03:15"));
    assert!(read("plot.svg").contains("mutual information"));
    let page = read("report.html");
    assert!(page.contains("<svg") && page.contains("data:image/png;base64,iVBOR"));
    assert!(page.contains("Cuts at frames 30, 60."));
    assert!(!page.contains("src=\"http"));
}

#[test]
fn timecodes_have_the_rate_and_the_start_that_are_given() {
    let folder = tempdir().unwrap();
    write_clip(&folder.path().join("clip.y4m"));
    let scenes = |options: &[&str]| {
        let arguments = ["video", "keyframes", "clip.y4m", "--scenes", "scenes.edl"];
        nullcone(folder.path(), [&arguments[..], options].concat())
    };
    let output = scenes(&["--rate", "29.97", "--start-timecode", "01:00:00;00"]);
    assert_success(&output);
    let list = std::fs::read_to_string(folder.path().join("scenes.edl")).unwrap();
    // 1.2 s and 2.4 s of 30000/1001 frames in a second.
    assert!(
        list.contains("FCM: DROP FRAME") && list.contains("30000/1001"),
        "{list}"
    );
    assert!(
        list.contains(" 01:00:01;06 01:00:02;12 01:00:01;06 01:00:02;12\n"),
        "{list}"
    );
    for (options, part) in [
        (["--rate", "none"], "--rate none"),
        (["--start-timecode", "01:00:00;00"], "25/1"),
    ] {
        assert_failure(&scenes(&options), &[part]);
    }
}

/// Every third frame of 24000/1001 is left out.
#[test]
fn a_varying_rate_is_counted_in_frames_of_its_times() {
    let Some(film) = shared("cases/video/vfr-edl/vfr.mp4") else {
        return;
    };
    let folder = tempdir().unwrap();
    let film = film.to_str().unwrap();
    let arguments = [
        "video",
        "keyframes",
        film,
        "--scenes",
        "scenes.edl",
        "--scenes",
        "scenes.csv",
    ];
    let output = nullcone(folder.path(), arguments);
    if !output.status.success() && text(&output.stderr).contains("mp4") {
        return;
    }
    assert_success(&output);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    // 8.758750 s are frame 210 of 24000/1001: 8 s of 24 frames and 18.
    assert!(
        read("scenes.edl").contains(" 00:00:08:18 "),
        "{}",
        read("scenes.edl")
    );
    assert!(
        read("scenes.csv").contains("8.758750"),
        "{}",
        read("scenes.csv")
    );
    assert!(read("scenes.csv").contains("24000/1001"));
}

#[test]
fn shots_are_split_to_the_frame() {
    let folder = tempdir().unwrap();
    write_clip(&folder.path().join("clip.y4m"));
    let run = |film: &str| {
        let arguments = ["video", "keyframes", film, "--split", "shots"];
        assert_success(&nullcone(folder.path(), arguments));
        names(&folder.path().join("shots"))
    };
    let films = run("clip.y4m");
    assert_eq!(films, ["shot_0001.y4m", "shot_0002.y4m", "shot_0003.y4m"]);
    let whole = std::fs::read(folder.path().join("clip.y4m")).unwrap();
    let second = std::fs::read(folder.path().join("shots/shot_0002.y4m")).unwrap();
    // The header, and the frames 30 to 60 of as many bytes each.
    let header = whole.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    let frame = (whole.len() - header) / 90;
    assert_eq!(
        second[header..],
        whole[header + 30 * frame..header + 60 * frame]
    );
    if !ga_video::ffmpeg::is_installed() {
        return;
    }
    std::fs::remove_dir_all(folder.path().join("shots")).unwrap();
    let mut command = std::process::Command::new("ffmpeg");
    command
        .current_dir(folder.path())
        .args(["-v", "error", "-i", "clip.y4m", "clip.mkv"]);
    assert!(command.status().unwrap().success());
    assert_eq!(
        run("clip.mkv"),
        ["shot_0001.mp4", "shot_0002.mp4", "shot_0003.mp4"]
    );
    for film in ["shot_0001.mp4", "shot_0002.mp4", "shot_0003.mp4"] {
        let film = folder.path().join("shots").join(film);
        let report = json_of(
            folder.path(),
            &["video", "keyframes", film.to_str().unwrap(), "--json"],
        );
        assert_eq!(
            (&report["frames"], &report["cuts"]),
            (&json!(30), &json!([]))
        );
    }
}

#[test]
fn standard_input_is_a_video_too() {
    let folder = tempdir().unwrap();
    let clip = folder.path().join("clip.y4m");
    write_clip(&clip);
    let mut command = program(folder.path());
    command.args([
        "video",
        "keyframes",
        "-",
        "--json",
        "--budget",
        "2",
        "--out",
        "keys",
    ]);
    command.stdin(Stdio::from(std::fs::File::open(&clip).unwrap()));
    let output = command.output().unwrap();
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["cuts"], json!([30, 60]));
    assert_eq!(report["key_frames"].as_array().unwrap().len(), 2);
    assert_eq!(names(&folder.path().join("keys")).len(), 2);
}

#[test]
fn cuts_are_scored_against_labels() {
    let folder = tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("found.json", "{\"cuts\": [10, 40, 70]}");
    write("labels.csv", "11\n40\n\n90\n100\n");
    let arguments = [
        "video",
        "score",
        "found.json",
        "labels.csv",
        "--tolerance",
        "1",
        "--json",
    ];
    let scores = json_of(folder.path(), &arguments);
    assert_eq!(
        [&scores["correct"], &scores["extra"], &scores["missed"]],
        [2, 1, 2]
    );
    assert!((number(&scores, "/precision") - 2.0 / 3.0).abs() < 1e-12);
    assert!((number(&scores, "/recall") - 0.5).abs() < 1e-12);
    assert!((number(&scores, "/f1") - 4.0 / 7.0).abs() < 1e-12);
    write("labels.csv", "11\nforty\n");
    let output = nullcone(folder.path(), &arguments[..4]);
    assert_failure(&output, &["labels.csv", "line 2", "forty"]);
    write("found.json", "{\"cuts\": [-1]}");
    let output = nullcone(folder.path(), &arguments[..4]);
    assert_failure(&output, &["found.json"]);
}

#[test]
fn shots_are_counted_over_clips() {
    let folder = tempdir().unwrap();
    for name in ["a.y4m", "b.y4m"] {
        write_clip(&folder.path().join(name));
    }
    let table = json_of(
        folder.path(),
        &["video", "statistics", "a.y4m", "b.y4m", "--json"],
    );
    assert_eq!(table["clips"][1]["file"], "b.y4m");
    assert_eq!(table["clips"][0]["shots"], 3);
    let total = &table["total"];
    assert_eq!(
        [&total["shots"], &total["static"], &total["dynamic"]],
        [6, 4, 2]
    );
    assert!((number(&table, "/total/static_proportion") - 2.0 / 3.0).abs() < 1e-12);
}

#[test]
fn a_truncated_clip_is_reported_as_far_as_it_goes() {
    let folder = tempdir().unwrap();
    let clip = folder.path().join("clip.y4m");
    write_clip(&clip);
    let bytes = std::fs::read(&clip).unwrap();
    let cut = bytes.len() / 2 + 100;
    std::fs::write(&clip, &bytes[..cut]).unwrap();
    let arguments = ["video", "keyframes", "clip.y4m", "--json", "--out", "keys"];
    let output = nullcone(folder.path(), arguments);
    assert_eq!(output.status.code(), Some(1));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["frames"], 45);
    assert_eq!(report["cuts"], json!([30]));
    assert!(
        text(&output.stderr).contains("frame 45"),
        "{}",
        text(&output.stderr)
    );
    assert!(!folder.path().join("keys").exists());
    std::fs::write(&clip, &bytes[..40]).unwrap();
    assert_failure(&nullcone(folder.path(), arguments), &["clip.y4m"]);
    let wrong = ["video", "keyframes", "clip.y4m", "--plot", "plot.png"];
    assert_failure(&nullcone(folder.path(), wrong), &["--plot", ".svg"]);
}

#[test]
fn statistics_of_the_clips_before_an_error_are_reported() {
    let folder = tempdir().unwrap();
    let [whole, cut] = ["a.y4m", "b.y4m"].map(|name| folder.path().join(name));
    write_clip(&whole);
    let bytes = std::fs::read(&whole).unwrap();
    std::fs::write(&cut, &bytes[..bytes.len() / 2 + 100]).unwrap();
    for (second, clips, frames) in [("b.y4m", 2, 135), ("absent.y4m", 1, 90)] {
        let arguments = ["video", "statistics", "a.y4m", second, "a.y4m", "--json"];
        let output = nullcone(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(1));
        let table: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(table["clips"].as_array().unwrap().len(), clips);
        assert_eq!(table["total"]["frames"], frames);
        let message = text(&output.stderr);
        assert!(message.contains(second), "{message}");
    }
    // Numbered pictures are one video, and a file that is named twice counts once.
    std::fs::create_dir(folder.path().join("row")).unwrap();
    for index in 0..30_usize {
        let picture = Plane::from_fn(64, 36, |column, row| {
            [(4 * column) as u8, (7 * row) as u8, 9]
        });
        file::write(folder.path().join(format!("row/{index}.png")), &picture).unwrap();
    }
    let arguments = [
        "video",
        "statistics",
        "row/*.png",
        "a.y4m",
        "*.y4m",
        "--json",
    ];
    std::fs::remove_file(&cut).unwrap();
    let table = json_of(folder.path(), &arguments);
    assert_eq!(table["clips"].as_array().unwrap().len(), 2, "{table}");
    assert_eq!(table["total"]["frames"], 120);
    let output = nullcone(
        folder.path(),
        ["video", "statistics", "absent.y4m", "--json"],
    );
    assert_failure(&output, &["absent.y4m"]);
}

#[test]
fn an_empty_clip_and_pictures_of_two_sizes_are_errors() {
    let folder = tempdir().unwrap();
    std::fs::write(
        folder.path().join("empty.y4m"),
        "YUV4MPEG2 W128 H72 F25:1\n",
    )
    .unwrap();
    let arguments = ["video", "keyframes", "empty.y4m", "--json", "--out", "keys"];
    assert_failure(&nullcone(folder.path(), arguments), &["empty.y4m"]);
    std::fs::create_dir(folder.path().join("row")).unwrap();
    for index in 0..6_usize {
        let size = if index < 4 { [40, 30] } else { [30, 40] };
        let picture = Plane::from_fn(size[0], size[1], |column, row| {
            [(5 * column) as u8, (5 * row) as u8, 90]
        });
        let path = folder.path().join(format!("row/{index:03}.png"));
        std::fs::write(path, ga_image::png::encode(&picture).unwrap()).unwrap();
    }
    let output = nullcone(
        folder.path(),
        ["video", "keyframes", "row", "--json", "--out", "keys"],
    );
    assert_eq!(output.status.code(), Some(1));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["frames"], 4);
    assert!(
        text(&output.stderr).contains("004.png"),
        "{}",
        text(&output.stderr)
    );
    assert!(!folder.path().join("keys").exists());
}

#[test]
fn odd_sizes_and_two_runs_are_the_same() {
    let folder = tempdir().unwrap();
    let frames = (0..30usize).map(|index| {
        Plane::from_fn(67, 41, |column, row| {
            let level = if index < 15 {
                3 * column
            } else {
                200 - 4 * row
            } as u8;
            [level, level, level]
        })
    });
    y4m::write(folder.path().join("odd.y4m"), frames, Film::default()).unwrap();
    let arguments = ["video", "keyframes", "odd.y4m", "--json"];
    let [first, second] = [0, 1].map(|_| nullcone(folder.path(), arguments));
    assert_success(&first);
    assert_eq!(first.stdout, second.stdout);
    let report: Value = serde_json::from_slice(&first.stdout).unwrap();
    assert_eq!(report["cuts"], json!([15]));
}

#[test]
fn the_oracle_has_two_cuts_and_a_dissolve() {
    let Some(clip) = shared("oracle/vision/seed1/cuts.y4m") else {
        return;
    };
    let folder = tempdir().unwrap();
    let arguments = ["video", "keyframes", clip.to_str().unwrap(), "--json"];
    let report = json_of(folder.path(), &arguments);
    assert_eq!(report["cuts"], json!([31, 38]));
    assert_eq!(report["dissolves"], json!([{"start": 66, "end": 74}]));
}
