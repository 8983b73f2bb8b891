//! Packets of triangles.

use ga_runtime::cga3::Point;
use ga_runtime::scalar::Lanes;
use ga_runtime::vga3::Vector;

use super::frame::Frame;

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

    /// The corners in the frame.
    pub(super) fn screen(&self, frame: &Frame) -> Screen {
        let mut screen = Screen {
            corners: [[Lanes::splat(f32::NAN); 3]; 3],
        };
        for lane in 0..WIDTH {
            let corners = self.triangle(lane).map(|corner| {
                let position = frame.position(corner).coordinates();
                position.map(|x| x as f32)
            });
            if !has_exact_normal(corners.map(|corner| corner.map(f64::from).into())) {
                continue;
            }
            for (row, corner) in screen.corners.iter_mut().zip(corners) {
                for (numbers, x) in row.iter_mut().zip(corner) {
                    numbers[lane] = x;
                }
            }
        }
        screen
    }

    /// The lanes that hold different triangles.
    pub(super) fn lanes(&self) -> std::ops::Range<usize> {
        let repeated = self.triangles.windows(2).rev();
        0..WIDTH - repeated.take_while(|pair| pair[0] == pair[1]).count()
    }
}

/// The corners of the triangles of a packet in the frame, rounded to single precision, by which
/// most triangles are seen to be too far away. They take half of the memory. Triangles whose normal
/// single precision does not give have corners that are NaN, by which nothing is decided.
#[derive(Clone, Debug)]
pub(super) struct Screen {
    /// The coordinates x, y and z of the first, second and third corners.
    pub(super) corners: [[Lanes<f32, WIDTH>; 3]; 3],
}

/// Whether a triangle is neither a sliver nor very small, so that the rounding errors of its normal
/// in single precision are below 2⁻¹⁶ of its length: the product of two sides is at most 2⁶ times
/// the length, and each side has an error of 2⁻²⁴.
fn has_exact_normal([a, b, c]: [Vector<f64>; 3]) -> bool {
    let (ab, ac) = (b - a, c - a);
    let length = ab.cross(ac).length();
    length > 1e-12 && ab.length() * ac.length() <= 64.0 * length
}
