//! Sections by planes.

use std::collections::HashMap;

use ga_runtime::cga3::{Plane, Point};
use ga_runtime::scalar::{LaneMask, Real};
use ga_runtime::vga3::Vector;

use super::frame::Frame;
use super::node::{BRANCHES, Children, Node};
use super::{Bvh, QueryError};
use crate::places::place_key;

/// The segment in which a plane cuts a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The ends. Seen with the plane's normal up, the front of the triangle is to the right of the
    /// way from the first to the second.
    pub ends: [Point<f64>; 2],
    /// The index of the triangle.
    pub triangle: u32,
}

/// Segments one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// The points; a closed contour does not repeat the first one.
    pub points: Vec<Point<f64>>,
    /// Whether the last point is joined to the first.
    pub is_closed: bool,
}

impl Bvh {
    /// The segments in which a plane cuts the triangles, in the order of the triangles. Corners on
    /// the plane count as above it, so that a closed surface gives closed contours. A triangle in
    /// the plane, or one that only touches it, gives no segment.
    ///
    /// # Errors
    ///
    /// [`QueryError::Degenerate`] for a plane of weight zero or beyond the range of `f64`.
    ///
    /// ```
    /// use ga_mesh::query::Bvh;
    /// use ga_runtime::cga3::{Plane, Point};
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 4.0]];
    /// let triangle = Bvh::new(&corners, &[[0, 1, 2]])?;
    /// let plane = Plane::from_point_normal(Point::new(0.0, 0.0, 1.0), [0.0, 0.0, 1.0]);
    /// let segments = triangle.section(plane)?;
    /// assert_eq!(segments[0].ends, [Point::new(0.0, 0.0, 1.0), Point::new(3.0, 0.0, 1.0)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn section(&self, plane: Plane<f64>) -> Result<Vec<Segment>, QueryError> {
        let degenerate = QueryError::Degenerate { what: "plane" };
        let normal = Vector::from(plane.unit_normal().ok_or(degenerate)?);
        let support = Vector::from(plane.support().ok_or(degenerate)?);
        let height = |p: Vector<f64>| (p - support).dot(normal);
        let mut segments = Vec::new();
        self.visit(self.crosses(support, normal), |packet| {
            for lane in packet.lanes() {
                let corners = packet.triangle(lane);
                if let Some(ends) = cut(corners, corners.map(height)) {
                    segments.push(Segment {
                        ends: ends.map(Point::from),
                        triangle: packet.triangles[lane],
                    });
                }
            }
        });
        segments.sort_unstable_by_key(|segment| segment.triangle);
        Ok(segments)
    }

    /// The contours in which a plane cuts the surface: the segments of [`section`](Self::section),
    /// joined where they end at exactly the same point, as those of neighbours do.
    ///
    /// # Errors
    ///
    /// As [`section`](Self::section).
    pub fn contours(&self, plane: Plane<f64>) -> Result<Vec<Contour>, QueryError> {
        Ok(join(&self.section(plane)?))
    }

    /// Whether the boxes of children meet a plane, up to rounding.
    fn crosses(
        &self,
        support: Vector<f64>,
        normal: Vector<f64>,
    ) -> impl Fn(&Node) -> LaneMask<BRANCHES> {
        let support = self.frame.position(support);
        // The point of the plane nearest to the middle of the frame.
        let distance = support.dot(normal);
        let (_, error) = Frame::rounded(normal * distance, support.length());
        let normal = normal.coordinates().map(|x| x as f32);
        let distance = distance as f32;
        move |node: &Node| {
            let half = Children::splat(0.5);
            let mut height = Children::splat(-distance);
            let mut reach = Children::splat(4.0 * error);
            for (axis, normal) in normal.into_iter().enumerate() {
                let (low, high) = (node.bounds[2 * axis], node.bounds[2 * axis + 1]);
                height += (low + high) * half * Children::splat(normal);
                reach += (high - low) * half * Children::splat(normal.abs());
            }
            let reach = reach * Children::splat(1.000_01);
            height.abs().less_or_equal(reach)
        }
    }
}

/// Where a plane cuts a triangle, given the heights of its corners above the plane.
fn cut(corners: [Vector<f64>; 3], heights: [f64; 3]) -> Option<[Vector<f64>; 2]> {
    let is_above = heights.map(|height| height >= 0.0);
    // The corner that is alone on its side.
    let alone = (0..3)
        .find(|&i| is_above[i] != is_above[(i + 1) % 3] && is_above[i] != is_above[(i + 2) % 3])?;
    let (next, last) = ((alone + 1) % 3, (alone + 2) % 3);
    let at = |i: usize, j: usize| {
        // From below to above, for both triangles at the edge; exact at a corner on the plane.
        let (i, j) = if is_above[i] { (j, i) } else { (i, j) };
        if heights[j] == 0.0 {
            return corners[j];
        }
        let part = heights[i] / (heights[i] - heights[j]);
        corners[i] + (corners[j] - corners[i]) * part
    };
    let (first, second) = if is_above[alone] {
        (next, last)
    } else {
        (last, next)
    };
    let ends = [at(alone, first), at(alone, second)];
    (ends[0] != ends[1]).then_some(ends)
}

/// Joins segments where they end at the same point.
fn join(segments: &[Segment]) -> Vec<Contour> {
    let key = |point: Point<f64>| place_key(point.coordinates());
    let mut at: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
    for (index, segment) in segments.iter().enumerate() {
        for end in segment.ends {
            at.entry(key(end)).or_default().push(index);
        }
    }
    let mut is_used = vec![false; segments.len()];
    let mut contours = Vec::new();
    for first in 0..segments.len() {
        if is_used[first] {
            continue;
        }
        is_used[first] = true;
        let mut points: std::collections::VecDeque<_> = segments[first].ends.into();
        for is_forward in [true, false] {
            loop {
                let end = if is_forward {
                    points.back()
                } else {
                    points.front()
                };
                let Some(end) = end.map(|&end| key(end)) else {
                    break;
                };
                let next = at[&end].iter().find(|&&index| !is_used[index]);
                let Some(&next) = next else { break };
                is_used[next] = true;
                let [a, b] = segments[next].ends;
                let other = if key(a) == end { b } else { a };
                if is_forward {
                    points.push_back(other);
                } else {
                    points.push_front(other);
                }
            }
        }
        let is_closed =
            points.len() > 2 && points.front().map(|&p| key(p)) == points.back().map(|&p| key(p));
        if is_closed {
            points.pop_back();
        }
        contours.push(Contour {
            points: points.into(),
            is_closed,
        });
    }
    contours
}
