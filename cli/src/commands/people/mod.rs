//! `nullcone people`: from films of a person, with joints, to an animated character.

mod arguments;
mod drawing;
mod figure;
mod films;
mod overlay;
mod page;
mod report;
mod tables;

pub(crate) use arguments::Arguments;

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_anim::clip::Clip;
use ga_anim::motion_file::{Format as MotionFormat, WriteOptions, Written};
use ga_anim::recording::Recording;
use ga_body::character::{CharacterFit, FittedCharacter};
use ga_body::format::JointViews;
use ga_body::ground::GroundOptions;
use ga_body::registration::RegistrationOptions;
use ga_mesh::gltf;

use crate::files::{Files, expanded};
use crate::frame::{Command, Context, Progress, Verdict, Warning};
use crate::motion_file::lost;
use crate::person::{CharacterFile, FitLengths, ViewCamera};
use crate::person::{judged, noted};
use drawing::{Drawn, Task};
use figure::Figure;
use films::ViewFilm;
use overlay::Overlay;
use page::Contents;
use report::Report;

/// What the names of films with the body over them begin with.
const OVERLAY: &str = "overlay-";

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = Self {
            films: expanded("FILM", &self.films)?,
            joints: self.joints.expanded()?,
            ..self.clone()
        };
        arguments.make(context)
    }
}

impl Arguments {
    fn make(&self, context: &Context) -> Result<Report> {
        let character = CharacterFile(&self.character);
        let mut files = self.files(&character, context)?;
        let progress = context.progress(5 + self.films.len() as u64);
        progress.step("reading");
        let joints = self.joints.read()?;
        let cameras = self.cameras.read(&joints.view_names())?;
        let mut films = films::open(&self.films, joints.views())?;
        let outputs = self.overlays(&joints, &films);
        let names = outputs.iter().filter_map(|path| path.file_name());
        files.write_folder("--out", &self.out, names)?;
        for (film, path) in films.iter_mut().zip(&outputs) {
            film.overlay = Some(path.clone());
        }
        let only = self.overlay_of.as_deref();
        let only = only.map(|name| number_of(name, &joints, films.len()));
        let only = only.transpose()?;
        let of_film = films.iter().find_map(ViewFilm::rate);
        let rate = self.joints.rate(&joints, of_film)?;
        let stated = (!self.joints.has_rate()).then_some(rate);
        let of_films = films::doubts(&films, &joints, &cameras, stated);

        let fitted = self.fit(&character, &joints, &cameras, rate, &progress)?;
        let (verdict, mut warnings) = judged(&fitted.findings);
        let verdict = match verdict {
            Verdict::Good if !of_films.is_empty() => Verdict::Doubtful,
            verdict => verdict,
        };
        warnings.extend(of_films);
        warnings.extend(joints.notes().iter().map(noted));
        warnings.extend(without_film(&joints, &films));
        warnings.extend(left_over(&self.out, &outputs));

        progress.step("making the character");
        let figure = Figure::new(&fitted)?;
        let motion = self.motion(&fitted, &mut warnings)?;
        let known = films.iter().map(|film| (film.path.clone(), film.frames));
        let known: Vec<(PathBuf, usize)> = known.collect();
        let sizes = cameras.iter().enumerate().map(|(view, camera)| {
            let of_film = films.get(view).map(|film| film.size);
            camera.size.or(of_film)
        });
        let sizes: Vec<Option<[usize; 2]>> = sizes.collect();
        if let Some(view) = only {
            let films = films.into_iter().enumerate().skip(view).take(1);
            let drawn = self.draw(films, &figure, &fitted, &sizes, context, &progress)?;
            warnings.extend(drawn.into_iter().filter_map(|drawn| drawn.warning));
            let written = &outputs[view..=view];
            let mut report =
                Report::new(&self.character, &self.out, fitted.report, &known, written);
            (report.verdict, report.warnings) = (verdict, warnings);
            report.is_of_view = true;
            return Ok(report);
        }
        let tables = [
            (report::CSV, tables::csv(&figure, rate)),
            (report::TRC, tables::trc(&figure, rate, report::TRC)),
        ];
        let tables = tables.map(|(name, text)| (self.out.join(name), text.into_bytes()));
        let files: Vec<(PathBuf, Vec<u8>)> = motion.into_iter().chain(tables).collect();
        let mut written: Vec<PathBuf> = files.iter().map(|(path, _)| path.clone()).collect();
        context.outputs().write_all(&files)?;
        let films = films.into_iter().enumerate();
        let drawn = self.draw(films, &figure, &fitted, &sizes, context, &progress)?;
        written.extend(outputs);
        written.extend([report::PAGE, report::JSON].map(|name| self.out.join(name)));
        warnings.extend(drawn.iter().filter_map(|drawn| drawn.warning.clone()));

        progress.step("writing");
        let page = page::page(Contents {
            title: &context.title(),
            command: (!context.is_recording()).then(|| context.line()),
            verdict: verdict.with_files(),
            warnings: &warnings,
            figure: &figure,
            fitted: &fitted,
            sizes: &sizes,
            films: drawn,
        })?;
        let mut report = Report::new(&self.character, &self.out, fitted.report, &known, &written);
        if context.is_recording() {
            report.milliseconds_per_frame = None;
        }
        (report.verdict, report.warnings) = (verdict, warnings);
        report.page = Some(page);
        Ok(report)
    }

