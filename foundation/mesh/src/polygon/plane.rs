//! The plane that fits a polygon best.

use ga_runtime::vga3::Vector;

use crate::normals::area_vector;

/// A polygon and the normal of the plane that fits it best.
///
/// The normal n is the direction of the area vector `Σ pᵢ × pᵢ₊₁ / 2`, as of Newell: of all
/// projections of the polygon that along n has the greatest area.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plane {
    /// The corners from the first one, in a unit that makes the farthest between 1 and 2.
    corners: Vec<Vector<f64>>,
    /// The area vector; zero for a polygon without an area.
    area: Vector<f64>,
    normal: Vector<f64>,
}

/// How far from a plane or a straight line a corner may lie, as a part of the size of its polygon,
/// so that the rounding of coordinates in files does not count.
const FLATNESS: f64 = 1e-5;

impl Plane {
    /// The plane of a polygon, in place of the one before.
    pub(crate) fn set(&mut self, polygon: impl Iterator<Item = Vector<f64>> + Clone) {
        self.corners.clear();
        self.area = Vector::ZERO;
        self.normal = Vector::ZERO;
        let Some(first) = polygon.clone().next() else {
            return;
        };
        // Differences of the largest numbers would overflow.
        let far = polygon
            .clone()
            .any(|corner| largest(corner) > f64::MAX / 4.0);
        let shrink = if far { 0.125 } else { 1.0 };
        let from_first = polygon.map(|corner| corner * shrink - first * shrink);
        self.corners.extend(from_first);
        let size = self
            .corners
            .iter()
            .copied()
            .map(largest)
            .fold(0.0, f64::max);
        if size == 0.0 {
            return;
        }
        // Areas of tiny polygons would be rounded to 0. A power of two changes no digit.
        let exponent = size.to_bits() & f64::INFINITY.to_bits();
        let unit = f64::from_bits(exponent).max(f64::MIN_POSITIVE);
        self.corners
            .iter_mut()
            .for_each(|corner| *corner *= 1.0 / unit);
        let fan = (1..self.corners.len() - 1).map(|i| [0, i, i + 1]);
        self.area = fan.fold(Vector::ZERO, |sum, triangle| sum + self.doubled(triangle)) * 0.5;
        self.normal = self.area.normalized().unwrap_or_default();
    }

    pub(crate) fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether the area vector is zero.
    pub(crate) fn is_degenerate(&self) -> bool {
        self.area == Vector::ZERO
    }

    /// Whether some corner lies out of the plane through the mean of all.
    pub(crate) fn is_bent(&self) -> bool {
        let sum = self
            .corners
            .iter()
            .fold(Vector::ZERO, |sum, &corner| sum + corner);
        let height = sum.dot(self.normal) / self.corners.len() as f64;
        let mut corners = self.corners.iter();
        corners.any(|corner| (corner.dot(self.normal) - height).abs() > FLATNESS)
    }

    /// Whether the angle inside the polygon is more than 180° at some corner, seen along the
    /// normal.
    pub(crate) fn is_concave(&self) -> bool {
        let count = self.corners.len();
        (0..count).any(|i| {
            let triangle = [(i + count - 1) % count, i, (i + 1) % count];
            let base = self.corners[triangle[0]].distance(self.corners[triangle[2]]);
            self.doubled_area(triangle) < -FLATNESS * base
        })
    }

    /// Twice the area of the projection of a triangle of corners, negative where it runs the other
    /// way round than the polygon.
    pub(crate) fn doubled_area(&self, triangle: [usize; 3]) -> f64 {
        self.doubled(triangle).dot(self.normal)
    }

    /// Twice the area of the projection of the polygon.
    pub(crate) fn doubled_area_of_all(&self) -> f64 {
        2.0 * self.area.length()
    }

    /// The square of the distance of two corners.
    pub(crate) fn square_distance(&self, a: u32, b: u32) -> f64 {
        let offset = self.corners[a as usize] - self.corners[b as usize];
        offset.dot(offset)
    }

    /// The corners in the plane.
    pub(crate) fn projected(&self) -> impl Iterator<Item = [f64; 2]> {
        let axes = self.normal.orthonormal_pair();
        self.corners
            .iter()
            .map(move |&corner| axes.map(|axis| axis.dot(corner)))
    }

    fn doubled(&self, triangle: [usize; 3]) -> Vector<f64> {
        area_vector(triangle.map(|corner| self.corners[corner]))
    }
}

fn largest(vector: Vector<f64>) -> f64 {
    vector
        .coordinates()
        .into_iter()
        .fold(0.0, |most: f64, x| most.max(x.abs()))
}
