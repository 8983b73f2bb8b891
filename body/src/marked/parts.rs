//! Parts of the body that are recognised by the distances and hues of their dots.

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use super::space::SpaceDot;
use crate::BodyModel;
use crate::chain::rotated;
use crate::marker::Hue;

/// What is painted at a point of the skin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// The hue of the dot.
    pub hue: Hue,
    /// The normal of the skin at rest, outwards.
    pub normal: [f64; 3],
}

/// The range of distances by which dots are compared, in metres: smaller ones say less, and larger
/// ones change where the skin bends.
const REACH: [f64; 2] = [0.025, 0.20];
/// The difference of a distance in space from that at rest, in metres: depths from two views are
/// known to some millimetres, and the skin bends.
const DIFFERENCE: f64 = 0.006;
/// How far a dot of a part is from its place, in metres.
const TOLERANCE: f64 = 0.012;
/// A point of the skin follows a joint by at least this weight to be a dot of its part.
const LEAST_WEIGHT: f64 = 0.6;
/// Cosine of the angle from the normal within which dots are expected to be seen.
const FACING: f64 = 0.5;
/// How much a dot that is expected and not seen counts against a placement: other parts hide some.
const UNSEEN: f64 = 0.25;
/// The number of placements of a part that are kept.
const KEPT: usize = 12;
/// Placements whose dots are nearer than this in the mean, in metres, are the same.
const SAME: f64 = 0.02;
/// A placement is sure with at least this number of dots, and this part of the expected ones.
const SURE: (usize, f64) = (8, 0.6);
/// The greatest number of placements that are tried.
const MOST_TRIED: usize = 40_000;

const HUES: usize = Hue::ALL.len();

/// A pair of dots of a part, by their distance.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pair {
    distance: f64,
    dots: [usize; 2],
}

/// The dots of a joint that move as one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    pub(super) joint: usize,
    /// The points of the model.
    points: Vec<usize>,
    at_rest: Vec<Vector<f64>>,
    marks: Vec<Mark>,
    /// For each pair of hues, the pairs of dots by rising distance.
    pairs: Vec<Vec<Pair>>,
}

/// Where a part may be.
#[derive(Clone, Debug)]
pub(super) struct Placement {
    pub(super) motor: Motor<f64>,
    /// Points of the model and the dots in space at their places.
    pub(super) matched: Vec<(usize, usize)>,
    /// How many dots are expected to be seen.
    facing: usize,
}

impl Placement {
    pub(super) fn score(&self) -> f64 {
        self.matched.len() as f64 - UNSEEN * self.facing as f64
    }

    fn is_sure(&self) -> bool {
        let count = self.matched.len();
        count >= SURE.0 && count as f64 >= SURE.1 * self.facing as f64
    }
}

/// The dots in space, prepared for a search.
pub(super) struct Space<'a> {
    pub(super) dots: &'a [SpaceDot],
    /// The centres of the cameras.
    eyes: Vec<Vector<f64>>,
    by_hue: Vec<Vec<usize>>,
    /// For each dot those after it within reach, with their distances.
    near: Vec<Vec<(usize, f64)>>,
}

impl<'a> Space<'a> {
    pub(super) fn new(dots: &'a [SpaceDot], eyes: Vec<Vector<f64>>) -> Self {
        let of_hue = |hue: &Hue| {
            (0..dots.len())
                .filter(|&dot| dots[dot].hue == *hue)
                .collect()
        };
        let near = dots.iter().enumerate().map(|(index, dot)| {
            let after = dots.iter().enumerate().skip(index + 1);
            let distances = after.map(|(other, o)| (other, dot.position.distance(o.position)));
            distances
                .filter(|(_, distance)| is_within_reach(*distance))
                .collect()
        });
        Self {
            by_hue: Hue::ALL.iter().map(of_hue).collect(),
            near: near.collect(),
            dots,
            eyes,
        }
    }
}

fn is_within_reach(distance: f64) -> bool {
    (REACH[0]..REACH[1]).contains(&distance)
}

