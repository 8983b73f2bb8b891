//! What can be wrong with a motion.

use super::model::{Motion, MotionFilm};

/// The farthest place from the origin along an axis, in metres. Tenths of millimetres of it fit
/// into 32 bits.
const FARTHEST: f64 = 1e5;

/// Why a [`Motion`] cannot be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// The number of frames in a second is not a positive number.
    #[error("{0} frames per second: this must be a positive number")]
    FramesPerSecond(f64),
    /// No frame has a pose, or the poses have no points.
    #[error("no frame has a pose with points, so that there is nothing to show")]
    NoPose,
    /// A pose has more or fewer points than there are names.
    #[error("frame {frame} has {points} points, but there are {names} names of points")]
    Points {
        /// The frame.
        frame: usize,
        /// The number of its points.
        points: usize,
        /// The number of names.
        names: usize,
    },
    /// A coordinate is not a number, or is far beyond what can be shown.
    #[error("{element} has the coordinate {value}, which must be a number from -1e5 to 1e5 metres")]
    Coordinate {
        /// What has the coordinate.
        element: String,
        /// The coordinate.
        value: f64,
    },
    /// A bone ends at a point that does not exist.
    #[error("bone {bone} ends at point {point}, but there are {points} points")]
    Bone {
        /// The index of the bone.
        bone: usize,
        /// The index of the point.
        point: usize,
        /// The number of points.
        points: usize,
    },
    /// A film is wrong.
    #[error("film `{name}`: {problem}")]
    Film {
        /// The name of the film.
        name: String,
        /// What is wrong.
        problem: FilmProblem,
    },
}

/// Why a [`MotionFilm`] cannot be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FilmProblem {
    /// Its pictures have no width or no height.
    #[error("its pictures are {0} by {1} pixels, but need a width and a height")]
    Size(u32, u32),
    /// A picture is shown at no frame, at frames that the motion does not have, or at or before a
    /// frame of the picture before it.
    #[error(
        "picture {picture} is shown from frame {start} until before {end}; this must begin at frame \
         {from} or later, and end after its beginning and until {until} at the latest"
    )]
    Frames {
        /// The index of the picture.
        picture: usize,
        /// Its first frame.
        start: usize,
        /// The frame after its last one.
        end: usize,
        /// The first frame that is allowed.
        from: usize,
        /// The number of frames of the motion.
        until: usize,
    },
}

/// Finds what is wrong with a motion.
pub(super) fn check(motion: &Motion) -> Result<(), MotionError> {
    let rate = motion.frames_per_second;
    if !(rate.is_finite() && rate > 0.0) {
        return Err(MotionError::FramesPerSecond(rate));
    }
    let names = motion.names.len();
    for (frame, pose) in poses(motion) {
        if pose.len() != names {
            return Err(MotionError::Points {
                frame,
                points: pose.len(),
                names,
            });
        }
        for (place, name) in pose.iter().zip(&motion.names) {
            check_place(place, || format!("the point `{name}` of frame {frame}"))?;
        }
    }
    if names == 0 || poses(motion).next().is_none() {
        return Err(MotionError::NoPose);
    }
    for (bone, ends) in motion.bones.iter().map(|bone| bone.ends).enumerate() {
        if let Some(&point) = ends.iter().find(|&&end| end >= names) {
            return Err(MotionError::Bone {
                bone,
                point,
                points: names,
            });
        }
    }
    if let Some(height) = motion.floor {
        check_place(&[height], || "the floor".to_owned())?;
    }
    for camera in &motion.cameras {
        for place in [camera.centre].iter().chain(&camera.corners) {
            check_place(place, || format!("the camera `{}`", camera.name))?;
        }
    }
    for film in &motion.films {
        check_film(film, motion.frames.len()).map_err(|problem| MotionError::Film {
            name: film.name.clone(),
            problem,
        })?;
    }
    Ok(())
}

/// The poses that are known, with their frames.
pub(super) fn poses(motion: &Motion) -> impl Iterator<Item = (usize, &[[f64; 3]])> {
    let frames = motion.frames.iter().enumerate();
    frames.filter_map(|(frame, pose)| Some((frame, pose.as_deref()?)))
}

fn check_place(place: &[f64], element: impl Fn() -> String) -> Result<(), MotionError> {
    match place.iter().find(|x| x.is_nan() || x.abs() > FARTHEST) {
        Some(&value) => Err(MotionError::Coordinate {
            element: element(),
            value,
        }),
        None => Ok(()),
    }
}

fn check_film(film: &MotionFilm, until: usize) -> Result<(), FilmProblem> {
    let [width, height] = film.size;
    if width == 0 || height == 0 {
        return Err(FilmProblem::Size(width, height));
    }
    let mut from = 0;
    for (picture, frames) in film
        .pictures
        .iter()
        .map(|picture| &picture.frames)
        .enumerate()
    {
        if frames.start < from || frames.is_empty() || frames.end > until {
            return Err(FilmProblem::Frames {
                picture,
                start: frames.start,
                end: frames.end,
                from,
                until,
            });
        }
        from = frames.end;
    }
    Ok(())
}
