//! What rays hit.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::geometry::ray::{Hit, Ray, TriangleTest};
use ga_runtime::scalar::{Lanes, Mask, Real};
use ga_runtime::vga3::Vector;

use super::Bvh;
use super::frame::Frame;
use super::node::{Children, LEAF, Node, Stack};
use super::packet::{Packet, WIDTH};

/// Where a ray hits the surface of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshHit {
    /// The hit of the triangle; its front is where the corners run counter-clockwise.
    pub hit: Hit<f64>,
    /// The index of the triangle.
    pub triangle: u32,
    /// The barycentric coordinates of the point, with sum 1, in the order of the corners.
    pub barycentric: [f64; 3],
}

/// More than the relative errors of distances in single precision.
const LARGER: f32 = 1.0 + 1.0 / (1 << 20) as f32;

impl Bvh {
    /// The first hit of a ray, at a distance of more than zero, as [`Ray::first_hit`] decides it
    /// for each triangle; `None` for a miss. Of several triangles at the same distance it is the
    /// one with the lowest index.
    ///
    /// ```
    /// use ga_mesh::query::Bvh;
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::{Ray, Side};
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    /// let triangle = Bvh::new(&corners, &[[0, 1, 2]])?;
    /// let ray = Ray::new(Point::new(1.0, 2.0, 5.0), [0.0, 0.0, -1.0]).unwrap();
    /// let found = triangle.first_hit(ray).unwrap();
    /// assert_eq!((found.hit.distance, found.hit.side()), (5.0, Side::Front));
    /// assert_eq!(found.barycentric, [0.25, 0.25, 0.5]);
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn first_hit(&self, ray: Ray<f64>) -> Option<MeshHit> {
        self.first_hit_within(ray, f64::INFINITY)
    }

    /// The first hit of a ray at a distance of less than `limit`.
    #[must_use]
    pub fn first_hit_within(&self, ray: Ray<f64>, limit: f64) -> Option<MeshHit> {
        let mut first = First {
            best: limit,
            found: None,
        };
        self.traverse(ray, limit, &mut first);
        let (packet, lane, _) = first.found?;
        hit_of(packet, lane, ray)
    }

    /// Whether a ray hits a triangle at a distance of more than zero and less than `limit`, which
    /// may be infinite. It takes less time than [`first_hit`](Self::first_hit).
    ///
    /// ```
    /// use ga_mesh::query::Bvh;
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::Ray;
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    /// let triangle = Bvh::new(&corners, &[[0, 1, 2]])?;
    /// let ray = Ray::new(Point::new(1.0, 2.0, 5.0), [0.0, 0.0, -1.0]).unwrap();
    /// assert!(triangle.is_hit(ray, f64::INFINITY));
    /// assert!(!triangle.is_hit(ray, 4.0));
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn is_hit(&self, ray: Ray<f64>, limit: f64) -> bool {
        let mut any = Any {
            limit,
            is_found: false,
        };
        self.traverse(ray, limit, &mut any);
        any.is_found
    }

    /// All hits of a ray, at distances of more than zero, in the order of distances and, where they
    /// are equal, of triangles. A ray through an edge may hit both of its triangles.
    #[must_use]
    pub fn all_hits(&self, ray: Ray<f64>) -> Vec<MeshHit> {
        let mut all = All {
            ray,
            hits: Vec::new(),
        };
        self.traverse(ray, f64::INFINITY, &mut all);
        let mut hits = all.hits;
        hits.sort_by(|a, b| {
            let order = a.hit.distance.total_cmp(&b.hit.distance);
            order.then(a.triangle.cmp(&b.triangle))
        });
        hits
    }

