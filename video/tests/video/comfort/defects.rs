//! Defects of random amounts, injected into real pairs.

use ga_video::comfort::{Dimension, FrameMeasures, Histogram, Level};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::inputs::{Motion, PAIRS, Picture, blurred, level, measures, moved, pair, warped};

/// Numbers between −1 and 1.
struct Amounts(ChaCha8Rng);

impl Amounts {
    fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    fn next(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0
    }
}

/// Calls a function with each pair, its measures, and amounts of its own.
fn for_each_pair(check: impl Fn(&str, [&Picture; 2], &FrameMeasures, &mut Amounts)) {
    for (index, paths) in PAIRS.into_iter().enumerate() {
        let Some([left, right]) = pair(paths) else {
            return;
        };
        let found = measures(&left, &right);
        check(
            paths[0],
            [&left, &right],
            &found,
            &mut Amounts::new(index as u64),
        );
    }
}

#[test]
fn real_pairs_are_green_where_they_are_rectified_and_equally_exposed() {
    for_each_pair(|name, [left, right], found, _| {
        for found in [found, &measures(right, left)] {
            for dimension in [
                Dimension::Brightness,
                Dimension::Colour,
                Dimension::Vertical,
                Dimension::FocalGap,
            ] {
                assert_eq!(level(found, dimension), Level::Green, "{name}: {found:?}");
            }
            let geometry = found.geometry.unwrap();
            assert!(geometry.deviation_px < 0.5, "{name}: {geometry:?}");
            assert!(found.sharpness_log2.unwrap().abs() < 0.1, "{name}");
        }
    });
}

#[test]
fn motions_of_one_view_are_measured() {
    for_each_pair(|name, [left, right], before, amounts| {
        let height = right.height() as f64;
        let before = before.geometry.unwrap();
        let mut next = |most: f64| most * amounts.next();
        let motions = [
            Motion {
                down: next(0.03 * height),
                ..Motion::default()
            },
            Motion {
                degrees: next(2.0),
                ..Motion::default()
            },
            Motion {
                percent: next(4.0),
                ..Motion::default()
            },
            Motion {
                down: next(0.015 * height),
                degrees: next(1.0),
                percent: next(2.0),
                right: next(4.0),
            },
        ];
        for motion in motions {
            let found = measures(left, &moved(right, motion)).geometry.unwrap();
            let errors = [
                (found.shift_px - before.shift_px - motion.down, 0.1),
                (
                    found.rotation_degrees - before.rotation_degrees - motion.degrees,
                    0.03,
                ),
                (
                    found.zoom_percent - before.zoom_percent - motion.percent,
                    0.1,
                ),
            ];
            for (error, within) in errors {
                assert!(
                    error.abs() < within,
                    "{name} {motion:?}: {found:?}, {before:?}"
                );
            }
        }
    });
}

/// Points that are found before and after have moved by what was injected.
#[test]
fn shifts_to_the_side_are_parallax() {
    for_each_pair(|name, [left, right], before, amounts| {
        let right_by = 0.03 * right.width() as f64 * amounts.next();
        let motion = Motion {
            right: right_by,
            ..Motion::default()
        };
        let after = measures(left, &moved(right, motion));
        let mut errors = Vec::new();
        for point in &after.matches {
            if let Some(same) = before.matches.iter().find(|same| same.left == point.left) {
                errors.push((point.right[0] - same.right[0] - right_by).abs());
            }
        }
        errors.sort_by(f64::total_cmp);
        assert!(errors.len() > 50, "{name}");
        assert!(
            errors[errors.len() / 2] < 0.05,
            "{name}: {}",
            errors[errors.len() / 2]
        );
        assert!(
            errors[errors.len() * 9 / 10] < 0.3,
            "{name}: {}",
            errors[errors.len() * 9 / 10]
        );
    });
}

