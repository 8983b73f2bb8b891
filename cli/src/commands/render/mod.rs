//! `nullcone render`: pictures and films of a model.

mod arguments;
mod camera;
mod drawing;
mod film;
mod film_arguments;
mod model_file;

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result, bail, ensure};
use ga_character::animated_scene::Moment;
use ga_draw::Colour;
use ga_image::colour::LinearColour;
use ga_render::view_file;
use ga_render::{Shading, Style, Viewpoint, buffer_files};
use serde::Serialize;

pub(crate) use self::arguments::Arguments;
use self::arguments::Light;
use self::camera::Camera;
use self::drawing::Drawing;
use self::film_arguments::Times;
use self::model_file::{ModelFile, Scene};
use crate::chosen_animation::warn_of_times;
use crate::film_file;
use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::part::{self, About};
use crate::standard_output::is_standard_output;

/// The words of the command.
pub(crate) const COMMAND: &str = "render";

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
            Some(document) if self.plays() => {
                let number = self.animation.number(document);
                number.with_context(|| path.display().to_string())?
            }
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
            None => Times::one(time),
        };
        let all = times.count().max(count as usize);
        let pictures = match self.frames {
            Some(frames) => frames.among(all)?,
            None => 0..all,
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
        let drawing = Drawing::new(context.outputs(), &progress);
        let drawing = match (&mut scene, &self.film.file) {
            (Scene::Animated(scene), Some(_)) => {
                let film = film::Film {
                    animation,
                    camera: &camera,
                    times: &times,
                    pictures: pictures.clone(),
                };
                film.draw(drawing, self, scene, &style, format)
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
                let pictures = pictures.clone();
                drawing::draw(drawing, self, model, &views, pictures, &style, format)
            }
        };
        let mut drawing = drawing.with_context(named)?;
        if self.frames.is_some() {
            let is_last = pictures.end == all;
            let inputs = [path.as_path()]
                .into_iter()
                .chain(camera::file(&self.camera));
            let about = About::new(COMMAND, self, inputs, pictures.clone(), is_last)?;
            drawing.add_part(out, about)?;
        }
        warnings.extend(drawing.warnings);
        Ok(Report {
            out: out.display().to_string(),
            width_px: width,
            height_px: height,
            pictures: pictures.len(),
            triangles,
            seconds: begin.elapsed().as_secs_f64(),
            played: played.zip(animation).map(|(played, animation)| Played {
                animation,
                animation_name: played.name.clone(),
                time_seconds: times.at(0),
                duration_seconds: duration,
                frames_per_second: self.film.file.as_ref().map(|_| self.film.rate),
            }),
            files: drawing
                .files
                .iter()
                .map(|path| path.display().to_string())
                .collect(),
            warnings,
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
        let format = film_file::format(&mut files, option, out)?;
        if let Some(frames) = self.frames {
            ensure!(
                option == "--film" || self.turntable > 1,
                "--frames {frames}: one picture has no frames: --film or --turntable is needed"
            );
            ensure!(
                format == Format::Y4m && !is_standard_output(out),
                "--frames {frames}: {option} {}: a part of a film must be a .y4m file, which alone \
                 can be joined without loss: nullcone merge writes the whole",
                out.display()
            );
            files.write(option, &part::beside(out), &[Format::Json])?;
        }
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
}

fn parse_colour(text: &str) -> Result<LinearColour> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let colour: Colour = format!("#{digits}")
        .parse()
        .ok()
        .with_context(|| format!("--background {text}: not six hexadecimal digits"))?;
    Ok(LinearColour::from_srgb(colour.0))
}
