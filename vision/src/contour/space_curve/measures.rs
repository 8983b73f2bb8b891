//! A curve in space in numbers: its length, how well two views agree on it, the circle and the line
//! nearest to it.

use ga_mesh::{Faces, Mesh, MeshError, Polylines};
use ga_runtime::cga3::{Circle, Line, Motor};
use serde::Serialize;

use super::{SpaceCurve, SpaceCurvePoint};
use crate::contour::ContourError;

/// The length of a curve in space, and how well two views agree on it. Serialised, lengths have
/// `metres` or `px` in their names.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SpaceCurveMeasures {
    /// The length of the closed polygon through the points in metres.
    #[serde(rename = "length_metres")]
    pub length: f64,
    /// How many points lie on planes through their neighbours, where epipolar lines touch.
    pub bridged: usize,
    /// The mean distance of the rays of both pixels of a point in metres.
    #[serde(rename = "gap_mean_metres")]
    pub gap_mean: f64,
    /// The greatest of these distances.
    #[serde(rename = "gap_max_metres")]
    pub gap_max: f64,
    /// The root mean square of the distances from the right contour, in pixels.
    #[serde(rename = "deviation_rms_px")]
    pub deviation_rms: f64,
    /// The greatest of these distances.
    #[serde(rename = "deviation_max_px")]
    pub deviation_max: f64,
}

/// The circle nearest to a curve in space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct NearestSpaceCircle {
    /// The centre.
    #[serde(rename = "centre_metres")]
    pub centre: [f64; 3],
    /// The unit normal of its plane.
    pub normal: [f64; 3],
    /// The radius in metres.
    #[serde(rename = "radius_metres")]
    pub radius: f64,
    /// The root mean square of the distances of the triangulated points in metres.
    #[serde(rename = "rms_metres")]
    pub rms: f64,
}

/// The line nearest to a curve in space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct NearestSpaceLine {
    /// The point nearest to the origin.
    #[serde(rename = "point_metres")]
    pub point: [f64; 3],
    /// The unit direction.
    pub direction: [f64; 3],
    /// The root mean square of the distances of the triangulated points in metres.
    #[serde(rename = "rms_metres")]
    pub rms: f64,
}

impl SpaceCurve {
    /// The curve after a motion `M x M~`.
    #[must_use]
    pub fn moved(&self, motor: &Motor<f64>) -> Self {
        let points = self.points.iter().map(|point| SpaceCurvePoint {
            position: motor.transform(point.position),
            ..*point
        });
        Self {
            points: points.collect(),
        }
    }

    /// The length, the gaps and the deviations. Means of a curve without points are not numbers.
    #[must_use]
    pub fn measures(&self) -> SpaceCurveMeasures {
        let points = &self.points;
        let count = points.len() as f64;
        let greatest =
            |value: fn(&SpaceCurvePoint) -> f64| points.iter().map(value).fold(0.0, f64::max);
        let squares = points.iter().map(|point| point.deviation.powi(2));
        SpaceCurveMeasures {
            length: self.length(),
            bridged: points.iter().filter(|point| point.is_bridged).count(),
            gap_mean: points.iter().map(|point| point.gap).sum::<f64>() / count,
            gap_max: greatest(|point| point.gap),
            deviation_rms: (squares.sum::<f64>() / count).sqrt(),
            deviation_max: greatest(|point| point.deviation),
        }
    }

    /// The circle with the least squared distances from the triangulated points.
    ///
    /// # Errors
    ///
    /// [`ContourError::Circle`].
    pub fn nearest_circle(&self) -> Result<NearestSpaceCircle, ContourError> {
        let fit = Circle::fit(&self.triangulated()).map_err(ContourError::Circle)?;
        let [_, _, normal] = fit.axes();
        Ok(NearestSpaceCircle {
            centre: fit.origin().coordinates(),
            normal,
            radius: fit.radius(),
            rms: fit.rms(),
        })
    }

    /// The line with the least squared distances from the triangulated points.
    ///
    /// # Errors
    ///
    /// [`ContourError::Line`], and [`ContourError::LineNotFinite`].
    pub fn nearest_line(&self) -> Result<NearestSpaceLine, ContourError> {
        let fit = Line::fit(&self.triangulated()).map_err(ContourError::Line)?;
        let line = fit.primitive;
        let (nearest, direction) = line
            .support()
            .zip(line.unit_direction())
            .ok_or(ContourError::LineNotFinite)?;
        Ok(NearestSpaceLine {
            point: nearest.coordinates(),
            direction,
            rms: fit.rms(),
        })
    }

    /// The curve as a mesh without faces: a chain of edges that ends where it begins.
    ///
    /// # Errors
    ///
    /// [`MeshError`] for more points than a mesh can have.
    pub fn to_mesh(&self) -> Result<Mesh, MeshError> {
        let places: Vec<[f64; 3]> = self
            .positions()
            .iter()
            .map(|position| position.coordinates())
            .collect();
        let count = places.len();
        let mesh = Mesh::new(places, Faces::default())?;
        // The mesh has refused more vertices than this can number.
        let chain: Vec<u32> = (0..count as u32).chain([0]).collect();
        mesh.with_polylines(Polylines::from_lines([chain])?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ga_runtime::cga3::Point;

    /// A curve of points that both views agree on.
    fn curve(place: impl Fn(f64) -> [f64; 3]) -> SpaceCurve {
        let points = (0..80).map(|k| {
            let [x, y, z] = place(std::f64::consts::TAU * f64::from(k) / 80.0);
            SpaceCurvePoint {
                position: Point::new(x, y, z),
                left: [0.0; 2],
                right: [0.0; 2],
                gap: 0.001 * f64::from(k % 2),
                deviation: 0.5 * f64::from(k % 2),
                is_bridged: k < 4,
            }
        });
        SpaceCurve {
            points: points.collect(),
        }
    }

    #[test]
    fn a_circle_is_measured_and_found() {
        let circle = curve(|angle| [0.3 * angle.cos(), 2.0, 1.0 + 0.3 * angle.sin()]);
        let measures = circle.measures();
        let side = 0.6 * (std::f64::consts::PI / 80.0).sin();
        assert!((measures.length - 80.0 * side).abs() < 1e-12);
        assert_eq!((measures.bridged, measures.gap_max), (4, 0.001));
        assert!((measures.gap_mean - 0.0005).abs() < 1e-15);
        assert!((measures.deviation_rms - 0.125f64.sqrt()).abs() < 1e-12);
        let found = circle.nearest_circle().unwrap();
        assert!((found.radius - 0.3).abs() < 1e-9 && found.rms < 1e-9);
        assert!((found.normal[1].abs() - 1.0).abs() < 1e-9);
        assert!((found.centre[2] - 1.0).abs() < 1e-9);
        let polylines = circle.to_mesh().unwrap();
        assert_eq!(polylines.vertex_count(), 80);
    }

    #[test]
    fn a_line_is_found_and_is_no_circle() {
        let line = curve(|angle| [angle.cos(), 1.0, 0.0]);
        let found = line.nearest_line().unwrap();
        assert!((found.point[1] - 1.0).abs() < 1e-12 && found.point[0].abs() < 1e-9);
        assert!((found.direction[0].abs() - 1.0).abs() < 1e-12);
        assert!(matches!(
            line.nearest_circle(),
            Err(ContourError::Circle(_))
        ));
    }
}
