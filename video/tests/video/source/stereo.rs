//! Videos of two views.

use std::io::Cursor;

use ga_image::plane::Plane;
use ga_image::y4m::{self as film, Film, Sampling};
use ga_video::stereo::{Layout, StereoSource};
use ga_video::y4m::Y4mSource;
use ga_video::{Frame, Source, VideoError};
use nullcone_shared_data::shared;
use proptest::prelude::*;

use super::levels;

type Video = Box<dyn Source + Send>;

fn video(bytes: Vec<u8>) -> Video {
    Box::new(Y4mSource::new(Cursor::new(bytes), "film.y4m").unwrap())
}

fn pairs(source: &mut StereoSource) -> (Vec<[Frame; 2]>, Result<(), VideoError>) {
    let (mut pairs, mut pair) = (Vec::new(), <[Frame; 2]>::default());
    loop {
        match source.read(&mut pair) {
            Ok(true) => pairs.push(pair.clone()),
            Ok(false) => return (pairs, Ok(())),
            Err(error) => {
                assert!(matches!(source.read(&mut pair), Ok(false)));
                return (pairs, Err(error));
            }
        }
    }
}

proptest! {
    /// The halves of a frame are what the halves of its picture encode to, where no colour
    /// difference belongs to both.
    #[test]
    fn halves_are_parts_of_the_frame(
        (columns, rows) in (1usize..5, 1usize..5),
        sampling in prop::sample::select(vec![
            Sampling::Quarter, Sampling::Half, Sampling::Full, Sampling::Grey,
        ]),
        (layout, aspect) in prop::sample::select(vec![
            (Layout::SideBySide, [4, 3]),
            (Layout::TopBottom, [4, 3]),
            (Layout::HalfSideBySide, [8, 3]),
            (Layout::HalfTopBottom, [2, 3]),
        ]),
        seed in any::<u8>(),
    ) {
        let (width, height) = (4 * columns, 4 * rows);
        let pixel = |c: usize, r: usize| {
            let mix = seed.wrapping_add((31 * c + 57 * r) as u8);
            [mix, mix.wrapping_mul(3), mix.wrapping_mul(11)]
        };
        let film = Film { sampling, pixel_aspect: [4, 3], ..Film::default() };
        let encode = |size: [usize; 2], start: [usize; 2]| {
            let part = Plane::from_fn(size[0], size[1], |c, r| pixel(c + start[0], r + start[1]));
            film::encode([&part], film).unwrap()
        };
        let whole = video(encode([width, height], [0, 0]));
        let mut source = StereoSource::halves(whole, layout).unwrap();
        let (size, second) = match layout {
            Layout::SideBySide | Layout::HalfSideBySide => ([width / 2, height], [width / 2, 0]),
            Layout::TopBottom | Layout::HalfTopBottom => ([width, height / 2], [0, height / 2]),
        };
        prop_assert_eq!(source.properties().pixel_aspect, aspect);
        prop_assert_eq!(source.frame_aspect(), [4, 3]);
        prop_assert_eq!(source.properties().size, size);
        let (found, end) = pairs(&mut source);
        prop_assert!(end.is_ok() && found.len() == 1);
        for (side, start) in [[0, 0], second].into_iter().enumerate() {
            let mut expected = Frame::default();
            video(encode(size, start)).read(&mut expected).unwrap();
            prop_assert_eq!(&found[0][side], &expected);
        }
    }
}

#[test]
fn views_of_odd_width_have_all_their_differences() {
    for (width, layout) in [(6, Layout::SideBySide), (2, Layout::SideBySide)] {
        let bytes = levels([width, 3], &[9], Film::default());
        let mut source = StereoSource::halves(video(bytes), layout).unwrap();
        let (found, _) = pairs(&mut source);
        for frame in &found[0] {
            let planes = frame.samples.eight_bits();
            let half = width / 2;
            assert_eq!((planes.luma.width(), planes.luma.height()), (half, 3));
            let cb = &planes.differences[0];
            assert_eq!((cb.width(), cb.height()), (half.div_ceil(2), 2));
        }
    }
}

#[test]
fn odd_sides_cannot_be_halved() {
    let bytes = || levels([5, 3], &[9], Film::default());
    for (layout, expected) in [
        (Layout::SideBySide, "two views side by side"),
        (Layout::TopBottom, "two views one above the other"),
    ] {
        let error = StereoSource::halves(video(bytes()), layout).err().unwrap();
        let message = error.to_string();
        assert!(
            message.contains("5 × 3") && message.ends_with(expected),
            "{message}"
        );
    }
}

