//! Which texels belong to which triangle of a surface.

use ga_runtime::vga3::Vector;

use super::map::dilation;
use crate::TextureSpaceError;
use crate::atlas::{MAX_SIZE, raster};
use crate::query::closest_weights;

/// A texel and the point of the surface that it shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texel {
    /// Where it is in the rows of the texture, from the top, each from left to right.
    pub index: u32,
    /// The triangle to which it belongs.
    pub triangle: u32,
    /// The barycentric coordinates of the point, with sum 1, in the order of the corners.
    pub weights: [f64; 3],
}

/// The texels that the triangles of a surface touch in a square texture. A texel belongs to the
/// triangle in which its centre lies, or else to the first that touches it; it then shows the point
/// of that triangle that is nearest to its centre.
///
/// ```
/// use ga_mesh::bake::Texels;
///
/// // The triangle reaches 1.6 of 4 texels to the right and up.
/// let texels = Texels::new(&[[[0.0, 0.0], [0.4, 0.0], [0.0, 0.4]]], 4)?;
/// let indices: Vec<u32> = texels.iter().map(|texel| texel.index).collect();
/// assert_eq!(indices, [8, 12, 13]);
/// // The centre of texel 12 is half a texel to the right of the corner, and half a texel up.
/// let weights = texels.iter().nth(1).ok_or("three texels")?.weights;
/// assert!((weights[1] - 0.5 / 1.6).abs() < 1e-12 && (weights[2] - 0.5 / 1.6).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Texels {
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
    /// The texels of a square texture with the given side, for the texture coordinates (u, v) at
    /// the corners of each triangle, u to the right and v up, in the unit square.
    ///
    /// # Errors
    ///
    /// [`TextureSpaceError::MapSize`] and [`TextureSpaceError::CornerOutsideSquare`].
    pub fn new(coordinates: &[[[f64; 2]; 3]], size: u32) -> Result<Self, TextureSpaceError> {
        if !(1..=MAX_SIZE).contains(&size) {
            return Err(TextureSpaceError::MapSize { size });
        }
        let side = f64::from(size);
        let mut places = Vec::with_capacity(coordinates.len());
        for (triangle, &corners) in coordinates.iter().enumerate() {
            for coordinate in corners {
                if !coordinate.iter().all(|x| (0.0..=1.0).contains(x)) {
                    return Err(TextureSpaceError::CornerOutsideSquare {
                        triangle,
                        coordinate,
                    });
                }
            }
            places.push(corners.map(|[u, v]| [u * side, (1.0 - v) * side]));
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
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// For the texels around these, up to a number of steps to one of the eight neighbours, the
    /// texel from which each is copied, `[target, source]`, so that interpolation across the border
    /// of a chart reads no others.
    #[must_use]
    pub fn margin(&self, steps: u32) -> Vec<[u32; 2]> {
        let owned = (0..).zip(&self.owners).filter(|(_, owner)| **owner != NONE);
        let covered: Vec<u32> = owned.map(|(index, _)| index).collect();
        dilation(self.size, &covered, steps)
    }

    /// The texels in the order of their indices. They are computed one by one, since a list of them
    /// would take many times the memory of a map.
    pub fn iter(&self) -> impl Iterator<Item = Texel> + '_ {
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
#[derive(Clone, Copy, Debug, Default)]
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

    /// The triangle reaches 1.6 of 4 texels to the right and up: it touches two texels of the
    /// lowest row and one of the row above.
    #[test]
    fn the_texels_are_counted_before_they_are_computed() {
        let texels = Texels::new(&[[[0.0, 0.0], [0.4, 0.0], [0.0, 0.4]]], 4).unwrap();
        let indices: Vec<u32> = texels.iter().map(|texel| texel.index).collect();
        assert_eq!(indices, [8, 12, 13]);
        assert_eq!(texels.len(), 3);
    }
}
