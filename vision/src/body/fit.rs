//! Fits of poses to what views show.

use ga_anim::inverse_kinematics::{Marker, PoseFit, PoseFitSettings};
use ga_anim::pose::Pose;
use ga_runtime::cga3::Point;

use super::start::triangulated;
use super::{BodyError, BodyModel, ClipError, Observation};
use crate::camera::Camera;

/// Fits of the poses of a body to what views show, prepared for many frames.
#[derive(Clone, Debug)]
pub struct BodyFit<'a> {
    model: &'a BodyModel,
    cameras: &'a [Camera],
}

/// A pose that was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedPose {
    /// The motors of the joints and of the whole body, for the skeleton of the model.
    pub pose: Pose,
    /// Where the points of the model are, in the order of [`BodyModel::points`], in metres.
    pub points: Vec<Point<f64>>,
    /// For each view and each point how far its projection is from its pixel, in pixels; `None`
    /// where the view does not show it.
    pub residuals_px: Vec<Vec<Option<f64>>>,
    /// The root mean square of these distances.
    pub root_mean_square_px: f64,
    /// The points that no view shows: where they are follows from the other points, and what these
    /// do not determine from rest and, in a clip, from the frames before and after.
    pub unseen: Vec<usize>,
}

impl<'a> BodyFit<'a> {
    /// Prepares fits of a body that these cameras see.
    ///
    /// # Errors
    /// [`BodyError::NoViews`] where there is no camera.
    pub fn new(model: &'a BodyModel, cameras: &'a [Camera]) -> Result<Self, BodyError> {
        if cameras.is_empty() {
            return Err(BodyError::NoViews);
        }
        Ok(Self { model, cameras })
    }

    /// The most likely pose for what the views show at one time.
    ///
    /// # Errors
    /// Any [`BodyError`] but [`BodyError::NoViews`] and [`BodyError::FrameRate`].
    pub fn frame(&self, observation: &Observation) -> Result<FittedPose, BodyError> {
        self.check(observation)?;
        let targets = triangulated(self.model, self.cameras, observation)?;
        let seen = targets.iter().filter(|target| target.weight > 0.0).count();
        if seen < 3 {
            return Err(BodyError::TooFewPoints { seen, needed: 3 });
        }
        let skeleton = self.model.skeleton();
        let markers = self.model.points().iter().map(|point| {
            let strongest = point.joints.iter().max_by(|a, b| a.1.total_cmp(&b.1));
            Marker {
                joint: strongest.map_or(0, |(joint, _)| *joint),
                at_rest: point.at_rest,
            }
        });
        let mut pose = Pose::rest(skeleton.len());
        let mut fit = PoseFit::new(skeleton, self.model.limits(), markers.collect())?;
        fit.solve(&targets, &mut pose, &PoseFitSettings::default())?;
        let motions = pose.motions(skeleton).unwrap_or_default();
        let points = fit.markers().iter();
        let points = points.map(|marker| {
            let motion = motions[marker.joint];
            motion.transform(Point::from(marker.at_rest))
        });
        self.fitted(observation, pose.clone(), points.collect())
    }

    /// The most likely poses for what the views show in a clip.
    ///
    /// # Errors
    /// [`ClipError`] with the first frame that has an error of [`frame`](Self::frame), or a frame
    /// rate that is not positive.
    pub fn clip(
        &self,
        observations: &[Observation],
        frames_per_second: f64,
    ) -> Result<Vec<FittedPose>, ClipError> {
        if !(frames_per_second > 0.0 && frames_per_second.is_finite()) {
            let error = BodyError::FrameRate(frames_per_second);
            return Err(ClipError { frame: 0, error });
        }
        let fit = |(frame, observation)| {
            let fitted = self.frame(observation);
            fitted.map_err(|error| ClipError { frame, error })
        };
        observations.iter().enumerate().map(fit).collect()
    }

    /// Whether an observation fits the cameras and the model, with finite pixels.
    fn check(&self, observation: &Observation) -> Result<(), BodyError> {
        let (expected, found) = (self.cameras.len(), observation.views.len());
        if expected != found {
            return Err(BodyError::Views { expected, found });
        }
        let points = self.model.points();
        for (view, pixels) in observation.views.iter().enumerate() {
            let (expected, found) = (points.len(), pixels.len());
            if expected != found {
                return Err(BodyError::Points {
                    view,
                    expected,
                    found,
                });
            }
            for (pixel, point) in pixels.iter().zip(points) {
                let Some(pixel) = pixel else { continue };
                let point = || point.name.clone();
                if !pixel.position.iter().all(|x| x.is_finite()) {
                    return Err(BodyError::Pixel {
                        view,
                        point: point(),
                        pixel: pixel.position,
                    });
                }
                if !(pixel.deviation > 0.0 && pixel.deviation.is_finite()) {
                    return Err(BodyError::Deviation {
                        view,
                        point: point(),
                        deviation: pixel.deviation,
                    });
                }
            }
        }
        Ok(())
    }

    /// A pose with what remains in the pictures.
    fn fitted(
        &self,
        observation: &Observation,
        pose: Pose,
        points: Vec<Point<f64>>,
    ) -> Result<FittedPose, BodyError> {
        let mut residuals_px = Vec::with_capacity(self.cameras.len());
        let (mut sum, mut count) = (0.0, 0);
        let name = |index: usize| self.model.points()[index].name.as_str();
        for (view, (camera, pixels)) in self.cameras.iter().zip(&observation.views).enumerate() {
            let mut row = Vec::with_capacity(points.len());
            for (index, (pixel, place)) in pixels.iter().zip(&points).enumerate() {
                let Some(pixel) = pixel else {
                    row.push(None);
                    continue;
                };
                let [u, v] = camera
                    .project(*place)
                    .map_err(|error| BodyError::of_point(view, name(index), error))?;
                let distance = (u - pixel.position[0]).hypot(v - pixel.position[1]);
                sum += distance * distance;
                count += 1;
                row.push(Some(distance));
            }
            residuals_px.push(row);
        }
        let is_unseen = |point: &usize| observation.views.iter().all(|view| view[*point].is_none());
        Ok(FittedPose {
            pose,
            unseen: (0..points.len()).filter(is_unseen).collect(),
            points,
            residuals_px,
            root_mean_square_px: (sum / f64::from(count.max(1))).sqrt(),
        })
    }
}
