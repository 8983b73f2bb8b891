//! Other light, objects that leave, and stray shots: what divides a clip, and what does not.

use ga_image::plane::Plane;
use ga_video::keyframe::flash::{Flash, Kind};
use ga_video::keyframe::{Analysis, Options};

use super::analysed;
use super::clips::{Random, SIZE};
use super::splices::Material;

/// The frames of a clip of one shot, and what changes in it from frame 30 on.
const CHANGE: usize = 30;

/// Analyses a clip in which a function of its number, its place and its value changes a pixel.
fn changed(frames: &[Plane<f32>], change: impl Fn(usize, [usize; 2], f32) -> f32) -> Analysis {
    let frames = frames.iter().enumerate().map(|(index, frame)| {
        Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
            let value = frame.get(column, row).unwrap();
            // A cast from float saturates.
            (change(index, [column, row], value) + 0.5) as u8
        })
    });
    analysed(&frames.collect::<Vec<_>>(), 25.0, Options::default())
}

fn shots() -> Vec<(u64, Vec<Plane<f32>>)> {
    let Some(material) = Material::read() else {
        return Vec::new();
    };
    let seeds = super::seeds().flat_map(|seed| [seed, seed + 1, seed + 2]);
    seeds
        .map(|seed| (seed, material.one_shot(&mut Random::new(seed), 2 * CHANGE)))
        .collect()
}

#[test]
fn a_lamp_that_is_switched_on_is_no_cut() {
    for (seed, frames) in shots() {
        for strength in [1.6, 2.5, 4.0] {
            // Light from the left upon a dim scene.
            let found = changed(&frames, |index, [column, _], value| {
                let side = 1.0 - column as f32 / SIZE[0] as f32;
                let dim = 0.3 * value + 4.0;
                if index < CHANGE {
                    dim
                } else {
                    dim * (1.0 + strength * (0.3 + side))
                }
            });
            assert!(found.transitions.cuts.is_empty(), "{seed} {strength}");
            assert!(found.transitions.flashes.is_empty(), "{seed} {strength}");
        }
    }
}

#[test]
fn flashes_of_up_to_three_frames_are_reported_as_such() {
    for (seed, frames) in shots() {
        for length in 1..=3 {
            for is_white in [false, true] {
                let found = changed(&frames, |index, _, value| {
                    match (CHANGE..CHANGE + length).contains(&index) {
                        true if is_white => 255.0,
                        true => 1.7 * value + 60.0,
                        false => 0.8 * value,
                    }
                });
                assert!(
                    found.transitions.cuts.is_empty(),
                    "{seed} {length} {is_white}"
                );
                let flashes = found.transitions.flashes;
                let expected = Flash {
                    frames: CHANGE..CHANGE + length,
                    kind: Kind::Flash,
                };
                // A brighter scene may look like the one before it, which is no change at all.
                let is_right = flashes == [expected] || (!is_white && flashes.is_empty());
                assert!(is_right, "{seed} {length} {flashes:?}");
            }
        }
    }
}

/// Lightning: light from another side in each of the frames, that fades away.
#[test]
fn lightning_is_no_cut() {
    for (seed, frames) in shots() {
        let found = changed(&frames, |index, [column, _], value| {
            let after = index.wrapping_sub(CHANGE);
            let light = [3.0, 1.0, 4.0, 2.0, 1.0, 0.5]
                .get(after)
                .copied()
                .unwrap_or(0.0);
            let side = column as f32 / SIZE[0] as f32;
            let side = if after.is_multiple_of(2) {
                side
            } else {
                1.0 - side
            };
            (0.2 * value + 3.0) * (1.0 + light * (0.4 + side))
        });
        assert!(found.transitions.cuts.is_empty(), "{seed}");
    }
}

/// A dark object over the left two thirds of a still picture leaves within four frames, and its
/// shadow over most of the rest with it.
#[test]
fn an_object_that_leaves_is_no_cut() {
    for (seed, frames) in shots() {
        let still: Vec<Plane<f32>> = vec![frames[0].clone(); 2 * CHANGE];
        let found = changed(&still, |index, [column, row], value| {
            let part = 0.6 * (1.0 - index.saturating_sub(CHANGE) as f32 / 4.0);
            let edge = part * SIZE[1] as f32;
            let shadow = if (row as f32) < 1.2 * edge { 0.55 } else { 1.0 };
            if (row as f32) < edge && column < 2 * SIZE[0] / 3 {
                60.0
            } else {
                shadow * value
            }
        });
        assert!(found.transitions.cuts.is_empty(), "{seed}");
    }
}

/// One frame or two of another picture, between two others and within one shot.
#[test]
fn stray_shots_are_reported_as_such() {
    let Some(material) = Material::read() else {
        return;
    };
    for seed in super::seeds() {
        let pictures: Vec<Plane<f32>> = [1, 7, 11]
            .map(|scene| material.photograph(scene, &mut Random::new(seed)))
            .into_iter()
            .collect();
        for length in [1, 2] {
            for (first, stray, last) in [(0, 1, 2), (1, 2, 1), (2, 0, 2), (2, 1, 0)] {
                let end = CHANGE + length;
                let frames = (0..2 * CHANGE).map(|index| match index {
                    index if index < CHANGE => pictures[first].clone(),
                    index if index < end => pictures[stray].clone(),
                    _ => pictures[last].clone(),
                });
                let found = changed(&frames.collect::<Vec<_>>(), |_, _, value| value);
                let expected = Flash {
                    frames: CHANGE..end,
                    kind: Kind::StrayShot,
                };
                assert_eq!(
                    found.transitions.flashes,
                    [expected],
                    "{seed} {first} {stray}"
                );
                assert_eq!(
                    found.transitions.cuts,
                    [CHANGE, end],
                    "{seed} {first} {stray}"
                );
            }
        }
    }
}