#[test]
fn parallax_is_counted() {
    for_each_pair(|name, [left, _], found, _| {
        let parallax = found.parallax.as_ref().unwrap();
        let points = found.matches.iter();
        let all: Vec<f64> = points.map(|point| point.right[0] - point.left[0]).collect();
        // Points whose row is far from the model are left out; they are few.
        let counted: u32 = parallax.histogram.counts().iter().sum();
        let left_out = 1.0 - f64::from(counted) / all.len() as f64;
        assert!((0.0..0.2).contains(&left_out), "{name}: {left_out}");
        let one = 1.0 / all.len() as f64;
        for (limit, share) in [
            (parallax.near_px, 0.02),
            (parallax.median_px, 0.5),
            (parallax.far_px, 0.98),
        ] {
            let below = one * all.iter().filter(|x| **x < limit).count() as f64;
            assert!(
                (below - share).abs() <= one + left_out,
                "{name}: {below} {share}"
            );
        }
        let mut twice = parallax.histogram.clone();
        twice.merge(&parallax.histogram);
        for (index, count) in parallax.histogram.counts().iter().enumerate() {
            let middle = Histogram::middle_percent(index);
            let is_inside = |x: &&f64| {
                let percent = 100.0 * **x / left.width() as f64;
                (percent - middle).abs() < 0.5 * Histogram::INTERVAL_PERCENT
            };
            let inside = all.iter().filter(is_inside).count();
            let least = inside as f64 - left_out * all.len() as f64 - 0.5;
            assert!(
                (least..=inside as f64).contains(&f64::from(*count)),
                "{name}: {count} of {inside}"
            );
            assert_eq!(twice.counts()[index], 2 * count);
        }
    });
}

#[test]
fn offsets_and_gains_of_one_view_are_measured() {
    for_each_pair(|name, [left, right], before, amounts| {
        let (photometry, sharpness) = (before.photometry.unwrap(), before.sharpness_log2.unwrap());
        // What is darker than black is lost, so that dark scenes are made brighter.
        let offset = (25.0 * amounts.next()).round().abs();
        let brighter = right.map(|codes| codes.map(|code| code + offset as f32));
        let found = measures(left, &brighter);
        let measured = found.photometry.unwrap();
        let error = measured.offset_codes - photometry.offset_codes - offset;
        assert!(error.abs() < 0.8, "{name}, offset {offset}: {error}");
        let colour = measured.colour_difference - photometry.colour_difference;
        assert!(colour.abs() < 1.0, "{name}, offset {offset}: {colour}");
        let change = found.sharpness_log2.unwrap() - sharpness;
        assert!(change.abs() < 0.1, "{name}, offset {offset}: {change}");
        // It does not matter which of the views is brighter.
        let darker = measures(&brighter, left).photometry.unwrap();
        let [more, less] = [measured, darker].map(|found| found.luminance_percent);
        assert!(
            less > 0.0 && (more - less).abs() < 2.0,
            "{name}, {offset}: {more} {less}"
        );

        let gain = 0.8 + 0.1 * amounts.next();
        let scaled = |red: f64, others: f64| {
            let [red, others] = [red, others].map(|gain| gain as f32);
            right.map(|[r, g, b]| [red * r, others * g, others * b])
        };
        let found = measures(left, &scaled(gain, 1.0));
        let measured = found.photometry.unwrap();
        let error = measured.offset_codes - photometry.offset_codes;
        assert!(error.abs() < 0.8, "{name}, red {gain}: {error}");
        let ratio = measured.channel_ratios[0] / photometry.channel_ratios[0];
        assert!((ratio - gain).abs() < 0.02, "{name}, red {gain}: {ratio}");
        assert_ne!(
            level(&found, Dimension::Colour),
            Level::Green,
            "{name}, red {gain}"
        );

        let green = right.map(|[r, g, b]| [r, gain as f32 * g, b]);
        let measured = measures(left, &green).photometry.unwrap();
        let error = measured.offset_codes - photometry.offset_codes;
        assert!(error.abs() < 2.0, "{name}, green {gain}: {error}");

        // A darker view has another brightness, and neither another colour nor sharpness.
        let found = measures(left, &scaled(gain, gain));
        let colour = found.photometry.unwrap().colour_difference - photometry.colour_difference;
        assert!(colour.abs() < 1.5, "{name}, gain {gain}: {colour}");
        let change = found.sharpness_log2.unwrap() - sharpness;
        assert!(change.abs() < 0.1, "{name}, gain {gain}: {change}");
        for ratio in found.photometry.unwrap().channel_ratios {
            assert!(
                (ratio / gain - 1.0).abs() < 0.1,
                "{name}, gain {gain}: {ratio}"
            );
        }
    });
}

