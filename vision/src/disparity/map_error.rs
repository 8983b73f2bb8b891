//! What cannot be made of a disparity map.

use ga_image::plane::PlaneError;
use ga_mesh::MeshError;

/// Why a disparity map cannot be evaluated, has no modelling points, or is not a surface.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DisparityMapError {
    /// The map and the truth have different sizes.
    #[error("the map and the truth cannot be compared: {0}")]
    TruthSize(#[source] PlaneError),
    /// The mask has another size.
    #[error("the mask does not fit the truth: {0}")]
    MaskSize(#[source] PlaneError),
    /// No pixel that counts has a true disparity that is finite and not 0.
    #[error("the truth has no pixel that counts and whose disparity is finite and not 0")]
    NoTruth,
    /// The map and the weights have different sizes.
    #[error("the disparities and their weights do not fit together: {0}")]
    WeightsSize(#[source] PlaneError),
    /// A weight is negative or not finite.
    #[error(
        "the weight {weight} of the pixel in column {column} and row {row} is negative or not finite"
    )]
    Weight {
        /// The weight.
        weight: f32,
        /// The column.
        column: usize,
        /// The row.
        row: usize,
    },
    /// The number of levels is not from 1 to 32.
    #[error("a pyramid has 1 to 32 levels, not {0}")]
    Levels(usize),
    /// The deviation of a pixel's disparity is negative or not finite.
    #[error("{0} px is not a standard deviation")]
    Deviation(f64),
    /// The denominator S Q + t is zero.
    #[error("the denominator S Q + t vanishes for S = {deviation}, Q = {spacing}, t = {direction}")]
    Denominator {
        /// S, the visual deviation.
        deviation: f64,
        /// Q, the visual point spacing.
        spacing: f64,
        /// t, the correlation direction.
        direction: f64,
    },
    /// A number is not finite, or the result would not be.
    #[error("the predicted distance is not finite for {0:?} (S, Q, φ, t, C)")]
    NotFinite([f64; 5]),
    /// The limit of the disparity between neighbours is not positive and finite.
    #[error("{0} px is not a limit for the disparity between neighbouring pixels")]
    Cut(f64),
    /// The grid has no step.
    #[error("every 0th pixel is none: the step must be at least 1")]
    Step,
    /// The range of depths is empty.
    #[error("no depth is from {0} to {1} m")]
    Depths(f64, f64),
    /// The greatest relative deviation of a depth is not positive.
    #[error("a relative deviation of depths of {0} is not positive")]
    DepthDeviation(f64),
    /// No pixel has a disparity with a depth in the range and of the accuracy that is asked for.
    #[error(
        "none of the {pixels} pixels has a disparity with a depth in the range{}",
        left_out(*uncertain)
    )]
    Empty {
        /// How many pixels the map has.
        pixels: usize,
        /// How many have a depth in the range whose deviation is too great.
        uncertain: usize,
    },
    /// There are more points than indices.
    #[error("{0} points are more than a mesh can number")]
    TooMany(usize),
    /// The picture does not have the size of the disparity map.
    #[error(
        "the picture has {} × {} pixels and the disparity map {} × {}",
        picture[0], picture[1], map[0], map[1]
    )]
    PictureSize {
        /// Width and height of the picture.
        picture: [usize; 2],
        /// Width and height of the disparity map.
        map: [usize; 2],
    },
    /// No two neighbouring pixels belong together.
    #[error("the surface has no triangles: all neighbouring pixels are cut apart")]
    NoTriangles,
    /// The mesh is not valid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

fn left_out(uncertain: usize) -> String {
    match uncertain {
        0 => String::new(),
        count => format!(" whose deviation is small enough: {count} of them are left out for it"),
    }
}
