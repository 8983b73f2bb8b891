//! `nullcone stereo calibrate`: a rig from pictures of a chessboard.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_camera::Intrinsics;
use ga_camera::format::rig;
use ga_files::{natural_order, numbers};
use ga_image::plane::Plane;
use ga_image::png;
use ga_vision::calibration::{
    CalibrationError, CameraSettings, JointIntrinsics, LEAST_VIEWS, LensTerms, SquareEdges, Start,
    StereoCalibration, StereoSettings, calibrate_stereo, square_edges,
};
use ga_vision::chessboard::{BoardSize, Chessboard, find, pair_picture};
use serde::Serialize;

use super::views;
use crate::camera_file::{about, read_side};
use crate::files::expanded;
use crate::format::Format;
use crate::frame::{
    self, Check, Command, Context, Progress, Verdict, Warning, command_line, keep_for_failure,
};
use crate::output;
use crate::rotation::smaller_rotation;

/// Calibrate a stereo rig from pairs of pictures of a chessboard.
///
/// The views are sorted by name, where numbers count as numbers, and paired in that order. A name
/// of a file counts before a pattern; the program itself matches patterns, or the shell does.
/// Pairs in which the board is not found, or that do not agree with the others, are left out. For
/// instance
///
///   nullcone stereo calibrate --board 9x6 --square 0.025 --left 'left*.jpg' --right 'right*.jpg'
///     --out rig.yml --json
///
/// prints {"rms_px": …, "rms_left_px": …, "rms_right_px": …, "pairs_used": …,
/// "pairs_rejected": […], "baseline_metres": …, …}. rms_px is the root mean square distance of all
/// corners from the projections of their places on the boards, as OpenCV's stereoCalibrate returns
/// it.
///
/// The verdict is good where at least 10 pairs were used, rms_px is at most 1, and the numbers in
/// the names of all pairs belong together as in the first; else it is doubtful, and --json has the
/// reasons as "warnings".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The number of inner corners: columns x rows.
    #[arg(long, value_name = "9x6")]
    board: BoardSize,
    /// The side of a square in metres.
    #[arg(long, value_name = "METRES")]
    square: f64,
    /// The left views: names, or patterns with `*`, `?` or `[abc]`; `**` stands for any folders.
    #[arg(long, value_name = "FILE or GLOB", required = true, num_args = 1..)]
    left: Vec<String>,
    /// The right views.
    #[arg(long, value_name = "FILE or GLOB", required = true, num_args = 1..)]
    right: Vec<String>,
    /// Write the rig in OpenCV's YAML: M1, D1, M2, D2, R and T.
    #[arg(long, value_name = "RIG.yml")]
    out: PathBuf,
    /// What to do with focal lengths, principal points and distortion.
    #[arg(long, value_enum, default_value_t = IntrinsicsChoice::Joint)]
    intrinsics: IntrinsicsChoice,
    /// The distortion that is determined: none, fisheye, or terms such as k1,k2,p1,p2,k3.
    #[arg(long, value_name = "TERMS", default_value_t = LensTerms::default())]
    distortion: LensTerms,
    /// The left camera, of a file of any format: a guess, or, with --intrinsics known, the truth.
    /// Of a rig, it is the left camera.
    #[arg(long, value_name = "FILE")]
    left_camera: Option<PathBuf>,
    /// The right camera; of a rig, it is the right camera.
    #[arg(long, value_name = "FILE")]
    right_camera: Option<PathBuf>,
    /// Use all pairs with a board, also those that do not agree with the others.
    #[arg(long)]
    keep_outliers: bool,
    /// Write pictures of the corners that were found into a folder.
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    #[command(flatten)]
    check: Check,
}

/// OpenCV's guide to calibration asks for at least this number of views of the board.
const ENOUGH_PAIRS: usize = 10;

