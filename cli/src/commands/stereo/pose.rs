//! `nullcone stereo pose`: the motion between two views.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Error, Result, ensure};
use ga_camera::format::NamedCamera;
use ga_vision::ViewGeometryError;
use ga_vision::feature::{DetectOptions, ViewOptions, match_views};
use ga_vision::relative_pose::{
    AlternativeMotion, MotionSummary, Options, estimate, retain_in_field,
};
use serde::Serialize;

use super::views;
use crate::camera_file::{LensChoice, about};
use crate::frame::{self, Command, Context, Warning};

/// Find how a camera moved between two views: the rotation, and the direction of the translation.
///
/// Corners of both views are matched, and the motion with which most of them agree is refined. A
/// point x in the frame of the first camera is at R x + t in the frame of the second one, with x to
/// the right, y down and z forward. Two views do not show how long t is.
///
/// For instance
///
///   nullcone stereo pose left.png right.png --camera K.yml --json
///
/// prints {"rotation_matrix": [[…], […], […]], "rotation_axis": […], "rotation_degrees": …,
/// "translation_direction": […], "rotation_deviation_degrees": …, "direction_deviation_degrees": …,
/// "cameras": […, …], "pairs": …, "pairs_outside_field": …, "inliers": …, "in_front": …,
/// "rms_px": …, "ambiguous": …, "alternatives": [{"rotation": …, "direction": …, …}, …],
/// "seconds": …}. The matrix is given by rows, and axis and direction have length 1. The deviations
/// are standard deviations of the result, estimated from what remains; they are larger where the
/// errors of neighbouring corners are alike. pairs counts the matched corners, pairs_outside_field
/// those of them that are left out because the distortion of a lens cannot be inverted there,
/// inliers those that agree with the motion, and rms_px is the root mean square of their distances
/// from the epipolar condition. Equal seeds give equal results.
///
/// Two views of a plane often have two motions that explain them alike. Then ambiguous is true, a
/// warning says so, and alternatives has the others: the matrix of the rotation, the direction of
/// the translation, their deviations, inliers, in_front and rms_px. A third view, or points beside
/// the plane, would tell which is right.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The first view.
    #[arg(value_name = "A")]
    first: PathBuf,
    /// The second view.
    #[arg(value_name = "B")]
    second: PathBuf,
    /// The camera of the first view, and of the second one unless --camera-b is given: a file of
    /// cameras of any format. Of a file with two cameras, the first is that of the first view and
    /// the second that of the second one. Their poses are not used.
    #[arg(long, value_name = "FILE")]
    camera: PathBuf,
    /// The camera of the second view.
    #[arg(long, value_name = "FILE")]
    camera_b: Option<PathBuf>,
    /// The camera of --camera that took the first view, and the second one unless --camera-b or
    /// --view-b is given: its name, or its number from 0.
    #[arg(long, value_name = "NAME")]
    view: Option<String>,
    /// The camera of --camera-b, or without it of --camera, that took the second view.
    #[arg(long, value_name = "NAME")]
    view_b: Option<String>,
    #[command(flatten)]
    lens: LensChoice,
    /// Corners that are farther from the epipolar condition are left out, in pixels.
    #[arg(long, value_name = "PX", default_value_t = Options::default().threshold)]
    threshold: f64,
    /// The greatest number of corners in each view.
    #[arg(long, value_name = "N", default_value_t = DetectOptions::default().features)]
    features: usize,
    /// The seed of the random samples.
    #[arg(long, value_name = "N", default_value_t = Options::default().seed)]
    seed: u64,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(flatten)]
    motion: MotionSummary,
    /// The cameras of both views by their names.
    cameras: [String; 2],
    pairs: usize,
    pairs_outside_field: usize,
    inliers: usize,
    in_front: usize,
    rms_px: f64,
    ambiguous: bool,
    alternatives: Vec<AlternativeMotion>,
    seconds: f64,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let inputs = [&self.first, &self.second, &self.camera].into_iter();
        context.files(inputs.chain(&self.camera_b))?;
        ensure!(
            self.threshold.is_finite() && self.threshold > 0.0,
            "--threshold {}: it must be positive and finite",
            self.threshold
        );
        let progress = context.progress(3);
        progress.step("reading the views");
        let cameras = self.cameras()?;
        let paths = [&*self.first, &*self.second];
        let views = views::read_both(paths)?;
        let second = self.camera_b.as_ref().unwrap_or(&self.camera);
        let files = [&self.camera, second];
        for side in 0..2 {
            let view = &views[side];
            views::check_side(view, paths[side])?;
            let size = [view.width(), view.height()];
            cameras[side].check_size(size, paths[side], files[side])?;
        }

        let begin = Instant::now();
        progress.step("matching corners");
        let named = || format!("{} and {}", paths[0].display(), paths[1].display());
        let intrinsics = |side: usize| {
            let found = cameras[side].intrinsics();
            found.map_err(|error| about(files[side], error))
        };
        let (left, right) = (intrinsics(0)?, intrinsics(1)?);
        let matching = ViewOptions {
            detect: DetectOptions {
                features: self.features,
                ..DetectOptions::default()
            },
            ..ViewOptions::default()
        };
        let mut pairs = match_views(&views[0], &views[1], &matching);
        let matched = pairs.len();
        let outside = retain_in_field(&mut pairs, &left, &right);
        progress.step("searching the motion");
        let options = Options {
            threshold: self.threshold,
            seed: self.seed,
            ..Options::default()
        };
        let found = estimate(&pairs, &left, &right, &options);
        let found = found.map_err(|error| {
            let corners = match (error, outside) {
                (ViewGeometryError::TooFew { needed, .. }, _) if matched < needed => {
                    views::few_matches(views.each_ref(), paths, &matching.detect, needed)
                }
                (_, 0) => format!("{matched} pairs of corners"),
                _ => format!(
                    "{matched} pairs of corners, {outside} of them outside the field of a lens"
                ),
            };
            Error::new(error).context(corners).context(named())
        })?;
        let seconds = begin.elapsed().as_secs_f64();
        drop(progress);

        let others = found.alternatives.len();
        let warnings = found.is_ambiguous().then(|| {
            let motions = match others {
                1 => "another motion explains".to_owned(),
                _ => format!("{others} other motions explain"),
            };
            let message = format!(
                "{}: {motions} the views as well, as two views of a plane do; \
                 the deviations hold for each by itself",
                named()
            );
            Warning::new("ambiguous_motion", message)
        });
        Ok(Report {
            motion: found.summary(),
            cameras: cameras.map(|camera| camera.name),
            pairs: matched,
            pairs_outside_field: outside,
            inliers: found.inliers.len(),
            in_front: found.in_front,
            rms_px: found.root_mean_square,
            ambiguous: found.is_ambiguous(),
            alternatives: found.alternative_summaries(),
            seconds,
            warnings: warnings.into_iter().collect(),
        })
    }
}

