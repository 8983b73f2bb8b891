//! Limbs that were not recognised by themselves, searched about the joint by which they hang.

use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::vga3::Vector;

use super::MarkedBody;
use super::assignment::Assignment;
use crate::FittedPose;
use crate::chain::rotated;
use crate::marker::Dot;
use ga_anim::skeleton::SkeletonError;
use ga_camera::Camera;

/// Steps of the rotation about the way from the joint to a dot.
const STEPS: usize = 36;
/// How far a dot is from its place in a picture, in pixels.
const GATE: f64 = 5.0;
/// Cosine of the greatest angle from the normal at which a dot is expected to be seen.
const FACING: f64 = 0.5;
/// How much a dot that is expected and not seen counts against a rotation.
const UNSEEN: f64 = 0.25;
/// The least number of dots over all pictures.
const LEAST: usize = 4;
/// A dot that is nearer to its joint says too little, in metres.
const NEAREST: f64 = 0.03;
/// How much farther from the joint than its dot a ray may be, in metres.
const SLACK: f64 = 0.01;

/// The dots of a limb as they are at rest, relative to the head of its joint.
struct Limb {
    points: Vec<usize>,
    at_rest: Vec<Vector<f64>>,
}

/// A rotation of a limb and the dots that it explains: view, point and dot.
struct Rotation {
    score: f64,
    rotor: Rotor<f64>,
    matched: Vec<[usize; 3]>,
}

impl MarkedBody {
    /// Adds the dots of limbs that have none, where the joint above has some. The place of the
    /// joint is known then. A ray to a dot meets the sphere about it on which a dot of the limb is
    /// at up to two places; with a rotation about the way to there this gives the rotation of the
    /// limb. The one that explains most dots is taken. Whether there is any.
    pub(super) fn complete(
        &self,
        cameras: &[Camera],
        dots: &[Vec<Dot>],
        fitted: &FittedPose,
        assignment: &mut Assignment,
    ) -> Result<bool, SkeletonError> {
        let skeleton = self.model.skeleton();
        let mut motions = fitted.pose.motions(skeleton)?;
        let mut is_known = vec![false; skeleton.len()];
        let mut is_free: Vec<Vec<bool>> = dots.iter().map(|dots| vec![true; dots.len()]).collect();
        for (view, free) in assignment.iter().zip(&mut is_free) {
            for (dot, joint) in view.iter().zip(&self.strongest) {
                if let Some(dot) = dot {
                    is_known[*joint] = true;
                    free[*dot] = false;
                }
            }
        }
        let mut is_any = false;
        for (joint, own) in skeleton.joints().iter().enumerate() {
            let Some(parent) = own.parent.filter(|parent| is_known[*parent]) else {
                continue;
            };
            if is_known[joint] {
                continue;
            }
            let limb = self.limb(joint);
            let head: Vector<f64> = motions[parent].transform(Point::from(own.head)).into();
            let search = Search {
                body: self,
                cameras,
                dots,
                is_free: &is_free,
                head,
            };
            let Some(found) = search.best(&limb) else {
                continue;
            };
            is_any = true;
            is_known[joint] = true;
            let displacement = head - rotated(found.rotor, own.head.into());
            motions[joint] =
                ga_runtime::cga3::Translator::from_displacement(displacement.into()) * found.rotor;
            for [view, point, dot] in found.matched {
                assignment[view][point] = Some(dot);
                is_free[view][dot] = false;
            }
        }
        Ok(is_any)
    }

    fn limb(&self, joint: usize) -> Limb {
        let points = (0..self.marks.len()).filter(|&point| self.strongest[point] == joint);
        let points: Vec<usize> = points.collect();
        let head = Vector::from(self.model.skeleton().joints()[joint].head);
        let at_rest = points
            .iter()
            .map(|&point| Vector::from(self.model.points()[point].at_rest) - head);
        Limb {
            at_rest: at_rest.collect(),
            points,
        }
    }
}