/// Calibrations of usual cameras are below this: boards that are not flat, lenses with other
/// distortion and wrong corners are above it.
const MOST_RMS_PX: f64 = 1.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum IntrinsicsChoice {
    /// Determine them together with the motion between the cameras.
    Joint,
    /// Determine them for each camera by itself, and then the motion between the cameras.
    Separate,
    /// Keep those of --left-camera and --right-camera.
    Known,
}

/// What is printed. Lengths in metres, unless the name has another unit.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    next: String,
    #[serde(skip)]
    warnings: Vec<Warning>,
    rms_px: f64,
    rms_left_px: f64,
    rms_right_px: f64,
    /// The pairs that were made of the files.
    pairs: Vec<PairFiles>,
    pairs_used: usize,
    pairs_rejected: Vec<Rejected>,
    baseline_metres: f64,
    baseline_deviation_metres: f64,
    square_edge_mean_metres: f64,
    square_edge_rms_error_metres: f64,
    rotation_degrees: f64,
    left: CameraReport,
    right: CameraReport,
    pair_rms_px: Vec<f64>,
}

#[derive(Serialize)]
struct PairFiles {
    left: String,
    right: String,
}

#[derive(Serialize)]
struct Rejected {
    left: String,
    right: String,
    reason: String,
}

/// Intrinsic parameters with their standard deviations.
#[derive(Serialize)]
struct CameraReport {
    focal_px: [f64; 2],
    focal_deviation_px: [f64; 2],
    principal_px: [f64; 2],
    principal_deviation_px: [f64; 2],
    distortion: Vec<f64>,
    distortion_deviation: Vec<f64>,
}

/// A pair of views in which the board was found.
struct Pair {
    index: usize,
    /// The views, where pictures of the corners are to be drawn.
    views: Option<[Plane<u8>; 2]>,
    boards: [Chessboard; 2],
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let square = arguments.square;
        ensure!(
            square > 0.0 && square.is_finite(),
            "--square {square}: the side of a square must be positive and finite"
        );
        let settings = settings(arguments)?;
        let files = pairs_of_files(&arguments.left, &arguments.right)?;
        check_outputs(arguments, context, &files)?;
        let other_numbers = warning_of_other_numbers(&files);
        keep_for_failure(other_numbers.as_slice());
        let mut report = calibrated(arguments, context, &files, &settings)?;
        report.warnings.extend(other_numbers);
        Ok(report)
    }
}

/// Finds the boards, calibrates and writes the results.
fn calibrated(
    arguments: &Arguments,
    context: &Context,
    files: &[[PathBuf; 2]],
    settings: &StereoSettings,
) -> Result<Report> {
    let square = arguments.square;
    let progress = context.progress(files.len() as u64 + 1);
    let (size, pairs, mut rejected) = find_boards(arguments, files, &progress)?;
    progress.step("calibrating");
    if pairs.len() < LEAST_VIEWS {
        let first = rejected.first().map(|rejected| rejected.reason.clone());
        bail!(
            "the board was found in {} of {} pairs, and {LEAST_VIEWS} are needed{}",
            pairs.len(),
            files.len(),
            first
                .map(|reason| format!("; first: {reason}"))
                .unwrap_or_default()
        );
    }
    let corners = |side: usize| -> Vec<Vec<[f64; 2]>> {
        let boards = pairs
            .iter()
            .map(|pair| pair.boards[side].corners().to_vec());
        boards.collect()
    };
    let [left, right] = [corners(0), corners(1)];
    let places = arguments.board.places(square);
    let found = calibrate_stereo([&left, &right], &places, size, settings);
    let found = found.map_err(|error| {
        let pair = error.view().map(|pair| &files[pairs[pair].index]);
        let error = anyhow::Error::new(error);
        match pair {
            Some([left, right]) => {
                error.context(format!("{} and {}", left.display(), right.display()))
            }
            None => error,
        }
    })?;
    for outlier in &found.outliers {
        rejected.push(Rejected::new(
            &files[pairs[outlier.pair].index],
            outlier.to_string(),
        ));
    }
    let used = |views: &[Vec<[f64; 2]>]| -> Vec<Vec<[f64; 2]>> {
        found.used.iter().map(|&pair| views[pair].clone()).collect()
    };
    let edges = square_edges(
        &found.rig,
        [&used(&left), &used(&right)],
        arguments.board,
        square,
    )
    .context("the edges of the squares cannot be measured")?;
    let contents = rig::encode(&found.rig, Some(size));
    let contents = contents.with_context(|| arguments.out.display().to_string())?;
    let mut outputs = vec![(arguments.out.clone(), contents.into_bytes())];
    if let Some(folder) = &arguments.pictures {
        outputs.extend(pictures(folder, &pairs)?);
    }
    output::write_together(outputs)?;
    drop(progress);
    let mut report = Report::new(&found, edges, files, rejected);
    report.next = next(&files[pairs[found.used[0]].index], &arguments.out);
    Ok(report)
}

