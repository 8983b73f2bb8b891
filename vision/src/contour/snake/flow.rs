//! Gradient vector flow: the slopes of edges, spread over the picture.

use ga_image::plane::Plane;

use super::diffusion::Diffusion;
use crate::contour::ContourError;

/// How far the forces of edges reach.
///
/// For the strength f of edges, scaled so that its greatest value is 1, the field of forces w
/// minimises
///
/// ```text
/// ∫ μ |∇w|² + |∇f|² |w − ∇f|²
/// ```
///
/// (C. Xu and J. Prince, "Snakes, shapes, and gradient vector flow", 1998, eq. 10): near edges it
/// is their slope, and where the picture is level it continues smoothly. Xu and Prince follow the
/// diffusion `∂w/∂t = μ Δw − |∇f|² (w − ∇f)` in small steps; here its end, the solution of
/// `μ Δw = |∇f|² (w − ∇f)` with `∂w/∂n = 0` at the border of the picture, is found directly, by
/// conjugate gradients with multigrid cycles.
///
/// A flow is not the slope of anything, so that a snake in it would have no energy. The potential P
/// is that whose forces −∇P are nearest to w in the mean square: `−ΔP = ∇·w`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow {
    /// μ, in squared pixels times the squared slope of f: how much smoothness counts against
    /// nearness to the slope of edges.
    pub smoothness: f64,
}

impl Default for Flow {
    /// μ = 0.02.
    fn default() -> Self {
        Self { smoothness: 0.02 }
    }
}

impl Flow {
    /// The field of forces `[w_u, w_v]` of edges whose strength is given at the pixels, with
    /// differences of neighbouring pixels for derivatives.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_vision::contour::snake::Flow;
    ///
    /// // An edge in column 10: the forces far away from it point to it.
    /// let edge = Plane::from_fn(40, 9, |column, _| {
    ///     (-0.5 * (column as f32 - 10.0).powi(2)).exp()
    /// });
    /// let [across, down] = Flow::default().field(&edge)?;
    /// assert!(across.row(4)[2] > 0.1 && across.row(4)[35] < -0.1);
    /// assert!(down.values().iter().all(|force| force.abs() < 1e-6));
    /// # Ok::<(), ga_vision::contour::ContourError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ContourError`] for a μ that is not positive and finite, fewer than 2 × 2 pixels, values
    /// that are not finite, and equations whose solution is beyond the accuracy of the numbers.
    pub fn field(&self, strength: &Plane<f32>) -> Result<[Plane<f64>; 2], ContourError> {
        let mu = self.smoothness;
        if !(mu > 0.0 && mu.is_finite()) {
            return Err(ContourError::Setting {
                setting: "smoothness of the flow",
                value: mu,
            });
        }
        let size = check_plane(strength)?;
        let greatest = strength.values().iter().fold(0.0f32, |a, b| a.max(b.abs()));
        if greatest == 0.0 {
            return Ok([(); 2].map(|()| Plane::filled(size[0], size[1], 0.0)));
        }
        let scaled = strength.map(|value| f64::from(value) / f64::from(greatest));
        let slopes = central(&scaled);
        let squares: Vec<f64> = slopes[0]
            .values()
            .iter()
            .zip(slopes[1].values())
            .map(|(x, y)| x * x + y * y)
            .collect();
        let diffusion = Diffusion::new(size, mu, squares);
        let [across, down] = slopes.map(|slope| {
            let weights = diffusion.weights().iter();
            let right: Vec<f64> = weights
                .zip(slope.values())
                .map(|(weight, slope)| weight * slope)
                .collect();
            diffusion.solve(&right)
        });
        let plane =
            |values: Vec<f64>| Plane::from_fn(size[0], size[1], |u, v| values[v * size[0] + u]);
        Ok([plane(across?), plane(down?)])
    }

    /// The potential of the flow of edges whose strength is given.
    pub(super) fn potential(&self, strength: &Plane<f32>) -> Result<Plane<f32>, ContourError> {
        let [across, down] = self.field(strength)?;
        let (width, height) = (across.width(), across.height());
        let poisson = Diffusion::new([width, height], 1.0, vec![0.0; width * height]);
        let values = poisson.solve(&divergence(&across, &down))?;
        Ok(Plane::from_fn(width, height, |u, v| {
            values[v * width + u] as f32
        }))
    }
}

/// The sums of what flows out of each pixel to its neighbours, with the mean force of both.
/// Nothing flows across the border of the picture.
fn divergence(across: &Plane<f64>, down: &Plane<f64>) -> Vec<f64> {
    let (width, height) = (across.width(), across.height());
    let mut sums = vec![0.0; width * height];
    for row in 0..height {
        for column in 0..width {
            let index = row * width + column;
            let mut flow = |other: usize, force: f64| {
                sums[index] += force / 2.0;
                sums[other] -= force / 2.0;
            };
            if column + 1 < width {
                let pixels = across.row(row);
                flow(index + 1, pixels[column] + pixels[column + 1]);
            }
            if row + 1 < height {
                let below = down.row(row + 1);
                flow(index + width, down.row(row)[column] + below[column]);
            }
        }
    }
    sums
}

/// Half the differences of the two neighbours, along columns and rows. Beyond the border the
/// outermost pixels are repeated.
fn central(plane: &Plane<f64>) -> [Plane<f64>; 2] {
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

/// Columns and rows of a plane that has slopes, all of whose values are finite.
pub(super) fn check_plane(plane: &Plane<f32>) -> Result<[usize; 2], ContourError> {
    let (width, height) = (plane.width(), plane.height());
    if width.min(height) < 2 {
        return Err(ContourError::TooSmall { width, height });
    }
    let wrong = plane.values().iter().position(|value| !value.is_finite());
    match wrong {
        None => Ok([width, height]),
        Some(index) => Err(ContourError::PixelNotFinite {
            column: index % width,
            row: index / width,
        }),
    }
}
