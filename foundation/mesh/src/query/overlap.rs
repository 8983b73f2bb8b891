//! Triangles within reach of a point, a sphere or a box, and crossings of a line.

use ga_runtime::cga3::{Line, Point, Sphere};
use ga_runtime::geometry::ray::{Ray, Side};
use ga_runtime::scalar::{LaneMask, Mask, Real};
use ga_runtime::vga3::Vector;

use super::frame::{rounded_down, rounded_up};
use super::nearest::{Visitor, nearest_of};
use super::node::{BRANCHES, Children, LEAF, Node, Stack};
use super::packet::{Packet, Screen};
use super::{Bvh, Nearest, QueryError};

/// Where a line crosses the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineCrossing {
    /// The point.
    pub point: Point<f64>,
    /// The distance from the point of the line nearest to the origin ([`Line::support`]), positive
    /// in the direction of the line.
    pub position: f64,
    /// The side of the triangle from which the line comes.
    pub side: Side,
    /// The index of the triangle.
    pub triangle: u32,
    /// The barycentric coordinates of the point, with sum 1, in the order of the corners.
    pub barycentric: [f64; 3],
}

impl Bvh {
    /// The triangles whose distance from a point is at most `radius`, each with its nearest point,
    /// in rising order: those that a ball meets.
    ///
    /// # Errors
    ///
    /// [`QueryError::NotFinite`] for a point that is not finite and a radius that is NaN.
    ///
    /// ```
    /// use ga_mesh::query::Bvh;
    /// use ga_runtime::cga3::Point;
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
    /// let square = Bvh::new(&corners, &[[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(square.within(Point::new(3.0, 1.0, 0.0), 1.0)?.len(), 1);
    /// assert_eq!(square.within(Point::new(3.0, 1.0, 0.0), 1.5)?.len(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn within(&self, point: Point<f64>, radius: f64) -> Result<Vec<Nearest>, QueryError> {
        let position = Vector::from(point);
        if !position.is_finite() {
            return Err(QueryError::NotFinite { what: "point" });
        }
        if radius.is_nan() {
            return Err(QueryError::NotFinite { what: "radius" });
        }
        let mut ball = Ball {
            centre: position,
            radius,
            found: Vec::new(),
        };
        if radius >= 0.0 {
            self.approach(position, radius * radius, &mut ball);
        }
        let mut found = ball.found;
        found.sort_unstable_by_key(|nearest| nearest.triangle);
        Ok(found)
    }

    /// The triangles that have a point on a sphere, in rising order.
    ///
    /// # Errors
    ///
    /// [`QueryError::Degenerate`] for a sphere that is imaginary or flat, or beyond the range of
    /// `f64`.
    pub fn on_sphere(&self, sphere: Sphere<f64>) -> Result<Vec<u32>, QueryError> {
        let (Some(centre), Some(radius)) = (sphere.centre(), sphere.radius()) else {
            return Err(QueryError::Degenerate { what: "sphere" });
        };
        let position = Vector::from(centre);
        let mut shell = Shell(Ball {
            centre: position,
            radius,
            found: Vec::new(),
        });
        self.approach(position, radius * radius, &mut shell);
        let mut found: Vec<u32> = shell.0.found.iter().map(|near| near.triangle).collect();
        found.sort_unstable();
        Ok(found)
    }

    /// The triangles that have a point in a box with sides along the axes, given by its corners of
    /// least and of greatest coordinates, in rising order. The box is closed: to touch it is
    /// enough. By separating axes (T. Akenine-Möller, Fast 3D Triangle-Box Overlap Testing, 2001).
    ///
    /// # Errors
    ///
    /// [`QueryError::NotFinite`] for a corner that is not finite.
    pub fn in_box(&self, [low, high]: [Point<f64>; 2]) -> Result<Vec<u32>, QueryError> {
        let (low, high) = (Vector::from(low), Vector::from(high));
        if !low.is_finite() || !high.is_finite() {
            return Err(QueryError::NotFinite { what: "box" });
        }
        let bounds = [self.frame.position(low), self.frame.position(high)];
        let (below, above) = (
            bounds[0].coordinates().map(rounded_down),
            bounds[1].coordinates().map(rounded_up),
        );
        let meets = |node: &Node| {
            let mut meets: LaneMask<BRANCHES> = Mask::splat(true);
            for axis in 0..3 {
                let (low, high) = (Children::splat(below[axis]), Children::splat(above[axis]));
                meets = meets
                    & node.bounds[2 * axis].less_or_equal(high)
                    & low.less_or_equal(node.bounds[2 * axis + 1]);
            }
            meets
        };
        let mut found = Vec::new();
        self.visit(meets, |packet| {
            for lane in packet.lanes() {
                if meets_box(packet.triangle(lane), [low, high]) {
                    found.push(packet.triangles[lane]);
                }
            }
        });
        found.sort_unstable();
        Ok(found)
    }

    /// Where a line crosses the surface, in the order of its direction and, at one place, of the
    /// triangles. What counts as a crossing is decided as for a ray; a line through an edge may
    /// cross both of its triangles.
    ///
    /// # Errors
    ///
    /// [`QueryError::Degenerate`] for a line of weight zero or beyond the range of `f64`.
    ///
    /// ```
    /// use ga_mesh::query::Bvh;
    /// use ga_runtime::cga3::{Line, Point};
    /// let corners = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0]];
    /// let triangle = Bvh::new(&corners, &[[0, 1, 2]])?;
    /// let line = Line::through(Point::new(1.0, 1.0, -3.0), Point::new(1.0, 1.0, -2.0));
    /// let crossings = triangle.crossings(line)?;
    /// assert_eq!((crossings[0].position, crossings[0].triangle), (1.0, 0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn crossings(&self, line: Line<f64>) -> Result<Vec<LineCrossing>, QueryError> {
        let degenerate = QueryError::Degenerate { what: "line" };
        let direction = Vector::from(line.unit_direction().ok_or(degenerate)?);
        let support = Vector::from(line.support().ok_or(degenerate)?);
        let Some([low, high]) = self.bounds else {
            return Ok(Vec::new());
        };
        // A ray along the line that begins before the bounds.
        let middle = (low * 0.5 + high * 0.5 - support).dot(direction);
        let start = middle - (high - low).length() - support.distance(low) * 1e-9;
        let start = start - start.abs() * 1e-9;
        let origin = support + direction * start;
        let Some(ray) = Ray::new(origin.into(), direction) else {
            return Err(degenerate);
        };
        let crossings = self.all_hits(ray).into_iter().map(|found| LineCrossing {
            point: found.hit.point,
            position: start + found.hit.distance,
            side: found.hit.side(),
            triangle: found.triangle,
            barycentric: found.barycentric,
        });
        Ok(crossings.collect())
    }

    /// Visits the packets of the children that a test of nodes chooses.
    pub(super) fn visit<'a>(
        &'a self,
        meets: impl Fn(&Node) -> LaneMask<BRANCHES>,
        mut visit: impl FnMut(&'a Packet),
    ) {
        if self.nodes.is_empty() {
            return;
        }
        let mut stack = Stack::new();
        while let Some((_, reference)) = stack.pop() {
            if reference & LEAF == 0 {
                let node = &self.nodes[reference as usize];
                stack.push(meets(node), Children::splat(0.0), &node.children);
            } else if let Some(packet) = self.packet(reference) {
                visit(packet);
            }
        }
    }
}