    /// Visits the packets whose boxes the ray meets before `limit`, near ones first.
    #[inline]
    fn traverse<'a>(&'a self, ray: Ray<f64>, limit: f64, visitor: &mut impl Visitor<'a>) {
        Batch::new().run(Traversal {
            bvh: self,
            ray,
            limit,
            visitor,
        });
    }

    /// The ray made ready for tests with boxes; `None` where it misses them all.
    #[inline(always)]
    pub(super) fn slabs(&self, ray: Ray<f64>) -> Option<Slabs> {
        let bounds = self.bounds?;
        let direction = Vector::from(ray.direction());
        let origin = Vector::from(ray.origin());
        let skipped = entry(bounds, origin, direction)?;
        let start = self.frame.position(origin + direction * skipped);
        let far = self.frame.position(origin).abs();
        let far = far.e1.max(far.e2).max(far.e3);
        let (start, error) = Frame::rounded(start, far);
        let components = direction.coordinates();
        // A component that is nearly zero moves the ray by less than the error of its start.
        let mut inverse = [0.0_f32; 3];
        for (inverse, x) in inverse.iter_mut().zip(components) {
            let x = x as f32;
            *inverse = if x.abs() < 1e-18 {
                1e18_f32.copysign(x)
            } else {
                x.recip()
            };
        }
        let mut slabs = Slabs {
            near_rows: [0; 3],
            near: [Children::splat(0.0); 3],
            far: [Children::splat(0.0); 3],
            inverse: [Children::splat(0.0); 3],
            skipped,
            scale: self.frame.scale,
            error,
        };
        for axis in 0..3 {
            let is_backward = inverse[axis] < 0.0;
            let margin = if is_backward { -error } else { error };
            slabs.inverse[axis] = Children::splat(inverse[axis]);
            slabs.near_rows[axis] = 2 * axis + usize::from(is_backward);
            slabs.near[axis] = Children::splat(start[axis] + margin);
            slabs.far[axis] = Children::splat(start[axis] - margin);
        }
        Some(slabs)
    }
}

/// What is done at the packets whose boxes a ray meets. It is not a closure, since those are not
/// always inlined, and would then be compiled without the instructions of [`Batch`].
trait Visitor<'a> {
    /// Visits a packet, and returns the limit of distances from then on, or `None` to stop.
    fn visit(&mut self, packet: &'a Packet, test: &TriangleTest<f64>) -> Option<f64>;
}

/// Looks for the first hit.
struct First<'a> {
    best: f64,
    /// The packet, the lane and the triangle.
    found: Option<(&'a Packet, usize, u32)>,
}

impl<'a> Visitor<'a> for First<'a> {
    #[inline(always)]
    fn visit(&mut self, packet: &'a Packet, test: &TriangleTest<f64>) -> Option<f64> {
        let crossing = test.crossing(&packet.corners);
        let is_close = crossing.distance.less_or_equal(Lanes::splat(self.best));
        let is_hit = (crossing.is_hit & is_close).to_array();
        if is_hit == [false; WIDTH] {
            return Some(self.best);
        }
        for (lane, is_hit) in is_hit.into_iter().enumerate() {
            let distance = crossing.distance[lane];
            let triangle = packet.triangles[lane];
            let is_first = distance < self.best
                || distance == self.best && self.found.is_some_and(|(_, _, t)| triangle < t);
            if is_hit && is_first {
                self.best = distance;
                self.found = Some((packet, lane, triangle));
            }
        }
        Some(self.best)
    }
}

/// Looks for any hit before a limit.
struct Any {
    limit: f64,
    is_found: bool,
}

impl<'a> Visitor<'a> for Any {
    #[inline(always)]
    fn visit(&mut self, packet: &'a Packet, test: &TriangleTest<f64>) -> Option<f64> {
        let crossing = test.crossing(&packet.corners);
        let is_close = crossing.distance.less_than(Lanes::splat(self.limit));
        self.is_found = (crossing.is_hit & is_close).any();
        (!self.is_found).then_some(self.limit)
    }
}

/// Collects all hits.
struct All {
    ray: Ray<f64>,
    hits: Vec<MeshHit>,
}

impl<'a> Visitor<'a> for All {
    #[inline(always)]
    fn visit(&mut self, packet: &'a Packet, test: &TriangleTest<f64>) -> Option<f64> {
        let crossing = test.crossing(&packet.corners);
        for lane in packet.lanes() {
            if crossing.is_hit[lane] {
                self.hits.extend(hit_of(packet, lane, self.ray));
            }
        }
        Some(f64::INFINITY)
    }
}

/// A visit of the packets whose boxes a ray meets before `limit`.
struct Traversal<'a, 'v, V> {
    bvh: &'a Bvh,
    ray: Ray<f64>,
    limit: f64,
    visitor: &'v mut V,
}

