//! Fits of logistic curves by variable projection.

use super::super::{OpinionError, Scores};
use super::Curve;
use super::curve::{Fit, logistic};
use super::simplex::{self, Vertex};

/// A logistic function with a straight line, `height · logistic(steepness (x − middle)) + slope x +
/// constant`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts {
    pub(super) height: f64,
    pub(super) steepness: f64,
    pub(super) middle: f64,
    pub(super) slope: f64,
    pub(super) constant: f64,
}

/// The middle of the curve on the grid, in halves of the range of scores: a little beyond it.
const MIDDLES: usize = 61;
const FARTHEST_MIDDLE: f64 = 3.0;
/// The steepness on the grid, for scores from −1 to 1.
const STEEPNESSES: usize = 40;
const LEAST_STEEPNESS: f64 = 0.05;
const GREATEST_STEEPNESS: f64 = 1e5;
/// Where a score may lie on a slope, in the unit of its width.
const ON_SLOPE: [f64; 9] = [-3.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 3.0];
/// The simplex may leave the grid by this much, but the scores must span this part of the logistic
/// function at least: its height would be lost in rounding otherwise.
const FARTHEST: f64 = 30.0;
const LEAST_PART: f64 = 1e-6;
/// How many local minima of the grid are followed.
const FOLLOWED: usize = 80;
/// How often the search from a place begins again.
const SEARCHES: usize = 8;

/// The curve of least error on the whole grid.
pub(super) fn everywhere<C: Curve>(
    scores: &Scores,
    parameters: usize,
    curve: impl Fn(Parts) -> C,
) -> Result<Fit<C>, OpinionError> {
    let problem = Projection::new(scores, parameters)?;
    let (mut starts, least_free_sum) = problem.local_minima();
    starts.truncate(FOLLOWED);
    let sides = [
        2.0 * FARTHEST_MIDDLE / MIDDLES as f64,
        (GREATEST_STEEPNESS / LEAST_STEEPNESS).ln() / STEEPNESSES as f64,
    ];
    let mut slopes = problem.on_slopes();
    slopes.truncate(FOLLOWED);
    let slopes = slopes.into_iter().map(|(place, _)| {
        // A part of the slope.
        problem.follow(place, [0.3 / place[1].exp(), 0.5 * sides[1]])
    });
    let followed = starts
        .into_iter()
        .map(|(place, _)| problem.follow(place, sides))
        .chain(slopes);
    let best = followed.min_by(|a, b| a.1.total_cmp(&b.1));
    // The grid has a least value, so that there is at least one start.
    let place = best.map_or([0.0, 0.0], |(place, _)| place);
    let fit = problem.fit(place, curve);
    Ok(Fit {
        is_held_monotone: fit.is_held_monotone
            || problem.is_less(least_free_sum, fit.sum_of_squares),
        ..fit
    })
}

/// The curve of least error near another one.
pub(super) fn near<C: Curve>(
    scores: &Scores,
    parameters: usize,
    start: &Fit<C>,
    curve: impl Fn(Parts) -> C,
) -> Result<Fit<C>, OpinionError> {
    let problem = Projection::new(scores, parameters)?;
    let ratio = start.range[1] / problem.range[1];
    let middle = start.range[0] + start.range[1] * start.place[0];
    // On a steep slope, the rounding of another unit would move a score.
    let place = match start.range == problem.range {
        true => start.place,
        false => [
            (middle - problem.range[0]) / problem.range[1],
            start.place[1] - ratio.ln(),
        ],
    };
    let (followed, _) = problem.follow(place, [0.05, 0.2]);
    // On a steep slope the sum of the curve is not quite the one that was followed, by rounding.
    let fits = [place, followed].map(|place| problem.fit(place, &curve));
    let [start, found] = fits;
    Ok(if found.sum_of_squares < start.sum_of_squares {
        found
    } else {
        start
    })
}

