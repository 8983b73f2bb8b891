//! `nullcone quality compare`: pictures and videos against their references.

mod identity;

use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use ga_image::file;
use ga_image::plane::Plane;
use ga_image::quality::{Ssim, mse, psnr};
use ga_image::y4m::{self, Film, Sampling};
use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, nullcone, number, program, text};

/// The measures of luma.
const KEYS: [&str; 6] = [
    "attention_psnr",
    "attention_ssim",
    "ms_ssim",
    "psnr",
    "ssim",
    "vif",
];

/// What else is printed of pictures, of which `differs_in` and `identical` are no measures.
const OTHERS: [&str; 7] = [
    "ciede2000",
    "differs_in",
    "identical",
    "psnr_6_1_1",
    "psnr_all",
    "psnr_cb",
    "psnr_cr",
];

fn compare<const N: usize>(folder: &Path, arguments: [&str; N]) -> std::process::Output {
    let all = [&["quality", "compare"][..], &arguments].concat();
    nullcone(folder, all)
}

fn report(output: &std::process::Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap()
}

fn close(got: f64, expected: f64, tolerance: f64) {
    assert!((got - expected).abs() <= tolerance, "{got}, not {expected}");
}

#[test]
fn the_oracles_pictures_have_its_figures() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let truth: Value =
        serde_json::from_slice(&std::fs::read(folder.join("truth.json")).unwrap()).unwrap();
    for row in truth["quality"].as_array().unwrap() {
        let name = row["file"].as_str().unwrap();
        // Grey, and the picture in colour that it was made from.
        for reference in ["gray.png", "base.png"] {
            let output = compare(
                &folder,
                [reference, name, "--attention", "attention.png", "--json"],
            );
            assert_success(&output);
            assert!(output.stderr.is_empty());
            let report = report(&output);
            let mut keys: Vec<&String> = report.as_object().unwrap().keys().collect();
            keys.retain(|key| *key != "warnings" && !key.ends_with("_reason"));
            keys.sort();
            let mut expected = [&KEYS[..], &OTHERS].concat();
            expected.sort_unstable();
            assert_eq!(keys, expected);
            assert_eq!(report["warnings"], serde_json::json!([]));
            for (key, expected) in [
                ("psnr", "psnr"),
                ("ssim", "ssim"),
                ("attention_psnr", "wpsnr"),
                ("attention_ssim", "wssim"),
            ] {
                let expected = row[expected].as_f64().unwrap();
                close(report[key].as_f64().unwrap(), expected, 1e-6);
            }
            assert!(report["ms_ssim"].is_number());
        }
    }
}

/// A texture, and the same with errors.
fn textures(width: usize, height: usize) -> [Plane<u8>; 2] {
    let a = Plane::from_fn(width, height, |x, y| {
        ((x * x / 9 + 5 * y + x * y / 7) % 220) as u8
    });
    let b = Plane::from_fn(width, height, |x, y| {
        a.row(y)[x] + ((3 * x + 7 * y) % 11) as u8
    });
    [a, b]
}

#[test]
fn equal_pictures_have_null_and_one() {
    let folder = tempdir().unwrap();
    let [a, _] = textures(200, 180);
    file::write(folder.path().join("a.png"), &a).unwrap();
    let output = compare(folder.path(), ["a.png", "a.png", "--json"]);
    assert_success(&output);
    let report = report(&output);
    for key in ["psnr", "attention_psnr"] {
        assert!(report[key].is_null());
        assert_eq!(report[format!("{key}_reason")], "nothing differs");
    }
    assert_eq!(report["identical"], true);
    for key in ["ssim", "ms_ssim", "vif", "attention_ssim"] {
        assert_eq!(report[key].as_f64(), Some(1.0), "{key}");
    }
    let output = compare(folder.path(), ["a.png", "a.png"]);
    assert_success(&output);
    assert!(
        text(&output.stdout)
            .contains("PSNR                              infinite: nothing differs\n")
    );
}

