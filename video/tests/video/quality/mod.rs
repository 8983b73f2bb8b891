//! Measures of frames and videos.

mod identity;
mod matching;
mod vif;

use ga_image::plane::Plane;
use ga_image::quality::{Ssim, Weights, mse, psnr, weighted_psnr};
use ga_image::y4m::Sampling;
use ga_image::ycbcr::YCbCr;
use ga_video::quality::{FrameQuality, Meter, Pooled, VideoComparison};
use ga_video::{Frame, Planes, Properties, Samples, Source, VideoError};
use proptest::prelude::*;

const SIZE: [usize; 2] = [48, 32];

/// A video in memory.
struct Memory {
    properties: Properties,
    frames: Vec<Samples>,
    next: usize,
    /// Seconds from each frame to the next.
    step_seconds: f64,
    /// The frame that cannot be read.
    broken: Option<usize>,
}

impl Memory {
    fn new(frames: Vec<Samples>) -> Self {
        let first = &frames[0];
        Self {
            properties: Properties {
                size: first.size(),
                sampling: Sampling::Quarter,
                bit_depth: first.bit_depth(),
                colours: YCbCr::default(),
                pixel_aspect: [1, 1],
                frames_per_second: Some([25, 1]),
                frame_count: Some(frames.len()),
            },
            frames,
            next: 0,
            step_seconds: 0.04,
            broken: None,
        }
    }
}

impl Source for Memory {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        if self.broken == Some(self.next) {
            return Err(VideoError::Truncated {
                file: "memory".into(),
                frame: self.next,
            });
        }
        let Some(samples) = self.frames.get(self.next) else {
            return Ok(false);
        };
        *frame = Frame {
            index: self.next,
            time_seconds: self.step_seconds * self.next as f64,
            samples: samples.clone(),
        };
        self.next += 1;
        Ok(true)
    }
}

fn planes(seed: usize) -> Planes<u8> {
    let plane = |width: usize, height: usize, step: usize| {
        Plane::from_fn(width, height, |x, y| {
            ((seed * 37 + x * step + y * y * 3 + x * y) % 200) as u8
        })
    };
    let [width, height] = SIZE;
    Planes {
        luma: plane(width, height, 5),
        differences: [
            plane(width / 2, height / 2, 7),
            plane(width / 2, height / 2, 11),
        ],
    }
}

/// Frames, and the same with errors that differ from frame to frame; the second has none.
fn pair(count: usize) -> [Vec<Planes<u8>>; 2] {
    let reference: Vec<_> = (0..count).map(planes).collect();
    let changed = |(index, planes): (usize, &Planes<u8>)| {
        let change = |plane: &Plane<u8>, bits: u8| match index {
            1 => plane.clone(),
            _ => plane.map(|v| v ^ (bits + index as u8)),
        };
        let [cb, cr] = &planes.differences;
        Planes {
            luma: change(&planes.luma, 1),
            differences: [change(cb, 1), change(cr, 4)],
        }
    };
    let distorted = reference.iter().enumerate().map(changed).collect();
    [reference, distorted]
}

fn eight(frames: &[Planes<u8>]) -> Memory {
    Memory::new(frames.iter().cloned().map(Samples::Eight).collect())
}

fn compared(reference: impl Source, distorted: impl Source) -> Vec<FrameQuality> {
    let comparison = VideoComparison::new(reference, distorted, None).unwrap();
    let stated = comparison.frame_count();
    let frames: Vec<FrameQuality> = comparison.map(Result::unwrap).collect();
    assert_eq!(stated, Some(frames.len()));
    frames
}

