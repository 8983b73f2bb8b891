//! The cameras of a rig from pictures of a board.

use ga_camera::Camera;
use ga_camera::format::{CameraFile, NamedCamera};
use ga_image::plane::Plane;
use ga_image::sample::Sample;
use serde::Serialize;

use super::board_view::BoardView;
use super::board_views::{CameraDoubt, RejectedView};
use super::error::{CalibrationError, LEAST_VIEWS};
use super::lens_choice::calibrate_lens;
use super::lens_terms::LensTerms;
use super::many_cameras::{RigCalibration, RigOptions, calibrate_rig, sees};
use super::one_camera::{CameraOptions, Start};
use super::summary::CameraParameters;
use crate::board::{Board, or_reason};
use crate::found_board::FoundBoard;

/// The boards of the pictures of several cameras, frame by frame.
#[derive(Clone, Debug)]
pub struct BoardRig {
    board: Board,
    cameras: Vec<RigCamera>,
    /// The first picture of each frame.
    frames: Vec<String>,
    rejected: Vec<RejectedView>,
}

/// A camera and what its pictures show.
#[derive(Clone, Debug)]
struct RigCamera {
    name: String,
    /// The first picture, and its columns and rows.
    first: Option<(String, [usize; 2])>,
    /// For each frame the board.
    views: Vec<BoardView>,
}

/// The cameras of a rig from pictures of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct RigOfBoards {
    /// The cameras.
    pub rig: RigCalibration,
    /// Their names and the sizes of their pictures.
    pub cameras: Vec<(String, [usize; 2])>,
    /// How many frames show the board to both of two cameras, and, for a camera with itself, to it.
    pub common_boards: Vec<Vec<usize>>,
    /// The first picture of each frame.
    pub frames: Vec<String>,
    /// The pictures in which no board was found, and the frames that do not agree with the others.
    pub rejected: Vec<RejectedView>,
}

/// A camera of a rig, in metres, degrees and pixels.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RigCameraSummary {
    /// Its name.
    pub name: String,
    /// How many of its pictures with a board were used.
    pub boards: usize,
    /// The root mean square distance of their corners from the projections.
    pub rms_px: f64,
    /// The kind of its lens.
    pub lens: &'static str,
    /// Its intrinsic parameters.
    pub camera: CameraParameters,
    /// Its centre in the frame of the first camera: x to the right, y down, z forward.
    pub centre_metres: [f64; 3],
    /// Its distance from the first camera.
    pub distance_metres: f64,
    /// The standard deviation of the distance, 0 for the first camera.
    pub distance_deviation_metres: f64,
    /// The angle between it and the first camera.
    pub rotation_degrees: f64,
}

impl BoardRig {
    /// No frames yet, of cameras with names and a board.
    #[must_use]
    pub fn new(board: Board, cameras: impl IntoIterator<Item = String>) -> Self {
        let camera = |name| RigCamera {
            name,
            first: None,
            views: Vec::new(),
        };
        Self {
            board,
            cameras: cameras.into_iter().map(camera).collect(),
            frames: Vec::new(),
            rejected: Vec::new(),
        }
    }

    /// Looks for the board in the pictures of the next frame, which have names; a camera may have
    /// none.
    ///
    /// Boards that look alike upside down, as those with an even number of columns + rows, begin in
    /// each picture at the point that makes it most like the first one.
    ///
    /// # Errors
    /// [`CalibrationError::PictureSizes`] for a picture of another size than the first of its
    /// camera, and those of [`Board::find`] other than that there is no board.
    pub fn add<T: Sample>(
        &mut self,
        pictures: Vec<Option<(String, Plane<T>)>>,
    ) -> Result<(), CalibrationError> {
        let name = pictures.iter().flatten().next();
        self.frames
            .push(name.map(|(name, _)| name.clone()).unwrap_or_default());
        let mut first: Option<FoundBoard> = None;
        let pictures = pictures.into_iter().chain(std::iter::repeat(None));
        for (camera, picture) in self.cameras.iter_mut().zip(pictures) {
            let mut view = BoardView::default();
            if let Some((picture, pixels)) = picture {
                camera.check_size(&picture, &pixels)?;
                match or_reason(self.board.find(&pixels))? {
                    Ok(board) => {
                        let like = first.get_or_insert_with(|| board.clone());
                        view = board.ordered_like(like).view().clone();
                    }
                    Err(reason) => self.rejected.push(RejectedView { picture, reason }),
                }
            }
            camera.views.push(view);
        }
        Ok(())
    }

