//! Closed curves that settle at the edges of a picture: snakes.

mod check;
mod diffusion;
mod fault;
mod flow;
mod options;
mod picture;
mod potential;

pub use fault::SnakeFault;
pub use flow::Flow;
pub use options::SnakeOptions;
pub use picture::{PictureSnake, Start};
pub use potential::Potential;

use super::polygon::{perimeter, resampled};
use crate::contour::ContourError;
use ga_numerics::banded::ring::Ring;
use ga_numerics::least_squares::{Attempt, Damping, Descent, Search};

/// A snake after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SnakeStep<'a> {
    /// The number of the step, from 1 on; 0 for the curve at the beginning.
    pub number: usize,
    /// The energy.
    pub energy: f64,
    /// The greatest distance that a point moved in this step, or by the resampling after it, in
    /// pixels.
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
    /// Whether no point moved farther than the tolerance in the last two steps, or the energy could
    /// not fall any further in the accuracy of the numbers.
    pub has_converged: bool,
}

/// A closed curve x(s) that minimises
///
/// ```text
/// E = ∫ ½ α |x′(s)|² + ½ β |x″(s)|² + P(x(s)) ds
/// ```
///
/// where P is the potential of the picture, and s the arc length of the curve at the beginning (M.
/// Kass, A. Witkin and D. Terzopoulos, "Snakes: active contour models", 1988). With the points xᵢ,
/// whose mean distance at the beginning is h, this is
///
/// ```text
/// E = h Σ ½ α |xᵢ₊₁ − xᵢ|²/h² + ½ β |xᵢ₊₁ − 2 xᵢ + xᵢ₋₁|²/h⁴ + P(xᵢ)
/// ```
///
/// so that the number of points changes the curve only by the error of the sum, and the same α and
/// β suit any h below the size of what the curve should follow. An energy that is summed over
/// points, without h, has the tension α/h² and the rigidity β/h⁴.
///
/// h is that of the beginning however long the curve becomes. To continue with the same energy from
/// a curve that has settled and whose points are h′ apart, scale α by (h′/h)² and β by (h′/h)⁴.
///
/// Each step solves
///
/// ```text
/// (A + H(x) + γ) (x̂ − x) = −A x − ∇P(x)
/// ```
///
/// for the next points x̂, with the matrix A of the first two terms of E/h, which joins each point
/// to two neighbours on either side, and the second derivatives H of P at the points. Without H it
/// is the semi-implicit step of Kass, Witkin and Terzopoulos, which crawls along edges; with it,
/// the last steps are those of Newton's method. γ is chosen so that the matrix is positive
/// definite, that no point moves farther than it may, and that the energy falls by at least a tenth
/// of what the step predicts ([`ga_numerics::least_squares::Search`]).
///
/// The snake has settled when no point moves farther than the tolerance in two steps: one short
/// step may be that of a large γ.
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
/// [`ContourError`] for fewer than six points, points that are all at one place, settings that are
/// not positive and finite, an energy beyond the range of numbers, and a point outside the picture,
/// at the beginning or after a step.
pub fn settle(
    start: &[[f64; 2]],
    potential: &Potential,
    options: &SnakeOptions,
    mut each_step: impl FnMut(&SnakeStep<'_>),
) -> Result<Settled, ContourError> {
    check::check(start, potential, options)?;
    let mut motion = Motion::new(start, potential, options);
    motion.check_energy()?;
    let mut search = motion.search();
    let mut has_converged = false;
    let [mut number, mut short_steps] = [0; 2];
    each_step(&motion.state(0, 0.0));
    while number < options.steps && !has_converged {
        number += 1;
        let mut greatest_move = motion.step(&mut search)?;
        if options
            .resampled_every
            .is_some_and(|every| number % every == 0)
        {
            greatest_move = greatest_move.max(motion.resample());
            search.continue_from(motion.energy);
        }
        short_steps = if greatest_move <= options.tolerance {
            short_steps + 1
        } else {
            0
        };
        has_converged = greatest_move == 0.0 || short_steps == 2;
        each_step(&motion.state(number, greatest_move));
    }
    Ok(Settled {
        energy: motion.spacing * motion.energy,
        points: motion.points,
        steps: number,
        has_converged,
    })
}

/// `count` points on a circle, from the rightmost one on, clockwise as seen in the picture.
///
/// ```
/// use ga_vision::contour::snake::circle;
///
/// let [right, below] = [0, 1].map(|k| circle([20.0, 30.0], 5.0, 4)[k]);
/// assert_eq!(right, [25.0, 30.0]);
/// assert!((below[0] - 20.0).abs() < 1e-12 && (below[1] - 35.0).abs() < 1e-12);
/// ```
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
    /// h: the mean distance of the points at the beginning.
    spacing: f64,
    /// α/h² and β/h⁴.
    stiffness: [f64; 2],
    points: Vec<[f64; 2]>,
    /// The slope of E/h by each point, and the second derivatives of the potential there.
    slopes: Vec<[f64; 2]>,
    curvatures: Vec<[f64; 3]>,
    /// E/h.
    energy: f64,
    /// The same at the end of a step that may not be taken.
    next: Vec<[f64; 2]>,
    next_slopes: Vec<[f64; 2]>,
    next_curvatures: Vec<[f64; 3]>,
    /// The step, the greatest distance in it, and the energy after it.
    moves: Vec<[f64; 2]>,
    greatest_move: f64,
    next_energy: f64,
    matrix: Ring,
}

