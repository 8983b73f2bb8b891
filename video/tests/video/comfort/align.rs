//! Differences between the views of real pairs, removed again.

use std::io::Cursor;

use ga_image::plane::Plane;
use ga_image::y4m::{Film, Sampling, Writer};
use ga_video::comfort::align::{Correction, Corrector, Plan};
use ga_video::comfort::stereoscopy::Alignment;
use ga_video::comfort::{ComfortError, Dimension, FrameMeasures, Level, Tone};
use ga_video::stereo::{Layout, StereoSource, joined};
use ga_video::y4m::Y4mSource;
use ga_video::{Planes, Samples};
use nullcone_shared_data::shared;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::inputs::{
    COLOURS, Motion, PAIRS, Picture, level, measures, moved, pair, picture, samples,
};

/// A film side by side of views that are given for each frame.
fn film(views: &[[Samples; 2]], sampling: Sampling) -> Vec<u8> {
    let film = Film {
        sampling,
        colours: COLOURS,
        ..Film::default()
    };
    let whole = |[left, right]: &[Samples; 2]| joined([left, right], Layout::SideBySide).unwrap();
    let first = whole(&views[0]);
    let mut bytes = Vec::new();
    let mut writer = Writer::new(&mut bytes, first.size(), first.bit_depth(), film).unwrap();
    for pair in views {
        match &whole(pair) {
            Samples::Eight(Planes {
                luma,
                differences: [cb, cr],
            }) => writer.write([luma, cb, cr]),
            Samples::Ten(Planes {
                luma,
                differences: [cb, cr],
            }) => writer.write([luma, cb, cr]),
        }
        .unwrap();
    }
    bytes
}

fn open(bytes: &[u8]) -> StereoSource {
    let source = Y4mSource::new(Cursor::new(bytes.to_vec()), "film.y4m").unwrap();
    StereoSource::halves(Box::new(source), Layout::SideBySide).unwrap()
}

/// The plan for a film, and its views after it.
fn aligned(bytes: &[u8]) -> (Plan, Vec<[Samples; 2]>) {
    let layout = Some(Layout::SideBySide);
    let plan = Plan::of(|| Ok(open(bytes)), layout, 2, |_, _| {}).unwrap();
    let mut views = Vec::new();
    plan.apply(&mut open(bytes), |pair| {
        views.push(pair.map(|frame| frame.samples.clone()));
        Ok::<(), ComfortError>(())
    })
    .unwrap();
    assert_eq!(views.len(), plan.frames());
    (plan, views)
}

fn measured([left, right]: &[Samples; 2]) -> FrameMeasures {
    FrameMeasures::of(left, right, COLOURS).unwrap()
}

/// The rows that must be green after alignment.
const MENDED: [Dimension; 3] = [
    Dimension::Brightness,
    Dimension::Colour,
    Dimension::Vertical,
];

#[test]
fn combined_defects_of_real_pairs_are_removed() {
    for (index, paths) in PAIRS.into_iter().enumerate() {
        let Some([left, right]) = pair(paths) else {
            return;
        };
        let mut random = ChaCha8Rng::seed_from_u64(70 + index as u64);
        let mut amount = |most: f64| most * (f64::from(random.next_u32()) / 2_147_483_648.0 - 1.0);
        let motion = Motion {
            down: amount(0.02 * right.height() as f64),
            degrees: amount(1.5),
            percent: amount(3.0),
            right: 0.0,
        };
        let gains = [0.8, 0.8, 0.8].map(|usual| usual + amount(0.1));
        let offset = 20.0 + amount(8.0);
        let changed = moved(&right, motion).map(|rgb: [f32; 3]| {
            [0, 1, 2].map(|k: usize| (gains[k] * f64::from(rgb[k]) + offset) as f32)
        });
        let before = measures(&left, &changed);
        let bad = |dimension| level(&before, dimension) != Level::Green;
        assert!(
            bad(Dimension::Vertical) || bad(Dimension::Colour),
            "{paths:?}"
        );
        let film = film(&[[samples(&left), samples(&changed)]], Sampling::Full);
        let (plan, views) = aligned(&film);
        assert_eq!((plan.exchanged_frames(), plan.delay().measured), (0, 0));
        assert_eq!(views[0][0], samples(&left), "the left view stays as it is");
        let after = measured(&views[0]);
        for dimension in MENDED {
            assert_eq!(
                level(&after, dimension),
                Level::Green,
                "{paths:?} {after:?}"
            );
        }
        let geometry = after.geometry.unwrap();
        assert!(geometry.shift_px.abs() < 0.1, "{paths:?} {geometry:?}");
        assert!(
            geometry.rotation_degrees.abs() < 0.03,
            "{paths:?} {geometry:?}"
        );
        assert!(geometry.zoom_percent.abs() < 0.1, "{paths:?} {geometry:?}");
        let photometry = after.photometry.unwrap();
        assert!(
            photometry.offset_codes.abs() < 1.0,
            "{paths:?} {photometry:?}"
        );
        assert!(
            photometry.colour_difference < 1.0,
            "{paths:?} {photometry:?}"
        );
    }
}