/// The opinion scores, and the columns on which they depend linearly whatever the logistic function
/// is.
struct Projection<'a> {
    scores: &'a Scores,
    /// Middle and half of the range of the measure's scores.
    range: [f64; 2],
    /// The measure's scores between −1 and 1.
    objective: Vec<f64>,
    /// An orthonormal basis of what is linear: the constant, and the straight line where the curve
    /// has one.
    basis: Vec<Vec<f64>>,
    /// The opinion scores without their mean.
    centred: Vec<f64>,
    /// The opinion scores without their part in the span of the basis.
    rest: Vec<f64>,
}

/// The best of the curves with one logistic function, `height · logistic + slope x + constant` for
/// scores x between −1 and 1.
#[derive(Clone, Copy)]
struct Best {
    height: f64,
    slope: f64,
    sum_of_squares: f64,
    /// The sum of the best one that need not be monotone.
    free_sum: f64,
}

impl<'a> Projection<'a> {
    fn new(scores: &'a Scores, parameters: usize) -> Result<Self, OpinionError> {
        let count = scores.len();
        if count < parameters {
            return Err(OpinionError::TooFew {
                what: "scores",
                found: count,
                least: parameters,
            });
        }
        let bound = |start: f64, choose: fn(f64, f64) -> f64| {
            scores.objective().iter().copied().fold(start, choose)
        };
        let (least, greatest) = (
            bound(f64::INFINITY, f64::min),
            bound(f64::NEG_INFINITY, f64::max),
        );
        let range = [0.5 * least + 0.5 * greatest, 0.5 * greatest - 0.5 * least];
        let scaled = |x: &f64| (x - range[0]) / range[1];
        let objective: Vec<f64> = scores.objective().iter().map(scaled).collect();
        let mut basis = vec![vec![1.0 / (count as f64).sqrt(); count]];
        if parameters == 5 {
            let mut line = objective.clone();
            remove(&basis, &mut line);
            let length = dot(&line, &line).sqrt();
            line.iter_mut().for_each(|v| *v /= length);
            basis.push(line);
        }
        let mut centred = scores.subjective().to_vec();
        remove(&basis[..1], &mut centred);
        let mut rest = scores.subjective().to_vec();
        remove(&basis, &mut rest);
        Ok(Self {
            scores,
            range,
            objective,
            basis,
            centred,
            rest,
        })
    }

    /// The curve of least error with this middle and logarithm of the steepness, among those that
    /// rise or fall all over the range of the scores.
    fn best(&self, [middle, steepness]: [f64; 2]) -> Best {
        let steepness = steepness.exp();
        let places = self.objective.iter();
        let values: Vec<f64> = places.map(|x| logistic(steepness * (x - middle))).collect();
        let mut column = values.clone();
        remove(&self.basis, &mut column);
        let (height, sum) = projected(&column, &self.rest);
        let free = Best {
            height,
            slope: self.slope(height, &values),
            sum_of_squares: sum,
            free_sum: sum,
        };
        if self.basis.len() == 1 {
            return free;
        }
        // The curve's derivative is linear in that of the logistic function, so that it has one
        // sign wherever it has it at the least and at the greatest of those.
        let derivative = |x: f64| {
            let z = steepness * (x - middle);
            steepness * logistic(z) * logistic(-z)
        };
        let ends = [derivative(-1.0), derivative(1.0)];
        let greatest = match middle.abs() <= 1.0 {
            true => 0.25 * steepness,
            false => ends[0].max(ends[1]),
        };
        let extremes = [ends[0].min(ends[1]), greatest];
        let [first, second] = extremes.map(|extreme| free.height * extreme + free.slope);
        if first * second >= 0.0 {
            return free;
        }
        // Otherwise the best monotone curve is level where one of the two is.
        let level = extremes.map(|extreme| {
            let values = values.iter().zip(&self.objective);
            let mut column: Vec<f64> = values.map(|(v, x)| v - extreme * x).collect();
            remove(&self.basis[..1], &mut column);
            let (height, sum_of_squares) = projected(&column, &self.centred);
            Best {
                height,
                slope: -height * extreme,
                sum_of_squares,
                ..free
            }
        });
        let [first, second] = level;
        match first.sum_of_squares <= second.sum_of_squares {
            true => first,
            false => second,
        }
    }

