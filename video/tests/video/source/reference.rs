//! Videos as the program x264 encodes them, beside its own reconstruction of every frame.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ga_image::plane::Plane;
use ga_image::y4m::{self as film, Film};
use ga_video::ffmpeg::{self, FfmpegSource};
use ga_video::{Frame, Source, VideoError, open};
use nullcone_shared_data::shared;
use tempfile::TempDir;

use super::frames;

/// Columns and rows: no multiples of 16.
const SIZE: [usize; 2] = [150, 88];
const FRAMES: usize = 26;

/// Whether ffmpeg and x264 are installed; fails where they must be.
fn is_installed() -> bool {
    let x264 = Command::new("x264")
        .arg("--version")
        .stdout(Stdio::null())
        .status();
    let found = ffmpeg::is_installed() && x264.is_ok_and(|status| status.success());
    let required = std::env::var("NULLCONE_REQUIRE_FFMPEG").is_ok_and(|value| value == "1");
    assert!(
        found || !required,
        "NULLCONE_REQUIRE_FFMPEG=1, but ffmpeg or x264 is not installed"
    );
    found
}

/// A texture that moves and rotates behind a square that moves the other way, while all of it
/// becomes brighter: what weights and motion vectors of all kinds are for.
fn scene(frame: usize) -> Plane<[u8; 3]> {
    let time = frame as f64;
    let (sin, cos) = (0.01 * time).sin_cos();
    Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        let (x, y) = (column as f64, row as f64);
        let (u, v) = (
            cos * x - sin * y + 1.3 * time,
            sin * x + cos * y - 0.7 * time,
        );
        let square = (x - 20.0 - 3.0 * time).abs() < 14.0 && (y - 40.0).abs() < 14.0;
        let texture = (0.31 * u).sin() * (0.23 * v).cos() + 0.4 * (1.1 * u + 0.7 * v).sin();
        let light = 0.6 + 0.4 * (0.25 * time).sin();
        [0.0, 0.4, 0.9].map(|phase| match square {
            true => (60.0 + 4.0 * (y + phase * x) * light) as u8,
            false => (light * (120.0 + 70.0 * (texture + phase))) as u8,
        })
    })
}

fn run(program: &str, arguments: &[&str], folder: &Path) {
    let mut command = Command::new(program);
    command
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null());
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{program} {arguments:?}: {said}");
}

/// Encodes the scene with options of x264 as MP4 and Matroska; returns the folder, and the planes
/// of all frames as the encoder reconstructs them, one after another.
fn encoded(options: &str) -> (TempDir, Vec<u8>) {
    let folder = tempfile::tempdir().unwrap();
    let source = film::encode((0..FRAMES).map(scene), Film::default()).unwrap();
    std::fs::write(folder.path().join("scene.y4m"), source).unwrap();
    let words = options.split_whitespace();
    let rest = [
        "--quiet",
        "--dump-yuv",
        "truth.yuv",
        "-o",
        "clip.mkv",
        "scene.y4m",
    ];
    let arguments: Vec<&str> = words.chain(rest).collect();
    run("x264", &arguments, folder.path());
    let copy = ["-v", "error", "-i", "clip.mkv", "-c", "copy", "clip.mp4"];
    run("ffmpeg", &copy, folder.path());
    let truth = std::fs::read(folder.path().join("truth.yuv")).unwrap();
    (folder, truth)
}

/// The planes of all frames, one after another.
fn planes(source: &mut dyn Source) -> (Vec<u8>, Vec<Frame>) {
    let (found, end) = frames(source);
    assert!(end.is_ok(), "{end:?}");
    let mut bytes = Vec::new();
    for frame in &found {
        let planes = frame.samples.eight_bits();
        for plane in planes.as_array() {
            bytes.extend_from_slice(plane.values());
        }
    }
    (bytes, found)
}

/// Fails with the first frame that differs.
fn assert_equal(found: &[u8], truth: &[u8], options: &str) {
    let length = truth.len() / FRAMES;
    let pairs = found.chunks(length).zip(truth.chunks(length));
    let differ: Vec<usize> = pairs
        .enumerate()
        .filter(|(_, (a, b))| a != b)
        .map(|(frame, _)| frame)
        .collect();
    assert!(differ.is_empty(), "{options}: the frames {differ:?} differ");
    assert_eq!(found.len(), truth.len(), "{options}");
}

