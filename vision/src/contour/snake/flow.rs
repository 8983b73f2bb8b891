//! Gradient vector flow: the slopes of edges, spread over the picture.

use ga_image::plane::Plane;
use ga_image::pyramid::halved;

/// How far the forces of edges reach.
///
/// The field of forces w minimises `∫ μ |∇w|² + |∇f|² |w − ∇f|²` for the strength f of edges (C. Xu
/// and J. Prince, "Gradient vector flow: a new external force for snakes", 1997): near edges it is
/// their slope, and where the picture is level it continues smoothly. The potential P is that whose
/// forces −∇P are nearest to w, so that a snake has an energy. Both equations are relaxed from a
/// small picture up to the whole one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow {
    /// μ: how much smoothness counts against nearness to the slope of edges.
    pub smoothness: f64,
    /// The number of passes over the pictures of each size.
    pub passes: usize,
}

impl Default for Flow {
    /// μ = 0.02, 20 passes.
    fn default() -> Self {
        Self {
            smoothness: 0.02,
            passes: 20,
        }
    }
}

impl Flow {
    /// The potential of the flow of edges whose strength is given.
    pub(super) fn potential(&self, strength: &Plane<f32>) -> Plane<f32> {
        /// The smallest picture has at least so many pixels in a row and a column.
        const LEAST: usize = 8;
        let mut levels = vec![strength.clone()];
        while let Some(last) = levels.last() {
            if last.width().min(last.height()) < 2 * LEAST {
                break;
            }
            levels.push(halved(last));
        }
        let mut field: [Plane<f32>; 2] = Default::default();
        let mut potential: Plane<f32> = Plane::default();
        while let Some(level) = levels.pop() {
            let size = [level.width(), level.height()];
            let slopes = central(&level);
            // A slope is a difference of neighbours, whose distance halves; a potential is not.
            field = if field[0].is_empty() {
                slopes.clone()
            } else {
                field.map(|plane| enlarged(&plane, size, 0.5))
            };
            potential = if potential.is_empty() {
                Plane::filled(size[0], size[1], 0.0)
            } else {
                enlarged(&potential, size, 1.0)
            };
            self.spread(&mut field, &slopes);
            self.integrate(&mut potential, &field);
        }
        potential
    }

    /// Relaxes `μ Δw = |∇f|² (w − ∇f)`.
    fn spread(&self, field: &mut [Plane<f32>; 2], slopes: &[Plane<f32>; 2]) {
        let mu = self.smoothness as f32;
        let squares: Vec<f32> = slopes[0]
            .values()
            .iter()
            .zip(slopes[1].values())
            .map(|(x, y)| x * x + y * y)
            .collect();
        for (component, slope) in field.iter_mut().zip(slopes) {
            let slope = slope.values();
            relax(component, self.passes, |index, sum, count| {
                let weight = squares[index];
                (mu * sum + weight * slope[index]) / (mu * count + weight)
            });
        }
    }

    /// Relaxes `Δ(−P) = ∇·w`: the differences of neighbours are to be the mean forces between them.
    fn integrate(&self, potential: &mut Plane<f32>, [x, y]: &[Plane<f32>; 2]) {
        let (width, height) = (x.width(), x.height());
        let divergence = Plane::from_fn(width, height, |column, row| {
            let between = |plane: &Plane<f32>, a: [usize; 2], b: [usize; 2]| {
                let [a, b] = [a, b].map(|[column, row]| plane.row(row)[column]);
                (a + b) / 2.0
            };
            let mut sum = 0.0;
            if column + 1 < width {
                sum += between(x, [column, row], [column + 1, row]);
            }
            if column > 0 {
                sum -= between(x, [column - 1, row], [column, row]);
            }
            if row + 1 < height {
                sum += between(y, [column, row], [column, row + 1]);
            }
            if row > 0 {
                sum -= between(y, [column, row - 1], [column, row]);
            }
            sum
        });
        let divergence = divergence.values();
        relax(potential, self.passes, |index, sum, count| {
            (sum + divergence[index]) / count
        });
    }
}

/// Passes of successive over-relaxation. `value` gives the value of the pixel at an index from the
/// sum of its neighbours and their number.
fn relax(plane: &mut Plane<f32>, passes: usize, value: impl Fn(usize, f32, f32) -> f32) {
    const OVER: f32 = 1.7;
    let (width, height) = (plane.width(), plane.height());
    let values = plane.values_mut();
    for _ in 0..passes {
        for row in 0..height {
            for column in 0..width {
                let index = row * width + column;
                let (mut sum, mut count) = (0.0, 0.0);
                for (exists, neighbour) in [
                    (column > 0, index.wrapping_sub(1)),
                    (column + 1 < width, index + 1),
                    (row > 0, index.wrapping_sub(width)),
                    (row + 1 < height, index + width),
                ] {
                    if exists {
                        sum += values[neighbour];
                        count += 1.0;
                    }
                }
                values[index] += OVER * (value(index, sum, count) - values[index]);
            }
        }
    }
}

/// Half the differences of the two neighbours, along columns and rows.
fn central(plane: &Plane<f32>) -> [Plane<f32>; 2] {
    let (width, height) = (plane.width(), plane.height());
    let across = Plane::from_fn(width, height, |column, row| {
        let pixels = plane.row(row);
        (pixels[(column + 1).min(width - 1)] - pixels[column.saturating_sub(1)]) / 2.0
    });
    let down = Plane::from_fn(width, height, |column, row| {
        let (above, below) = (row.saturating_sub(1), (row + 1).min(height - 1));
        (plane.row(below)[column] - plane.row(above)[column]) / 2.0
    });
    [across, down]
}

/// A plane of twice the size, bilinear, times a factor.
fn enlarged(plane: &Plane<f32>, [width, height]: [usize; 2], factor: f32) -> Plane<f32> {
    let around = |place: usize, length: usize| {
        let place = (place as f32 - 0.5) / 2.0;
        let place = place.clamp(0.0, length as f32 - 1.0);
        let first = place.floor();
        let index = first as usize;
        (index, (index + 1).min(length - 1), place - first)
    };
    let columns: Vec<_> = (0..width)
        .map(|column| around(column, plane.width()))
        .collect();
    Plane::from_fn(width, height, |column, row| {
        let (top, bottom, down) = around(row, plane.height());
        let (left, right, across) = columns[column];
        let [above, below] = [top, bottom].map(|row| {
            let pixels = plane.row(row);
            pixels[left] + across * (pixels[right] - pixels[left])
        });
        factor * (above + down * (below - above))
    })
}
