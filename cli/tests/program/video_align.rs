//! `nullcone video align`: what is written, and what is refused.

use std::path::Path;

use ga_image::plane::Plane;
use ga_image::y4m::{Film, Sampling, Stream, Writer};
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, nullcone, text};

const SIZE: [usize; 2] = [240, 136];

/// A view of random blocks that moves, lower and brighter by given amounts, in codes of 10 bits.
fn view(frame: usize, lower: usize, brighter: u16) -> [Plane<u16>; 3] {
    let moved = [0, 3, 8, 9, 4, 1, 2, 7][frame % 8];
    let code = |u: usize, v: usize| {
        let block = ((u + 2 * moved) / 5 + 1) * 7919 + ((v + 40 + moved - lower) / 5 + 1) * 104_729;
        200 + (block * block / 977 % 560) as u16
    };
    let [width, height] = SIZE;
    let difference = Plane::from_fn(width / 2, height, |u, v| 300 + code(2 * u, v) / 2);
    let luma = Plane::from_fn(width, height, |u, v| code(u, v) + brighter);
    [luma, difference.clone(), difference]
}

/// Views with 10 bits and 4:2:2, at 30 000/1001 frames in a second.
fn write(path: &Path, frames: usize, planes: impl Fn(usize) -> [Plane<u16>; 3]) {
    let film = Film {
        frames_per_second: [30_000, 1001],
        sampling: Sampling::Half,
        ..Film::default()
    };
    let file = std::fs::File::create(path).unwrap();
    let size = [planes(0)[0].width(), planes(0)[0].height()];
    let mut writer = Writer::new(file, size, 10, film).unwrap();
    for frame in 0..frames {
        writer.write(planes(frame).each_ref()).unwrap();
    }
}

fn stacked([left, right]: [[Plane<u16>; 3]; 2]) -> [Plane<u16>; 3] {
    std::array::from_fn(|k| {
        let (above, below) = (&left[k], &right[k]);
        Plane::from_fn(above.width(), 2 * above.height(), |column, row| {
            let height = above.height();
            let plane = if row < height { above } else { below };
            plane.row(row % height)[column]
        })
    })
}

/// The size, the rate, and the frames of a film of 10 bits and 4:2:2.
fn read(path: &Path) -> ([usize; 2], [u32; 2], Vec<[Plane<u16>; 3]>) {
    let mut stream = Stream::new(std::fs::File::open(path).unwrap()).unwrap();
    let header = *stream.header();
    assert_eq!(
        (header.bit_depth, header.film.sampling),
        (10, Sampling::Half)
    );
    let mut frames = Vec::new();
    let mut planes = [(); 3].map(|()| Plane::default());
    while stream.read(planes.each_mut()).unwrap() {
        frames.push(planes.clone());
    }
    (header.size, header.film.frames_per_second, frames)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn depth_sampling_rate_and_layout_stay() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    write(&path("film.y4m"), 5, |i| {
        stacked([view(i, 0, 0), view(i, 3, 60)])
    });
    let align = |more: &[&str]| {
        let all = [&["video", "align"], more].concat();
        nullcone(folder.path(), &all)
    };
    let output = align(&["film.y4m", "--layout", "top-bottom", "--out", "aligned.y4m"]);
    assert_success(&output);
    assert!(text(&output.stdout).contains("5 frames; views exchanged in 0"));
    // Y4M has no sound that could be lost.
    assert!(!text(&output.stderr).contains("sound"));
    let (size, rate, frames) = read(&path("aligned.y4m"));
    assert_eq!((size, rate, frames.len()), ([240, 272], [30_000, 1001], 5));
    for (index, frame) in frames.iter().enumerate() {
        let truth = view(index, 0, 0);
        for (plane, left) in frame.iter().zip(&truth) {
            let half = plane.height() / 2;
            for row in 0..half {
                assert_eq!(plane.row(row), left.row(row), "the left view stays");
            }
            // The border that the right view did not show is below.
            for row in 8..half - 8 {
                for (found, expected) in plane.row(half + row).iter().zip(left.row(row)).skip(8) {
                    assert!(
                        found.abs_diff(*expected) <= 4,
                        "{index} {row}: {found} {expected}"
                    );
                }
            }
        }
    }

    // Two files make a film side by side, and the same frames.
    write(&path("left.y4m"), 5, |i| view(i, 0, 0));
    write(&path("right.y4m"), 5, |i| view(i, 3, 60));
    assert_success(&align(&["left.y4m", "right.y4m", "--out", "pair.y4m"]));
    let (size, _, pair) = read(&path("pair.y4m"));
    assert_eq!((size, pair.len()), ([480, 136], 5));
    assert_eq!(pair[2][0].row(60)[240..], *frames[2][0].row(136 + 60));

    // The result has nothing more to be removed.
    let again = align(&["pair.y4m", "--out", "again.y4m", "--quiet"]);
    assert_success(&again);
    assert!(again.stdout.is_empty());
    assert_eq!(read(&path("again.y4m")).2, pair);
    let measured = nullcone(
        folder.path(),
        [
            "video",
            "comfort",
            "pair.y4m",
            "--layout",
            "side-by-side",
            "--json",
        ],
    );
    for line in text(&measured.stdout).lines() {
        let line: Value = serde_json::from_str(line).unwrap();
        for row in ["brightness", "colour", "vertical"] {
            assert!(
                line["rows"][row]["score"].as_u64() <= Some(7),
                "{row}: {line}"
            );
        }
    }
}

