//! `nullcone render`: a picture of a model.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_camera::format::json;
use ga_draw::Colour;
use ga_image::colour::LinearColour;
use ga_image::{frames, png, y4m};
use ga_mesh::gltf;
use ga_render::model::{self, Model};
use ga_render::view_file::{self, ViewFiles};
use ga_render::{Buffers, Shading, Style, View, Viewpoint, ViewpointError, buffer_files, render};
use serde::Serialize;

use crate::camera_file;
use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::mesh_file;
use crate::output;

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

/// The most pictures of a turntable.
const MOST_PICTURES: u32 = 1000;

/// The most pixels of all pictures together. A film of this number takes 1.5 GiB of memory while it
/// is made.
const MOST_PIXELS: u64 = 1 << 30;

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
        let (viewpoint, own_size) = viewpoint(&arguments.camera, arguments.view.as_deref())?;
        let asked_size = arguments.size.as_deref().map(parse_size).transpose()?;
        let [width, height] = match (own_size, asked_size) {
            (Some(own), Some(asked)) if own != asked => bail!(
                "--size {}x{}: the camera {} is for {}x{}",
                asked[0],
                asked[1],
                arguments.camera,
                own[0],
                own[1]
            ),
            (None, None) if matches!(viewpoint, Viewpoint::View(_)) => bail!(
                "{}: the file does not say how large its pictures are: --size WxH is needed",
                arguments.camera
            ),
            (own, asked) => own.or(asked).unwrap_or(DEFAULT_SIZE),
        };
        let count = arguments.turntable;
        let pixels = (u64::from(width) * u64::from(height)).saturating_mul(count.into());
        ensure!(
            count == 1 || pixels <= MOST_PIXELS,
            "--turntable {count}: with {width}x{height} these are {pixels} pixels, more than \
             {MOST_PIXELS}"
        );
        let mut style = Style {
            width,
            height,
            supersampling: arguments.samples,
            shading: match arguments.shading {
                Light::Lit => Shading::Lit,
                Light::Unlit => Shading::Unlit,
            },
            ..Style::model()
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
        let views = viewpoint.turntable(&model, style.aspect(), count);
        let views = views.with_context(named)?;
        let drawing = draw(&model, &views, &style, arguments, format).with_context(named)?;
        let files = drawing.files.iter();
        let files = files.map(|(path, _)| path.display().to_string()).collect();
        output::write_together(drawing.files)?;
        Ok(Report {
            out: out.display().to_string(),
            width_px: width,
            height_px: height,
            pictures: count,
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

/// Fails where a file cannot be written; else the format of the picture or film.
fn check_files(arguments: &Arguments, context: &Context) -> Result<Format> {
    let camera = camera_path(&arguments.camera);
    let mut files = context.files([arguments.model.as_path()].into_iter().chain(camera))?;
    let format = files.write("--out", &arguments.out, &[Format::Png, Format::Y4m])?;
    if let Some(folder) = &arguments.buffers {
        files.write_folder("--buffers", folder, buffer_files::NAMES)?;
    }
    if let Some(folder) = &arguments.views {
        files.write_folder("--views", folder, view_file::names(arguments.turntable))?;
    }
    files.write_if_given(
        "--camera-out",
        arguments.camera_out.as_ref(),
        &[Format::Json],
    )?;
    Ok(format)
}

/// The path of a file of cameras, where the text is the name of one. Names of viewpoints mean them
/// whatever lies in the folder.
fn camera_path(text: &str) -> Option<&Path> {
    let Err(ViewpointError::Unknown(_)) = text.parse::<Viewpoint>() else {
        return None;
    };
    let path = Path::new(text.trim());
    let is_known = Format::of(path, &[Format::Json, Format::Yaml, Format::Text]).is_some();
    (is_known || path.exists()).then_some(path)
}

/// What `--camera` asks for, and columns and rows of the pictures of a camera of a file.
fn viewpoint(text: &str, name: Option<&str>) -> Result<(Viewpoint, Option<[u32; 2]>)> {
    if let Some(path) = camera_path(text) {
        let camera = camera_file::read_one(path, name)?;
        let view = view_file::from_camera(&camera).with_context(|| path.display().to_string())?;
        let size = camera.size.map(|size| size.map(|side| side as u32));
        return Ok((Viewpoint::View(view), size));
    }
    ensure!(
        name.is_none(),
        "--view chooses a camera of a file, and --camera {text} is none"
    );
    match text.parse() {
        Ok(viewpoint) => Ok((viewpoint, None)),
        Err(ViewpointError::Unknown(_)) => bail!(
            "--camera {text}: not front, side, top, three-quarter, the file of a camera, or of the \
             form \"eye X,Y,Z target X,Y,Z fov DEGREES\""
        ),
        Err(error) => Err(error).context("--camera"),
    }
}

/// The files that are made: paths and contents, the picture or film first.
struct Drawing {
    files: Vec<(PathBuf, Vec<u8>)>,
    /// How long drawing the pictures took.
    time: Duration,
}

fn draw(
    model: &Model,
    views: &[View],
    style: &Style,
    arguments: &Arguments,
    format: Format,
) -> Result<Drawing> {
    let options = model::Options {
        edges: arguments.wireframe,
        ground: arguments.ground,
    };
    let size = [style.width, style.height];
    let mut time = Duration::ZERO;
    let mut pictures_with_views = arguments.views.as_deref().map(ViewFiles::new);
    model.with_scene(options, |scene| {
        let pictures = views.iter().map(|view| {
            let begin = Instant::now();
            let picture = render(scene, view, style)?.colour;
            time += begin.elapsed();
            if let Some(files) = &mut pictures_with_views {
                files.add(&picture, view)?;
            }
            anyhow::Ok(picture)
        });
        let film = frames::encode(pictures, |pictures| match format {
            Format::Y4m => y4m::encode(pictures, y4m::Film::default()),
            _ if pictures.len() == 1 => png::encode(&pictures.next().unwrap_or_default()),
            _ => png::encode_animation(pictures, png::Animation::default()),
        });
        let mut files = vec![(arguments.out.clone(), film??)];
        if let (Some(folder), [first, ..]) = (&arguments.buffers, views) {
            let buffers = Buffers::new(scene, first, style.width, style.height)?;
            let encoded = buffer_files::encode(&buffers)
                .context("--buffers")?
                .into_iter();
            files.extend(encoded.map(|(name, contents)| (folder.join(name), contents)));
        }
        files.extend(pictures_with_views.map_or(Ok(Vec::new()), ViewFiles::finish)?);
        if let (Some(path), [first, ..]) = (&arguments.camera_out, views) {
            let camera = view_file::to_camera("camera", first, size)?;
            files.push((path.clone(), json::encode(&camera)?.into_bytes()));
        }
        Ok(Drawing { files, time })
    })
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
    let colour: Colour = format!("#{digits}")
        .parse()
        .ok()
        .with_context(|| format!("--background {text}: not six hexadecimal digits"))?;
    Ok(LinearColour::from_srgb(colour.0))
}
