//! Closed curves that settle at the edges of a picture: snakes.

mod error;
mod flow;
mod potential;

pub use error::SnakeError;
pub use flow::Flow;
pub use potential::Potential;

use ga_runtime::cga2::Point;

use super::cyclic::Cyclic;
use super::polygon::resampled;

/// How a snake moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SnakeOptions {
    /// α: how strongly the curve contracts.
    pub tension: f64,
    /// β: how strongly the curve resists bending.
    pub rigidity: f64,
    /// The snake has settled when no point moves farther than this in a step, in pixels.
    pub tolerance: f64,
    /// The greatest distance that a point moves in a step, in pixels.
    pub greatest_move: f64,
    /// The greatest number of steps.
    pub steps: usize,
    /// After so many steps each, the points are placed at equal distances along the curve, if the
    /// energy does not rise by that.
    pub resampled_every: Option<usize>,
}

impl Default for SnakeOptions {
    /// α = 0.01, β = 0.01, at most 2500 steps of at most 1 pixel until none is above 0.01 pixels,
    /// without resampling.
    fn default() -> Self {
        Self {
            tension: 0.01,
            rigidity: 0.01,
            tolerance: 0.01,
            greatest_move: 1.0,
            steps: 2500,
            resampled_every: None,
        }
    }
}

/// A snake after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SnakeStep<'a> {
    /// The number of the step, from 1 on; 0 for the curve at the beginning.
    pub number: usize,
    /// The energy.
    pub energy: f64,
    /// The greatest distance that a point moved in this step, in pixels.
    pub greatest_move: f64,
    /// The points.
    pub points: &'a [[f64; 2]],
}

/// What has become of a snake.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// The energy.
    pub energy: f64,
    /// The number of steps.
    pub steps: usize,
    /// Whether no point moved farther than the tolerance in the last step.
    pub has_converged: bool,
}

/// A closed curve of points that minimises
///
/// ```text
/// E = Σ ½ α |xᵢ₊₁ − xᵢ|² + ½ β |xᵢ₊₁ − 2 xᵢ + xᵢ₋₁|² + P(xᵢ)
/// ```
///
/// where P is the potential of the picture (M. Kass, A. Witkin and D. Terzopoulos, "Snakes: active
/// contour models", 1988). Each step is implicit in the shape and explicit in the potential,
/// `(A + γ) x′ = γ x − ∇P(x)`. γ is chosen in each step so that the energy falls by at
/// least ¼ γ Σ |x′ − x|²: it is doubled until that is so, and lowered again afterwards.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::contour::snake::{self, Potential, SnakeOptions};
///
/// let disk = Plane::from_fn(80, 80, |column, row| {
///     let radius = (column as f32 - 40.0).hypot(row as f32 - 40.0);
///     (20.5 - radius).clamp(0.0, 1.0)
/// });
/// let potential = Potential::edges(&disk, 2.0)?;
/// let start = snake::circle([40.0, 40.0], 30.0, 100);
/// let mut energies = Vec::new();
/// let settled = snake::settle(&start, &potential, &SnakeOptions::default(), |step| {
///     energies.push(step.energy);
/// })?;
/// assert!(settled.has_converged && energies.is_sorted_by(|a, b| a >= b));
/// for [u, v] in settled.points {
///     assert!(((u - 40.0).hypot(v - 40.0) - 20.0).abs() < 0.3);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`SnakeError`] for fewer than six points, settings that are not positive and finite, and a point
/// outside the picture, at the beginning or after a step.
pub fn settle(
    start: &[[f64; 2]],
    potential: &Potential,
    options: &SnakeOptions,
    mut each_step: impl FnMut(&SnakeStep<'_>),
) -> Result<Settled, SnakeError> {
    error::check(start, potential, options)?;
    let mut motion = Motion::new(start, potential, options);
    let mut has_converged = false;
    let mut number = 0;
    each_step(&motion.state(0, 0.0));
    while number < options.steps && !has_converged {
        number += 1;
        let greatest_move = motion.step()?;
        if options
            .resampled_every
            .is_some_and(|every| number % every == 0)
        {
            motion.resample();
        }
        has_converged = greatest_move <= options.tolerance;
        each_step(&motion.state(number, greatest_move));
    }
    Ok(Settled {
        points: motion.points,
        energy: motion.energy,
        steps: number,
        has_converged,
    })
}

/// `count` points on a circle, from the rightmost one on, clockwise as seen in the picture.
#[must_use]
pub fn circle(centre: [f64; 2], radius: f64, count: usize) -> Vec<[f64; 2]> {
    let points = (0..count).map(|index| {
        let angle = std::f64::consts::TAU * index as f64 / count as f64;
        [
            centre[0] + radius * angle.cos(),
            centre[1] + radius * angle.sin(),
        ]
    });
    points.collect()
}

/// A snake on its way.
struct Motion<'a> {
    potential: &'a Potential,
    options: &'a SnakeOptions,
    points: Vec<[f64; 2]>,
    /// The slope of the potential at the points.
    slopes: Vec<[f64; 2]>,
    energy: f64,
    /// γ.
    damping: f64,
    next: Vec<[f64; 2]>,
    next_slopes: Vec<[f64; 2]>,
    matrix: Cyclic,
}

