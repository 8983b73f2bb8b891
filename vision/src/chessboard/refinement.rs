//! The corners of a chessboard to a small part of a pixel.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::{Plane, PlaneError};
use ga_runtime::vga2::Vector;

use super::BoardSize;

/// The standard deviation in pixels of the blur before gradients are taken.
const SIGMA: f64 = 0.8;
/// The extent of the window around a corner to either side: this part of the distance to the next
/// corner…
const WINDOW: f64 = 0.5;
/// …but no more than this, in pixels: the edges of a board are straight in the picture only over
/// short distances.
const GREATEST_WINDOW: f64 = 20.0;
/// A corner has settled when it moves by no more than this, in pixels.
const SETTLED: f64 = 1e-5;
const STEPS: usize = 60;

/// The gradient of a picture, from which corners are refined.
pub(crate) struct Gradient(Plane<[f32; 2]>);

impl Gradient {
    pub(crate) fn new(picture: &Plane<f32>) -> Result<Self, PlaneError> {
        let smooth = Gaussian::new(SIGMA)?.blur(picture, Border::Mirror);
        let [right, bottom] = [smooth.width(), smooth.height()].map(|k| k.saturating_sub(1));
        Ok(Self(Plane::from_fn(
            smooth.width(),
            smooth.height(),
            |column, row| {
                let (above, here, below) = (
                    smooth.row(row.saturating_sub(1)),
                    smooth.row(row),
                    smooth.row((row + 1).min(bottom)),
                );
                let along = here[(column + 1).min(right)] - here[column.saturating_sub(1)];
                [along, below[column] - above[column]]
            },
        )))
    }

    /// The corners of a board, given row by row, moved to where the edges meet. `None` where one of
    /// them does not settle near its place.
    pub(super) fn refine(
        &self,
        corners: &[Vector<f64>],
        size: BoardSize,
    ) -> Option<Vec<Vector<f64>>> {
        let (columns, rows) = (size.columns(), size.rows());
        // Half the way from the neighbour before to the one after; at the ends there is one only.
        let step = |index: usize, place: usize, count: usize, stride: usize| {
            let before = if place == 0 { index } else { index - stride };
            let after = if place + 1 == count {
                index
            } else {
                index + stride
            };
            let intervals = ((after - before) / stride) as f64;
            (corners[after] - corners[before]) * (1.0 / intervals)
        };
        (0..corners.len())
            .map(|index| {
                let along = step(index, index % columns, columns, 1);
                let down = step(index, index / columns, rows, columns);
                self.corner(corners[index], [along, down].map(half_window))
            })
            .collect()
    }

    /// The place to which the gradients in a window point at right angles: with weights w,
    /// gradients g and places p, the q at which `Σ w (g·(p − q))²` is least (W. Förstner and E.
    /// Gülch, "A fast operator for detection and precise location of distinct points, corners and
    /// centres of circular features", 1987). The window is a parallelogram along the board, and
    /// moves with q.
    pub(crate) fn corner(
        &self,
        start: Vector<f64>,
        sides: [Vector<f64>; 2],
    ) -> Option<Vector<f64>> {
        let area = (sides[0] ^ sides[1]).e12;
        let extent = |k: usize| {
            sides
                .map(|side| side.coordinates()[k].abs())
                .iter()
                .sum::<f64>()
        };
        let extent = [extent(0), extent(1)];
        let mut place = start;
        for _ in 0..STEPS {
            let range = |k: usize, count: usize| {
                let [low, high] = [-1.0, 1.0].map(|sign| place.coordinates()[k] + sign * extent[k]);
                // A conversion from a negative number gives 0.
                (low.ceil() as usize)..(high.floor() as usize + 1).min(count)
            };
            let mut products = [0.0; 3];
            let mut right = [0.0; 2];
            for row in range(1, self.0.height()) {
                for column in range(0, self.0.width()) {
                    let offset = Vector::new(column as f64, row as f64) - place;
                    let [s, t] = [
                        (offset ^ sides[1]).e12 / area,
                        (sides[0] ^ offset).e12 / area,
                    ];
                    let [s, t] = [1.0 - s * s, 1.0 - t * t];
                    if !(s > 0.0 && t > 0.0) {
                        continue;
                    }
                    let [x, y] = self.0.row(row)[column].map(f64::from);
                    let weight = (s * t).powi(2);
                    let along = weight * (x * offset.e1 + y * offset.e2);
                    products[0] += weight * x * x;
                    products[1] += weight * x * y;
                    products[2] += weight * y * y;
                    right[0] += along * x;
                    right[1] += along * y;
                }
            }
            let [xx, xy, yy] = products;
            let determinant = xx * yy - xy * xy;
            if determinant.is_nan() || determinant <= 1e-6 * (xx + yy).powi(2) {
                return None;
            }
            let step = Vector::new(
                (yy * right[0] - xy * right[1]) / determinant,
                (xx * right[1] - xy * right[0]) / determinant,
            );
            place += step;
            let moved = place - start;
            let [s, t] = [(moved ^ sides[1]).e12 / area, (sides[0] ^ moved).e12 / area];
            if !(s.abs() < 1.0 && t.abs() < 1.0) {
                return None;
            }
            if step.length() <= SETTLED {
                return Some(place);
            }
        }
        Some(place)
    }
}

/// The side of the window along a step to the next corner.
fn half_window(step: Vector<f64>) -> Vector<f64> {
    step * WINDOW.min(GREATEST_WINDOW / step.length())
}
