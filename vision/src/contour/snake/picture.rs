//! Snakes in a picture, from the picture itself.

use ga_image::plane::Plane;

use super::flow::Flow;
use super::options::SnakeOptions;
use super::potential::Potential;
use super::{Settled, SnakeStep, circle, settle};
use crate::contour::ContourError;
use crate::contour::outline::outline;
use crate::contour::polygon::resampled;

/// Where a snake begins in a picture, and what draws it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureSnake {
    /// Where it begins.
    pub start: Start,
    /// The number of its points.
    pub points: usize,
    /// The standard deviation of the blur before edges are found, in pixels.
    pub sigma: f64,
    /// Draws the snake to edges from far away, where it is given.
    pub flow: Option<Flow>,
    /// How the snake moves.
    pub options: SnakeOptions,
}

/// Where a snake begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// At a circle, in pixels.
    Circle {
        /// The centre.
        centre: [f64; 2],
        /// The radius.
        radius: f64,
    },
    /// At the border that encloses the largest area ([`outline`]).
    Outline {
        /// The least area that it may enclose, in pixels.
        least_area: f64,
    },
}

impl Default for PictureSnake {
    /// 400 points from the largest border, and edges of a blur of 2 pixels without a flow.
    fn default() -> Self {
        Self {
            start: Start::Outline { least_area: 1.0 },
            points: 400,
            sigma: 2.0,
            flow: None,
            options: SnakeOptions::default(),
        }
    }
}

impl PictureSnake {
    /// Lets the snake settle at the edges of a picture.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_vision::contour::snake::PictureSnake;
    ///
    /// let disk = Plane::from_fn(80, 80, |column, row| {
    ///     let radius = (column as f64 - 40.0).hypot(row as f64 - 40.0);
    ///     (255.0 * (20.5 - radius).clamp(0.0, 1.0)) as u8
    /// });
    /// let settled = PictureSnake::default().settle(&disk, |_| {})?;
    /// assert!(settled.has_converged);
    /// for [u, v] in settled.points {
    ///     assert!(((u - 40.0).hypot(v - 40.0) - 20.0).abs() < 0.3);
    /// }
    /// # Ok::<(), ga_vision::contour::ContourError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ContourError`] of [`outline`], of the potential and of [`settle`].
    pub fn settle(
        &self,
        picture: &Plane<u8>,
        each_step: impl FnMut(&SnakeStep<'_>),
    ) -> Result<Settled, ContourError> {
        let start = match self.start {
            Start::Circle { centre, radius } => circle(centre, radius, self.points),
            Start::Outline { least_area } => {
                resampled(&outline(picture, least_area)?.points(), self.points)
            }
        };
        let floats = picture.map(|value| f32::from(value) / 255.0);
        let potential = match &self.flow {
            Some(flow) => Potential::flow(&floats, self.sigma, flow)?,
            None => Potential::edges(&floats, self.sigma)?,
        };
        settle(&start, &potential, &self.options, each_step)
    }
}
