//! `nullcone render`: a picture of a model.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_camera::format::json;
use ga_image::colour::LinearColour;
use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::{png, y4m};
use ga_mesh::gltf;
use ga_render::model::Model;
use ga_render::{
    Buffers, Ground, Polyline, Scene, Shading, Style, Visibility, buffer_files, render,
};
use serde::Serialize;

use crate::camera_file;
use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::mesh_file;
use crate::output;
use crate::view::{View, bounds, camera_path};
use crate::view_files::{self, ViewFiles};

/// Draw a model.
///
/// The model is Wavefront OBJ with its materials and textures, PLY or glTF. It is lit by a key
/// light from the upper left of the camera, a weak light from the right and light from all around;
/// objects cast shadows. Transparent surfaces show what lies behind them, and lines and points of
/// the model are drawn. Of glTF models, faces are seen from the back where their material is
/// double-sided; of others, all are.
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
/// "seconds": …, "files": […], "warnings": […]}.
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
    /// Columns and rows of the picture; by default those of the camera's file, or 1280x720.
    #[arg(long, value_name = "WxH")]
    size: Option<String>,
    /// The picture: PNG if its name ends in .png, or a film without compression if it ends in .y4m.
    #[arg(long, value_name = "FILE.png or FILE.y4m")]
    out: PathBuf,
    /// As many pictures with the camera moving once around the model: an animated PNG or a film
    /// with 25 pictures in a second. At most 1000, with at most 2^30 pixels together.
    #[arg(long, value_name = "N", default_value_t = 1)]
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
    /// Put the model on level ground.
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
    #[arg(long, value_name = "DIR")]
    buffers: Option<PathBuf>,
    /// Also write each picture as PNG into this folder, and views.json with their cameras, which
    /// `nullcone texture` and `nullcone body fit` read.
    #[arg(long, value_name = "DIR")]
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

const DEFAULT_SIZE: [u32; 2] = [1280, 720];

/// The width of the model's polylines and the diameter of its points, in pixels.
const LINE_WIDTH: f64 = 2.0;
const POINT_DIAMETER: f64 = 5.0;

/// The most pictures of a turntable.
const MOST_PICTURES: u32 = 1000;

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    out: String,
    width_px: u32,
    height_px: u32,
    pictures: u32,
    triangles: usize,
    /// The time of drawing.
    seconds: f64,
    files: Vec<String>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let Self {
            model: path, out, ..
        } = arguments;
        ensure!(
            (1..=MOST_PICTURES).contains(&arguments.turntable),
            "--turntable {}: not 1 to {MOST_PICTURES}",
            arguments.turntable
        );
        let format = check_files(arguments, context)?;
        let view = View::parse(&arguments.camera, arguments.view.as_deref())?;
        let size = match &arguments.size {
            Some(size) => Some(parse_size(size)?),
            None => None,
        };
        let [width, height] = match (view.size(), size) {
            (Some(own), Some(asked)) if own != asked => bail!(
                "--size {}x{}: the camera {} is for {}x{}",
                asked[0],
                asked[1],
                arguments.camera,
                own[0],
                own[1]
            ),
            (None, None) if matches!(view, View::File { .. }) => bail!(
                "{}: the file does not say how large its pictures are: --size WxH is needed",
                arguments.camera
            ),
            (own, asked) => own.or(asked).unwrap_or(DEFAULT_SIZE),
        };
        check_pixels(arguments.turntable, [width, height])?;
        let mut style = Style {
            width,
            height,
            supersampling: arguments.samples,
            shading: match arguments.shading {
                Light::Lit => Shading::Lit,
                Light::Unlit => Shading::Unlit,
            },
            self_shadow: 0.8,
            ambient_occlusion: 0.7,
            depth_contrast: 0.0,
            ..Style::default()
        };
        if let Some(background) = &arguments.background {
            style.background = [parse_colour(background)?; 2];
        }

        let (model, warnings) = read(path)?;
        ensure!(
            !model.is_empty(),
            "{}: there is no triangle, line or point to be drawn",
            path.display()
        );
        let named = || path.display().to_string();
        let cameras = view
            .cameras(&model, style.aspect(), arguments.turntable)
            .with_context(named)?;
        let drawing = draw(&model, &cameras, &style, arguments, format).with_context(named)?;
        let files = drawing.write(arguments)?;
        Ok(Report {
            out: out.display().to_string(),
            width_px: width,
            height_px: height,
            pictures: arguments.turntable,
            triangles: model.triangle_count(),
            seconds: drawing.time.as_secs_f64(),
            files,
            warnings,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        format!(
            "wrote {} ({} × {}, {} triangles, {:.0} ms)\n",
            self.out,
            self.width_px,
            self.height_px,
            self.triangles,
            1e3 * self.seconds
        )
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }
}