impl<'a> Motion<'a> {
    fn new(start: &[[f64; 2]], potential: &'a Potential, options: &'a SnakeOptions) -> Self {
        let count = start.len();
        let spacing = perimeter(start) / count as f64;
        let mut motion = Self {
            potential,
            options,
            spacing,
            stiffness: [
                options.tension / spacing.powi(2),
                options.rigidity / spacing.powi(4),
            ],
            points: start.to_vec(),
            slopes: vec![[0.0; 2]; count],
            curvatures: vec![[0.0; 3]; count],
            energy: 0.0,
            next: start.to_vec(),
            next_slopes: vec![[0.0; 2]; count],
            next_curvatures: vec![[0.0; 3]; count],
            moves: vec![[0.0; 2]; count],
            greatest_move: 0.0,
            next_energy: 0.0,
            matrix: Ring::default(),
        };
        let energy = motion.evaluate();
        motion.take(energy);
        motion
    }

    /// A search whose first step would be as long as it may be, if the matrix had only the damping.
    fn search(&self) -> Search {
        let steepest = self.slopes.iter().map(|[x, y]| x.hypot(*y));
        let first = steepest.fold(0.0, f64::max) / self.options.greatest_move;
        let first = first.max(f64::MIN_POSITIVE);
        let damping = Damping {
            first,
            least: 1e-4 * first,
            greatest: f64::MAX,
        };
        Search::new(self.energy, damping)
    }

