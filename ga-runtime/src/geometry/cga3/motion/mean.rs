//! The intrinsic mean of motions.

use alloc::vec::Vec;
use core::fmt::Debug;

use super::alignment::{aligned, rotor_coordinates};
use super::blend::{counting, is_finite, largest_weight};
use super::enclosing::lie_in_quarter_ball;
use super::residual::Residual;
use crate::cga3::{DualQuaternion, Motor, MotorGenerator, Rotor, Translator};
use crate::geometry::FitError;
use crate::geometry::cga3::matrix::{Matrix, solve};
use crate::scalar::Real;
use crate::vga3::Vector;

/// More steps than the iteration needs for any motions with a unique mean.
const MOST_STEPS: usize = 25;

/// A mean, and how accurate it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean<V, S> {
    /// The mean: the weighted sum of the logarithms of the others, as seen from it, is zero.
    pub mean: V,
    /// The remaining error of the condition on the mean.
    pub residual: Residual<S>,
    /// The number of steps of the iteration, which starts at the blend.
    pub steps: usize,
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The weighted intrinsic mean of motors: the M with `Σ wᵢ log(~M Mᵢ) = 0`.
    ///
    /// Its rotation is the Karcher mean of the rotations, where the weighted sum of squared angles
    /// is least (Moakher, Means and averaging in the group of rotations, SIAM Journal on Matrix
    /// Analysis 24, 2002). The whole is the exponential barycentre of Pennec and Arsigny (in Matrix
    /// Information Geometry, 2012): it is equivariant under changes of frames on either side,
    /// `mean(A Mᵢ B) = A mean(Mᵢ) B`, which is not true of any least sum of squared distances of
    /// motions. The mean of two motors is on the screw from one to the other, at the fraction given
    /// by the weights. Only the ratios of the weights matter, and the sign is that of the motor
    /// with the largest weight, as in [`Motor::blend`], where the iteration starts.
    ///
    /// The mean is unique where all rotations are within a quarter turn of some common rotation,
    /// which need not be one of them (Kendall, Probability, convexity, and harmonic maps,
    /// Proceedings of the London Mathematical Society 61, 1990; Afsari, Riemannian Lᵖ center of
    /// mass, Proceedings of the American Mathematical Society 139, 2011), except where there are
    /// only two different rotations, half a turn apart. Other motors are an error; it is then
    /// proven, up to 64ε, that there is no such common rotation.
    ///
    /// # Method
    ///
    /// With rotations of half-angle φᵢ about uᵢ in the logarithms, the sum of squares has the
    /// second derivative `H = Σ wᵢ (uᵢuᵢᵀ + φᵢ cot φᵢ (1 − uᵢuᵢᵀ))`, so a step by `H⁻¹` instead of
    /// `1/Σw` is a Newton step. At the mean of the rotations the displacements obey a linear system
    /// with the same H, and the same step solves it. Usually three steps are enough, or four where
    /// the rotations are a quarter turn away; the remaining error is that of rounding.
    ///
    /// # Errors
    /// Those of [`Motor::blend`]; rotations that are not all within a quarter turn of a common one;
    /// no convergence after 25 steps.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor, Translator};
    /// use ga_runtime::geometry::FitError;
    /// let rotation =
    ///     |angle: f64| Motor::from(Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap());
    /// let lift = Motor::from(Translator::from_displacement([0.0, 0.0, 6.0]));
    /// let found = Motor::mean(&[
    ///     (1.0, rotation(0.0)),
    ///     (1.0, rotation(0.3)),
    ///     (1.0, lift * rotation(0.6)),
    /// ])
    /// .unwrap();
    /// let [x, y, z] = found.mean.translator().displacement();
    /// assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && (z - 2.0).abs() < 1e-15);
    /// assert!(
    ///     (found.mean.rotor().to_axis_angle().1 - 0.3).abs() < 1e-15
    ///         && found.residual.angle < 1e-15
    /// );
    /// // Three rotations by thirds of a full turn have no mean: each of the three is equally good.
    /// let thirds = [0.0, 2.0, 4.0].map(|k| (1.0, rotation(k * std::f64::consts::PI / 3.0)));
    /// assert!(matches!(
    ///     Motor::mean(&thirds),
    ///     Err(FitError::MeanNotUnique { .. })
    /// ));
    /// ```
    pub fn mean(weighted: &[(S, Self)]) -> Result<Mean<Self, S>, FitError<S>> {
        let largest = largest_weight(weighted)?;
        let terms: Vec<_> = aligned(counting(weighted, largest))
            .into_iter()
            .flatten()
            .collect();
        let blend = Self::blend(weighted)?;
        let rotors: Vec<_> = terms
            .iter()
            .map(|&(_, motor)| rotor_coordinates(motor))
            .collect();
        if !lie_in_quarter_ball(&rotors, rotor_coordinates(blend)) {
            let (index, angle) = farthest(weighted, blend);
            return Err(FitError::MeanNotUnique { index, angle });
        }
        let found = iterate(&terms, blend)?;
        let mean = DualQuaternion::from(found.mean).normalize();
        match mean.filter(|&mean| is_finite(mean)) {
            Some(mean) => Ok(Mean { mean, ..found }),
            None => Err(FitError::OutOfRange),
        }
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The weighted intrinsic mean of rotors, the R with `Σ wᵢ log(~R Rᵢ) = 0`; see
    /// [`Motor::mean`]. The residual has no displacement.
    ///
    /// # Errors
    /// Those of [`Motor::mean`].
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let rotations = axes.map(|axis| (1.0, Rotor::from_axis_angle(axis, 1.0_f64).unwrap()));
    /// let found = Rotor::mean(&rotations).unwrap();
    /// let (axis, _) = found.mean.to_axis_angle();
    /// assert!(axis.iter().all(|x| (x - 1.0 / 3.0_f64.sqrt()).abs() < 1e-15));
    /// ```
    pub fn mean(weighted: &[(S, Self)]) -> Result<Mean<Self, S>, FitError<S>> {
        let motors: Vec<_> = weighted
            .iter()
            .map(|&(weight, rotor)| (weight, Motor::from(rotor)))
            .collect();
        let found = Motor::mean(&motors)?;
        Ok(Mean {
            mean: found.mean.rotor(),
            residual: found.residual,
            steps: found.steps,
        })
    }
}

