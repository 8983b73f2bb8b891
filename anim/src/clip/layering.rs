//! Poses laid over each other, with a weight for each joint.

use ga_runtime::cga3::Motor;

use crate::clip::ClipError;
use crate::pose::Pose;

/// A pose that is laid over others.
#[derive(Clone, Copy, Debug)]
pub struct Layer<'a> {
    /// The pose.
    pub pose: &'a Pose,
    /// How much of it is seen, from 0 to 1.
    pub weight: f64,
    /// A factor for each joint, from 0 to 1, such as 1 for the joints of an arm and 0 for all
    /// others; without it 1 for all. It does not change the weight of the root.
    pub joints: Option<&'a [f64]>,
    /// A factor for the root's motion, from 0 to 1.
    pub root: f64,
}

impl<'a> Layer<'a> {
    /// A whole pose with one weight for all.
    #[must_use]
    pub fn new(pose: &'a Pose, weight: f64) -> Self {
        Self {
            pose,
            weight,
            joints: None,
            root: 1.0,
        }
    }

    /// The same with a factor for each joint; the root stays as it is below.
    #[must_use]
    pub fn of_joints(self, factors: &'a [f64]) -> Self {
        Self {
            joints: Some(factors),
            root: 0.0,
            ..self
        }
    }
}

/// Lays poses over `pose`, the first layer first. Each replaces what is below it by a mean, with
/// the weight of the layer times the factor of the joint:
///
/// ```text
/// M ← ((1 − w) M ± w N) / |(1 − w) M ± w N|.
/// ```
///
/// This is the normalised sum of two motors, as in dual quaternion skinning; the sign is that of
/// the shorter rotation. With a weight of 0 the pose below stays as it is to the last bit, and with
/// 1 it becomes that of the layer. Two motors with equal weights give the middle of the screw from
/// one to the other. Nothing is allocated.
///
/// # Errors
///
/// [`ClipError`]; the pose is then unchanged.
///
/// ```
/// use ga_anim::clip::{Layer, overlay};
/// use ga_anim::pose::Pose;
/// use ga_runtime::cga3::{Motor, Translator};
/// let mut other = Pose::rest(2);
/// other.joints[1] = Motor::from(Translator::from_displacement([4.0, 0.0, 0.0]));
/// let mut pose = Pose::rest(2);
/// overlay(&mut pose, &[Layer::new(&other, 0.5).of_joints(&[1.0, 0.5])])?;
/// let [x, ..]: [f64; 3] = pose.joints[1].translator().displacement();
/// assert!((x - 1.0).abs() < 1e-15);
/// # Ok::<(), ga_anim::clip::ClipError>(())
/// ```
pub fn overlay(pose: &mut Pose, layers: &[Layer<'_>]) -> Result<(), ClipError> {
    for (index, layer) in layers.iter().enumerate() {
        check(index, layer, pose.joints.len())?;
    }
    for layer in layers {
        pose.root = mean(pose.root, layer.pose.root, layer.weight * layer.root);
        let joints = pose.joints.iter_mut().zip(&layer.pose.joints);
        match layer.joints {
            Some(factors) => {
                for ((below, &above), factor) in joints.zip(factors) {
                    *below = mean(*below, above, layer.weight * factor);
                }
            }
            None => {
                for (below, &above) in joints {
                    *below = mean(*below, above, layer.weight);
                }
            }
        }
    }
    Ok(())
}

/// The normalised sum of two motors, exactly one of them where the other has no weight.
#[inline]
pub(super) fn mean(from: Motor<f64>, to: Motor<f64>, weight: f64) -> Motor<f64> {
    if weight <= 0.0 {
        return from;
    }
    if weight >= 1.0 {
        return to;
    }
    from.nlerp(to, weight)
}

fn check(index: usize, layer: &Layer<'_>, expected: usize) -> Result<(), ClipError> {
    let found = layer.pose.joints.len();
    if found != expected {
        return Err(ClipError::LayerJointCount {
            layer: index,
            expected,
            found,
        });
    }
    let factors = layer.joints.unwrap_or_default();
    if layer.joints.is_some() && factors.len() != expected {
        let found = factors.len();
        return Err(ClipError::LayerWeightCount {
            layer: index,
            expected,
            found,
        });
    }
    let mut weights = [layer.weight, layer.root]
        .into_iter()
        .chain(factors.iter().copied());
    match weights.find(|weight| !(0.0..=1.0).contains(weight)) {
        Some(weight) => Err(ClipError::LayerWeight {
            layer: index,
            weight,
        }),
        None => Ok(()),
    }
}