#[test]
fn two_videos_are_read_together() {
    let film = Film::default();
    let left = video(levels([4, 2], &[0, 255], film));
    let right = video(levels([4, 2], &[255, 0], film));
    let (found, end) = pairs(&mut StereoSource::pair(left, right).unwrap());
    assert!(end.is_ok());
    let levels: Vec<_> = found
        .iter()
        .map(|pair| {
            pair.each_ref()
                .map(|f| f.samples.eight_bits().luma.get(0, 0).unwrap())
        })
        .collect();
    assert_eq!(levels, [[16, 235], [235, 16]]);
}

#[test]
fn videos_that_differ_are_not_a_pair() {
    let film = Film::default();
    let slow = Film {
        frames_per_second: [24, 1],
        ..film
    };
    let full = Film {
        sampling: Sampling::Full,
        ..film
    };
    let first = || video(levels([4, 2], &[0, 1, 2], film));
    let cases = [
        (
            levels([4, 3], &[0], film),
            "size: 4 × 2 pixels and 4 × 3 pixels",
        ),
        (
            levels([4, 2], &[0], slow),
            "rate of frames: 25/1 per second and 24/1 per second",
        ),
        (
            levels([4, 2], &[0], full),
            "samples: 8 bits, Quarter and 8 bits, Full",
        ),
    ];
    for (bytes, expected) in cases {
        let error = StereoSource::pair(first(), video(bytes))
            .err()
            .unwrap()
            .to_string();
        assert!(error.ends_with(expected), "{error}");
    }
    // The same rate in other numbers.
    let doubled = Film {
        frames_per_second: [50, 2],
        ..film
    };
    let short = || video(levels([4, 2], &[0, 1], doubled));
    for (left, right, side) in [(first(), short(), "right"), (short(), first(), "left")] {
        let (found, end) = pairs(&mut StereoSource::pair(left, right).unwrap());
        assert_eq!(found.len(), 2);
        let message = end.unwrap_err().to_string();
        assert_eq!(
            message,
            format!("the {side} video has no frame 2, the other has")
        );
    }
}

/// A source whose frames come at given times.
struct Timed(Video, std::vec::IntoIter<f64>);

impl Source for Timed {
    fn properties(&self) -> &ga_video::Properties {
        self.0.properties()
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        let has_frame = self.0.read(frame)?;
        frame.time_seconds = self.1.next().unwrap_or(frame.time_seconds);
        Ok(has_frame)
    }
}

#[test]
fn frames_at_different_times_are_not_a_pair() {
    let timed = |times: &[f64]| {
        let bytes = levels([4, 2], &[0, 1, 2], Film::default());
        Box::new(Timed(video(bytes), Vec::from(times).into_iter()))
    };
    let left = timed(&[0.0, 0.04, 0.08]);
    let right = timed(&[0.0, 0.041, 0.12]);
    let (found, end) = pairs(&mut StereoSource::pair(left, right).unwrap());
    assert_eq!(found.len(), 2);
    let error = end.unwrap_err();
    assert!(
        matches!(error, VideoError::Time { frame: 2, .. }),
        "{error}"
    );
}

/// The right half of the shared clip is the left one moved by its disparity, so that the two have
/// nearly the same mean where no defect was added.
#[test]
fn the_shared_clip_has_two_views() {
    let Some(path) = shared("data/vision/clips/motorcycle_sbs_960x324_defects.y4m") else {
        return;
    };
    let source = ga_video::open(path).unwrap();
    let mut source = StereoSource::halves(source, Layout::SideBySide).unwrap();
    assert_eq!(source.properties().size, [480, 324]);
    let (found, end) = pairs(&mut source);
    assert!(end.is_ok() && found.len() == 48);
    let mean = |frame: &Frame| {
        let planes = frame.samples.eight_bits();
        let values = planes.luma.values();
        values.iter().map(|v| f64::from(*v)).sum::<f64>() / values.len() as f64
    };
    // By the list of defects: none before frame 8, the right view 25 brighter from 14 to 20.
    let difference = |index: usize| mean(&found[index][1]) - mean(&found[index][0]);
    assert!(difference(4).abs() < 3.0, "{}", difference(4));
    let brighter = difference(16) - difference(4);
    assert!((15.0..30.0).contains(&brighter), "{brighter}");
}
