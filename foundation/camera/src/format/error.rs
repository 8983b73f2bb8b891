//! What is wrong with a file of cameras.

use std::fmt;
use std::path::{Path, PathBuf};

use ga_files::ReadError;

use crate::CameraError;
use crate::rig::RigError;

/// Where in a file of cameras a value stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line, from 1, of formats by lines.
    pub line: Option<usize>,
    /// The view, from 0, in a list of views.
    pub view: Option<usize>,
    /// The key, with those of the objects around it.
    pub key: String,
}

/// What is wrong with a file of cameras, or why its cameras are not those that are needed.
#[derive(Debug, thiserror::Error)]
pub enum CameraFileError {
    /// The bytes are not text.
    #[error("line {line}: not text in UTF-8")]
    NotText {
        /// The line with the first byte that is not UTF-8.
        line: usize,
    },
    /// The text is not of its format.
    #[error("line {line}: not {format}: {problem}")]
    Syntax {
        /// The line.
        line: usize,
        /// The format.
        format: &'static str,
        /// What the parser says.
        problem: String,
    },
    /// What is valid has no place in such a file.
    #[error("line {line}: {problem}")]
    Unsupported {
        /// The line.
        line: usize,
        /// What it is.
        problem: &'static str,
    },
    /// There is no list of views, or an empty one.
    #[error("`views` is not a list of at least one view")]
    NoViews,
    /// A key is given twice.
    #[error("{0} is given a second time")]
    Duplicate(Place),
    /// A value is given by two keys.
    #[error("{place} is given, and also `{other}`")]
    Twice {
        /// One key.
        place: Place,
        /// The other one.
        other: String,
    },
    /// A value is missing.
    #[error("{}", missing(.place, .also))]
    Missing {
        /// The key that is missing.
        place: Place,
        /// Other keys under which it was looked for.
        also: Vec<String>,
    },
    /// A key is not known.
    #[error("{0} is not a key of a view")]
    Unknown(Place),
    /// A value is not what it must be.
    #[error("{place} is not {expected}")]
    Value {
        /// The value.
        place: Place,
        /// What it must be.
        expected: &'static str,
    },
    /// A lens has a name that is not known.
    #[error("{place} is not one of {}", .known.join(", "))]
    Lens {
        /// The name.
        place: Place,
        /// The names that are known.
        known: Vec<&'static str>,
    },
    /// A lens has four coefficients, as those of two kinds have, and the file does not say which.
    #[error(
        "{0} has 4 numbers, as a radial-tangential lens and a fisheye have, and the file does not \
         say which it is"
    )]
    UnclearLens(Place),
    /// A lens is said to be another one than it is in the file.
    #[error("the camera {name:?} has the lens {stated} in the file, not {asked}")]
    OtherLens {
        /// The camera.
        name: String,
        /// The lens in the file.
        stated: &'static str,
        /// The other one.
        asked: &'static str,
    },
    /// A camera is of a model that is not read.
    #[error("{place} is {found:?}, which is not read: only {}", .known.join(", "))]
    Model {
        /// Its name.
        place: Place,
        /// The model.
        found: Box<str>,
        /// The models that are read.
        known: Box<[&'static str]>,
    },
    /// The format that is written cannot hold something without which the camera is another one.
    #[error("{format} cannot hold {what} of the camera {name:?}")]
    CannotHold {
        /// The format.
        format: &'static str,
        /// What it cannot hold.
        what: &'static str,
        /// The camera.
        name: String,
    },
    /// A format has room for fewer cameras.
    #[error(
        "{format} holds {most}, and there are {} ({}): choose by name", .names.len(), listed(.names)
    )]
    TooMany {
        /// The format.
        format: &'static str,
        /// How many it holds.
        most: &'static str,
        /// The names that there are.
        names: Vec<String>,
    },
    /// The cameras are not those of rectified pictures.
    #[error("{format} holds rectified cameras alone: {problem}")]
    NotRectified {
        /// The format.
        format: &'static str,
        /// What is wrong.
        problem: String,
    },
    /// A format is read, and not written.
    #[error("{0} is read, and not written")]
    ReadOnly(&'static str),
    /// A binary file ends before its values do, or has values that cannot be.
    #[error("byte {byte}: not {format}: {problem}")]
    Binary {
        /// Where, from 0.
        byte: usize,
        /// The format.
        format: &'static str,
        /// What is wrong.
        problem: &'static str,
    },
    /// A number is infinite or not a number.
    #[error("{place} has the value {value}, which is not finite")]
    NotFinite {
        /// The number's key.
        place: Place,
        /// The number.
        value: f64,
    },
    /// A number of pixels is not a positive integer.
    #[error("{place} is {value}, not a number of pixels")]
    Size {
        /// The number's key.
        place: Place,
        /// The number.
        value: f64,
    },
    /// A matrix has another number of values than its rows and columns say.
    #[error("{place} has {found} values, not {rows} × {columns}")]
    ValueCount {
        /// The matrix.
        place: Place,
        /// How many values there are.
        found: usize,
        /// The number of rows.
        rows: usize,
        /// The number of columns, times that of channels.
        columns: usize,
    },
    /// A matrix does not have the shape that its meaning demands.
    #[error("{place} has {rows} × {columns} values, not {expected}")]
    Shape {
        /// The matrix.
        place: Place,
        /// The number of rows.
        rows: usize,
        /// The number of columns.
        columns: usize,
        /// What is expected.
        expected: &'static str,
    },
    /// The numbers do not form a camera.
    #[error("{place}: {error}")]
    Camera {
        /// The matrix or the object.
        place: Place,
        /// What is wrong.
        error: Box<CameraError>,
    },
    /// Parameters are given that only a projection has which is not read.
    #[error("{place} is a parameter of {projection}, which is not read")]
    Projection {
        /// The parameter.
        place: Place,
        /// The projection.
        projection: &'static str,
    },
    /// A pose is that in the frame of a camera which the file does not have.
    #[error("{place} leads from the frame of `{from}`, and there is no such camera")]
    NoSuchFrame {
        /// The pose.
        place: Place,
        /// The camera that is missing.
        from: String,
    },
    /// A file states sizes of pictures that do not belong together.
    #[error(
        "{place} is {} × {} pixels, whose sides are not in the ratio of {} × {}",
        .found[0], .found[1], .whole[0], .whole[1]
    )]
    Sizes {
        /// One of the sizes.
        place: Place,
        /// Its columns and rows.
        found: [usize; 2],
        /// Columns and rows of the sensor.
        whole: [usize; 2],
    },
    /// The size of a picture is not stated, and the picture cannot be read.
    #[error(
        "{place} is not given, and the picture {} cannot be read: {problem}", .picture.display()
    )]
    PictureSize {
        /// The size that is missing.
        place: Place,
        /// The picture.
        picture: Box<Path>,
        /// What is wrong with it.
        problem: Box<str>,
    },
    /// Numbers are not a rotation.
    #[error("{place} is not a rotation: it differs from the nearest by {deviation:e}")]
    Rotation {
        /// The numbers.
        place: Place,
        /// The largest difference of an entry from the nearest rotation.
        deviation: f64,
    },
    /// The two cameras of a rig are at the same place.
    #[error("{0} is zero, so the cameras are at the same place")]
    ZeroBaseline(Place),
    /// The cameras and the baseline are not a rectified rig.
    #[error("line {line}: {error}")]
    Rectified {
        /// The line of the right camera, or of the baseline.
        line: usize,
        /// What is wrong.
        error: Box<RigError>,
    },
    /// The difference of the principal points is not the one that is stated.
    #[error("{place} is {found}, and the principal points differ by {expected}")]
    Offset {
        /// The stated difference.
        place: Place,
        /// Its value.
        found: f64,
        /// The difference.
        expected: f64,
    },
    /// The file of a camera to which a view refers cannot be read.
    #[error("{place}: {error}")]
    Referred {
        /// The reference.
        place: Place,
        /// What is wrong with the file, which it names.
        error: Box<ReadError<CameraFileError>>,
    },
    /// The file of the images of a model cannot be read.
    #[error(transparent)]
    Images(Box<ReadError<CameraFileError>>),
    /// One camera of a rig is a fisheye and the other is not: OpenCV has one mark for both.
    #[error("a file cannot hold a fisheye and another lens in one rig")]
    MixedLenses,
    /// A camera is asked for that the file does not have.
    #[error("there is no camera {name:?}: the cameras are {}", listed(.names))]
    NoSuchCamera {
        /// The name that was asked for.
        name: String,
        /// The names that there are.
        names: Vec<String>,
    },
    /// There are other cameras than the number that is needed.
    #[error("there are {} cameras ({}), and {needed} is needed: choose by name", .names.len(), listed(.names))]
    Several {
        /// How many are needed.
        needed: &'static str,
        /// The names that there are.
        names: Vec<String>,
    },
    /// There is one camera where a rig is needed.
    #[error(
        "there is one camera, and a rig of two is needed: `M1`, `M2`, `R` and `T` in OpenCV's \
         files, `cam0` and `cam1` in those of kalibr and Middlebury, or two of the `views` in JSON"
    )]
    NoRig,
    /// A camera has no pose.
    #[error(
        "the camera {name:?} has no pose, which is needed: `rotation` and `translation` in JSON, \
         `R` and `T` of a rig in OpenCV's files, or `T_cn_cnm1` in kalibr's"
    )]
    NoPose {
        /// The camera.
        name: String,
    },
    /// The size of a camera's pictures is not known, and the format needs it.
    #[error("the camera {name:?} has no `width` and `height`")]
    NoSize {
        /// The camera.
        name: String,
    },
    /// A camera has no picture, and a view needs one.
    #[error("the camera {name:?} has no `picture`")]
    NoPicture {
        /// The camera.
        name: String,
    },
    /// The rows of a picture are not perpendicular to its columns.
    #[error("the camera {name:?} has the skew {skew}, which only a renderer can use")]
    Skew {
        /// The camera.
        name: String,
        /// The skew in pixels.
        skew: f64,
    },
    /// Two cameras of which a rig is made are at one place.
    #[error("the cameras {left:?} and {right:?} are at the same place")]
    SamePlace {
        /// The first camera.
        left: String,
        /// The second one.
        right: String,
    },
}

