//! Clipping of polygons in the camera's frame, so that every corner that is left can be projected.

use crate::Vector;

/// The half-spaces that a polygon has to lie in: between the near and the far depth, and within a
/// pyramid around the picture.
pub(crate) struct Clipper {
    depths: [f64; 2],
    /// The least and the greatest slopes `x' / depth` and `y / depth`.
    low: [f64; 2],
    high: [f64; 2],
    /// `x' = x + shear y`.
    shear: f64,
}

/// Near, far, left, right, below, above.
const PLANES: usize = 6;

/// The corners of a clipped triangle: one more than it had for each of the planes, at most.
pub(crate) struct Polygon {
    corners: [Vector; 3 + PLANES],
    len: usize,
}

impl Polygon {
    pub(crate) fn corners(&self) -> &[Vector] {
        &self.corners[..self.len]
    }

    fn push(&mut self, corner: Vector) {
        self.corners[self.len] = corner;
        self.len += 1;
    }

    fn empty() -> Self {
        Self {
            corners: [Vector::default(); 3 + PLANES],
            len: 0,
        }
    }
}

impl Clipper {
    /// The half-spaces between two depths and two slopes `(x + shear y) / depth` and `y / depth`.
    pub(crate) fn new(depths: [f64; 2], low: [f64; 2], high: [f64; 2], shear: f64) -> Self {
        Self {
            depths,
            low,
            high,
            shear,
        }
    }

    /// The part of a triangle, given by right offset, up offset and depth, that lies in all
    /// half-spaces.
    pub(crate) fn clip(&self, triangle: [Vector; 3]) -> Polygon {
        let mut polygon = Polygon::empty();
        for corner in triangle {
            polygon.push(corner);
        }
        for plane in 0..PLANES {
            let outside = |corner: &Vector| self.signed_distance(plane, *corner) < 0.0;
            if polygon.corners().iter().any(outside) {
                polygon = self.cut(plane, &polygon);
            }
        }
        polygon
    }

    /// The part of a segment that lies in all half-spaces.
    pub(crate) fn clip_segment(&self, mut ends: [Vector; 2]) -> Option<[Vector; 2]> {
        for plane in 0..PLANES {
            let [a, b] = ends;
            let (da, db) = (
                self.signed_distance(plane, a),
                self.signed_distance(plane, b),
            );
            ends = match (da >= 0.0, db >= 0.0) {
                (true, true) => ends,
                (false, false) => return None,
                (true, false) => [a, crossing(a, b, da, db)],
                (false, true) => [crossing(a, b, da, db), b],
            };
        }
        Some(ends)
    }

    /// Sutherland and Hodgman's step for one plane.
    fn cut(&self, plane: usize, polygon: &Polygon) -> Polygon {
        let corners = polygon.corners();
        let mut cut = Polygon::empty();
        for (i, &corner) in corners.iter().enumerate() {
            let next = corners[(i + 1) % corners.len()];
            let (here, there) = (
                self.signed_distance(plane, corner),
                self.signed_distance(plane, next),
            );
            if here >= 0.0 {
                cut.push(corner);
            }
            if (here >= 0.0) != (there >= 0.0) {
                cut.push(crossing(corner, next, here, there));
            }
        }
        cut
    }

    /// Positive inside, linear in the point.
    fn signed_distance(&self, plane: usize, point: Vector) -> f64 {
        let [x, y, depth] = point.coordinates();
        let x = x + self.shear * y;
        match plane {
            0 => depth - self.depths[0],
            1 => self.depths[1] - depth,
            2 => x - self.low[0] * depth,
            3 => self.high[0] * depth - x,
            4 => y - self.low[1] * depth,
            _ => self.high[1] * depth - y,
        }
    }
}

/// Always computed from the inner end, so that two triangles cut a shared edge at the same place.
fn crossing(a: Vector, b: Vector, da: f64, db: f64) -> Vector {
    if da >= 0.0 {
        a + (b - a) * (da / (da - db))
    } else {
        b + (a - b) * (db / (db - da))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FAR: f64 = f64::INFINITY;

    fn twice_area(corners: &[Vector]) -> f64 {
        corners
            .windows(2)
            .skip(1)
            .map(|pair| {
                let (a, b) = (pair[0] - corners[0], pair[1] - corners[0]);
                a.cross(b).e3
            })
            .sum()
    }

    #[test]
    fn a_triangle_half_behind_the_near_plane_keeps_its_front_part() {
        let clipper = Clipper::new([1.0, FAR], [-8e3; 2], [8e3; 2], 0.0);
        let triangle = [[0.0, 0.0, 3.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
        let front = [[0.0, 0.0, 3.0], [0.5, 0.0, 1.0], [-0.5, 0.0, 1.0]];
        let polygon = clipper.clip(triangle.map(Vector::from));
        assert_eq!(polygon.corners(), front.map(Vector::from));
    }

    proptest! {
        /// In a plane of constant depth the guard pyramid is a rectangle, and the area within has a
        /// closed form.
        #[test]
        fn a_right_triangle_loses_its_corners(size in 8.5f64..15.9) {
            let clipper = Clipper::new([0.5, FAR], [-8.0; 2], [8.0; 2], 0.0);
            let triangle = [[0.0, 0.0, 1.0], [size, 0.0, 1.0], [0.0, size, 1.0]].map(Vector::from);
            let cut_off = size - 8.0;
            let area = size * size - 2.0 * cut_off * cut_off;
            prop_assert!((twice_area(clipper.clip(triangle).corners()) - area).abs() < 1e-9);
        }

        #[test]
        fn every_corner_left_is_inside(triangle in prop::array::uniform3(prop::array::uniform3(-20f64..20.0))) {
            let clipper = Clipper::new([0.5, 9.0], [-2.4, -3.2], [2.4, 3.2], 0.3);
            for corner in clipper.clip(triangle.map(Vector::from)).corners() {
                for plane in 0..PLANES {
                    prop_assert!(clipper.signed_distance(plane, *corner) > -1e-9);
                }
            }
        }
    }
}
