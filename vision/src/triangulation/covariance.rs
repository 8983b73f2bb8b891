//! How uncertain a point is, for pixels with independent noise of equal size.

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::scalar::{Real, Ring};
use ga_runtime::vga3::Vector;

/// A camera prepared for the derivatives of its pixels: where a point is in its frame, and how its
/// two coordinates depend on the point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight<S> {
    /// The axes of the camera in the world.
    axes: [Vector<S>; 3],
    centre: Vector<S>,
    focal: [S; 2],
}

impl Sight<f64> {
    pub(super) fn new(world_to_camera: Motor<f64>, focal: [f64; 2]) -> Self {
        let to_world = world_to_camera.reverse();
        let rotation = to_world.rotor();
        let axes = [Vector::X, Vector::Y, Vector::Z];
        Self {
            axes: axes.map(|axis| {
                let turned = rotation.transform(Point::from(axis));
                Vector::from(turned)
            }),
            centre: Vector::from(to_world.transform(Point::default())),
            focal,
        }
    }

    /// The same over another scalar.
    #[inline(always)]
    pub(super) fn map<T: Ring>(&self, number: impl Fn(f64) -> T + Copy) -> Sight<T> {
        let vector = |vector: Vector<f64>| {
            let [x, y, z] = vector.coordinates().map(number);
            Vector::new(x, y, z)
        };
        Sight {
            axes: self.axes.map(vector),
            centre: vector(self.centre),
            focal: self.focal.map(number),
        }
    }
}

impl<S: Real> Sight<S> {
    /// The gradients of both coordinates of the pixel at a point of the world: `f_x (X − x/z Z)/z`
    /// and `f_y (Y − y/z Z)/z`, with X, Y, Z the axes of the camera.
    #[inline(always)]
    fn gradients(&self, point: Vector<S>) -> [Vector<S>; 2] {
        let [x_axis, y_axis, z_axis] = self.axes;
        let between = point - self.centre;
        let by_depth = between.dot(z_axis).recip();
        let x = between.dot(x_axis) * by_depth;
        let y = between.dot(y_axis) * by_depth;
        [
            (x_axis - z_axis * x) * (self.focal[0] * by_depth),
            (y_axis - z_axis * y) * (self.focal[1] * by_depth),
        ]
    }
}

/// The covariance of a point seen by two cameras, as xx, xy, xz, yy, yz, zz: `σ² (Σ g gᵀ)⁻¹` over
/// the gradients g of all four pixel coordinates.
#[inline(always)]
pub(super) fn covariance<S: Real>(sights: &[Sight<S>; 2], point: Vector<S>, variance: S) -> [S; 6] {
    let [a, b] = sights[0].gradients(point);
    let [c, d] = sights[1].gradients(point);
    let mut information = [S::zero(); 6];
    for g in [a, b, c, d] {
        let products = [
            g.e1 * g.e1,
            g.e1 * g.e2,
            g.e1 * g.e3,
            g.e2 * g.e2,
            g.e2 * g.e3,
            g.e3 * g.e3,
        ];
        for (sum, product) in information.iter_mut().zip(products) {
            *sum += product;
        }
    }
    inverse(information, variance)
}

/// A multiple of the inverse of a symmetric matrix, each as xx, xy, xz, yy, yz, zz: the inverse has
/// the cross products of the rows, divided by their volume.
#[inline(always)]
fn inverse<S: Real>([xx, xy, xz, yy, yz, zz]: [S; 6], factor: S) -> [S; 6] {
    let rows = [
        Vector::new(xx, xy, xz),
        Vector::new(xy, yy, yz),
        Vector::new(xz, yz, zz),
    ];
    let first = rows[1].cross(rows[2]);
    let second = rows[2].cross(rows[0]);
    let by_volume = factor / rows[0].dot(first);
    [
        first.e1 * by_volume,
        first.e2 * by_volume,
        first.e3 * by_volume,
        second.e2 * by_volume,
        second.e3 * by_volume,
        (xx * yy - xy * xy) * by_volume,
    ]
}
