//! `nullcone stereo match` and `evaluate`: disparities, and how far they are from the truth.

use std::path::Path;

use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

/// The bytes of a PFM file with these numbers, whose first is that of the top left pixel.
fn pfm(width: usize, values: &[f32]) -> Vec<u8> {
    let mut bytes = format!("Pf\n{width} {}\n-1.0\n", values.len() / width).into_bytes();
    let rows = values.chunks(width).rev().flatten();
    bytes.extend(rows.flat_map(|value| value.to_le_bytes()));
    bytes
}

/// A map of six pixels, and truths as PFM and as PGM with four times the disparity.
fn maps() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("d.pfm", &pfm(3, &[5.0, 5.0, 5.0, f32::INFINITY, 5.0, 5.0]));
    write(
        "truth.pfm",
        &pfm(3, &[4.5, 7.0, 8.25, 5.0, 0.0, f32::INFINITY]),
    );
    write("truth.pgm", b"P5 3 2 255\n\x12\x1c\x21\x14\0\0");
    folder
}

#[test]
fn evaluate_prints_the_measures() {
    let folder = maps();
    for truth in [&["truth.pfm"][..], &["truth.pgm", "--scale", "4"]] {
        let arguments = [&["stereo", "evaluate", "d.pfm", "--json"], truth].concat();
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        for (key, expected) in [
            ("/bad_0_5", 75.0),
            ("/bad_1", 75.0),
            ("/bad_2", 50.0),
            ("/bad_3", 50.0),
            ("/d1", 50.0),
            ("/average_px", (0.5 + 2.0 + 3.25) / 3.0),
            ("/density", 75.0),
            ("/truth_pixels", 4.0),
        ] {
            assert_eq!(number(&report, key), expected, "{key}");
        }
    }
    let output = nullcone(folder.path(), ["stereo", "evaluate", "d.pfm", "truth.pfm"]);
    assert_success(&output);
    let table = text(&output.stdout);
    assert!(table.contains("bad 2      50.000 %\n"), "{table}");
    assert!(table.contains("75.000 % of 4 pixels with truth"), "{table}");
}

