//! `nullcone render`: pictures and films of a model.

mod camera;
mod drawing;
mod film;
mod model_file;

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_character::animated_scene::Moment;
use ga_draw::Colour;
use ga_files::Staged;
use ga_image::colour::LinearColour;
use ga_render::view_file;
use ga_render::{Shading, Style, Viewpoint, buffer_files};
use serde::Serialize;

use self::camera::Camera;
use self::drawing::Drawing;
use self::film::FilmArguments;
use self::model_file::{ModelFile, Scene};
use crate::chosen_animation::{ChosenAnimation, warn_of_times};
use crate::film_file;
use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};

/// Draw a model.
///
/// The model is Wavefront OBJ with its materials and textures, PLY or glTF. It is lit by a key
/// light from the upper left of the camera, a weak light from the right and light from all around;
/// objects cast shadows. Transparent surfaces show what lies behind them, and lines and points of
/// the model are drawn. Of glTF models, faces are seen from the back where their material is
/// double-sided; of others, all are.
///
/// An animated glTF model is drawn at a --time of an --animation, with its skins, morph targets and
/// moving nodes; without both, in the pose of its nodes. --film FILE draws all frames of the
/// animation, from one camera that sees the whole film, or from a --camera-node that may move.
///
/// The camera (--camera) is one of
///
///   front, side, top, three-quarter
///       a view of the whole model, whose y axis points up and which looks along +z
///   eye X,Y,Z target X,Y,Z fov DEGREES
///   eye X,Y,Z target X,Y,Z up X,Y,Z fov DEGREES
///       a place, what it looks at, the upward direction (0,1,0 by default) and the vertical field
///       of view, as one argument in quotation marks
///   FILE
///       the camera of a file of any format (docs/stereo.md lists them), which --view chooses if
///       there are several. It needs a pose; the world of a rig is the frame of its left camera.
///       Distortion is not drawn: nullcone stereo undistort removes it. In JSON, for instance:
///       intrinsics in pixels and the pose from the world to the camera, whose axes are x right,
///       y down, z forwards; (0, 0) is the middle of the first pixel. A point p falls on
///       (fx x/z + cx, fy y/z + cy), where (x, y, z) = rotation p + translation:
///
///       {"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5,
///        "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 2]}
///
///       "skew" (0 by default), "near" and "far" may be added.
///
/// --json prints {"out": …, "width_px": …, "height_px": …, "pictures": …, "triangles": …,
/// "seconds": …, "files": […], "warnings": […]}; of an animation, also {"animation": …,
/// "animation_name": …, "time_seconds": …, "duration_seconds": …}, where the time is that of the
/// first picture and the duration that of the animation, and of a film "frames_per_second".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The model: its name ends in .obj, .ply, .glb or .gltf.
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// From where it is seen; see above.
    #[arg(long, value_name = "VIEW", default_value = "three-quarter")]
    camera: String,
    /// The camera of the file: its name, or its number from 0.
    #[arg(long, value_name = "NAME")]
    view: Option<String>,
    /// See the model from a camera inside the glTF document: the name of its node or of the camera,
    /// or the number of the node from 0. In a film it moves with its node.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["camera", "view"])]
    camera_node: Option<String>,
    /// Columns and rows of the picture; by default those of the camera's file, or 1280x720, or 720
    /// rows as wide as a --camera-node says.
    #[arg(long, value_name = "WxH")]
    size: Option<String>,
    /// The picture: PNG if its name ends in .png, or a film without compression if it ends in .y4m.
    #[arg(
        long,
        value_name = "FILE.png or FILE.y4m",
        required_unless_present = "film"
    )]
    out: Option<PathBuf>,
    #[command(flatten)]
    animation: ChosenAnimation,
    /// The time in seconds of the animation that is drawn; by default 0.
    ///
    /// Before the first key of a channel the first key counts, after the last key the last. A time
    /// that the animation does not have is warned of.
    #[arg(long, value_name = "SECONDS", conflicts_with = "film")]
    time: Option<f64>,
    #[command(flatten)]
    film: FilmArguments,
    /// As many pictures with the camera moving once around the model: an animated PNG or a film
    /// with 25 pictures in a second. At most 1000, with at most 2^30 pixels together.
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with = "film")]
    turntable: u32,
    /// Whether surfaces are lit or show their base colour.
    #[arg(long, value_enum, default_value_t = Light::Lit)]
    shading: Light,
    /// Samples along each side of a pixel, 1 to 8, against jagged edges.
    #[arg(long, value_name = "N", default_value_t = 3)]
    samples: u32,
    /// One colour behind the model, as six hexadecimal digits such as ffffff, in place of a
    /// gradient.
    #[arg(long, value_name = "RRGGBB")]
    background: Option<String>,
    /// Draw the edges of all triangles.
    #[arg(long)]
    wireframe: bool,
    /// Put the model on level ground, that of a film at its lowest place in all frames.
    #[arg(long)]
    ground: bool,
    /// Also write what the first picture shows at the middle of each pixel, as numbers, into this
    /// folder.
    ///
    /// depth.pfm holds the distance along the viewing direction and distance.pfm that from the eye,
    /// both infinite where nothing is seen; uv.pfm texture coordinates and a mask; normal.pfm the
    /// normal in the world; identity.png, with 16 bits for each channel, the object, counted from
    /// 1, in red and the triangle, counted from 1, in green (multiples of 65536) and blue (the
    /// rest); material.png, grey with 16 bits, the material, counted from 1. Where nothing is seen,
    /// all these are 0.
    #[arg(long, value_name = "DIR", conflicts_with = "film")]
    buffers: Option<PathBuf>,
    /// Also write each picture as PNG into this folder, and views.json with their cameras, which
    /// `nullcone texture` and `nullcone body fit` read.
    #[arg(long, value_name = "DIR", conflicts_with = "film")]
    views: Option<PathBuf>,
    /// Also write the camera of the first picture, as --camera reads it.
    #[arg(long, value_name = "FILE.json")]
    camera_out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Light {
    Lit,
    Unlit,
}

