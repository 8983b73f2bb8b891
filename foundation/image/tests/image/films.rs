//! Films: Y4M and animated PNG.

use ga_image::file::{self, FormatError};
use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::png::{self, Animation};
use ga_image::y4m::{self, Film, Reader, Sampling};
use ga_image::ycbcr::{Range, YCbCr};
use nullcone_shared_data::shared;

fn frames() -> Vec<Plane<[u8; 3]>> {
    let frame = |index: usize| {
        Plane::from_fn(7, 5, |column, row| {
            [30 * column, 50 * row, 60 * index].map(|v| v as u8)
        })
    };
    (0..3).map(frame).collect()
}

#[test]
fn a_film_at_full_sampling_comes_back() {
    for range in [Range::Limited, Range::Full] {
        let colours = YCbCr {
            luma: Luma::Bt709,
            range,
        };
        let film = Film {
            frames_per_second: [30000, 1001],
            sampling: Sampling::Full,
            colours,
            pixel_aspect: [4, 3],
        };
        let bytes = y4m::encode(frames(), film).unwrap();
        let reader = Reader::new(&bytes).unwrap();
        assert_eq!(reader.film().frames_per_second, [30000, 1001]);
        assert_eq!(reader.film().pixel_aspect, [4, 3]);
        assert_eq!(reader.film().colours.range, range);
        let read: Vec<_> = reader.map(|frame| frame.unwrap().to_rgb(colours)).collect();
        assert_eq!(read.len(), 3);
        for (read, frame) in read.iter().zip(frames()) {
            for (a, b) in read.values().iter().zip(frame.values()) {
                assert!((0..3).all(|i| a[i].abs_diff(b[i]) <= 2), "{a:?}, not {b:?}");
            }
        }
    }
}

/// 2 × 2 squares of one colour keep it at a quarter of the differences.
#[test]
fn colour_differences_are_means_of_squares() {
    let frame = Plane::from_fn(3, 3, |column, row| match (column, row) {
        (2, _) => [255, 0, 0],
        (_, 2) => [0, 0, 255],
        (c, r) => [if c == r { 255u8 } else { 0 }; 3],
    });
    let bytes = y4m::encode([&frame], Film::default()).unwrap();
    let frame = Reader::new(&bytes).unwrap().next().unwrap().unwrap();
    let differences = frame.differences.map(|plane| plane.to_plane());
    assert_eq!(differences[0].values(), [128, 90, 240, 90]);
    assert_eq!(differences[1].values(), [128, 240, 110, 240]);
    assert_eq!(frame.luma.row(0), [235, 16, 81]);
}

#[test]
fn films_of_other_programs_are_read() {
    let Some(path) = shared("data/vision/clips/bbb_f265-305_320x180_cut285.y4m") else {
        return;
    };
    let bytes = std::fs::read(&path).unwrap();
    let reader = Reader::new(&bytes).unwrap();
    assert_eq!((reader.width(), reader.height()), (320, 180));
    assert_eq!(reader.film().sampling, Sampling::Quarter);
    assert_eq!(reader.map(Result::unwrap).count(), 41);
    let Picture::Rgb8(first) = file::read(&path).unwrap() else {
        panic!("not RGB")
    };
    assert_eq!((first.width(), first.height()), (320, 180));
}

#[test]
fn a_film_that_ends_within_a_frame_is_an_error() {
    let bytes = y4m::encode(frames(), Film::default()).unwrap();
    let results: Vec<_> = Reader::new(&bytes[..bytes.len() - 1]).unwrap().collect();
    assert_eq!(results.len(), 3);
    assert!(results[..2].iter().all(Result::is_ok));
    let message = results[2].as_ref().unwrap_err().to_string();
    assert!(
        message.ends_with("the film ends within a frame"),
        "{message}"
    );
}

#[test]
fn frames_of_different_sizes_make_no_film() {
    let mut frames = frames();
    frames[1] = Plane::filled(7, 6, [0; 3]);
    assert!(matches!(
        y4m::encode(&frames, Film::default()),
        Err(FormatError::FrameSize { frame: 1, .. })
    ));
    assert!(matches!(
        png::encode_animation(&frames, Animation::default()),
        Err(FormatError::FrameSize { frame: 1, .. })
    ));
    assert!(matches!(
        png::encode_animation(&frames[..0], Animation::default()),
        Err(FormatError::Frames { frames: 0, .. })
    ));
    assert!(y4m::encode(&frames[..0], Film::default()).is_err());
}

/// The chunks of the file, by the specification of PNG: length, name, data, check sum.
fn chunks(bytes: &[u8]) -> Vec<(String, Vec<u8>)> {
    let mut rest = &bytes[8..];
    let mut chunks = Vec::new();
    while !rest.is_empty() {
        let length = u32::from_be_bytes(rest[..4].try_into().unwrap()) as usize;
        let name = String::from_utf8(rest[4..8].to_vec()).unwrap();
        chunks.push((name, rest[8..8 + length].to_vec()));
        rest = &rest[12 + length..];
    }
    chunks
}

#[test]
fn an_animation_states_its_frames_and_their_time() {
    let animation = Animation {
        frames_per_second: [24, 1],
        plays: 2,
    };
    let bytes = png::encode_animation(frames(), animation).unwrap();
    let chunks = chunks(&bytes);
    let named = |name: &str| -> Vec<&Vec<u8>> {
        let of_name = chunks.iter().filter(|(n, _)| n == name);
        of_name.map(|(_, data)| data).collect()
    };
    assert_eq!(named("acTL"), [&vec![0, 0, 0, 3, 0, 0, 0, 2]]);
    let controls = named("fcTL");
    assert_eq!(controls.len(), 3);
    // Numerator and denominator of the seconds of a frame.
    assert!(controls.iter().all(|c| c[20..24] == [0, 1, 0, 24]));
    assert_eq!(png::decode(&bytes).unwrap(), frames()[0].clone().into());
}
