//! The pose of a body from coloured dots on its skin.
//!
//! A dot in a picture has one of six [hues](crate::marker::Hue), so it alone does not say which
//! point of the skin it is. It is recognised together with its neighbours, in these steps:
//!
//! 1. Where the rays of two views to dots of one hue meet, there is a dot in space, or two dots
//!    that are taken for one.
//! 2. Three of them with the hues and nearly the distances of three dots of one joint give the
//!    motor that takes these there. It is as likely as other dots of the joint then are at
//!    their places. The most likely parts that meet at their joints are the body.
//! 3. The pose is fitted ([`BodyFit`]) to these dots in all pictures. Then all dots of the body
//!    that face a camera are projected, the nearest dot of the same hue in the picture is taken for
//!    each, also where only one view shows it, and the pose is fitted again, with a narrowing gate.
//!    Parts of which not more dots are found than chance would find are left out, and so are those
//!    whose dots do not fit to the pose. Limbs that were not recognised are searched about the
//!    joint by which they hang.
//!
//! This is how optical motion capture labels its markers (M. Ringer, J. Lasenby, A procedure for
//! automatically estimating model parameters in optical motion capture, 2004), with hues as a
//! further constraint. Nothing is known of the pose before.

mod assembly;
mod assignment;
mod body;
mod completion;
mod doubt;
mod joints;
mod parts;
mod space;

use ga_runtime::vga3::Vector;

pub use body::MarkedBody;
pub use parts::Mark;

use super::{BodyFit, BodyModel, FittedPose, Observation};
use crate::BodyError;
use crate::marker::Dot;
use assembly::{FIRST, assembled};
use assignment::Assignment;
use ga_anim::kinematics::KinematicsError;
use ga_camera::Camera;
use parts::{Part, Space};
use space::space_dots;

/// The distances from their expected places within which dots are searched, in pixels.
const GATES: [f64; 5] = [8.0, 5.0, 4.0, 3.0, 3.0];

/// Of the dots that face the cameras, one in so many is recognised of a body at least, half of
/// which may be hidden: where cameras or dots are others than was said, some fit by chance.
const RECOGNISED: usize = 4;

/// How often limbs are searched that were not recognised.
const COMPLETIONS: usize = 3;

/// A pose with the dots to which it was fitted.
struct Labelled {
    fitted: FittedPose,
    observation: Observation,
    assignment: Assignment,
}

/// A pose that was fitted to dots.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkedFit {
    /// The pose, and what remains in the pictures.
    pub fitted: FittedPose,
    /// Which dots were taken for the points of the model.
    pub observation: Observation,
    /// The joints with dots of which none was recognised in any view: how they are rotated is
    /// not known.
    pub unrecognised: Vec<usize>,
}

impl MarkedBody {
    /// A body with a mark at each of its points, in their order.
    ///
    /// # Errors
    /// [`BodyError::Marks`], [`BodyError::Normal`].
    pub fn new(model: BodyModel, marks: Vec<Mark>) -> Result<Self, BodyError> {
        let (expected, found) = (model.points().len(), marks.len());
        if expected != found {
            return Err(BodyError::Marks { expected, found });
        }
        let mut unit = Vec::with_capacity(marks.len());
        for (mark, point) in marks.into_iter().zip(model.points()) {
            let normal = Vector::from(mark.normal)
                .normalized()
                .filter(|n| n.is_finite());
            let normal = normal.ok_or_else(|| BodyError::Normal {
                point: point.name.clone(),
                normal: mark.normal,
            })?;
            unit.push(Mark {
                normal: normal.coordinates(),
                ..mark
            });
        }
        let strongest = model.points().iter().map(|point| {
            let strongest = point.joints.iter().max_by(|a, b| a.1.total_cmp(&b.1));
            strongest.map_or(0, |(joint, _)| *joint)
        });
        Ok(Self {
            strongest: strongest.collect(),
            parts: Part::all(&model, &unit),
            marks: unit,
            model,
        })
    }

    /// The body.
    #[must_use]
    pub fn model(&self) -> &BodyModel {
        &self.model
    }

    /// The marks of its points.
    #[must_use]
    pub fn marks(&self) -> &[Mark] {
        &self.marks
    }

