//! Which frames become key frames.

use ga_vision::keyframe::{Options, Reason};

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
