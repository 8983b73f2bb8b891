//! Measurements of the figure in motion.

use anyhow::Result;
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skin::{BodyReport, Method};
use ga_runtime::vga3::Vector;
use rayon::prelude::*;
use serde::Serialize;

use crate::figure::Figure;

/// What was measured on every frame of a clip.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Checks {
    /// The greatest difference between the length of a bone in a frame and at rest.
    pub(crate) bone_length_deviation_max_metres: f64,
    /// The height of the lowest vertex above the ground, where it is least and where it is
    /// greatest.
    pub(crate) lowest_vertex_min_metres: f64,
    pub(crate) lowest_vertex_max_metres: f64,
    /// The angle between the vertical and the direction from the root joint to the joint that is
    /// highest at rest.
    pub(crate) trunk_from_upright_mean_degrees: f64,
    pub(crate) trunk_from_upright_max_degrees: f64,
    /// The distance between the positions of a vertex by linear and by motor blend.
    pub(crate) linear_to_motor_blend_mean_metres: f64,
    pub(crate) linear_to_motor_blend_max_metres: f64,
}

/// What was measured on one frame.
struct Measured {
    body: BodyReport,
    blend_sum: f64,
    blend_max: f64,
}

impl Checks {
    /// Measures every frame.
    pub(crate) fn new(figure: &Figure, clip: &Clip) -> Result<Self> {
        let frames = clip
            .frames()
            .par_iter()
            .map(|pose| measure(figure, pose))
            .collect::<Result<Vec<_>>>()?;
        let count = frames.len() as f64;
        let bodies = || frames.iter().map(|frame| &frame.body);
        let lean = || bodies().map(|body| from_vertical(body.up));
        Ok(Self {
            bone_length_deviation_max_metres: bodies()
                .map(|body| body.bone_length_error)
                .fold(0.0, f64::max),
            lowest_vertex_min_metres: bodies()
                .map(|body| body.lowest)
                .fold(f64::INFINITY, f64::min),
            lowest_vertex_max_metres: bodies()
                .map(|body| body.lowest)
                .fold(f64::NEG_INFINITY, f64::max),
            trunk_from_upright_mean_degrees: lean().sum::<f64>() / count,
            trunk_from_upright_max_degrees: lean().fold(0.0, f64::max),
            linear_to_motor_blend_mean_metres: frames
                .iter()
                .map(|frame| frame.blend_sum)
                .sum::<f64>()
                / (count * figure.mesh.vertex_count().max(1) as f64),
            linear_to_motor_blend_max_metres: frames
                .iter()
                .map(|frame| frame.blend_max)
                .fold(0.0, f64::max),
        })
    }
}

fn measure(figure: &Figure, pose: &Pose) -> Result<Measured> {
    let body = BodyReport::new(
        figure.mesh.positions(),
        &figure.weights,
        &figure.skeleton,
        pose,
        Method::Motor,
    )?;
    let linear = figure.skinned(pose, Method::Linear)?;
    let motor = figure.skinned(pose, Method::Motor)?;
    let (mut blend_sum, mut blend_max) = (0.0, 0.0f64);
    for (a, b) in linear.into_iter().zip(motor) {
        let distance = distance(a, b);
        blend_sum += distance;
        blend_max = blend_max.max(distance);
    }
    Ok(Measured {
        body,
        blend_sum,
        blend_max,
    })
}

/// The angle between a direction and the vertical, in degrees.
fn from_vertical([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(z).atan2(y).to_degrees()
}

/// The distance between two points.
pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    Vector::from(a).distance(b.into())
}
