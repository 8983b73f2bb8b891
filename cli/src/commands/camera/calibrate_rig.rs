//! `nullcone camera calibrate-rig`: any number of cameras from pictures of a board.

use std::path::PathBuf;

use anyhow::{Context as _, Result, bail, ensure};
use ga_camera::format::{CameraFile, Encoded, Format, encode_files};
use ga_files::frames;
use ga_vision::calibration::{
    BoardRig, CameraParameters, LensTerms, RejectedView, RigCameraSummary,
};
use serde::Serialize;

use crate::board::BoardArguments;
use crate::commands::stereo::views;
use crate::files::expanded;
use crate::format;
use crate::frame::{self, Check, Command, Context, Verdict, Warning, command_line};

/// The formats of any number of cameras with poses, which an ending tells.
const FORMATS: [Format; 2] = [Format::Anipose, Format::Json];

/// Calibrate the cameras of a rig, of any number and arrangement.
///
/// --views is given once for each camera. Pictures whose names have the same numbers are of one
/// moment; numbers that all names of a camera share do not count. No board needs to be seen by all
/// cameras: boards that two see at once must join them all, one with the next, and each camera
/// needs three. The file has all cameras, with their poses in the frame of the first one; `stereo
/// rectify` and `reconstruct` take two of them with --view. For instance
///
///   nullcone camera calibrate-rig --board 9x6 --square 0.025 --views 'a/*.png' --views 'b/*.png'
///     --views 'c/*.png' --out rig.toml --json
///
/// prints {"rms_px": …, "cameras": [{"name": "cam0", "boards": …, "rms_px": …, "lens": …,
/// "camera": {"focal_px": […], …}, "centre_metres": […], "distance_metres": …,
/// "distance_deviation_metres": …, "rotation_degrees": …}, …], "common_boards": [[…], …],
/// "frames_used": …, "rejected": [{"picture": …, "reason": …}, …]}. common_boards counts the boards
/// that two cameras see at once.
///
/// The verdict is good where at least 10 boards of each camera were used and their rms_px is at
/// most 1; else it is doubtful, and --json has the reasons as "warnings".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    board: BoardArguments,
    /// The pictures of one camera: a name, or a pattern with `*`, `?` or `[abc]`; once for each.
    #[arg(long, value_name = "GLOB", required = true, action = clap::ArgAction::Append)]
    views: Vec<String>,
    /// The names of the cameras, in the order of --views; without them cam0, cam1 and so on.
    #[arg(long = "name", value_name = "NAME", action = clap::ArgAction::Append)]
    names: Vec<String>,
    /// Write the cameras: .toml as aniposelib and Pose2Sim, or .json.
    #[arg(long, value_name = "RIG.toml")]
    out: PathBuf,
    /// The lens of all cameras: pinhole, radial-tangential, fisheye, or terms such as k1,k2,p1,p2;
    /// without it, each camera is told from a fisheye.
    #[arg(long, value_name = "LENS", value_parser = LensTerms::named)]
    lens: Option<LensTerms>,
    #[command(flatten)]
    check: Check,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    next: Option<String>,
    #[serde(skip)]
    warnings: Vec<Warning>,
    rms_px: f64,
    cameras: Vec<RigCameraSummary>,
    common_boards: Vec<Vec<usize>>,
    frames_used: usize,
    rejected: Vec<RejectedView>,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let board = self.board.board()?;
        let names = self.names()?;
        let lists = self.views.iter().map(|views| expanded("--views", &[views]));
        let lists = lists.collect::<Result<Vec<Vec<PathBuf>>>>()?;
        let mut files = context.files(lists.iter().flatten())?;
        let format = files.write("--out", &self.out, &FORMATS.map(format::Format::Camera))?;
        let frames = frames(lists).context("--views")?.frames;
        let progress = context.progress(frames.len() as u64 + 1);
        let mut boards = BoardRig::new(board, names);
        for frame in &frames {
            progress.step("looking for the board");
            let read = |path: &Option<PathBuf>| -> Result<Option<_>> {
                let Some(path) = path else { return Ok(None) };
                Ok(Some((
                    path.display().to_string(),
                    views::read::<u16>(path)?,
                )))
            };
            boards.add(frame.iter().map(read).collect::<Result<_>>()?)?;
        }
        progress.step("calibrating");
        let found = boards.calibrate(self.lens)?;
        let file = found.file();
        let format = FORMATS
            .into_iter()
            .find(|known| format == format::Format::Camera(*known));
        let Encoded { files, .. } = encode_files(&self.out, format.unwrap_or(FORMATS[0]), &file)
            .with_context(|| self.out.display().to_string())?;
        context.outputs().write_all(&files)?;
        drop(progress);

        let doubts = found.doubts().into_iter();
        let doubts =
            doubts.map(|(camera, doubt)| Warning::new(doubt.kind(), format!("{camera}: {doubt}")));
        Ok(Report {
            next: self.next(&frames, &file),
            warnings: doubts.collect(),
            rms_px: found.rig.rms,
            cameras: found.summary(),
            common_boards: found.common_boards.clone(),
            frames_used: found.rig.used.len(),
            rejected: found.rejected,
        })
    }
}

