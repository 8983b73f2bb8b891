//! Which texels belong to which triangle of the coarse surface.

use ga_runtime::vga3::Vector;

use super::{BakeError, Coarse};
use crate::atlas::raster;
use crate::query::closest_weights;

/// A texel and the point of the coarse surface that it shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Texel {
    pub(super) index: u32,
    pub(super) triangle: u32,
    pub(super) weights: [f64; 3],
}

/// The texels that the triangles touch. A texel belongs to the triangle in which its centre lies,
/// or else to the first that touches it; it then shows the point of that triangle that is nearest
/// to its centre.
pub(super) struct Texels {
    size: u32,
    /// The corners of each triangle, in texels from the upper left corner.
    places: Vec<[[f64; 2]; 3]>,
    /// The triangle of each texel of the texture, or [`NONE`].
    owners: Vec<u32>,
    count: usize,
}

/// A texel does not belong to a triangle.
const NONE: u32 = u32::MAX;

impl Texels {
    pub(super) fn new(coarse: &Coarse, size: u32) -> Result<Self, BakeError> {
        let side = f64::from(size);
        let mut places = Vec::with_capacity(coarse.triangles.len());
        for (triangle, corners) in coarse.triangles.iter().enumerate() {
            for corner in corners {
                if !corner.coordinate.iter().all(|x| (0.0..=1.0).contains(x)) {
                    return Err(BakeError::OutsideSquare {
                        triangle,
                        coordinate: corner.coordinate,
                    });
                }
            }
            places.push(corners.map(|corner| {
                let [u, v] = corner.coordinate;
                [u * side, (1.0 - v) * side]
            }));
        }
        let mut owners = vec![NONE; size as usize * size as usize];
        let mut claim = |row: i64, [first, last]: [i64; 2], triangle: usize| {
            let last_column = i64::from(size) - 1;
            if row < 0 || row > last_column {
                return;
            }
            let start = row as usize * size as usize;
            let columns = first.max(0) as usize..=last.clamp(-1, last_column) as usize;
            if first > last_column || last < 0 {
                return;
            }
            for owner in &mut owners[start..start + size as usize][columns] {
                if *owner == NONE {
                    *owner = triangle as u32;
                }
            }
        };
        for (triangle, place) in places.iter().enumerate() {
            raster::centres(*place, |row, columns| claim(row, columns, triangle));
        }
        for (triangle, place) in places.iter().enumerate() {
            raster::touched(*place, 0.0, |row, columns| claim(row, columns, triangle));
        }
        Ok(Self {
            size,
            places,
            count: owners.iter().filter(|&&owner| owner != NONE).count(),
            owners,
        })
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// The texels in the order of their indices. They are computed one by one, since a list of them
    /// would take many times the memory of a map.
    pub(super) fn iter(&self) -> impl Iterator<Item = Texel> + '_ {
        let flat = |[x, y]: [f64; 2]| Vector::new(x, y, 0.0);
        let size = self.size as usize;
        let mut last = NONE;
        let mut weigh = Weigh::default();
        let owned = self
            .owners
            .iter()
            .enumerate()
            .filter(|&(_, &triangle)| triangle != NONE);
        owned.map(move |(index, &triangle)| {
            let place = &self.places[triangle as usize];
            if triangle != last {
                weigh = Weigh::new(*place);
                last = triangle;
            }
            let centre = [index % size, index / size].map(|place| place as f64 + 0.5);
            let mut weights = weigh.weights(centre);
            if !weights.iter().all(|w| (0.0..=1.0).contains(w)) {
                weights = closest_weights(flat(centre), place.map(flat));
            }
            Texel {
                index: index as u32,
                triangle,
                weights,
            }
        })
    }
}

/// Barycentric coordinates in a triangle of the texture.
#[derive(Default)]
struct Weigh {
    origin: [f64; 2],
    /// The gradients of the second and third coordinates.
    rows: [[f64; 2]; 2],
}

impl Weigh {
    fn new([a, b, c]: [[f64; 2]; 3]) -> Self {
        let ([bx, by], [cx, cy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let area = bx * cy - by * cx;
        Self {
            origin: a,
            rows: [[cy / area, -cx / area], [-by / area, bx / area]],
        }
    }

    fn weights(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let (x, y) = (x - self.origin[0], y - self.origin[1]);
        let [v, w] = [0, 1].map(|row: usize| self.rows[row][0] * x + self.rows[row][1] * y);
        [1.0 - v - w, v, w]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Mesh, obj};

    /// The triangle reaches 1.6 of 4 texels to the right and up: it touches two texels of the
    /// lowest row and one of the row above.
    #[test]
    fn the_texels_are_counted_before_they_are_computed() {
        let mesh: Mesh =
            obj::parse(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 0.4 0\nvt 0 0.4\nf 1/1 2/2 3/3\n")
                .unwrap();
        let texels = Texels::new(&Coarse::from_mesh(&mesh, 0).unwrap(), 4).unwrap();
        let indices: Vec<u32> = texels.iter().map(|texel| texel.index).collect();
        assert_eq!(indices, [8, 12, 13]);
        assert_eq!(texels.len(), 3);
    }
}