impl Part {
    /// The parts of a body that have three dots or more.
    pub(super) fn all(model: &BodyModel, marks: &[Mark]) -> Vec<Self> {
        let parts = (0..model.skeleton().len()).map(|joint| {
            let is_own = |point: &usize| {
                let joints = &model.points()[*point].joints;
                joints
                    .iter()
                    .any(|&(own, weight)| own == joint && weight >= LEAST_WEIGHT)
            };
            let points: Vec<usize> = (0..marks.len()).filter(is_own).collect();
            let at_rest = points
                .iter()
                .map(|&point| Vector::from(model.points()[point].at_rest));
            Self::new(
                joint,
                at_rest.collect(),
                points.iter().map(|&point| marks[point]).collect(),
                points,
            )
        });
        parts.filter(|part| part.points.len() >= 3).collect()
    }

    fn new(joint: usize, at_rest: Vec<Vector<f64>>, marks: Vec<Mark>, points: Vec<usize>) -> Self {
        let mut pairs = vec![Vec::new(); HUES * HUES];
        for (a, first) in at_rest.iter().enumerate() {
            for (b, second) in at_rest.iter().enumerate() {
                let distance = first.distance(*second);
                if a != b && is_within_reach(distance) {
                    let hues = [marks[a].hue, marks[b].hue];
                    pairs[index(hues)].push(Pair {
                        distance,
                        dots: [a, b],
                    });
                }
            }
        }
        for pairs in &mut pairs {
            pairs.sort_by(|a: &Pair, b| a.distance.total_cmp(&b.distance));
        }
        Self {
            joint,
            points,
            at_rest,
            marks,
            pairs,
        }
    }

    /// The likely placements, best first: three dots in space with the hues of three dots of the
    /// part and nearly their distances give a motion, and the dots at the other places say how
    /// likely it is.
    pub(super) fn placements(&self, space: &Space<'_>) -> Vec<Placement> {
        let mut best: Vec<Placement> = Vec::new();
        let mut tried = 0;
        for (p, near) in space.near.iter().enumerate() {
            for (at, &(q, distance)) in near.iter().enumerate() {
                for dots in self.pairs_like([p, q], distance, space) {
                    for &(r, other) in &near[at + 1..] {
                        for c in self.third(dots, [p, q, r], other, space) {
                            let sources = [dots[0], dots[1], c];
                            let Some(found) = self.placed(sources, [p, q, r], space) else {
                                continue;
                            };
                            tried += 1;
                            let is_sure = found.is_sure();
                            self.keep(&mut best, found);
                            if is_sure || tried >= MOST_TRIED {
                                return best;
                            }
                        }
                    }
                }
            }
        }
        best
    }