/// Maps and truths as KITTI stores them, those with the line ends of Windows, and masks.
#[test]
fn evaluate_takes_maps_of_every_format_and_masks() {
    let folder = maps();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    let deep = |name: &str, values: [u16; 6]| {
        let picture = ga_image::plane::Plane::from_values(3, 2, values.to_vec()).unwrap();
        write(name, &ga_image::png::encode(&picture).unwrap());
    };
    deep("d.png", [1280, 1280, 1280, 0, 1280, 1280]);
    deep("truth.png", [1152, 1792, 2112, 1280, 0, 0]);
    deep("visible.png", [1152, 1792, 0, 0, 0, 0]);
    let lines = std::fs::read(folder.path().join("d.pfm")).unwrap();
    let header = b"Pf\n3 2\n-1.0\n";
    let data = &lines[header.len()..];
    write("windows.pfm", &[b"Pf\r\n3 2\r\n-1.0\r\n", data].concat());
    write("mask.pgm", b"P5 3 2 255\n\xff\xff\x80\x80\0\0");
    let evaluate = |map: &str, truth: &str, more: &[&str]| -> Value {
        let arguments = [&["stereo", "evaluate", map, truth, "--json"], more].concat();
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let expected = evaluate("d.pfm", "truth.pfm", &[]);
    assert!(expected["visible"].is_null() && expected["occluded"].is_null());
    for map in ["d.pfm", "d.png", "windows.pfm"] {
        for (truth, more) in [
            ("truth.png", &[][..]),
            ("truth.png", &["--scale", "256"]),
            ("truth.pfm", &[]),
        ] {
            assert_eq!(
                evaluate(map, truth, more),
                expected,
                "{map} {truth} {more:?}"
            );
        }
    }
    let halved = evaluate("d.png", "truth.png", &["--map-scale", "512"]);
    assert_eq!(number(&halved, "/average_px"), (2.0 + 4.5 + 5.75) / 3.0);
    for more in [["--mask", "mask.pgm"], ["--visible", "visible.png"]] {
        let found = evaluate("d.png", "truth.png", &more);
        assert_eq!(found["truth_pixels"], 4);
        assert_eq!(number(&found, "/visible/average_px"), 1.25, "{found}");
        assert_eq!(number(&found, "/occluded/d1"), 100.0, "{found}");
    }
}

#[test]
fn evaluate_draws_map_truth_and_errors() {
    let folder = maps();
    let arguments = [
        "stereo",
        "evaluate",
        "d.pfm",
        "truth.pfm",
        "--picture",
        "new/e.png",
        "-q",
    ];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    assert!(output.stdout.is_empty());
    let picture = image::open(folder.path().join("new/e.png"))
        .unwrap()
        .to_rgb8();
    assert!(picture.width() > 900 && picture.height() > 60);
}

/// Two views of random texture, the right one with everything 5 px further left, and 9 px in the
/// square from 30 to 60 of both axes.
fn views(folder: &Path) {
    // A multiplication alone would give levels that rise by a constant from pixel to pixel.
    let noise = |u: usize, v: usize| {
        let mut mixed = (u as u64) << 32 | v as u64;
        for _ in 0..2 {
            mixed = (mixed ^ mixed >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93);
        }
        (mixed >> 56) as u8
    };
    let square = |u: usize, v: usize| (30..60).contains(&u) && (30..60).contains(&v);
    let write = |name: &str, level: &dyn Fn(usize, usize) -> u8| {
        let picture =
            image::GrayImage::from_fn(120, 90, |u, v| image::Luma([level(u as usize, v as usize)]));
        picture.save(folder.join(name)).unwrap();
    };
    write("left.png", &|u, v| {
        noise(u + if square(u, v) { 1000 } else { 0 }, v)
    });
    write("right.png", &|u, v| match square(u + 9, v) {
        true => noise(u + 1009, v),
        false => noise(u + 5, v),
    });
}

#[test]
fn match_writes_the_disparities_it_finds() {
    let folder = tempdir().unwrap();
    views(folder.path());
    let mut maps = Vec::new();
    for (mode, threads) in [
        ("fast", "1"),
        ("balanced", "1"),
        ("balanced", "3"),
        ("best", "2"),
    ] {
        let output = nullcone(
            folder.path(),
            [
                "stereo",
                "match",
                "left.png",
                "right.png",
                "--max-disparity",
                "16",
                "--mode",
                mode,
                "--threads",
                threads,
                "--out",
                "new/d.pfm",
                "--confidence",
                "c.png",
                "--picture",
                "d.png",
                "--json",
            ],
        );
        assert_success(&output);
        assert!(output.stderr.is_empty());
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["mode"], mode);
        assert_eq!(number(&report, "/width_px"), 120.0);
        assert_eq!(number(&report, "/height_px"), 90.0);
        assert_eq!(number(&report, "/max_disparity_px"), 16.0);
        assert_eq!(number(&report, "/density"), 100.0);
        assert!(number(&report, "/least_px") >= 0.0 && number(&report, "/greatest_px") < 16.0);
        assert!((0.1..=1.0).contains(&number(&report, "/mean_confidence")));

        let bytes = std::fs::read(folder.path().join("new/d.pfm")).unwrap();
        let header = b"Pf\n120 90\n-1.0\n";
        assert_eq!(bytes[..header.len()], header[..]);
        let at = |u: usize, v: usize| {
            let place = header.len() + 4 * ((89 - v) * 120 + u);
            f32::from_le_bytes(bytes[place..place + 4].try_into().unwrap())
        };
        for (u, v, expected) in [(100, 20, 5.0), (45, 45, 9.0), (35, 55, 9.0), (45, 75, 5.0)] {
            assert!(
                (at(u, v) - expected).abs() < 0.2,
                "{mode}: {} at {u}, {v}",
                at(u, v)
            );
        }
        let confidence = image::open(folder.path().join("c.png")).unwrap();
        assert_eq!((confidence.width(), confidence.height()), (120, 90));
        assert_eq!(confidence.color(), image::ColorType::L8);
        assert_eq!(
            names(folder.path()),
            ["c.png", "d.png", "left.png", "new", "right.png"]
        );
        maps.push(bytes);
    }
    assert_eq!(maps[1], maps[2]);
}

