//! The cameras of a file, whatever its format.

use std::path::{Path, PathBuf};

use ga_runtime::cga3::Motor;

use super::error::{CameraFileError, PictureSizeError, Place};
use super::lens::UnstatedLens;
use crate::rig::{RectifiedRig, StereoRig};
use crate::{Camera, Intrinsics, LensModel};

/// The cameras of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraFile {
    /// One camera or more, in the order of the file.
    pub cameras: Vec<NamedCamera>,
    /// The rectified rig, where the file says that its pictures are rectified.
    pub rectified: Option<Rectified>,
}

/// What a file says of rectified pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectified {
    /// The two cameras, in metres.
    pub rig: RectifiedRig,
    /// An upper bound of the disparities in pixels.
    pub disparities: Option<usize>,
}

/// A camera of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedCamera {
    /// `left` and `right` in a rig, the file name of the picture in a list of views, and `camera`
    /// in the file of one camera.
    pub name: String,
    /// The path of its picture, where the file states one.
    pub picture: Option<PathBuf>,
    /// Width and height of its pictures in pixels, where the file states them.
    pub size: Option<[usize; 2]>,
    /// The motor that takes the world into the camera's frame, where the file states a pose. The
    /// world of a rig is the frame of its left camera.
    pub pose: Option<Motor<f64>>,
    /// The least depth that a renderer draws.
    pub near: Option<f64>,
    /// The greatest depth that a renderer draws.
    pub far: Option<f64>,
    intrinsics: Intrinsics,
    skew: f64,
    /// What the lens may be, where the file does not state its kind.
    unstated_lens: Option<UnstatedLens>,
    /// The kind that is asked for, where the lens is of another one.
    other_model: Option<LensModel>,
}

/// Two cameras of a file as a rig.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedRig {
    /// The cameras, in the frame of the left one.
    pub rig: StereoRig,
    /// What the file says of rectified pictures, where it lists these cameras and their views are
    /// such.
    pub rectified: Option<Rectified>,
    /// The left and the right camera as the file has them.
    pub cameras: [NamedCamera; 2],
}

impl NamedRig {
    /// Checks that the views, which have one size, are as large as the file says.
    ///
    /// # Errors
    /// [`PictureSizeError`], which names the first view that is not, and the file.
    pub fn check_sizes(
        &self,
        found: [usize; 2],
        views: [&Path; 2],
        file: &Path,
    ) -> Result<(), PictureSizeError> {
        let mut sides = self.cameras.iter().zip(views);
        sides.try_for_each(|(camera, view)| camera.check_size(found, view, file))
    }
}

/// The name of the camera of a file that holds one.
pub(super) const SINGLE: &str = "camera";

/// The names of the cameras of a rig.
pub(super) const SIDES: [&str; 2] = ["left", "right"];

impl NamedCamera {
    /// A camera of which nothing but its projection is known.
    #[must_use]
    pub fn new(name: impl Into<String>, intrinsics: Intrinsics) -> Self {
        Self {
            name: name.into(),
            picture: None,
            size: None,
            pose: None,
            near: None,
            far: None,
            intrinsics,
            skew: 0.0,
            unstated_lens: None,
            other_model: None,
        }
    }

    /// The same camera with what its lens may be, where the file does not state it.
    pub(super) fn with_unstated_lens(self, unstated_lens: Option<UnstatedLens>) -> Self {
        Self {
            unstated_lens,
            ..self
        }
    }

    /// Where the coefficients of a lens stand whose kind is not stated.
    pub(super) fn unstated_lens_mut(&mut self) -> Option<&mut Place> {
        self.unstated_lens.as_mut().map(|lens| &mut lens.place)
    }

    /// The same camera with the kind of lens that its file does not state. Where the file states
    /// another kind, the camera has no [`intrinsics`](Self::intrinsics).
    #[must_use]
    pub fn with_lens_model(self, model: LensModel) -> Self {
        let unstated = self.unstated_lens.as_ref();
        if let Some(lens) = unstated.and_then(|lens| lens.of_model(model)) {
            return Self {
                intrinsics: self.intrinsics.with_lens(lens),
                unstated_lens: None,
                ..self
            };
        }
        let fits = match (self.intrinsics.lens().model(), model) {
            // A radial–tangential lens without distortion is a pinhole.
            (LensModel::Pinhole, LensModel::RadialTangential) => true,
            (own, model) => own == model,
        };
        Self {
            other_model: (!fits).then_some(model),
            ..self
        }
    }

    /// The same camera with a skew in pixels, which a renderer can use: `u = f_x x' + s y' + c_x`.
    #[must_use]
    pub fn with_skew(self, skew: f64) -> Self {
        Self { skew, ..self }
    }

    /// The same camera for pictures of a size.
    #[must_use]
    pub fn with_size(self, size: Option<[usize; 2]>) -> Self {
        Self { size, ..self }
    }