fn iterate<S: Real<Mask = bool>>(
    terms: &[(S, Motor<S>)],
    start: Motor<S>,
) -> Result<Mean<Motor<S>, S>, FitError<S>> {
    let epsilon = |multiple| S::epsilon() * S::from_integer(multiple);
    // Displacements are not more accurate than the rounding of the largest of them.
    let reach = terms.iter().fold(S::zero(), |most, (_, motor)| {
        most.max(Vector::from(motor.translator().displacement()).length())
    });
    let (mut mean, mut here) = (start, Deviation::from(start, terms));
    let mut before = None;
    let mut steps = 0;
    loop {
        let residual = here.residual();
        let level = residual.angle.max(if S::zero().less_than(reach) {
            residual.displacement / reach
        } else {
            S::zero()
        });
        if !level.is_finite() || !residual.displacement.is_finite() {
            return Err(FitError::OutOfRange);
        }
        // Converged, or as near to it as rounding allows.
        let is_stalled = before.is_some_and(|before: S| !(level + level).less_than(before));
        if !epsilon(4).less_than(level) || is_stalled && level.less_than(epsilon(256)) {
            return Ok(Mean {
                mean,
                residual,
                steps,
            });
        }
        if steps == MOST_STEPS {
            return Err(FitError::MeanNotConverged { steps, residual });
        }
        steps += 1;
        before = Some(level);
        mean *= here.step();
        here = Deviation::from(mean, terms);
    }
}

/// How motors deviate from one: weighted means over `log(~M Mᵢ)`.
struct Deviation<S> {
    /// Half the rotation vector.
    turn: Vector<S>,
    displacement: Vector<S>,
    /// The second derivative H of half the sum of squares of half-angles.
    curvature: Matrix<S, 3>,
}