/// Fails where frames are not shown 25 times in a second.
fn assert_times(source: &dyn Source, shown: &[Frame], options: &str) {
    assert_eq!(source.properties().frames_per_second, Some([25, 1]));
    for (index, frame) in shown.iter().enumerate() {
        let expected = 0.04 * index as f64;
        assert!((frame.time_seconds - expected).abs() < 1e-9, "{options}");
    }
}

/// With each tool that encoders use, every sample of every frame is that of the encoder.
#[cfg(feature = "mp4")]
#[test]
fn what_is_decoded_here_is_what_the_encoder_reconstructs() {
    if !is_installed() {
        return;
    }
    for options in [
        "--preset medium",
        "--preset medium --no-cabac",
        "--preset medium --direct temporal",
        "--preset medium --direct temporal --no-cabac --bframes 5",
        "--preset medium --direct none",
        "--preset medium --no-weightb",
        "--preset placebo",
        "--preset veryslow --direct temporal --b-pyramid strict",
        "--preset slow --weightp 2 --bframes 0",
        "--profile baseline --preset slow",
        "--profile main --preset slow",
        "--profile main --preset slow --no-cabac --direct temporal",
        "--preset slow --no-8x8dct",
        "--preset slow --cqm jvt",
        "--preset slow --b-pyramid none --ref 16",
        "--preset slow --qp 24",
        "--preset slow --crf 45",
        "--preset slow --slices 3",
        "--preset slow --keyint 7 --open-gop",
        "--preset slow --constrained-intra",
        "--preset slow --intra-refresh",
        "--preset slow --deblock -3:2",
        "--preset slow --chroma-qp-offset 7",
        "--preset slow --partitions all --no-cabac",
        "--preset slow --range pc --colormatrix bt709",
    ] {
        let (folder, truth) = encoded(options);
        let source = ga_video::mp4::Mp4Source::open(folder.path().join("clip.mp4"));
        let mut source = source.unwrap_or_else(|error| panic!("{options}: {error}"));
        let (found, shown) = planes(&mut source);
        assert_equal(&found, &truth, options);
        assert_times(&source, &shown, options);
    }
}

/// What is not decoded exactly here is named, and left to ffmpeg.
#[test]
fn what_is_not_decoded_here_is_decoded_by_ffmpeg() {
    if !is_installed() {
        return;
    }
    for (options, problem) in [
        ("--preset medium --no-deblock", "deblocking filter"),
        ("--preset medium --qp 4", "deblocking filter"),
        ("--preset medium --qp 0", "without loss"),
        ("--preset medium --fake-interlaced", "interlaced"),
    ] {
        let (folder, truth) = encoded(options);
        for name in ["clip.mp4", "clip.mkv"] {
            let mut source = open(folder.path().join(name)).unwrap();
            let (found, shown) = planes(&mut source);
            assert_equal(&found, &truth, options);
            assert_times(&source, &shown, options);
        }
        #[cfg(feature = "mp4")]
        {
            let here = ga_video::mp4::Mp4Source::open(folder.path().join("clip.mp4"));
            let error = here.err().unwrap().to_string();
            assert!(error.contains(problem), "{options}: {error}");
        }
        let _ = problem;
    }
}

/// Rows of two moments are not taken for one picture.
#[test]
fn interlaced_videos_are_refused() {
    if !is_installed() {
        return;
    }
    let (folder, _) = encoded("--preset medium --tff");
    let error = open(folder.path().join("clip.mp4")).err();
    assert!(
        matches!(error, Some(VideoError::Interlaced { .. })),
        "{error:?}"
    );
}

/// Ten bits keep their numbers, here those of a video without loss.
#[test]
fn ten_bits_are_read_by_ffmpeg() {
    if !is_installed() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let source = film::encode((0..FRAMES).map(scene), Film::default()).unwrap();
    std::fs::write(folder.path().join("scene.y4m"), &source).unwrap();
    let encode = "-v error -i scene.y4m -pix_fmt yuv420p10le -c:v ffv1 clip.mkv";
    let words: Vec<&str> = encode.split(' ').collect();
    run("ffmpeg", &words, folder.path());
    let (found, end) = frames(&mut *open(folder.path().join("clip.mkv")).unwrap());
    assert!(end.is_ok(), "{end:?}");
    assert_eq!(found.len(), FRAMES);
    let mut expected = film::Reader::new(&source).unwrap();
    for frame in &found {
        let ga_video::Samples::Ten(planes) = &frame.samples else {
            panic!("not 10 bits");
        };
        let stored = expected.next().unwrap().unwrap();
        let here = planes.luma.map(|value| (value / 4) as u8);
        assert_eq!(here, stored.luma.map(|value| value));
    }
    // Of an alpha channel nothing is dropped in silence.
    run(
        "ffmpeg",
        &[
            "-v",
            "error",
            "-i",
            "scene.y4m",
            "-pix_fmt",
            "yuva420p",
            "-c:v",
            "ffv1",
            "alpha.mkv",
        ],
        folder.path(),
    );
    let error = open(folder.path().join("alpha.mkv")).err().unwrap();
    assert!(error.to_string().contains("yuva420p"), "{error}");
}

