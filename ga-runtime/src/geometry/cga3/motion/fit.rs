//! Motions that fit measured points and directions.

use alloc::vec::Vec;
use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use super::registration::{Pair, Sides, fixed_rotation, root_mean_square};
use super::weight::{WeightError, checked};
use crate::cga3::{Dilator, Motor, Point, Rotor, Similarity, Translator};
use crate::geometry::vector3::{are_numbers, difference, dot, normalized, scaled};
use crate::scalar::Real;

/// The motion that fits best, and how well it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<V, S> {
    /// The motion, a [`Rotor`], [`Motor`] or [`Similarity`] of non-negative scalar part.
    pub motion: V,
    /// The root mean square of the distances left, `√(Σ wᵢ |yᵢ − xᵢ'|² / Σ wᵢ)`.
    pub residual: S,
}

/// Pairs that fix no motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError<S> {
    /// There are too few pairs with a weight above zero.
    TooFewPairs {
        /// The number of such pairs.
        found: usize,
        /// The number needed: three of points, two of directions.
        needed: usize,
    },
    /// The weights make no average.
    Weight(WeightError<S>),
    /// A point or direction of a pair is not finite.
    NotFinite {
        /// Which of the pairs, from 0.
        index: usize,
    },
    /// A direction of a pair is zero.
    NoDirection {
        /// Which of the pairs, from 0.
        index: usize,
    },
    /// All points of one side are at one place.
    Coincident,
    /// All points of one side lie on a line, all directions of one side are parallel: a turn about
    /// it changes nothing.
    Collinear,
    /// Several turns fit equally well, as when one side is the mirror image of a regular body, or
    /// when the sides have nothing to do with each other.
    NotUnique,
    /// The result is beyond the range of the scalar.
    OutOfRange,
}

impl<S: Debug> Display for FitError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::TooFewPairs { found, needed } => {
                write!(
                    f,
                    "{needed} pairs with a weight above zero are needed, not {found}"
                )
            }
            Self::Weight(error) => Display::fmt(error, f),
            Self::NotFinite { index } => write!(f, "pair {index} is not finite"),
            Self::NoDirection { index } => write!(f, "pair {index} has a direction of length zero"),
            Self::Coincident => f.write_str("all points of one side are at one place"),
            Self::Collinear => f.write_str("all points of one side lie on a line"),
            Self::NotUnique => f.write_str("several turns fit equally well"),
            Self::OutOfRange => f.write_str("the result is beyond the range of the scalar"),
        }
    }
}

impl<S: Debug> core::error::Error for FitError<S> {}

