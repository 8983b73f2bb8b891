//! Films of other times or another size than their reference.

use ga_image::plane::Plane;
use ga_video::Planes;
use ga_video::quality::{Moments, Scaled, TimeAlignment, VideoComparison};

use super::{Memory, SIZE, compared, eight, planes};

/// A film whose first frames are missing, one with half of the frames, and one with both.
#[test]
fn frames_are_matched_by_their_times() {
    let reference: Vec<_> = (0..24).map(planes).collect();
    let moments = |frames: &[usize], step_seconds: f64| {
        let frames: Vec<_> = frames.iter().map(|frame| planes(*frame)).collect();
        let source = Memory {
            step_seconds,
            ..eight(&frames)
        };
        Moments::of(source).unwrap()
    };
    let whole = moments(&(0..24).collect::<Vec<_>>(), 0.04);
    let every = |first: usize, step: usize| (first..24).step_by(step).collect::<Vec<_>>();
    for (frames, step_seconds) in [
        (every(0, 1), 0.04),
        (every(5, 1), 0.04),
        (every(0, 2), 0.08),
        (every(3, 3), 0.12),
    ] {
        let found = TimeAlignment::find(&whole, &moments(&frames, step_seconds)).unwrap();
        let expected: Vec<_> = frames.iter().enumerate().map(|(k, f)| [*f, k]).collect();
        assert_eq!(found.pairs, expected);
        assert!((found.offset_seconds - 0.04 * frames[0] as f64).abs() < 1e-9);
        assert_eq!(found.mean_square_difference, 0.0);
        assert_eq!(found.unmatched_reference_frames, 24 - frames.len());
        assert_eq!(found.unmatched_distorted_frames, 0);
        let distorted: Vec<_> = frames.iter().map(|frame| planes(*frame)).collect();
        let comparison = VideoComparison::new(eight(&reference), eight(&distorted), None).unwrap();
        let compared: Vec<_> = comparison
            .of_pairs(found.pairs)
            .map(Result::unwrap)
            .collect();
        assert_eq!(compared.len(), frames.len());
        assert!(compared.iter().all(|frame| frame.same.is_all()));
        assert_eq!(compared.last().unwrap().index, *frames.last().unwrap());
    }
    // A film that begins earlier.
    let found = TimeAlignment::find(&moments(&every(4, 1), 0.04), &whole).unwrap();
    assert!((found.offset_seconds + 0.16).abs() < 1e-9);
    assert_eq!(
        (found.pairs[0], found.unmatched_distorted_frames),
        ([0, 4], 4)
    );
    // Nothing moves: no offset.
    assert!(found.frame_difference().is_some());
    let still = TimeAlignment::find(&moments(&[7; 20], 0.04), &moments(&[7; 15], 0.04)).unwrap();
    assert_eq!((still.offset_seconds, still.pairs.len()), (0.0, 15));
}

/// A plane of a linear slope is one at every size.
#[test]
fn films_of_another_size_are_scaled() {
    let slope = |width: usize, height: usize, left: f64| {
        Plane::from_fn(width, height, |x, y| {
            let [x, y] = [
                (x as f64 + 0.5) / width as f64,
                (y as f64 + 0.5) / height as f64,
            ];
            (left + 100.0 * x + 60.0 * y).round() as u8
        })
    };
    let film = |width: usize, height: usize| {
        let [w, h] = [width.div_ceil(2), height.div_ceil(2)];
        eight(&[Planes {
            luma: slope(width, height, 20.0),
            differences: [slope(w, h, 30.0), slope(w, h, 40.0)],
        }])
    };
    for [width, height] in [[24, 16], [96, 64], [31, 50]] {
        let scaled = Scaled::new(film(width, height), SIZE, [1, 1]);
        let found = compared(film(SIZE[0], SIZE[1]), scaled);
        let worst = found[0]
            .psnr_differences
            .unwrap()
            .into_iter()
            .fold(found[0].luma.psnr, f64::min);
        assert!(worst > 40.0, "{width} × {height}: {worst}");
    }
    let scaled = Scaled::new(film(SIZE[0], SIZE[1]), SIZE, [1, 1]);
    assert!(compared(film(SIZE[0], SIZE[1]), scaled)[0].same.is_all());
}