/// How a pair of views is rectified with the rig.
fn next([left, right]: &[PathBuf; 2], rig: &Path) -> String {
    command_line([
        "nullcone stereo rectify".as_ref(),
        left.as_os_str(),
        right.as_os_str(),
        "--rig".as_ref(),
        rig.as_os_str(),
        "--out".as_ref(),
        "rectified".as_ref(),
    ])
}

fn settings(arguments: &Arguments) -> Result<StereoSettings> {
    let read = |path: &Option<PathBuf>, side: usize| -> Result<Option<Intrinsics>> {
        let Some(path) = path else { return Ok(None) };
        let intrinsics = read_side(path, side)?.intrinsics();
        Ok(Some(intrinsics.map_err(|error| about(path, error))?))
    };
    let cameras = [
        read(&arguments.left_camera, 0)?,
        read(&arguments.right_camera, 1)?,
    ];
    let is_known = arguments.intrinsics == IntrinsicsChoice::Known;
    ensure!(
        !is_known || cameras.iter().all(Option::is_some),
        "--intrinsics known needs --left-camera and --right-camera"
    );
    let start = |camera: Option<Intrinsics>| match camera {
        Some(intrinsics) if is_known => Start::Fixed(intrinsics),
        Some(intrinsics) => Start::Guess(intrinsics),
        None => Start::Boards,
    };
    let camera = |camera| CameraSettings {
        start: start(camera),
        terms: arguments.distortion,
    };
    let defaults = StereoSettings::default();
    Ok(StereoSettings {
        cameras: cameras.map(camera),
        joint: match arguments.intrinsics {
            IntrinsicsChoice::Joint => JointIntrinsics::Free,
            IntrinsicsChoice::Separate | IntrinsicsChoice::Known => JointIntrinsics::Fixed,
        },
        outlier_ratio: defaults.outlier_ratio.filter(|_| !arguments.keep_outliers),
    })
}

/// Fails where the results could not be written, or would replace what is read.
fn check_outputs(arguments: &Arguments, context: &Context, pairs: &[[PathBuf; 2]]) -> Result<()> {
    let cameras = arguments.left_camera.iter().chain(&arguments.right_camera);
    let mut files = context.files(pairs.as_flattened().iter().chain(cameras))?;
    files.write("--out", &arguments.out, &[Format::Yaml])?;
    if let Some(folder) = &arguments.pictures {
        files.write_folder("--pictures", folder, (0..pairs.len()).map(corners_name))?;
    }
    Ok(())
}

/// The files of the left and the right views, in pairs.
fn pairs_of_files(left: &[String], right: &[String]) -> Result<Vec<[PathBuf; 2]>> {
    let sorted = |option: &str, arguments| -> Result<Vec<PathBuf>> {
        let mut files = expanded(option, arguments)?;
        natural_order(&mut files);
        files.dedup();
        Ok(files)
    };
    let left = sorted("--left", left)?;
    let right = sorted("--right", right)?;
    ensure!(
        left.len() == right.len(),
        "{} left views and {} right ones do not make pairs",
        left.len(),
        right.len()
    );
    let pairs = left.into_iter().zip(right);
    Ok(pairs.map(|(left, right)| [left, right]).collect())
}

