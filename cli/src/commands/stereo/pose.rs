//! `nullcone stereo pose`: the motion between two views.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Error, Result, ensure};
use ga_camera::Intrinsics;
use ga_camera::format::{self, NamedCamera};
use ga_image::plane::Plane;
use ga_runtime::cga3::Motor;
use ga_vision::ViewGeometryError;
use ga_vision::feature::{DetectOptions, ViewOptions, match_views};
use ga_vision::relative_pose::{Options, RelativePose, estimate};
use serde::Serialize;

use super::views;
use crate::camera_file::{about, check_size, read_one};
use crate::frame::{self, Command, Context, Progress};

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
/// "pairs": …, "pairs_outside_field": …, "inliers": …, "in_front": …, "rms_px": …,
/// "seconds": …}. The matrix is given by rows, and axis and direction have length 1. The deviations
/// are standard deviations of the result, estimated from what remains as if the pairs were
/// independent, which corners that are matched in several scales are not. pairs counts the matched
/// corners, pairs_outside_field those of them that are left out because the distortion of a lens
/// cannot be inverted there, inliers those that agree with the motion, and rms_px is the root mean
/// square of their distances from the epipolar condition. Equal seeds give equal results.
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
    rotation_matrix: [[f64; 3]; 3],
    rotation_axis: [f64; 3],
    rotation_degrees: f64,
    translation_direction: [f64; 3],
    rotation_deviation_degrees: Option<f64>,
    direction_deviation_degrees: Option<f64>,
    pairs: usize,
    pairs_outside_field: usize,
    inliers: usize,
    in_front: usize,
    rms_px: f64,
    seconds: f64,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let inputs = [&self.first, &self.second, &self.camera].into_iter();
        context.files(inputs.chain(&self.camera_b))?;
        ensure!(
            arguments.threshold.is_finite() && arguments.threshold > 0.0,
            "--threshold {}: it must be positive and finite",
            arguments.threshold
        );
        let progress = context.progress(3);
        progress.step("reading the views");
        let [first, second] = cameras(arguments)?;
        let views = [
            views::read(&arguments.first)?,
            views::read(&arguments.second)?,
        ];
        let second_path = arguments.camera_b.as_ref().unwrap_or(&arguments.camera);
        for (path, camera, view_path, view) in [
            (&arguments.camera, &first, &arguments.first, &views[0]),
            (second_path, &second, &arguments.second, &views[1]),
        ] {
            views::check_side(view, view_path)?;
            check_size(camera.size, [view.width(), view.height()], view_path, path)?;
        }

        let begin = Instant::now();
        progress.step("matching corners");
        let [a, b] = &views;
        let found = pose(
            a,
            b,
            [&first.intrinsics()?, &second.intrinsics()?],
            arguments,
            &progress,
        )
        .with_context(|| {
            let [a, b] = [&arguments.first, &arguments.second].map(|path| path.display());
            format!("{a} and {b}")
        })?;
        let seconds = begin.elapsed().as_secs_f64();
        drop(progress);

        Ok(Report::new(&found, seconds))
    }
}

/// The cameras of both views.
fn cameras(arguments: &Arguments) -> Result<[NamedCamera; 2]> {
    let (path, name) = (&arguments.camera, arguments.view.as_deref());
    let name_b = arguments.view_b.as_deref();
    if let Some(other) = &arguments.camera_b {
        return Ok([read_one(path, name)?, read_one(other, name_b)?]);
    }
    let file = format::read(path)?;
    let found = match (name, name_b, file.cameras.as_slice()) {
        (None, None, [first, second]) => Ok([first, second]),
        (None, Some(name_b), [first, _]) => file.camera(name_b).map(|second| [first, second]),
        _ => file.one(name).and_then(|first| {
            let second = name_b.map_or(Ok(first), |name| file.camera(name))?;
            Ok([first, second])
        }),
    };
    let found = found.map_err(|error| about(path, error))?;
    Ok(found.map(NamedCamera::clone))
}

/// A motion, and the corners that it was found from.
struct Found {
    motion: RelativePose,
    /// How many corners were matched.
    pairs: usize,
    /// How many of them have no direction.
    outside: usize,
}

fn pose(
    first: &Plane<u8>,
    second: &Plane<u8>,
    cameras: [&Intrinsics; 2],
    arguments: &Arguments,
    progress: &Progress,
) -> Result<Found> {
    let matching = ViewOptions {
        detect: DetectOptions {
            features: arguments.features,
            ..DetectOptions::default()
        },
        ..ViewOptions::default()
    };
    let mut pairs = match_views(first, second, &matching);
    let matched = pairs.len();
    // Near the corners of a view, the distortion of a wide lens may not be invertible.
    pairs.retain(|pair| {
        cameras[0].direction(pair.left).is_ok() && cameras[1].direction(pair.right).is_ok()
    });
    progress.step("searching the motion");
    let options = Options {
        threshold: arguments.threshold,
        seed: arguments.seed,
        ..Options::default()
    };
    let outside = matched - pairs.len();
    let motion = estimate(&pairs, cameras[0], cameras[1], &options);
    let motion = motion.map_err(|error| {
        let corners = match (error, outside) {
            (ViewGeometryError::TooFew { needed, .. }, _) if matched < needed => {
                let paths = [&*arguments.first, &*arguments.second];
                views::few_matches([first, second], paths, &matching.detect, needed)
            }
            (_, 0) => format!("{matched} pairs of corners"),
            _ => {
                format!("{matched} pairs of corners, {outside} of them outside the field of a lens")
            }
        };
        Error::new(error).context(corners)
    })?;
    Ok(Found {
        motion,
        pairs: matched,
        outside,
    })
}

impl Report {
    fn new(found: &Found, seconds: f64) -> Self {
        let Found {
            motion: found,
            pairs,
            outside,
        } = found;
        let motion: Motor<f64> = found.left_to_right.motor;
        let rotor = motion.rotor();
        let (rotation_axis, angle) = rotor.canonical().to_axis_angle();
        Self {
            rotation_matrix: rotor.to_matrix(),
            rotation_axis,
            rotation_degrees: angle.to_degrees(),
            translation_direction: motion.translator().displacement(),
            rotation_deviation_degrees: found.rotation_deviation().map(f64::to_degrees),
            direction_deviation_degrees: found.direction_deviation().map(f64::to_degrees),
            pairs: *pairs,
            pairs_outside_field: *outside,
            inliers: found.inliers.len(),
            in_front: found.in_front,
            rms_px: found.root_mean_square,
            seconds,
        }
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let vector = |[x, y, z]: [f64; 3]| format!("({x:.6}, {y:.6}, {z:.6})");
        let deviation = |value: Option<f64>| match value {
            Some(value) => format!(" ± {value:.3}°"),
            None => String::new(),
        };
        let outside = match self.pairs_outside_field {
            0 => String::new(),
            count => format!("{count} pairs of corners are outside the field of a lens\n"),
        };
        format!(
            "rotation {:.4}°{} about {}\ntranslation along {}{}\n\
             {} of {} pairs of corners agree to {:.3} px, {} in front of both cameras\n{outside}",
            self.rotation_degrees,
            deviation(self.rotation_deviation_degrees),
            vector(self.rotation_axis),
            vector(self.translation_direction),
            deviation(self.direction_deviation_degrees),
            self.inliers,
            self.pairs,
            self.rms_px,
            self.in_front
        )
    }
}