/// A picture of half the size, whose pixels are means of four, from the row `first` on.
fn halved(picture: &Picture, first: usize) -> Picture {
    Plane::from_fn(
        picture.width() / 2,
        picture.height() / 2 - 1,
        |column, row| {
            let mut sum = [0.0; 3];
            for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let pixel = picture.get(2 * column + x, 2 * row + first + y).unwrap();
                sum = [0, 1, 2].map(|k| sum[k] + 0.25 * pixel[k]);
            }
            sum
        },
    )
}

/// Half a pixel is where interpolation blurs most.
#[test]
fn the_right_view_stays_sharp() {
    for paths in PAIRS {
        let Some([left, right]) = pair(paths) else {
            return;
        };
        let straight = measures(&halved(&left, 0), &halved(&right, 0));
        let views = [halved(&left, 1), halved(&right, 0)].map(|view| samples(&view));
        let before = measured(&views).geometry.unwrap().shift_px;
        let usual = straight.geometry.unwrap().shift_px;
        assert!(
            (before - usual - 0.5).abs() < 0.1,
            "{paths:?}: {before} {usual}"
        );
        let (plan, views) = aligned(&film(&[views], Sampling::Full));
        assert_ne!(*plan.corrections().next().unwrap(), Correction::default());
        let after = measured(&views[0]);
        let blurred = after.sharpness_log2.unwrap() - straight.sharpness_log2.unwrap();
        assert!(blurred.abs() < 0.1, "{paths:?}: {blurred}");
        assert_eq!(
            level(&after, Dimension::FocalGap),
            Level::Green,
            "{paths:?}"
        );
        assert!(after.geometry.unwrap().shift_px.abs() < 0.1, "{paths:?}");
    }
}

/// Measures of a still clip differ from frame to frame because of noise; the picture must not.
#[test]
fn a_noisy_still_clip_does_not_tremble() {
    let Some([left, right]) = pair(PAIRS[3]) else {
        return;
    };
    let motion = Motion {
        down: 2.3,
        degrees: 0.4,
        percent: -1.0,
        right: 0.0,
    };
    let right = moved(&right, motion).map(|rgb: [f32; 3]| rgb.map(|code| 0.85 * code + 6.0));
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut noisy = |view: &Picture| {
        let mut noise = || {
            let sum: f32 = (0..4)
                .map(|_| random.next_u32() as f32 / u32::MAX as f32 - 0.5)
                .sum();
            14.0 * sum
        };
        samples(&view.map(|rgb| rgb.map(|code| code + noise())))
    };
    let clip: Vec<_> = (0..20).map(|_| [noisy(&left), noisy(&right)]).collect();
    let shifts = clip
        .iter()
        .map(|views| measured(views).geometry.unwrap().shift_px);
    let shifts: Vec<f64> = shifts.collect();
    assert!(shifts.windows(2).any(|pair| pair[0] != pair[1]));
    let (plan, _) = aligned(&film(&clip, Sampling::Full));
    let corrections: Vec<&Correction> = plan.corrections().collect();
    let half_width = 0.5 * left.width() as f64;
    for pair in corrections.windows(2) {
        let [a, b] = [pair[0].alignment, pair[1].alignment];
        let change = (a.shift_px - b.shift_px).abs()
            + half_width * (a.rotation_degrees - b.rotation_degrees).abs().to_radians()
            + half_width * 0.01 * (a.zoom_percent - b.zoom_percent).abs();
        assert!(change < 0.1, "{a:?} {b:?}");
        for (a, b) in pair[0].tones.iter().zip(&pair[1].tones) {
            let change = [0.0, 255.0].map(|code| (a.apply(code) - b.apply(code)).abs());
            assert!(change.iter().all(|codes| *codes < 0.5), "{a:?} {b:?}");
        }
    }
    let found = corrections[0].alignment;
    assert!((found.shift_px - 2.3).abs() < 0.1, "{found:?}");
    assert!((found.rotation_degrees - 0.4).abs() < 0.03, "{found:?}");
    assert!((found.zoom_percent + 1.0).abs() < 0.1, "{found:?}");
}