    /// The files that are read, and those of the folder that are always written.
    fn files(&self, character: &CharacterFile<'_>, context: &Context) -> Result<Files> {
        let inputs = self.joints.paths().iter().chain(self.cameras.path());
        let mut files = context
            .files(inputs.chain(&self.films))?
            .and_reading(character.path());
        let names = [
            report::CHARACTER,
            report::MOTION,
            report::CSV,
            report::TRC,
            report::PAGE,
            report::JSON,
        ];
        // --report may name the page of the folder, which is the same.
        let is_page = |name: &str| name == report::PAGE && files.writes(&self.out.join(name));
        let names: Vec<&str> = names.into_iter().filter(|name| !is_page(name)).collect();
        files.write_folder("--out", &self.out, names)?;
        Ok(files)
    }

    /// Where the films with the body over them are written.
    fn overlays(&self, joints: &JointViews, films: &[ViewFilm]) -> Vec<PathBuf> {
        if self.no_overlay {
            return Vec::new();
        }
        let mut names: Vec<String> = Vec::new();
        for view in joints.views().iter().take(films.len()) {
            let safe = file_name(&view.name);
            let mut name = safe.clone();
            let mut number = 2;
            while names.iter().any(|other| other.eq_ignore_ascii_case(&name)) {
                name = format!("{safe}-{number}");
                number += 1;
            }
            names.push(name);
        }
        let ending = drawing::FORMAT.endings()[0];
        let names = names.iter();
        names
            .map(|name| self.out.join(format!("{OVERLAY}{name}.{ending}")))
            .collect()
    }

    fn fit(
        &self,
        character: &CharacterFile<'_>,
        joints: &JointViews,
        cameras: &[ViewCamera],
        rate: f64,
        progress: &Progress,
    ) -> Result<FittedCharacter> {
        let of_joints = || self.joints.names();
        let cameras: Vec<_> = cameras.iter().map(|view| view.camera).collect();
        let default = match cameras.len() {
            1 => FitLengths::None,
            _ => FitLengths::Bones,
        };
        let lengths = self.fit_lengths.unwrap_or(default);
        let ground = GroundOptions {
            up: self.up,
            floor: self.floor,
            has_upright_axis: self.cameras.has_world(),
        };
        let options = RegistrationOptions::default();
        progress.step("finding how the views belong together");
        let fit = CharacterFit::new(character.read()?, joints, &cameras);
        let fit = fit.with_context(of_joints)?.with_lengths(lengths.into());
        let fit = match self.cameras.has_world() {
            true => fit.with_board_poses(),
            false => fit,
        };
        let fit = fit.registered(&options, self.refine_cameras, self.synchronise);
        progress.step("fitting poses");
        let done = |done, of| progress.at(done as u64, of as u64);
        let fitted = fit.with_ground(ground).fit(rate, false, done);
        fitted.with_context(of_joints)
    }

