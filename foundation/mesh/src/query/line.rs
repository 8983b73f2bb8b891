//! The crossing of a line that is nearest to a point of it.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::scalar::{Lanes, Real};
use ga_runtime::vga3::Vector;

use super::Bvh;
use super::node::{Children, LEAF, Stack};
use super::packet::WIDTH;

/// Where a line crosses the surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineHit {
    /// The distance from the point of the query in the direction of the line.
    pub(crate) height: f64,
    pub(crate) triangle: u32,
    pub(crate) barycentric: [f64; 3],
}

impl Bvh {
    /// The crossing of the line through a point, in a direction of length 1, that is nearest to the
    /// point, at a distance of less than `reach`. Only triangles whose normal has a positive inner
    /// product with the direction are crossed. Of several at the same distance it is the one with
    /// the lowest index.
    pub(crate) fn nearest_crossing(
        &self,
        point: Vector<f64>,
        direction: Vector<f64>,
        reach: f64,
    ) -> Option<LineHit> {
        let mut found = None;
        Batch::new().run(NearestCrossing {
            bvh: self,
            point,
            direction,
            reach,
            found: &mut found,
        });
        found
    }
}

/// A search for the nearest crossing.
struct NearestCrossing<'a> {
    bvh: &'a Bvh,
    point: Vector<f64>,
    direction: Vector<f64>,
    reach: f64,
    found: &'a mut Option<LineHit>,
}

impl Work for NearestCrossing<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { bvh, reach, .. } = self;
        let start = Point::from(self.point - self.direction * reach);
        let ray = Ray::new_unchecked(start, self.direction.into());
        let Some(slabs) = bvh.slabs(ray) else {
            return;
        };
        let test = ray.triangle_test();
        let middle = ((reach - slabs.skipped) * slabs.scale) as f32;
        // Distances from the middle, rounded up.
        let rounded = |height: f64| slabs.rounded(height + slabs.skipped) + middle.abs() * 1e-6;
        let mut best = reach;
        let mut found: Option<LineHit> = None;
        let mut limit = rounded(best);
        let mut stack = Stack::new();
        while let Some((distance, reference)) = stack.pop() {
            if distance > limit {
                continue;
            }
            if reference & LEAF == 0 {
                let node = &bvh.nodes[reference as usize];
                let [enters, leaves] = slabs.interval(node, middle + limit);
                let centre = Children::splat(middle);
                let zero = Children::splat(0.0);
                let distance = zero.max(enters - centre).max(centre - leaves);
                let is_met =
                    enters.less_or_equal(leaves) & distance.less_or_equal(Children::splat(limit));
                stack.push(is_met, distance, &node.children);
                continue;
            }
            let Some(packet) = bvh.packet(reference) else {
                continue;
            };
            let crossing = test.crossing(&packet.corners);
            let heights = crossing.distance - Lanes::splat(reach);
            let is_met = crossing.is_hit
                & Lanes::splat(0.0).less_than(crossing.slope)
                & heights.abs().less_or_equal(Lanes::splat(best));
            let is_met = is_met.to_array();
            if is_met == [false; WIDTH] {
                continue;
            }
            for lane in 0..WIDTH {
                let (height, triangle) = (heights[lane], packet.triangles[lane]);
                let is_nearer = height.abs() < best
                    || height.abs() == best && found.is_some_and(|found| triangle < found.triangle);
                if is_met[lane] && is_nearer {
                    best = height.abs();
                    let [u, v, w] = crossing.areas;
                    let [u, v, w] = [u[lane], v[lane], w[lane]];
                    let sum = u + v + w;
                    found = Some(LineHit {
                        height,
                        triangle,
                        barycentric: [u / sum, v / sum, w / sum],
                    });
                }
            }
            limit = rounded(best);
        }
        *self.found = found;
    }
}
