//! How uncertain a point is, for pixels with independent noise of equal size.

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

/// A camera prepared for the derivatives of its pixels: where a point is in its frame, and how its
/// two coordinates depend on the point.
///
/// At a point b as seen from the centre, of depth z, the gradients of both coordinates of the pixel
/// are `f_x ((b·Z) X − (b·X) Z)/z² = f_x Y × b/z²` and `−f_y X × b/z²`, with X, Y, Z the axes of
/// the camera: the coordinates change with a motion about the centre, and not along the ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// `f_x Y` and `f_y X` in the world.
    axes: [Vector<f64>; 2],
    /// The optical axis Z in the world.
    forward: Vector<f64>,
    centre: Vector<f64>,
}

impl Sight {
    pub(super) fn new(world_to_camera: Motor<f64>, focal: [f64; 2]) -> Self {
        let to_world = world_to_camera.reverse();
        let rotation = to_world.rotor();
        let axis = |axis: Vector<f64>| Vector::from(rotation.transform(Point::from(axis)));
        Self {
            axes: [axis(Vector::Y) * focal[0], axis(Vector::X) * focal[1]],
            forward: axis(Vector::Z),
            centre: Vector::from(to_world.transform(Point::default())),
        }
    }

    /// The information about a point that both coordinates of its pixel contain, `Σ g gᵀ` over the
    /// gradients g, as xx, xy, xz, yy, yz, zz and multiplied by z⁴, and z⁴.
    #[inline(always)]
    fn information(&self, point: Vector<f64>) -> ([f64; 6], f64) {
        let between = point - self.centre;
        let [g, h] = [self.axes[0].cross(between), self.axes[1].cross(between)];
        let depth = between.dot(self.forward);
        let square = depth * depth;
        let products = [
            g.e1 * g.e1 + h.e1 * h.e1,
            g.e1 * g.e2 + h.e1 * h.e2,
            g.e1 * g.e3 + h.e1 * h.e3,
            g.e2 * g.e2 + h.e2 * h.e2,
            g.e2 * g.e3 + h.e2 * h.e3,
            g.e3 * g.e3 + h.e3 * h.e3,
        ];
        (products, square * square)
    }
}

/// The covariance of a point seen by two cameras, as xx, xy, xz, yy, yz, zz: `σ² (Σ g gᵀ)⁻¹` over
/// the gradients g of all four pixel coordinates. All entries are 0 where a depth is 0, if they are
/// numbers.
#[inline(always)]
pub(super) fn covariance(sights: &[Sight; 2], point: Vector<f64>, variance: f64) -> [f64; 6] {
    let (left, left_depth) = sights[0].information(point);
    let (right, right_depth) = sights[1].information(point);
    let mut information = left;
    for (sum, right) in information.iter_mut().zip(right) {
        *sum = *sum * right_depth + right * left_depth;
    }
    inverse(information, variance * (left_depth * right_depth))
}

/// The volume of the rows of an information matrix, as a part of the product of its diagonal, from
/// which on it counts as singular: that of rays at an angle of about 1e-6.
const SINGULAR: f64 = 1e-13;

/// A multiple of the inverse of a positive definite matrix, each as xx, xy, xz, yy, yz, zz: the
/// inverse has the cross products of the rows, divided by their volume. NaN where the matrix is
/// singular.
#[inline(always)]
fn inverse([xx, xy, xz, yy, yz, zz]: [f64; 6], factor: f64) -> [f64; 6] {
    let rows = [
        Vector::new(xx, xy, xz),
        Vector::new(xy, yy, yz),
        Vector::new(xz, yz, zz),
    ];
    let first = rows[1].cross(rows[2]);
    let second = rows[2].cross(rows[0]);
    // On the line of both centres the volume is zero, or what rounding leaves of it.
    let volume = rows[0].dot(first);
    let is_regular = volume > SINGULAR * (xx * yy * zz);
    let by_volume = if is_regular {
        factor / volume
    } else {
        f64::NAN
    };
    [
        first.e1 * by_volume,
        first.e2 * by_volume,
        first.e3 * by_volume,
        second.e2 * by_volume,
        second.e3 * by_volume,
        (xx * yy - xy * xy) * by_volume,
    ]
}
