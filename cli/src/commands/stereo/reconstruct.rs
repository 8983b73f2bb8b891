//! `nullcone stereo reconstruct`: two views as a cloud of points or a surface in metres.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_camera::frame::y_up;
use ga_image::png;
use ga_mesh::format::{Format as MeshFormat, Options};
use ga_runtime::cga3::Motor;
use ga_vision::surface::{DepthSummary, PairOptions, RectifiedPair, Surface, SurfaceOptions};
use serde::Serialize;

use super::match_views::{Mode, threads};
use super::views::ViewPair;
use crate::camera_file::ChosenPair;
use crate::format::{Format, endings};
use crate::frame::{self, Command, Context};
use crate::{mesh_file, output};

/// Reconstruct what two cameras see, in metres.
///
/// The views are as the cameras took them: they are rectified with the rig of a file (of any
/// format, such as OpenCV's YAML, which `nullcone stereo calibrate` writes), matched, and each
/// pixel that both cameras see becomes a point. Where --rig is a Middlebury calib.txt, the views
/// are taken as rectified already.
///
/// The ending of --out decides: .ply holds a cloud of points, .obj and .glb a surface of triangles;
/// --cloud asks for points in any of them, --surface for triangles. Neighbouring pixels are joined
/// unless their disparities differ by more than --cut pixels.
///
/// The left camera is at the origin. By default y is up and the camera looks along −z, as glTF
/// has it; with --axes camera, y is down and it looks along z, as computer vision has it.
///
/// For instance
///
///   nullcone stereo reconstruct left.jpg right.jpg --rig rig.yml --out model.glb --json
///
/// prints {"width_px": …, "height_px": …, "max_disparity_px": …, "mode": "balanced",
/// "points": …, "triangles": …, "density": …, "nearest_metres": …, "median_metres": …,
/// "farthest_metres": …, "bounds_metres": [[…], […]], "baseline_metres": …, "focal_px": …,
/// "seconds": …}. Distances are depths along the axis of the left camera after rectification, and
/// density is the percentage of pixels that became points.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    views: ViewPair,
    /// The two cameras: YAML with M1, D1, M2, D2, R and T in one file, a calib.txt, or two views in
    /// JSON. OpenCV's examples write two files: append extrinsics.yml, without `%YAML:1.0` and
    /// `---`, to intrinsics.yml.
    #[arg(long, value_name = "FILE")]
    rig: PathBuf,
    #[command(flatten)]
    chosen: ChosenPair,
    /// The model: .ply, .obj, .glb or .gltf.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Write points, whatever the ending.
    #[arg(long, conflicts_with = "surface")]
    cloud: bool,
    /// Write triangles, whatever the ending.
    #[arg(long)]
    surface: bool,
    /// Lay the left view on the surface as a picture, instead of a colour for each vertex.
    #[arg(long, conflicts_with = "cloud")]
    texture: bool,
    /// Disparities are less than this number of pixels; without it, the views decide.
    #[arg(long, value_name = "N")]
    max_disparity: Option<usize>,
    /// How much work the matcher does.
    #[arg(long, value_enum, default_value_t = Mode::Balanced)]
    mode: Mode,
    /// Cut the surface where the disparities of neighbouring pixels differ by more.
    #[arg(long, value_name = "PIXELS", default_value_t = 1.0)]
    cut: f64,
    /// Every how many rows and columns there is a point.
    #[arg(long, value_name = "N", default_value_t = 1)]
    step: usize,
    /// Leave out what is nearer, in metres.
    #[arg(long, value_name = "METRES", default_value_t = 0.0)]
    near: f64,
    /// Leave out what is farther away, in metres.
    #[arg(long, value_name = "METRES", default_value_t = f64::INFINITY)]
    far: f64,
    /// Leave out pixels that are less certain, from 0 to 1.
    #[arg(long, value_name = "C", default_value_t = 0.0)]
    min_confidence: f32,
    /// Which way the axes point.
    #[arg(long, value_enum, default_value_t = Axes::YUp)]
    axes: Axes,
    /// The number of threads; by default as many as the machine can run at the same time.
    #[arg(long, value_name = "N", value_parser = threads())]
    threads: Option<u16>,
}

