//! Films that are read from files, with pictures of what may become key frames.

use std::collections::VecDeque;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use ga_video::keyframe::{Options, Pictures, analyse};

use super::clips::{Effect, Joins, SIZE, clip};

#[test]
fn a_film_is_read_with_progress_and_pictures() {
    let clip = clip(5, Joins::Cuts, Effect::None);
    let frames = clip
        .frames
        .iter()
        .map(|luma| luma.map(|level: u8| [level; 3]));
    let frames: Vec<Plane<[u8; 3]>> = frames.collect();
    let count = frames.len();
    assert!(!clip.labels.cuts.is_empty() && count > 40);
    let bytes = y4m::encode(&frames, Film::default()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.y4m");
    std::fs::write(&path, &bytes).unwrap();

    let mut pictures = Pictures::new().unwrap();
    let mut calls = Vec::new();
    let progress = |done, all| calls.push([done, all]);
    let none = VecDeque::new;
    let found = analyse(
        &path,
        Options::default(),
        none(),
        Some(&mut pictures),
        progress,
    )
    .unwrap();
    assert!(found.failure.is_none());
    assert_eq!(found.analysis.frames.len(), count);
    let expected: Vec<[usize; 2]> = (1..=count / 16).map(|step| [16 * step, count]).collect();
    assert_eq!(calls, expected);
    assert!(found.analysis.key_frames.len() > clip.labels.cuts.len());
    for key in &found.analysis.key_frames {
        let picture = pictures.picture(key.index).unwrap().unwrap();
        let pairs = picture.values().iter().zip(frames[key.index].values());
        // Grey in the range of television has fewer levels.
        let farthest = pairs.map(|(a, b)| a[1].abs_diff(b[1])).max();
        assert!(
            farthest.unwrap() <= 2,
            "{farthest:?} in frame {}",
            key.index
        );
    }

    // A frame takes six bytes of header and twelve bits a pixel.
    let frame = 6 + SIZE[0] * SIZE[1] * 3 / 2;
    let header = bytes.len() - count * frame;
    for (kept, is_whole) in [(header + 20 * frame + 100, true), (header + 100, false)] {
        std::fs::write(&path, &bytes[..kept]).unwrap();
        let found = analyse(&path, Options::default(), none(), None, |_, _| {});
        assert_eq!(found.is_ok(), is_whole);
        if let Ok(found) = found {
            assert_eq!(found.analysis.frames.len(), 20);
            let message = found.failure.unwrap().to_string();
            assert!(message.contains("film.y4m"), "{message}");
        }
    }
}
