//! Pictures of a model that does not move.

use std::ops::Range;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_camera::format::json;
use ga_image::film::Rate;
use ga_image::plane::Plane;
use ga_image::png;
use ga_render::model::{self, Model};
use ga_render::view_file::{self, ViewFiles};
use ga_render::{Buffers, Ground, Style, View, buffer_files, render};

use super::arguments::Arguments;
use crate::film_file::Film;
use crate::format::Format;
use crate::frame::{Progress, Warning};
use crate::output::Staging;
use crate::part::{self, About, FilmPart, Part};

/// Files that were written, the picture or film first.
pub(super) struct Drawing<'a> {
    outputs: &'a Staging,
    pub(super) progress: &'a Progress,
    pub(super) files: Vec<PathBuf>,
    pub(super) warnings: Vec<Warning>,
    /// How many bytes the film has.
    pub(super) film_bytes: usize,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(outputs: &'a Staging, progress: &'a Progress) -> Self {
        Self {
            outputs,
            progress,
            files: Vec::new(),
            warnings: Vec::new(),
            film_bytes: 0,
        }
    }

    fn add(&mut self, path: PathBuf, contents: &[u8]) -> Result<()> {
        self.outputs.write(&path, contents)?;
        self.files.push(path);
        Ok(())
    }

    /// Adds a film of these pictures, which a function makes one after another.
    pub(super) fn add_film(
        &mut self,
        path: &Path,
        format: Format,
        style: &Style,
        pictures: Range<usize>,
        rate: f64,
        mut picture: impl FnMut(usize) -> Result<Plane<[u8; 3]>>,
    ) -> Result<()> {
        let film = Film {
            path,
            format,
            size: [style.width, style.height],
            frames: pictures.len(),
            rate: Rate::new(rate).context("the rate is not above 0")?,
        };
        self.film_bytes = film.write(self.outputs, |show| {
            (pictures.clone()).try_for_each(|frame| show(&picture(frame)?))
        })?;
        self.warnings.extend(film.warning());
        self.files.push(path.to_path_buf());
        Ok(())
    }

    /// Adds the description of the part of a film.
    pub(super) fn add_part(&mut self, film: &Path, about: About) -> Result<()> {
        let path = part::beside(film);
        let part = Part::new(about, FilmPart::new(film, self.film_bytes));
        part.write(&path, self.outputs)?;
        self.files.push(path);
        Ok(())
    }

    /// Adds the file of the camera of a view, where it is asked for.
    pub(super) fn add_camera(
        &mut self,
        arguments: &Arguments,
        view: &View,
        style: &Style,
    ) -> Result<()> {
        let Some(path) = &arguments.camera_out else {
            return Ok(());
        };
        let camera = view_file::to_camera("camera", view, [style.width, style.height])?;
        self.add(path.clone(), json::encode(&camera)?.as_bytes())
    }
}

/// The rate of the film of a turntable.
const TURNTABLE_RATE: f64 = 25.0;

/// Draws a model as these views see it.
pub(super) fn draw<'a>(
    mut drawing: Drawing<'a>,
    arguments: &Arguments,
    model: &Model,
    views: &[View],
    pictures: Range<usize>,
    style: &Style,
    format: Format,
) -> Result<Drawing<'a>> {
    let progress = drawing.progress;
    let options = model::Options {
        edges: arguments.wireframe,
        ground: arguments.ground.then(|| Ground::under(model.bounds())),
    };
    let out = arguments.out.clone().unwrap_or_default();
    let mut pictures_with_views = arguments.views.as_deref().map(ViewFiles::new);
    progress.step("drawing");
    model.with_scene(options, |scene| {
        let mut picture = |number: usize| {
            let picture = render(scene, &views[number], style)?.colour;
            if let Some(files) = &mut pictures_with_views {
                files.add(&picture, &views[number])?;
            }
            progress.at(number as u64 + 1, views.len() as u64);
            anyhow::Ok(picture)
        };
        match format {
            Format::Png if views.len() == 1 => drawing.add(out, &png::encode(&picture(0)?)?)?,
            _ => drawing.add_film(&out, format, style, pictures, TURNTABLE_RATE, picture)?,
        }
        if let (Some(folder), [first, ..]) = (&arguments.buffers, views) {
            let buffers = Buffers::new(scene, first, style.width, style.height)?;
            let encoded = buffer_files::encode(&buffers).context("--buffers")?;
            for (name, contents) in encoded {
                drawing.add(folder.join(name), &contents)?;
            }
        }
        for (path, contents) in pictures_with_views.map_or(Ok(Vec::new()), ViewFiles::finish)? {
            drawing.add(path, &contents)?;
        }
        if let [first, ..] = views {
            drawing.add_camera(arguments, first, style)?;
        }
        Ok(drawing)
    })
}