/// Two thirds of the picture are nearly white, so that they do not show the whole difference.
#[test]
fn what_is_cut_off_at_white_does_not_count() {
    let mut amounts = Amounts::new(77);
    let mut blocks = vec![0.0_f32; 60 * 40];
    for (index, block) in blocks.iter_mut().enumerate() {
        let [usual, most] = if index % 60 < 20 {
            [90.0, 40.0]
        } else {
            [227.0, 27.0]
        };
        *block = usual + most * amounts.next() as f32;
    }
    let left = Picture::from_fn(480, 320, |u, v| [blocks[u / 8 + 60 * (v / 8)]; 3]);
    let right = left.map(|codes| codes.map(|code| (code + 30.0).min(255.0)));
    let found = measures(&left, &right).photometry.unwrap();
    assert!((found.offset_codes - 30.0).abs() < 2.0, "{found:?}");
}

#[test]
fn a_blurred_view_differs_in_sharpness_alone() {
    for_each_pair(|name, [left, right], before, amounts| {
        let deviation = 1.75 + 0.75 * amounts.next();
        let [sharp, blunt] = [left, right].map(|view| blurred(view, deviation));
        for (found, sign) in [
            (measures(left, &blunt), -1.0),
            (measures(&sharp, right), 1.0),
        ] {
            let sharpness = sign * found.sharpness_log2.unwrap();
            assert!(sharpness > 0.3, "{name}, blur {deviation}: {sharpness}");
            assert_ne!(level(&found, Dimension::FocalGap), Level::Green);
            let photometry = [&found, before].map(|found| found.photometry.unwrap());
            let [offset, colour] = [
                photometry[0].offset_codes - photometry[1].offset_codes,
                photometry[0].colour_difference - photometry[1].colour_difference,
            ];
            assert!(
                offset.abs() < 1.5 && colour.abs() < 0.5,
                "{name}, blur {deviation}"
            );
            assert_eq!(level(&found, Dimension::Vertical), Level::Green, "{name}");
            let zoom = found.geometry.unwrap().zoom_percent;
            assert!(zoom.abs() < 0.5, "{name}, blur {deviation}: {zoom}");
        }
    });
}

/// What is measured from the right view to the left one is the opposite.
#[test]
fn exchanged_views_have_opposite_measures() {
    for_each_pair(|name, [left, right], before, _| {
        let after = measures(right, left);
        let [g, h] = [before, &after].map(|found| found.geometry.unwrap());
        assert!((g.shift_px + h.shift_px).abs() < 0.1, "{name}: {g:?} {h:?}");
        assert!(
            (g.rotation_degrees + h.rotation_degrees).abs() < 0.03,
            "{name}"
        );
        assert!((g.zoom_percent + h.zoom_percent).abs() < 0.1, "{name}");
        let [p, q] = [before, &after].map(|found| found.photometry.unwrap());
        assert!((p.offset_codes + q.offset_codes).abs() < 1.0, "{name}");
        let [s, t] = [before, &after].map(|found| found.sharpness_log2.unwrap());
        assert!((s + t).abs() < 0.06, "{name}: {s} {t}");
    });
}

/// Keystone distortion, as converging cameras make it, is a vertical deviation that shift, rotation
/// and zoom do not explain.
#[test]
fn keystone_distortion_is_a_vertical_deviation() {
    for_each_pair(|name, [left, right], before, _| {
        let [width, height] = [right.width(), right.height()].map(|side| side as f64);
        // Rows spread on one side and meet on the other, by 1 % of the height in the corners.
        let reach = 0.01 * height;
        let slope = reach / (0.25 * width * height);
        let keystone = warped(right, |[x, y]| [x, y / (1.0 + slope * x)]);
        let found = measures(left, &keystone).geometry.unwrap();
        let rise = found.deviation_px - before.geometry.unwrap().deviation_px;
        assert!(rise > 0.3 * reach, "{name}: {found:?}, {reach}");
    });
}