/// A warning of the first pair whose names do not belong together by their numbers: where a number
/// of the left name differs from that of the right one, it does so as in the first pair, as 0 and 1
/// in
/// `0-07.png` and `1-07.png`. Names with different counts of numbers are not compared.
fn warning_of_other_numbers(pairs: &[[PathBuf; 2]]) -> Option<Warning> {
    let changes = |pair: &[PathBuf; 2]| {
        let [left, right] = pair.each_ref().map(|path| numbers(path));
        let is_comparable = left.len() == right.len();
        let both = left.into_iter().zip(right).filter(|_| is_comparable);
        both.map(|(left, right)| (left != right).then_some((left, right)))
            .collect::<Vec<_>>()
    };
    let first = pairs.first().map(changes);
    let [left, right] = pairs.iter().find(|pair| Some(changes(pair)) != first)?;
    let text = format!(
        "{} and {} are a pair by their places in the lists, but their numbers differ otherwise \
         than those of the first pair",
        left.display(),
        right.display()
    );
    Some(Warning::new("other_numbers", text))
}

type Found = ([usize; 2], Vec<Pair>, Vec<Rejected>);

/// Looks for the board in all views, which must have one size.
fn find_boards(
    arguments: &Arguments,
    files: &[[PathBuf; 2]],
    progress: &Progress,
) -> Result<Found> {
    let mut size: Option<[usize; 2]> = None;
    let (mut pairs, mut rejected) = (Vec::new(), Vec::new());
    for (index, files_of_pair) in files.iter().enumerate() {
        progress.step("looking for the board");
        let [left, right] = files_of_pair;
        let views = views::read_pair(left, right)?;
        let own = [views[0].width(), views[0].height()];
        let [width, height] = *size.get_or_insert(own);
        ensure!(
            own == [width, height],
            "the views differ in size: {} has {} × {} pixels and {} has {width} × {height}",
            left.display(),
            own[0],
            own[1],
            files[0][0].display(),
        );
        let board = |side: usize| -> Result<Result<Chessboard, String>> {
            match find(&views[side], arguments.board) {
                Ok(board) => Ok(Ok(board)),
                Err(error @ CalibrationError::NotFound { .. }) => {
                    let path = files_of_pair[side].display();
                    Ok(Err(format!("{path}: {error}")))
                }
                Err(error) => Err(error.into()),
            }
        };
        match (board(0)?, board(1)?) {
            (Ok(left), Ok(right)) => {
                let right = right.ordered_like(&left);
                pairs.push(Pair {
                    index,
                    views: arguments.pictures.is_some().then_some(views),
                    boards: [left, right],
                });
            }
            (Err(left), Err(right)) => {
                rejected.push(Rejected::new(files_of_pair, format!("{left}; {right}")));
            }
            (Err(reason), _) | (_, Err(reason)) => {
                rejected.push(Rejected::new(files_of_pair, reason));
            }
        }
    }
    Ok((size.unwrap_or_default(), pairs, rejected))
}

/// The name of the picture of a pair.
fn corners_name(index: usize) -> String {
    format!("corners{:03}.png", index + 1)
}

/// For each pair a picture of both views with the corners that were found: its path and its bytes.
fn pictures(folder: &Path, pairs: &[Pair]) -> Result<Vec<(PathBuf, Vec<u8>)>> {
    let mut files = Vec::new();
    for Pair {
        index,
        views,
        boards,
    } in pairs
    {
        if let Some(views) = views {
            let path = folder.join(corners_name(*index));
            files.push((path, png::encode(&pair_picture(views, boards))?));
        }
    }
    Ok(files)
}

impl PairFiles {
    fn new(files: &[PathBuf; 2]) -> Self {
        let [left, right] = files.each_ref().map(|path| path.display().to_string());
        Self { left, right }
    }
}

impl Rejected {
    fn new([left, right]: &[PathBuf; 2], reason: String) -> Self {
        let [left, right] = [left, right].map(|path| path.display().to_string());
        Self {
            left,
            right,
            reason,
        }
    }
}

