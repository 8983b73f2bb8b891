//! What joints are by the shape of their hierarchy at rest, where their names do not say it.

use std::collections::HashMap;

use ga_runtime::vga3::Vector;

use super::convention::{Part, Side};

/// A part of the body and its side.
pub(super) type Meaning = (Part, Option<Side>);

/// The joints of each part of a body, from the root on.
pub(super) type Parts = HashMap<Meaning, Vec<usize>>;

/// Why a hierarchy is not that of a person.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BodyProblem {
    /// There are no two chains to the ground with hips, knees and ankles.
    #[error("it has no two legs with hips, knees and ankles that reach the ground at rest")]
    NoLegs,
    /// The trunk does not stand upright.
    #[error("from the hips to the head it is {degrees:.0}° from the vertical at rest")]
    Lying {
        /// The angle.
        degrees: f64,
    },
    /// What should be arms reaches the ground.
    #[error("it stands on four legs at rest: what would be its hands is as low as its feet")]
    FourLegs,
}

/// The greatest angle of a trunk that stands upright at rest, in degrees.
const UPRIGHT: f64 = 45.0;
/// As fractions of the body's height: how far above the lowest joint the end of a leg is at most;
/// how far beside the middle a hand is at least; and a length that is none.
const LOW: f64 = 0.2;
const BESIDE: f64 = 0.05;
const TINY: f64 = 1e-3;

/// The joints of each part of a body that stands upright at rest, y up, found by the shape of the
/// hierarchy: two chains to the ground, above them a trunk, and two chains to its sides.
///
/// Digits are not told apart. `None` where there are no two legs.
pub(super) fn parts_by_structure(parents: &[Option<usize>], places: &[[f64; 3]]) -> Option<Parts> {
    Body::new(parents, places)?.parts()
}

/// The same of a person.
///
/// # Errors
///
/// What makes it no person.
pub(super) fn parts_of_person(
    parents: &[Option<usize>],
    places: &[[f64; 3]],
) -> Result<Parts, BodyProblem> {
    let body = Body::new(parents, places).ok_or(BodyProblem::NoLegs)?;
    let parts = body.parts().ok_or(BodyProblem::NoLegs)?;
    body.check(&parts)?;
    Ok(parts)
}

struct Body<'a> {
    parents: &'a [Option<usize>],
    places: Vec<Vector<f64>>,
    children: Vec<Vec<usize>>,
    low: f64,
    height: f64,
}

/// Three joints of a limb by their places on the way to its end, such as hip, knee and ankle.
type Triple = [usize; 3];

/// What lengths a limb usually has, relative to its two long bones together.
struct Usual {
    /// The lower bone as a part of the upper one.
    lower: f64,
    /// What comes before the upper bone.
    before: f64,
    /// What comes after the lower one, at most.
    after: f64,
}

const LEG: Usual = Usual {
    lower: 0.97,
    before: 0.15,
    after: 0.4,
};
const ARM: Usual = Usual {
    lower: 0.9,
    before: 0.3,
    after: 0.5,
};

impl<'a> Body<'a> {
    fn new(parents: &'a [Option<usize>], places: &[[f64; 3]]) -> Option<Self> {
        let heights = || places.iter().map(|place| place[1]);
        let low = heights().fold(f64::INFINITY, f64::min);
        let height = heights().fold(f64::NEG_INFINITY, f64::max) - low;
        let mut children = vec![Vec::new(); parents.len()];
        for (joint, parent) in parents.iter().enumerate() {
            if let Some(parent) = *parent {
                children[parent].push(joint);
            }
        }
        (height > 0.0 && height.is_finite()).then(|| Self {
            parents,
            places: places.iter().map(|&place| place.into()).collect(),
            children,
            low,
            height,
        })
    }

    fn parts(&self) -> Option<Parts> {
        let (hips, legs) = self.legs()?;
        let bones = legs.clone().map(|leg| self.limb(&leg, &LEG));
        let [Some(one), Some(other)] = bones else {
            return None;
        };
        let mut parts: Parts = HashMap::new();
        parts.insert((Part::Hips, None), vec![hips]);
        let across = self.places[legs[0][one[0]]] - self.places[legs[1][other[0]]];
        let across = Vector::new(across.e1, 0.0, across.e3).normalized()?;
        let left = self.left(across, &legs, [one, other]);
        let sides = if across.dot(left) > 0.0 {
            [Side::Left, Side::Right]
        } else {
            [Side::Right, Side::Left]
        };
        for ((leg, bones), side) in legs.iter().zip([one, other]).zip(sides) {
            let names = [Part::UpperLeg, Part::LowerLeg, Part::Foot];
            for (part, place) in names.into_iter().zip(bones) {
                parts.insert((part, Some(side)), vec![leg[place]]);
            }
            if let Some(&toes) = leg.get(bones[2] + 1) {
                parts.insert((Part::Toes, Some(side)), vec![toes]);
            }
        }
        self.upper_body(hips, &legs, left, &mut parts);
        Some(parts)
    }

