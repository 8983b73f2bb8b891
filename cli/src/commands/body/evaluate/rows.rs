//! The errors of each method under each disturbance.

use std::fmt;
use std::time::Instant;

use anyhow::Result;
use ga_runtime::cga3::Point;
use ga_vision::body::evaluation::{Disturbance, Scores, score, simulate, triangulated_points};
use ga_vision::body::{BodyFit, FittedPose};
use rayon::prelude::*;
use serde::Serialize;

use super::scene::{Motion, Stretch};

/// What the cameras see, and how many there are.
pub(super) struct Case {
    pub(super) noise_px: f64,
    pub(super) views: usize,
    pub(super) missing: f64,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            noise_px,
            views,
            missing,
        } = self;
        write!(
            f,
            "{views} views, {noise_px} px of noise, {missing} of the joints missing"
        )
    }
}

/// How a body is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Method {
    /// Each joint by itself.
    Triangulation,
    /// A pose for each frame.
    SingleFrame,
    /// Poses that are smooth over time.
    Clip,
}

impl Method {
    pub(super) const ALL: [Self; 3] = [Self::Triangulation, Self::SingleFrame, Self::Clip];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Triangulation => "triangulation",
            Self::SingleFrame => "single frame",
            Self::Clip => "clip",
        }
    }
}

/// The mean errors of a method.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Row {
    pub(super) method: Method,
    pub(super) noise_px: f64,
    pub(super) views: usize,
    pub(super) missing: f64,
    pub(super) mpjpe_mm: f64,
    pub(super) root_relative_mm: Option<f64>,
    pub(super) aligned_mm: Option<f64>,
    pub(super) joint_error_px: f64,
    pub(super) milliseconds_per_frame: f64,
    /// The part of the joints that the errors are means of.
    pub(super) joints_found: f64,
}

/// What a method found in a stretch, and the seconds that it took.
type Measured = (Scores, f64);

/// The rows of all methods that the number of views allows.
pub(super) fn measure(motion: &Motion, case: &Case, seed: u64) -> Result<Vec<Row>> {
    let stretches = motion.stretches.par_iter().enumerate();
    let measured = stretches.map(|(index, stretch)| {
        // Noise of its own for each stretch.
        let seed = seed.wrapping_add((index as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        measure_stretch(motion, stretch, case, seed)
    });
    let measured = measured.collect::<Result<Vec<_>>>()?;
    let rows = Method::ALL
        .iter()
        .enumerate()
        .filter_map(|(method, &name)| {
            let of_method = measured.iter().map(|stretch| stretch[method]);
            let of_method = of_method.collect::<Option<Vec<Measured>>>()?;
            let weights: Vec<f64> = motion
                .stretches
                .iter()
                .map(|s| s.frames.len() as f64)
                .collect();
            let mean = |value: &dyn Fn(&Scores) -> Option<f64>| {
                let values = of_method.iter().zip(&weights);
                let values = values.filter_map(|((scores, _), w)| Some((value(scores)?, *w)));
                let (sum, weight) = values.fold((0.0, 0.0), |(s, t), (x, w)| (s + w * x, t + w));
                (weight > 0.0).then(|| sum / weight)
            };
            let millimetres = |value: &dyn Fn(&Scores) -> Option<f64>| mean(value).map(|x| 1e3 * x);
            let seconds: f64 = of_method.iter().map(|(_, seconds)| seconds).sum();
            Some(Row {
                method: name,
                noise_px: case.noise_px,
                views: case.views,
                missing: case.missing,
                mpjpe_mm: millimetres(&|scores| Some(scores.position_error))?,
                root_relative_mm: millimetres(&|scores| scores.root_relative_error),
                aligned_mm: millimetres(&|scores| scores.aligned_error),
                joint_error_px: mean(&|scores| Some(scores.joint_error_px))?,
                milliseconds_per_frame: 1e3 * seconds / motion.frame_count() as f64,
                joints_found: mean(&|scores| Some(scores.found))?,
            })
        });
    Ok(rows.collect())
}

/// What each method finds; `None` for triangulation from one view.
fn measure_stretch(
    motion: &Motion,
    stretch: &Stretch,
    case: &Case,
    seed: u64,
) -> Result<[Option<Measured>; 3]> {
    let cameras = stretch.cameras(case.views)?;
    let disturbance = Disturbance {
        noise_px: case.noise_px,
        missing: case.missing,
        seed,
    };
    let seen = simulate(&cameras, &stretch.frames, &disturbance)?;
    let scores = |found: &[Vec<Option<Point<f64>>>]| score(&cameras, &stretch.frames, found);

    let triangulated = if case.views > 1 {
        let begin = Instant::now();
        let found: Vec<_> = seen
            .iter()
            .map(|s| triangulated_points(&cameras, s))
            .collect();
        let seconds = begin.elapsed().as_secs_f64();
        Some((scores(&found)?, seconds))
    } else {
        None
    };

    let fit = BodyFit::new(&motion.model, &cameras)?;
    let begin = Instant::now();
    let poses = seen.iter().map(|seen| fit.frame(seen));
    let poses = poses.collect::<Result<Vec<_>, _>>()?;
    let single = (scores(&points(&poses))?, begin.elapsed().as_secs_f64());

    let begin = Instant::now();
    let poses = fit.clip(&seen, motion.frames_per_second)?;
    let clip = (scores(&points(&poses))?, begin.elapsed().as_secs_f64());
    Ok([triangulated, Some(single), Some(clip)])
}

fn points(poses: &[FittedPose]) -> Vec<Vec<Option<Point<f64>>>> {
    let poses = poses.iter();
    poses
        .map(|pose| pose.points.iter().copied().map(Some).collect())
        .collect()
}