impl<S> From<WeightError<S>> for FitError<S> {
    fn from(error: WeightError<S>) -> Self {
        Self::Weight(error)
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The motor that carries the first points of three or more pairs as near as possible to the
    /// second ones: the M for which `Σ |yᵢ − M xᵢ ~M|²` is least.
    ///
    /// The turn comes from the largest eigenvalue of Horn's symmetric 4×4 matrix (Closed-form
    /// solution of absolute orientation using unit quaternions, Journal of the Optical Society of
    /// America A 4, 1987) and two steps of Newton, which take away what its squares have lost; the
    /// shift carries centroid to centroid. Mirror images give the best proper motion.
    ///
    /// # Errors
    /// Less than three pairs, numbers that are not finite, a result beyond the range of the scalar.
    /// Points of one side that are at one place or on a line, within 8√ε of their extent and what
    /// the size of their coordinates lets be told. Pairs that several motors fit equally well.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point};
    /// use ga_runtime::geometry::motion::FitError;
    /// // A quarter turn about e3 and a shift by 5 along e1.
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

    /// The same with weights: `Σ wᵢ |yᵢ − M xᵢ ~M|²` is least. Pairs of weight zero do not count,
    /// and weights count by their ratios.
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
    /// The similarity, a motion after a scaling, that carries the first points of three or more
    /// pairs as near as possible to the second ones: Procrustes analysis. The turn is that of
    /// [`Motor::from_point_pairs`], the factor is `s = Σ yᵢ·R xᵢ / Σ xᵢ²` with both sides taken
    /// from their centroids (Umeyama, Least-squares estimation of transformation parameters between
    /// two point patterns, IEEE Transactions on Pattern Analysis and Machine Intelligence 13,
    /// 1991).
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
    /// The rotor that turns the first directions of two or more pairs as near as possible to the
    /// second ones: the R for which `Σ |bᵢ − R aᵢ ~R|²` is least, for the directions made of
    /// length 1. This is Wahba's problem (SIAM Review 7, 1965), and the solution that of
    /// [`Motor::from_point_pairs`].
    ///
    /// # Errors
    /// Less than two pairs, numbers that are not finite, directions of length zero, directions of
    /// one side that are all parallel within 8√ε, pairs that several rotors fit equally well.
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

    /// The same with weights: `Σ wᵢ |bᵢ − R aᵢ ~R|²` is least. Pairs of weight zero do not count,
    /// and weights count by their ratios.
    ///
    /// # Errors
    /// Those of [`Rotor::from_direction_pairs`], and weights that are negative or not finite, or
    /// all zero.
    pub fn from_weighted_direction_pairs(
        weighted: &[(S, [S; 3], [S; 3])],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        let mut pairs = counting(weighted, 2)?;
        for (index, pair) in &mut pairs {
            let of_length_one = |v| normalized(v).ok_or(FitError::NoDirection { index: *index });
            (pair.from, pair.to) = (of_length_one(pair.from)?, of_length_one(pair.to)?);
        }
        let pairs: Vec<_> = pairs.into_iter().map(|(_, pair)| pair).collect();
        let sides = Sides::measured(&pairs, [S::one(); 2])?;
        let motion = fixed_rotation(&pairs, sides)?;
        let residual = root_mean_square(&pairs, motion, S::one());
        Ok(Fit { motion, residual })
    }
}

/// Pairs of points, each from the centroid of its side.
struct Centred<S> {
    pairs: Vec<Pair<S>>,
    sides: Sides<S>,
    centroids: [[S; 3]; 2],
}

impl<S: Real<Mask = bool>> Centred<S> {
    fn from(weighted: &[(S, Point<S>, Point<S>)]) -> Result<Self, FitError<S>> {
        let coordinates: Vec<_> = weighted
            .iter()
            .map(|(weight, x, y)| (*weight, x.coordinates(), y.coordinates()))
            .collect();
        let mut pairs: Vec<_> = counting(&coordinates, 3)?
            .into_iter()
            .map(|(_, pair)| pair)
            .collect();
        let total = pairs.iter().fold(S::zero(), |sum, pair| sum + pair.weight);
        let mut centroids = [[S::zero(); 3]; 2];
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
            pair.from = difference(pair.from, centroids[0]);
            pair.to = difference(pair.to, centroids[1]);
            if !(are_numbers(pair.from) && are_numbers(pair.to)) {
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

    /// The shift that carries the image of the one centroid to the other.
    fn shift(&self, rotor: Rotor<S>, factor: S) -> Result<Translator<S>, FitError<S>> {
        let [from, to] = self.centroids;
        let image = rotor.transform(Point::from(scaled(from, factor)));
        let displacement = difference(to, image.coordinates());
        are_numbers(displacement)
            .then(|| Translator::from_displacement(displacement))
            .ok_or(FitError::OutOfRange)
    }

    fn factor(&self, rotor: Rotor<S>) -> S {
        let [from, to] = self.sides.extents;
        let sums = self
            .pairs
            .iter()
            .fold([S::zero(); 2], |[along, square], pair| {
                let x = pair.from.map(|x| x / from);
                let image = rotor.transform(Point::from(x)).coordinates();
                let y = pair.to.map(|y| y / to);
                [
                    along + dot(image, y) * pair.weight,
                    square + dot(x, x) * pair.weight,
                ]
            });
        sums[0] / sums[1] * (to / from)
    }
}

/// The pairs of weights above zero, by their indices; the largest weight becomes 1.
fn counting<S: Real<Mask = bool>>(
    weighted: &[(S, [S; 3], [S; 3])],
    needed: usize,
) -> Result<Vec<(usize, Pair<S>)>, FitError<S>> {
    let mut largest = S::zero();
    for (index, &(weight, from, to)) in weighted.iter().enumerate() {
        largest = largest.max(checked(index, weight)?);
        if !(from.iter().chain(&to)).all(|x| x.is_finite()) {
            return Err(FitError::NotFinite { index });
        }
    }
    if !weighted.is_empty() && !S::zero().less_than(largest) {
        return Err(WeightError::AllZero.into());
    }
    let pairs: Vec<_> = weighted
        .iter()
        .enumerate()
        .filter(|(_, (weight, ..))| S::zero().less_than(*weight))
        .map(|(index, &(weight, from, to))| {
            let weight = weight / largest;
            (index, Pair { weight, from, to })
        })
        .collect();
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
