//! Where the epipolar planes of a contour meet the other contour.

use ga_runtime::cga3::{Plane, Point};
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;

use ga_camera::triangulation::triangulate;

/// A point of the right contour that may be seen at a point of the left one.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    /// The edge of the right contour, by the corner at which it begins.
    pub(super) edge: usize,
    /// The part of the edge before the point.
    pub(super) part: f64,
    /// The point in space, its distance along the left ray, and the distance of the rays.
    pub(super) position: Point<f64>,
    pub(super) depth: f64,
    pub(super) gap: f64,
}

/// For each point of the left contour, the points of the right one that lie in its epipolar plane
/// in front of both cameras, where both contours cross the plane in the same sense and at angles
/// whose sine is at least `least_sine`; `None` where the left contour does not cross it so.
pub(super) fn candidates(
    left: &[Ray<f64>],
    right: &[Ray<f64>],
    least_sine: f64,
) -> Vec<Option<Vec<Candidate>>> {
    let [left_centre, right_centre] = [left[0].origin(), right[0].origin()];
    let baseline = left_centre.vector_to(right_centre);
    // Points of the right rays at a distance of 1, of which an edge joins two.
    let tips: Vec<Point<f64>> = right.iter().map(|ray| ray.at(1.0)).collect();
    (0..left.len())
        .map(|index| {
            let ray = left[index];
            let plane = Plane::through(left_centre, right_centre, ray.at(1.0));
            // What the direction adds to the baseline: the half of the plane that is seen.
            let forward = Vector::from(ray.direction()).reject(baseline)?;
            let [before, after] = [left.len() - 1, 1].map(|k| left[(index + k) % left.len()]);
            let sense = crossing(plane, [before.at(1.0), after.at(1.0)])?;
            if sense.is_nan() || sense.abs() < least_sine {
                return None;
            }
            let signed = |tip: Point<f64>| plane.signed_distance(tip).unwrap_or(0.0);
            let mut found = Vec::new();
            let mut from = signed(tips[0]);
            for edge in 0..tips.len() {
                let ends = [tips[edge], tips[(edge + 1) % tips.len()]];
                let [start, to] = [from, signed(ends[1])];
                from = to;
                // An edge that ends in the plane crosses it, and not the next one.
                if (start > 0.0) == (to > 0.0) {
                    continue;
                }
                let steepness = crossing(plane, ends).unwrap_or(0.0);
                if steepness * sense <= 0.0 || steepness.abs() < least_sine {
                    continue;
                }
                let part = start / (start - to);
                let direction = right_centre.vector_to(ends[0].lerp(ends[1], part));
                let ahead = direction.dot(forward);
                if ahead.is_nan() || ahead <= 0.0 {
                    continue;
                }
                let other = Ray::new(right_centre, direction);
                let Some(Ok(point)) = other.map(|other| triangulate(ray, other)) else {
                    continue;
                };
                if point.is_in_front() {
                    found.push(Candidate {
                        edge,
                        part,
                        position: point.position,
                        depth: point.depths[0],
                        gap: point.gap,
                    });
                }
            }
            Some(found)
        })
        .collect()
}

/// The sine of the angle between a plane and the way from one point to another, positive towards
/// the side of the plane's normal.
fn crossing(plane: Plane<f64>, [from, to]: [Point<f64>; 2]) -> Option<f64> {
    let way = plane.signed_distance(to)? - plane.signed_distance(from)?;
    Some(way / from.distance(to))
}
