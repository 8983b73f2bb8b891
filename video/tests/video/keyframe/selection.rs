//! Which frames become key frames.

use ga_image::plane::Plane;
use ga_video::keyframe::{Options, Reason};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::analysed;
use super::clips::{Effect, Joins, clip};

#[test]
fn the_threshold_and_the_budget_choose_by_score() {
    for seed in [3, 8, 21] {
        let frames = clip(seed, Joins::Cuts, Effect::None).frames;
        let with = |threshold, budget| {
            let options = Options {
                threshold,
                budget,
                ..Options::default()
            };
            analysed(&frames, 25.0, options).key_frames
        };
        let all = with(0.0, None);
        let firsts = all.iter().filter(|key| key.reason == Reason::Shot).count();
        let mut others: Vec<f64> = all
            .iter()
            .filter(|key| key.reason != Reason::Shot)
            .map(|key| key.score)
            .collect();
        others.sort_by(f64::total_cmp);
        assert!(others.len() > 1, "{seed}");
        let least = 0.5 * (others[0] + others[others.len() - 1]);
        let more = others.iter().filter(|score| **score >= least).count();
        assert_eq!(with(least, None).len(), firsts + more);
        // The first frames of shots come before all others, and then what is newest.
        assert!(
            with(0.0, Some(firsts))
                .iter()
                .all(|key| key.reason == Reason::Shot)
        );
        let one_more = with(0.0, Some(firsts + 1));
        assert_eq!(one_more.len(), firsts + 1);
        let other = one_more.iter().find(|key| key.reason != Reason::Shot);
        assert_eq!(other.unwrap().score, others[others.len() - 1]);
    }
}

/// A still scene, in which a light object is in another place in every second. The background has a
/// little noise in each frame, and there are black bars above and below.
fn acted(bar: usize) -> Vec<Plane<u8>> {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let scene = Plane::from_fn(160, 90, |_, _| 40 + (random.next_u32() % 60) as u8);
    let mut frame = |index: usize| {
        let (left, top) = (45 + 25 * (index / 25 % 2), 22 + 4 * (index / 25 % 3));
        Plane::from_fn(160, 90, |column, row| {
            let noise = (random.next_u32() % 5) as u8;
            let is_object = (left..left + 40).contains(&column) && (top..top + 40).contains(&row);
            if row < bar || row >= 90 - bar {
                0
            } else if is_object {
                180 + (column * row % 30) as u8
            } else {
                scene.row(row)[column] + noise
            }
        })
    };
    (0..100).map(&mut frame).collect()
}

#[test]
fn action_before_a_still_background_has_key_frames() {
    for bar in [0, 10] {
        let found = analysed(&acted(bar), 25.0, Options::default());
        assert!(found.transitions.cuts.is_empty());
        let keys: Vec<(usize, Reason)> = found
            .key_frames
            .iter()
            .map(|key| (key.index, key.reason))
            .collect();
        let [first, others @ ..] = &keys[..] else {
            panic!("no key frames");
        };
        assert_eq!(first.1, Reason::Shot);
        assert_eq!(others.len(), 3, "{keys:?}");
        for ((index, reason), second) in others.iter().zip(1..) {
            assert_eq!(*reason, Reason::Action);
            assert!(index.abs_diff(25 * second) <= 5, "{keys:?}");
        }
    }
}
