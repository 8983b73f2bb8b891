//! Characters: bodies that move, and measurements of them in motion.

use ga_mesh::Mesh;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;
use serde::Serialize;

use crate::clip::Clip;
use crate::file_error::MotionFileError;
use crate::pose::Pose;
use crate::skeleton::{Skeleton, SkeletonError};
use crate::skin::{self, BodyReport, Method, SkinError};
use crate::weights::SkinWeights;

/// A body that moves: a mesh at rest, its joints, and how they move its vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Character {
    /// The mesh at rest, in the world.
    pub mesh: Mesh,
    /// The joints at rest, in the world.
    pub skeleton: Skeleton,
    /// The joints that move each vertex.
    pub weights: SkinWeights,
}

impl Character {
    /// The height of the mesh at rest; 0 without vertices.
    #[must_use]
    pub fn height(&self) -> f64 {
        let bounds = self.mesh.bounds();
        bounds.map_or(0.0, |[low, high]| high[1] - low[1])
    }

    /// The vertices in a pose.
    ///
    /// # Errors
    ///
    /// As [`skin`](skin::skin()), and [`SkinError::Skeleton`] for a pose of another skeleton.
    pub fn skinned(&self, pose: &Pose, method: Method) -> Result<Vec<[f64; 3]>, SkinError> {
        let motions = pose.motions(&self.skeleton)?;
        let moved = skin::skin(self.mesh.positions(), &self.weights, &motions, method)?;
        let places = moved.iter().map(|position| position.coordinates());
        Ok(places.collect())
    }

    /// The positions of the joints in a pose.
    ///
    /// # Errors
    ///
    /// [`SkeletonError`] for a pose of another skeleton.
    pub fn joints(&self, pose: &Pose) -> Result<Vec<[f64; 3]>, SkeletonError> {
        let bones = pose.bones(&self.skeleton)?;
        Ok(bones.into_iter().map(|[head, _]| head).collect())
    }

    /// The same character in another unit: lengths times `factor`.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Mesh`] and [`MotionFileError::Skeleton`] where a coordinate is no longer
    /// finite.
    pub fn scaled(self, factor: f64) -> Result<Self, MotionFileError> {
        Ok(Self {
            mesh: self.mesh.scaled(factor)?,
            skeleton: self.skeleton.scaled(factor)?,
            weights: self.weights,
        })
    }
}

/// What was measured on every frame of a clip of a character in metres, with y up and the ground at
/// the height 0.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MotionReport {
    /// The greatest difference between the length of a bone in a frame and at rest.
    pub bone_length_deviation_max_metres: f64,
    /// The height of the lowest vertex above the ground, where it is least.
    pub lowest_vertex_min_metres: f64,
    /// The same where it is greatest.
    pub lowest_vertex_max_metres: f64,
    /// The angle between the vertical and the direction from the root joint to the joint that is
    /// highest at rest, on average.
    pub trunk_from_upright_mean_degrees: f64,
    /// The same at most.
    pub trunk_from_upright_max_degrees: f64,
    /// The distance between the positions of a vertex by linear and by motor blend, on average.
    pub linear_to_motor_blend_mean_metres: f64,
    /// The same at most.
    pub linear_to_motor_blend_max_metres: f64,
}

/// What was measured on one frame.
struct Measured {
    body: BodyReport,
    blend_sum: f64,
    blend_max: f64,
}

impl MotionReport {
    /// Measures every frame.
    ///
    /// # Errors
    ///
    /// [`SkinError::Skeleton`] for a clip of another skeleton, [`SkinError::NoVertices`], and those
    /// of [`skin`](skin::skin()).
    pub fn new(character: &Character, clip: &Clip) -> Result<Self, SkinError> {
        let frames = clip.frames().par_iter();
        let frames = frames.map(|pose| Measured::new(character, pose));
        let frames = frames.collect::<Result<Vec<_>, _>>()?;
        let count = frames.len() as f64;
        let bodies = || frames.iter().map(|frame| &frame.body);
        let lowest = || bodies().map(|body| body.lowest);
        let lean = || bodies().map(|body| from_vertical(body.up));
        let blend_sum: f64 = frames.iter().map(|frame| frame.blend_sum).sum();
        let vertices = character.mesh.vertex_count().max(1) as f64;
        Ok(Self {
            bone_length_deviation_max_metres: bodies()
                .map(|body| body.bone_length_error)
                .fold(0.0, f64::max),
            lowest_vertex_min_metres: lowest().fold(f64::INFINITY, f64::min),
            lowest_vertex_max_metres: lowest().fold(f64::NEG_INFINITY, f64::max),
            trunk_from_upright_mean_degrees: lean().sum::<f64>() / count,
            trunk_from_upright_max_degrees: lean().fold(0.0, f64::max),
            linear_to_motor_blend_mean_metres: blend_sum / (count * vertices),
            linear_to_motor_blend_max_metres: frames
                .iter()
                .map(|frame| frame.blend_max)
                .fold(0.0, f64::max),
        })
    }
}

impl Measured {
    fn new(character: &Character, pose: &Pose) -> Result<Self, SkinError> {
        let Character {
            mesh,
            skeleton,
            weights,
        } = character;
        let body = BodyReport::new(mesh.positions(), weights, skeleton, pose, Method::Motor)?;
        let linear = character.skinned(pose, Method::Linear)?;
        let motor = character.skinned(pose, Method::Motor)?;
        let pairs = linear.into_iter().zip(motor);
        let distances = pairs.map(|(a, b)| Vector::from(a).distance(b.into()));
        let (blend_sum, blend_max) = distances.fold((0.0, 0.0f64), |(sum, max), distance| {
            (sum + distance, max.max(distance))
        });
        Ok(Self {
            body,
            blend_sum,
            blend_max,
        })
    }
}

/// The angle between a direction and the vertical, in degrees.
fn from_vertical([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(z).atan2(y).to_degrees()
}
