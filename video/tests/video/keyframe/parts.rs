//! Signatures, layouts, differences, fades, timecodes and scores, one by one.

use ga_image::plane::Plane;
use ga_image::ycbcr::{Range, YCbCr};
use ga_video::keyframe::colour::Colour;
use ga_video::keyframe::difference::{after_motion, at_rest};
use ga_video::keyframe::evaluation::score;
use ga_video::keyframe::fade::{Direction, Level, fades};
use ga_video::keyframe::layout::Layout;
use ga_video::keyframe::scenes::{csv, edl};
use ga_video::keyframe::timecode::{TimeBase, rate_of_times};
use ga_video::keyframe::{Analyser, Background, Options, Shot, signature};
use ga_video::{Frame, Planes, Samples, VideoError};
use proptest::prelude::*;

use super::clips::{Effect, Joins, Random, clip};

/// Random planes of 4:2:0.
fn planes(seed: u64, [width, height]: [usize; 2]) -> Planes<u8> {
    let mut random = Random::new(seed);
    let mut plane = |width, height, low, high| {
        Plane::from_fn(width, height, |_, _| random.index(low..high) as u8)
    };
    let (half_width, half_height) = (width.div_ceil(2), height.div_ceil(2));
    Planes {
        luma: plane(width, height, 60, 180),
        differences: [
            plane(half_width, half_height, 118, 138),
            plane(half_width, half_height, 118, 138),
        ],
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Where boxes are whole pixels of both planes, the means of converted pixels are the same.
    #[test]
    fn red_is_the_mean_of_converted_pixels(seed: u64, across in 1usize..4, down in 1usize..4) {
        let planes = planes(seed, [128 * across, 72 * down]);
        for range in [Range::Limited, Range::Full] {
            let colours = YCbCr { range, ..YCbCr::default() };
            let found = signature::red(&Samples::Eight(planes.clone()), colours);
            prop_assert_eq!([found.width(), found.height()], [64, 36]);
            for (column, row) in [(0, 0), (17, 30), (63, 35)] {
                let mut sum = 0.0;
                for y in 2 * down * row..2 * down * (row + 1) {
                    for x in 2 * across * column..2 * across * (column + 1) {
                        let value = |plane: &Plane<u8>, x, y| plane.get(x, y).unwrap();
                        let rgb = colours.to_rgb([
                            value(&planes.luma, x, y),
                            value(&planes.differences[0], x / 2, y / 2),
                            value(&planes.differences[1], x / 2, y / 2),
                        ]);
                        sum += f64::from(rgb[0]);
                    }
                }
                let mean = sum / (4 * across * down) as f64;
                let found = f64::from(found.get(column, row).unwrap());
                // Converted pixels are rounded.
                prop_assert!((found - mean).abs() < 0.51, "{} {}", found, mean);
            }
        }
    }

    /// Pairs within the tolerance, counted by trying all subsets in turn.
    #[test]
    fn scores_pair_as_many_as_possible(
        found in proptest::collection::btree_set(0usize..30, 0..6),
        labels in proptest::collection::btree_set(0usize..30, 0..6),
        tolerance in 0usize..4,
    ) {
        fn most(found: &[usize], labels: &[usize], tolerance: usize) -> usize {
            let Some((first, rest)) = found.split_first() else { return 0 };
            let mut best = most(rest, labels, tolerance);
            for (index, label) in labels.iter().enumerate() {
                if first.abs_diff(*label) <= tolerance {
                    let mut others = labels.to_vec();
                    others.remove(index);
                    best = best.max(1 + most(rest, &others, tolerance));
                }
            }
            best
        }
        let (found, labels): (Vec<_>, Vec<_>) = (found.into_iter().collect(), labels.into_iter().collect());
        let scored = score(&found, &labels, tolerance);
        prop_assert_eq!(scored.correct, most(&found, &labels, tolerance));
        prop_assert_eq!(scored.correct + scored.extra, found.len());
        prop_assert_eq!(scored.correct + scored.missed, labels.len());
    }

    #[test]
    fn timecodes_count_frames(frame in 0usize..1_000_000, rate in 1u32..61) {
        let code = TimeBase::new([rate, 1], None).unwrap().code(frame as f64 / f64::from(rate));
        let parts: Vec<usize> = code.split(':').map(|part| part.parse().unwrap()).collect();
        let seconds = (60 * parts[0] + parts[1]) * 60 + parts[2];
        let day = 24 * 3600 * rate as usize;
        prop_assert_eq!(seconds * rate as usize + parts[3], frame % day);
    }
}

#[test]
fn small_and_deep_frames_have_signatures() {
    for size in [[1, 1], [3, 2], [63, 37], [65, 35]] {
        let samples = Samples::Eight(planes(3, size));
        let found = signature::red(&samples, YCbCr::default());
        assert_eq!(
            [found.width(), found.height()],
            [size[0].min(64), size[1].min(36)]
        );
        assert!(
            found
                .values()
                .iter()
                .all(|value| (0.0..=255.0).contains(value))
        );
    }
    let eight = planes(5, [256, 144]);
    let deep = |plane: &Plane<u8>| plane.map(|value| 4 * u16::from(value));
    let ten = Planes {
        luma: deep(&eight.luma),
        differences: [deep(&eight.differences[0]), deep(&eight.differences[1])],
    };
    let [a, b] = [Samples::Eight(eight), Samples::Ten(ten)]
        .map(|samples| signature::red(&samples, YCbCr::default()));
    for (a, b) in a.values().iter().zip(b.values()) {
        assert!((a - b).abs() < 1e-3, "{a} {b}");
    }
}

#[test]
fn a_moved_picture_does_not_differ_and_another_one_does() {
    let texture = |seed: u64| clip(seed, Joins::Cuts, Effect::None).frames[0].map(f32::from);
    let part = |plane: &Plane<f32>, x: usize, y: usize| {
        plane
            .view()
            .part(20 + x, 20 + y, 64, 36)
            .unwrap()
            .to_plane()
    };
    for seed in 0..8 {
        let plane = texture(seed);
        let (a, b) = (part(&plane, 5, 3), part(&plane, 0, 0));
        for layout in [Layout::Five, Layout::Paper] {
            let moved = after_motion(&a, &b, layout);
            assert_eq!(moved.motion, [5, 3]);
            assert!(moved.typical() < 1e-3);
            assert!(at_rest(&a, &b, layout).typical() > 0.05);
            let other = part(&texture(seed + 100), 0, 0);
            assert!(after_motion(&a, &other, layout).typical() > 0.3);
            let dark = a.map(|value| 0.75 * value);
            assert!(at_rest(&a, &dark, layout).typical() < 0.02);
        }
    }
}

#[test]
fn fades_are_steady_rises_from_even_frames() {
    let level = |part: f32| Level {
        mean: 120.0 * part,
        deviation: 40.0 * part,
    };
    let mut levels = vec![level(0.0); 4];
    levels.extend((1..=20).map(|step| level(step as f32 / 20.0)));
    levels.extend([level(1.0); 30]);
    levels.extend((1..=10).rev().map(|step| level((step - 1) as f32 / 10.0)));
    levels.extend([level(0.0); 3]);
    let found = fades(&levels, &vec![[70, 0, 0]; levels.len()]);
    assert_eq!(found.len(), 2);
    assert_eq!(
        [found[0].direction, found[1].direction],
        [Direction::In, Direction::Out]
    );
    assert_eq!(found[0].colour, Colour::Other([70, 0, 0]));
    assert_eq!(found[0].frames.start, 0);
    assert!(found[0].frames.end.abs_diff(24) <= 1, "{found:?}");
    assert!(found[1].frames.start.abs_diff(54) <= 1, "{found:?}");
    assert_eq!(found[1].frames.end, levels.len());

    // A hard cut from black is not a fade.
    let mut levels = vec![level(0.0); 4];
    levels.extend([level(1.0); 30]);
    assert!(fades(&levels, &vec![[70, 0, 0]; levels.len()]).is_empty());
}

#[test]
fn scenes_are_tables_and_edit_decision_lists() {
    let shot = |frames, background| Shot { frames, background };
    let shots = [
        shot(0..285, Background::Dynamic),
        shot(285..720, Background::Static),
    ];
    let times: Vec<f64> = (0..=720).map(|frame| f64::from(frame) / 24.0).collect();
    let base = TimeBase::new([24, 1], None).unwrap();
    assert_eq!(
        csv(&shots, &times, Some(base)),
        "shot,start,end,start_timecode,end_timecode,frames,background,start_seconds,end_seconds,\
         rate\n\
         1,0,285,00:00:00:00,00:00:11:21,285,dynamic,0.000000,11.875000,24/1\n\
         2,285,720,00:00:11:21,00:00:30:00,435,static,11.875000,30.000000,24/1\n"
    );
    assert!(csv(&shots, &times, None).contains("\n1,0,285,,,285,dynamic,0.000000,11.875000,\n"));
    let list = edl(&shots, &times, base, "film\n.mp4");
    assert!(
        list.starts_with("TITLE: film.mp4\nFCM: NON-DROP FRAME\n\n001  AX       V     C        ")
    );
    assert!(list.contains("00:00:11:21 00:00:30:00 00:00:11:21 00:00:30:00\n"));
    let dropped = TimeBase::new([30_000, 1001], Some("01:00:00;00")).unwrap();
    let list = edl(&shots, &times, dropped, "film");
    assert!(
        list.contains("FCM: DROP FRAME") && list.contains(" 01:00:11;26 01:00:29;29 "),
        "{list}"
    );
}

/// Frames 0 and 1 of each minute but every tenth are left out, counted one by one.
#[test]
fn dropped_numbers_follow_the_clock() {
    for (rate, start, nominal) in [
        ([30_000, 1001], "00:00:00;00", 30),
        ([60_000, 1001], "00:00:00;00", 60),
    ] {
        let base = TimeBase::new(rate, Some(start)).unwrap();
        let mut parts = [0, 0, 0];
        for frame in 0..40 * 60 * nominal {
            let [minutes, seconds, frames] = parts;
            let time = frame as f64 * 1001.0 / f64::from(rate[0]);
            let expected = format!("00:{minutes:02}:{seconds:02};{frames:02}");
            assert_eq!(base.code(time), expected);
            parts[2] += 1;
            if parts[2] == nominal {
                parts = [minutes, seconds + 1, 0];
            }
            if parts[1] == 60 {
                let left_out = if (minutes + 1) % 10 == 0 {
                    0
                } else {
                    nominal / 15
                };
                parts = [minutes + 1, 0, left_out];
            }
        }
        // An hour by the clock, within the tenth of a second that remains.
        assert!(base.code(3600.0).starts_with("01:00:00;0"));
    }
    for wrong in [
        "00:01:00;00",
        "1:00:00:00",
        "00:00:00:30",
        "00:60:00:00",
        "00;00:00:00",
        "x",
    ] {
        assert!(
            TimeBase::new([30_000, 1001], Some(wrong)).is_err(),
            "{wrong}"
        );
    }
    let error = TimeBase::new([25, 1], Some("00:00:00;00")).unwrap_err();
    assert!(error.to_string().contains("25/1"), "{error}");
    assert!(TimeBase::new([25, 0], None).is_err());
}

#[test]
fn rates_are_those_of_all_times() {
    let times = |rate: f64, kept: fn(&usize) -> bool| -> Vec<f64> {
        let frames = (0..600).filter(kept);
        // To the millisecond, as some containers have them.
        frames
            .map(|frame| (1000.0 * frame as f64 / rate).round() / 1000.0)
            .collect()
    };
    let ntsc = 24_000.0 / 1001.0;
    assert_eq!(
        rate_of_times(&times(ntsc, |frame| frame % 3 != 2)),
        Some([24_000, 1001])
    );
    assert_eq!(
        rate_of_times(&times(25.0, |frame| frame % 7 != 2)),
        Some([25, 1])
    );
    assert_eq!(
        rate_of_times(&times(60.0, |frame| frame % 5 != 1)),
        Some([60, 1])
    );
    let wandering: Vec<f64> = (0..100)
        .map(|frame| f64::from(frame).powf(1.1) / 25.0)
        .collect();
    assert_eq!(rate_of_times(&wandering), None);
    assert_eq!(rate_of_times(&[0.0]), None);
}

#[test]
fn a_frame_of_another_size_is_an_error() {
    let mut analyser = Analyser::new(Options::default(), YCbCr::default());
    let frame = |size| Frame {
        samples: Samples::Eight(planes(1, size)),
        ..Frame::default()
    };
    analyser.push(&frame([64, 36])).unwrap();
    let error = analyser.push(&frame([64, 40])).unwrap_err();
    let is_expected = matches!(
        error,
        VideoError::KeyFrameSize {
            frame: 1,
            size: [64, 40],
            first: [64, 36],
        }
    );
    assert!(is_expected, "{error}");
    // What was analysed before remains.
    assert_eq!(analyser.finish().frames.len(), 1);
    let empty = Analyser::new(Options::default(), YCbCr::default()).finish();
    assert!(empty.frames.is_empty() && empty.shots.is_empty() && empty.key_frames.is_empty());
}
