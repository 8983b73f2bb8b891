//! How a polygon is split into triangles.

use earcut::Earcut;
use ga_runtime::vga3::Vector;

use super::fill::fill;
use super::plane::Plane;

/// Splits polygons into triangles, one after the other.
///
/// A polygon of n corners gives n − 2 triangles, whatever its shape. Where the polygon does not
/// cross itself, seen along the normal of its plane, they cover it once, so that their areas are
/// together that of the polygon if it is flat. Corners at one place, as of the bridge to a hole,
/// and corners on a straight line are allowed.
///
/// The triangles share the first corner where that is possible, as in every convex polygon, and a
/// quadrilateral has its other diagonal otherwise; the rest is done by clipping ears.
///
/// Source: Eberly, *Triangulation by Ear Clipping*, 2002; the code is that of the crate `earcut`.
pub(crate) struct Triangulation {
    plane: Plane,
    ears: Earcut<f64>,
    clipped: Vec<u32>,
}

/// Triangles below this part of the polygon's area are avoided.
const SLIVER: f64 = 1e-12;

impl Triangulation {
    pub(crate) fn new() -> Self {
        Self {
            plane: Plane::default(),
            ears: Earcut::new(),
            clipped: Vec::new(),
        }
    }

    /// Calls `push` with the triangles of a polygon of three corners or more. Each has its corners,
    /// numbered from 0, in rising order, and so the orientation of the polygon.
    pub(crate) fn split(
        &mut self,
        polygon: impl ExactSizeIterator<Item = Vector<f64>> + Clone,
        mut push: impl FnMut([u32; 3]),
    ) {
        let count = polygon.len();
        if count == 3 {
            return push([0, 1, 2]);
        }
        self.plane.set(polygon);
        let fan = (1..count - 1).map(|i| [0, i, i + 1]);
        let least = self.least_area(fan.clone());
        let push_one = |triangle: [usize; 3]| push(triangle.map(|corner| corner as u32));
        if self.plane.is_degenerate() || least > SLIVER * self.plane.doubled_area_of_all() {
            return fan.for_each(push_one);
        }
        if count == 4 {
            let other = [[0, 1, 3], [1, 2, 3]];
            return match self.least_area(other.into_iter()) > least {
                true => other.into_iter().for_each(push_one),
                false => fan.for_each(push_one),
            };
        }
        self.ears
            .earcut(self.plane.projected(), &[], &mut self.clipped);
        let clipped = self.clipped.as_chunks::<3>().0;
        fill(&self.plane, clipped).into_iter().for_each(push);
    }

    /// The least of the areas of some triangles, with their signs.
    fn least_area(&self, triangles: impl Iterator<Item = [usize; 3]>) -> f64 {
        let areas = triangles.map(|triangle| self.plane.doubled_area(triangle));
        areas.fold(f64::INFINITY, f64::min)
    }
}
