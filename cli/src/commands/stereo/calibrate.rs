//! `nullcone stereo calibrate`: a rig from pictures of a board.

use std::mem;
use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_camera::Intrinsics;
use ga_camera::format::rig;
use ga_files::frames;
use ga_image::png;
use ga_vision::board::Board;
use ga_vision::calibration::{
    BoardPairs, CameraOptions, JointIntrinsics, LensTerms, PairNames, RejectedPair, Residuals,
    RigSummary, Start, StereoOptions,
};
use ga_vision::chessboard::pair_picture;
use serde::Serialize;

use super::views;
use crate::board::BoardArguments;
use crate::camera_file::{LensChoice, about};
use crate::files::expanded;
use crate::format::Format;
use crate::frame::{
    self, Check, Command, Context, Progress, Verdict, Warning, command_line, keep_for_failure,
};

/// Calibrate a stereo rig from pairs of pictures of a board.
///
/// Views whose names have the same numbers are a pair, as left7.jpg and right07.jpg; numbers that
/// all names of a camera share, such as that of the camera, do not count. Where the numbers have
/// little in common, as those of times, views are paired in the order of their names. A name of a
/// file counts before a pattern; the program itself matches patterns, or the shell does. Views
/// without a partner are named in a warning. --pattern says what is on the board. All of its points
/// must be in both views, as which part of a plain board a picture shows cannot be told; of boards
/// with tags, both views must show six of the same points or more, with four around a square or a
/// tag among them. Pairs in which it is not found, or that do not agree with the others, are left
/// out. For instance
///
///   nullcone stereo calibrate --board 9x6 --square 0.025 --left 'left*.jpg' --right 'right*.jpg'
///     --out rig.yml --json
///
/// prints {"rms_px": …, "rms_left_px": …, "rms_right_px": …, "pairs_used": …,
/// "pairs_rejected": […], "baseline_metres": …, …}. rms_px is the root mean square distance of all
/// corners from the projections of their places on the boards, as OpenCV's stereoCalibrate returns
/// it.
///
/// The verdict is good where at least 10 pairs were used, rms_px is at most 1, and all views have a
/// partner; else it is doubtful, and --json has the reasons as "warnings".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    board: BoardArguments,
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
    #[command(flatten)]
    lens: LensChoice,
    /// Use all pairs with a board, also those that do not agree with the others.
    #[arg(long)]
    keep_outliers: bool,
    /// Write pictures of the corners that were found into a folder.
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    #[command(flatten)]
    check: Check,
}

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
    #[serde(flatten)]
    residuals: Residuals,
    /// The pairs that were made of the files.
    pairs: Vec<PairNames>,
    pairs_used: usize,
    pairs_rejected: Vec<RejectedPair>,
    #[serde(flatten)]
    rig: RigSummary,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let board = self.board.board()?;
        let options = self.options()?;
        let Pairs { files, left_over } = Pairs::of(&self.left, &self.right)?;
        self.check_outputs(context, &files)?;
        keep_for_failure(&left_over);
        let progress = context.progress(files.len() as u64 + 1);
        let (boards, pictures) = self.find_boards(board, &files, &progress)?;
        progress.step("calibrating");
        let found = boards.calibrate(&options)?;
        let contents = rig::encode(&found.stereo.rig, Some(found.size));
        let contents = contents.with_context(|| self.out.display().to_string())?;
        context.outputs().write(&self.out, contents)?;
        context.outputs().write_all(&pictures)?;
        drop(progress);

        let doubts = found.doubts().into_iter();
        let doubts = doubts.map(|doubt| Warning::new(doubt.kind(), doubt));
        let [left, right] = &files[found.used[0]];
        Ok(Report {
            next: command_line([
                "nullcone stereo rectify".as_ref(),
                left.as_os_str(),
                right.as_os_str(),
                "--rig".as_ref(),
                self.out.as_os_str(),
                "--out".as_ref(),
                "rectified".as_ref(),
            ]),
            warnings: doubts.chain(left_over).collect(),
            residuals: found.residuals(),
            rig: found.summary(),
            pairs_used: found.used.len(),
            pairs: found.pairs,
            pairs_rejected: found.rejected,
        })
    }
}