/// The most pictures of a turntable.
const MOST_PICTURES: u32 = 1000;

/// The most pixels of all pictures of a turntable together.
const MOST_PIXELS: u64 = 1 << 30;

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    out: String,
    width_px: u32,
    height_px: u32,
    pictures: usize,
    triangles: usize,
    /// The time of drawing.
    seconds: f64,
    #[serde(flatten)]
    played: Option<Played>,
    files: Vec<String>,
    #[serde(skip)]
    warnings: Vec<Warning>,
    #[serde(skip)]
    staged: Staged,
}

/// The animation that is seen.
#[derive(Serialize)]
struct Played {
    animation: usize,
    animation_name: Option<String>,
    time_seconds: f64,
    duration_seconds: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    frames_per_second: Option<f64>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let count = self.turntable;
        ensure!(
            (1..=MOST_PICTURES).contains(&count),
            "--turntable {count}: not 1 to {MOST_PICTURES}",
        );
        let (out, format) = self.check_files(context)?;
        let time = self.time.unwrap_or(0.0);
        ensure!(time.is_finite(), "--time {time}: the time must be finite");
        self.film.check()?;

        let progress = context.progress(1);
        progress.step("reading the model");
        let path = &self.model;
        let file = ModelFile::read(path, self.plays())?;
        let mut warnings = file.warnings.clone();
        let animation = match &file.document {
            Some(document) if self.plays() => self.animation.number(document)?,
            _ => None,
        };
        let played = file.animation(animation);
        if self.film.file.is_some() && played.is_none() {
            bail!("--film: {} has no animation to be drawn", path.display());
        }
        let camera = Camera::new(self, file.document.as_ref())?;
        let [width, height] = camera.picture_size(self)?;
        let pixels = (u64::from(width) * u64::from(height)).saturating_mul(count.into());
        ensure!(
            count == 1 || pixels <= MOST_PIXELS,
            "--turntable {count}: with {width}x{height} these are {pixels} pixels, more than \
             {MOST_PIXELS}"
        );
        let style = self.style([width, height])?;
        let duration = played.map_or(0.0, |animation| animation.duration());
        let times = match &self.film.file {
            Some(_) => self.film.times(duration)?,
            None => film::Times::one(time),
        };
        warn_of_times(path, played, times.ends(), &mut warnings);

