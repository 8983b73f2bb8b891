//! Closed curves in space from their contours in two views.

mod bridge;
mod candidates;
mod measures;
mod order;

use std::f64::consts::PI;

use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use serde::{Serialize, Serializer};

use super::polygon::{distance_to, perimeter, signed_area};
use crate::contour::ContourError;
use bridge::bridge;
use candidates::{Candidate, candidates};
use ga_camera::rig::StereoRig;
use ga_camera::triangulation::{TriangulationError, triangulate};
use ga_camera::{Camera, CameraError};
use order::in_order;

pub use measures::{NearestSpaceCircle, NearestSpaceLine, SpaceCurveMeasures};

/// How contours are matched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceCurveOptions {
    /// Where the angle between a contour and an epipolar line is less than this, in radians, their
    /// intersection is not used: it moves by the error of the contour over the sine of the angle.
    pub least_angle: f64,
}

impl Default for SpaceCurveOptions {
    /// 0.25 radians, about 14°.
    fn default() -> Self {
        Self { least_angle: 0.25 }
    }
}

/// A point of a curve in space. Serialised, its numbers have their units in their names.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SpaceCurvePoint {
    /// Where it is, in the world of the rig.
    #[serde(rename = "position_metres", serialize_with = "coordinates")]
    pub position: Point<f64>,
    /// The pixel of the left contour.
    #[serde(rename = "left_px")]
    pub left: [f64; 2],
    /// The pixel of the right view.
    #[serde(rename = "right_px")]
    pub right: [f64; 2],
    /// The distance of the rays of both pixels in metres.
    #[serde(rename = "gap_metres")]
    pub gap: f64,
    /// The distance of the right pixel from the right contour, in pixels.
    #[serde(rename = "deviation_px")]
    pub deviation: f64,
    /// Whether the point lies on the plane through its neighbours, or on the straight line between
    /// them where that plane is not in front of the camera, instead of the intersection of an
    /// epipolar line, because this touches the contour or does not meet it.
    #[serde(rename = "bridged")]
    pub is_bridged: bool,
}

fn coordinates<S: Serializer>(position: &Point<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    position.coordinates().serialize(serializer)
}

/// A closed curve in space: a point for each point of the left contour, in the same order.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceCurve {
    /// The points. The last one is joined to the first one.
    pub points: Vec<SpaceCurvePoint>,
}

impl SpaceCurve {
    /// The positions of the points.
    #[must_use]
    pub fn positions(&self) -> Vec<Point<f64>> {
        self.points.iter().map(|point| point.position).collect()
    }

    /// The positions of those points that were triangulated, without the bridged ones.
    #[must_use]
    pub fn triangulated(&self) -> Vec<Point<f64>> {
        let points = self.points.iter().filter(|point| !point.is_bridged);
        points.map(|point| point.position).collect()
    }

    /// The length of the closed polygon through the points in metres.
    #[must_use]
    pub fn length(&self) -> f64 {
        let next = self.points.iter().cycle().skip(1);
        let edges = self.points.iter().zip(next);
        edges.map(|(a, b)| a.position.distance(b.position)).sum()
    }
}

