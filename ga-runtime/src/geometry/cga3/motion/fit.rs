//! Motions that fit measured points and directions.

use alloc::vec::Vec;

use super::fit_error::FitError;
use super::registration::{Pair, Sides, fixed_rotation, root_mean_square};
use super::weight::{WeightError, checked};
use crate::cga3::{Dilator, Motor, Point, Rotor, Similarity, Translator};
use crate::scalar::Real;
use crate::vga3::Vector;

/// The motion that fits best, and how well it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<V, S> {
    /// The motion, a [`Rotor`], [`Motor`] or [`Similarity`] of non-negative scalar part.
    pub motion: V,
    /// The root mean square of the remaining distances, `√(Σ wᵢ |yᵢ − xᵢ'|² / Σ wᵢ)`.
    pub residual: S,
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The motor that moves the first points of three or more pairs as near as possible to the
    /// second points: the M for which `Σ |yᵢ − M xᵢ ~M|²` is least.
    ///
    /// The rotation comes from the largest eigenvalue of Horn's symmetric 4×4 matrix (Closed-form
    /// solution of absolute orientation using unit quaternions, Journal of the Optical Society of
    /// America A 4, 1987) and two Newton steps, which restore the accuracy that is lost by its
    /// squares; the translation maps centroid to centroid. For mirror images the result is the best
    /// motion without a reflection.
    ///
    /// # Errors
    /// Fewer than three pairs, numbers that are not finite, a result beyond the range of the
    /// scalar. All first points, or all second points, coincident or on a line, within 8√ε of their
    /// extent and the rounding of their coordinates. Pairs that several motors fit equally well.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point};
    /// use ga_runtime::geometry::motion::FitError;
    /// // A quarter turn about e3 and a translation by 5 along e1.
    /// let from = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point::from);
    /// let to = [[5.0, 0.0, 0.0], [5.0, 1.0, 0.0], [3.0, 0.0, 0.0]].map(Point::from);
    /// let pairs: Vec<(Point<f64>, Point<f64>)> = from.into_iter().zip(to).collect();
    /// let fit = Motor::from_point_pairs(&pairs).unwrap();
    /// assert!(fit.residual < 1e-15);
    /// let image = fit.motion.transform(Point::new(0.0, 0.0, 7.0));
    /// assert!(image.distance(Point::new(5.0, 0.0, 7.0)) < 1e-14);
    /// assert_eq!(
    ///     Motor::from_point_pairs(&pairs[..2]),
    ///     Err(FitError::TooFewPairs {
    ///         found: 2,
    ///         needed: 3
    ///     })
    /// );
    /// ```
    pub fn from_point_pairs(pairs: &[(Point<S>, Point<S>)]) -> Result<Fit<Self, S>, FitError<S>> {
        Self::from_weighted_point_pairs(&equally_weighted(pairs))
    }

    /// The same with weights: `Σ wᵢ |yᵢ − M xᵢ ~M|²` is least. Pairs of weight zero are ignored,
    /// and only the ratios of the weights matter.
    ///
    /// # Errors
    /// Those of [`Motor::from_point_pairs`], and weights that are negative or not finite, or all
    /// zero.
    pub fn from_weighted_point_pairs(
        weighted: &[(S, Point<S>, Point<S>)],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        let centred = Centred::from(weighted)?;
        let rotor = fixed_rotation(&centred.pairs, centred.sides)?;
        let residual = root_mean_square(&centred.pairs, rotor, S::one());
        let shift = centred.shift(rotor, S::one())?;
        finite(shift * rotor, residual)
    }
}