/// A picture in colour is the grey of its luma.
#[test]
fn match_takes_colour_as_grey() {
    let folder = tempdir().unwrap();
    views(folder.path());
    for name in ["left", "right"] {
        let grey = image::open(folder.path().join(format!("{name}.png"))).unwrap();
        let colour = folder.path().join(format!("{name}.ppm"));
        let rgb = grey.to_rgb8();
        let header = format!("P6 {} {} 255\n", rgb.width(), rgb.height());
        std::fs::write(colour, [header.as_bytes(), rgb.as_raw()].concat()).unwrap();
    }
    for (ending, out) in [("png", "grey.pfm"), ("ppm", "colour.pfm")] {
        let [left, right] = ["left", "right"].map(|name| format!("{name}.{ending}"));
        let arguments = [
            "stereo",
            "match",
            &left,
            &right,
            "--max-disparity",
            "16",
            "--out",
            out,
            "-q",
        ];
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        assert!(output.stdout.is_empty());
    }
    let [grey, colour] = ["grey.pfm", "colour.pfm"].map(|name| folder.path().join(name));
    assert_eq!(std::fs::read(grey).unwrap(), std::fs::read(colour).unwrap());
}

#[test]
fn match_says_what_is_wrong_and_writes_nothing() {
    let folder = tempdir().unwrap();
    views(folder.path());
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    let png = std::fs::read(folder.path().join("left.png")).unwrap();
    write("cut.png", &png[..png.len() / 2]);
    let mut flipped = png;
    let middle = flipped.len() / 2;
    flipped[middle] ^= 0x55;
    write("flipped.png", &flipped);
    write("text.png", b"none");
    write("small.pgm", b"P5 3 2 255\nabcdef");
    std::fs::create_dir(folder.path().join("taken.pfm")).unwrap();
    let before = names(folder.path());
    let refused = |arguments: &str, parts: &[&str]| {
        let all = ["stereo", "match"].into_iter().chain(arguments.split(' '));
        assert_failure(&nullcone(folder.path(), all), parts);
        assert_eq!(names(folder.path()), before, "{arguments}");
    };
    for (views, parts) in [
        ("nowhere.png right.png", &["cannot read nowhere.png: "][..]),
        ("left.png nowhere.png", &["cannot read nowhere.png: "]),
        ("cut.png right.png", &["cut.png: PNG: "]),
        ("left.png flipped.png", &["flipped.png: PNG: "]),
        ("left.png text.png", &["text.png: not a picture"]),
        (
            "left.png small.pgm",
            &["left.png has 120 × 90", "small.pgm has 3 × 2"],
        ),
        ("small.pgm small.pgm", &["small.pgm", "3 × 2"]),
    ] {
        let arguments = format!("{views} --max-disparity 16 --out new/d.pfm");
        refused(&arguments, parts);
    }
    for (options, parts) in [
        (
            "--max-disparity 0 --out d.pfm",
            &["left.png and right.png: ", "range of 0 px"][..],
        ),
        (
            "--max-disparity 121 --out d.pfm",
            &["range of 121 px", "1 to 120 px"],
        ),
        (
            "--max-disparity 16 --out d.tiff",
            &["--out d.tiff: its name must end in .pfm or .png"],
        ),
        (
            "--max-disparity 16 --min-disparity 16 --out d.pfm",
            &["range of 0 px"],
        ),
        (
            "--max-disparity -110 --min-disparity -140 --out d.pfm",
            &[
                "from -140 px up to, and without, -110 px",
                "120 pixels wide",
            ],
        ),
        (
            "--max-disparity 16 --min-confidence 1.5 --out d.pfm",
            &["--min-confidence 1.5"],
        ),
        (
            "--max-disparity 4 --min-disparity -12 --out d.png",
            &["d.png: a PNG file", "from 0 to 255.996 px"],
        ),
        (
            "--max-disparity 16 --out taken.pfm --picture d.png",
            &["cannot write taken.pfm"],
        ),
        (
            "--max-disparity 16 --out d.pfm --picture left.png/d.png",
            &["cannot write left.png/d.png"],
        ),
        (
            "--max-disparity 16 --out d.pfm --picture d.jpg",
            &["--picture d.jpg: its name must end in .png"],
        ),
        (
            "--max-disparity 16 --out d.pfm --picture x.png --confidence x.png",
            &["--picture x.png", "another output", "that of --confidence"],
        ),
    ] {
        refused(&format!("left.png right.png {options}"), parts);
    }
}