/// A picture does not have the size that a file of cameras is for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{} has {} × {} pixels, and {} is for {} × {}",
    picture.display(), found[0], found[1], file.display(), expected[0], expected[1]
)]
pub struct PictureSizeError {
    /// The picture.
    pub picture: PathBuf,
    /// Its columns and rows.
    pub found: [usize; 2],
    /// The file of cameras.
    pub file: PathBuf,
    /// The columns and rows that it states.
    pub expected: [usize; 2],
}

impl CameraFileError {
    /// The place in a file that is to blame, where it is one.
    pub(super) fn place_mut(&mut self) -> Option<&mut Place> {
        match self {
            Self::Duplicate(place)
            | Self::Twice { place, .. }
            | Self::Missing { place, .. }
            | Self::Unknown(place)
            | Self::Value { place, .. }
            | Self::Lens { place, .. }
            | Self::UnclearLens(place)
            | Self::Model { place, .. }
            | Self::NotFinite { place, .. }
            | Self::Size { place, .. }
            | Self::ValueCount { place, .. }
            | Self::Shape { place, .. }
            | Self::Camera { place, .. }
            | Self::Projection { place, .. }
            | Self::NoSuchFrame { place, .. }
            | Self::Sizes { place, .. }
            | Self::PictureSize { place, .. }
            | Self::Rotation { place, .. }
            | Self::ZeroBaseline(place)
            | Self::Offset { place, .. }
            | Self::Referred { place, .. } => Some(place),
            _ => None,
        }
    }
}