impl<'a, V: Visitor<'a>> Work for Traversal<'a, '_, V> {
    #[inline(always)]
    fn run(self) {
        let Some(slabs) = self.bvh.slabs(self.ray) else {
            return;
        };
        let test = self.ray.triangle_test();
        let mut limit = slabs.rounded(self.limit);
        let mut stack = Stack::new();
        while let Some((distance, reference)) = stack.pop() {
            if distance > limit {
                continue;
            }
            if reference & LEAF == 0 {
                let node = &self.bvh.nodes[reference as usize];
                let [enters, leaves] = slabs.interval(node, limit);
                stack.push(enters.less_or_equal(leaves), enters, &node.children);
            } else {
                let Some(packet) = self.bvh.packet(reference) else {
                    continue;
                };
                match self.visitor.visit(packet, &test) {
                    Some(rest) => limit = slabs.rounded(rest),
                    None => return,
                }
            }
        }
    }
}

/// A ray made ready for tests with boxes, in the coordinates of the frame.
pub(super) struct Slabs {
    /// The bounds through which the ray enters; those through which it leaves are the others of the
    /// same axes.
    near_rows: [usize; 3],
    /// The start, moved outwards by the error, for the bounds through which the ray enters and
    /// leaves.
    near: [Children; 3],
    far: [Children; 3],
    inverse: [Children; 3],
    /// The distance from the origin of the ray to the start.
    pub(super) skipped: f64,
    pub(super) scale: f64,
    pub(super) error: f32,
}

impl Slabs {
    /// At which distances from the start the ray enters and leaves the box of each child, from zero
    /// to the limit; it misses boxes that it leaves before it enters them.
    #[inline(always)]
    pub(super) fn interval(&self, node: &Node, limit: f32) -> [Children; 2] {
        let mut enters = Children::splat(0.0);
        let mut leaves = Children::splat(limit);
        for axis in 0..3 {
            let row = self.near_rows[axis];
            let near = (node.bounds[row] - self.near[axis]) * self.inverse[axis];
            let far = (node.bounds[row ^ 1] - self.far[axis]) * self.inverse[axis];
            enters = enters.max(near);
            leaves = leaves.min(far);
        }
        [enters, leaves * Children::splat(LARGER)]
    }

    /// A distance along the ray, from the start, in the coordinates of the frame, rounded up.
    #[inline(always)]
    pub(super) fn rounded(&self, distance: f64) -> f32 {
        ((distance - self.skipped) * self.scale) as f32 * LARGER + self.error
    }
}

/// The distance at which a ray enters a box, or a little less; zero where it begins inside, and
/// `None` where it misses the box.
#[inline(always)]
fn entry(
    [low, high]: [Vector<f64>; 2],
    origin: Vector<f64>,
    direction: Vector<f64>,
) -> Option<f64> {
    // As arrays, since the indices of those are known when the loop is unrolled.
    let [low, high] = [low.coordinates(), high.coordinates()];
    let (origin, direction) = (origin.coordinates(), direction.coordinates());
    let (mut enters, mut leaves) = (0.0_f64, f64::INFINITY);
    for axis in 0..3 {
        // More than the rounding errors of the differences below.
        let size = origin[axis].abs() + low[axis].abs() + high[axis].abs();
        let margin = size * (1.0 / (1_u64 << 48) as f64);
        let (to_low, to_high) = (low[axis] - origin[axis], high[axis] - origin[axis]);
        let (to_low, to_high) = (to_low - margin, to_high + margin);
        if direction[axis] == 0.0 {
            if to_low > 0.0 || to_high < 0.0 {
                return None;
            }
            continue;
        }
        let inverse = direction[axis].recip();
        let (a, b) = (to_low * inverse, to_high * inverse);
        let (a, b) = if a < b { (a, b) } else { (b, a) };
        enters = if a > enters { a } else { enters };
        leaves = if b < leaves { b } else { leaves };
    }
    const SMALLER: f64 = 1.0 - 1.0 / (1_u64 << 48) as f64;
    (enters * SMALLER <= leaves).then_some(enters * SMALLER)
}

/// The hit of one triangle of a packet.
fn hit_of(packet: &Packet, lane: usize, ray: Ray<f64>) -> Option<MeshHit> {
    let hit = ray.first_hit(packet.points(lane))?;
    let areas = ray.triangle_test().crossing(&packet.corners).areas;
    let [u, v, w] = areas.map(|area| area[lane]);
    let sum = u + v + w;
    Some(MeshHit {
        hit,
        triangle: packet.triangles[lane],
        barycentric: [u / sum, v / sum, w / sum],
    })
}
