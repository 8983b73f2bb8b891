//! The films of the views.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail, ensure};
use ga_body::format::{JointView, JointViews};
use ga_video::{Frame, Properties, Source};

use crate::frame::Warning;
use crate::person::{ViewCamera, is_other_rate, stated_rate};
use crate::standard_output::is_dash;

/// The film of a view, before its first frame is read.
pub(super) struct ViewFilm {
    pub(super) path: PathBuf,
    pub(super) source: Box<dyn Source + Send>,
    pub(super) size: [usize; 2],
    pub(super) frames: usize,
    /// Where the film with the body over it is written.
    pub(super) overlay: Option<PathBuf>,
}

impl ViewFilm {
    /// Frames in a second, where the film states it.
    pub(super) fn rate(&self) -> Option<f64> {
        stated_rate(self.source.properties())
    }
}

/// Opens the films of the first views of the joints.
pub(super) fn open(paths: &[PathBuf], views: &[JointView]) -> Result<Vec<ViewFilm>> {
    if let Some(more) = paths.get(views.len()) {
        bail!(
            "FILM {}: there are {} films, and the joints are in {} views: each view has one film",
            more.display(),
            paths.len(),
            views.len()
        );
    }
    paths.iter().map(|path| open_one(path)).collect()
}

fn open_one(path: &Path) -> Result<ViewFilm> {
    let shown = path.display();
    let source = ga_video::open(path)?;
    let Properties {
        size, frame_count, ..
    } = *source.properties();
    let frames = match frame_count {
        Some(frames) => frames,
        None if is_dash(path) || ga_files::is_stream(path) => {
            bail!("FILM {shown}: a film is read from a file, not from a stream")
        }
        None => count(path)?,
    };
    ensure!(frames > 0, "{shown}: the film has no frames");
    Ok(ViewFilm {
        path: path.to_owned(),
        source,
        size,
        frames,
        overlay: None,
    })
}

/// The number of frames of a film whose file does not tell it.
fn count(path: &Path) -> Result<usize> {
    let (mut source, mut frame) = (ga_video::open(path)?, Frame::default());
    let mut count = 0;
    while source.read(&mut frame)? {
        count += 1;
    }
    Ok(count)
}

/// What of the films does not fit to the joints and the cameras. `rate` is the number of frames in
/// a second, where the films should agree with it.
pub(super) fn doubts(
    films: &[ViewFilm],
    joints: &JointViews,
    cameras: &[ViewCamera],
    rate: Option<f64>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for ((film, view), camera) in films.iter().zip(joints.views()).zip(cameras) {
        let [width, height] = film.size;
        let mut doubt = |kind, message: String| {
            warnings.push(Warning {
                view: Some(view.name.clone()),
                ..Warning::new(kind, message).in_file(&film.path)
            });
        };
        if film.frames != joints.frame_count() {
            let message = format!(
                "the film has {} frames, and the joints of the view {} are in {}: frame 0 is taken \
                 for the same time in both",
                film.frames,
                view.name,
                joints.frame_count()
            );
            doubt("film_length", message);
        }
        if let (Some(own), Some(rate)) = (film.rate(), rate)
            && is_other_rate(own, rate)
        {
            let message = format!(
                "the film has {own:.2} frames in a second, and the joints are taken for {rate:.2}; \
                 --fps says which is right"
            );
            doubt("film_rate", message);
        }
        if let Some(size) = camera.size.filter(|_| camera.scale(film.size).is_none()) {
            let message = format!(
                "the film has {width} × {height} pixels, which is another shape than the {} × {} \
                 of the camera of the view {}",
                size[0], size[1], view.name
            );
            doubt("film_size", message);
        }
        let reference = camera.size.unwrap_or(film.size);
        let (outside, all) = outside(view, reference);
        if 2 * outside > all {
            let message = format!(
                "{outside} of {all} joints of the view {} lie outside of {} × {} pixels: is this \
                 the film of the view, in the size of its camera?",
                view.name, reference[0], reference[1]
            );
            doubt("film_size", message);
        }
    }
    warnings
}

/// How many of the joints of a view lie outside of pictures of a size, and how many there are.
fn outside(view: &JointView, size: [usize; 2]) -> (usize, usize) {
    let seen = || view.frames.iter().flatten().flatten();
    let is_outside = |position: [f64; 2]| {
        let sides = position.iter().zip(size);
        sides
            .into_iter()
            .any(|(place, side)| *place < -0.5 || *place > side as f64 - 0.5)
    };
    let outside = seen().filter(|pixel| is_outside(pixel.position)).count();
    (outside, seen().count())
}