/// The model in a file, with warnings of what it refers to that is not there.
fn read(path: &Path) -> Result<(Model, Vec<Warning>)> {
    let is_gltf = Format::of(path, &[Format::Glb, Format::Gltf]).is_some();
    let (mesh, mut warnings) = match is_gltf {
        true => (gltf::read_mesh(path)?, Vec::new()),
        false => mesh_file::read(path)?,
    };
    let model = Model::from_mesh(&mesh, path.parent());
    let mut model = model.with_context(|| path.display().to_string())?;
    if !is_gltf {
        model = model.with_both_sides();
    }
    for warning in mesh_file::missing_parts(path, model.warnings().iter().cloned()) {
        if !warnings.contains(&warning) {
            warnings.push(warning);
        }
    }
    Ok((model, warnings))
}

/// The files of a picture or film and of buffers.
struct Drawing {
    film: Vec<u8>,
    buffers: Vec<(&'static str, Vec<u8>)>,
    /// The files of `--views` and `--camera-out`.
    cameras: Vec<(PathBuf, Vec<u8>)>,
    /// How long drawing the pictures took.
    time: Duration,
}

/// Fails where a file cannot be written; else the format of the picture or film.
fn check_files(arguments: &Arguments, context: &Context) -> Result<Format> {
    let camera = camera_path(&arguments.camera);
    let mut files = context.files([arguments.model.as_path()].into_iter().chain(camera))?;
    let format = files.write("--out", &arguments.out, &[Format::Png, Format::Y4m])?;
    if let Some(folder) = &arguments.buffers {
        files.write_folder("--buffers", folder, buffer_files::NAMES)?;
    }
    if let Some(folder) = &arguments.views {
        files.write_folder("--views", folder, view_files::names(arguments.turntable))?;
    }
    files.write_if_given(
        "--camera-out",
        arguments.camera_out.as_ref(),
        &[Format::Json],
    )?;
    Ok(format)
}

/// The bytes of a file with these pictures, of which one at a time is in memory.
fn encode(
    format: Format,
    mut pictures: impl ExactSizeIterator<Item = Plane<[u8; 3]>>,
) -> Result<Vec<u8>, FormatError> {
    match format {
        Format::Y4m => y4m::encode(pictures, y4m::Film::default()),
        _ if pictures.len() == 1 => png::encode(&pictures.next().unwrap_or_default()),
        _ => png::encode_animation(pictures, png::Animation::default()),
    }
}

fn draw(
    model: &Model,
    cameras: &[ga_render::View],
    style: &Style,
    arguments: &Arguments,
    format: Format,
) -> Result<Drawing> {
    let materials = model.materials();
    let edges = if arguments.wireframe {
        model.edges()
    } else {
        Vec::new()
    };
    let mut lines = model.lines(LINE_WIDTH);
    lines.extend(edges.iter().map(|ends| Polyline {
        points: ends,
        colour: LinearColour::from_srgb([30, 40, 60]),
        width: 1.0,
        visibility: Visibility::Hidden,
    }));
    let dots = model.dots(POINT_DIAMETER);
    let scene = Scene {
        lines: &lines,
        dots: &dots,
        ground: arguments.ground.then(|| ground(model)),
        ..model.scene(&materials)
    };
    let mut time = Duration::ZERO;
    let mut failure: Option<anyhow::Error> = None;
    let mut views = arguments.views.as_deref().map(ViewFiles::new);
    let pictures = cameras.iter().map(|camera| {
        let begin = Instant::now();
        // An encoder asks for pictures, not for errors: those after an error have no pixels.
        let picture = match failure {
            None => render(&scene, camera, style)
                .map_err(|error| failure = Some(error.into()))
                .ok(),
            Some(_) => None,
        };
        time += begin.elapsed();
        let picture = picture.map(|picture| picture.colour).unwrap_or_default();
        if let (Some(views), None) = (&mut views, &failure) {
            failure = views.add(&picture, camera).err();
        }
        picture
    });
    let film = encode(format, pictures);
    if let Some(error) = failure {
        return Err(error);
    }
    let buffers = match (&arguments.buffers, cameras) {
        (Some(_), [camera, ..]) => {
            let buffers = Buffers::new(&scene, camera, style.width, style.height)?;
            buffer_files::encode(&buffers).context("--buffers")?
        }
        _ => Vec::new(),
    };
    let mut files = views.map_or(Ok(Vec::new()), ViewFiles::finish)?;
    if let (Some(path), [camera, ..]) = (&arguments.camera_out, cameras) {
        let camera = camera_file::of_view("camera", camera, [style.width, style.height])?;
        files.push((path.clone(), json::encode(&camera)?.into_bytes()));
    }
    Ok(Drawing {
        film: film?,
        buffers,
        cameras: files,
        time,
    })
}

impl Drawing {
    /// Writes all files or none, and says their names.
    fn write(&self, arguments: &Arguments) -> Result<Vec<String>> {
        let mut files = vec![(arguments.out.clone(), &self.film)];
        if let Some(folder) = &arguments.buffers {
            let buffers = self.buffers.iter();
            files.extend(buffers.map(|(name, contents)| (folder.join(name), contents)));
        }
        let cameras = self.cameras.iter();
        files.extend(cameras.map(|(path, contents)| (path.clone(), contents)));
        let names = files.iter().map(|(path, _)| path.display().to_string());
        let names = names.collect();
        output::write_together(files)?;
        Ok(names)
    }
}

/// The most pixels of all pictures together. A film of this number takes 1.5 GiB of memory while it
/// is made.
const MOST_PIXELS: u64 = 1 << 30;

/// A film whose pictures have too many pixels together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "--turntable {pictures}: with {}x{} these are {} pixels, more than {MOST_PIXELS}",
    size[0],
    size[1],
    pixels(*.pictures, *.size)
)]
struct TooManyPixels {
    pictures: u32,
    size: [u32; 2],
}