    /// The cameras that see the boards, with a lens that is given, or for each camera the likelier
    /// one of a radial–tangential lens and a fisheye.
    ///
    /// # Errors
    /// [`CalibrationError::Picture`] with what is wrong with one camera or frame, by its name,
    /// [`CalibrationError::Unjoined`] for cameras that see no board together with the others, and
    /// as [`calibrate_rig`].
    pub fn calibrate(self, lens: Option<LensTerms>) -> Result<RigOfBoards, CalibrationError> {
        let places = self.board.places();
        let mut options = RigOptions::new(self.cameras.len());
        let mut sizes = Vec::new();
        for (index, camera) in self.cameras.iter().enumerate() {
            let views = camera.views.iter().filter(|view| sees(view));
            let views: Vec<BoardView> = views.cloned().collect();
            let size = camera.first.as_ref().map_or([0; 2], |(_, size)| *size);
            if views.len() < LEAST_VIEWS {
                let error = CalibrationError::TooFewViews { found: views.len() };
                return Err(self.named(error.of_camera(index)));
            }
            let fitted = calibrate_lens(&views, &places, size, lens);
            let fitted = fitted.map_err(|error| self.named(error.of_camera(index)))?;
            sizes.push(size);
            options.cameras[index] = CameraOptions {
                start: Start::Guess(fitted.camera.intrinsics),
                terms: fitted.terms,
            };
        }
        let views: Vec<&[BoardView]> = self.cameras.iter().map(|c| c.views.as_slice()).collect();
        let found = calibrate_rig(&views, &places, &sizes, &options);
        let rig = found.map_err(|error| self.named(error))?;
        let common = |a: &RigCamera, b: &RigCamera| {
            let both = |&&frame: &&usize| ![a, b].iter().any(|c| !sees(&c.views[frame]));
            rig.used.iter().filter(both).count()
        };
        let row = |a| self.cameras.iter().map(|b| common(a, b)).collect();
        let common_boards = self.cameras.iter().map(row).collect();
        let mut rejected = self.rejected;
        rejected.extend(rig.outliers.iter().map(|outlier| RejectedView {
            picture: self.frames[outlier.pair].clone(),
            reason: outlier.to_string(),
        }));
        let names = self.cameras.into_iter().map(|camera| camera.name);
        Ok(RigOfBoards {
            cameras: names.zip(sizes).collect(),
            rig,
            common_boards,
            frames: self.frames,
            rejected,
        })
    }

    /// An error that names cameras and pictures instead of counting them.
    fn named(&self, error: CalibrationError) -> CalibrationError {
        let name = |camera: usize| self.cameras[camera].name.clone();
        match error {
            CalibrationError::OfCamera { camera, error } => CalibrationError::Picture {
                name: name(camera),
                error,
            },
            CalibrationError::Disconnected { cameras } => CalibrationError::Unjoined {
                cameras: cameras.into_iter().map(name).collect(),
            },
            error => match error.view() {
                Some(frame) => CalibrationError::Picture {
                    name: self.frames[frame].clone(),
                    error: Box::new(error),
                },
                None => error,
            },
        }
    }
}

impl RigCamera {
    fn check_size<T: Sample>(
        &mut self,
        name: &str,
        picture: &Plane<T>,
    ) -> Result<(), CalibrationError> {
        let size = [picture.width(), picture.height()];
        let (first, expected) = self.first.get_or_insert_with(|| (name.to_owned(), size));
        match size == *expected {
            true => Ok(()),
            false => Err(CalibrationError::PictureSizes {
                name: name.to_owned(),
                size,
                first: first.clone(),
                expected: *expected,
            }),
        }
    }
}

impl RigOfBoards {
    /// The cameras for a file, with their poses in the frame of the first one.
    #[must_use]
    pub fn file(&self) -> CameraFile {
        let named = self.rig.cameras.iter().zip(&self.cameras);
        let cameras = named.map(|(camera, (name, size))| {
            let mut named = NamedCamera::new(name, camera.intrinsics).with_size(Some(*size));
            named.pose = Some(camera.world_to_camera);
            named
        });
        CameraFile::new(cameras.collect())
    }

    /// Each camera in numbers.
    #[must_use]
    pub fn summary(&self) -> Vec<RigCameraSummary> {
        let rig = &self.rig;
        let cameras = rig.cameras.iter().zip(&self.cameras).enumerate();
        let summary = |(k, (camera, (name, _))): (usize, (&Camera, &(String, _)))| {
            let centre = camera.centre();
            let rotation = camera.world_to_camera.rotor().canonical();
            RigCameraSummary {
                name: name.clone(),
                boards: self.common_boards[k][k],
                rms_px: rig.camera_rms[k],
                lens: camera.intrinsics.lens().model().name(),
                camera: CameraParameters::new(&camera.intrinsics, &rig.deviations[k]),
                centre_metres: centre.coordinates(),
                distance_metres: centre.distance(rig.cameras[0].centre()),
                distance_deviation_metres: rig.distance_deviations[k],
                rotation_degrees: rotation.to_axis_angle().1.to_degrees(),
            }
        };
        cameras.map(summary).collect()
    }

    /// What makes the result doubtful, and of which camera.
    #[must_use]
    pub fn doubts(&self) -> Vec<(&str, CameraDoubt)> {
        let cameras = self.cameras.iter().enumerate();
        let doubts = cameras.flat_map(|(k, (name, _))| {
            let doubts = CameraDoubt::of_boards(self.common_boards[k][k], self.rig.camera_rms[k]);
            let same_place = self.rig.is_where_the_first_is(k).then(|| {
                let [first, camera] = [0, k].map(|k| self.rig.cameras[k].centre());
                CameraDoubt::SamePlace {
                    metres: first.distance(camera),
                }
            });
            doubts.chain(same_place).map(|doubt| (name.as_str(), doubt))
        });
        doubts.collect()
    }
}
