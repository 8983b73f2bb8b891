//! The nearest point of the surface.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Point;
use ga_runtime::scalar::{Real, Select};
use ga_runtime::vga3::Vector;

use super::frame::Frame;
use super::node::{Children, LEAF, Node, Stack};
use super::packet::{Packet, Screen, WIDTH};
use super::{Bvh, QueryError};

/// A point of the surface, and its distance from the point of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The point of the surface.
    pub point: Point<f64>,
    /// Its distance from the point of the query.
    pub distance: f64,
    /// The index of the triangle on which it lies.
    pub triangle: u32,
    /// Its barycentric coordinates, with sum 1, in the order of the corners. One of them is zero,
    /// exactly, where the point lies on an edge, and two at a corner.
    pub barycentric: [f64; 3],
}

/// More than the relative errors of squared distances in single precision.
const LARGER: f32 = 1.0 + 1.0 / (1 << 18) as f32;

impl Bvh {
    /// The point of the surface that is nearest to a point. Of several triangles at the same
    /// distance it is the one with the lowest index.
    ///
    /// # Errors
    ///
    /// [`QueryError::NoTriangles`]; [`QueryError::NotFinite`] for a point that is not finite or so
    /// far away that the square of its distance is not.
    ///
    /// ```
    /// use ga_mesh::query::{Bvh, QueryError};
    /// use ga_runtime::cga3::Point;
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    /// let triangle = Bvh::new(&corners, &[[0, 1, 2]])?;
    /// let nearest = triangle.nearest(Point::new(2.0, -3.0, 4.0))?;
    /// assert_eq!((nearest.point, nearest.distance), (Point::new(2.0, 0.0, 0.0), 5.0));
    /// assert_eq!(nearest.barycentric, [0.5, 0.5, 0.0]);
    ///
    /// let nothing = Bvh::new(&corners, &[])?;
    /// assert_eq!(nothing.nearest(Point::default()), Err(QueryError::NoTriangles));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest(&self, point: Point<f64>) -> Result<Nearest, QueryError> {
        if self.nodes.is_empty() {
            return Err(QueryError::NoTriangles);
        }
        self.nearest_within(point, f64::INFINITY)?
            .filter(|nearest| nearest.distance.is_finite())
            .ok_or(QueryError::NotFinite { what: "point" })
    }

    /// The point of the surface that is nearest to a point, if its distance is at most `radius`,
    /// which may be infinite; `None` also without triangles.
    ///
    /// # Errors
    ///
    /// [`QueryError::NotFinite`] for a point that is not finite, and a radius that is NaN.
    pub fn nearest_within(
        &self,
        point: Point<f64>,
        radius: f64,
    ) -> Result<Option<Nearest>, QueryError> {
        let position = Vector::from(point);
        if !position.is_finite() {
            return Err(QueryError::NotFinite { what: "point" });
        }
        if radius.is_nan() {
            return Err(QueryError::NotFinite { what: "radius" });
        }
        if radius < 0.0 {
            return Ok(None);
        }
        let mut closest = ClosestVisited::new(&self.frame, position, radius * radius);
        self.approach(position, radius * radius, &mut closest);
        let found = closest.found;
        Ok(found.map(|(packet, lane, _)| nearest_of(packet, lane, position)))
    }

    /// Visits the packets whose boxes are nearer to a point than the square root of `limit`, near
    /// ones first.
    #[inline]
    pub(super) fn approach<'a>(
        &'a self,
        point: Vector<f64>,
        limit: f64,
        visitor: &mut impl Visitor<'a>,
    ) {
        Batch::new().run(Approach {
            bvh: self,
            point,
            limit,
            visitor,
        });
    }
}

/// What is done at the packets whose boxes are near a point.
pub(super) trait Visitor<'a> {
    /// Visits a packet, and returns the limit of squared distances from then on.
    fn visit(&mut self, screen: &Screen, packet: &'a Packet) -> f64;
}

/// Looks for the nearest point.
struct ClosestVisited<'a> {
    point: Vector<f64>,
    /// The point in the frame, and a bound of its errors.
    position: Vector<f32>,
    error: f32,
    scale: f64,
    /// The limit of squared distances for screens.
    limit: f32,
    /// The least squared distance.
    best: f64,
    /// The packet, the lane and the triangle.
    found: Option<(&'a Packet, usize, u32)>,
}

