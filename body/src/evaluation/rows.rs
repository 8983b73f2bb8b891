//! The errors of each method under each disturbance.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use ga_camera::triangulation::TriangulationError;
use ga_runtime::cga3::Point;
use serde::Serialize;

use super::case::Case;
use super::error::EvaluationError;
use super::motion::{Motion, Stretch};
use super::scores::{Scores, score};
use super::simulation::{Disturbance, simulate, triangulated_points};
use crate::{BodyError, BodyFit, FittedPose};

/// How a body is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Each joint by itself.
    Triangulation,
    /// A pose for each frame.
    SingleFrame,
    /// Poses that are smooth over time.
    Clip,
}

impl Method {
    /// All methods, in the order of the rows.
    pub const ALL: [Self; 3] = [Self::Triangulation, Self::SingleFrame, Self::Clip];

    /// The name for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Triangulation => "triangulation",
            Self::SingleFrame => "single frame",
            Self::Clip => "clip",
        }
    }
}

/// The mean errors of a method in a case, over all joints that it found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The method.
    pub method: Method,
    /// What the cameras saw.
    #[serde(flatten)]
    pub case: Case,
    /// The mean per joint position error, in millimetres.
    pub mpjpe_mm: f64,
    /// The same relative to the root, in millimetres; `None` where no frame has the root.
    pub root_relative_mm: Option<f64>,
    /// The error after Procrustes alignment, in millimetres; `None` where no frame has three
    /// joints.
    pub aligned_mm: Option<f64>,
    /// The distance in the pictures from where the joints truly are, in pixels.
    pub joint_error_px: f64,
    /// The time of one thread, in milliseconds.
    pub milliseconds_per_frame: f64,
    /// The part of the joints that the errors are means of.
    pub joints_found: f64,
}

/// What a method found in a stretch, and the seconds that it took.
type Measured = (Scores, f64);

/// The rows of all methods that the number of views allows, for each case in turn. Each stretch of
/// each case is measured on one thread, as many at a time as there are threads; `done` is told how
/// many are.
pub(super) fn measure(
    motion: &Motion,
    cases: &[Case],
    seed: u64,
    done: impl Fn(usize, usize) + Sync,
) -> Result<Vec<Row>, EvaluationError> {
    let stretches = motion.stretches.len();
    let all = cases.len() * stretches;
    let count = AtomicUsize::new(0);
    let measured = on_single_threads(all, |job| {
        let (case, index) = (&cases[job / stretches], job % stretches);
        // Noise of its own for each stretch.
        let seed = seed.wrapping_add((index as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let measured = measure_stretch(motion, &motion.stretches[index], case, seed);
        done(count.fetch_add(1, Ordering::Relaxed) + 1, all);
        measured.map_err(|error| EvaluationError::Case {
            case: *case,
            error: Box::new(error),
        })
    })?;
    let of_cases = cases.iter().zip(measured.chunks(stretches.max(1)));
    Ok(of_cases
        .flat_map(|(case, measured)| rows_of(motion, case, measured))
        .collect())
}

/// The results of jobs 0 to `count`, each of which runs on one thread alone together with all that
/// it would spread over several: so times that it takes are those of one thread.
fn on_single_threads<T: Send>(
    count: usize,
    job: impl Fn(usize) -> Result<T, EvaluationError> + Sync,
) -> Result<Vec<T>, EvaluationError> {
    type Numbered<T> = (usize, Result<T, EvaluationError>);
    let next = AtomicUsize::new(0);
    let work = || -> Result<Vec<Numbered<T>>, EvaluationError> {
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        let mut results = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return Ok(results);
            }
            results.push((index, alone.install(|| job(index))));
        }
    };
    let workers = rayon::current_num_threads().min(count);
    let of_workers = std::thread::scope(|scope| {
        let running: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        running
            .into_iter()
            .map(|worker| worker.join().map_err(|_| EvaluationError::Panic)?)
            .collect::<Result<Vec<_>, _>>()
    })?;
    let mut results: Vec<Numbered<T>> = of_workers.into_iter().flatten().collect();
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}