impl CameraReport {
    fn new(camera: &Intrinsics, deviations: &[f64; Intrinsics::MAX_PARAMETERS]) -> Self {
        // Coefficients that stay 0 after the last other one say nothing.
        let coefficients = &camera.parameters()[4..];
        let last = coefficients
            .iter()
            .rposition(|coefficient| *coefficient != 0.0);
        let count = last.map_or(0, |last| last + 1);
        Self {
            focal_px: camera.focal(),
            focal_deviation_px: [deviations[0], deviations[1]],
            principal_px: camera.principal(),
            principal_deviation_px: [deviations[2], deviations[3]],
            distortion: coefficients[..count].to_vec(),
            distortion_deviation: deviations[4..4 + count].to_vec(),
        }
    }
}

impl Report {
    fn new(
        found: &StereoCalibration,
        edges: SquareEdges,
        files: &[[PathBuf; 2]],
        rejected: Vec<Rejected>,
    ) -> Self {
        let rig = &found.rig;
        let (_, degrees) = smaller_rotation(rig.left_to_right().motor.rotor());
        let mut warnings = Vec::new();
        if found.used.len() < ENOUGH_PAIRS {
            let text = format!(
                "{} pairs were used, and {ENOUGH_PAIRS} are recommended",
                found.used.len()
            );
            warnings.push(Warning::new("few_pairs", text));
        }
        if found.rms > MOST_RMS_PX {
            let text = format!(
                "the corners are {:.3} px from their projections (root mean square), more than \
                 {MOST_RMS_PX} px",
                found.rms
            );
            warnings.push(Warning::new("large_rms", text));
        }
        Self {
            next: String::new(),
            warnings,
            rms_px: found.rms,
            rms_left_px: found.camera_rms[0],
            rms_right_px: found.camera_rms[1],
            pairs: files.iter().map(PairFiles::new).collect(),
            pairs_used: found.used.len(),
            pairs_rejected: rejected,
            baseline_metres: rig.baseline(),
            baseline_deviation_metres: found.baseline_deviation,
            square_edge_mean_metres: edges.mean,
            square_edge_rms_error_metres: edges.rms_error,
            rotation_degrees: degrees,
            left: CameraReport::new(&rig.left.intrinsics, &found.deviations[0]),
            right: CameraReport::new(&rig.right.intrinsics, &found.deviations[1]),
            pair_rms_px: found.pair_rms.clone(),
        }
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(Verdict::of(&self.warnings))
    }

    fn next(&self) -> Option<String> {
        Some(self.next.clone())
    }

    fn text(&self) -> String {
        let mut table = format!(
            "rms        {:.4} px (left {:.4}, right {:.4})\npairs      {} used, {} rejected\n\
             baseline   {:.6} m ± {:.6}\nrotation   {:.4}°\n\
             edges      {:.6} m on average, ± {:.6}\n",
            self.rms_px,
            self.rms_left_px,
            self.rms_right_px,
            self.pairs_used,
            self.pairs_rejected.len(),
            self.baseline_metres,
            self.baseline_deviation_metres,
            self.rotation_degrees,
            self.square_edge_mean_metres,
            self.square_edge_rms_error_metres
        );
        for (name, camera) in [("left", &self.left), ("right", &self.right)] {
            let ([fx, fy], [cx, cy]) = (camera.focal_px, camera.principal_px);
            let ([dfx, dfy], [dcx, dcy]) =
                (camera.focal_deviation_px, camera.principal_deviation_px);
            table += &format!(
                "{name:<10} focal {fx:.2} ± {dfx:.2}, {fy:.2} ± {dfy:.2} px; \
                 principal point {cx:.2} ± {dcx:.2}, {cy:.2} ± {dcy:.2} px\n"
            );
        }
        for rejected in &self.pairs_rejected {
            let Rejected {
                left,
                right,
                reason,
            } = rejected;
            table += &format!("rejected   {left} and {right}: {reason}\n");
        }
        table
    }
}