    /// The most likely pose for the dots that the pictures of two cameras or more show.
    ///
    /// # Errors
    /// [`BodyError::DotViews`], [`BodyError::NoDots`], [`BodyError::DotNotFinite`] and
    /// [`BodyError::TooFewMarkers`], [`BodyError::Unrecognised`], and those of
    /// [`BodyFit::frame`](crate::BodyFit::frame).
    pub fn fit(&self, cameras: &[Camera], dots: &[Vec<Dot>]) -> Result<MarkedFit, BodyError> {
        check(cameras, dots)?;
        let fit = BodyFit::new(&self.model, cameras)?;
        let first = self.recognised(cameras, dots)?;
        let observation = self
            .observation(cameras, dots, &first, None)
            .map_err(pose)?;
        let mut found = Labelled {
            fitted: fit.frame(&observation)?,
            observation,
            assignment: first,
        };
        self.refine(&fit, cameras, dots, &mut found, &GATES)?;
        for _ in 0..COMPLETIONS {
            let mut more = found.assignment.clone();
            let fitted = &found.fitted;
            if !self
                .complete(cameras, dots, fitted, &mut more)
                .map_err(pose)?
            {
                break;
            }
            let seen = self
                .observation(cameras, dots, &more, Some(fitted))
                .map_err(pose)?;
            found.fitted = fit.frame(&seen)?;
            self.refine(&fit, cameras, dots, &mut found, &GATES[1..])?;
        }
        let Labelled {
            fitted,
            observation,
            assignment,
        } = found;
        let is_seen = |joint: usize| {
            assignment.iter().any(|view| {
                let points = view.iter().zip(&self.strongest);
                points
                    .into_iter()
                    .any(|(dot, own)| dot.is_some() && *own == joint)
            })
        };
        let joints = 0..self.model.skeleton().len();
        let unrecognised = joints
            .filter(|joint| self.strongest.contains(joint) && !is_seen(*joint))
            .collect();
        let recognised = assignment.iter().flatten().flatten().count();
        let facing = self.facing(cameras, &fitted).map_err(pose)?;
        if RECOGNISED * recognised < facing {
            return Err(BodyError::Unrecognised { recognised, facing });
        }
        Ok(MarkedFit {
            fitted,
            observation,
            unrecognised,
        })
    }

    /// Labels all dots anew by where the fitted pose shows them, and fits again, with one gate
    /// after the other. Parts whose dots do not fit then lose their labels.
    fn refine(
        &self,
        fit: &BodyFit<'_>,
        cameras: &[Camera],
        dots: &[Vec<Dot>],
        found: &mut Labelled,
        gates: &[f64],
    ) -> Result<(), BodyError> {
        let mut last = f64::INFINITY;
        for &gate in gates {
            let next = self
                .assigned(cameras, dots, &found.fitted, gate)
                .map_err(pose)?;
            let is_last = gate == last && next == found.assignment;
            if is_last || next.iter().flatten().all(Option::is_none) {
                break;
            }
            last = gate;
            found.observation = self
                .observation(cameras, dots, &next, Some(&found.fitted))
                .map_err(pose)?;
            found.assignment = next;
            found.fitted = fit.frame(&found.observation)?;
        }
        while let Some(joint) = self.worst_joint(&found.fitted, &found.observation) {
            for view in &mut found.assignment {
                let points = view.iter_mut().zip(&self.strongest);
                let of_joint = points.filter(|(_, own)| **own == joint);
                of_joint.for_each(|(dot, _)| *dot = None);
            }
            found.observation = self
                .observation(cameras, dots, &found.assignment, Some(&found.fitted))
                .map_err(pose)?;
            found.fitted = fit.frame(&found.observation)?;
        }
        Ok(())
    }

    /// The dots of the parts that are recognised in space.
    fn recognised(&self, cameras: &[Camera], dots: &[Vec<Dot>]) -> Result<Assignment, BodyError> {
        let in_space = space_dots(cameras, dots);
        let eyes = cameras.iter().map(|camera| Vector::from(camera.centre()));
        let space = Space::new(&in_space, eyes.collect());
        let placements: Vec<_> = self
            .parts
            .iter()
            .map(|part| part.placements(&space))
            .collect();
        let skeleton = self.model.skeleton();
        let placed = assembled(skeleton, &self.parts, &placements);
        if placed.iter().all(Option::is_none) {
            let best = self
                .parts
                .iter()
                .zip(&placements)
                .map(|(part, placements)| {
                    let counts = placements.iter().map(|placement| placement.matched.len());
                    (part.joint, counts.max().unwrap_or(0))
                });
            let (joint, found) = best.max_by_key(|(_, count)| *count).unwrap_or((0, 0));
            return Err(BodyError::TooFewMarkers {
                joint: skeleton.joints()[joint].name.clone(),
                found,
                needed: FIRST,
            });
        }
        let mut assignment: Assignment = vec![vec![None; self.marks.len()]; cameras.len()];
        for (point, dot) in placed
            .iter()
            .flatten()
            .flat_map(|placement| &placement.matched)
        {
            for (view, index) in in_space[*dot].seen {
                assignment[view][*point] = Some(index);
            }
        }
        Ok(assignment)
    }
}

fn pose(error: ga_anim::skeleton::SkeletonError) -> BodyError {
    KinematicsError::from(error).into()
}

fn check(cameras: &[Camera], dots: &[Vec<Dot>]) -> Result<(), BodyError> {
    let (expected, found) = (cameras.len(), dots.len());
    if expected != found {
        return Err(BodyError::DotViews { expected, found });
    }
    for (view, dots) in dots.iter().enumerate() {
        if dots.is_empty() {
            return Err(BodyError::NoDots { view });
        }
        let wrong = dots
            .iter()
            .find(|dot| !dot.centre.iter().all(|c| c.is_finite()));
        if let Some(dot) = wrong {
            let centre = dot.centre;
            return Err(BodyError::DotNotFinite { view, centre });
        }
    }
    Ok(())
}