    /// The same camera in a pose.
    #[must_use]
    pub fn with_pose(self, pose: Option<Motor<f64>>) -> Self {
        Self { pose, ..self }
    }

    /// Focal lengths, principal point and lens.
    ///
    /// # Errors
    /// [`CameraFileError::Skew`] for a camera with skew, and as
    /// [`intrinsics_and_skew`](Self::intrinsics_and_skew).
    pub fn intrinsics(&self) -> Result<Intrinsics, CameraFileError> {
        match self.intrinsics_and_skew()? {
            (intrinsics, 0.0) => Ok(intrinsics),
            (_, skew) => Err(CameraFileError::Skew {
                name: self.name.clone(),
                skew,
            }),
        }
    }

    /// Focal lengths, principal point and lens, and beside them the skew in pixels.
    ///
    /// # Errors
    /// [`CameraFileError::UnclearLens`] where the file does not say which lens the coefficients are
    /// of, and [`CameraFileError::OtherLens`] where it says another than
    /// [`with_lens_model`](Self::with_lens_model).
    pub fn intrinsics_and_skew(&self) -> Result<(Intrinsics, f64), CameraFileError> {
        if let Some(lens) = self.unstated_lens.as_ref().filter(|lens| lens.is_unclear()) {
            return Err(CameraFileError::UnclearLens(lens.place.clone()));
        }
        match self.other_model {
            None => Ok((self.intrinsics, self.skew)),
            Some(asked) => Err(CameraFileError::OtherLens {
                name: self.name.clone(),
                stated: self.intrinsics.lens().model().name(),
                asked: asked.name(),
            }),
        }
    }

    /// Columns and rows of the pictures, where they must be known.
    pub(super) fn known_size(&self) -> Result<[usize; 2], CameraFileError> {
        self.size.ok_or_else(|| CameraFileError::NoSize {
            name: self.name.clone(),
        })
    }

    /// The motor that takes the world into the camera's frame.
    ///
    /// # Errors
    /// [`CameraFileError::NoPose`] where the file states none.
    pub fn world_to_camera(&self) -> Result<Motor<f64>, CameraFileError> {
        self.pose.ok_or_else(|| CameraFileError::NoPose {
            name: self.name.clone(),
        })
    }

    /// The camera in its world.
    ///
    /// # Errors
    /// As [`intrinsics`](Self::intrinsics) and [`world_to_camera`](Self::world_to_camera).
    pub fn camera(&self) -> Result<Camera, CameraFileError> {
        Ok(Camera {
            intrinsics: self.intrinsics()?,
            world_to_camera: self.world_to_camera()?,
        })
    }

    /// Checks that a picture has the size that the camera is for, where its file states one.
    ///
    /// # Errors
    /// [`PictureSizeError`], which names the picture and the file.
    pub fn check_size(
        &self,
        found: [usize; 2],
        picture: &Path,
        file: &Path,
    ) -> Result<(), PictureSizeError> {
        match self.size {
            Some(expected) if expected != found => Err(PictureSizeError {
                picture: picture.to_owned(),
                found,
                file: file.to_owned(),
                expected,
            }),
            _ => Ok(()),
        }
    }

    /// Whether the camera has a name, or its picture has it, with or without its ending.
    #[must_use]
    pub fn is_named(&self, name: &str) -> bool {
        let picture = self.picture.as_deref();
        let file = picture.map(|path| [path.file_name(), path.file_stem()]);
        self.name == name || file.is_some_and(|names| names.contains(&Some(name.as_ref())))
    }
}

impl CameraFile {
    /// Cameras of pictures that are not known to be rectified.
    #[must_use]
    pub fn new(cameras: Vec<NamedCamera>) -> Self {
        Self {
            cameras,
            rectified: None,
        }
    }

    /// The same cameras with the kind of lens that the file does not state, where one is given;
    /// see [`NamedCamera::with_lens_model`].
    #[must_use]
    pub fn with_lens_model(mut self, model: Option<LensModel>) -> Self {
        if let Some(model) = model {
            let cameras = self.cameras.into_iter();
            let cameras = cameras.map(|camera| camera.with_lens_model(model));
            self.cameras = cameras.collect();
        }
        self
    }

    /// The camera of a name, or of a number from 0.
    ///
    /// # Errors
    /// [`CameraFileError::NoSuchCamera`] where there is none, or several have the name.
    pub fn camera(&self, name: &str) -> Result<&NamedCamera, CameraFileError> {
        let mut named = self.cameras.iter().filter(|camera| camera.is_named(name));
        let found = match (named.next(), named.next()) {
            (Some(camera), None) => Some(camera),
            (None, _) => name
                .parse()
                .ok()
                .and_then(|index: usize| self.cameras.get(index)),
            (Some(_), Some(_)) => None,
        };
        found.ok_or_else(|| CameraFileError::NoSuchCamera {
            name: name.to_owned(),
            names: self.names(),
        })
    }

