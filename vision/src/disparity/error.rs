//! What can go wrong with matching, and with files of disparity maps.

use ga_files::WriteError;
use ga_image::file::FormatError;
use ga_image::plane::PlaneError;

use crate::geometry_error::ViewGeometryError;

/// Why views cannot be matched, or a file does not take or hold a disparity map.
#[derive(Debug, thiserror::Error)]
pub enum StereoError {
    /// The disparities to be looked for are none, too many, or more than the columns.
    #[error(
        "the disparity range of {range} px must be from 1 to {greatest} px for views {width} \
         pixels wide"
    )]
    Range {
        /// The number of disparities.
        range: i64,
        /// The greatest possible number.
        greatest: usize,
        /// Columns.
        width: usize,
    },
    /// Some of the disparities to be looked for point from every pixel out of the other view.
    #[error(
        "disparities from {} px up to, and without, {} px point out of views {width} pixels wide",
        range[0], range[1]
    )]
    OutOfView {
        /// The first disparity, and the first one beyond the last.
        range: [i32; 2],
        /// Columns.
        width: usize,
    },
    /// The views have too few pixels.
    #[error(
        "views of {width} × {height} pixels are too small; at least {least} × {least} are needed"
    )]
    TooSmall {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// The least number of columns and rows.
        least: usize,
    },
    /// The views have too many pixels.
    #[error("views of {width} × {height} pixels are too large; at most {most} pixels are possible")]
    TooLarge {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// The greatest number of pixels.
        most: usize,
    },
    /// The views have different sizes.
    #[error(
        "the left view has {} × {} pixels and the right view {} × {}",
        left[0], left[1], right[0], right[1]
    )]
    Views {
        /// Columns and rows of the left view.
        left: [usize; 2],
        /// Columns and rows of the right view.
        right: [usize; 2],
    },
    /// The views do not have the size that the matcher was built for.
    #[error(
        "the views have {} × {} pixels, and the matcher is for {} × {}",
        found[0], found[1], expected[0], expected[1]
    )]
    Size {
        /// Columns and rows of the views.
        found: [usize; 2],
        /// Columns and rows that the matcher was built for.
        expected: [usize; 2],
    },
    /// The threads could not be started.
    #[error("the threads of the matcher cannot be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// The bytes are not a picture, or a map without pixels has no file.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The picture has more than one number for each pixel.
    #[error("a disparity map has one number for each pixel, and this picture is {kind}")]
    Kind {
        /// The kind of pixel.
        kind: &'static str,
    },
    /// The picture is not a mask.
    #[error("a mask is a grey picture of whole numbers, and this picture is {kind}")]
    Mask {
        /// The kind of pixel.
        kind: &'static str,
    },
    /// A level of a mask has no meaning.
    #[error("a mask has the levels 0, 128 and 255, or 0 and 1, and not {level}")]
    MaskLevel {
        /// The level.
        level: u16,
    },
    /// The scale by which the stored numbers are divided is 0, negative or not finite.
    #[error("the scale {scale} of the disparities is not positive and finite")]
    Scale {
        /// The scale.
        scale: f64,
    },
    /// A PNG file cannot hold the disparity.
    #[error(
        "a PNG file with 16 bits holds disparities from 0 to {greatest:.3} px, and the map has \
         {disparity:.3} px: PFM holds all"
    )]
    NotInPng {
        /// The disparity in pixels.
        disparity: f32,
        /// The greatest that it can hold.
        greatest: f64,
    },
    /// Too few points of the views are found to tell the range of their disparities.
    #[error(
        "{found} points that both views show in one row are too few to tell the range of \
         disparities; at least {needed} are needed"
    )]
    FewPoints {
        /// How many are found.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// The cameras cannot be rectified.
    #[error(transparent)]
    Geometry(Box<ViewGeometryError>),
    /// Pictures of views have different sizes.
    #[error(transparent)]
    Plane(#[from] PlaneError),
    /// The file could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}