impl<S: Real<Mask = bool>> Similarity<S> {
    /// The similarity (a scaling followed by a motion) that moves the first points of three or more
    /// pairs as near as possible to the second points: Procrustes analysis. The rotation is that of
    /// [`Motor::from_point_pairs`], the scale factor is `s = Σ yᵢ·R xᵢ / Σ xᵢ²` with both sets of
    /// points relative to their centroids (Umeyama, Least-squares estimation of transformation
    /// parameters between two point patterns, IEEE Transactions on Pattern Analysis and Machine
    /// Intelligence 13, 1991).
    ///
    /// # Errors
    /// Those of [`Motor::from_point_pairs`].
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Similarity};
    /// let from = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
    /// let to = [[1.0, 1.0, 0.0], [4.0, 1.0, 0.0], [1.0, 4.0, 0.0]].map(Point::from);
    /// let pairs: Vec<(Point<f64>, Point<f64>)> = from.into_iter().zip(to).collect();
    /// let fit = Similarity::from_point_pairs(&pairs).unwrap();
    /// let image = fit.motion.transform(Point::new(1.0, 1.0, 1.0)).centre().unwrap();
    /// assert!(image.distance(Point::new(4.0, 4.0, 3.0)) < 1e-14 && fit.residual < 1e-15);
    /// ```
    pub fn from_point_pairs(pairs: &[(Point<S>, Point<S>)]) -> Result<Fit<Self, S>, FitError<S>> {
        Self::from_weighted_point_pairs(&equally_weighted(pairs))
    }

    /// The same with weights; see [`Motor::from_weighted_point_pairs`].
    ///
    /// # Errors
    /// Those of [`Motor::from_weighted_point_pairs`].
    pub fn from_weighted_point_pairs(
        weighted: &[(S, Point<S>, Point<S>)],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        let centred = Centred::from(weighted)?;
        let rotor = fixed_rotation(&centred.pairs, centred.sides)?;
        let factor = centred.factor(rotor);
        let dilator = Dilator::from_factor(factor).ok_or(FitError::OutOfRange)?;
        let residual = root_mean_square(&centred.pairs, rotor, factor);
        let fit = finite(centred.shift(rotor, factor)? * rotor, residual)?;
        Ok(Fit {
            motion: fit.motion * dilator,
            residual,
        })
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotor that rotates the first directions of two or more pairs as near as possible to the
    /// second directions: the R for which `Σ |bᵢ − R aᵢ ~R|²` is least, with all directions
    /// normalised to length 1. This is Wahba's problem (SIAM Review 7, 1965), and it is solved as
    /// in [`Motor::from_point_pairs`].
    ///
    /// # Errors
    /// Fewer than two pairs, numbers that are not finite, directions of length zero, first
    /// directions or second directions that are all parallel within 8√ε, pairs that several rotors
    /// fit equally well.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// // North and up, as seen in two frames.
    /// let pairs = [
    ///     ([0.0_f64, 1.0, 0.0], [2.0, 0.0, 0.0]),
    ///     ([0.0, 0.0, 1.0], [0.0, 0.0, 9.8]),
    /// ];
    /// let fit = Rotor::from_direction_pairs(&pairs).unwrap();
    /// let (axis, angle) = fit.motion.to_axis_angle();
    /// assert!(
    ///     (axis[2] + 1.0).abs() < 1e-15 && (angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15
    /// );
    /// ```
    pub fn from_direction_pairs(pairs: &[([S; 3], [S; 3])]) -> Result<Fit<Self, S>, FitError<S>> {
        Self::from_weighted_direction_pairs(&equally_weighted(pairs))
    }

    /// The same with weights: `Σ wᵢ |bᵢ − R aᵢ ~R|²` is least. Pairs of weight zero are ignored,
    /// and only the ratios of the weights matter.
    ///
    /// # Errors
    /// Those of [`Rotor::from_direction_pairs`], and weights that are negative or not finite, or
    /// all zero.
    pub fn from_weighted_direction_pairs(
        weighted: &[(S, [S; 3], [S; 3])],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        let mut pairs = counting(weighted.iter().copied(), 2)?;
        for (index, pair) in &mut pairs {
            let of_length_one = |v: Vector<S>| {
                v.normalized()
                    .ok_or(FitError::NoDirection { index: *index })
            };
            (pair.from, pair.to) = (of_length_one(pair.from)?, of_length_one(pair.to)?);
        }
        let pairs: Vec<_> = pairs.into_iter().map(|(_, pair)| pair).collect();
        let sides = Sides::measured(&pairs, [S::one(); 2])?;
        let motion = fixed_rotation(&pairs, sides)?;
        let residual = root_mean_square(&pairs, motion, S::one());
        Ok(Fit { motion, residual })
    }
}