fn pixels(pictures: u32, [width, height]: [u32; 2]) -> u64 {
    let one = u64::from(width) * u64::from(height);
    one.saturating_mul(u64::from(pictures))
}

fn check_pixels(pictures: u32, size: [u32; 2]) -> Result<(), TooManyPixels> {
    if pictures > 1 && pixels(pictures, size) > MOST_PIXELS {
        return Err(TooManyPixels { pictures, size });
    }
    Ok(())
}

/// Level ground under the model, with a grid of about a fifth of its size.
fn ground(model: &Model) -> Ground {
    let [low, high] = bounds(model);
    let sides = high - low;
    let size = sides.e1.max(sides.e2).max(sides.e3);
    Ground {
        height: low.e2,
        grid: (size / 5.0).max(f64::MIN_POSITIVE),
    }
}

fn parse_size(text: &str) -> Result<[u32; 2]> {
    let side = |text: &str| text.trim().parse::<u32>().ok().filter(|&side| side > 0);
    let sides = text
        .split_once(['x', 'X', '×'])
        .and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.with_context(|| {
        format!("--size {text}: not two numbers above 0 of the form WxH, such as 1280x720")
    })
}

fn parse_colour(text: &str) -> Result<LinearColour> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let code = Some(digits)
        .filter(|digits| digits.len() == 6 && digits.chars().all(|c| c.is_ascii_hexdigit()))
        .and_then(|digits| u32::from_str_radix(digits, 16).ok());
    let [_, red, green, blue] = code
        .with_context(|| format!("--background {text}: not six hexadecimal digits"))?
        .to_be_bytes();
    Ok(LinearColour::from_srgb([red, green, blue]))
}
