//! `nullcone stereo rectify`: views in which the images of a point are in one row.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_image::png;
use ga_runtime::cga3::Motor;
use ga_vision::rectification::{Rectangle, Rectification, RectificationOptions};
use serde::Serialize;

use super::pixels;
use crate::camera_file::ChosenPair;
use crate::frame::{self, Command, Context, command_line};
use crate::output::{self, File};

const LEFT: &str = "left.png";
const RIGHT: &str = "right.png";
/// The name of the file with the rectified cameras.
pub(super) const RIG: &str = "rig.yml";

/// Rectify two views, so that the images of a point are in the same row of both.
///
/// The rig is a file of two cameras of any format, such as YAML with OpenCV's names M1, D1, M2, D2,
/// R and T, as `nullcone stereo calibrate` writes it. The folder gets left.png, right.png and
/// rig.yml, which holds the rectified cameras (M1, M2, R, T) and OpenCV's R1, R2, P1, P2 and Q.
/// What no camera saw is black.
///
/// For instance
///
///   nullcone stereo rectify left.jpg right.jpg --rig rig.yml --alpha 0 --out rectified --json
///
/// prints {"width_px": …, "height_px": …, "focal_px": …, "left_principal_px": […],
/// "right_principal_px": […], "disparity_offset_px": …, "baseline_metres": …,
/// "left_rotation_degrees": …, "right_rotation_degrees": …, "left_valid_px": {…},
/// "right_valid_px": {…}}. The depth at a disparity d is
/// focal_px · baseline_metres/(d + disparity_offset_px).
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The left view.
    #[arg(value_name = "LEFT")]
    left: PathBuf,
    /// The right view.
    #[arg(value_name = "RIGHT")]
    right: PathBuf,
    /// The two cameras and the motion between them.
    #[arg(long, value_name = "FILE")]
    rig: PathBuf,
    #[command(flatten)]
    chosen: ChosenPair,
    /// The folder for the rectified views and cameras.
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
    /// From 0, where all pixels of the results were seen, to 1, where the results hold all pixels
    /// of the views; by default the focal length is kept.
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    alpha: Option<f64>,
    /// Centre each view for itself, so that what is infinitely far away has a disparity other than
    /// zero.
    #[arg(long)]
    separate_centres: bool,
    /// The size of the results, such as 800x600; by default that of the views.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = pixels::size)]
    size: Option<[usize; 2]>,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    folder: PathBuf,
    width_px: usize,
    height_px: usize,
    focal_px: f64,
    left_principal_px: [f64; 2],
    right_principal_px: [f64; 2],
    disparity_offset_px: f64,
    baseline_metres: f64,
    left_rotation_degrees: f64,
    right_rotation_degrees: f64,
    left_valid_px: Valid,
    right_valid_px: Valid,
}

/// A part of a picture in which every pixel was seen.
#[derive(Serialize)]
struct Valid {
    left: usize,
    top: usize,
    width: usize,
    height: usize,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let inputs = [&arguments.left, &arguments.right, &arguments.rig];
        context
            .files(inputs)?
            .write_folder("--out", &arguments.out, [LEFT, RIGHT, RIG])?;
        let progress = context.progress(4);
        progress.step("reading the views");
        let file = arguments.chosen.read(&arguments.rig)?;
        let left = ga_image::file::read(&arguments.left)?;
        let right = ga_image::file::read(&arguments.right)?;
        let size = [left.width(), left.height()];
        ensure!(
            size == [right.width(), right.height()],
            "the views differ in size: {} has {} × {} pixels and {} has {} × {}",
            arguments.left.display(),
            size[0],
            size[1],
            arguments.right.display(),
            right.width(),
            right.height()
        );
        file.check_sizes(size, [&arguments.left, &arguments.right], &arguments.rig)?;

        progress.step("rectifying");
        let options = RectificationOptions {
            zero_disparity: !arguments.separate_centres,
            alpha: arguments.alpha,
            size: arguments.size,
        };
        let found = Rectification::new(&file.rig, size, options)
            .with_context(|| format!("{} cannot be rectified", arguments.rig.display()))?;
        let new_left = left.view().warped(&found.left_map())?;
        let new_right = right.view().warped(&found.right_map())?;

        progress.step("encoding");
        let files = [
            File {
                name: LEFT,
                contents: png::encode(&new_left)?,
            },
            File {
                name: RIGHT,
                contents: png::encode(&new_right)?,
            },
            File {
                name: RIG,
                contents: found.storage()?.encode().into_bytes(),
            },
        ];
        progress.step("writing");
        output::write_all(&arguments.out, &files)?;
        drop(progress);

        Ok(Report::new(&found, &arguments.out))
    }
}

impl Report {
    fn new(found: &Rectification, folder: &Path) -> Self {
        let degrees = |motor: Motor<f64>| motor.rotor().to_axis_angle().1.to_degrees();
        let valid = |part: Rectangle| Valid {
            left: part.left,
            top: part.top,
            width: part.width,
            height: part.height,
        };
        Self {
            folder: folder.to_path_buf(),
            width_px: found.size[0],
            height_px: found.size[1],
            focal_px: found.rig.left().focal()[0],
            left_principal_px: found.rig.left().principal(),
            right_principal_px: found.rig.right().principal(),
            disparity_offset_px: found.rig.disparity_offset(),
            baseline_metres: found.rig.baseline(),
            left_rotation_degrees: degrees(found.left.motor),
            right_rotation_degrees: degrees(found.right.motor),
            left_valid_px: valid(found.valid[0]),
            right_valid_px: valid(found.valid[1]),
        }
    }
}

impl frame::Report for Report {
    /// Disparities are looked for in a quarter of the width, and are mostly less.
    fn next(&self) -> Option<String> {
        let range = self.width_px.div_ceil(4).to_string();
        let [left, right] = [LEFT, RIGHT].map(|name| self.folder.join(name));
        Some(command_line([
            "nullcone stereo match".as_ref(),
            left.as_os_str(),
            right.as_os_str(),
            "--max-disparity".as_ref(),
            range.as_ref(),
            "--out".as_ref(),
            self.folder.join("disparities.pfm").as_os_str(),
        ]))
    }

    fn text(&self) -> String {
        format!(
            "{} × {} pixels, focal length {:.3} px, baseline {:.6} m\n\
             principal points {:.3}, {:.3} px and {:.3}, {:.3} px\n\
             rotated by {:.3}° and {:.3}°\n",
            self.width_px,
            self.height_px,
            self.focal_px,
            self.baseline_metres,
            self.left_principal_px[0],
            self.left_principal_px[1],
            self.right_principal_px[0],
            self.right_principal_px[1],
            self.left_rotation_degrees,
            self.right_rotation_degrees
        )
    }
}
