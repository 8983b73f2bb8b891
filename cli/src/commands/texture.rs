//! `nullcone texture`: a mesh textured from calibrated views.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Result, ensure};
use clap::builder::RangedI64ValueParser;
use ga_camera::format::NamedCamera;
use ga_vision::texture::{self, Options, View, texture_mesh};
use serde::Serialize;

use crate::camera_file::{LensChoice, about};
use crate::files::expanded;
use crate::format::{Format, endings};
use crate::frame::{self, Command, Context, Warning};
use crate::{mesh_file, picture_file};

/// Texture a mesh from pictures whose cameras are known.
///
/// The views are projected into the texture atlas of the mesh, which keeps its texture coordinates
/// if every corner has one; otherwise an atlas is made. Surfaces that other parts hide from a
/// camera get nothing from it, exposures are levelled, views are blended so that no seams are
/// seen, and what no view sees is filled from its surroundings.
///
/// VIEWS.json lists the pictures, by paths relative to it, and their cameras:
///
///   {"views": [
///     {"picture": "front.png",
///      "camera": {"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5},
///      "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 2]},
///     {"picture": "side.jpg", "camera": "side.yml",
///      "quaternion_wxyz": [0, 0.707107, 0, 0.707107], "translation": [0, 0.1, 2]}
///   ]}
///
/// A point p of the mesh is at rotation p + translation in the camera's frame, with x right, y
/// down and z forwards; (0, 0) is the middle of the first pixel. A camera is an object, which may
/// have "distortion" in OpenCV's order and "lens": "fisheye", or the path of OpenCV's YAML or of
/// such an object as JSON. `nullcone render --views DIR` writes pictures and such a file. A file of
/// another format, such as the rig of nullcone stereo calibrate, names no pictures: --pictures
/// does. Its cameras need poses; the world of a rig is the frame of its left camera.
///
/// For instance
///
///   nullcone render statue.glb --turntable 8 --shading unlit --views views --out film.png
///   nullcone texture statue.obj --views views/views.json --out model.glb
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[arg(value_name = "MESH", help = format!("The mesh: {}", mesh_file::read_endings()))]
    mesh: PathBuf,
    /// The cameras, see above; or a folder with them in views.json.
    #[arg(long, value_name = "VIEWS.json")]
    views: PathBuf,
    /// The pictures of the cameras, in their order, where the file names none: names, or patterns
    /// with `*`, `?` or `[abc]`, whose pictures are sorted by the numbers in their names.
    #[arg(long, value_name = "PICTURE or GLOB", num_args = 1..)]
    pictures: Vec<PathBuf>,
    #[command(flatten)]
    lens: LensChoice,
    #[arg(long, value_name = "FILE", help = format!("The textured model: {}", endings(&formats())))]
    out: PathBuf,
    /// The side of the texture, in texels; at most 8192.
    #[arg(long, value_name = "TEXELS", default_value_t = 2048, value_parser = size())]
    size: u32,
    /// Make new texture coordinates even if the mesh has its own.
    #[arg(long)]
    unwrap: bool,
    /// In a new atlas, texels around each chart that no other chart claims; at most 256.
    #[arg(
        long,
        value_name = "TEXELS",
        default_value_t = 4,
        value_parser = clap::value_parser!(u32).range(0..=256)
    )]
    margin: u32,
    /// Take the pictures as bright as they are, without levelling their exposures.
    #[arg(long)]
    keep_exposure: bool,
}

/// The formats that keep the picture.
fn formats() -> Vec<Format> {
    mesh_file::formats(ga_mesh::format::Format::keeps_materials)
}