        let mut scene = file.scene()?;
        for warning in scene.warnings(path) {
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
        let named = || path.display().to_string();
        let first = Moment {
            animation,
            seconds: times.at(0),
        };
        let model = scene.at(first).with_context(named)?;
        ensure!(
            !model.is_empty(),
            "{}: there is no triangle, line or point to be drawn",
            path.display()
        );
        let triangles = model.triangle_count();
        let begin = Instant::now();
        let drawing = match (&mut scene, &self.film.file) {
            (Scene::Animated(scene), Some(_)) => {
                let film = film::Film {
                    animation,
                    camera: &camera,
                    times: &times,
                };
                film.draw(self, scene, &style, format, &progress)
            }
            _ => {
                let viewpoint = match camera {
                    Camera::Node(node, _) => {
                        Viewpoint::View(scene.view(node, first).with_context(named)?)
                    }
                    Camera::Outside(viewpoint, _) => viewpoint,
                };
                let model = scene.at(first)?;
                let views = viewpoint.turntable(model, style.aspect(), count);
                let views = views.with_context(named)?;
                drawing::draw(self, model, &views, &style, format, &progress)
            }
        };
        let Drawing { staged, files } = drawing.with_context(named)?;
        Ok(Report {
            out: out.display().to_string(),
            width_px: width,
            height_px: height,
            pictures: times.count().max(count as usize),
            triangles,
            seconds: begin.elapsed().as_secs_f64(),
            played: played.zip(animation).map(|(played, animation)| Played {
                animation,
                animation_name: played.name.clone(),
                time_seconds: times.at(0),
                duration_seconds: duration,
                frames_per_second: self.film.file.as_ref().map(|_| self.film.rate),
            }),
            files: files
                .iter()
                .map(|path| path.display().to_string())
                .collect(),
            warnings,
            staged,
        })
    }
}

impl Arguments {
    /// Whether an animation is asked for.
    fn plays(&self) -> bool {
        self.animation.is_given() || self.time.is_some() || self.film.file.is_some()
    }

    /// The picture or film that is asked for, and its format; fails where a file cannot be written.
    fn check_files(&self, context: &Context) -> Result<(&PathBuf, Format)> {
        let camera = camera::file(&self.camera);
        let mut files = context.files([self.model.as_path()].into_iter().chain(camera))?;
        let (option, out) = match (&self.film.file, &self.out) {
            (Some(film), _) => ("--film", film),
            (None, Some(out)) => ("--out", out),
            (None, None) => bail!("--out or --film is needed"),
        };
        let format = files.write(option, out, &film_file::FORMATS)?;
        if let Some(folder) = &self.buffers {
            files.write_folder("--buffers", folder, buffer_files::NAMES)?;
        }
        if let Some(folder) = &self.views {
            files.write_folder("--views", folder, view_file::names(self.turntable))?;
        }
        files.write_if_given("--camera-out", self.camera_out.as_ref(), &[Format::Json])?;
        Ok((out, format))
    }

    fn style(&self, [width, height]: [u32; 2]) -> Result<Style> {
        let usual = Style::model();
        Ok(Style {
            width,
            height,
            supersampling: self.samples,
            shading: match self.shading {
                Light::Lit => Shading::Lit,
                Light::Unlit => Shading::Unlit,
            },
            background: match &self.background {
                Some(text) => [parse_colour(text)?; 2],
                None => usual.background,
            },
            ..usual
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let Self {
            out,
            width_px,
            height_px,
            triangles,
            ..
        } = self;
        let milliseconds = 1e3 * self.seconds;
        let played = match &self.played {
            None => String::new(),
            Some(played) => {
                let name = played.animation_name.as_ref();
                let name = name.map_or(String::new(), |name| format!(" ({name})"));
                let of = format!("animation {}{name}", played.animation);
                match played.frames_per_second {
                    Some(rate) => {
                        let pictures = self.pictures;
                        format!("{pictures} pictures of {of}, {rate} in a second, ")
                    }
                    None => format!("{of} at {} s, ", played.time_seconds),
                }
            }
        };
        format!(
            "wrote {out} ({width_px} × {height_px}, {triangles} triangles, {played}\
             {milliseconds:.0} ms)\n"
        )
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn files(&mut self) -> Staged {
        std::mem::take(&mut self.staged)
    }
}

fn parse_colour(text: &str) -> Result<LinearColour> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let colour: Colour = format!("#{digits}")
        .parse()
        .ok()
        .with_context(|| format!("--background {text}: not six hexadecimal digits"))?;
    Ok(LinearColour::from_srgb(colour.0))
}
