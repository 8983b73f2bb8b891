//! `nullcone stereo rectify`: views in which the images of a point are in one row.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_image::png;
use ga_vision::rectification::{Rectification, RectificationOptions, RectificationSummary};
use serde::Serialize;

use super::views::ViewPair;
use crate::camera_file::ChosenPair;
use crate::frame::{self, Command, Context, command_line};
use crate::picture_file::picture_size;

const LEFT: &str = "left.png";
const RIGHT: &str = "right.png";
/// The name of the file with the rectified cameras.
pub(super) const RIG: &str = "rig.yml";

/// Rectify two views, so that the images of a point are in the same row of both.
///
/// The rig is a file of two cameras of any format, such as YAML with OpenCV's names M1, D1, M2, D2,
/// R and T, as `nullcone stereo calibrate` writes it. The folder gets left.png, right.png and
/// rig.yml, which holds the rectified cameras (M1, M2, R, T) and OpenCV's R1, R2, P1, P2 and Q.
/// What no camera saw is black. Where one camera is above the other, both views are put on their
/// side, so that the images of a point are in one row also then; a camera that stands on its side
/// or on its head is rolled like the other one.
///
/// For instance
///
///   nullcone stereo rectify left.jpg right.jpg --rig rig.yml --alpha 0 --out rectified --json
///
/// prints {"width_px": …, "height_px": …, "focal_px": …, "left_principal_px": […],
/// "right_principal_px": […], "disparity_offset_px": …, "baseline_metres": …,
/// "left_rotation_degrees": …, "right_rotation_degrees": …, "left_roll_degrees": …,
/// "right_roll_degrees": …, "left_valid_px": {…}, "right_valid_px": {…}}. The depth at a disparity
/// d is focal_px · baseline_metres/(d + disparity_offset_px).
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    views: ViewPair,
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
    #[arg(long, value_name = "A")]
    alpha: Option<f64>,
    /// Centre each view for itself, so that what is infinitely far away has a disparity other than
    /// zero.
    #[arg(long)]
    separate_centres: bool,
    /// The size of the results, such as 800x600; by default that of the left view, on its side
    /// where it is put so.
    #[arg(long, value_name = "WxH", value_parser = picture_size)]
    size: Option<[usize; 2]>,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    folder: PathBuf,
    #[serde(flatten)]
    found: RectificationSummary,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let inputs = self.views.paths().into_iter().chain([&*self.rig]);
        context
            .files(inputs)?
            .write_folder("--out", &self.out, [LEFT, RIGHT, RIG])?;
        let progress = context.progress(4);
        progress.step("reading the views");
        let file = self.chosen.read(&self.rig)?;
        let [left, right] = self.views.read()?;
        let size = [left.width(), left.height()];
        file.check_sizes(size, self.views.paths(), &self.rig)?;

        progress.step("rectifying");
        let options = RectificationOptions {
            zero_disparity: !self.separate_centres,
            alpha: self.alpha,
            size: self.size,
        };
        let found = Rectification::new(&file.rig, size, options)
            .with_context(|| format!("{} cannot be rectified", self.rig.display()))?;
        let new_left = left.view().warped(&found.left_map())?;
        let new_right = right.view().warped(&found.right_map())?;

        progress.step("encoding");
        let files = [
            (LEFT, png::encode(&new_left)?),
            (RIGHT, png::encode(&new_right)?),
            (RIG, found.storage()?.encode().into_bytes()),
        ];
        progress.step("writing");
        let files = files.map(|(name, contents)| (self.out.join(name), contents));
        context.outputs().write_all(&files)?;
        drop(progress);

        Ok(Report {
            folder: self.out.clone(),
            found: found.summary(),
        })
    }
}

impl frame::Report for Report {
    /// Disparities are looked for in a quarter of the width, and are mostly less.
    fn next(&self) -> Option<String> {
        let range = self.found.width.div_ceil(4).to_string();
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
        let found = &self.found;
        let ([left_u, left_v], [right_u, right_v]) = (found.left_principal, found.right_principal);
        let rolled = match [found.left_roll_degrees, found.right_roll_degrees] {
            [0, 0] => String::new(),
            [left, right] => format!(", of which rolls of {left}° and {right}°, clockwise"),
        };
        format!(
            "{} × {} pixels, focal length {:.3} px, baseline {:.6} m\n\
             principal points {left_u:.3}, {left_v:.3} px and {right_u:.3}, {right_v:.3} px\n\
             rotated by {:.3}° and {:.3}°{rolled}\n",
            found.width,
            found.height,
            found.focal,
            found.baseline,
            found.left_rotation_degrees,
            found.right_rotation_degrees
        )
    }
}