#[test]
fn defects_of_a_real_clip_are_removed() {
    let Some(path) = shared("data/vision/clips/motorcycle_sbs_960x324_defects.y4m") else {
        return;
    };
    let bytes = std::fs::read(path).unwrap();
    let colours = open(&bytes).properties().colours;
    let (plan, views) = aligned(&bytes);
    // The views of frames 26 to 31 are exchanged.
    assert_eq!(plan.exchanged_frames(), 6);
    assert_eq!(views.len(), 48);
    for (frame, [left, right]) in views.iter().enumerate() {
        let found = FrameMeasures::of(left, right, colours).unwrap();
        for dimension in MENDED {
            assert_eq!(level(&found, dimension), Level::Green, "{frame} {found:?}");
        }
        // Blur remains.
        let is_blurred = (32..38).contains(&frame);
        let is_green = level(&found, Dimension::FocalGap) == Level::Green;
        assert_eq!(is_green, !is_blurred, "{frame} {found:?}");
        assert!(found.geometry.unwrap().zoom_percent.abs() < 0.1, "{frame}");
    }
}

#[test]
fn cases_of_the_oracle_are_mended() {
    let folder = "oracle/vision/seed1";
    for index in 7..26 {
        let view = |eye| Some(picture(&shared(&format!("{folder}/c{index}_{eye}.png"))?));
        let (Some(left), Some(right)) = (view('L'), view('R')) else {
            return;
        };
        let (_, views) = aligned(&film(&[[samples(&left), samples(&right)]], Sampling::Full));
        let found = measured(&views[0]);
        for dimension in MENDED {
            assert_eq!(level(&found, dimension), Level::Green, "c{index} {found:?}");
        }
        let geometry = found.geometry.unwrap();
        assert!(geometry.zoom_percent.abs() < 0.1, "c{index} {geometry:?}");
        if index == 25 {
            let parallax = found.parallax.unwrap();
            assert!((parallax.near_px + 8.0).abs() < 0.2, "{parallax:?}");
        }
    }
}

/// What is changed is the true right view, by its differences from the true left one.
#[test]
fn exchanged_views_are_corrected_in_their_order() {
    let folder = "oracle/vision/seed1";
    let view = |eye| Some(picture(&shared(&format!("{folder}/c24_{eye}.png"))?));
    let (Some(left), Some(right)) = (view('L'), view('R')) else {
        return;
    };
    let motion = Motion {
        down: 5.0,
        ..Motion::default()
    };
    let changed = moved(&right, motion).map(|rgb: [f32; 3]| rgb.map(|code| code + 12.0));
    let stored = [samples(&changed), samples(&left)];
    let (plan, views) = aligned(&film(&[stored], Sampling::Full));
    assert_eq!(plan.exchanged_frames(), 1);
    assert_eq!(views[0][0], samples(&left));
    let correction = plan.corrections().next().unwrap();
    assert!(
        (correction.alignment.shift_px - 5.0).abs() < 0.1,
        "{correction:?}"
    );
    for tone in &correction.tones {
        assert!((tone.apply(100.0) - 88.0).abs() < 1.0, "{correction:?}");
    }
}