    fn state(&self, number: usize, greatest_move: f64) -> SnakeStep<'_> {
        SnakeStep {
            number,
            energy: self.spacing * self.energy,
            greatest_move,
            points: &self.points,
        }
    }

    fn check_energy(&self) -> Result<(), ContourError> {
        let mut slopes = self.slopes.as_flattened().iter();
        if self.energy.is_finite() && slopes.all(|slope| slope.is_finite()) {
            return Ok(());
        }
        Err(self.energy_not_finite())
    }

    fn energy_not_finite(&self) -> ContourError {
        ContourError::EnergyNotFinite {
            tension: self.options.tension,
            rigidity: self.options.rigidity,
        }
    }

    /// Moves the points, and gives the greatest distance. It is 0 where the energy cannot fall by
    /// more than its rounding errors.
    fn step(&mut self, search: &mut Search) -> Result<f64, ContourError> {
        while !search.is_exhausted() {
            let outcome = search.step(self);
            if outcome.is_accepted {
                check::check_inside(&self.points, self.potential.size())?;
                return Ok(self.greatest_move);
            }
            if outcome.has_converged {
                return Ok(0.0);
            }
        }
        Err(self.energy_not_finite())
    }

    /// Solves the equations of a step. Gives the greatest distance of it and the slope of the
    /// energy along it; `None` where the energy has no minimum with this damping.
    fn solve(&mut self, damping: f64) -> Option<[f64; 2]> {
        let [tension, rigidity] = self.stiffness;
        let diagonal = damping + 2.0 * tension + 6.0 * rigidity;
        let neighbours = [-tension - 4.0 * rigidity, rigidity];
        self.matrix
            .factorise(&self.curvatures, diagonal, neighbours)?;
        for (step, slope) in self.moves.iter_mut().zip(&self.slopes) {
            *step = slope.map(|x| -x);
        }
        self.matrix.solve(&mut self.moves);
        let (mut greatest, mut along) = (0.0f64, 0.0);
        for ([x, y], [p, q]) in self.moves.iter().zip(&self.slopes) {
            greatest = greatest.max(x * x + y * y);
            along += x * p + y * q;
        }
        Some([greatest.sqrt(), along])
    }

    /// Places the points at equal distances, if the energy does not rise. Gives the greatest
    /// distance that a point moves.
    fn resample(&mut self) -> f64 {
        let points = resampled(&self.points, self.points.len());
        if points.len() != self.points.len() {
            return 0.0;
        }
        self.next.copy_from_slice(&points);
        let energy = self.evaluate();
        if energy.is_nan() || energy > self.energy {
            return 0.0;
        }
        self.take(energy);
        // What was accepted has changed places with what was before.
        let ways = self.points.iter().zip(&self.next);
        ways.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]))
            .fold(0.0, f64::max)
    }

    /// Goes to the next points, whose energy is this.
    fn take(&mut self, energy: f64) {
        self.energy = energy;
        std::mem::swap(&mut self.points, &mut self.next);
        std::mem::swap(&mut self.slopes, &mut self.next_slopes);
        std::mem::swap(&mut self.curvatures, &mut self.next_curvatures);
    }

    /// E/h of the next points. Notes its slope and the curvature of the potential there.
    fn evaluate(&mut self) -> f64 {
        let [tension, rigidity] = self.stiffness;
        let points = &self.next;
        let count = points.len();
        let [mut stretching, mut bending, mut outer] = [0.0; 3];
        let ends = [points[count - 2], points[count - 1], points[0], points[1]];
        let at = |index: usize| match index {
            0 | 1 => ends[index],
            _ if index < count + 2 => points[index - 2],
            _ => ends[index - count],
        };
        for index in 0..count {
            let [a, b, here, c, d] = std::array::from_fn(|k| at(index + k));
            let found = self.potential.expansion(here);
            outer += found.value;
            self.next_curvatures[index] = found.curvature;
            for axis in 0..2 {
                let [a, b, here, c, d] = [a, b, here, c, d].map(|point: [f64; 2]| point[axis]);
                let second = b - 2.0 * here + c;
                let fourth = (a - 2.0 * b + here) - 2.0 * second + (here - 2.0 * c + d);
                stretching += (c - here) * (c - here);
                bending += second * second;
                self.next_slopes[index][axis] =
                    found.slope[axis] - tension * second + rigidity * fourth;
            }
        }
        (tension * stretching + rigidity * bending) / 2.0 + outer
    }
}

impl Descent for Motion<'_> {
    fn attempt(&mut self, damping: f64) -> Attempt {
        /// Part of the energy that its rounding errors may reach.
        const ROUNDING: f64 = 1e-14;
        /// The energy falls by at least this part of what a step predicts.
        const LEAST_GAIN: f64 = 0.1;
        let Some([greatest, along]) = self.solve(damping) else {
            return Attempt::NONE;
        };
        if greatest.is_nan() || greatest > self.options.greatest_move {
            return Attempt::NONE;
        }
        let square: f64 = self.moves.as_flattened().iter().map(|x| x * x).sum();
        let predicted = (damping * square - along) / 2.0;
        if predicted <= ROUNDING * self.energy.abs() {
            return Attempt {
                is_small: true,
                predicted,
                ..Attempt::NONE
            };
        }
        let ends = self.points.iter().zip(&self.moves);
        for (next, (point, step)) in self.next.iter_mut().zip(ends) {
            *next = [point[0] + step[0], point[1] + step[1]];
        }
        let energy = self.evaluate();
        (self.greatest_move, self.next_energy) = (greatest, energy);
        let is_enough = self.energy - energy > LEAST_GAIN * predicted;
        Attempt {
            size: greatest,
            predicted,
            is_small: false,
            cost: if is_enough { energy } else { f64::INFINITY },
        }
    }

    fn accept(&mut self) {
        self.take(self.next_energy);
    }
}
