//! Snakes from the arguments of the command.

use std::path::Path;
use std::time::Instant;

use anyhow::{Result, bail};
use ga_image::plane::Plane;
use ga_vision::contour::ContourError;
use ga_vision::contour::snake::{Flow, PictureSnake, SnakeFault, SnakeOptions, Start};
use serde::Serialize;

use crate::frame::{Progress, Warning};

/// How a snake settles.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct SnakeArguments {
    /// The circle at which the snake begins, its centre and radius in pixels, instead of the
    /// largest border.
    #[arg(
        long,
        value_name = "U,V,RADIUS",
        value_delimiter = ',',
        requires = "a snake"
    )]
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
    #[arg(
        long,
        value_name = "COUNT",
        default_value_t = 400,
        requires = "a snake"
    )]
    points: u16,
    /// The standard deviation of the blur before edges are found, in pixels.
    #[arg(
        long,
        value_name = "PIXELS",
        default_value_t = 2.0,
        requires = "a snake"
    )]
    sigma: f64,
    /// How strongly the snake contracts (α, in square pixels), whatever the number of points.
    #[arg(long, value_name = "NUMBER", default_value_t = SnakeOptions::default().tension, requires = "a snake")]
    tension: f64,
    /// How strongly the snake resists bending (β, in fourth powers of a pixel), whatever the number
    /// of points.
    #[arg(long, value_name = "NUMBER", default_value_t = SnakeOptions::default().rigidity, requires = "a snake")]
    rigidity: f64,
    /// The snake has settled when no point moves farther than this in a step.
    #[arg(long, value_name = "PIXELS", default_value_t = SnakeOptions::default().tolerance, requires = "a snake")]
    tolerance: f64,
    /// The greatest number of steps of the snake.
    #[arg(long, value_name = "COUNT", default_value_t = SnakeOptions::default().steps, requires = "a snake")]
    steps: usize,
    /// Draw the snake to edges from far away, by gradient vector flow.
    #[arg(long, requires = "a snake")]
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
    #[serde(skip)]
    faults: Vec<SnakeFault>,
}

impl SnakeArguments {
    /// A snake that settles at edges of the left or only view, or of the right one.
    pub(super) fn settle(
        &self,
        picture: &Plane<u8>,
        is_right: bool,
        least_area: f64,
        progress: &Progress,
    ) -> Result<Settled> {
        let (name, circle) = match is_right {
            true => ("--right-circle", &self.right_circle),
            false => ("--circle", &self.circle),
        };
        let start = match circle.as_deref() {
            None => Start::Outline {
                least_area: least_area.max(1.0),
            },
            Some(&[_, _, radius]) if radius <= 0.0 => {
                bail!("{name}: a radius of {radius} pixels is not above 0")
            }
            Some(&[u, v, radius]) => Start::Circle {
                centre: [u, v],
                radius,
            },
            Some(numbers) => bail!("{name} has {} numbers instead of U,V,RADIUS", numbers.len()),
        };
        let snake = PictureSnake {
            start,
            points: usize::from(self.points),
            sigma: self.sigma,
            flow: self.flow.then_some(Flow {
                smoothness: self.smoothness,
            }),
            options: SnakeOptions {
                tension: self.tension,
                rigidity: self.rigidity,
                tolerance: self.tolerance,
                steps: self.steps,
                ..SnakeOptions::default()
            },
        };
        let (mut energies, mut begin) = (Vec::new(), None);
        let settled = snake.settle(picture, |step| {
            begin.get_or_insert_with(Instant::now);
            energies.push(step.energy);
            progress.at(step.number as u64, self.steps as u64);
        });
        let seconds = begin.map_or(0.0, |begin| begin.elapsed().as_secs_f64());
        let settled = match settled {
            Err(error @ ContourError::LeavesPicture { .. }) => bail!(
                "{error}; --circle, or --right-circle for the right view, gives the circle at \
                 which the snake begins"
            ),
            settled => settled?,
        };
        Ok(Settled {
            faults: settled.faults([picture.width(), picture.height()]),
            points: settled.points,
            steps: settled.steps,
            converged: settled.has_converged,
            seconds,
            energies,
        })
    }
}

impl Settled {
    /// Warnings where the snake of a view has not settled, or is not the outline of a thing.
    pub(super) fn warnings(&self, view: &Path) -> Vec<Warning> {
        let text = format!("the snake still moves after {} steps", self.steps);
        let moving = (!self.converged).then(|| Warning::new("not_settled", text));
        let faults = self.faults.iter();
        let faults = faults.map(|fault| Warning::new(fault.kind(), fault));
        let all = moving.into_iter().chain(faults);
        all.map(|warning| warning.in_file(view)).collect()
    }

    pub(super) fn text(&self) -> String {
        let end = match self.converged {
            true => "settled",
            false => "still moving",
        };
        let (steps, milliseconds) = (self.steps, 1e3 * self.seconds);
        format!("{end} after {steps} steps in {milliseconds:.1} ms")
    }
}