/// A search for the rotation of a limb about a place.
struct Search<'a> {
    body: &'a MarkedBody,
    cameras: &'a [Camera],
    dots: &'a [Vec<Dot>],
    is_free: &'a [Vec<bool>],
    head: Vector<f64>,
}

impl Search<'_> {
    fn best(&self, limb: &Limb) -> Option<Rotation> {
        let mut best: Option<Rotation> = None;
        for (view, camera) in self.cameras.iter().enumerate() {
            for (index, dot) in self.dots[view].iter().enumerate() {
                if !self.is_free[view][index] {
                    continue;
                }
                let Ok(ray) = camera.ray(dot.centre) else {
                    continue;
                };
                let (from, along) = (Vector::from(ray.origin()), Vector::from(ray.direction()));
                for (point, at_rest) in limb.points.iter().zip(&limb.at_rest) {
                    if self.body.marks[*point].hue != dot.hue || at_rest.length() < NEAREST {
                        continue;
                    }
                    for way in meetings(from - self.head, along, at_rest.length()) {
                        for rotor in about(*at_rest, way) {
                            let found = self.scored(limb, rotor);
                            if best.as_ref().is_none_or(|best| found.score > best.score) {
                                best = Some(found);
                            }
                        }
                    }
                }
            }
        }
        best.filter(|best| best.score > 0.0 && best.matched.len() >= LEAST)
    }

    /// What a rotation explains.
    fn scored(&self, limb: &Limb, rotor: Rotor<f64>) -> Rotation {
        let mut score = 0.0;
        let mut matched: Vec<[usize; 3]> = Vec::new();
        for (view, camera) in self.cameras.iter().enumerate() {
            let eye = Vector::from(camera.centre());
            for (&point, at_rest) in limb.points.iter().zip(&limb.at_rest) {
                let mark = &self.body.marks[point];
                let place = self.head + rotated(rotor, *at_rest);
                let normal = rotated(rotor, mark.normal.into());
                let is_facing = (eye - place).dot(normal) >= FACING * eye.distance(place);
                let Some([u, v]) = camera.project(place.into()).ok().filter(|_| is_facing) else {
                    continue;
                };
                score -= UNSEEN;
                let mut nearest: Option<(f64, usize)> = None;
                for (index, dot) in self.dots[view].iter().enumerate() {
                    if dot.hue != mark.hue || !self.is_free[view][index] {
                        continue;
                    }
                    let squared = (dot.centre[0] - u).powi(2) + (dot.centre[1] - v).powi(2);
                    if squared <= GATE * GATE && nearest.is_none_or(|(least, _)| squared < least) {
                        nearest = Some((squared, index));
                    }
                }
                let Some((squared, index)) = nearest else {
                    continue;
                };
                if matched.iter().all(|&[v, _, dot]| [v, dot] != [view, index]) {
                    score += 1.0 - 0.5 * squared / (GATE * GATE);
                    matched.push([view, point, index]);
                }
            }
        }
        Rotation {
            score,
            rotor,
            matched,
        }
    }
}

/// The points of a ray on a sphere about the origin, or its nearest one where it passes by closely.
fn meetings(
    from: Vector<f64>,
    along: Vector<f64>,
    radius: f64,
) -> impl Iterator<Item = Vector<f64>> {
    let middle = -along.dot(from);
    let nearest = (from + along * middle).length();
    let half = (radius * radius - nearest * nearest).max(0.0).sqrt();
    let is_met = nearest <= radius + SLACK;
    let count = match (is_met, half > 0.0) {
        (false, _) => 0,
        (true, false) => 1,
        (true, true) => 2,
    };
    [middle - half, middle + half]
        .into_iter()
        .take(count)
        .map(move |distance| from + along * distance)
}

/// The rotations that take one direction to another.
fn about(from: Vector<f64>, to: Vector<f64>) -> impl Iterator<Item = Rotor<f64>> {
    let nearest = Rotor::between(from.into(), to.into());
    (0..STEPS).filter_map(move |step| {
        let angle = std::f64::consts::TAU * step as f64 / STEPS as f64;
        Some(Rotor::from_axis_angle(to.into(), angle)? * nearest?)
    })
}
