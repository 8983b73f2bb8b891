//! `nullcone body dots`: the joints of a character in films, by the dots on its skin.

mod arguments;
mod films;
mod found;
mod report;

pub(crate) use arguments::Arguments;

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result, bail};
use ga_body::format::{JointView, JointViews};
use rayon::prelude::*;

use crate::files::expanded;
use crate::format::Format;
use crate::frame::{Command, Context};
use crate::person::ViewCamera;
use films::Films;
use found::{Found, View};
use report::Report;

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = Self {
            films: expanded("FILM", &self.films)?,
            ..self.clone()
        };
        arguments.find(context)
    }
}

impl Arguments {
    fn find(&self, context: &Context) -> Result<Report> {
        let films = self.films.iter().chain(self.cameras.path());
        let inputs = films.map(PathBuf::as_path).chain(self.character.path());
        let mut files = context.files(inputs)?;
        files.write("--out", &self.out, &[Format::Json])?;
        let progress = context.progress(3);
        progress.step("reading");
        let mut films = Films::open(&self.films)?;
        let names: Vec<String> = films.all.iter().map(|film| film.name.clone()).collect();
        let views = self.views(&films, &names)?;
        let body = self.character.read()?.into_body()?;
        progress.step("finding dots");
        let begin = Instant::now();
        let mut found: Vec<Found> = Vec::new();
        loop {
            // So many are in memory at a time. Some take longer than others.
            let frames = films.next(2 * rayon::current_num_threads())?;
            if frames.is_empty() {
                break;
            }
            found.par_extend(frames.into_par_iter().map(|pictures| {
                let seen = views.par_iter().zip(pictures);
                let dots = seen.map(|(view, picture)| view.dots(&picture));
                Found::new(&body, &views, dots.collect())
            }));
            let count = films.frames().unwrap_or(found.len());
            progress.at(found.len() as u64, count.max(found.len()) as u64);
        }
        let seconds = begin.elapsed().as_secs_f64();
        let is_none = found.iter().all(|frame| frame.fit.is_err());
        if is_none
            && let Some(Found {
                fit: Err(error), ..
            }) = found.first()
        {
            let films = self.films.iter().map(|path| path.display().to_string());
            bail!(
                "{}: the body is not recognised in any of {} frames; in the first, {}",
                films.collect::<Vec<_>>().join(", "),
                found.len(),
                report::reason(error, &names)
            );
        }
        progress.step("writing");
        let skeleton = body.model().skeleton();
        let joints: Vec<String> = skeleton.joints().iter().map(|j| j.name.clone()).collect();
        let of_view = |(view, name): (usize, &String)| JointView {
            name: name.clone(),
            frames: found
                .iter()
                .map(|frame| match &frame.fit {
                    Ok(fit) => fit.joints[view].clone(),
                    Err(_) => vec![None; joints.len()],
                })
                .collect(),
        };
        let pixels = names.iter().enumerate().map(of_view).collect();
        let pixels = JointViews::new(joints, films.rate(), pixels)?;
        context.outputs().write(&self.out, pixels.encode())?;
        drop(progress);
        Ok(Report::new(self, &films, &pixels, &found, seconds))
    }

    /// The cameras of the films.
    fn views(&self, films: &Films, names: &[String]) -> Result<Vec<View>> {
        let cameras = self.cameras.read(names)?;
        let views = films.all.iter().zip(cameras).map(|(film, camera)| {
            let [width, height] = film.size();
            let scale = camera.scale([width, height]).with_context(|| {
                let [columns, rows] = camera.size.unwrap_or_default();
                format!(
                    "{}: the film has {width} × {height} pixels, which is another shape than the \
                     {columns} × {rows} of the camera of the view {}",
                    film.path.display(),
                    film.name
                )
            })?;
            let ViewCamera { camera, .. } = camera;
            Ok(View { camera, scale })
        });
        views.collect()
    }
}
