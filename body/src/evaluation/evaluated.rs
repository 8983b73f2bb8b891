//! An evaluation of all methods on a motion.

use serde::Serialize;

use super::case::Case;
use super::error::EvaluationError;
use super::motion::{BASELINE, DISTANCE, FOCAL_LENGTH, Motion};
use super::rows::{Row, measure};

/// How accurately bodies are reconstructed from a motion that synthetic cameras see: by one; by a
/// rig of two; or by three and more in a circle around the body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evaluation {
    /// What the numbers were measured on.
    pub data: &'static str,
    /// The length of one unit of the recording, in metres.
    pub metres_per_unit: f64,
    /// The number of joints that are compared.
    pub joints: usize,
    /// The number of frames.
    pub frames: usize,
    /// The frame rate of these frames.
    pub frames_per_second: f64,
    /// From the mean of the body's joints to each camera.
    pub distance_metres: f64,
    /// Between the two cameras of a rig.
    pub baseline_metres: f64,
    /// The focal length of the cameras.
    pub focal_length_px: f64,
    /// What noise and missing joints were made from.
    pub seed: u64,
    /// The errors of each method that the number of views allows, for each case in turn.
    pub rows: Vec<Row>,
}

impl Evaluation {
    /// Measures the errors of all methods in these cases. Each stretch of each case is measured on
    /// one thread, as many at a time as there are threads; `done` is told how many of how many are.
    /// Equal seeds give equal errors on any number of threads.
    ///
    /// # Errors
    /// [`EvaluationError`], where a camera does not see a joint among others.
    ///
    /// ```
    /// use ga_anim::bvh;
    /// use ga_body::evaluation::{Case, Evaluation, Method, Motion, MotionOptions};
    ///
    /// let arm = b"HIERARCHY
    /// ROOT Shoulder
    /// {
    ///   OFFSET 0 0 0
    ///   CHANNELS 3 Zrotation Xrotation Yrotation
    ///   JOINT Elbow
    ///   {
    ///     OFFSET 0.3 0 0
    ///     CHANNELS 3 Zrotation Xrotation Yrotation
    ///     JOINT Wrist
    ///     {
    ///       OFFSET 0.25 0 0
    ///       CHANNELS 3 Zrotation Xrotation Yrotation
    ///     }
    ///   }
    /// }
    /// MOTION
    /// Frames: 2
    /// Frame Time: 0.04
    /// 0 0 0 30 0 0 0 0 0
    /// 0 0 0 40 0 0 0 0 0
    /// ";
    /// let options = MotionOptions { metres_per_unit: Some(1.0), ..MotionOptions::default() };
    /// let motion = Motion::new(&bvh::decode(arm)?, &options)?;
    /// let cases = Case::combinations(&[0.0], &[2], &[0.0]);
    /// let found = Evaluation::new(&motion, &cases, 1, |_, _| ())?;
    /// let triangulation = found.rows.iter().find(|row| row.method == Method::Triangulation);
    /// assert!(triangulation.is_some_and(|row| row.mpjpe_mm < 1e-6));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        motion: &Motion,
        cases: &[Case],
        seed: u64,
        done: impl Fn(usize, usize) + Sync,
    ) -> Result<Self, EvaluationError> {
        Ok(Self {
            data: "this motion, seen by synthetic cameras; not Human3.6M",
            metres_per_unit: motion.metres_per_unit,
            joints: motion.model.points().len(),
            frames: motion.frame_count(),
            frames_per_second: motion.frames_per_second,
            distance_metres: DISTANCE,
            baseline_metres: BASELINE,
            focal_length_px: FOCAL_LENGTH,
            seed,
            rows: measure(motion, cases, seed, done)?,
        })
    }
}