impl ClosestVisited<'_> {
    #[inline(always)]
    fn new(frame: &Frame, point: Vector<f64>, best: f64) -> Self {
        let ([x, y, z], error) = Frame::rounded(frame.position(point), 0.0);
        let mut closest = Self {
            point,
            position: Vector::new(x, y, z),
            error,
            scale: frame.scale,
            limit: f32::INFINITY,
            best,
            found: None,
        };
        closest.set_best(best);
        closest
    }

    #[inline(always)]
    fn set_best(&mut self, square: f64) {
        self.best = square;
        // Several times the rounding errors of offsets, which are sums and differences of a few
        // positions.
        let reach = ((square.sqrt() * self.scale) as f32 + 8.0 * self.error) * LARGER;
        self.limit = reach * reach * LARGER;
    }
}

impl<'a> Visitor<'a> for ClosestVisited<'a> {
    #[inline(always)]
    fn visit(&mut self, screen: &Screen, packet: &'a Packet) -> f64 {
        let squares = screen.squares(self.position);
        let mut rest = 0_u32;
        for (lane, square) in squares.into_iter().enumerate() {
            // Not "below the limit", since a square that is NaN decides nothing.
            rest |= u32::from(!self.limit.less_than(square)) << lane;
        }
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % WIDTH;
            rest &= rest - 1;
            if self.limit.less_than(squares[lane]) {
                continue;
            }
            let square = closest(self.point, packet.triangle(lane)).square;
            let triangle = packet.triangles[lane];
            if square <= self.best
                && (square < self.best || self.found.is_none_or(|(_, _, other)| triangle < other))
            {
                self.set_best(square);
                self.found = Some((packet, lane, triangle));
            }
        }
        self.best
    }
}

impl Screen {
    /// The squared distances of the triangles from a point, or a little less.
    #[inline(always)]
    fn squares(&self, point: Vector<f32>) -> [f32; WIDTH] {
        let mut squares = [0.0; WIDTH];
        // A loop over single numbers is compiled to vector instructions as a whole; operations on
        // lanes, one after the other, are too many here for the compiler to keep them together.
        for (lane, square) in squares.iter_mut().enumerate() {
            let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = &self.corners;
            *square = screened(
                point,
                Vector::new(ax[lane], ay[lane], az[lane]),
                Vector::new(bx[lane], by[lane], bz[lane]),
                Vector::new(cx[lane], cy[lane], cz[lane]),
            );
        }
        squares
    }
}

/// The squared distance of a triangle from a point, or a little less.
#[inline(always)]
fn screened(point: Vector<f32>, a: Vector<f32>, b: Vector<f32>, c: Vector<f32>) -> f32 {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let bc = ac - ab;
    let (ab_square, ac_square) = (ab.dot(ab), ac.dot(ac));
    let to_ab = square_to_segment(ap, ab, ab_square);
    let to_ac = square_to_segment(ap, ac, ac_square);
    let to_bc = square_to_segment(ap - ab, bc, bc.dot(bc));
    let to_edges = Real::min(Real::min(to_ab, to_ac), to_bc);

    let normal = ab.cross(ac);
    let (v, w) = (ap.cross(ac).dot(normal), ab.cross(ap).dot(normal));
    let whole = normal.dot(normal);
    let height = ap.dot(normal);
    // The foot of the perpendicular lies inside where the least area is positive.
    let is_inside = 0.0 < Real::min(Real::min(v, w), whole - v - w);
    let square = f32::select(is_inside, height * height / whole, to_edges);
    // The height has an error of 2⁻¹⁶ of the distance from the corner, as the normal has; twice as
    // much is allowed for.
    square - (ap.dot(ap) + ab_square + ac_square) * (1.0 / (1 << 14) as f32)
}

/// The squared distance from a segment, which runs from the origin and has this squared length.
#[inline(always)]
fn square_to_segment(point: Vector<f32>, segment: Vector<f32>, square: f32) -> f32 {
    let part = Real::min(Real::max(0.0, point.dot(segment) / square), 1.0);
    let offset = point - segment * part;
    offset.dot(offset)
}

/// A visit of the packets whose boxes are near a point.
struct Approach<'a, 'v, V> {
    bvh: &'a Bvh,
    point: Vector<f64>,
    /// The square of the greatest distance.
    limit: f64,
    visitor: &'v mut V,
}

impl<'a, V: Visitor<'a>> Work for Approach<'a, '_, V> {
    #[inline(always)]
    fn run(self) {
        let bvh = self.bvh;
        if bvh.nodes.is_empty() {
            return;
        }
        let (position, error) = Frame::rounded(bvh.frame.position(self.point), 0.0);
        let mut reach = Reach {
            below: [Children::splat(error); 3],
            above: [Children::splat(-error); 3],
        };
        for (axis, x) in position.into_iter().enumerate() {
            let x = Children::splat(x);
            reach.below[axis] += x;
            reach.above[axis] += x;
        }
        let scale = bvh.frame.scale;
        let rounded = |square: f64| (square * scale * scale) as f32 * LARGER;
        let mut limit = rounded(self.limit);
        let mut stack = Stack::new();
        while let Some((square, reference)) = stack.pop() {
            if square > limit {
                continue;
            }
            if reference & LEAF == 0 {
                let node = &bvh.nodes[reference as usize];
                let squares = reach.squares(node);
                // A box that is empty has an infinite distance.
                let is_near = squares.less_or_equal(Children::splat(limit.min(f32::MAX)));
                stack.push(is_near, squares, &node.children);
            } else {
                let index = (reference ^ LEAF) as usize;
                let (Some(screen), Some(packet)) = (bvh.screens.get(index), bvh.packets.get(index))
                else {
                    continue;
                };
                limit = rounded(self.visitor.visit(screen, packet));
            }
        }
    }
}