#[test]
fn nothing_is_written_after_an_error() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    write(&path("left.y4m"), 4, |i| view(i, 0, 0));
    write(&path("right.y4m"), 4, |i| view(i, 2, 0));
    write(&path("short.y4m"), 3, |i| view(i, 2, 0));
    let mut bytes = std::fs::read(path("right.y4m")).unwrap();
    bytes.truncate(bytes.len() - 700);
    std::fs::write(path("cut.y4m"), bytes).unwrap();
    let before = names(folder.path());
    let left = std::fs::read(path("left.y4m")).unwrap();
    for (arguments, message) in [
        (
            &["left.y4m", "cut.y4m", "--out", "a.y4m"][..],
            "within frame 3",
        ),
        (&["left.y4m", "short.y4m", "--out", "a.y4m"], "no frame 3"),
        (&["left.y4m", "none.y4m", "--out", "a.y4m"], "none.y4m"),
        (
            &["left.y4m", "right.y4m", "--out", "left.y4m/a.y4m"],
            "cannot write left.y4m/a.y4m",
        ),
        (
            &["left.y4m", "right.y4m", "--out", "a.mp4"],
            "must end in .y4m",
        ),
        (
            &["left.y4m", "right.y4m", "--out", "left.y4m"],
            "--out left.y4m: it is the input left.y4m",
        ),
        (
            &["left.y4m", "right.y4m", "--out", "./right.y4m"],
            "it is the input right.y4m",
        ),
        (&["left.y4m", "-", "--out", "a.y4m"], "read twice"),
        (
            &["left.y4m", "--layout", "two-files", "--out", "a.y4m"],
            "the right view",
        ),
    ] {
        let all = [&["video", "align"], arguments].concat();
        let output = nullcone(folder.path(), &all);
        assert_failure(&output, &[message]);
        assert_eq!(names(folder.path()), before, "{arguments:?}");
    }
    assert_eq!(std::fs::read(path("left.y4m")).unwrap(), left);
}

fn header(path: &Path) -> String {
    let bytes = std::fs::read(path).unwrap();
    let end = bytes.iter().position(|byte| *byte == b'\n').unwrap();
    String::from_utf8(bytes[..end].to_vec()).unwrap()
}