#[test]
fn ms_ssim_of_small_pictures_is_null_with_a_reason() {
    let folder = tempdir().unwrap();
    let [a, b] = textures(175, 300);
    file::write(folder.path().join("a.png"), &a).unwrap();
    file::write(folder.path().join("b.png"), &b).unwrap();
    let output = compare(folder.path(), ["a.png", "b.png", "--json"]);
    assert_success(&output);
    let object = report(&output);
    assert!(object["ms_ssim"].is_null());
    let reason = "175 × 300 pixels are too few, five scales need 176 × 176";
    assert_eq!(object["ms_ssim_reason"], reason);
    assert_eq!(object["warnings"][0]["kind"], "too_few_pixels");
    assert!(text(&output.stderr).contains(reason));
    let output = compare(folder.path(), ["a.png", "b.png"]);
    assert!(text(&output.stdout).contains(reason));
}

#[test]
fn deep_pictures_are_compared_with_their_depth() {
    let folder = tempdir().unwrap();
    let [a, b] = textures(64, 48).map(|plane| plane.map(|v| 200 * u16::from(v)));
    file::write(folder.path().join("a.png"), &a).unwrap();
    file::write(folder.path().join("b.png"), &b).unwrap();
    let output = compare(folder.path(), ["a.png", "b.png", "--json", "-q"]);
    assert_success(&output);
    assert!(output.stderr.is_empty());
    let got = number(&report(&output), "/psnr");
    close(got, psnr(&a, &b, 65535.0).unwrap(), 1e-4);
}

/// Grey videos `a.y4m` and `b.y4m` with these numbers of frames; frame 1 is the same in both.
fn videos(frames: [usize; 2]) -> TempDir {
    let folder = tempdir().unwrap();
    let [a, b] = textures(192, 176);
    let moved = |plane: &Plane<u8>, index: usize| {
        let plane = plane.clone();
        Plane::from_fn(192, 176, move |x, y| {
            [plane.row(y)[(x + 3 * index) % 192]; 3]
        })
    };
    let film = Film {
        sampling: Sampling::Grey,
        ..Film::default()
    };
    let write = |name: &str, count: usize, plane: &Plane<u8>| {
        let frames = (0..count).map(|index| match index {
            1 => moved(&a, index),
            _ => moved(plane, index),
        });
        y4m::write(folder.path().join(name), frames, film).unwrap();
    };
    write("a.y4m", frames[0], &a);
    write("b.y4m", frames[1], &b);
    folder
}

/// The luma of the frames of a grey film.
fn lumas(path: &Path) -> Vec<Plane<u8>> {
    let bytes = std::fs::read(path).unwrap();
    let reader = y4m::Reader::new(&bytes).unwrap();
    reader.map(|frame| frame.unwrap().luma.to_plane()).collect()
}

