//! `nullcone stereo reconstruct`: two views as a cloud of points or a surface in metres.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_camera::frame::y_up;
use ga_image::picture::Picture;
use ga_image::png;
use ga_mesh::format::{Format as MeshFormat, Options};
use ga_runtime::cga3::Motor;
use ga_vision::surface::{DepthSummary, PairOptions, RectifiedPair, Surface, SurfaceOptions};
use serde::Serialize;

use super::matching::{MatchingArguments, Mode, warnings};
use super::views::ViewPair;
use crate::camera_file::ChosenPair;
use crate::format::{Format, endings};
use crate::frame::{self, Check, Command, Context, Verdict, Warning, keep_for_failure};
use crate::mesh_file;

/// Reconstruct what two cameras see, in metres.
///
/// The views are as the cameras took them: they are rectified with the rig of a file (of any
/// format, such as OpenCV's YAML, which `nullcone stereo calibrate` writes), matched, and each
/// pixel that both cameras see becomes a point. Where --rig is a Middlebury calib.txt, the views
/// are taken as rectified already. Without --max-disparity, that file or the views decide how far
/// disparities are looked for.
///
/// The ending of --out decides: .ply holds a cloud of points, .obj and .glb a surface of triangles;
/// --cloud asks for points in any of them, --surface for triangles. Neighbouring pixels are joined
/// unless their disparities differ by more than --cut pixels. Far away, where disparities are no
/// greater than their noise, depths are decided by it: --depth-deviation leaves such points out.
///
/// The left camera is at the origin. By default y is up and the camera looks along −z, as glTF
/// has it; with --axes camera, y is down and it looks along z, as computer vision has it.
///
/// For instance
///
///   nullcone stereo reconstruct left.jpg right.jpg --rig rig.yml --out model.glb --json
///
/// prints {"width_px": …, "height_px": …, "min_disparity_px": 0, "max_disparity_px": …,
/// "mode": "balanced", "points": …, "triangles": …, "density": …, "nearest_metres": …,
/// "median_metres": …, "farthest_metres": …, "left_out_by_depth_deviation": …,
/// "bounds_metres": [[…], […]], "baseline_metres": …, "focal_px": …, "seconds": …}. Distances are
/// depths along the axis of the left camera after rectification, and density is the percentage of
/// pixels that became points. Where the views are matched badly, a warning says what
/// `nullcone stereo diagnose` finds, and the verdict is doubtful.
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
    #[command(flatten)]
    matching: MatchingArguments,
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
    /// Leave out points whose depth has a greater standard deviation than this part of it, where
    /// disparities have one of 0.25 px; `inf` for none.
    #[arg(long, value_name = "PART", default_value_t = SurfaceOptions::default().depth_deviation)]
    depth_deviation: f64,
    /// Which way the axes point.
    #[arg(long, value_enum, default_value_t = Axes::YUp)]
    axes: Axes,
    #[command(flatten)]
    check: Check,
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
    #[serde(skip)]
    warnings: Vec<Warning>,
    width_px: usize,
    height_px: usize,
    min_disparity_px: i32,
    max_disparity_px: i32,
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

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let mut files = context.files(self.views.paths().into_iter().chain([&*self.rig]))?;
        let format = files.write("--out", &self.out, &mesh_file::all_formats(MeshFormat::Ply))?;
        self.check(format)?;
        let begin = Instant::now();
        let progress = context.progress(5);
        progress.step("reading the views");
        let views = Picture::spread(self.views.read()?);
        progress.step("rectifying");
        let size = [views[0].width(), views[0].height()];
        let file = self.chosen.read(&self.rig)?;
        file.check_sizes(size, self.views.paths(), &self.rig)?;
        let pair = match file.rectified {
            Some(rectified) => RectifiedPair::new(&views, rectified.rig),
            None => RectifiedPair::rectify(&views, &file.rig)
                .with_context(|| self.rig.display().to_string())?,
        };
        progress.step("matching");
        let given = file.rectified.and_then(|rectified| rectified.disparities);
        let given = given.and_then(|count| i32::try_from(count).ok());
        let matching = &self.matching;
        let options = PairOptions {
            min_disparity: matching.min_disparity,
            max_disparity: matching.max_disparity.or(given),
            mode: matching.mode.into(),
            threads: rayon::current_num_threads(),
            least_confidence: matching.min_confidence,
        };
        let found = pair.disparities(&options);
        let found = found.with_context(|| self.views.named())?;
        let warnings = warnings(&found.faults);
        keep_for_failure(&warnings);
        progress.step("building the model");
        let options = SurfaceOptions {
            cut_px: self.cut,
            step: self.step,
            depths: [self.near, self.far],
            depth_deviation: self.depth_deviation,
        };
        let rig = pair.rig();
        let surface = Surface::new(&found.disparity, rig, &options)
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
        context.outputs().write_all(&files)?;
        drop(progress);

        let [width_px, height_px] = surface.size();
        Ok(Report {
            out: self.out.display().to_string(),
            width_px,
            height_px,
            min_disparity_px: found.range[0],
            max_disparity_px: found.range[1],
            warnings,
            mode: matching.mode,
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
        self.matching.check()?;
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
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(Verdict::of(&self.warnings))
    }

    fn text(&self) -> String {
        let triangles = match self.triangles {
            0 => String::new(),
            count => format!(" and {count} triangles"),
        };
        let uncertain = match self.depths.uncertain {
            0 => String::new(),
            count => format!("{count} pixels are left out by the deviation of their depth\n"),
        };
        format!(
            "{}: {} points{triangles} from {} × {} pixels, {:.2} % of them\n{uncertain}\
             depths {:.3} to {:.3} m, in the middle {:.3} m\n\
             disparities from {} up to {} px, baseline {:.4} m, focal length {:.1} px\n\
             done in {:.2} s\n",
            self.out,
            self.points,
            self.width_px,
            self.height_px,
            self.depths.density,
            self.depths.nearest,
            self.depths.farthest,
            self.depths.median,
            self.min_disparity_px,
            self.max_disparity_px,
            self.baseline_metres,
            self.focal_px,
            self.seconds
        )
    }
}
