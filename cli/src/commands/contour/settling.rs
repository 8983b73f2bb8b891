//! Snakes from the arguments of the command.

use std::path::Path;
use std::time::Instant;

use anyhow::{Result, bail};
use ga_image::plane::Plane;
use ga_vision::contour::snake::{self, Flow, Potential, SnakeOptions};
use ga_vision::contour::{ContourError, outline, resampled};
use serde::Serialize;

use crate::frame::{Progress, Warning};

/// How a snake settles.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Settings {
    /// The circle at which the snake begins, its centre and radius in pixels, instead of the
    /// largest border.
    #[arg(long, value_name = "U,V,RADIUS", value_delimiter = ',')]
    circle: Option<Vec<f64>>,
    /// The same in the right view.
    #[arg(
        long,
        value_name = "U,V,RADIUS",
        value_delimiter = ',',
        requires = "rig"
    )]
    right_circle: Option<Vec<f64>>,
    /// The number of points of the snake.
    #[arg(long, value_name = "COUNT", default_value_t = 400)]
    points: u16,
    /// The standard deviation of the blur before edges are found, in pixels.
    #[arg(long, value_name = "PIXELS", default_value_t = 2.0)]
    sigma: f64,
    /// How strongly the snake contracts (α, in square pixels), whatever the number of points.
    #[arg(long, value_name = "NUMBER", default_value_t = SnakeOptions::default().tension)]
    tension: f64,
    /// How strongly the snake resists bending (β, in fourth powers of a pixel), whatever the number
    /// of points.
    #[arg(long, value_name = "NUMBER", default_value_t = SnakeOptions::default().rigidity)]
    rigidity: f64,
    /// The snake has settled when no point moves farther than this in a step.
    #[arg(long, value_name = "PIXELS", default_value_t = SnakeOptions::default().tolerance)]
    tolerance: f64,
    /// The greatest number of steps of the snake.
    #[arg(long, value_name = "COUNT", default_value_t = SnakeOptions::default().steps)]
    steps: usize,
    /// Draw the snake to edges from far away, by gradient vector flow.
    #[arg(long)]
    flow: bool,
    /// How smooth the flow is (μ).
    #[arg(
        long,
        value_name = "NUMBER",
        default_value_t = Flow::default().smoothness,
        requires = "flow"
    )]
    smoothness: f64,
}

/// What became of a snake.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Settled {
    #[serde(skip)]
    pub(super) points: Vec<[f64; 2]>,
    steps: usize,
    converged: bool,
    /// The time of the steps.
    seconds: f64,
    /// Before the first step and after each one.
    energies: Vec<f64>,
}

impl Settings {
    /// The circle at which the snake of the left or only view begins, or that of the right one.
    pub(super) fn circle(&self, is_right: bool) -> Result<Option<[f64; 3]>> {
        let (name, given) = if is_right {
            ("--right-circle", &self.right_circle)
        } else {
            ("--circle", &self.circle)
        };
        match given.as_deref() {
            None => Ok(None),
            Some([u, v, radius]) => Ok(Some([*u, *v, *radius])),
            Some(numbers) => bail!("{name} has {} numbers instead of U,V,RADIUS", numbers.len()),
        }
    }

    /// A snake that settles at edges of a picture.
    pub(super) fn settle(
        &self,
        picture: &Plane<u8>,
        circle: Option<[f64; 3]>,
        least_area: f64,
        progress: &Progress,
    ) -> Result<Settled> {
        let count = usize::from(self.points);
        let start = match circle {
            Some([u, v, radius]) => snake::circle([u, v], radius, count),
            None => match outline(picture, least_area.max(1.0)) {
                Ok(border) => resampled(&border.points(), count),
                Err(error @ ContourError::LeavesPicture { .. }) => bail!(
                    "{error}; --circle, or --right-circle for the right view, gives the circle at \
                     which the snake begins"
                ),
                Err(error) => return Err(error.into()),
            },
        };
        let floats = picture.map(|value| f32::from(value) / 255.0);
        let potential = if self.flow {
            let flow = Flow {
                smoothness: self.smoothness,
            };
            Potential::flow(&floats, self.sigma, &flow)?
        } else {
            Potential::edges(&floats, self.sigma)?
        };
        let options = SnakeOptions {
            tension: self.tension,
            rigidity: self.rigidity,
            tolerance: self.tolerance,
            steps: self.steps,
            ..SnakeOptions::default()
        };
        let mut energies = Vec::new();
        let begin = Instant::now();
        let settled = snake::settle(&start, &potential, &options, |step| {
            energies.push(step.energy);
            progress.at(step.number as u64, self.steps as u64);
        })?;
        Ok(Settled {
            points: settled.points,
            steps: settled.steps,
            converged: settled.has_converged,
            seconds: begin.elapsed().as_secs_f64(),
            energies,
        })
    }
}

impl Settled {
    /// A warning where the snake of a view has not settled.
    pub(super) fn warning(&self, view: &Path) -> Option<Warning> {
        let text = format!("the snake still moves after {} steps", self.steps);
        (!self.converged).then(|| Warning::new("not_settled", text).in_file(view))
    }

    pub(super) fn text(&self) -> String {
        let end = if self.converged {
            "settled"
        } else {
            "still moving"
        };
        format!(
            "{end} after {} steps in {:.1} ms",
            self.steps,
            1e3 * self.seconds
        )
    }
}