/// A broken file gives an error, and not pictures that were made up for it.
#[test]
fn ffmpeg_says_what_is_broken() {
    if !is_installed() {
        return;
    }
    let (folder, _) = encoded("--preset medium --no-deblock");
    let path = folder.path().join("clip.mkv");
    let mut bytes = std::fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    for byte in &mut bytes[middle..middle + 400] {
        *byte ^= 0x5a;
    }
    std::fs::write(&path, &bytes).unwrap();
    let end = open(&path).map(|mut source| frames(&mut source).1);
    assert!(!matches!(end, Ok(Ok(()))), "nothing is said");
    std::fs::write(&path, &bytes[..64]).unwrap();
    let error = open(&path).err().unwrap().to_string();
    assert!(error.contains("clip.mkv"), "{error}");
}

/// The case of a video whose header rotates it by 180°, beside what ffmpeg shows of it.
#[test]
fn videos_are_upright() {
    let (Some(stored), Some(upright)) = (
        shared("cases/video/rotation/rot180.mp4"),
        shared("cases/video/rotation/upright_by_ffmpeg.y4m.gz"),
    ) else {
        return;
    };
    if !is_installed() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let plain = folder.path().join("upright.y4m");
    let unpacked = Command::new("gzip")
        .arg("-dc")
        .arg(&upright)
        .output()
        .unwrap();
    std::fs::write(&plain, unpacked.stdout).unwrap();
    let (expected, _) = frames(&mut *open(&plain).unwrap());
    let (found, end) = frames(&mut *open(&stored).unwrap());
    assert!(end.is_ok());
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert!(found.samples == expected.samples, "frame {}", found.index);
    }
    // A rotation by 90° exchanges columns and rows.
    let sideways: PathBuf = folder.path().join("sideways.mp4");
    let (clip, truth) = encoded("--preset medium");
    let rotate = [
        "-v",
        "error",
        "-i",
        "clip.mp4",
        "-c",
        "copy",
        "-metadata:s:v:0",
        "rotate=90",
    ];
    let arguments: Vec<&str> = rotate
        .into_iter()
        .chain([sideways.to_str().unwrap()])
        .collect();
    run("ffmpeg", &arguments, clip.path());
    let mut source = open(&sideways).unwrap();
    assert_eq!(source.properties().size, [SIZE[1], SIZE[0]]);
    let mut frame = Frame::default();
    assert!(source.read(&mut frame).unwrap());
    let planes = frame.samples.eight_bits();
    let stored = |column: usize, row: usize| truth[row * SIZE[0] + column];
    for column in 0..SIZE[1] {
        for row in 0..SIZE[0] {
            // What ffmpeg writes is the matrix (0, −1; 1, 0): by 90° anticlockwise.
            let expected = stored(SIZE[0] - 1 - row, column);
            assert_eq!(
                planes.luma.get(column, row),
                Some(expected),
                "{column} {row}"
            );
        }
    }
}

/// The cases of files that were not read: fragments, an edit list of two parts, pictures that are
/// called interlaced and are not, and sound before pictures.
#[test]
fn the_cases_that_were_refused_are_read() {
    if !is_installed() {
        return;
    }
    // The pictures of the last begin 17 s after its sound, so that ffprobe does not say their kind.
    let cases = [
        ("mp4-refused/frag.mp4", 40),
        ("mp4-refused/twoedits.mp4", 40),
        ("mp4-refused/fakeinterlaced.mp4", 40),
        ("false-cut-occluder/hand.mp4", 58),
    ];
    for (name, count) in cases {
        let Some(path) = shared(&format!("cases/video/{name}")) else {
            return;
        };
        let (found, end) = frames(&mut FfmpegSource::open(&path).unwrap());
        assert!(end.is_ok(), "{name}: {end:?}");
        assert_eq!(found.len(), count, "{name}");
        assert!(
            found
                .windows(2)
                .all(|pair| pair[0].time_seconds < pair[1].time_seconds),
            "{name}"
        );
    }
}