#[test]
fn evaluate_says_what_is_wrong() {
    let folder = maps();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("wide.pfm", &pfm(6, &[1.0; 6]));
    write("zero.pfm", &pfm(3, &[0.0; 6]));
    write("short.pfm", &pfm(3, &[1.0; 6])[..30]);
    write("long.pfm", &[&pfm(3, &[1.0; 6])[..], b"more"].concat());
    write("wide.pgm", b"P5 6 1 255\n\xff\xff\x80\x80\0\0");
    write("odd.pgm", b"P5 3 2 255\nabcdef");
    write("colour.ppm", b"P6 1 1 255\nabc");
    write("text.pfm", b"five");
    let before = names(folder.path());
    for (arguments, parts) in [
        (
            &["nowhere.pfm", "truth.pfm"][..],
            &["cannot read nowhere.pfm: "][..],
        ),
        (&["d.pfm", "nowhere.png"], &["cannot read nowhere.png: "]),
        (&["text.pfm", "truth.pfm"], &["text.pfm: not a picture"]),
        (&["colour.ppm", "truth.pfm"], &["colour.ppm: ", "8-bit RGB"]),
        (
            &["short.pfm", "truth.pfm"],
            &["short.pfm: PFM", "3 × 2 pixels, which are 24 bytes, and 18"],
        ),
        (
            &["long.pfm", "truth.pfm"],
            &["long.pfm: PFM", "3 × 2 pixels, which are 24 bytes, and 28"],
        ),
        (
            &["d.pfm", "truth.pfm", "--mask", "wide.pgm"],
            &["d.pfm and truth.pfm: the mask", "3 × 2 and 6 × 1"],
        ),
        (
            &["d.pfm", "truth.pfm", "--mask", "odd.pgm"],
            &["odd.pgm: a mask has the levels", "and not 97"],
        ),
        (
            &["d.pfm", "truth.pfm", "--mask", "zero.pfm"],
            &["zero.pfm: a mask is"],
        ),
        (
            &["d.pfm", "truth.pfm", "--map-scale", "0"],
            &["--map-scale 0"],
        ),
        (&["d.pfm", "colour.ppm"], &["colour.ppm: ", "8-bit RGB"]),
        (&["d.pfm", "text.pfm"], &["text.pfm: not a picture"]),
        (
            &["d.pfm", "wide.pfm"],
            &["d.pfm and wide.pfm: ", "3 × 2 and 6 × 1"],
        ),
        (&["d.pfm", "zero.pfm"], &["d.pfm and zero.pfm: ", "not 0"]),
        (&["d.pfm", "truth.pfm", "--scale", "0"], &["--scale 0"]),
        (&["d.pfm", "truth.pfm", "--scale", "-4"], &["--scale -4"]),
        (&["d.pfm", "truth.pfm", "--scale", "nan"], &["--scale NaN"]),
        (
            &["d.pfm", "truth.pfm", "--picture", "e.pfm"],
            &["e.pfm", "png"],
        ),
    ] {
        let all = [&["stereo", "evaluate", "--picture", "e.png"], arguments].concat();
        let picture = arguments.contains(&"--picture");
        let all = if picture {
            [&["stereo", "evaluate"], arguments].concat()
        } else {
            all
        };
        assert_failure(&nullcone(folder.path(), all), parts);
        assert_eq!(names(folder.path()), before);
    }
}

/// The views of a texture without repetition, whose right one is moved by a number of columns, and
/// one of a single level.
fn textures(folder: &Path, shift: i64) {
    let write = |name: &str, level: &dyn Fn(i64, i64) -> f64| {
        let level = |u: u32, v: u32| level(u.into(), v.into()).round().clamp(0.0, 255.0) as u8;
        let picture = image::GrayImage::from_fn(320, 240, |u, v| image::Luma([level(u, v)]));
        picture.save(folder.join(name)).unwrap();
    };
    let wave = |u: i64, v: i64| {
        let waves = (1..24).map(f64::from).map(|k| {
            let (angle, wave) = (2.4 * k, 0.09 + 0.019 * k);
            let along = u as f64 * angle.cos() + v as f64 * angle.sin();
            14.0 * (wave * along + 1.7 * k * k).sin()
        });
        128.0 + waves.sum::<f64>()
    };
    write("left.png", &wave);
    write("right.png", &|u, v| wave(u + shift, v));
    write("grey.png", &|_, _| 90.0);
}