impl Arguments {
    /// A name for each camera.
    fn names(&self) -> Result<Vec<String>> {
        let count = self.views.len();
        ensure!(
            count > 1,
            "--views is given once, and a rig has two cameras or more"
        );
        if self.names.is_empty() {
            return Ok((0..count).map(|camera| format!("cam{camera}")).collect());
        }
        ensure!(
            self.names.len() == count,
            "--name is given {} times, and --views {count} times",
            self.names.len()
        );
        let mut names = self.names.clone();
        names.sort();
        let same = names.windows(2).find(|pair| pair[0] == pair[1]);
        match same {
            Some(pair) => bail!("--name {} is given twice", pair[0]),
            None => Ok(self.names.clone()),
        }
    }

    /// The rectification of the first frame that two cameras have.
    fn next(&self, frames: &[Vec<Option<PathBuf>>], file: &CameraFile) -> Option<String> {
        let both = frames.iter().find_map(|frame| {
            let mut pictures = frame.iter().enumerate();
            let mut next = || pictures.find_map(|(camera, path)| Some((camera, path.as_ref()?)));
            Some([next()?, next()?])
        });
        let [(left, left_path), (right, right_path)] = both?;
        Some(command_line([
            "nullcone stereo rectify".as_ref(),
            left_path.as_os_str(),
            right_path.as_os_str(),
            "--rig".as_ref(),
            self.out.as_os_str(),
            "--view".as_ref(),
            file.cameras[left].name.as_ref(),
            "--view".as_ref(),
            file.cameras[right].name.as_ref(),
            "--out".as_ref(),
            "rectified".as_ref(),
        ]))
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
        self.next.clone()
    }

    fn text(&self) -> String {
        let mut table = format!(
            "rms        {:.4} px\nframes     {} used\n",
            self.rms_px, self.frames_used
        );
        for camera in &self.cameras {
            let [x, y, z] = camera.centre_metres;
            let CameraParameters {
                focal: [fx, fy],
                principal: [cx, cy],
                ..
            } = camera.camera;
            table += &format!(
                "{:<10} {} boards, {:.4} px; focal {fx:.2}, {fy:.2} px; principal point {cx:.2}, \
                 {cy:.2} px; {}\n           at {x:.4}, {y:.4}, {z:.4} m, {:.6} ± {:.6} m from the \
                 first, rotated by {:.2}°\n",
                camera.name,
                camera.boards,
                camera.rms_px,
                camera.lens,
                camera.distance_metres,
                camera.distance_deviation_metres,
                camera.rotation_degrees
            );
        }
        for RejectedView { picture, reason } in &self.rejected {
            table += &format!("rejected   {picture}: {reason}\n");
        }
        table
    }
}