impl Place {
    /// A key on a line from 1, or 0 where there is none.
    pub(super) fn on_line(line: usize, key: impl Into<String>) -> Self {
        Self {
            line: Some(line).filter(|line| *line > 0),
            view: None,
            key: key.into(),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        if let Some(view) = self.view {
            write!(f, "view {view}: ")?;
        }
        write!(f, "`{}`", self.key)
    }
}

fn missing(place: &Place, also: &[String]) -> String {
    if place.view.is_some() {
        return format!("{place} is missing");
    }
    let quoted: Vec<String> = also.iter().map(|key| format!("`{key}`")).collect();
    let line = place.line.map(|line| format!("line {line}: "));
    let (line, key) = (line.unwrap_or_default(), &place.key);
    match quoted.as_slice() {
        [] => format!("{line}there is no `{key}`"),
        quoted => format!(
            "{line}there is no `{key}`, and none of {}",
            quoted.join(", ")
        ),
    }
}

fn listed(names: &[String]) -> String {
    names.join(", ")
}

pub(super) fn wrong_type(key: &str, line: usize, expected: &'static str) -> CameraFileError {
    CameraFileError::Value {
        place: Place::on_line(line, key),
        expected,
    }
}

/// The value at a place is missing, which has no other name.
pub(super) fn absent(place: Place) -> CameraFileError {
    CameraFileError::Missing {
        place,
        also: Vec::new(),
    }
}

/// The numbers at a place do not form a camera.
pub(super) fn refused(place: Place, error: CameraError) -> CameraFileError {
    CameraFileError::Camera {
        place,
        error: error.into(),
    }
}

/// The number at a place, which must be finite.
pub(super) fn finite(place: impl FnOnce() -> Place, value: f64) -> Result<f64, CameraFileError> {
    match value.is_finite() {
        true => Ok(value),
        false => Err(CameraFileError::NotFinite {
            place: place(),
            value,
        }),
    }
}
