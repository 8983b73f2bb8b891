//! `--frames` and `nullcone merge`: a work in parts gives the bytes of the work in one process.

mod comparison;
mod disparities;
mod film;
mod key_frames;
mod refused;
mod stereoscopic;
mod threads;
mod view;

use std::collections::BTreeSet;
use std::path::Path;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use proptest::prelude::*;

use crate::common::{assert_success, nullcone};

/// Divisions of frames into parts, in any order: the first frame of each and the end.
fn divisions(frames: usize) -> impl Strategy<Value = Vec<[usize; 2]>> {
    let ends = proptest::collection::btree_set(1..frames, 0..4);
    let parts = ends.prop_map(move |inside: BTreeSet<usize>| {
        let ends: Vec<usize> = [0].into_iter().chain(inside).chain([frames]).collect();
        ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    });
    parts.prop_flat_map(|parts: Vec<[usize; 2]>| Just(parts).prop_shuffle())
}

/// Few cases: each runs the program several times.
fn few_cases() -> ProptestConfig {
    ProptestConfig {
        cases: 5,
        ..ProptestConfig::default()
    }
}

/// Runs the program in a folder, and demands that it succeeds.
#[track_caller]
fn run(folder: &Path, line: &str) -> Vec<u8> {
    let output = nullcone(folder, line.split_whitespace());
    assert_success(&output);
    output.stdout
}

/// A picture in which squares move, that looks random.
fn picture(width: usize, height: usize, frame: usize, strength: usize) -> Plane<[u8; 3]> {
    Plane::from_fn(width, height, |column, row| {
        let [x, y] = [(column + 2 * frame) / 5, (row + frame) / 5];
        let hash = (x * 7919 + y * 104_729 + 17) * 2_654_435_761 % 4_294_967_296;
        let noise = (column * 31 + row * 17 + frame * 7) % 11 * strength;
        [hash >> 8, hash >> 14, hash >> 20].map(|level| (level % 200 + noise).min(255) as u8)
    })
}

/// The views of a stereoscopic film, large enough for points to be found in them.
fn write_views(folder: &Path, frames: usize) {
    for (name, shift) in [("left.y4m", 0), ("right.y4m", 5)] {
        let frames = (0..frames).map(|frame| {
            Plane::from_fn(320, 180, |column, row| {
                let [x, y] = [(column + 3 * frame + shift) / 7, (row + shift / 3) / 7];
                let hash = (x * 7919 + y * 104_729 + 17) * 2_654_435_761 % 4_294_967_296;
                [40 + (hash >> 12) as u8 % 150; 3]
            })
        });
        y4m::write(folder.join(name), frames, Film::default()).unwrap();
    }
}

/// A film of such pictures, of which a function says how strong their noise is.
fn write_film(path: &Path, [width, height]: [usize; 2], noise: &[usize]) {
    let frames = noise.iter().enumerate();
    let frames = frames.map(|(frame, noise)| picture(width, height, frame, *noise));
    y4m::write(path, frames, Film::default()).unwrap();
}