    /// The files of the character and its motion.
    fn motion(
        &self,
        fitted: &FittedCharacter,
        warnings: &mut Vec<Warning>,
    ) -> Result<[(PathBuf, Vec<u8>); 2]> {
        let [model, motion] = [report::CHARACTER, report::MOTION].map(|name| self.out.join(name));
        let of_character = || self.character.display().to_string();
        let document = fitted.to_document("fitted");
        let (document, losses) = document.with_context(of_character)?;
        warnings.extend(losses.iter().map(|loss| lost(loss, &model)));
        let document = document.relocated(&self.character, &model)?;
        let contents = gltf::encode(&document).context("the fitted character cannot be written")?;

        let poses = fitted.poses.iter().map(|fit| fit.pose.clone()).collect();
        let clip = Clip::new(1.0 / fitted.report.frames_per_second, poses)?;
        let recording = Recording::from_clip(fitted.character.skeleton(), &clip);
        let recording = recording.with_context(of_character)?;
        let options = WriteOptions::default();
        let written = Written::new(&recording, MotionFormat::Bvh, &options, |_, _| ());
        let written = written.with_context(of_character)?;
        warnings.extend(written.losses.iter().map(|loss| lost(loss, &motion)));
        Ok([(model, contents), (motion, written.encode()?)])
    }

    /// Draws films, each with the number of its view, one after the other.
    fn draw(
        &self,
        films: impl ExactSizeIterator<Item = (usize, ViewFilm)>,
        figure: &Figure,
        fitted: &FittedCharacter,
        sizes: &[Option<[usize; 2]>],
        context: &Context,
        progress: &Progress,
    ) -> Result<Vec<Drawn>> {
        let count = films.len();
        let views = &fitted.report.per_view;
        let drawn = films.map(|(view, film)| {
            let found = &views[view];
            progress.step("drawing over films");
            let offset = match self.synchronise {
                true => found.offset_frames.unwrap_or(0.0),
                false => 0.0,
            };
            let overlay = Overlay {
                figure,
                fitted,
                view,
                size: sizes[view].unwrap_or(film.size),
                offset,
            };
            let task = Task {
                film,
                overlay,
                name: found.name.clone(),
                rate: fitted.report.frames_per_second,
                films: count,
            };
            task.draw(context.outputs(), progress)
        });
        drawn.collect()
    }
}

/// The number of a view with a film.
fn number_of(name: &str, joints: &JointViews, films: usize) -> Result<usize> {
    let mut views = joints.views().iter().take(films);
    let number = views.position(|view| view.name == name);
    number.with_context(|| {
        let known = joints.views().iter().take(films);
        let known: Vec<&str> = known.map(|view| view.name.as_str()).collect();
        format!(
            "--overlay-of {name}: no view with a film has this name, but: {}",
            known.join(", ")
        )
    })
}

/// Says which views have no film, where others have one.
fn without_film(joints: &JointViews, films: &[ViewFilm]) -> Vec<Warning> {
    let without = joints.views().iter().skip(films.len());
    let without = without.filter(|_| !films.is_empty());
    let warnings = without.map(|view| {
        let message = format!("the view {} has no film, and is not drawn over", view.name);
        Warning {
            view: Some(view.name.clone()),
            ..Warning::new("no_film", message).into_note()
        }
    });
    warnings.collect()
}

/// Says which films with a body over them the folder has that are not written, but are those of an
/// earlier run.
fn left_over(folder: &Path, written: &[PathBuf]) -> Option<Warning> {
    let is_written = |name: &str| written.iter().any(|path| path.ends_with(name));
    let names = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let names = names.filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<String> = names
        .filter(|name| name.starts_with(OVERLAY) && !is_written(name))
        .filter(|name| [".y4m", ".mp4"].iter().any(|ending| name.ends_with(ending)))
        .collect();
    names.sort_unstable();
    let message = match names.as_slice() {
        [] => return None,
        [name] => format!("{name} is of an earlier run and does not show this result"),
        names => format!(
            "{} are of an earlier run and do not show this result",
            names.join(", ")
        ),
    };
    Some(Warning::new("earlier_films", message).in_file(folder))
}

/// The name of a view as that of a file.
fn file_name(view: &str) -> String {
    let safe = |letter: char| match letter {
        letter if letter.is_alphanumeric() || "-_.".contains(letter) => letter,
        _ => '_',
    };
    view.chars().map(safe).collect()
}