#[test]
fn frames_of_videos_have_the_measures_of_their_planes() {
    let [reference, distorted] = pair(4);
    let mut slower = eight(&distorted);
    slower.step_seconds = 0.05;
    let found = compared(eight(&reference), slower);
    assert_eq!(found.len(), 4);
    let mut meter = Meter::new(SIZE, 255.0).unwrap();
    for (index, frame) in found.iter().enumerate() {
        let (a, b) = (&reference[index], &distorted[index]);
        assert_eq!(
            (frame.index, frame.time_seconds),
            (index, 0.04 * index as f64)
        );
        assert_eq!(
            frame.luma,
            meter.compare(&a.luma, &b.luma, &a.luma).unwrap()
        );
        assert_eq!(frame.luma.mse, mse(&a.luma, &b.luma).unwrap());
        assert_eq!(frame.luma.psnr, psnr(&a.luma, &b.luma, 255.0).unwrap());
        let ssim = Ssim::new(255.0).compare(&a.luma, &b.luma).unwrap();
        assert_eq!(frame.luma.ssim, Some(ssim.ssim));
        // Fewer pixels than five scales need.
        assert_eq!(frame.luma.ms_ssim, None);
        let [cb, cr] = frame.psnr_differences.unwrap();
        assert_eq!(
            cb,
            psnr(&a.differences[0], &b.differences[0], 255.0).unwrap()
        );
        assert_eq!(
            cr,
            psnr(&a.differences[1], &b.differences[1], 255.0).unwrap()
        );
        assert!(index == 1 || cb > cr);
        let weighted = (6.0 * frame.luma.psnr + cb + cr) / 8.0;
        assert_eq!(frame.psnr_6_1_1(), Some(weighted));
    }
    assert_eq!(found[1].luma.psnr, f64::INFINITY);
    assert_eq!(
        [found[1].luma.ssim, found[1].luma.attention_ssim],
        [Some(1.0), Some(1.0)]
    );
    let same: Vec<bool> = found.iter().map(|frame| frame.same.is_all()).collect();
    assert_eq!(same, [false, true, false, false]);
    assert_eq!(found[1].ciede2000, Some(0.0));
    assert!((found[3].time_offset_seconds - 0.03).abs() < 1e-12);
}

/// Ten bits of four times the numbers differ by four times as much, in a range of 1023.
#[test]
fn ten_bits_have_their_own_range() {
    let [reference, distorted] = pair(2);
    let deep = |frames: &[Planes<u8>]| {
        let times_4 = |plane: &Plane<u8>| plane.map(|v| 4 * u16::from(v));
        let samples = frames.iter().map(|planes| {
            Samples::Ten(Planes {
                luma: times_4(&planes.luma),
                differences: planes.differences.each_ref().map(times_4),
            })
        });
        Memory::new(samples.collect())
    };
    let shallow = compared(eight(&reference), eight(&distorted))[0];
    let found = compared(deep(&reference), deep(&distorted))[0];
    let step = 20.0 * (1023.0 / 1020.0f64).log10();
    for (deep, shallow) in [
        (found.luma.psnr, shallow.luma.psnr),
        (found.luma.attention_psnr, shallow.luma.attention_psnr),
        (found.psnr_6_1_1().unwrap(), shallow.psnr_6_1_1().unwrap()),
    ] {
        assert!((deep - shallow - step).abs() < 1e-9);
    }
    let [a, b] = [found, shallow].map(|frame| frame.luma.ssim.unwrap());
    assert!((a - b).abs() < 1e-3);
    assert_eq!(found.ciede2000, None);

    let mixed = VideoComparison::new(eight(&reference), deep(&distorted), None);
    let message = mixed.err().unwrap().to_string();
    assert_eq!(message, "the videos differ in depth: 8 bits and 10 bits");
}

#[test]
fn a_given_map_weighs_all_frames() {
    let [reference, distorted] = pair(3);
    let map = Plane::from_fn(SIZE[0], SIZE[1], |x, y| (x + 3 * y) as f32);
    let map = Weights::new(map).unwrap();
    let comparison = VideoComparison::new(eight(&reference), eight(&distorted), Some(map.clone()));
    for (index, frame) in comparison.unwrap().enumerate() {
        let (a, b) = (&reference[index].luma, &distorted[index].luma);
        let expected = weighted_psnr(a, b, &map, 255.0).unwrap();
        assert_eq!(frame.unwrap().luma.attention_psnr, expected);
    }
    let other = Weights::new(Plane::filled(3, 3, 1.0)).unwrap();
    let mut comparison =
        VideoComparison::new(eight(&reference), eight(&distorted), Some(other)).unwrap();
    let error = comparison.next().unwrap().unwrap_err();
    assert!(matches!(
        error,
        VideoError::Unmeasured {
            frame: 0,
            problem: _
        }
    ));
    assert!(comparison.next().is_none());
}

