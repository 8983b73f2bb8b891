//! `nullcone stereo reconstruct`: two views as a cloud of points or a surface in metres.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_camera::rig::RectifiedRig;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::Mesh;
use ga_mesh::format::Options;
use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Motor, Rotor};
use ga_vision::disparity::DisparityMap;
use ga_vision::matcher::{Matcher, MatcherOptions};
use ga_vision::rectification::{Rectification, RectificationOptions};
use ga_vision::surface::{Surface, SurfaceOptions, disparity_range, seen_by_both};
use serde::Serialize;

use super::match_views::{Mode, threads};
use super::views;
use crate::camera_file::ChosenPair;
use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::mesh_file;
use crate::output;

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
    /// The left view.
    #[arg(value_name = "LEFT")]
    left: PathBuf,
    /// The right view.
    #[arg(value_name = "RIGHT")]
    right: PathBuf,
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
    density: f64,
    nearest_metres: f64,
    median_metres: f64,
    farthest_metres: f64,
    bounds_metres: [[f64; 3]; 2],
    baseline_metres: f64,
    focal_px: f64,
    seconds: f64,
}

/// Two rectified views, which of their pixels were seen, and the cameras.
struct Pair {
    views: [Plane<[u8; 3]>; 2],
    inside: [Plane<bool>; 2],
    rig: RectifiedRig,
    /// From the frame of the rectified left camera into that of the left camera.
    to_left: Motor<f64>,
    /// An upper bound of the disparities, where the file of the rig has one.
    disparities: Option<usize>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let mut files = context.files([&arguments.left, &arguments.right, &arguments.rig])?;
        let formats = [Format::Ply, Format::Obj, Format::Glb, Format::Gltf];
        let format = files.write("--out", &arguments.out, &formats)?;
        let kind = Kind::new(arguments, format)?;
        let begin = Instant::now();
        let progress = context.progress(5);
        progress.step("reading the views");
        let views = views::read_colour_pair(&arguments.left, &arguments.right)?;
        progress.step("rectifying");
        let pair = rectify(views, arguments)?;
        progress.step("matching");
        let (map, range) = disparities(&pair, arguments)?;
        progress.step("building the model");
        let options = SurfaceOptions {
            cut_px: arguments.cut,
            step: arguments.step,
            depths: [arguments.near, arguments.far],
        };
        let surface = Surface::new(&map, &pair.rig, &options).with_context(|| {
            let [left, right] = [&arguments.left, &arguments.right].map(|path| path.display());
            format!("{left} and {right} with {}", arguments.rig.display())
        })?;
        let mut depths: Vec<f64> = surface.points().iter().map(|point| point.e3()).collect();
        let depths = Sorted::new(&mut depths).context("the surface has no points")?;
        let surface = surface.moved(&(arguments.axes.motor() * pair.to_left));
        let mesh = kind.mesh(&surface, &pair.views[0])?;
        progress.step("writing");
        let files = mesh_file::files(&arguments.out, format, &mesh, &Options::default())?;
        output::write_together(files)?;
        drop(progress);

        let [width, height] = surface.size();
        let grid = width.div_ceil(arguments.step) * height.div_ceil(arguments.step);
        Ok(Report {
            out: arguments.out.display().to_string(),
            width_px: width,
            height_px: height,
            max_disparity_px: range,
            mode: arguments.mode,
            points: mesh.vertex_count(),
            triangles: mesh.faces().len(),
            density: 100.0 * depths.values().len() as f64 / grid as f64,
            nearest_metres: depths.quantile(0.0),
            median_metres: depths.median(),
            farthest_metres: depths.quantile(1.0),
            bounds_metres: surface.bounds(),
            baseline_metres: pair.rig.baseline(),
            focal_px: pair.rig.left().focal()[0],
            seconds: begin.elapsed().as_secs_f64(),
        })
    }
}

/// What is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Cloud,
    Coloured,
    Textured,
}

