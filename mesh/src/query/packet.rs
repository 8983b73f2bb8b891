//! Packets of triangles.

use ga_runtime::cga3::Point;
use ga_runtime::scalar::Lanes;
use ga_runtime::vga3::Vector;

/// How many triangles a packet holds, and how many children a node has.
pub(super) const WIDTH: usize = 4;

/// One number for each triangle of a packet.
pub(super) type Four = Lanes<f64, WIDTH>;

/// Up to four triangles side by side. Where there are fewer, the last one is repeated.
#[derive(Clone, Debug)]
pub(super) struct Packet {
    /// The coordinates x, y and z of the first, second and third corners.
    pub(super) corners: [[Four; 3]; 3],
    /// The indices of the triangles.
    pub(super) triangles: [u32; WIDTH],
}

impl Packet {
    /// The triangles of `indices`, which are at least one and at most four.
    pub(super) fn new(indices: [u32; WIDTH], corners: impl Fn(u32) -> [Vector<f64>; 3]) -> Self {
        let each = indices.map(corners);
        Self {
            corners: [0, 1, 2].map(|corner| {
                [0, 1, 2].map(|axis| Lanes::from_array(each.map(|triangle| triangle[corner][axis])))
            }),
            triangles: indices,
        }
    }

    /// The corners of all triangles.
    #[inline(always)]
    pub(super) fn vectors(&self) -> [Vector<Four>; 3] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.corners;
        [
            Vector::new(a, b, c),
            Vector::new(d, e, f),
            Vector::new(g, h, i),
        ]
    }

    /// The corners of one triangle.
    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> [Vector<f64>; 3] {
        let corner = |[x, y, z]: &[Four; 3]| Vector::new(x[lane], y[lane], z[lane]);
        let [a, b, c] = &self.corners;
        [corner(a), corner(b), corner(c)]
    }

    /// The corners of one triangle as conformal points.
    #[inline(always)]
    pub(super) fn points(&self, lane: usize) -> [Point<f64>; 3] {
        self.triangle(lane).map(Point::from)
    }

    /// The lanes that hold different triangles.
    pub(super) fn lanes(&self) -> std::ops::Range<usize> {
        let repeated = self.triangles.windows(2).rev();
        0..WIDTH - repeated.take_while(|pair| pair[0] == pair[1]).count()
    }
}
