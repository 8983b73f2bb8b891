//! Whether a grid of corners is a whole board, or all that the picture shows of one, and not a part
//! of a larger board or of clutter.
//!
//! What tells is the picture itself, not the grid: squares are bright and dark in turn around each
//! corner and over the whole board, and where the next row or column of corners would be there are
//! none. Places beyond are continued from the last three corners of each line, so that neither
//! perspective nor the distortion of a lens matters.

use ga_image::interpolation::bilinear;
use ga_image::plane::Plane;
use ga_runtime::vga2::Vector;

use super::BoardSize;

/// Corners that may be a board or a part of one.
pub(super) struct Candidate<'a> {
    pub(super) picture: &'a Plane<f32>,
    /// Row by row.
    pub(super) corners: &'a [Vector<f64>],
    pub(super) size: BoardSize,
    /// The size of the whole board.
    pub(super) whole: BoardSize,
}

/// A side of a board: the line of its outermost corners, and the way outwards.
struct Side {
    /// Whether the corners of the line are those of a row.
    is_row: bool,
    /// Whether the line is the last one.
    is_last: bool,
}

const SIDES: [Side; 4] = [
    Side {
        is_row: true,
        is_last: false,
    },
    Side {
        is_row: true,
        is_last: true,
    },
    Side {
        is_row: false,
        is_last: false,
    },
    Side {
        is_row: false,
        is_last: true,
    },
];

impl Candidate<'_> {
    /// Whether the corners are those of the whole board, or the border of the picture cuts it on a
    /// side of each kind that is too short.
    pub(super) fn is_cut_where_short(&self) -> bool {
        [false, true].into_iter().all(|is_row| {
            let mut sides = SIDES.iter().filter(|side| side.is_row == is_row);
            sides.any(|side| !self.is_short(side) || self.is_cut(side))
        })
    }

    /// Whether the squares between the corners are bright and dark in turn, and do not go on beyond
    /// the outermost squares but where the border of the picture cuts the whole board.
    pub(super) fn is_board(&self) -> bool {
        let is_cut = |side: &Side| self.is_short(side) && self.is_cut(side);
        self.has_crossings()
            && self.has_plain_squares()
            && SIDES.iter().all(|side| is_cut(side) || !self.goes_on(side))
    }

    /// Whether corners of the whole board are missing beyond a side or the opposite one.
    fn is_short(&self, side: &Side) -> bool {
        match side.is_row {
            true => self.size.rows() < self.whole.rows(),
            false => self.size.columns() < self.whole.columns(),
        }
    }

    fn corner(&self, column: usize, row: usize) -> Vector<f64> {
        self.corners[row * self.size.columns() + column]
    }

    /// Whether all corners are crossings, of which none is much paler than the others or has bright
    /// squares where its neighbours have dark ones.
    fn has_crossings(&self) -> bool {
        /// The least contrast of a crossing as a part of the mean.
        const PALEST: f64 = 0.2;
        let (columns, rows) = (self.size.columns(), self.size.rows());
        let signed = |index: usize| {
            let (column, row) = (index % columns, index / columns);
            let along = half_step(columns, column, |k| self.corner(k, row));
            let down = half_step(rows, row, |k| self.corner(column, k));
            let contrast = crossing(self.picture, self.corner(column, row), [along, down])?;
            Some(match (column + row).is_multiple_of(2) {
                true => contrast,
                false => -contrast,
            })
        };
        let contrasts = (0..self.corners.len()).map(signed);
        let Some(contrasts) = contrasts.collect::<Option<Vec<f64>>>() else {
            return false;
        };
        let mean = contrasts.iter().sum::<f64>() / contrasts.len() as f64;
        let is_alike = |contrast: &f64| contrast * mean > PALEST * mean * mean;
        contrasts.iter().all(is_alike)
    }

    /// Whether squares differ more from those beside them than within themselves. Those of a grid
    /// that leaves out corners contain several squares of the board.
    fn has_plain_squares(&self) -> bool {
        /// The greatest standard deviation within squares as a part of the difference.
        const GREATEST: f64 = 0.5;
        let (columns, rows) = (self.size.columns() - 1, self.size.rows() - 1);
        let squares = (0..columns * rows).map(|k| self.square(k % columns, k / columns));
        let Some(squares) = squares.collect::<Option<Vec<[f64; 2]>>>() else {
            return false;
        };
        let difference = |a: usize, b: usize| (squares[a][0] - squares[b][0]).abs();
        let along = (1..squares.len()).filter(|k| k % columns > 0);
        let down = columns..squares.len();
        let pairs = along
            .map(|k| [k - 1, k])
            .chain(down.map(|k| [k - columns, k]));
        let differences: Vec<f64> = pairs.map(|[a, b]| difference(a, b)).collect();
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        let variances = squares.iter().map(|square| square[1]);
        let variance = variances.sum::<f64>() / squares.len() as f64;
        variance.sqrt() < GREATEST * mean
    }

    /// The mean brightness of the square between a corner and its diagonal neighbour, and its
    /// variance.
    fn square(&self, column: usize, row: usize) -> Option<[f64; 2]> {
        const PARTS: [f64; 3] = [0.25, 0.5, 0.75];
        let [a, b] = [row, row + 1].map(|row| [column, column + 1].map(|k| self.corner(k, row)));
        let mut sums = [0.0; 2];
        for x in PARTS {
            for y in PARTS {
                let [upper, lower] = [a, b].map(|[from, to]| from + (to - from) * x);
                let place = upper + (lower - upper) * y;
                let value = bilinear(self.picture, place.coordinates())?;
                sums = [sums[0] + value, sums[1] + value * value];
            }
        }
        let [mean, square] = sums.map(|sum| sum / (PARTS.len() * PARTS.len()) as f64);
        Some([mean, square - mean * mean])
    }

    /// Whether there is a further line of corners beyond a side.
    fn goes_on(&self, side: &Side) -> bool {
        /// The least part of such a line that tells. What lies beside a board looks like a corner
        /// here and there; what covers a board may hide the rest of the line.
        const LEAST_PART: f64 = 0.4;
        /// The least contrast of a corner as a part of that of the corner before it.
        const LEAST_CONTRAST: f64 = 0.5;
        let count = self.count(side);
        let further = (0..count).filter(|&k| self.further_corner(side, k) > LEAST_CONTRAST);
        further.count() as f64 > LEAST_PART * count as f64
    }

    /// Whether the picture ends before the next line of corners beyond a side does.
    fn is_cut(&self, side: &Side) -> bool {
        let mut lines = 0..self.count(side);
        lines.any(|index| {
            let [expected, _] = self.beyond(side, index);
            bilinear(self.picture, expected.coordinates()).is_none()
        })
    }

    /// The number of corners along a side.
    fn count(&self, side: &Side) -> usize {
        match side.is_row {
            true => self.size.columns(),
            false => self.size.rows(),
        }
    }

    /// Where the next corner is expected on a line across a side, and the step to it.
    fn beyond(&self, side: &Side, index: usize) -> [Vector<f64>; 2] {
        let [last, before, third] = [0, 1, 2].map(|depth| self.inwards(side, index, depth));
        // Of equal second differences.
        let expected = (last - before) * 3.0 + third;
        [expected, expected - last]
    }

    /// A corner by its index along a side and the number of corners between it and the side.
    fn inwards(&self, side: &Side, index: usize, depth: usize) -> Vector<f64> {
        let depths = match side.is_row {
            true => self.size.rows(),
            false => self.size.columns(),
        };
        let depth = match side.is_last {
            true => depths - 1 - depth,
            false => depth,
        };
        match side.is_row {
            true => self.corner(index, depth),
            false => self.corner(depth, index),
        }
    }

    /// The greatest contrast of a crossing about where a line across a side goes on, as a part of
    /// that at the last corner.
    fn further_corner(&self, side: &Side, index: usize) -> f64 {
        /// How far the corner may be from where it is expected, in steps.
        const OFFSETS: [f64; 5] = [-0.2, -0.1, 0.0, 0.1, 0.2];
        let [last, before] = [0, 1].map(|depth| self.inwards(side, index, depth));
        let [expected, outwards] = self.beyond(side, index);
        let along = half_step(self.count(side), index, |k| self.inwards(side, k, 0));
        let Some(known) = crossing(self.picture, last, [last - before, along]) else {
            return 0.0;
        };
        let mut greatest = 0.0_f64;
        for x in OFFSETS {
            for y in OFFSETS {
                let place = expected + outwards * x + along * y;
                if let Some(found) = crossing(self.picture, place, [outwards, along]) {
                    // The squares of neighbours are exchanged.
                    greatest = greatest.max(-found / known);
                }
            }
        }
        greatest
    }
}