/// Sizes that textures may have.
fn size() -> RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(1..=8192)
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = &Self {
            pictures: expanded("--pictures", &self.pictures)?,
            ..self.clone()
        };
        let out = &arguments.out;
        let mut files = context.files(
            [&arguments.mesh, &arguments.views]
                .into_iter()
                .chain(&arguments.pictures),
        )?;
        let format = files.write("--out", out, &formats())?;
        let begin = Instant::now();
        let progress = context.progress(8);
        progress.step("reading");
        let (mesh, mut warnings) = mesh_file::read(&arguments.mesh)?;
        let views = read_views(&arguments.views, &arguments.pictures, arguments.lens)?;
        let mut options = Options::with_size(arguments.size);
        options.unwrap = arguments.unwrap;
        options.margin_texels = arguments.margin;
        options.level_exposure = !arguments.keep_exposure;
        let textured = texture_mesh(&mesh, &views, &options, |step| progress.step(step));
        let textured = textured.with_context(|| arguments.mesh.display().to_string())?;
        progress.step("writing");
        let model = textured.to_mesh()?;
        let files = mesh_file::files(out, format, &model, &Default::default())?;
        mesh_file::check_parts("--out", &[&arguments.mesh], &files[1..])?;
        context.outputs().write_all(&files)?;
        drop(progress);
        warnings.extend(views_alone(&textured.report.views));
        Ok(Report {
            out: out.display().to_string(),
            warnings,
            texture: textured.report,
            seconds: begin.elapsed().as_secs_f64(),
        })
    }
}

/// A warning of each view whose exposure cannot be compared with that of another.
fn views_alone(views: &[texture::ViewReport]) -> impl Iterator<Item = Warning> {
    let alone = views.iter().filter(|view| view.overlapping_views == 0);
    let alone = alone.filter(|_| views.len() > 1);
    alone.map(|view| {
        let text = "this view overlaps no other, so that its exposure is not levelled";
        Warning {
            view: Some(view.name.clone()),
            ..Warning::new("view_alone", text).in_file(Path::new(&view.name))
        }
    })
}

/// The cameras of a file with their pictures, which are the names of the views.
fn read_views(path: &Path, pictures: &[PathBuf], lens: LensChoice) -> Result<Vec<View>> {
    let shown = path.display();
    let mut cameras = lens.read(path)?.cameras;
    if !pictures.is_empty() {
        let (given, needed) = (pictures.len(), cameras.len());
        ensure!(
            given == needed,
            "--pictures: there are {given} pictures, and {shown} has {needed} cameras"
        );
        for (camera, picture) in cameras.iter_mut().zip(pictures) {
            camera.picture = Some(picture.clone());
        }
    }
    let view = |named: &NamedCamera| {
        let picture = named.picture.as_ref().with_context(|| {
            format!("{shown}: the file names no pictures: --pictures LEFT RIGHT is needed")
        })?;
        let camera = named.camera().map_err(|error| about(path, error))?;
        let name = picture.display().to_string();
        let view = View::new(name, camera, named.size, &picture_file::read(picture)?);
        view.with_context(|| shown.to_string())
    };
    cameras.iter().map(view).collect()
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    out: String,
    #[serde(skip)]
    warnings: Vec<Warning>,
    #[serde(flatten)]
    texture: texture::Report,
    seconds: f64,
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let of = &self.texture;
        let atlas = if of.unwrapped { "a new" } else { "its own" };
        let share = |part: usize| 100.0 * part as f64 / of.covered_texels.max(1) as f64;
        let mut text = format!(
            "{}: {} texels a side, {atlas} atlas of {} charts, {} texels on the surface\n",
            self.out, of.size, of.charts, of.covered_texels
        );
        for view in &of.views {
            let [red, green, blue] = view.gain;
            text += &format!(
                "{}: sees {:.1} %, is the best for {:.1} %, gain {red:.3} {green:.3} {blue:.3}\n",
                view.name,
                share(view.seen_texels),
                share(view.best_texels)
            );
        }
        let (filled, seconds) = (share(of.filled_texels), self.seconds);
        text + &format!("{filled:.1} % seen by no view and filled; done in {seconds:.2} s\n")
    }
}