    /// Fails for a body that stands on four legs or does not stand at all.
    fn check(&self, parts: &Parts) -> Result<(), BodyProblem> {
        let place = |part, side| {
            let joint = parts.get(&(part, side))?.last()?;
            Some(self.places[*joint])
        };
        let sides = [Some(Side::Left), Some(Side::Right)];
        let height = |part| {
            let heights = sides.iter().filter_map(|&side| Some(place(part, side)?.e2));
            heights.reduce(f64::max)
        };
        if let Some((hand, foot)) = height(Part::Hand).zip(height(Part::Foot))
            && hand <= foot.max(self.low + LOW * self.height)
        {
            return Err(BodyProblem::FourLegs);
        }
        let upper = [Part::Head, Part::Neck, Part::Spine];
        let head = upper.into_iter().find_map(|part| place(part, None));
        if let Some((hips, head)) = place(Part::Hips, None).zip(head) {
            let up = Vector::new(0.0, 1.0, 0.0);
            let degrees = (head - hips).angle(up).map_or(0.0, f64::to_degrees);
            if degrees > UPRIGHT {
                return Err(BodyProblem::Lying { degrees });
            }
        }
        Ok(())
    }

    /// The joints from a root to a joint.
    fn way_to(&self, joint: usize) -> Vec<usize> {
        let mut way: Vec<usize> =
            std::iter::successors(Some(joint), |&joint| self.parents[joint]).collect();
        way.reverse();
        way
    }

