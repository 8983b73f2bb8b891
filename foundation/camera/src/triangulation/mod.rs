//! The point that two or more rays determine.
//!
//! Two lines that are not parallel have one [common perpendicular][perpendicular], of length zero
//! where they meet. Noise in the pixels keeps the rays of one point from meeting, and there are
//! several answers to the question where the point is:
//!
//! | | which point | for |
//! | --- | --- | --- |
//! | [`triangulate`] | the middle of the common perpendicular | two rays |
//! | [`TwoViews`] with [`Method::Midpoint`] | the same | many pairs of pixels |
//! | [`TwoViews`] with [`Method::DepthWeighted`] | one step towards the next | the same |
//! | [`TwoViews`] with [`Method::Optimal`] | that of the least error in both | the same |
//! | [`triangulate_views`] | that of the least error in all pictures | any number of views |
//!
//! The midpoint has the least sum of squared distances from the rays, not that of squared pixel
//! errors: where one camera is much nearer than the other, its errors in the pictures are larger.
//! Noise also tilts the common perpendicular against the plane of both centres and the point, by
//! the distance of the rays divided by the baseline. The optimal point of two views is found by
//! moving both pixels as little as possible to where their rays meet, after Lindstrom; one step of
//! that is the point weighted by depth; that of many views by the method of Gauss and Newton.
//!
//! Every point comes with the distance of the rays (the gap), the depths in front of the cameras,
//! whose signs are the cheirality, and the parallax angle;
//! [`TwoViews::covariances`] says how uncertain points are.
//!
//! [perpendicular]: ga_runtime::cga3::Line::common_perpendicular

mod blocks;
mod columns;
mod covariance;
mod kernel;
mod many_views;
mod meeting;
mod optimal;
mod two_rays;
mod two_views;

pub use columns::{CovarianceColumns, PixelColumns, PointColumns, TriangulatedPoint};
pub use many_views::{ManyViewsPoint, triangulate_views};
pub use two_rays::{Triangulation, triangulate};
pub use two_views::{Method, TwoViews};

use crate::CameraError;

/// Why rays do not determine a point, or points have no observations.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TriangulationError {
    /// The rays are parallel up to rounding.
    #[error("the rays are parallel: the sine of the angle between them is {sine:e}")]
    Parallel {
        /// The sine of the angle; of the largest one where there are several.
        sine: f64,
    },
    /// A ray has a coefficient that is infinite or not a number, or the point is beyond the range
    /// of numbers.
    #[error("a ray or the point is not finite")]
    NotFinite,
    /// The point is behind a camera, or in the plane of its centre.
    #[error("the point is behind view {view}: its depth is {depth} m")]
    Behind {
        /// Which view, from 0.
        view: usize,
        /// Its depth along the optical axis.
        depth: f64,
    },
    /// A point needs two views.
    #[error("{found} views do not determine a point: at least 2 are needed")]
    TooFewViews {
        /// How many views there are.
        found: usize,
    },
    /// There are other numbers of cameras and of pixels.
    #[error("{cameras} cameras, but {pixels} pixels")]
    Counts {
        /// How many cameras there are.
        cameras: usize,
        /// How many pixels there are.
        pixels: usize,
    },
    /// A camera does not see the point, or has no ray of the pixel.
    #[error("view {view}: {error}")]
    Camera {
        /// Which view, from 0.
        view: usize,
        /// What is wrong.
        error: CameraError,
    },
    /// A lens is not a pinhole where one is needed.
    #[error("the lens of view {view} is distorted: its pixels are undistorted first")]
    Distorted {
        /// Which view, from 0.
        view: usize,
    },
    /// The centres of two cameras coincide.
    #[error("the centres of the cameras coincide: without a baseline there is no parallax")]
    NoBaseline,
    /// No point of least error was found.
    #[error("no point of least error was found in {steps} steps")]
    NotConverged {
        /// How many steps were taken.
        steps: usize,
    },
    /// A pair of pixels does not determine a point.
    #[error("point {point}: {error}")]
    Point {
        /// Which pair, from 0.
        point: usize,
        /// What is wrong with it.
        error: Box<TriangulationError>,
    },
    /// A column has another length than the first.
    #[error("{column} has {found} elements, but there are {expected} columns of the left view")]
    Length {
        /// Which column.
        column: &'static str,
        /// How many elements the u column of the left view has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// A camera does not see a point that is to be observed.
    #[error("point {point}: {error}")]
    Unseen {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with it.
        error: CameraError,
    },
    /// The noise is not the standard deviation of a normal distribution.
    #[error("{0} px is not a standard deviation")]
    Noise(f64),
}

impl TriangulationError {
    /// The error of a camera among several.
    fn of_view(view: usize, error: CameraError) -> Self {
        match error {
            CameraError::Behind { depth, .. } => Self::Behind { view, depth },
            error => Self::Camera { view, error },
        }
    }

    /// The same of one of several points.
    pub(crate) fn of_point(self, point: usize) -> Self {
        let error = Box::new(self);
        Self::Point { point, error }
    }
}
