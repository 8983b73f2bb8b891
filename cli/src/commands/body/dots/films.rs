//! The films of the views, read in step.

use std::path::PathBuf;

use anyhow::{Result, ensure};
use ga_files::is_same_file;
use ga_image::plane::Plane;
use ga_video::{Frame, Source};

use crate::frame::Warning;
use crate::person::{is_other_rate, stated_rate};

/// The film of a view.
pub(super) struct Film {
    pub(super) path: PathBuf,
    /// The name of the view.
    pub(super) name: String,
    source: Box<dyn Source + Send>,
}

impl Film {
    /// Columns and rows.
    pub(super) fn size(&self) -> [usize; 2] {
        self.source.properties().size
    }

    fn read(&mut self) -> Result<Option<Plane<[u8; 3]>>> {
        let mut frame = Frame::default();
        let is_read = self.source.read(&mut frame)?;
        let colours = self.source.properties().colours;
        Ok(is_read.then(|| frame.to_rgb(colours)))
    }
}

/// The films of all views.
pub(super) struct Films {
    pub(super) all: Vec<Film>,
    /// How many frames were read of each.
    read: usize,
    /// What was said of their lengths.
    pub(super) ended: Option<Warning>,
}

impl Films {
    pub(super) fn open(paths: &[PathBuf]) -> Result<Self> {
        ensure!(
            paths.len() > 1,
            "FILM {}: there is 1 film, and the films of two views or more are needed",
            paths.first().cloned().unwrap_or_default().display()
        );
        let mut all: Vec<Film> = Vec::with_capacity(paths.len());
        for path in paths {
            let is_new = all.iter().all(|film| !is_same_file(&film.path, path));
            ensure!(
                is_new,
                "FILM {}: the film is given twice, and each view has its own",
                path.display()
            );
            let source = ga_video::open_with_stills(path)?;
            let mut name = ga_files::stem(path);
            if all.iter().any(|film| film.name == name) {
                name = path.display().to_string();
            }
            all.push(Film {
                path: path.clone(),
                name,
                source,
            });
        }
        Ok(Self {
            all,
            read: 0,
            ended: None,
        })
    }

    /// The number of frames, where the files tell it.
    pub(super) fn frames(&self) -> Option<usize> {
        let counts = self
            .all
            .iter()
            .map(|film| film.source.properties().frame_count);
        counts.flatten().min()
    }

    /// Frames in a second: of the first film that states it.
    pub(super) fn rate(&self) -> Option<f64> {
        let rates = self.all.iter().map(|film| film.source.properties());
        rates.filter_map(stated_rate).next()
    }

    /// The films that do not agree with this rate.
    pub(super) fn other_rates(&self) -> Vec<Warning> {
        let Some(rate) = self.rate() else {
            return Vec::new();
        };
        let others = self.all.iter().filter_map(|film| {
            let own = stated_rate(film.source.properties())?;
            is_other_rate(own, rate).then(|| {
                let message = format!(
                    "the film has {own:.2} frames in a second, and the first {rate:.2}: frames of \
                     equal numbers are taken for one time"
                );
                let view = Some(film.name.clone());
                let warning = Warning::new("film_rate", message).in_file(&film.path);
                Warning { view, ..warning }
            })
        });
        others.collect()
    }

    /// The next frames of all films, at most so many: for each the pictures of the views. None
    /// are left where a film has ended.
    pub(super) fn next(&mut self, count: usize) -> Result<Vec<Vec<Plane<[u8; 3]>>>> {
        let mut frames = Vec::with_capacity(count);
        while frames.len() < count && self.ended.is_none() {
            let pictures = self.all.iter_mut().map(Film::read);
            let pictures: Vec<Option<_>> = pictures.collect::<Result<_>>()?;
            let (ended, going_on) = (
                pictures.iter().position(Option::is_none),
                pictures.iter().position(Option::is_some),
            );
            match (ended, going_on) {
                (None, _) => frames.push(pictures.into_iter().flatten().collect()),
                (Some(_), None) => break,
                (Some(ended), Some(other)) => self.ended = Some(self.shorter(ended, other)),
            }
            self.read += 1;
        }
        Ok(frames)
    }

    /// Says that a film ends before another.
    fn shorter(&self, ended: usize, other: usize) -> Warning {
        let [ended, other] = [ended, other].map(|index| &self.all[index]);
        let message = format!(
            "the film has {} frames, and that of the view {} has more, which are left out",
            self.read, other.name
        );
        let warning = Warning::new("film_length", message).in_file(&ended.path);
        Warning {
            view: Some(ended.name.clone()),
            frame: Some(self.read),
            ..warning
        }
    }
}