/// The closed curve in space that two cameras see as the closed contours `left` and `right`, in
/// pixels of their views with the distortion of the lenses.
///
/// A point x of the left contour lies on the ray `o∧d∧ei` of its pixel. The plane of this ray and
/// the centre of the right camera, `Π = o∧d∧c∧ei`, is the epipolar plane; where the rays of the
/// right contour cross it, there are candidates for the same point of the curve. They are chosen
/// so that the order along both contours is the same and the right contour is passed through once,
/// as evenly as possible: with the arc lengths s and t along both contours by their whole lengths,
/// the sum of `(Δt − Δs)²/Δs` over the chosen pairs is least (dynamic programming). The rays of a
/// chosen pair are [triangulated](mod@ga_camera::triangulation).
///
/// Where an epipolar line touches the contour, it meets it at an angle near zero or not at all.
/// These stretches lie on planes that are fitted to the curve on both sides of them, which is exact
/// for plane curves. They are estimates for other curves: neither picture shows the depth of a
/// stretch along an epipolar line, and a point of it may be as far off as the curve leaves that
/// plane. [`is_bridged`](SpaceCurvePoint::is_bridged) marks these points.
///
/// Both cameras have to look at the same side of the curve; contours in the opposite sense of
/// rotation are reversed. The distances between points should be some pixels, and their errors
/// small against them: snakes, not borders of pixels.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_camera::Intrinsics;
/// use ga_vision::contour::space_curve::{SpaceCurveOptions, space_curve};
/// use ga_camera::rig::StereoRig;
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.2, 0.0, 0.0])?;
/// // A circle of radius 0.3 m in the plane z = 2 m.
/// let circle: Vec<Point<f64>> = (0..200)
///     .map(|k| (std::f64::consts::TAU * f64::from(k) / 200.0).sin_cos())
///     .map(|(sin, cos)| Point::new(0.3 * cos, 0.3 * sin, 2.0))
///     .collect();
/// let left: Vec<_> = circle.iter().map(|p| rig.left.project(*p)).collect::<Result<_, _>>()?;
/// let right: Vec<_> = circle.iter().map(|p| rig.right.project(*p)).collect::<Result<_, _>>()?;
/// let curve = space_curve(&rig, &left, &right, &SpaceCurveOptions::default())?;
/// for (point, truth) in curve.points.iter().zip(&circle) {
///     assert!(point.position.distance(*truth) < 1e-3);
/// }
/// assert!((curve.length() - 0.6 * std::f64::consts::PI).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`ContourError`] for fewer than eight points, pixels without a ray, cameras at one place, a
/// contour along the epipolar lines, contours of which no part is seen by both cameras, and
/// contours that are not of one curve.
pub fn space_curve(
    rig: &StereoRig,
    left: &[[f64; 2]],
    right: &[[f64; 2]],
    options: &SpaceCurveOptions,
) -> Result<SpaceCurve, ContourError> {
    /// At least this part of the points at which the left contour crosses epipolar lines needs a
    /// counterpart.
    const LEAST_SHARE: f64 = 0.1;
    /// How far points may be from the right contour, by the diameter of a circle of its length.
    const GREATEST_DEVIATION: f64 = 0.1;
    let left_rays = rays(&rig.left, left, "left")?;
    let [left_area, right_area] = [left, right].map(signed_area);
    let mut right = right.to_vec();
    if (left_area > 0.0) != (right_area > 0.0) {
        right.reverse();
    }
    let right_rays = rays(&rig.right, &right, "right")?;
    for (view, area) in [("left", left_area), ("right", right_area)] {
        if area.is_nan() || area == 0.0 {
            return Err(ContourError::NoArea { view });
        }
    }
    if rig.baseline().is_nan() || rig.baseline() <= 0.0 {
        return Err(ContourError::Cameras(TriangulationError::NoBaseline));
    }
    let found = candidates(&left_rays, &right_rays, options.least_angle.sin());
    let crossing = found.iter().flatten().count();
    if crossing < LEAST {
        return Err(ContourError::AlongLines {
            crossing,
            count: left.len(),
            least: LEAST,
        });
    }
    let found: Vec<_> = found.into_iter().map(Option::unwrap_or_default).collect();
    if found.iter().all(Vec::is_empty) {
        return Err(ContourError::NoOverlap);
    }
    let chosen = in_order(&found, &fractions(left), &fractions(&right));
    let matched = chosen.iter().flatten().count();
    if (matched as f64) < LEAST_SHARE * crossing as f64 || matched < LEAST {
        return Err(ContourError::TooFewMatches { matched, crossing });
    }
    let depths: Vec<Option<f64>> = chosen
        .iter()
        .map(|chosen| chosen.as_ref().map(|candidate| candidate.depth))
        .collect();
    let depths = bridge(&left_rays, &depths)?;
    let points = (0..left.len()).map(|index| {
        let position = left_rays[index].at(depths[index]);
        match &chosen[index] {
            Some(candidate) => Ok(triangulated(candidate, left[index], &right)),
            None => bridged(rig, index, position, left[index], &right),
        }
    });
    let points = points.collect::<Result<Vec<_>, _>>()?;
    let greatest = GREATEST_DEVIATION * perimeter(&right) / PI;
    match points.iter().position(|point| point.deviation > greatest) {
        None => Ok(SpaceCurve { points }),
        Some(index) => Err(ContourError::Apart {
            index,
            deviation: points[index].deviation,
        }),
    }
}

/// The least number of points of a contour.
const LEAST: usize = 8;

fn rays(
    camera: &Camera,
    pixels: &[[f64; 2]],
    view: &'static str,
) -> Result<Vec<Ray<f64>>, ContourError> {
    let count = pixels.len();
    if count < LEAST {
        let least = LEAST;
        return Err(ContourError::ContourTooFew { view, count, least });
    }
    let pixels = pixels.iter().enumerate();
    pixels
        .map(|(index, pixel)| {
            let ray = camera.ray(*pixel);
            ray.map_err(|error| ContourError::Camera {
                view,
                index,
                error: Box::new(error),
            })
        })
        .collect()
}

/// The lengths along a closed polygon at its corners, by the whole length.
fn fractions(corners: &[[f64; 2]]) -> Vec<f64> {
    let next = corners.iter().cycle().skip(1);
    let mut sum = 0.0;
    let mut lengths: Vec<f64> = corners
        .iter()
        .zip(next)
        .map(|(a, b)| {
            let before = sum;
            sum += (b[0] - a[0]).hypot(b[1] - a[1]);
            before
        })
        .collect();
    lengths.iter_mut().for_each(|length| *length /= sum);
    lengths
}

fn triangulated(candidate: &Candidate, left: [f64; 2], right: &[[f64; 2]]) -> SpaceCurvePoint {
    let [a, b] = [0, 1].map(|k| right[(candidate.edge + k) % right.len()]);
    SpaceCurvePoint {
        position: candidate.position,
        left,
        right: [0, 1].map(|axis| a[axis] + candidate.part * (b[axis] - a[axis])),
        gap: candidate.gap,
        deviation: 0.0,
        is_bridged: false,
    }
}

/// A bridged point, with the ray of the nearest point of the right contour.
fn bridged(
    rig: &StereoRig,
    index: usize,
    position: Point<f64>,
    left: [f64; 2],
    right: &[[f64; 2]],
) -> Result<SpaceCurvePoint, ContourError> {
    let of_point = |view| {
        move |error: CameraError| ContourError::Camera {
            view,
            index,
            error: Box::new(error),
        }
    };
    let seen = rig.right.project(position).map_err(of_point("right"))?;
    let (deviation, nearest) = distance_to(right, seen);
    let ray = rig.right.ray(nearest).map_err(of_point("right"))?;
    let own = rig.left.ray(left).map_err(of_point("left"))?;
    let rays = triangulate(own, ray).map_err(|_| ContourError::NotBridged { index })?;
    Ok(SpaceCurvePoint {
        position,
        left,
        right: seen,
        gap: rays.gap,
        deviation,
        is_bridged: true,
    })
}
