//! Disparities of films in parts.

use std::path::Path;

use ga_image::y4m;
use tempfile::tempdir;

use super::{run, write_views};
use crate::common::{assert_failure, contents, json, nullcone};

const MATCH: &str = "stereo match left.y4m right.y4m --mode fast";

/// A view of a frame as a picture of its luma.
fn picture(folder: &Path, side: &str, frame: usize) {
    let bytes = std::fs::read(folder.join(format!("{side}.y4m"))).unwrap();
    let mut film = y4m::Reader::new(&bytes).unwrap();
    let [width, height] = [film.width(), film.height()];
    let frame = film.nth(frame).unwrap().unwrap();
    let header = format!("P5 {width} {height} 255\n").into_bytes();
    let pixels = (0..height).flat_map(|row| frame.luma.row(row).iter().copied());
    let bytes: Vec<u8> = header.into_iter().chain(pixels).collect();
    std::fs::write(folder.join(format!("{side}.pgm")), bytes).unwrap();
}

#[test]
fn the_maps_of_parts_are_those_of_the_film_and_of_its_pictures() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    write_views(folder, 3);
    let range = "--max-disparity 16";
    let out = "d_%04d.pfm --picture DIR/p%d.png --confidence DIR/c%02d.png";
    for dir in ["whole", "parts"] {
        std::fs::create_dir(folder.join(dir)).unwrap();
    }
    let line = |dir: &str| format!("{MATCH} {range} --out {dir}/{}", out.replace("DIR", dir));
    run(folder, &line("whole"));
    run(folder, &format!("{} --frames 2..9", line("parts")));
    run(folder, &format!("{} --frames ..2", line("parts")));
    let whole = contents(&folder.join("whole"));
    let names: Vec<&str> = whole.iter().map(|(name, _)| name.as_str()).collect();
    let expected = [
        "c00.png",
        "c01.png",
        "c02.png",
        "d_0000.pfm",
        "d_0001.pfm",
        "d_0002.pfm",
        "p0.png",
        "p1.png",
        "p2.png",
    ];
    assert_eq!(names, expected);
    assert!(whole == contents(&folder.join("parts")));
    for frame in 0..3 {
        picture(folder, "left", frame);
        picture(folder, "right", frame);
        run(
            folder,
            &format!("stereo match left.pgm right.pgm --mode fast {range} --out one.pfm"),
        );
        let one = std::fs::read(folder.join("one.pfm")).unwrap();
        assert!(one == whole[3 + frame].1, "{frame}");
    }
}

/// The range that is found is that of the first frame, whichever frames are matched.
#[test]
fn the_range_of_all_parts_is_the_same() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    write_views(folder, 2);
    let all = format!("{MATCH} --auto-range --out d%d.pfm");
    let report = json(folder, &all.split(' ').collect::<Vec<_>>());
    let first = contents(folder);
    assert_eq!(report["frames"], 2);
    assert_eq!(report["per_frame"][1]["frame"], 1);
    let part = json(
        folder,
        &format!("{all} --frames 1..").split(' ').collect::<Vec<_>>(),
    );
    assert_eq!(part["max_disparity_px"], report["max_disparity_px"]);
    assert_eq!(part["per_frame"][0], report["per_frame"][1]);
    assert!(first == contents(folder));
    let refused = |line: &str, parts: &[&str]| {
        assert_failure(&nullcone(folder, line.split(' ')), parts);
    };
    refused(&format!("{all} --frames 2..3"), &["2..3", "2 frames"]);
    refused(
        &format!("{MATCH} --auto-range --out d.pfm --frames 0..1"),
        &["d.pfm", "%04d"],
    );
    refused(&format!("{all} --picture p.png"), &["p.png", "%04d"]);
}
