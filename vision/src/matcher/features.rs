//! What is compared between the views: the census transform, the level and the horizontal slope of
//! each pixel (R. Zabih and J. Woodfill, "Non-parametric local transforms for computing visual
//! correspondence", European Conference on Computer Vision, 1994).

use super::view::{MARGIN, View};

/// The bytes of a census: 9 columns × 7 rows without the centre are 62 bits.
pub(super) const PLANES: usize = 8;
/// Columns and rows of the census on either side.
const REACH: [isize; 2] = [4, 3];

/// The features of the pixels of one row, byte by byte: plane *p* has byte *p* of every census.
/// Behind the last pixel the planes continue with zeros, so that whole blocks may be read there.
#[derive(Clone, Debug, Default)]
pub(super) struct Features {
    pub(super) census: [Vec<u8>; PLANES],
    pub(super) levels: Vec<u8>,
    /// A quarter of the Sobel filter's horizontal derivative, plus 128.
    pub(super) slopes: Vec<u8>,
}

impl Features {
    /// For rows of `width` pixels, continued by `slack`.
    pub(super) fn new(width: usize, slack: usize) -> Self {
        let row = || vec![0; width + slack];
        Self {
            census: std::array::from_fn(|_| row()),
            levels: row(),
            slopes: row(),
        }
    }

    /// The features of a row. Beyond the border of the view, its outermost pixels are repeated.
    ///
    /// A bit of the census says that the neighbour is darker than the pixel. In a mirrored view the
    /// bits are those of the neighbours before mirroring, and so is the sign of the slope.
    #[inline(always)]
    pub(super) fn compute(&mut self, view: &View, row: usize) {
        let row = row.cast_signed();
        match view.is_fine() {
            true => self.compute_census(view, |dy| view.padded_fine(row + dy)),
            false => self.compute_census(view, |dy| view.padded(row + dy)),
        }
        self.compute_slopes(view, row);
    }

    /// The census of a row from the lines around it, by their distance from it.
    #[inline(always)]
    fn compute_census<'a, T: Copy + PartialOrd + 'a>(
        &mut self,
        view: &View,
        lines: impl Fn(isize) -> &'a [T],
    ) {
        let width = view.width();
        let sign = if view.is_mirrored() { -1 } else { 1 };
        let centre = &lines(0)[MARGIN..][..width];
        let mut bit = 0;
        for plane in &mut self.census {
            plane[..width].fill(0);
        }
        for dy in -REACH[1]..=REACH[1] {
            let line = lines(dy);
            for dx in -REACH[0]..=REACH[0] {
                if (dx, dy) == (0, 0) {
                    continue;
                }
                let start = (MARGIN.cast_signed() + sign * dx).cast_unsigned();
                let neighbours = &line[start..][..width];
                let plane = &mut self.census[bit / 8][..width];
                let value = 1u8 << (bit % 8);
                for ((byte, neighbour), pixel) in plane.iter_mut().zip(neighbours).zip(centre) {
                    *byte |= if neighbour < pixel { value } else { 0 };
                }
                bit += 1;
            }
        }
    }

    /// The levels and slopes of a row.
    #[inline(always)]
    pub(super) fn compute_slopes(&mut self, view: &View, row: isize) {
        let width = view.width();
        let sign = if view.is_mirrored() { -1 } else { 1 };
        let centre = &view.padded(row)[MARGIN..][..width];
        self.levels[..width].copy_from_slice(centre);
        let [above, middle, below] = [-1, 0, 1].map(|dy| &view.padded(row + dy)[MARGIN - 1..]);
        let slopes = &mut self.slopes[..width];
        for (x, slope) in slopes.iter_mut().enumerate() {
            let side =
                |x: usize| i16::from(above[x]) + 2 * i16::from(middle[x]) + i16::from(below[x]);
            let difference = (side(x + 2) - side(x)) * sign;
            *slope = ((difference >> 2).clamp(-128, 127) + 128) as u8;
        }
    }
}

/// Whether two pixels of a row have the same census.
pub(super) fn is_same_census(view: &View, row: usize, columns: [usize; 2]) -> bool {
    let row = row.cast_signed();
    match view.is_fine() {
        true => has_same_signs(columns, |dy| view.padded_fine(row + dy)),
        false => has_same_signs(columns, |dy| view.padded(row + dy)),
    }
}

#[inline(always)]
fn has_same_signs<'a, T: Copy + PartialOrd + 'a>(
    columns: [usize; 2],
    lines: impl Fn(isize) -> &'a [T],
) -> bool {
    let centre = lines(0);
    // From the middle outwards: rows near it differ first.
    [0, -1, 1, -2, 2, -3, 3].into_iter().all(|dy| {
        let line = lines(dy);
        let [a, b] = columns.map(|column| {
            let level = centre[column + MARGIN];
            let start = column + MARGIN - REACH[0].unsigned_abs();
            line[start..][..2 * REACH[0].unsigned_abs() + 1]
                .iter()
                .map(move |neighbour| *neighbour < level)
        });
        a.eq(b)
    })
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::*;
    use crate::matcher::view::View;

    /// By hand: the centre of a picture that rises to the right is brighter than all columns to its
    /// left, and the slope is 8 · 2 / 4.
    #[test]
    fn a_ramp_has_its_left_half_darker() {
        let plane = Plane::from_fn(20, 9, |column, _| (2 * column) as u8);
        let identity = |level: u8| level;
        for mirrored in [false, true] {
            let mut view = View::new(20, 9, mirrored);
            view.fill(plane.view(), identity, 0);
            let mut features = Features::new(20, 32);
            features.compute(&view, 4);
            let column = if mirrored { 19 - 10 } else { 10 };
            let mut expected = [0u8; PLANES];
            let mut bit = 0;
            for dy in -3..=3 {
                for dx in -4..=4 {
                    if (dx, dy) != (0, 0) {
                        expected[bit / 8] |= u8::from(dx < 0) << (bit % 8);
                        bit += 1;
                    }
                }
            }
            let found: [u8; PLANES] = std::array::from_fn(|p| features.census[p][column]);
            assert_eq!(found, expected, "mirrored: {mirrored}");
            assert_eq!(features.slopes[column], 128 + 4);
            assert_eq!(features.levels[column], 20);
        }
    }
}