impl<S: Real<Mask = bool>> Deviation<S> {
    fn from(mean: Motor<S>, terms: &[(S, Motor<S>)]) -> Self {
        let (zero, one) = (S::zero(), S::one());
        let [mut turn, mut displacement] = [[Sum::default(); 3]; 2];
        let mut curvature = [[Sum::default(); 3]; 3];
        let mut total = Sum::default();
        for &(weight, motor) in terms {
            let mut between = mean.reverse() * motor;
            if between.scalar().less_than(zero) {
                between = -between;
            }
            let log = between.log();
            let half = Vector::new(-log.e23, log.e13, -log.e12);
            let angle = half.length();
            let sine = Vector::new(between.e12(), between.e13(), between.e23()).length();
            // φ cot φ
            let across = if zero.less_than(sine) {
                angle * between.scalar() / sine
            } else {
                one
            };
            let axis = if zero.less_than(angle) {
                half.divided(angle)
            } else {
                Vector::default()
            };
            let shift = Vector::new(log.e1i, log.e2i, log.e3i);
            for k in 0..3 {
                turn[k].add(half[k] * weight);
                displacement[k].add(-(shift[k] + shift[k]) * weight);
                curvature[k][k].add(across * weight);
                for j in 0..3 {
                    curvature[k][j].add((one - across) * axis[k] * axis[j] * weight);
                }
            }
            total.add(weight);
        }
        let total = total.value();
        let mean_of = |sum: Sum<S>| sum.value() / total;
        Self {
            turn: turn.map(mean_of).into(),
            displacement: displacement.map(mean_of).into(),
            curvature: curvature.map(|row| row.map(mean_of)),
        }
    }

    fn residual(&self) -> Residual<S> {
        Residual {
            angle: self.turn.length() * S::from_integer(2),
            displacement: self.displacement.length(),
        }
    }

    /// The motion of `H⁻¹` times the deviation; of the deviation itself where H is singular.
    fn step(&self) -> Motor<S> {
        let solved = |vector: Vector<S>| {
            let vector = vector.coordinates();
            solve(self.curvature, vector).unwrap_or(vector)
        };
        let [x, y, z] = solved(self.turn);
        let zero = S::zero();
        let turn = MotorGenerator::new(-z, y, -x, zero, zero, zero).exp();
        Translator::from_displacement(solved(self.displacement)) * turn.rotor()
    }
}

/// A sum that compensates for rounding (Neumaier, Rundungsfehleranalyse einiger Verfahren zur
/// Summation endlicher Summen, Zeitschrift für Angewandte Mathematik und Mechanik 54, 1974).
#[derive(Clone, Copy)]
struct Sum<S> {
    rounded: S,
    lost: S,
}

impl<S: Real<Mask = bool>> Default for Sum<S> {
    fn default() -> Self {
        Self {
            rounded: S::zero(),
            lost: S::zero(),
        }
    }
}

impl<S: Real<Mask = bool>> Sum<S> {
    fn add(&mut self, term: S) {
        let sum = self.rounded + term;
        self.lost += if term.abs().less_than(self.rounded.abs()) {
            (self.rounded - sum) + term
        } else {
            (term - sum) + self.rounded
        };
        self.rounded = sum;
    }

    fn value(self) -> S {
        self.rounded + self.lost
    }
}

/// The index of the motor with the largest angle from another, and this angle, in [0, π].
fn farthest<S: Real<Mask = bool>>(weighted: &[(S, Motor<S>)], from: Motor<S>) -> (usize, S) {
    let mut most = (0, S::zero());
    for (index, &(weight, motor)) in weighted.iter().enumerate() {
        let between = from.rotor().reverse() * motor.rotor();
        let sine = Vector::new(between.e12(), between.e13(), between.e23()).length();
        let half = sine.atan2(between.scalar().abs());
        if S::zero().less_than(weight) && most.1.less_than(half) {
            most = (index, half);
        }
    }
    (most.0, most.1 + most.1)
}
