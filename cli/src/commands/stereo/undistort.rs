//! `nullcone stereo undistort`: a picture without the distortion of its lens.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_camera::format::{CameraFile, Encoded, Format as CameraFormat, NamedCamera, encode_files};
use ga_image::png;
use ga_vision::rectification::Undistortion;
use serde::Serialize;

use crate::camera_file::{LensChoice, about, warn_of_unit};
use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::picture_file;

/// Remove the distortion of a lens from a picture.
///
/// The camera is that of a file of any format, such as YAML with OpenCV's names camera_matrix and
/// distortion_coefficients, and fisheye_model: 1 for a fisheye lens; --lens says which lens it is
/// where the file does not. What the camera did not see is black.
///
/// For instance
///
///   nullcone stereo undistort left01.jpg --camera left.yml --out straight.png --json
///
/// prints {"width_px": …, "height_px": …, "focal_px": […], "principal_px": […],
/// "unseen_percent": …}, the pinhole camera that would have taken the result and how much of the
/// result is black.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The picture.
    #[arg(value_name = "PICTURE")]
    picture: PathBuf,
    /// The camera.
    #[arg(long, value_name = "FILE")]
    camera: PathBuf,
    /// Which camera of the file, where it has several: its name, or its number from 0.
    #[arg(long, value_name = "NAME")]
    view: Option<String>,
    #[command(flatten)]
    lens: LensChoice,
    /// The result.
    #[arg(long, value_name = "FILE.png")]
    out: PathBuf,
    /// Write the pinhole camera of the result, with the pose of the camera.
    #[arg(long, value_name = "NEW.yml")]
    new_camera: Option<PathBuf>,
    /// From 0, where all pixels of the result were seen, to 1, where it holds all pixels of the
    /// picture; by default focal lengths and principal point are kept.
    #[arg(long, value_name = "A")]
    alpha: Option<f64>,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    width_px: usize,
    height_px: usize,
    focal_px: [f64; 2],
    principal_px: [f64; 2],
    unseen_percent: f64,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let mut files = context.files([&self.picture, &self.camera])?;
        files.write("--out", &self.out, &[Format::Png])?;
        files.write_if_given("--new-camera", self.new_camera.as_ref(), &[Format::Yaml])?;
        let progress = context.progress(3);
        progress.step("reading the picture");
        let (format, file) = self.lens.read_with_format(&self.camera)?;
        let camera = file.one(self.view.as_deref());
        let camera = camera.map_err(|error| about(&self.camera, error))?;
        let intrinsics = camera.intrinsics();
        let intrinsics = intrinsics.map_err(|error| about(&self.camera, error))?;
        let old = picture_file::read(&self.picture)?;
        let size = [old.width(), old.height()];
        camera.check_size(size, &self.picture, &self.camera)?;

        progress.step("removing the distortion");
        let found = Undistortion::new(intrinsics, size, self.alpha)
            .with_context(|| self.picture.display().to_string())?;
        let map = found.map();
        let new = old.view().warped(&map)?;
        let inside = map.inside();
        let unseen = inside.values().iter().filter(|inside| !**inside).count();

        progress.step("writing");
        let mut files = vec![(self.out.clone(), png::encode(&new)?)];
        if let Some(path) = &self.new_camera {
            if camera.pose.is_some() {
                warn_of_unit(format, &self.camera);
            }
            let mut target = NamedCamera::new("camera", found.target).with_size(Some(size));
            target.pose = camera.pose;
            let file = CameraFile::new(vec![target]);
            let Encoded { files: texts, .. } = encode_files(path, CameraFormat::OpenCv, &file)
                .with_context(|| path.display().to_string())?;
            files.extend(
                texts
                    .into_iter()
                    .map(|(path, text)| (path, text.into_bytes())),
            );
        }
        context.outputs().write_all(&files)?;
        drop(progress);

        Ok(Report {
            width_px: size[0],
            height_px: size[1],
            focal_px: found.target.focal(),
            principal_px: found.target.principal(),
            unseen_percent: 100.0 * unseen as f64 / inside.values().len() as f64,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let ([fx, fy], [cx, cy]) = (self.focal_px, self.principal_px);
        format!(
            "{} × {} pixels, {:.2} % unseen\nfocal lengths {fx:.3}, {fy:.3} px\n\
             principal point {cx:.3}, {cy:.3} px\n",
            self.width_px, self.height_px, self.unseen_percent
        )
    }
}
