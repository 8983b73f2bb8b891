//! `nullcone camera calibrate`: one camera from pictures of a board.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_camera::format::{CameraFile, Encoded, Format, NamedCamera, encode_files};
use ga_draw::document::Page;
use ga_files::natural_order;
use ga_vision::calibration::{
    BoardViews, CameraOfBoards, CameraParameters, LensTerms, Parameter, RejectedView, TriedLens,
    ViewResidual,
};
use serde::Serialize;

use crate::board::BoardArguments;
use crate::commands::stereo::views;
use crate::files::expanded;
use crate::format;
use crate::frame::{self, Check, Command, Context, Verdict, Warning, command_line};

/// Calibrate one camera from pictures of a board.
///
/// --pattern says what is on the board. Of boards with tags a picture may show any part with six
/// points, four of them around a square or a tag; the border of a picture may cut a chessboard,
/// down to half of its corners; of circles all must be seen. Other pictures are left out.
///
/// The lens is radial-tangential (k1, k2, p1, p2, k3), or a fisheye where that fits decisively
/// better, by Schwarz's criterion; --lens chooses it. Deviations are standard deviations of the
/// parameters, by what remains of the corners. --report writes a page with the residuals over the
/// picture, the parts of it that have corners, and the worst boards. For instance
///
///   nullcone camera calibrate 'left*.jpg' --board 9x6 --square 0.025 --out camera.yml --json
///
/// prints {"rms_px": …, "lens": …, "camera": {"focal_px": […], "focal_deviation_px": […], …},
/// "parameters": [{"name": "fx", "value": …, "deviation": …}, …], "boards_used": …,
/// "boards_rejected": […], "coverage_percent": …, "views": [{"picture": …, "points": …,
/// "rms_px": …}, …], "lenses": [{"lens": …, "rms_px": …, "schwarz": …}, …]}, the worst views first.
///
/// The verdict is good where at least 10 boards were used, rms_px is at most 1, corners are in half
/// of the parts of the picture, no board has three times the usual residual, and no other lens fits
/// decisively better; else it is doubtful, and --json has the reasons as "warnings".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The pictures: names, or patterns with `*`, `?` or `[abc]`; `**` stands for any folders.
    #[arg(value_name = "FILE or GLOB", required = true, num_args = 1..)]
    pictures: Vec<String>,
    #[command(flatten)]
    board: BoardArguments,
    /// Write the camera; the ending says the format, as for nullcone camera convert.
    #[arg(long, value_name = "CAMERA.yml")]
    out: PathBuf,
    /// The lens: pinhole, radial-tangential, fisheye, or terms such as k1,k2,p1,p2,k3,k4,k5,k6.
    #[arg(long, value_name = "LENS", value_parser = LensTerms::named)]
    lens: Option<LensTerms>,
    #[command(flatten)]
    check: Check,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    next: String,
    #[serde(skip)]
    warnings: Vec<Warning>,
    #[serde(skip)]
    found: CameraOfBoards,
    rms_px: f64,
    lens: String,
    camera: CameraParameters,
    parameters: Vec<Parameter>,
    boards_used: usize,
    boards_rejected: Vec<RejectedView>,
    coverage_percent: f64,
    views: Vec<ViewResidual>,
    lenses: Vec<TriedLens>,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let board = self.board.board()?;
        let mut pictures = expanded("pictures", &self.pictures)?;
        natural_order(&mut pictures);
        pictures.dedup();
        let format = Format::of_path(&self.out).unwrap_or(Format::OpenCv);
        let mut files = context.files(&pictures)?;
        files.write("--out", &self.out, &[format::Format::Camera(format)])?;
        let progress = context.progress(pictures.len() as u64 + 1);
        let mut boards = BoardViews::new(board);
        for path in &pictures {
            progress.step("looking for the board");
            boards.add(&views::read::<u16>(path)?, path.display().to_string())?;
        }
        progress.step("calibrating");
        let found = boards.calibrate(self.lens)?;
        let camera = NamedCamera::new("camera", found.camera.intrinsics);
        let file = CameraFile::new(vec![camera.with_size(Some(found.size))]);
        let Encoded { files, .. } = encode_files(&self.out, format, &file)
            .with_context(|| self.out.display().to_string())?;
        context.outputs().write_all(&files)?;
        drop(progress);

        let doubts = found.doubts().into_iter();
        let doubts = doubts.map(|doubt| Warning::new(doubt.kind(), doubt));
        Ok(Report {
            next: command_line([
                "nullcone stereo undistort".as_ref(),
                pictures[0].as_os_str(),
                "--camera".as_ref(),
                self.out.as_os_str(),
                "--out".as_ref(),
                "straight.png".as_ref(),
            ]),
            warnings: doubts.collect(),
            rms_px: found.camera.rms,
            lens: found.camera.intrinsics.lens().model().name().to_owned(),
            camera: CameraParameters::new(&found.camera.intrinsics, &found.camera.deviations),
            parameters: found.parameters(),
            boards_used: found.views.len(),
            boards_rejected: found.rejected.clone(),
            coverage_percent: found.coverage_percent(),
            views: found.views.clone(),
            lenses: found.tried.clone(),
            found,
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

    fn page(&self) -> Option<Page> {
        Some(self.found.page())
    }

    fn text(&self) -> String {
        let mut table = format!(
            "rms        {:.4} px\nboards     {} used, {} rejected\ncoverage   {:.0} %\nlens       {}\n",
            self.rms_px,
            self.boards_used,
            self.boards_rejected.len(),
            self.coverage_percent,
            self.lens
        );
        for Parameter {
            name,
            value,
            deviation,
        } in &self.parameters
        {
            table += &format!("{name:<10} {value:.6} ± {deviation:.6}\n");
        }
        for RejectedView { picture, reason } in &self.boards_rejected {
            table += &format!("rejected   {picture}: {reason}\n");
        }
        table
    }
}