/// Pairs of points, relative to the centroid of the first points and of the second points.
struct Centred<S> {
    pairs: Vec<Pair<S>>,
    sides: Sides<S>,
    centroids: [Vector<S>; 2],
}

impl<S: Real<Mask = bool>> Centred<S> {
    fn from(weighted: &[(S, Point<S>, Point<S>)]) -> Result<Self, FitError<S>> {
        let mut pairs: Vec<_> = counting(weighted.iter().copied(), 3)?
            .into_iter()
            .map(|(_, pair)| pair)
            .collect();
        let total = pairs.iter().fold(S::zero(), |sum, pair| sum + pair.weight);
        let mut centroids = [Vector::default(); 2];
        let mut largest = [S::zero(); 2];
        for pair in &pairs {
            let share = pair.weight / total;
            for (side, point) in [pair.from, pair.to].into_iter().enumerate() {
                for k in 0..3 {
                    centroids[side][k] = point[k].mul_add(share, centroids[side][k]);
                    largest[side] = largest[side].max(point[k].abs());
                }
            }
        }
        for pair in &mut pairs {
            pair.from -= centroids[0];
            pair.to -= centroids[1];
            if !(pair.from.is_finite() && pair.to.is_finite()) {
                return Err(FitError::OutOfRange);
            }
        }
        let sides = Sides::measured(&pairs, largest)?;
        Ok(Self {
            pairs,
            sides,
            centroids,
        })
    }

    /// The translation that moves the image of the first centroid to the second.
    fn shift(&self, rotor: Rotor<S>, factor: S) -> Result<Translator<S>, FitError<S>> {
        let [from, to] = self.centroids;
        let image = rotor.transform(Point::from(from * factor));
        let displacement = to - Vector::from(image);
        displacement
            .is_finite()
            .then(|| Translator::from_displacement(displacement.into()))
            .ok_or(FitError::OutOfRange)
    }

    fn factor(&self, rotor: Rotor<S>) -> S {
        let [from, to] = self.sides.extents;
        let sums = self
            .pairs
            .iter()
            .fold([S::zero(); 2], |[along, square], pair| {
                let x = pair.from.divided(from);
                let image = Vector::from(rotor.transform(Point::from(x)));
                let y = pair.to.divided(to);
                [
                    along + image.dot(y) * pair.weight,
                    square + x.dot(x) * pair.weight,
                ]
            });
        sums[0] / sums[1] * (to / from)
    }
}

/// The indices of the pairs with weights above zero, with the weights divided by the largest.
fn counting<S: Real<Mask = bool>, V: Into<Vector<S>>>(
    weighted: impl ExactSizeIterator<Item = (S, V, V)>,
    needed: usize,
) -> Result<Vec<(usize, Pair<S>)>, FitError<S>> {
    let mut largest = S::zero();
    let mut pairs = Vec::with_capacity(weighted.len());
    for (index, (weight, from, to)) in weighted.enumerate() {
        let (from, to) = (from.into(), to.into());
        largest = largest.max(checked(index, weight)?);
        if !(from.is_finite() && to.is_finite()) {
            return Err(FitError::NotFinite { index });
        }
        pairs.push((index, Pair { weight, from, to }));
    }
    if !pairs.is_empty() && !S::zero().less_than(largest) {
        return Err(WeightError::AllZero.into());
    }
    pairs.retain(|(_, pair)| S::zero().less_than(pair.weight));
    for (_, pair) in &mut pairs {
        pair.weight = pair.weight / largest;
    }
    if pairs.len() < needed {
        let found = pairs.len();
        return Err(FitError::TooFewPairs { found, needed });
    }
    Ok(pairs)
}

fn equally_weighted<S: Real, T: Copy>(pairs: &[(T, T)]) -> Vec<(S, T, T)> {
    pairs.iter().map(|&(x, y)| (S::one(), x, y)).collect()
}

fn finite<S: Real<Mask = bool>>(
    motion: Motor<S>,
    residual: S,
) -> Result<Fit<Motor<S>, S>, FitError<S>> {
    let is_finite = super::blend::is_finite(motion) && residual.is_finite();
    is_finite
        .then_some(Fit { motion, residual })
        .ok_or(FitError::OutOfRange)
}
