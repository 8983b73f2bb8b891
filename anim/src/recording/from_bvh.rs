use ga_runtime::cga3::Motor;

use super::{RecordedJoint, Recording};
use crate::bvh::Bvh;
use crate::recording::RecordingError;
use crate::transform::Transform;

impl Recording {
    /// The recording in a BVH file, with lengths in metres where one unit of the file is
    /// `metres_per_unit` long. A joint's frame has the axes of the file at rest; End Sites are not
    /// joints but [`ends`](Self::ends).
    ///
    /// # Errors
    ///
    /// [`RecordingError::Unit`] unless the length of a unit is positive and finite,
    /// [`RecordingError::NoFrames`], and [`RecordingError::Transform`] where a length overflows.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::recording::Recording;
    ///
    /// let motion = ga_anim::bvh::decode(
    ///     b"HIERARCHY ROOT arm { OFFSET 0 50 0 CHANNELS 1 Zrotation
    ///         JOINT hand { OFFSET 20 0 0 CHANNELS 1 Xrotation } }
    ///       MOTION Frames: 2 Frame Time: 0.01
    ///       0 0
    ///       90 0",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 0.01)?;
    /// assert_eq!(recording.frame_count(), 2);
    /// let hand = &recording.frame(1).ok_or("no frame")?[1];
    /// assert_eq!(hand.translation().coordinates(), [0.2, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_bvh(motion: &Bvh, metres_per_unit: f64) -> Result<Self, RecordingError> {
        if !metres_per_unit.is_finite() || metres_per_unit <= 0.0 {
            return Err(RecordingError::Unit(metres_per_unit));
        }
        let in_metres = |motor| Transform::from(scaled(motor, metres_per_unit));
        let joints = motion.joints().iter().map(|joint| RecordedJoint {
            name: joint.name.clone(),
            parent: joint.parent,
            rest: in_metres(joint.rest()),
        });
        let frames = (0..motion.frame_count()).filter_map(|frame| motion.own_motions(frame));
        let locals = frames.flatten().map(in_metres);
        let recording = Self::new(
            joints.collect(),
            motion.frame_time(),
            locals.collect(),
            Vec::new(),
        )?;
        let ends = motion.joints().iter().map(|joint| joint.end_site);
        let ends = ends.map(|end| Some(end?.map(|x| x * metres_per_unit)));
        Ok(Self {
            ends: ends.collect(),
            ..recording
        })
    }
}

/// The motor of the same motion with lengths times `factor`.
fn scaled(motor: Motor<f64>, factor: f64) -> Motor<f64> {
    let far = [motor.e1i(), motor.e2i(), motor.e3i(), motor.e123i()].map(|x| x * factor);
    let (scalar, [e12, e13, e23]) = (motor.scalar(), [motor.e12(), motor.e13(), motor.e23()]);
    Motor::new_unchecked(scalar, e12, e13, e23, far[0], far[1], far[2], far[3])
}