/// The step from one corner of a line to the next, at a corner: half of that from the corner before
/// to the one after, where there are both.
fn half_step(count: usize, index: usize, corner: impl Fn(usize) -> Vector<f64>) -> Vector<f64> {
    let (before, after) = (index.saturating_sub(1), (index + 1).min(count - 1));
    (corner(after) - corner(before)) * (1.0 / (after - before) as f64)
}

/// By how much the darker one of two opposite squares that meet at a place is brighter than the
/// brighter one of the other two. It is positive where those between both steps, and between their
/// negatives, are the bright ones, negative where the others are, and 0 where neither are. `None`
/// for a place outside the picture.
fn crossing(picture: &Plane<f32>, place: Vector<f64>, steps: [Vector<f64>; 2]) -> Option<f64> {
    /// Where brightness is taken, in steps.
    const PARTS: [f64; 3] = [0.2, 0.3, 0.4];
    let last = [picture.width(), picture.height()].map(|side| side as f64 - 1.0);
    bilinear(picture, place.coordinates())?;
    let quadrant = |signs: [f64; 2]| -> Option<f64> {
        let mut sum = 0.0;
        for x in PARTS {
            for y in PARTS {
                let at = place + steps[0] * (signs[0] * x) + steps[1] * (signs[1] * y);
                let [u, v] = at.coordinates();
                // A square that the picture cuts goes on to its border.
                sum += bilinear(picture, [u.clamp(0.0, last[0]), v.clamp(0.0, last[1])])?;
            }
        }
        Some(sum / (PARTS.len() * PARTS.len()) as f64)
    };
    let diagonal = [quadrant([1.0, 1.0])?, quadrant([-1.0, -1.0])?];
    let others = [quadrant([1.0, -1.0])?, quadrant([-1.0, 1.0])?];
    let difference = |bright: [f64; 2], dark: [f64; 2]| {
        let difference = bright[0].min(bright[1]) - dark[0].max(dark[1]);
        difference.max(0.0)
    };
    Some(difference(diagonal, others) - difference(others, diagonal))
}