#[test]
fn videos_are_pooled_and_written_frame_by_frame() {
    let folder = videos([4, 4]);
    let [a, b] = ["a.y4m", "b.y4m"].map(|name| lumas(&folder.path().join(name)));
    let output = compare(
        folder.path(),
        [
            "a.y4m", "b.y4m", "--json", "--csv", "f.csv", "--plot", "q.svg", "--report", "q.html",
        ],
    );
    assert_success(&output);
    let report = report(&output);
    assert!(KEYS.iter().all(|key| report.get(key).is_some()));
    assert_eq!(report["frames"], 4);
    assert!(report["psnr_cb"].is_null());
    // Frame 1 has no error, so the mean is infinite, and the harmonic mean is not.
    assert!(report["psnr"].is_null());
    assert_eq!(report["psnr_reason"], "1 of 4 frames is identical in luma");
    assert_eq!(
        (&report["identical"], &report["identical_frames"]),
        (&false.into(), &1.into())
    );
    let error = |index: usize| mse(&a[index], &b[index]).unwrap();
    let mean = (0..4).map(error).sum::<f64>() / 4.0;
    let expected = 10.0 * (255.0 * 255.0 / mean).log10();
    close(number(&report, "/psnr_of_mean_mse"), expected, 1e-9);
    let of = |index: usize| psnr(&a[index], &b[index], 255.0).unwrap();
    let harmonic = 4.0 / (1.0 / of(0) + 1.0 / of(2) + 1.0 / of(3));
    close(
        number(&report, "/pooled/psnr/harmonic_mean"),
        harmonic,
        1e-9,
    );
    let least = of(0).min(of(2)).min(of(3));
    close(number(&report, "/pooled/psnr/min"), least, 1e-9);
    let ssim = |index: usize| Ssim::new(255.0).compare(&a[index], &b[index]).unwrap().ssim;
    let mean = (0..4).map(ssim).sum::<f64>() / 4.0;
    close(number(&report, "/ssim"), mean, 1e-9);
    close(number(&report, "/pooled/ssim/mean"), mean, 1e-9);
    assert!(number(&report, "/pooled/ssim/p95") <= 1.0);

    let mut table = csv::Reader::from_path(folder.path().join("f.csv")).unwrap();
    let header: Vec<String> = table.headers().unwrap().iter().map(String::from).collect();
    assert_eq!(header[..4], ["frame", "time_seconds", "psnr", "ssim"]);
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 4);
    assert_eq!(
        (&rows[1][0], &rows[1][1], &rows[1][2]),
        ("1", "0.04", "inf")
    );
    close(rows[2][3].parse().unwrap(), ssim(2), 1e-9);
    let svg = std::fs::read_to_string(folder.path().join("q.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("Quality of b.y4m over time"));

    let page = page(folder.path(), "q.html");
    assert!(page.contains(svg.trim_end()) && page.contains("4 frames. Reference: a.y4m."));
    // The mean over the frames is infinite, since one has no error.
    let mean = "<td>mean PSNR</td><td>infinite: 1 of 4 frames is identical in luma</td>";
    assert!(page.contains(mean), "{page}");
    let worst = (0..4).min_by(|a, b| ssim(*a).total_cmp(&ssim(*b))).unwrap();
    let row = format!("attention SSIM</th></tr>\n<tr><td>{worst}</td><td>");
    assert!(page.contains(&row), "{page}");

    let piped = program(folder.path())
        .args(["quality", "compare", "a.y4m", "-", "--json"])
        .stdin(std::fs::File::open(folder.path().join("b.y4m")).unwrap())
        .output()
        .unwrap();
    assert_success(&piped);
    assert_eq!(piped.stdout, output.stdout);
}

/// A page that is whole, and needs no other file.
fn page(folder: &Path, name: &str) -> String {
    let page = std::fs::read_to_string(folder.join(name)).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    let links = page.matches("http").count();
    assert_eq!(
        links,
        page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count()
    );
    page
}

#[test]
fn a_report_of_pictures_shows_where_they_differ() {
    let folder = tempdir().unwrap();
    let [a, b] = textures(60, 50);
    let left = Plane::from_fn(
        60,
        50,
        |x, y| if x < 30 { a.row(y)[x] } else { b.row(y)[x] },
    );
    file::write(folder.path().join("a & b.png"), &a).unwrap();
    file::write(folder.path().join("c.png"), &left).unwrap();
    let output = compare(
        folder.path(),
        ["a & b.png", "c.png", "--report", "q.html", "--csv", "f.csv"],
    );
    assert_success(&output);
    let page = page(folder.path(), "q.html");
    assert!(page.contains("Reference: a &amp; b.png."));
    assert!(page.contains("none: 60 × 50 pixels are too few"));
    let pictures = page.split("data:image/png;base64,").skip(1).map(|rest| {
        let end = rest.find('"').unwrap();
        let picture = BASE64_STANDARD.decode(&rest[..end]).unwrap();
        let picture = file::decode(&picture).unwrap();
        picture.to_grey(ga_image::grey::Luma::Bt601)
    });
    let pictures: Vec<Plane<u8>> = pictures.collect();
    let [reference, distorted, map] = &pictures[..] else {
        panic!("{} pictures", pictures.len());
    };
    assert!(reference.rows().eq(a.rows()) && distorted.rows().eq(left.rows()));
    assert_eq!((map.width(), map.height()), (60, 50));
    assert!((0..20).all(|x| map.row(25)[x] == 255) && map.row(25)[45] < 255);
    // One of the files has no place: none is written.
    let output = compare(
        folder.path(),
        [
            "a & b.png",
            "c.png",
            "--csv",
            "g.csv",
            "--report",
            "c.png/q.html",
        ],
    );
    assert_eq!(output.status.code(), Some(1));
    assert!(!folder.path().join("g.csv").exists());
}

/// A depth of 16 bits beside one of 8: what is less than a level of 8 bits counts.
#[test]
fn pictures_of_different_depth_are_compared_as_the_deeper_one() {
    let folder = tempdir().unwrap();
    let [a, _] = textures(64, 48);
    let deep = a.map(|v| 257 * u16::from(v) + 100);
    file::write(folder.path().join("a.png"), &a).unwrap();
    file::write(folder.path().join("b.png"), &deep).unwrap();
    for pair in [["a.png", "b.png"], ["b.png", "a.png"]] {
        let output = compare(folder.path(), [pair[0], pair[1], "--json"]);
        assert_success(&output);
        let expected = 20.0 * (65535.0f64 / 100.0).log10();
        close(number(&report(&output), "/psnr"), expected, 1e-2);
    }
}

#[test]
fn ten_bits_have_a_range_of_1023() {
    let folder = tempdir().unwrap();
    let write = |name: &str, level: u16| {
        let mut bytes = b"YUV4MPEG2 W16 H12 F25:1 Cmono10\nFRAME\n".to_vec();
        bytes.extend(
            [level; 16 * 12]
                .iter()
                .flat_map(|level| level.to_le_bytes()),
        );
        std::fs::write(folder.path().join(name), bytes).unwrap();
    };
    write("a.y4m", 500);
    write("b.y4m", 503);
    let output = compare(folder.path(), ["a.y4m", "b.y4m", "--json"]);
    assert_success(&output);
    let report = report(&output);
    for key in ["/psnr", "/attention_psnr", "/psnr_of_mean_mse"] {
        close(number(&report, key), 20.0 * (1023.0f64 / 3.0).log10(), 1e-4);
    }
}

/// Cb differs by 1 and Cr by 2, in 4:4:4.
#[test]
fn colour_differences_have_their_own_figures() {
    let folder = tempdir().unwrap();
    let write = |name: &str, levels: [u8; 3]| {
        let mut bytes = b"YUV4MPEG2 W16 H12 F25:1 C444\nFRAME\n".to_vec();
        bytes.extend(levels.iter().flat_map(|level| [*level; 16 * 12]));
        std::fs::write(folder.path().join(name), bytes).unwrap();
    };
    write("a.y4m", [50, 100, 150]);
    write("b.y4m", [54, 101, 152]);
    let arguments = ["a.y4m", "b.y4m", "--json", "--csv", "f.csv"];
    let output = compare(folder.path(), arguments);
    assert_success(&output);
    let report = report(&output);
    let of = |difference: f64| 20.0 * (255.0 / difference).log10();
    close(number(&report, "/psnr"), of(4.0), 1e-9);
    close(number(&report, "/psnr_of_mean_mse"), of(4.0), 1e-9);
    close(number(&report, "/psnr_cb"), of(1.0), 1e-9);
    close(number(&report, "/psnr_cr"), of(2.0), 1e-9);
    let weighted = (6.0 * of(4.0) + of(1.0) + of(2.0)) / 8.0;
    close(number(&report, "/psnr_6_1_1"), weighted, 1e-9);
    let mut table = csv::Reader::from_path(folder.path().join("f.csv")).unwrap();
    let header = table.headers().unwrap().clone();
    let row = table.records().next().unwrap().unwrap();
    for (name, difference) in [("psnr_cb", 1.0), ("psnr_cr", 2.0)] {
        let column = header.iter().position(|column| column == name).unwrap();
        close(row[column].parse().unwrap(), of(difference), 1e-9);
    }
}

#[test]
fn frames_before_an_error_are_reported() {
    let folder = videos([4, 3]);
    let broken = |what: &[&str]| {
        let output = compare(
            folder.path(),
            [
                "a.y4m", "b.y4m", "--json", "--csv", "f.csv", "--report", "q.html",
            ],
        );
        assert_eq!(output.status.code(), Some(1));
        let message = text(&output.stderr);
        assert_eq!(message.lines().count(), 1, "{message}");
        for part in what {
            assert!(message.contains(part), "{message}");
        }
        let report = report(&output);
        let frames = report["frames"].as_u64().unwrap() as usize;
        assert!(message.contains(&format!("{frames} frames are reported")));
        assert!(report["error"].is_string());
        let table = std::fs::read_to_string(folder.path().join("f.csv")).unwrap();
        assert_eq!(table.lines().count(), 1 + frames);
        let page = page(folder.path(), "q.html");
        let error = report["error"].as_str().unwrap();
        assert!(page.contains(&format!("were not compared to their ends: {error}</p>")));
        frames
    };
    assert_eq!(broken(&["the distorted video has no frame 3"]), 3);
    let path = folder.path().join("b.y4m");
    let bytes = std::fs::read(&path).unwrap();
    std::fs::write(&path, &bytes[..bytes.len() - 10]).unwrap();
    assert_eq!(broken(&["b.y4m", "within frame 2"]), 2);
}

#[test]
fn what_cannot_be_compared_is_an_error() {
    let folder = videos([2, 2]);
    let [a, _] = textures(40, 30);
    let write = |name: &str, plane: &Plane<u8>| {
        file::write(folder.path().join(name), plane).unwrap();
    };
    write("a.png", &a);
    write("wide.png", &Plane::filled(41, 30, 0u8));
    write("black.png", &Plane::filled(40, 30, 0u8));
    let path = folder.path();
    let fails = |arguments: &[&str], parts: &[&str]| {
        let all = [&["quality", "compare"][..], arguments].concat();
        assert_failure(&nullcone(path, all), parts);
    };
    fails(
        &["a.png", "wide.png"],
        &["a.png", "wide.png", "40 × 30", "41 × 30"],
    );
    fails(
        &["a.png", "a.y4m"],
        &["a.png is a picture and a.y4m is not"],
    );
    fails(&["a.png", "missing.png"], &["missing.png"]);
    fails(&["a.png", "a.png", "--plot", "q.svg"], &["--plot"]);
    fails(&["a.png", "a.png", "--scale"], &["--scale"]);
    fails(&["a.y4m", "-", "--align-times"], &["--align-times"]);
    let film = std::fs::read(path.join("a.y4m")).unwrap();
    let end = film.iter().position(|byte| *byte == b'\n').unwrap();
    let full = [&film[..end], b" XCOLORRANGE=FULL", &film[end..]].concat();
    std::fs::write(path.join("full.y4m"), full).unwrap();
    fails(
        &["a.y4m", "full.y4m"],
        &["differ in range: limited and full"],
    );
    fails(&["-", "-"], &["standard input"]);
    fails(&["a.png", "-"], &["a.png is a picture and - is not"]);
    fails(
        &["a.png", "a.png", "--attention", "wide.png"],
        &["wide.png", "41 × 30"],
    );
    fails(
        &["a.png", "a.png", "--attention", "black.png"],
        &["black.png", "all weights are zero"],
    );
    fails(
        &["a.y4m", "b.y4m", "--attention", "a.png"],
        &["a.png", "192 × 176"],
    );
    assert!(!path.join("q.svg").exists());
}