    /// The slope of the straight line that is best beside a logistic function of this height.
    fn slope(&self, height: f64, values: &[f64]) -> f64 {
        self.basis.get(1).map_or(0.0, |line| {
            let left = self.scores.subjective().iter().zip(values);
            let left: Vec<f64> = left.map(|(y, value)| y - height * value).collect();
            // The line is the scaled scores without their mean, over its length.
            dot(line, &left) / dot(line, &self.objective)
        })
    }

    /// Whether a sum of squares is less than another one by more than rounding.
    fn is_less(&self, sum: f64, other: f64) -> bool {
        sum < other * (1.0 - 1e-6) - 1e-12 * dot(&self.centred, &self.centred)
    }

    /// Whether scores span enough of the logistic function, and it is none that is too far away.
    fn is_sensible(&self, [middle, steepness]: [f64; 2]) -> bool {
        let within = middle.abs() <= FARTHEST
            && (LEAST_STEEPNESS.ln()..=GREATEST_STEEPNESS.ln()).contains(&steepness);
        let end = |x: f64| logistic(steepness.exp() * (x - middle));
        within && end(1.0) - end(-1.0) > LEAST_PART
    }

    /// The sum of the squared errors, infinite outside of the range of sensible curves.
    fn sum_of_squares(&self, place: [f64; 2]) -> f64 {
        match self.is_sensible(place) {
            true => self.best(place).sum_of_squares,
            false => f64::INFINITY,
        }
    }

    /// The places of a grid whose sum is no greater than at the eight places around them, the least
    /// sum first; and the least sum on the grid of curves that need not be monotone.
    fn local_minima(&self) -> (Vec<Vertex>, f64) {
        let middles = self.middles();
        let steepnesses = steepnesses();
        let mut least_free_sum = f64::INFINITY;
        let mut sum = |place: [f64; 2]| {
            if !self.is_sensible(place) {
                return f64::INFINITY;
            }
            let best = self.best(place);
            least_free_sum = least_free_sum.min(best.free_sum);
            best.sum_of_squares
        };
        let mut sums: Vec<Vec<f64>> = Vec::with_capacity(middles.len());
        for middle in &middles {
            sums.push(steepnesses.iter().map(|s| sum([*middle, *s])).collect());
        }
        let mut minima = Vec::new();
        for (row, middle) in middles.iter().enumerate() {
            for (column, steepness) in steepnesses.iter().enumerate() {
                let sum = sums[row][column];
                let rows = row.saturating_sub(1)..(row + 2).min(middles.len());
                let columns = column.saturating_sub(1)..(column + 2).min(STEEPNESSES);
                if sums[rows]
                    .iter()
                    .all(|r| r[columns.clone()].iter().all(|s| *s >= sum))
                {
                    minima.push(([*middle, *steepness], sum));
                }
            }
        }
        minima.sort_by(|a, b| a.1.total_cmp(&b.1));
        // Where steps of any steepness lie between the same scores, one of them is enough.
        minima.dedup_by(|a, b| a.1 <= b.1 * (1.0 + 1e-12));
        (minima, least_free_sum)
    }

    /// Places where a score lies on the slope of the logistic function, the least sum first: for
    /// each score, those whose sum is no greater than at the next steepnesses. They are too narrow
    /// for the grid where the function is steep.
    fn on_slopes(&self) -> Vec<Vertex> {
        let steepnesses = steepnesses();
        let mut sorted = self.objective.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        let every = sorted.len().div_ceil(200);
        let mut minima = Vec::new();
        for score in sorted.iter().step_by(every) {
            let best = |steepness: &f64| {
                let places = ON_SLOPE.map(|part| [score + part / steepness.exp(), *steepness]);
                let sums = places.map(|place| (place, self.sum_of_squares(place)));
                let least = sums.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
                least.unwrap_or(([*score, *steepness], f64::INFINITY))
            };
            let row: Vec<Vertex> = steepnesses.iter().map(best).collect();
            for (k, vertex) in row.iter().enumerate() {
                let around = &row[k.saturating_sub(1)..(k + 2).min(row.len())];
                if around.iter().all(|other| other.1 >= vertex.1) {
                    minima.push(*vertex);
                }
            }
        }
        minima.sort_by(|a, b| a.1.total_cmp(&b.1));
        minima
    }