impl<'a> Motion<'a> {
    fn new(start: &[[f64; 2]], potential: &'a Potential, options: &'a SnakeOptions) -> Self {
        let mut motion = Self {
            potential,
            options,
            points: start.to_vec(),
            slopes: vec![[0.0; 2]; start.len()],
            energy: 0.0,
            damping: options.tension + options.rigidity + f64::EPSILON,
            next: start.to_vec(),
            next_slopes: vec![[0.0; 2]; start.len()],
            matrix: Cyclic::default(),
        };
        motion.energy = motion.evaluate();
        std::mem::swap(&mut motion.slopes, &mut motion.next_slopes);
        motion
    }

    fn state(&self, number: usize, greatest_move: f64) -> SnakeStep<'_> {
        SnakeStep {
            number,
            energy: self.energy,
            greatest_move,
            points: &self.points,
        }
    }

    /// Moves the points, and gives the greatest distance. It is 0 where the energy cannot fall.
    fn step(&mut self) -> Result<f64, SnakeError> {
        /// Beyond this damping, a step is below the accuracy of the numbers.
        const GREATEST: f64 = 1e12;
        let SnakeOptions {
            tension, rigidity, ..
        } = *self.options;
        while self.damping < GREATEST {
            let numbers = [
                self.damping + 2.0 * tension + 6.0 * rigidity,
                -tension - 4.0 * rigidity,
                rigidity,
            ];
            self.matrix.factorise(self.points.len(), numbers);
            let old = self.points.iter().zip(&self.slopes);
            for (next, (point, slope)) in self.next.iter_mut().zip(old) {
                *next = [0, 1].map(|axis| self.damping * point[axis] - slope[axis]);
            }
            self.matrix.solve(&mut self.next);
            let moves = self.points.iter().zip(&self.next);
            let squares = moves.map(|(a, b)| Point::from(*a).distance_squared(Point::from(*b)));
            let (sum, greatest) = squares.fold((0.0, 0.0f64), |(sum, greatest), square| {
                (sum + square, greatest.max(square))
            });
            let greatest = greatest.sqrt();
            if greatest <= self.options.greatest_move {
                let energy = self.evaluate();
                // Steps across a valley to the same height are not steps towards its bottom.
                if energy <= self.energy - self.damping * sum / 4.0 {
                    let size = self.potential.size();
                    error::check_inside(&self.next, size)?;
                    self.accept(energy);
                    self.damping *= 0.7;
                    return Ok(greatest);
                }
            }
            self.damping *= 2.0;
        }
        Ok(0.0)
    }

    /// Places the points at equal distances, if the energy does not rise.
    fn resample(&mut self) {
        let points = resampled(&self.points, self.points.len());
        if points.len() == self.points.len() {
            self.next.copy_from_slice(&points);
            let energy = self.evaluate();
            if energy <= self.energy {
                self.accept(energy);
            }
        }
    }

    fn accept(&mut self, energy: f64) {
        self.energy = energy;
        std::mem::swap(&mut self.points, &mut self.next);
        std::mem::swap(&mut self.slopes, &mut self.next_slopes);
    }

    /// The energy of the next points. Notes the slopes of the potential there.
    fn evaluate(&mut self) -> f64 {
        let points = &self.next;
        let count = points.len();
        let [mut stretching, mut bending, mut outer] = [0.0; 3];
        let [mut before, mut at] = [points[count - 2], points[count - 1]];
        for (point, slope) in points.iter().zip(&mut self.next_slopes) {
            let forward = [point[0] - at[0], point[1] - at[1]];
            let backward = [at[0] - before[0], at[1] - before[1]];
            for axis in 0..2 {
                stretching += forward[axis] * forward[axis];
                bending += (forward[axis] - backward[axis]).powi(2);
            }
            let (value, gradient) = self.potential.at(*point);
            outer += value;
            *slope = gradient;
            (before, at) = (at, *point);
        }
        (self.options.tension * stretching + self.options.rigidity * bending) / 2.0 + outer
    }
}