    /// The pairs of dots with the hues of two dots in space, and nearly their distance.
    fn pairs_like<'s>(
        &'s self,
        [p, q]: [usize; 2],
        distance: f64,
        space: &Space<'_>,
    ) -> impl Iterator<Item = [usize; 2]> + 's {
        let pairs = &self.pairs[index([space.dots[p].hue, space.dots[q].hue])];
        let from = pairs.partition_point(|pair| pair.distance < distance - DIFFERENCE);
        let like = pairs[from..].iter();
        like.take_while(move |pair| pair.distance <= distance + DIFFERENCE)
            .map(|pair| pair.dots)
    }

    /// The dots that complete a pair as a third dot in space does.
    fn third<'s>(
        &'s self,
        [a, b]: [usize; 2],
        [_, q, r]: [usize; 3],
        distance: f64,
        space: &Space<'_>,
    ) -> impl Iterator<Item = usize> + 's {
        let hue = space.dots[r].hue;
        let other = space.dots[q].position.distance(space.dots[r].position);
        (0..self.at_rest.len()).filter(move |&c| {
            let is_like = |from: usize, distance: f64| {
                (self.at_rest[from].distance(self.at_rest[c]) - distance).abs() <= DIFFERENCE
            };
            c != a
                && c != b
                && self.marks[c].hue == hue
                && is_like(a, distance)
                && is_like(b, other)
        })
    }

    /// The placement that takes three dots to three dots in space, improved by all that agree.
    fn placed(
        &self,
        sources: [usize; 3],
        targets: [usize; 3],
        space: &Space<'_>,
    ) -> Option<Placement> {
        let pair = |k: usize| {
            (
                Point::from(self.at_rest[sources[k]]),
                Point::from(space.dots[targets[k]].position),
            )
        };
        let mut motor = Motor::from_point_pairs(&[0, 1, 2].map(pair)).ok()?.motion;
        // The three must face both views that see them.
        let is_facing = (0..3).all(|k| {
            let seen = space.dots[targets[k]].seen;
            seen.iter()
                .all(|&(view, _)| self.cosine(sources[k], motor, space.eyes[view]) > 0.0)
        });
        if !is_facing {
            return None;
        }
        let mut matched = self.matched(motor, space);
        if matched.len() > 3 {
            let pairs: Vec<_> = matched
                .iter()
                .map(|&(own, dot)| {
                    (
                        Point::from(self.at_rest[own]),
                        Point::from(space.dots[dot].position),
                    )
                })
                .collect();
            if let Ok(fit) = Motor::from_point_pairs(&pairs) {
                let better = self.matched(fit.motion, space);
                if better.len() >= matched.len() {
                    (motor, matched) = (fit.motion, better);
                }
            }
        }
        let is_expected = |own: &usize| {
            let seeing = space
                .eyes
                .iter()
                .filter(|eye| self.cosine(*own, motor, **eye) > FACING);
            seeing.count() >= 2
        };
        Some(Placement {
            facing: (0..self.points.len()).filter(is_expected).count(),
            matched: matched
                .iter()
                .map(|&(own, dot)| (self.points[own], dot))
                .collect(),
            motor,
        })
    }

    /// Cosine of the angle between a dot's normal and the direction to an eye.
    fn cosine(&self, own: usize, motor: Motor<f64>, eye: Vector<f64>) -> f64 {
        let place: Vector<f64> = motor.transform(Point::from(self.at_rest[own])).into();
        let normal = rotated(motor.rotor(), self.marks[own].normal.into());
        (eye - place)
            .normalized()
            .map_or(0.0, |towards| towards.dot(normal))
    }

    /// The dots of the part with the nearest dots in space, each at most once.
    fn matched(&self, motor: Motor<f64>, space: &Space<'_>) -> Vec<(usize, usize)> {
        let mut found: Vec<(f64, usize, usize)> = Vec::new();
        for (own, (place, mark)) in self.at_rest.iter().zip(&self.marks).enumerate() {
            let place: Vector<f64> = motor.transform(Point::from(*place)).into();
            for &dot in &space.by_hue[mark.hue as usize] {
                let squared = (space.dots[dot].position - place).length_squared();
                if squared < TOLERANCE * TOLERANCE {
                    found.push((squared, own, dot));
                }
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut matched: Vec<(usize, usize)> = Vec::new();
        for (_, own, dot) in found {
            if matched.iter().all(|&(o, d)| o != own && d != dot) {
                matched.push((own, dot));
            }
        }
        matched
    }

    /// Adds a placement to the best ones.
    fn keep(&self, best: &mut Vec<Placement>, found: Placement) {
        let place = |placement: &Placement, own: usize| -> Vector<f64> {
            placement
                .motor
                .transform(Point::from(self.at_rest[own]))
                .into()
        };
        let is_same = |other: &Placement| {
            let distances =
                (0..self.at_rest.len()).map(|own| place(other, own).distance(place(&found, own)));
            distances.sum::<f64>() < SAME * self.at_rest.len() as f64
        };
        if best.len() == KEPT && best[KEPT - 1].score() >= found.score() {
            return;
        }
        if let Some(at) = best.iter().position(is_same) {
            if best[at].score() >= found.score() {
                return;
            }
            best.remove(at);
        }
        let at = best.partition_point(|other| other.score() >= found.score());
        best.insert(at, found);
        best.truncate(KEPT);
    }
}

fn index([a, b]: [Hue; 2]) -> usize {
    a as usize * HUES + b as usize
}