/// Means over the stretches, each with the weight of its frames.
fn rows_of(motion: &Motion, case: &Case, measured: &[[Option<Measured>; 3]]) -> Vec<Row> {
    let stretches = motion.stretches.iter();
    let weights: Vec<f64> = stretches.map(|s| s.frames.len() as f64).collect();
    let row = |(method, &name): (usize, &Method)| {
        let of_method = measured.iter().map(|stretch| stretch[method]);
        let of_method = of_method.collect::<Option<Vec<Measured>>>()?;
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
            case: *case,
            mpjpe_mm: millimetres(&|scores| Some(scores.position_error))?,
            root_relative_mm: millimetres(&|scores| scores.root_relative_error),
            aligned_mm: millimetres(&|scores| scores.aligned_error),
            joint_error_px: mean(&|scores| Some(scores.joint_error_px))?,
            milliseconds_per_frame: 1e3 * seconds / motion.frame_count() as f64,
            joints_found: mean(&|scores| Some(scores.found))?,
        })
    };
    Method::ALL.iter().enumerate().filter_map(row).collect()
}

/// What each method finds; `None` for triangulation from one view.
fn measure_stretch(
    motion: &Motion,
    stretch: &Stretch,
    case: &Case,
    seed: u64,
) -> Result<[Option<Measured>; 3], EvaluationError> {
    let cameras = stretch.cameras(case.views)?;
    let disturbance = Disturbance {
        noise_px: case.noise_px,
        missing: case.missing,
        seed,
    };
    let seen = simulate(&cameras, &stretch.frames, &disturbance)
        .map_err(|error| with_names(error, motion, stretch))?;
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
    let poses = seen.iter().enumerate().map(|(frame, seen)| {
        let pose = match fit.frame(seen) {
            Ok(pose) => Ok(Some(pose)),
            // A frame that shows too little has no pose of its own.
            Err(BodyError::TooFewPoints { .. } | BodyError::NoPose | BodyError::Behind { .. }) => {
                Ok(None)
            }
            Err(error) => Err(error),
        };
        pose.map_err(|error| BodyError::Frame {
            frame: stretch.number_in_file(frame),
            error: Box::new(error),
        })
    });
    let poses = poses.collect::<Result<Vec<_>, _>>()?;
    let seconds = begin.elapsed().as_secs_f64();
    let single = (scores(&points(&poses, motion))?, seconds);

    let begin = Instant::now();
    let poses = fit.clip(&seen, motion.frames_per_second);
    let seconds = begin.elapsed().as_secs_f64();
    let poses = poses.map_err(|error| match error {
        BodyError::Frame { frame, error } => BodyError::Frame {
            frame: stretch.number_in_file(frame),
            error,
        },
        error => error,
    })?;
    let poses: Vec<_> = poses.into_iter().map(Some).collect();
    let clip = (scores(&points(&poses, motion))?, seconds);
    Ok([triangulated, Some(single), Some(clip)])
}

/// The same with the frame of the file and the name of the joint.
fn with_names(error: BodyError, motion: &Motion, stretch: &Stretch) -> EvaluationError {
    let BodyError::Observation { frame, view, error } = error else {
        return error.into();
    };
    let frame = stretch.number_in_file(frame);
    match *error {
        TriangulationError::Unseen { point, error } => {
            let points = motion.model.points();
            let joint = points.get(point).map(|point| point.name.clone());
            EvaluationError::Joint {
                frame,
                view,
                joint: joint.unwrap_or_default(),
                error: Box::new(error),
            }
        }
        error => EvaluationError::Observation {
            frame,
            view,
            error: Box::new(error),
        },
    }
}

/// The points of poses; none of a frame without a pose.
fn points(poses: &[Option<FittedPose>], motion: &Motion) -> Vec<Vec<Option<Point<f64>>>> {
    let count = motion.model.points().len();
    let of_pose = |pose: &Option<FittedPose>| match pose {
        Some(pose) => pose.points.iter().copied().map(Some).collect(),
        None => vec![None; count],
    };
    poses.iter().map(of_pose).collect()
}