impl Arguments {
    fn options(&self) -> Result<StereoOptions> {
        let read = |path: &Option<PathBuf>, side: usize| -> Result<Option<Intrinsics>> {
            let Some(path) = path else { return Ok(None) };
            let intrinsics = self.lens.read_side(path, side)?.intrinsics();
            Ok(Some(intrinsics.map_err(|error| about(path, error))?))
        };
        let cameras = [read(&self.left_camera, 0)?, read(&self.right_camera, 1)?];
        if cameras.iter().all(Option::is_none) {
            let reason = "it is about the files of --left-camera and --right-camera";
            self.lens.refuse(reason)?;
        }
        let is_known = self.intrinsics == IntrinsicsChoice::Known;
        ensure!(
            !is_known || cameras.iter().all(Option::is_some),
            "--intrinsics known needs --left-camera and --right-camera"
        );
        let camera = |camera: Option<Intrinsics>| CameraOptions {
            start: match camera {
                Some(intrinsics) if is_known => Start::Fixed(intrinsics),
                Some(intrinsics) => Start::Guess(intrinsics),
                None => Start::Boards,
            },
            terms: self.distortion,
        };
        let ratio = StereoOptions::default().outlier_ratio;
        Ok(StereoOptions {
            cameras: cameras.map(camera),
            joint: match self.intrinsics {
                IntrinsicsChoice::Joint => JointIntrinsics::Free,
                IntrinsicsChoice::Separate | IntrinsicsChoice::Known => JointIntrinsics::Fixed,
            },
            outlier_ratio: ratio.filter(|_| !self.keep_outliers),
        })
    }

    /// Fails where the results could not be written, or would replace what is read.
    fn check_outputs(&self, context: &Context, pairs: &[[PathBuf; 2]]) -> Result<()> {
        let cameras = self.left_camera.iter().chain(&self.right_camera);
        let mut files = context.files(pairs.as_flattened().iter().chain(cameras))?;
        files.write("--out", &self.out, &[Format::Yaml])?;
        if let Some(folder) = &self.pictures {
            files.write_folder("--pictures", folder, (0..pairs.len()).map(corners_name))?;
        }
        Ok(())
    }

    /// Looks for the board in all views, and draws the corners where pictures of them are wanted:
    /// their paths and contents.
    fn find_boards(
        &self,
        board: Board,
        files: &[[PathBuf; 2]],
        progress: &Progress,
    ) -> Result<Found> {
        let mut boards = BoardPairs::new(board);
        let mut pictures = Vec::new();
        for (index, [left, right]) in files.iter().enumerate() {
            progress.step("looking for the board");
            let views = views::read_pair::<u16>(left, right)?;
            let names = PairNames {
                left: left.display().to_string(),
                right: right.display().to_string(),
            };
            if let (Some(found), Some(folder)) = (boards.add(&views, names)?, &self.pictures) {
                let picture = png::encode(&pair_picture(&views, found))?;
                pictures.push((folder.join(corners_name(index)), picture));
            }
        }
        Ok((boards, pictures))
    }
}

/// Boards, and files with pictures of them.
type Found = (BoardPairs, Vec<(PathBuf, Vec<u8>)>);

/// The name of the picture of a pair.
fn corners_name(index: usize) -> String {
    format!("corners{:03}.png", index + 1)
}

/// The files of the left and the right views.
struct Pairs {
    files: Vec<[PathBuf; 2]>,
    /// Those without a partner, in a warning.
    left_over: Vec<Warning>,
}

impl Pairs {
    fn of(left: &[String], right: &[String]) -> Result<Self> {
        let lists = vec![expanded("--left", left)?, expanded("--right", right)?];
        let found = frames(lists).context("--left and --right")?;
        let (mut files, mut alone) = (Vec::new(), Vec::new());
        for mut frame in found.frames {
            match frame.as_mut_slice() {
                [Some(left), Some(right)] => files.push([mem::take(left), mem::take(right)]),
                others => alone.extend(others.iter().flatten().map(|p| p.display().to_string())),
            }
        }
        let warning = |names: &[String]| {
            let text = format!("views without a partner are left out: {}", names.join(", "));
            Warning::new("no_partner", text)
        };
        Ok(Self {
            files,
            left_over: (!alone.is_empty())
                .then(|| warning(&alone))
                .into_iter()
                .collect(),
        })
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
        let (residuals, rig) = (&self.residuals, &self.rig);
        let mut table = format!(
            "rms        {:.4} px (left {:.4}, right {:.4})\npairs      {} used, {} rejected\n\
             baseline   {:.6} m ± {:.6}\nrotation   {:.4}°\n\
             edges      {:.6} m on average, ± {:.6}\n",
            residuals.both,
            residuals.left,
            residuals.right,
            self.pairs_used,
            self.pairs_rejected.len(),
            rig.baseline,
            rig.baseline_deviation,
            rig.rotation_degrees,
            rig.square_edge_mean,
            rig.square_edge_rms_error
        );
        for (name, camera) in [("left", &rig.left), ("right", &rig.right)] {
            let ([fx, fy], [cx, cy]) = (camera.focal, camera.principal);
            let ([dfx, dfy], [dcx, dcy]) = (camera.focal_deviation, camera.principal_deviation);
            table += &format!(
                "{name:<10} focal {fx:.2} ± {dfx:.2}, {fy:.2} ± {dfy:.2} px; \
                 principal point {cx:.2} ± {dcx:.2}, {cy:.2} ± {dcy:.2} px\n"
            );
        }
        for RejectedPair { names, reason } in &self.pairs_rejected {
            table += &format!("rejected   {names}: {reason}\n");
        }
        table
    }
}
