//! Which dot in a picture is which point of a body in a pose.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::MarkedBody;
use crate::chain::rotated;
use crate::marker::Dot;
use crate::{FittedPose, JointPixel, Observation};
use ga_anim::skeleton::SkeletonError;
use ga_camera::Camera;

/// The standard deviation of the centre of a dot that faces the camera, in pixels: most of it is
/// the bend of the skin.
const DEVIATION_PX: f64 = 0.25;
/// Cosine of the greatest angle between the normal and the direction to the camera at which the
/// whole of a dot on a limb is seen.
const FACING: f64 = 0.45;
/// A joint is recognised where the number of its dots that are found is at least the first value
/// times the number that chance would find, plus the second value.
const ABOVE_CHANCE: (f64, f64) = (3.0, 2.0);

/// For each view, the dot that each point is, if it is seen.
pub(super) type Assignment = Vec<Vec<Option<usize>>>;

impl MarkedBody {
    /// The dots within a distance of where a pose shows the points, in pixels, of the same hue: the
    /// nearest first, each at most once. Joints of which not more are found than by chance have
    /// none.
    pub(super) fn assigned(
        &self,
        cameras: &[Camera],
        dots: &[Vec<Dot>],
        fitted: &FittedPose,
        gate: f64,
    ) -> Result<Assignment, SkeletonError> {
        let normals = self.normals(fitted)?;
        let mut assignment: Assignment = vec![vec![None; self.marks.len()]; cameras.len()];
        let mut found = vec![0.0; self.model.skeleton().len()];
        let mut by_chance = vec![0.0; found.len()];
        for ((camera, dots), view) in cameras.iter().zip(dots).zip(&mut assignment) {
            let density = density(dots);
            let mut candidates: Vec<(f64, usize, usize)> = Vec::new();
            for (point, place) in fitted.points.iter().enumerate() {
                if cosine(camera, *place, normals[point]) < FACING {
                    continue;
                }
                let Ok([u, v]) = camera.project(*place) else {
                    continue;
                };
                let hue = self.marks[point].hue;
                let expected = std::f64::consts::PI * gate * gate * density[hue as usize];
                by_chance[self.strongest[point]] += expected.min(1.0);
                for (index, dot) in dots.iter().enumerate() {
                    let distance = (dot.centre[0] - u).hypot(dot.centre[1] - v);
                    if dot.hue == hue && distance <= gate {
                        candidates.push((distance, point, index));
                    }
                }
            }
            candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut is_taken = vec![false; dots.len()];
            for (_, point, dot) in candidates {
                if view[point].is_none() && !is_taken[dot] {
                    view[point] = Some(dot);
                    is_taken[dot] = true;
                    found[self.strongest[point]] += 1.0;
                }
            }
        }
        let (times, more) = ABOVE_CHANCE;
        for view in &mut assignment {
            for (point, dot) in view.iter_mut().enumerate() {
                let joint = self.strongest[point];
                if found[joint] < times * by_chance[joint] + more {
                    *dot = None;
                }
            }
        }
        Ok(assignment)
    }

    /// How many points face the cameras in a pose, over all views.
    pub(super) fn facing(
        &self,
        cameras: &[Camera],
        fitted: &FittedPose,
    ) -> Result<usize, SkeletonError> {
        let normals = self.normals(fitted)?;
        let faces = |camera: &Camera| {
            let points = fitted.points.iter().zip(&normals);
            let facing =
                points.filter(|(place, normal)| cosine(camera, **place, **normal) >= FACING);
            facing.count()
        };
        Ok(cameras.iter().map(faces).sum())
    }

    /// An assignment as what views show; dots that are seen from the side count less.
    pub(super) fn observation(
        &self,
        cameras: &[Camera],
        dots: &[Vec<Dot>],
        assignment: &Assignment,
        fitted: Option<&FittedPose>,
    ) -> Result<Observation, SkeletonError> {
        let normals = fitted.map(|fitted| self.normals(fitted)).transpose()?;
        let mut seen = Observation::unseen(cameras.len(), self.marks.len());
        for (index, view) in assignment.iter().enumerate() {
            for (point, dot) in view.iter().enumerate() {
                let Some(dot) = dot else { continue };
                let facing = match (fitted, &normals) {
                    (Some(fitted), Some(normals)) => {
                        cosine(&cameras[index], fitted.points[point], normals[point])
                    }
                    _ => 1.0,
                };
                seen.views[index][point] = Some(JointPixel {
                    position: dots[index][*dot].centre,
                    deviation: DEVIATION_PX / facing.max(FACING),
                });
            }
        }
        Ok(seen)
    }

    /// The normals of the points in a pose.
    fn normals(&self, fitted: &FittedPose) -> Result<Vec<Vector<f64>>, SkeletonError> {
        let motions = fitted.pose.motions(self.model.skeleton())?;
        let points = self.model.points().iter().zip(&self.marks);
        let normals = points.map(|(point, mark)| {
            let sum = point
                .joints
                .iter()
                .fold(Vector::default(), |sum, &(joint, weight)| {
                    sum + rotated(motions[joint].rotor(), mark.normal.into()) * weight
                });
            sum.normalized().unwrap_or_default()
        });
        Ok(normals.collect())
    }
}

/// Cosine of the angle between a normal and the direction to a camera.
fn cosine(camera: &Camera, place: Point<f64>, normal: Vector<f64>) -> f64 {
    let towards = Vector::from(camera.centre()) - Vector::from(place);
    towards
        .normalized()
        .map_or(0.0, |towards| towards.dot(normal))
}

/// For each hue, how many dots a square pixel of the box around all dots has.
fn density(dots: &[Dot]) -> [f64; 6] {
    let side = |axis: usize| {
        let places = dots.iter().map(|dot| dot.centre[axis]);
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| {
            (low.min(c), high.max(c))
        });
        (high - low).max(1.0)
    };
    let area = side(0) * side(1);
    let mut counts = [0.0; 6];
    for dot in dots {
        counts[dot.hue as usize] += 1.0 / area;
    }
    counts
}