/// Collects the triangles that a ball meets.
struct Ball {
    centre: Vector<f64>,
    radius: f64,
    found: Vec<Nearest>,
}

impl<'a> Visitor<'a> for Ball {
    #[inline(always)]
    fn visit(&mut self, _: &Screen, packet: &'a Packet) -> f64 {
        let near = packet
            .lanes()
            .map(|lane| nearest_of(packet, lane, self.centre));
        self.found
            .extend(near.filter(|nearest| nearest.distance <= self.radius));
        self.radius * self.radius
    }
}

/// Collects the triangles that the surface of a ball meets.
struct Shell(Ball);

impl<'a> Visitor<'a> for Shell {
    #[inline(always)]
    fn visit(&mut self, _: &Screen, packet: &'a Packet) -> f64 {
        let Self(Ball {
            centre,
            radius,
            found,
        }) = self;
        for lane in packet.lanes() {
            let farthest = packet.triangle(lane).map(|corner| corner.distance(*centre));
            let farthest = farthest.into_iter().fold(0.0, f64::max);
            let nearest = nearest_of(packet, lane, *centre);
            if nearest.distance <= *radius && *radius <= farthest {
                found.push(nearest);
            }
        }
        *radius * *radius
    }
}

/// Whether a triangle and a box have a common point: no axis separates them.
fn meets_box(corners: [Vector<f64>; 3], [low, high]: [Vector<f64>; 2]) -> bool {
    let (centre, half) = (low * 0.5 + high * 0.5, high * 0.5 - low * 0.5);
    let [a, b, c] = corners.map(|corner| corner - centre);
    let sides = [b - a, c - b, a - c];
    let is_separated = |axis: Vector<f64>| {
        let heights = [a.dot(axis), b.dot(axis), c.dot(axis)];
        let least = heights.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = heights.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let reach = half.dot(axis.abs());
        // An axis of length zero does not separate anything.
        least > reach || greatest < -reach
    };
    let units = [Vector::X, Vector::Y, Vector::Z];
    let is_empty = low.e1 > high.e1 || low.e2 > high.e2 || low.e3 > high.e3;
    let is_apart = is_empty
        || units.into_iter().any(is_separated)
        || is_separated(sides[0].cross(sides[1]))
        || units
            .into_iter()
            .any(|unit| sides.into_iter().any(|side| is_separated(unit.cross(side))));
    !is_apart
}
