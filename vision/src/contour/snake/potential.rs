//! The energy that a picture gives to each place.

use super::flow::check_plane;
use ga_image::filter::{Border, Gaussian};
use ga_image::interpolation::cubic_weights;
use ga_image::plane::Plane;

use super::Flow;
use crate::contour::ContourError;

/// The potential energy of places in a picture: low where a snake should lie.
///
/// Between the centres of pixels it is interpolated by cubic splines (E. Catmull and R. Rom, 1974),
/// so that its slope is continuous. Beyond the border the outermost pixels are repeated.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::contour::snake::Potential;
///
/// // An edge between the columns 9 and 10, where the potential is lowest: about −1.
/// let edge = Plane::from_fn(20, 8, |column, _| if column < 10 { 0.0 } else { 1.0 });
/// let potential = Potential::edges(&edge, 2.0)?;
/// let (value, slope) = potential.at([9.5, 4.0]);
/// assert!((value + 1.0).abs() < 0.1 && slope[0].abs() < 1e-6);
/// let (value, slope) = potential.at([12.0, 4.0]);
/// assert!(value > -0.6 && slope[0] > 0.1);
/// # Ok::<(), ga_vision::contour::ContourError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Potential {
    values: Plane<f32>,
}

impl Potential {
    /// A potential that is given at the centres of the pixels.
    ///
    /// # Errors
    ///
    /// [`ContourError`] for fewer than 2 × 2 pixels and values that are not finite.
    pub fn new(values: Plane<f32>) -> Result<Self, ContourError> {
        check_plane(&values)?;
        Ok(Self { values })
    }

    /// The potential of edges, minus the length of the slope of the picture after a blur by a
    /// Gaussian of standard deviation `sigma` pixels, in units of the step of an edge from black
    /// (0) to white (1) that is as sharp as the blur allows.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new), for the pixels of the picture, and for a `sigma` of which there is no
    /// Gaussian.
    pub fn edges(picture: &Plane<f32>, sigma: f64) -> Result<Self, ContourError> {
        Self::new(steepness(picture, sigma)?.map(|value| -value))
    }

    /// The potential of the gradient vector flow of the edges: snakes are drawn to them from far
    /// away and into concave parts; see [`Flow`].
    ///
    /// # Errors
    ///
    /// As [`edges`](Self::edges) and [`Flow::field`].
    pub fn flow(picture: &Plane<f32>, sigma: f64, flow: &Flow) -> Result<Self, ContourError> {
        Self::new(flow.potential(&steepness(picture, sigma)?)?)
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.values.width(), self.values.height()]
    }

    /// The values at the centres of the pixels.
    #[must_use]
    pub fn values(&self) -> &Plane<f32> {
        &self.values
    }

    /// The potential and its slope at a place.
    #[must_use]
    pub fn at(&self, place: [f64; 2]) -> (f64, [f64; 2]) {
        let found = self.expansion(place);
        (found.value, found.slope)
    }

    /// The potential near a place, to the second order.
    #[inline]
    pub(super) fn expansion(&self, [u, v]: [f64; 2]) -> Expansion {
        let (columns, across) = taps(u, self.values.width());
        let (rows, down) = taps(v, self.values.height());
        let mut found = Expansion::default();
        for (k, row) in rows.into_iter().enumerate() {
            let pixels = self.values.row(row);
            let mut sums = [0.0; 3];
            for (l, column) in columns.into_iter().enumerate() {
                let pixel = f64::from(pixels[column]);
                for (sum, weights) in sums.iter_mut().zip(&across) {
                    *sum += weights[l] * pixel;
                }
            }
            found.value += down[0][k] * sums[0];
            found.slope[0] += down[0][k] * sums[1];
            found.slope[1] += down[1][k] * sums[0];
            found.curvature[0] += down[0][k] * sums[2];
            found.curvature[1] += down[1][k] * sums[1];
            found.curvature[2] += down[2][k] * sums[0];
        }
        found
    }
}

/// A potential near a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Expansion {
    pub(super) value: f64,
    pub(super) slope: [f64; 2],
    /// The second derivatives: by u twice, by u and v, by v twice.
    pub(super) curvature: [f64; 3],
}

/// The four pixels round a place along one axis, their weights, and the first and second
/// derivatives of these.
#[inline]
fn taps(place: f64, length: usize) -> ([usize; 4], [[f64; 4]; 3]) {
    let last = length as f64 - 1.0;
    let place = place.clamp(-2.0, last + 2.0);
    let floor = place.floor();
    let t = place - floor;
    let at = |offset: f64| (floor + offset).clamp(0.0, last) as usize;
    let slopes = [
        ((4.0 - 3.0 * t) * t - 1.0) / 2.0,
        (9.0 * t - 10.0) * t / 2.0,
        ((8.0 - 9.0 * t) * t + 1.0) / 2.0,
        (3.0 * t - 2.0) * t / 2.0,
    ];
    let curvatures = [2.0 - 3.0 * t, 9.0 * t - 5.0, 4.0 - 9.0 * t, 3.0 * t - 1.0];
    let pixels = [at(-1.0), at(0.0), at(1.0), at(2.0)];
    (pixels, [cubic_weights(t), slopes, curvatures])
}

/// The length of the slope of a blurred picture, by Sobel's weights, times σ √(2π): 1 at a straight
/// edge from 0 to 1 where the blur is wide.
fn steepness(picture: &Plane<f32>, sigma: f64) -> Result<Plane<f32>, ContourError> {
    let gaussian = Gaussian::new(sigma)?;
    // Before the blur, which spreads a wrong pixel over all within its reach.
    check_plane(picture)?;
    let blurred = gaussian.blur(picture, Border::Replicate);
    let (width, height) = (blurred.width(), blurred.height());
    let scale = (sigma * std::f64::consts::TAU.sqrt() / 8.0) as f32;
    let mut steepness = Plane::filled(width, height, 0.0f32);
    let [mut sums, mut differences] = [(); 2].map(|()| vec![0.0f32; width]);
    for row in 0..height {
        let [above, here, below] =
            [row.saturating_sub(1), row, (row + 1).min(height - 1)].map(|row| blurred.row(row));
        for column in 0..width {
            sums[column] = above[column] + 2.0 * here[column] + below[column];
            differences[column] = below[column] - above[column];
        }
        for (column, target) in steepness.row_mut(row).iter_mut().enumerate() {
            let (left, right) = (column.saturating_sub(1), (column + 1).min(width - 1));
            let dx = sums[right] - sums[left];
            let dy = differences[left] + 2.0 * differences[column] + differences[right];
            *target = scale * (dx * dx + dy * dy).sqrt();
        }
    }
    Ok(steepness)
}