    fn leaves(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.parents.len()).filter(|&joint| self.children[joint].is_empty())
    }

    fn length(&self, way: &[usize]) -> f64 {
        let steps = way.windows(2);
        steps
            .map(|pair| self.places[pair[0]].distance(self.places[pair[1]]))
            .sum()
    }

    /// The joint from which two legs go down, and the joints of both below it: of the ways to
    /// joints near the ground, the two that part first and are the longest and most alike.
    fn legs(&self) -> Option<(usize, [Vec<usize>; 2])> {
        let limit = self.low + LOW * self.height;
        let low = self.leaves().filter(|&leaf| self.places[leaf].e2 <= limit);
        let ways: Vec<Vec<usize>> = low.map(|leaf| self.way_to(leaf)).collect();
        let mut best: Option<(usize, f64, [&[usize]; 2])> = None;
        for (number, one) in ways.iter().enumerate() {
            for other in &ways[number + 1..] {
                let common = one.iter().zip(other).take_while(|(a, b)| a == b).count();
                if common == 0 {
                    continue;
                }
                let [a, b] = [&one[common - 1..], &other[common - 1..]].map(|way| self.length(way));
                // A tail is near the ground too, but in the middle.
                let likeness = a + b - 3.0 * (a - b).abs();
                let is_better = best.as_ref().is_none_or(|&(least, greatest, _)| {
                    common < least || (common == least && likeness > greatest)
                });
                if is_better && a.min(b) > LOW * self.height {
                    best = Some((common, likeness, [&one[common..], &other[common..]]));
                }
            }
        }
        let (_, _, legs) = best?;
        let hips = self.parents[*legs[0].first()?]?;
        Some((hips, legs.map(<[usize]>::to_vec)))
    }

    /// Of the joints of a limb the three that begin and end its two long bones. Bones are straight,
    /// so what lies between two of them adds no length, and their lengths have usual ratios.
    fn limb(&self, way: &[usize], usual: &Usual) -> Option<Triple> {
        let first = *way.first()?;
        let before = self.parents[first].map_or(0.0, |parent| {
            self.places[parent].distance(self.places[first])
        });
        let mut best: Option<(f64, Triple)> = None;
        for end in 2..way.len() {
            for middle in 1..end {
                for begin in 0..middle {
                    let joints = [begin, middle, end];
                    let place = |k: usize| self.places[way[joints[k]]];
                    let [upper, lower] = [0, 1].map(|k| place(k).distance(place(k + 1)));
                    let whole = upper + lower;
                    if upper.min(lower) < TINY * self.height {
                        continue;
                    }
                    let ratio = (lower / upper / usual.lower).ln().abs();
                    let bent = self.length(&way[begin..=end]) / whole - 1.0;
                    let before = (before + self.length(&way[..=begin])) / whole;
                    let after = self.length(&way[end..]) / whole;
                    let cost = ratio
                        + 3.0 * bent
                        + (before - usual.before).abs()
                        + 2.0 * (after - usual.after).max(0.0)
                        + 0.2 * after;
                    if best.as_ref().is_none_or(|&(least, _)| cost < least) {
                        best = Some((cost, joints));
                    }
                }
            }
        }
        best.map(|(_, joints)| joints)
    }

    /// The direction to the left: across the direction of the feet, or of z where the feet have
    /// none.
    fn left(&self, across: Vector<f64>, legs: &[Vec<usize>; 2], bones: [Triple; 2]) -> Vector<f64> {
        let up = Vector::new(0.0, 1.0, 0.0);
        let forwards = across.cross(up);
        let feet = legs.iter().zip(bones).map(|(leg, [_, _, ankle])| {
            let toes = leg.last().map_or(leg[ankle], |&last| last);
            (self.places[toes] - self.places[leg[ankle]]).dot(forwards)
        });
        let feet: f64 = feet.sum();
        let towards = if feet.abs() > TINY * self.height {
            feet
        } else {
            forwards.e3
        };
        up.cross(forwards * if towards < 0.0 { -1.0 } else { 1.0 })
    }

    /// Spine, arms, neck and head.
    fn upper_body(
        &self,
        hips: usize,
        legs: &[Vec<usize>; 2],
        left: Vector<f64>,
        parts: &mut Parts,
    ) {
        let is_leg = |joint: usize| legs.iter().any(|leg| leg.first() == Some(&joint));
        let above = |leaf: usize| {
            let way = self.way_to(leaf);
            let place = way.iter().position(|&joint| joint == hips)?;
            let way = way[place + 1..].to_vec();
            way.first()
                .is_some_and(|&first| !is_leg(first))
                .then_some(way)
        };
        let ways: Vec<Vec<usize>> = self.leaves().filter_map(above).collect();
        let end = |way: &&Vec<usize>| way.last().map_or(hips, |&last| last);
        let beside = |way: &&Vec<usize>| (self.places[end(way)] - self.places[hips]).dot(left);
        let by_side = |a: &&Vec<usize>, b: &&Vec<usize>| beside(a).total_cmp(&beside(b));
        let arms = ways.iter().min_by(by_side).zip(ways.iter().max_by(by_side));
        let least = BESIDE * self.height;
        let arms = arms.filter(|(right, left)| beside(right) < -least && beside(left) > least);
        let by_height = |a: &&Vec<usize>, b: &&Vec<usize>| {
            let [a, b] = [a, b].map(|way| self.places[end(way)].e2);
            a.total_cmp(&b)
        };
        let Some((right, left_arm)) = arms else {
            if let Some(way) = ways.iter().max_by(by_height) {
                self.neck(way, parts);
            }
            return;
        };
        let common = right
            .iter()
            .zip(left_arm)
            .take_while(|(a, b)| a == b)
            .count();
        if common > 0 {
            parts.insert((Part::Spine, None), right[..common].to_vec());
        }
        for (way, side) in [(left_arm, Side::Left), (right, Side::Right)] {
            self.arm(&way[common..], side, parts);
        }
        let arms = [right, left_arm].map(|way| way.get(common).copied());
        let necks = ways.iter().filter(|way| {
            way.get(..common) == Some(&right[..common]) && !arms.contains(&way.get(common).copied())
        });
        if let Some(way) = necks.max_by(by_height) {
            self.neck(&way[common..], parts);
        }
    }

    fn arm(&self, way: &[usize], side: Side, parts: &mut Parts) {
        // A joint from which several digits begin is the hand.
        let hand = way.iter().position(|&joint| self.children[joint].len() > 2);
        let way = &way[..hand.map_or(way.len(), |hand| hand + 1)];
        let Some(bones) = self.limb(way, &ARM) else {
            return;
        };
        let names = [Part::UpperArm, Part::LowerArm, Part::Hand];
        for (part, place) in names.into_iter().zip(bones) {
            parts.insert((part, Some(side)), vec![way[place]]);
        }
        if let Some(clavicle) = bones[0].checked_sub(1) {
            parts.insert((Part::Shoulder, Some(side)), vec![way[clavicle]]);
        }
    }

    /// The neck, and the head at its end: where the face begins, or the last joint but for one that
    /// marks the top of the head.
    fn neck(&self, way: &[usize], parts: &mut Parts) {
        let branch = way.iter().position(|&joint| self.children[joint].len() > 1);
        let mut count = branch.map_or(way.len(), |branch| branch + 1);
        if branch.is_none() && count > 2 {
            let bone = |k: usize| self.places[way[k - 1]].distance(self.places[way[k]]);
            if bone(count - 1) > 1.5 * bone(count - 2) {
                count -= 1;
            }
        }
        let Some((&head, neck)) = way[..count].split_last() else {
            return;
        };
        parts.insert((Part::Head, None), vec![head]);
        if !neck.is_empty() {
            parts.insert((Part::Neck, None), neck.to_vec());
        }
    }
}