/// Against the rotation, size and shift of a picture by an independent routine.
#[test]
fn pixels_are_taken_from_where_the_alignment_says() {
    let smooth =
        |x: f64, y: f64| 120.0 + 50.0 * (0.11 * x).sin() + 40.0 * (0.09 * y + 0.04 * x).cos();
    let (size, alignment) = (
        [161, 91],
        Alignment {
            shift_px: 1.7,
            rotation_degrees: 2.0,
            zoom_percent: 3.0,
        },
    );
    let view = |codes: &dyn Fn(f64, f64) -> f64| {
        Plane::from_fn(size[0], size[1], |column, row| {
            codes(column as f64 - 80.0, row as f64 - 45.0)
        })
    };
    // A point (x, y) of the left view, y downwards, is rotated counter-clockwise, larger, lower.
    let (sine, cosine) = 2.0_f64.to_radians().sin_cos();
    let right = view(&|u, v| {
        let [u, v] = [u / 1.03, (v - 1.7) / 1.03];
        smooth(cosine * u - sine * v, sine * u + cosine * v)
    });
    let left = view(&smooth);
    for depth in [8, 10] {
        let scale = if depth == 8 { 1.0 } else { 4.0 };
        let code = |code: f64| (scale * code).round();
        let right = match depth {
            8 => Samples::Eight(Planes {
                luma: right.map(|c| code(c) as u8),
                ..Planes::default()
            }),
            _ => Samples::Ten(Planes {
                luma: right.map(|c| code(c) as u16),
                ..Planes::default()
            }),
        };
        let tone = Tone {
            factor: 0.5,
            offset_codes: 10.0,
        };
        let correction = Correction {
            alignment,
            tones: [tone; 3],
            ..Correction::default()
        };
        let found = Corrector::new(COLOURS).corrected(&right, &correction);
        for row in 12..79 {
            for column in 12..149 {
                let value = match &found {
                    Samples::Eight(planes) => f64::from(planes.luma.row(row)[column]),
                    Samples::Ten(planes) => 0.25 * f64::from(planes.luma.row(row)[column]),
                };
                let expected = 0.5 * left.row(row)[column] + 10.0;
                // Half a code of rounding twice, and the error of interpolation.
                let most = if depth == 8 { 0.9 } else { 0.3 };
                assert!(
                    (value - expected).abs() < most,
                    "{depth} {column} {row}: {value} {expected}"
                );
            }
        }
    }
}

/// With 10 bits and colour differences for squares of four pixels, of an odd number of columns.
#[test]
fn depth_and_sampling_stay() {
    let view = |brighter: u16, lower: usize| {
        let block = |u: usize, v: usize, step: usize| {
            let block = ((u / 6 + 1) * 7919 + (v / 6 + 1) * 104_729) / step;
            (block * block / 977 % 500) as u16
        };
        let luma = Plane::from_fn(321, 180, |u, v| {
            200 + block(u, v + 40 - lower, 1) + brighter
        });
        let differences = [3, 5].map(|step| {
            Plane::from_fn(161, 90, |u, v| {
                412 + block(2 * u, 2 * v + 40 - lower, step) * 2 / 5
            })
        });
        Samples::Ten(Planes { luma, differences })
    };
    let bytes = film(
        &[[view(0, 0), view(40, 2)], [view(0, 0), view(40, 2)]],
        Sampling::Quarter,
    );
    let (plan, views) = aligned(&bytes);
    let correction = plan.corrections().next().unwrap();
    assert!(
        (correction.alignment.shift_px - 2.0).abs() < 0.02,
        "{correction:?}"
    );
    let [Samples::Ten(left), Samples::Ten(right)] = &views[1] else {
        panic!("the depth is another one");
    };
    assert_eq!(views[1][0], view(0, 0));
    assert_eq!(
        (right.luma.width(), right.differences[1].width()),
        (321, 161)
    );
    for row in 10..85 {
        for column in 4..157 {
            let error = left.differences[0].row(row)[column]
                .abs_diff(right.differences[0].row(row)[column]);
            assert!(error <= 3, "{column} {row}: {error}");
            let error =
                left.luma.row(2 * row)[2 * column].abs_diff(right.luma.row(2 * row)[2 * column]);
            assert!(error <= 3, "{column} {row}: {error}");
        }
    }
}

#[test]
fn equal_views_stay_as_they_are() {
    let Some([left, _]) = pair(PAIRS[3]) else {
        return;
    };
    let view = samples(&left);
    let (plan, views) = aligned(&film(&[[view.clone(), view.clone()]], Sampling::Full));
    assert!(
        plan.corrections()
            .all(|correction| *correction == Correction::default())
    );
    assert_eq!(views, [[view.clone(), view]]);
}
