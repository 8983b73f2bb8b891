//! `nullcone camera convert`: cameras in another format.

use std::path::PathBuf;

use anyhow::{Context as _, Result, anyhow, bail};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use ga_camera::format::{self, CameraFile, CameraSummary, Encoded, encode_files};
use serde::Serialize;

use crate::camera_file::{LensChoice, about, warn_of_unit};
use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::picture_file::picture_size;

/// Write cameras in another format.
///
/// The contents of IN tell its format; docs/stereo.md lists all. That of the output is the one of
/// --format, or of the ending: .yml OpenCV's YAML, .xml its XML, .json JSON of a camera or of
/// views, .toml that of aniposelib and Pose2Sim, .txt KITTI's calib.txt. `colmap` writes a folder.
///
/// Warnings say what the format cannot hold and what is left out. What would make another camera of
/// it, such as a fisheye in KITTI's format, is an error. --json prints {"from": …, "format": …,
/// "cameras": [{"name": …, "focal_px": […], …}], "files": […], "warnings": […]}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The file of cameras, or the folder of a model of COLMAP.
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// The file to be written.
    #[arg(long, value_name = "OUT")]
    out: PathBuf,
    /// The format of the output.
    #[arg(long, value_name = "FORMAT", value_parser = written())]
    format: Option<format::Format>,
    /// Write this camera alone, by its name or its number from 0; given twice, these two.
    #[arg(long = "camera", value_name = "NAME", action = clap::ArgAction::Append)]
    cameras: Vec<String>,
    /// The size of the pictures, such as 1241x376, for a file that does not state it.
    #[arg(long, value_name = "WxH", value_parser = picture_size)]
    size: Option<[usize; 2]>,
    #[command(flatten)]
    lens: LensChoice,
}

/// The names of the formats that are written.
fn written() -> impl TypedValueParser<Value = format::Format> {
    let formats = format::Format::ALL.into_iter();
    let written = formats.filter(|format| format.is_written());
    let words = written.map(format::Format::word);
    PossibleValuesParser::new(words.collect::<Vec<_>>())
        .map(|word| format::Format::named(&word).unwrap_or(format::Format::OpenCv))
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    from: &'static str,
    format: &'static str,
    cameras: Vec<CameraSummary>,
    files: Vec<String>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let (input, out) = (&self.input, &self.out);
        let mut files = context.files([input])?;
        let format = format::Format::for_path(self.format, out);
        let format = format.with_context(|| {
            format!(
                "--out {}: its ending is of no format: give --format",
                out.display()
            )
        })?;
        match format.names_in_folder() {
            Some(names) => files.write_folder("--out", out, names)?,
            None => _ = files.write("--out", out, &[Format::Camera(format)])?,
        }
        let (from, file) = self.lens.read_with_format(input)?;
        let mut file = file
            .choose(&self.cameras)
            .map_err(|error| about(input, error))?;
        self.set_sizes(&mut file)?;
        let cameras = file.cameras.iter().map(CameraSummary::new);
        let cameras = cameras.collect::<Result<Vec<_>, _>>();
        let cameras = cameras.map_err(|error| about(input, error))?;
        if format.states_unit() && file.cameras.iter().any(|camera| camera.pose.is_some()) {
            warn_of_unit(from, input);
        }
        let encoded = encode_files(out, format, &file);
        let Encoded { files, omissions } = encoded.map_err(|error| match error {
            format::CameraFileError::TooMany { .. } => anyhow!("{error} with --camera NAME"),
            format::CameraFileError::NoSize { .. } => {
                anyhow!("{}: {error}: --size gives them", input.display())
            }
            error => about(input, error),
        })?;
        context.outputs().write_all(&files)?;
        let omissions = omissions.into_iter().map(|omission| Warning {
            what: Some(omission.what),
            count: Some(omission.count),
            ..Warning::new(
                "omission",
                format!("{omission}: {} does not hold them", format.name()),
            )
        });
        Ok(Report {
            from: from.word(),
            format: format.word(),
            cameras,
            files: files
                .iter()
                .map(|(path, _)| path.display().to_string())
                .collect(),
            warnings: omissions.collect(),
        })
    }
}

impl Arguments {
    fn set_sizes(&self, file: &mut CameraFile) -> Result<()> {
        let Some(asked) = self.size else {
            return Ok(());
        };
        for camera in &mut file.cameras {
            if let Some([width, height]) = camera.size.filter(|stated| *stated != asked) {
                bail!(
                    "{}: the camera {:?} has pictures of {width} x {height} pixels: --size is for \
                     files that do not state it",
                    self.input.display(),
                    camera.name
                );
            }
            camera.size = Some(asked);
        }
        Ok(())
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let mut text = format!(
            "{} to {}: {}\n",
            self.from,
            self.format,
            self.files.join(", ")
        );
        for camera in &self.cameras {
            let ([fx, fy], [cx, cy]) = (camera.focal_px, camera.principal_px);
            text += &format!(
                "{}: focal lengths {fx:.3}, {fy:.3} px, principal point {cx:.3}, {cy:.3} px, {}\n",
                camera.name, camera.lens
            );
        }
        text
    }
}
