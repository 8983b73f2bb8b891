//! The parts of a body, placed so that they hang together.

use ga_anim::skeleton::Skeleton;
use ga_runtime::cga3::{Motor, Point};

use super::parts::{Part, Placement};

/// How far the ends of two parts that meet at a joint may be apart, in metres: each is known from
/// a few dots on skin that bends.
const GAP: f64 = 0.04;
/// The least number of dots of the first part, and of others.
pub(super) const FIRST: usize = 5;
const FURTHER: usize = 3;

/// The placement of each part that is recognised: first the best of all, then always the best of
/// those that meet all others.
pub(super) fn assembled(
    skeleton: &Skeleton,
    parts: &[Part],
    placements: &[Vec<Placement>],
) -> Vec<Option<Placement>> {
    let mut chosen: Vec<Option<Placement>> = vec![None; parts.len()];
    loop {
        let needed = match chosen.iter().flatten().count() {
            0 => FIRST,
            _ => FURTHER,
        };
        let mut best: Option<(usize, &Placement)> = None;
        for (part, candidates) in placements.iter().enumerate() {
            if chosen[part].is_some() {
                continue;
            }
            let joint = parts[part].joint;
            let others = || {
                let placed = parts.iter().zip(&chosen);
                placed.filter_map(|(other, placement)| Some((other.joint, placement.as_ref()?)))
            };
            let hangs = |placement: &&Placement| {
                others().all(|(other, with)| {
                    meet(skeleton, [joint, other], [placement.motor, with.motor])
                })
            };
            let likely = candidates
                .iter()
                .filter(|placement| placement.matched.len() >= needed);
            // They are in falling order of their score.
            let Some(found) = likely.filter(|p| p.score() > 0.0).find(hangs) else {
                continue;
            };
            if best.is_none_or(|(_, other)| found.score() > other.score()) {
                best = Some((part, found));
            }
        }
        let Some((part, placement)) = best else {
            return chosen;
        };
        chosen[part] = Some(placement.clone());
    }
}

/// Whether two joints can be where two motors take them: the way between the last place that
/// follows the one and the first that follows the other is not longer than the bones between.
fn meet(skeleton: &Skeleton, joints: [usize; 2], motors: [Motor<f64>; 2]) -> bool {
    let heads = pivots(skeleton, joints);
    let (Some(first), Some(last)) = (heads.first(), heads.last()) else {
        return true;
    };
    let length: f64 = heads.windows(2).map(|ends| ends[0].distance(ends[1])).sum();
    let [near, far] = [motors[0].transform(*first), motors[1].transform(*last)];
    near.distance(far) <= length + GAP
}

/// The places at rest about which joints on the way from one to the other rotate.
fn pivots(skeleton: &Skeleton, [from, to]: [usize; 2]) -> Vec<Point<f64>> {
    let joints = skeleton.joints();
    let chain = |joint: usize| {
        std::iter::successors(Some(joint), |&joint| joints[joint].parent).collect::<Vec<_>>()
    };
    let (up, down) = (chain(from), chain(to));
    let mut way: Vec<usize> = up
        .iter()
        .copied()
        .take_while(|joint| !down.contains(joint))
        .collect();
    let other: Vec<usize> = down
        .iter()
        .copied()
        .take_while(|joint| !up.contains(joint))
        .collect();
    way.extend(other.into_iter().rev());
    way.into_iter()
        .map(|joint| joints[joint].head.into())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;

    #[test]
    fn pivots_are_the_joints_on_the_way() {
        let model = example::model();
        let skeleton = model.skeleton();
        let way = |from, to| pivots(skeleton, [from, to]);
        let heads = |joints: &[usize]| -> Vec<Point<f64>> {
            let heads = joints.iter().map(|&k| skeleton.joints()[k].head.into());
            heads.collect()
        };
        // From the hand up to the chest, which both arm and head have, and to the head.
        assert_eq!(way(3, 4), heads(&[3, 2, 4]));
        assert_eq!(way(0, 3), heads(&[1, 2, 3]));
        assert_eq!(way(2, 2), heads(&[]));
    }
}