impl Arguments {
    /// The cameras of both views.
    fn cameras(&self) -> Result<[NamedCamera; 2]> {
        let (path, name) = (&self.camera, self.view.as_deref());
        let name_b = self.view_b.as_deref();
        if let Some(other) = &self.camera_b {
            let lens = self.lens;
            return Ok([lens.read_one(path, name)?, lens.read_one(other, name_b)?]);
        }
        let file = self.lens.read(path)?;
        let found = file.of_two_views([name, name_b]);
        let found = found.map_err(|error| about(path, error))?;
        Ok(found.map(NamedCamera::clone))
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let motion = &self.motion;
        let vector = |[x, y, z]: [f64; 3]| format!("({x:.6}, {y:.6}, {z:.6})");
        let deviation = |value: Option<f64>| match value {
            Some(value) => format!(" ± {value:.3}°"),
            None => String::new(),
        };
        let outside = match self.pairs_outside_field {
            0 => String::new(),
            count => format!("{count} pairs of corners are outside the field of a lens\n"),
        };
        let alternatives = self.alternatives.iter().map(|other| {
            format!(
                "or translation along {}{}, with the rotation {:.4?}\n",
                vector(other.direction),
                deviation(other.direction_deviation_degrees),
                other.rotation
            )
        });
        let alternatives: String = alternatives.collect();
        let [first, second] = &self.cameras;
        format!(
            "cameras {first} and {second}\nrotation {:.4}°{} about {}\n\
             translation along {}{}\n{alternatives}\
             {} of {} pairs of corners agree to {:.3} px, {} in front of both cameras\n{outside}",
            motion.rotation_degrees,
            deviation(motion.rotation_deviation_degrees),
            vector(motion.rotation_axis),
            vector(motion.translation_direction),
            deviation(motion.direction_deviation_degrees),
            self.inliers,
            self.pairs,
            self.rms_px,
            self.in_front
        )
    }
}