/// Which way the axes point.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(in crate::commands) enum Axes {
    /// x to the right, y up, z towards the viewer.
    YUp,
    /// x to the right, y down, z forward.
    Camera,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    out: String,
    width_px: usize,
    height_px: usize,
    max_disparity_px: usize,
    mode: Mode,
    points: usize,
    triangles: usize,
    #[serde(flatten)]
    depths: DepthSummary,
    bounds_metres: [[f64; 3]; 2],
    baseline_metres: f64,
    focal_px: f64,
    seconds: f64,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let mut files = context.files(self.views.paths().into_iter().chain([&*self.rig]))?;
        let format = files.write("--out", &self.out, &mesh_file::all_formats(MeshFormat::Ply))?;
        self.check(format)?;
        let begin = Instant::now();
        let progress = context.progress(5);
        progress.step("reading the views");
        let views = self.views.read()?.map(|view| view.to_rgb());
        progress.step("rectifying");
        let size = [views[0].width(), views[0].height()];
        let file = self.chosen.read(&self.rig)?;
        file.check_sizes(size, self.views.paths(), &self.rig)?;
        let pair = match file.rectified {
            Some(rectified) => RectifiedPair::new(views, rectified.rig),
            None => RectifiedPair::rectify(&views, &file.rig)
                .with_context(|| self.rig.display().to_string())?,
        };
        progress.step("matching");
        let given = file.rectified.and_then(|rectified| rectified.disparities);
        let options = PairOptions {
            max_disparity: self.max_disparity.or(given),
            mode: self.mode.into(),
            threads: self.threads.map_or(0, usize::from),
            least_confidence: self.min_confidence,
        };
        let found = pair.disparities(&options);
        let (map, range) = found.with_context(|| self.views.named())?;
        progress.step("building the model");
        let options = SurfaceOptions {
            cut_px: self.cut,
            step: self.step,
            depths: [self.near, self.far],
        };
        let rig = pair.rig();
        let surface = Surface::new(&map, rig, &options)
            .with_context(|| format!("{} with {}", self.views.named(), self.rig.display()))?;
        let depths = surface.summary();
        let surface = surface.moved(&(self.axes.motor() * pair.to_left()));
        let view = &pair.views()[0];
        let mesh = if self.cloud || !(self.surface || keeps_materials(format)) {
            surface.to_cloud(view)?
        } else if self.texture {
            surface.to_textured_mesh("image/png", png::encode(view)?.into())?
        } else {
            surface.to_mesh(view)?
        };
        progress.step("writing");
        let files = mesh_file::files(&self.out, format, &mesh, &Options::default())?;
        output::write_together(files)?;
        drop(progress);

        let [width_px, height_px] = surface.size();
        Ok(Report {
            out: self.out.display().to_string(),
            width_px,
            height_px,
            max_disparity_px: range,
            mode: self.mode,
            points: mesh.vertex_count(),
            triangles: mesh.faces().len(),
            depths,
            bounds_metres: surface.bounds(),
            baseline_metres: rig.baseline(),
            focal_px: rig.left().focal()[0],
            seconds: begin.elapsed().as_secs_f64(),
        })
    }
}

/// Whether a surface keeps its picture in a format.
fn keeps_materials(format: Format) -> bool {
    matches!(format, Format::Mesh(format) if format.keeps_materials())
}

impl Arguments {
    /// Fails where the arguments contradict each other.
    fn check(&self, format: Format) -> Result<()> {
        ensure!(
            (0.0..=1.0).contains(&self.min_confidence),
            "--min-confidence {} is not from 0 to 1",
            self.min_confidence
        );
        ensure!(
            !self.texture || keeps_materials(format),
            "{}: the format holds no pictures; --texture needs {}",
            self.out.display(),
            endings(&mesh_file::formats(MeshFormat::keeps_materials))
        );
        Ok(())
    }
}

impl Axes {
    /// From the frame of a camera.
    pub(in crate::commands) fn motor(self) -> Motor<f64> {
        match self {
            Self::YUp => y_up(),
            Self::Camera => Motor::default(),
        }
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let triangles = match self.triangles {
            0 => String::new(),
            count => format!(" and {count} triangles"),
        };
        format!(
            "{}: {} points{triangles} from {} × {} pixels, {:.2} % of them\n\
             depths {:.3} to {:.3} m, in the middle {:.3} m\n\
             disparities below {} px, baseline {:.4} m, focal length {:.1} px\n\
             done in {:.2} s\n",
            self.out,
            self.points,
            self.width_px,
            self.height_px,
            self.depths.density,
            self.depths.nearest,
            self.depths.farthest,
            self.depths.median,
            self.max_disparity_px,
            self.baseline_metres,
            self.focal_px,
            self.seconds
        )
    }
}