fn matched(folder: &Path, arguments: &str) -> Value {
    let all = ["stereo", "match", "--json"].into_iter();
    let output = nullcone(folder, all.chain(arguments.split(' ')));
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn match_finds_negative_disparities() {
    let folder = tempdir().unwrap();
    textures(folder.path(), -20);
    for (range, least) in [
        ("--min-disparity -32 --max-disparity 0", -32.0),
        ("--min-disparity -32 --max-disparity -8", -32.0),
        ("--auto-range", -26.0),
    ] {
        let out = "--out d.pfm --min-confidence 0.1";
        let report = matched(folder.path(), &format!("left.png right.png {range} {out}"));
        assert_eq!(report["verdict"], "good", "{report}");
        let from = number(&report, "/min_disparity_px");
        assert!((from - least).abs() <= if range == "--auto-range" { 4.0 } else { 0.0 });
        assert_eq!(report["range_points"].is_null(), range != "--auto-range");
        assert!(number(&report, "/greatest_px") < -15.0, "{report}");
        let map = ga_vision::disparity::file::read(folder.path().join("d.pfm"), None).unwrap();
        assert!((map.get(150, 120).unwrap() + 20.0).abs() < 0.2);
        // What is outside the right view is not known.
        let right = (0..240).filter(|row| map.get(318, *row).is_none()).count();
        assert!(right > 120, "{right}");
        let density = 100.0 * map.known() as f64 / (320.0 * 240.0);
        assert!((number(&report, "/density") - density).abs() < 1e-9);
        assert!((80.0..99.0).contains(&density), "{density}");
    }
}

#[test]
fn match_says_why_a_pair_fails() {
    let folder = tempdir().unwrap();
    textures(folder.path(), 9);
    for (arguments, kinds) in [
        ("left.png right.png --max-disparity 32", &[][..]),
        ("left.png right.png --auto-range", &[]),
        (
            "right.png left.png --max-disparity 32",
            &["views_exchanged", "outside_range"],
        ),
        ("right.png left.png --auto-range", &[]),
        (
            "left.png right.png --min-disparity 32 --max-disparity 64",
            &["outside_range"],
        ),
        ("grey.png grey.png --max-disparity 32", &["no_texture"]),
    ] {
        let report = matched(folder.path(), &format!("{arguments} --out d.pfm"));
        let warnings = report["warnings"].as_array().unwrap().iter();
        let found: Vec<_> = warnings
            .map(|warning| warning["kind"].as_str().unwrap())
            .collect();
        assert_eq!(found, kinds, "{report}");
        let expected = if kinds.is_empty() { "good" } else { "doubtful" };
        assert_eq!(report["verdict"], expected);
    }
    let grey = matched(
        folder.path(),
        "grey.png grey.png --max-disparity 32 --min-confidence 0.01 --out d.png",
    );
    assert_eq!(number(&grey, "/mean_confidence"), 0.0);
    assert_eq!(
        (number(&grey, "/density"), &grey["least_px"]),
        (0.0, &Value::Null)
    );
    let stored = image::open(folder.path().join("d.png")).unwrap();
    assert!(stored.to_luma16().pixels().all(|pixel| pixel.0 == [0]));
    let arguments = ["stereo", "match", "grey.png", "grey.png", "--out", "d.pfm"];
    let few = nullcone(folder.path(), arguments.iter().chain(&["--auto-range"]));
    assert_failure(
        &few,
        &[
            "grey.png and grey.png: --max-disparity",
            "0 points",
            "at least 20",
        ],
    );
    let check = nullcone(
        folder.path(),
        arguments
            .iter()
            .chain(&["--max-disparity", "16", "--check"]),
    );
    assert_eq!(check.status.code(), Some(3));
}

/// 256 × the disparity, as KITTI has it: the file is evaluated as the map that it is.
#[test]
fn match_writes_maps_as_png() {
    let folder = tempdir().unwrap();
    textures(folder.path(), 9);
    for out in ["d.pfm", "d.png"] {
        let report = matched(
            folder.path(),
            &format!("left.png right.png --max-disparity 32 --min-confidence 0.2 --out {out}"),
        );
        assert!(number(&report, "/density") < 100.0);
    }
    let maps = ["d.pfm", "d.png"];
    let [floats, whole] =
        maps.map(|name| ga_vision::disparity::file::read(folder.path().join(name), None).unwrap());
    for (a, b) in floats.plane().values().iter().zip(whole.plane().values()) {
        assert!(
            a.is_nan() && b.is_nan() || (a - b).abs() <= 1.0 / 256.0,
            "{a} {b}"
        );
    }
}