/// A point made ready for tests with boxes, in the coordinates of the frame.
struct Reach {
    /// The point, moved towards boxes above it and below it by its error.
    below: [Children; 3],
    above: [Children; 3],
}

impl Reach {
    /// The squared distance to the box of each child, or a little less.
    #[inline(always)]
    fn squares(&self, node: &Node) -> Children {
        let zero = Children::splat(0.0);
        let mut sum = zero;
        for axis in 0..3 {
            let above = node.bounds[2 * axis] - self.below[axis];
            let below = self.above[axis] - node.bounds[2 * axis + 1];
            let outside = zero.max(above).max(below);
            sum += outside * outside;
        }
        sum
    }
}

/// The point of a triangle that is nearest to a point.
struct Closest<S> {
    /// The barycentric coordinates of the point.
    weights: [S; 3],
    /// The squared distance.
    square: S,
}

/// The barycentric coordinates of the point of a triangle that is nearest to a point.
pub(crate) fn closest_weights(point: Vector<f64>, corners: [Vector<f64>; 3]) -> [f64; 3] {
    closest(point, corners).weights
}

/// The point of a triangle that is nearest to a point: the foot of the perpendicular on its plane,
/// where that lies inside, or else the nearest point of an edge. A degenerate triangle has no
/// inside.
#[inline(always)]
fn closest<S: Real>(point: Vector<S>, [a, b, c]: [Vector<S>; 3]) -> Closest<S> {
    let (zero, one) = (S::zero(), S::one());
    let (ab, ac, ap) = (b - a, c - a, point - a);

    let (along_ab, square_ab) = along_segment(ap, ab);
    let (along_ac, square_ac) = along_segment(ap, ac);
    let (along_bc, square_bc) = along_segment(point - b, c - b);
    let mut best = Closest {
        weights: [one - along_ab, along_ab, zero],
        square: square_ab,
    };
    best.improve([one - along_ac, zero, along_ac], square_ac);
    best.improve([zero, one - along_bc, along_bc], square_bc);

    let normal = ab.cross(ac);
    let [v, w] = [ap.cross(ac).dot(normal), ab.cross(ap).dot(normal)];
    let sum = normal.dot(normal);
    let is_inside = zero.less_than(v) & zero.less_than(w) & (v + w).less_than(sum);
    let u = zero.max(sum - v - w) / sum;
    let (v, w) = (v / sum, w / sum);
    let offset = ap - ab * v - ac * w;
    let beyond = best.square + one;
    let square = S::select(is_inside, offset.dot(offset), beyond);
    best.improve([u, v, w], square);
    best
}

impl<S: Real> Closest<S> {
    /// Takes another point where that is nearer.
    #[inline(always)]
    fn improve(&mut self, weights: [S; 3], square: S) {
        let is_nearer = square.less_than(self.square);
        for (weight, other) in self.weights.iter_mut().zip(weights) {
            *weight = S::select(is_nearer, other, *weight);
        }
        self.square = S::select(is_nearer, square, self.square);
    }
}

/// The part of a segment, which runs from the origin, at which a point is nearest to it, from 0 to
/// 1, and the squared distance.
#[inline(always)]
fn along_segment<S: Real>(point: Vector<S>, segment: Vector<S>) -> (S, S) {
    let (zero, one) = (S::zero(), S::one());
    let (along, whole) = (point.dot(segment), segment.dot(segment));
    let part = S::select(along.less_than(whole), along / whole, one);
    let part = S::select(zero.less_than(along), part, zero);
    let offset = point - segment * part;
    (part, offset.dot(offset))
}

/// The nearest point of one triangle of a packet.
pub(super) fn nearest_of(packet: &Packet, lane: usize, position: Vector<f64>) -> Nearest {
    let [a, b, c] = packet.triangle(lane);
    let Closest { weights, square } = closest(position, [a, b, c]);
    let [u, v, w] = weights;
    Nearest {
        point: (a * u + b * v + c * w).into(),
        distance: square.sqrt(),
        triangle: packet.triangles[lane],
        barycentric: weights,
    }
}