/// The shape of pixels is that of the input, and so is the layout.
#[test]
fn half_views_keep_their_layout_and_shape() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    write(&path("film.y4m"), 3, |i| {
        stacked([view(i, 0, 0), view(i, 3, 0)])
    });
    let mut bytes = std::fs::read(path("film.y4m")).unwrap();
    let place = bytes.windows(4).position(|part| part == b"A1:1").unwrap();
    bytes[place..place + 4].copy_from_slice(b"A2:1");
    std::fs::write(path("wide.y4m"), bytes).unwrap();
    for (name, layout, aspect) in [
        ("film.y4m", "half-top-bottom", " A1:1 "),
        ("wide.y4m", "half-tab", " A2:1 "),
        ("wide.y4m", "top-bottom", " A2:1 "),
    ] {
        let align = [
            "video", "align", name, "--layout", layout, "--out", "out.y4m",
        ];
        let output = nullcone(folder.path(), align);
        assert_success(&output);
        let header = header(&path("out.y4m"));
        assert!(header.contains(aspect), "{header}");
        let next = format!("--layout {}", layout.replace("half-tab", "half-top-bottom"));
        assert!(text(&output.stdout).contains(&next));
        // 240 × 136 pixels of a view are usual, and so are squeezed ones of twice the width.
        let is_doubted = text(&output.stderr).contains("is it top-bottom?");
        assert_eq!(is_doubted, name == "film.y4m", "{}", text(&output.stderr));
    }
}

#[test]
fn parallax_is_shifted_by_an_angle() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    write(&path("film.y4m"), 3, |i| {
        stacked([view(i, 0, 0), view(i, 0, 0)])
    });
    let align = |shift: &str| {
        nullcone(
            folder.path(),
            [
                "video",
                "align",
                "film.y4m",
                "--layout",
                "top-bottom",
                "--out",
                "out.y4m",
                "--json",
                "--shift-parallax",
                shift,
            ],
        )
    };
    let output = align("-0.85");
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    // A degree is 2.94 % of the width before the usual screen: 6 of 240 columns.
    let percent = report["shift_parallax_percent"].as_f64().unwrap();
    assert!((percent + 2.5).abs() < 0.03, "{report}");
    let (_, _, frames) = read(&path("out.y4m"));
    let luma = &frames[1][0];
    for row in 20..110 {
        for column in 20..220 {
            let [left, right] = [luma.row(row)[column], luma.row(136 + row)[column - 6]];
            // Steps of blocks are interpolated where the shift is not whole.
            assert!(left.abs_diff(right) < 40, "{column} {row}: {left} {right}");
        }
    }
    // Views without depth are comfortable as they are.
    let report: Value = serde_json::from_slice(&align("recommended").stdout).unwrap();
    assert_eq!(report["shift_parallax_percent"], 0.0);
    for bad in ["back", "9", "nan"] {
        assert_eq!(align(bad).status.code(), Some(2), "{bad}");
    }
}

/// A film of MP4 may have sound, which Y4M cannot hold; and no frame of this one shows which eye is
/// which.
#[cfg(feature = "mp4")]
#[test]
fn what_is_lost_or_not_decided_is_said() {
    let folder = tempdir().unwrap();
    let Some(film) = nullcone_shared_data::shared("cases/video/align-swap-frame/swapped.mp4")
    else {
        return;
    };
    let film = film.to_str().unwrap();
    let output = nullcone(
        folder.path(),
        ["video", "align", film, "--out", "out.y4m", "--json"],
    );
    assert_success(&output);
    let error = text(&output.stderr);
    assert!(
        error.contains("Y4M has no sound, so that it is not kept"),
        "{error}"
    );
    assert!(error.contains(&format!("ffmpeg -i out.y4m -i {film} -map 0:v -map 1:a")));
    let words = "the order of the eyes could not be decided in frames 0 to 7";
    assert!(error.contains(words), "{error}");
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&report["undecided_frames"], &report["exchanged_frames"]),
        (&8.into(), &0.into())
    );
    assert!(report["warnings"].to_string().contains(words), "{report}");
    let comfort = |more: &[&str]| {
        let all = [
            &["video", "comfort", film, "--layout", "side-by-side"],
            more,
        ]
        .concat();
        nullcone(folder.path(), all)
    };
    let words = "The order of the eyes could not be decided in frames 0 to 7";
    assert!(text(&comfort(&[]).stdout).contains(words));
    let lines = comfort(&["--json", "--summary", "summary.json"]);
    assert!(
        text(&lines.stdout).contains("\"reason\":\"the pictures do not show which eye is which\"")
    );
    let summary = std::fs::read_to_string(folder.path().join("summary.json")).unwrap();
    assert!(summary.contains(words));
}
