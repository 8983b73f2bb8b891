//! The error of a compressed clip at the skin of a mesh.

use ga_runtime::cga3::Point;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::CompressedClip;
use super::sampler::Sampler;
use crate::kinematics::KinematicsError;
use crate::recording::{Recording, model_maps};
use crate::transform::Transform;
use crate::weights::{Influence, SkinWeights};

/// Why the error at a skin cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SkinMismatch {
    /// The recording has other joints or frames than the clip.
    #[error("the recording does not have the joints and frames of the clip")]
    Recording,
    /// There are weights for another number of joints or vertices.
    #[error(
        "weights for {joints} joints and {vertices} vertices do not fit the recording and mesh"
    )]
    Weights {
        /// How many joints the weights are for.
        joints: usize,
        /// How many vertices.
        vertices: usize,
    },
    /// The frame of a joint at rest has no inverse.
    #[error("joint {joint} is scaled to nothing at rest, so the skin cannot be attached to it")]
    Rest {
        /// The joint.
        joint: usize,
    },
    /// The hierarchy has no model space.
    #[error(transparent)]
    ModelSpace(#[from] KinematicsError),
}

/// The greatest distance, in metres and over all frames, of a vertex moved by the decoded clip from
/// its place by the recording. Vertices are given at rest, and moved by the weighted mean of the
/// positions to which the joints take them.
///
/// # Errors
///
/// Any [`SkinMismatch`].
pub fn error_at_skin(
    recording: &Recording,
    clip: &CompressedClip,
    positions: &[Point<f64>],
    weights: &SkinWeights,
) -> Result<f64, SkinMismatch> {
    let (parents, count) = (recording.parents(), recording.joints().len());
    if parents != clip.parents() || recording.frame_count() != clip.frame_count() {
        return Err(SkinMismatch::Recording);
    }
    let (joints, vertices) = (weights.joint_count(), weights.vertex_count());
    if joints != count || vertices != positions.len() {
        return Err(SkinMismatch::Weights { joints, vertices });
    }
    let rest: Vec<_> = recording.joints().iter().map(|joint| joint.rest).collect();
    let mut attachments = vec![Affine::default(); count];
    model_maps(parents, &rest, &mut attachments)?;
    for (joint, map) in attachments.iter_mut().enumerate() {
        *map = map.inverse().ok_or(SkinMismatch::Rest { joint })?;
    }
    let influences: Vec<&[Influence]> = weights.iter().collect();
    let frames: Vec<usize> = (0..recording.frame_count()).collect();
    let errors: Result<Vec<f64>, SkinMismatch> = frames
        .par_chunks(64)
        .map(|frames| {
            let mut sampler = Sampler::new(clip);
            let mut greatest = 0.0f64;
            let mut found = vec![Transform::default(); count];
            let mut found_maps = vec![Affine::default(); count];
            let mut maps = vec![Affine::default(); count];
            for &frame in frames {
                sampler.sample_frame(frame);
                sampler.locals(&mut found)?;
                model_maps(parents, &found, &mut found_maps)?;
                let truth = &recording.locals()[frame * count..][..count];
                model_maps(parents, truth, &mut maps)?;
                for ((map, found), &attachment) in
                    maps.iter_mut().zip(&found_maps).zip(&attachments)
                {
                    *map = difference(found, *map) * attachment;
                }
                for (&position, influences) in positions.iter().zip(&influences) {
                    let moved = influences.iter().fold(Vector::default(), |sum, influence| {
                        let image = maps[influence.joint as usize].transform(position);
                        sum + Vector::from(image.coordinates()) * influence.weight
                    });
                    greatest = greatest.max(moved.length());
                }
            }
            Ok(greatest)
        })
        .collect();
    Ok(errors?.into_iter().fold(0.0, f64::max))
}

/// The map that takes a point to the difference of its images.
fn difference(found: &Affine<f64>, truth: Affine<f64>) -> Affine<f64> {
    let minus = |found: [f64; 3], truth: [f64; 3]| [0, 1, 2].map(|k| found[k] - truth[k]);
    Affine::new(
        [0, 1, 2].map(|row| minus(found.linear[row], truth.linear[row])),
        minus(found.translation, truth.translation),
    )
}