    /// The camera of a name, or the only one.
    ///
    /// # Errors
    /// [`CameraFileError::Several`] where no name chooses among several cameras, and as
    /// [`camera`](Self::camera).
    pub fn one(&self, name: Option<&str>) -> Result<&NamedCamera, CameraFileError> {
        match (name, self.cameras.as_slice()) {
            (Some(name), _) => self.camera(name),
            (None, [camera]) => Ok(camera),
            (None, _) => Err(self.several("one")),
        }
    }

    /// The cameras of two names, left and right, or the only two.
    ///
    /// # Errors
    /// [`CameraFileError::NoRig`] where there is one camera, [`CameraFileError::Several`] where two
    /// names do not choose among several, and as [`camera`](Self::camera).
    pub fn pair(&self, names: &[String]) -> Result<[&NamedCamera; 2], CameraFileError> {
        match (names, self.cameras.as_slice()) {
            (_, [_]) => Err(CameraFileError::NoRig),
            ([left, right], _) => Ok([self.camera(left)?, self.camera(right)?]),
            ([], [left, right]) => Ok([left, right]),
            _ => Err(self.several("a pair")),
        }
    }

    /// The camera for one side of a pair, 0 on the left and 1 on the right: the only one, or of two
    /// the one in its place.
    ///
    /// # Errors
    /// [`CameraFileError::Several`] where there are more than two.
    pub fn side(&self, side: usize) -> Result<&NamedCamera, CameraFileError> {
        match self.cameras.as_slice() {
            [left, right] => Ok([left, right][side.min(1)]),
            _ => self.one(None),
        }
    }

    /// The cameras of two views, each by its name where one is given: without the first name, the
    /// first of two cameras, or the only one; without the second name, the second of two where the
    /// first has no name either, or else the camera of the first view.
    ///
    /// # Errors
    /// As [`one`](Self::one).
    pub fn of_two_views(
        &self,
        [first, second]: [Option<&str>; 2],
    ) -> Result<[&NamedCamera; 2], CameraFileError> {
        match (first, second, self.cameras.as_slice()) {
            (None, None, [first, second]) => Ok([first, second]),
            (None, Some(name), [first, _]) => Ok([first, self.camera(name)?]),
            _ => {
                let first = self.one(first)?;
                let second = second.map_or(Ok(first), |name| self.camera(name))?;
                Ok([first, second])
            }
        }
    }

    /// The cameras of some names, in their order; all where there are none.
    ///
    /// # Errors
    /// As [`camera`](Self::camera).
    pub fn choose(self, names: &[String]) -> Result<Self, CameraFileError> {
        if names.is_empty() {
            return Ok(self);
        }
        let chosen = names.iter().map(|name| self.camera(name).cloned());
        let cameras = chosen.collect::<Result<Vec<_>, _>>()?;
        let rectified = self.rectified.filter(|_| cameras == self.cameras);
        Ok(Self { cameras, rectified })
    }

    /// The rig of a [`pair`](Self::pair) with what the file says of its pictures.
    ///
    /// # Errors
    /// As [`rig`](Self::rig).
    pub fn named_rig(&self, names: &[String]) -> Result<NamedRig, CameraFileError> {
        let pair = self.pair(names)?;
        let as_listed = pair.into_iter().eq(self.cameras.iter());
        Ok(NamedRig {
            rig: self.rig(names)?,
            rectified: self.rectified.filter(|_| as_listed),
            cameras: pair.map(NamedCamera::clone),
        })
    }

    /// The rig of a [`pair`](Self::pair). Its world is the frame of the left camera.
    ///
    /// # Errors
    /// As [`pair`](Self::pair) and [`NamedCamera::camera`], and [`CameraFileError::SamePlace`] for
    /// cameras without a baseline.
    pub fn rig(&self, names: &[String]) -> Result<StereoRig, CameraFileError> {
        let [first, second] = self.pair(names)?;
        let (left, right) = (first.camera()?, second.camera()?);
        let rig = StereoRig {
            left: Camera {
                world_to_camera: Motor::default(),
                ..left
            },
            right: Camera {
                world_to_camera: right.world_to_camera * left.world_to_camera.reverse(),
                ..right
            },
        };
        if rig.baseline() > 0.0 {
            return Ok(rig);
        }
        Err(CameraFileError::SamePlace {
            left: first.name.clone(),
            right: second.name.clone(),
        })
    }

    fn names(&self) -> Vec<String> {
        let names = self.cameras.iter().map(|camera| camera.name.clone());
        names.collect()
    }

    fn several(&self, needed: &'static str) -> CameraFileError {
        CameraFileError::Several {
            needed,
            names: self.names(),
        }
    }
}