    /// Evenly spaced middles, the scores, and places between two neighbouring ones, where a step
    /// may be.
    fn middles(&self) -> Vec<f64> {
        let even =
            (0..MIDDLES).map(|k| FARTHEST_MIDDLE * (2.0 * k as f64 / (MIDDLES - 1) as f64 - 1.0));
        let mut sorted = self.objective.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        let every = sorted.len().div_ceil(200);
        // A step may also lie so near a score that this one is on its slope.
        let between = sorted.windows(2).step_by(every).flat_map(|pair| {
            [0.0, 0.25, 0.5, 0.75].map(|part| pair[0] + part * (pair[1] - pair[0]))
        });
        let mut middles: Vec<f64> = even.chain(between).chain(sorted.last().copied()).collect();
        middles.sort_by(f64::total_cmp);
        middles
    }

    /// The minimum to which a place leads. A search begins again with a new simplex, since the last
    /// one may have become flat, until that changes nothing.
    fn follow(&self, place: [f64; 2], mut sides: [f64; 2]) -> Vertex {
        let function = |place| self.sum_of_squares(place);
        let mut found = simplex::minimise(function, place, sides);
        for _ in 0..SEARCHES {
            sides = sides.map(|side| -0.3 * side);
            let next = simplex::minimise(function, found.0, sides);
            let is_same = next.1 >= found.1 * (1.0 - 1e-12);
            found = next;
            if is_same {
                break;
            }
        }
        found
    }

    fn fit<C: Curve>(&self, place: [f64; 2], curve: impl Fn(Parts) -> C) -> Fit<C> {
        let Best {
            height,
            slope,
            free_sum,
            ..
        } = self.best(place);
        let steepness = place[1].exp();
        let pairs = self.objective.iter().zip(self.scores.subjective());
        let left =
            pairs.map(|(x, y)| y - height * logistic(steepness * (x - place[0])) - slope * x);
        let constant = left.sum::<f64>() / self.objective.len() as f64;
        let [middle, half] = self.range;
        let curve = curve(Parts {
            height,
            steepness: steepness / half,
            middle: middle + half * place[0],
            slope: slope / half,
            constant: constant - slope * middle / half,
        });
        let pairs = self.scores.objective().iter().zip(self.scores.subjective());
        let sum_of_squares = pairs.map(|(x, y)| (curve.at(*x) - y).powi(2)).sum();
        Fit {
            curve,
            sum_of_squares,
            is_held_monotone: self.is_less(free_sum, sum_of_squares),
            place,
            range: self.range,
        }
    }
}

/// The logarithms of the steepnesses of the grid.
fn steepnesses() -> Vec<f64> {
    (0..STEEPNESSES)
        .map(|k| {
            let part = k as f64 / (STEEPNESSES - 1) as f64;
            (1.0 - part) * LEAST_STEEPNESS.ln() + part * GREATEST_STEEPNESS.ln()
        })
        .collect()
}

/// Takes away the part in the span of an orthonormal basis, twice for the sake of rounding.
fn remove(basis: &[Vec<f64>], values: &mut [f64]) {
    for column in basis.iter().chain(basis) {
        let part = dot(column, values);
        values
            .iter_mut()
            .zip(column)
            .for_each(|(v, c)| *v -= part * c);
    }
}

/// The factor of a column for which the sum of the squared differences from numbers is least, and
/// that sum.
fn projected(column: &[f64], numbers: &[f64]) -> (f64, f64) {
    let square = dot(column, column);
    // A column in the span of the basis has no factor.
    let factor = match square > 0.0 {
        true => dot(column, numbers) / square,
        false => 0.0,
    };
    let errors = numbers.iter().zip(column).map(|(n, c)| n - factor * c);
    (factor, errors.map(|e| e * e).sum())
}

fn dot(first: &[f64], second: &[f64]) -> f64 {
    first.iter().zip(second).map(|(a, b)| a * b).sum()
}