impl Kind {
    /// By the flags, or by the ending of the file.
    fn new(arguments: &Arguments, format: Format) -> Result<Self> {
        ensure!(
            (0.0..=1.0).contains(&arguments.min_confidence),
            "--min-confidence {} is not from 0 to 1",
            arguments.min_confidence
        );
        if arguments.texture && format == Format::Ply {
            bail!(
                "{}: PLY holds no pictures; --texture needs .obj or .glb",
                arguments.out.display()
            );
        }
        let by_ending = format == Format::Ply && !arguments.surface;
        Ok(if arguments.cloud || by_ending {
            Self::Cloud
        } else if arguments.texture {
            Self::Textured
        } else {
            Self::Coloured
        })
    }

    fn mesh(self, surface: &Surface, view: &Plane<[u8; 3]>) -> Result<Mesh> {
        Ok(match self {
            Self::Cloud => surface.to_cloud(view)?,
            Self::Coloured => surface.to_mesh(view)?,
            Self::Textured => {
                surface.to_textured_mesh("image/png", Arc::from(png::encode(view)?))?
            }
        })
    }
}

impl Axes {
    /// From the frame of a camera.
    pub(in crate::commands) fn motor(self) -> Motor<f64> {
        match self {
            // A rotation by 180° about x.
            Self::YUp => Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0).into(),
            Self::Camera => Motor::default(),
        }
    }
}

/// Rectifies the views with the rig of a file.
fn rectify(views: [Plane<[u8; 3]>; 2], arguments: &Arguments) -> Result<Pair> {
    let path = &arguments.rig;
    let size = [views[0].width(), views[0].height()];
    let rig = arguments.chosen.read(path)?;
    rig.check_sizes(size, [&arguments.left, &arguments.right], path)?;
    if let Some(rectified) = rig.rectified {
        return Ok(Pair {
            inside: [(); 2].map(|()| Plane::filled(size[0], size[1], true)),
            views,
            rig: rectified.rig,
            to_left: Motor::default(),
            disparities: rectified.disparities,
        });
    }
    let found = Rectification::new(&rig.rig, size, RectificationOptions::default())
        .with_context(|| path.display().to_string())?;
    let maps = [found.left_map(), found.right_map()];
    let warped = |side: usize| {
        let view = maps[side].warped(&views[side], [0; 3]);
        view.with_context(|| path.display().to_string())
    };
    Ok(Pair {
        views: [warped(0)?, warped(1)?],
        inside: maps.each_ref().map(ga_image::warp::Warp::inside),
        rig: found.rig,
        to_left: found.left.motor.reverse(),
        disparities: None,
    })
}

/// The disparities of what both cameras see, and the range they were looked for in.
fn disparities(pair: &Pair, arguments: &Arguments) -> Result<(DisparityMap, usize)> {
    let named = || {
        let [left, right] = [&arguments.left, &arguments.right].map(|path| path.display());
        format!("{left} and {right}")
    };
    let threads = arguments.threads.map_or(0, usize::from);
    let [left, right] = pair.views.each_ref().map(|view| Luma::Bt601.plane(view));
    let given = arguments.max_disparity.or(pair.disparities);
    let max_disparity = match given {
        Some(range) => range,
        None => disparity_range(&left, &right, threads).with_context(named)?,
    };
    let options = MatcherOptions {
        max_disparity,
        mode: arguments.mode.into(),
        threads,
    };
    let mut matcher = Matcher::new(options, left.width(), left.height()).with_context(named)?;
    let found = matcher.run(&left, &right).with_context(named)?;
    let [left, right] = &pair.inside;
    let seen = seen_by_both(&found.disparity, [left.view(), right.view()])?;
    let mut pixels = seen.into_plane();
    let confidence = found.confidence.values();
    for (disparity, confidence) in pixels.values_mut().iter_mut().zip(confidence) {
        if *confidence < arguments.min_confidence {
            *disparity = f32::NAN;
        }
    }
    Ok((DisparityMap::new(pixels), max_disparity))
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
            self.density,
            self.nearest_metres,
            self.farthest_metres,
            self.median_metres,
            self.max_disparity_px,
            self.baseline_metres,
            self.focal_px,
            self.seconds
        )
    }
}