#[test]
fn videos_of_other_lengths_and_broken_ones_give_the_frames_before() {
    let [reference, distorted] = pair(4);
    for (ended, first, second) in [("distorted", 4, 3), ("reference", 3, 4)] {
        let comparison = VideoComparison::new(
            eight(&reference[..first]),
            eight(&distorted[..second]),
            None,
        );
        let results: Vec<_> = comparison.unwrap().collect();
        assert_eq!(results.iter().filter(|result| result.is_ok()).count(), 3);
        let error = results.last().unwrap().as_ref().unwrap_err();
        assert_eq!(error.frame(), Some(3));
        let message = format!("the {ended} video has no frame 3, the other has");
        assert_eq!(error.to_string(), message);
    }
    let mut broken = eight(&distorted);
    broken.broken = Some(2);
    let comparison = VideoComparison::new(eight(&reference), broken, None).unwrap();
    let results: Vec<_> = comparison.collect();
    assert_eq!(results.len(), 3);
    let error = results[2].as_ref().unwrap_err();
    assert_eq!(error.frame(), Some(2));
    assert!(matches!(error, VideoError::Truncated { .. }));

    let mut small = eight(&distorted);
    small.properties.size = [32, 48];
    let error = VideoComparison::new(eight(&reference), small, None)
        .err()
        .unwrap();
    let message = "the videos differ in size: 48 × 32 pixels and 32 × 48 pixels";
    assert_eq!(error.to_string(), message);

    let mut other = eight(&distorted);
    other.properties.sampling = Sampling::Full;
    let error = VideoComparison::new(eight(&reference), other, None);
    let message = "the videos differ in sampling: Quarter and Full";
    assert_eq!(error.err().unwrap().to_string(), message);
}

#[test]
fn pooled_values_are_those_of_the_definitions() {
    // The percentiles are those of numpy.percentile([3, 1, 4, 1, 5, 9, 2, 6], [5, 25, 50, 75, 95]).
    let pooled = Pooled::new([3.0, 1.0, 4.0, 1.0, 5.0, 9.0, 2.0, 6.0]).unwrap();
    let expected = [1.0, 1.75, 3.5, 5.25, 7.95];
    for (got, expected) in pooled.percentiles.iter().zip(expected) {
        assert!((got - expected).abs() < 1e-12, "{got}, not {expected}");
    }
    assert_eq!((pooled.mean, pooled.least), (3.875, 1.0));
    let reciprocals = 1.0 / 3.0 + 2.0 + 0.25 + 0.2 + 1.0 / 9.0 + 0.5 + 1.0 / 6.0;
    assert!((pooled.harmonic_mean.unwrap() - 8.0 / reciprocals).abs() < 1e-12);

    assert_eq!(Pooled::new([]), None);
    assert_eq!(Pooled::new([1.0, f64::NAN]), None);
    assert_eq!(Pooled::new([0.0, 1.0]).unwrap().harmonic_mean, None);
    let infinite = Pooled::new([f64::INFINITY; 3]).unwrap();
    assert_eq!(infinite.percentiles, [f64::INFINITY; 5]);
    assert_eq!(infinite.harmonic_mean, Some(f64::INFINITY));
    let some = Pooled::new([30.0, f64::INFINITY, 30.0]).unwrap();
    assert_eq!(some.percentiles[..3], [30.0; 3]);
    assert_eq!(some.percentiles[4], f64::INFINITY);
}

proptest! {
    #[test]
    fn pooled_values_are_in_order(values in proptest::collection::vec(0.01f64..100.0, 1..40)) {
        let pooled = Pooled::new(values.iter().copied()).unwrap();
        let harmonic = pooled.harmonic_mean.unwrap();
        prop_assert!(pooled.least <= harmonic * (1.0 + 1e-12));
        prop_assert!(harmonic <= pooled.mean * (1.0 + 1e-12));
        prop_assert!(pooled.percentiles.is_sorted());
        prop_assert!(pooled.least <= pooled.percentiles[0]);
    }
}
