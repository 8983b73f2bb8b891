//! Motions that fit measured points and directions.

use alloc::vec::Vec;

use super::moments::Moments;
use super::registration::{Pair, Sides, fixed_rotation};
use crate::cga3::{Dilator, Motor, Point, Rotor, Similarity, Translator};
use crate::geometry::FitError;
use crate::geometry::cga3::weight::checked;
use crate::scalar::Real;
use crate::vga3::Vector;

/// The motion that fits best. How well it does is a [`residual`](Fit::residual) that is computed
/// from the pairs on request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<V, S> {
    /// The motion, a [`Rotor`], [`Motor`] or [`Similarity`] of non-negative scalar part.
    pub motion: V,
    alignment: Alignment<S>,
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The motor that moves the first points of three or more pairs as near as possible to the
    /// second points: the M for which `Σ |yᵢ − M xᵢ ~M|²` is least.
    ///
    /// The rotation comes from the largest eigenvalue of Horn's symmetric 4×4 matrix (Closed-form
    /// solution of absolute orientation using unit quaternions, Journal of the Optical Society of
    /// America A 4, 1987); the translation maps centroid to centroid. For mirror images the result
    /// is the best motion without a reflection.
    ///
    /// The pairs are read once. Only where they are close to a line or a point, or to several
    /// equally good motions, are they read again, for Newton steps that restore the accuracy that
    /// the squares in the matrix lose. [`Fit::residual`] is computed on request.
    ///
    /// # Errors
    /// Fewer than three pairs, numbers that are not finite, a result beyond the range of the
    /// scalar. All first points, or all second points, coincident or on a line, within 8√ε of their
    /// extent and the rounding of their coordinates. Pairs that several motors fit equally well.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point};
    /// use ga_runtime::geometry::FitError;
    /// // A quarter turn about e3 and a translation by 5 along e1.
    /// let from = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point::from);
    /// let to = [[5.0, 0.0, 0.0], [5.0, 1.0, 0.0], [3.0, 0.0, 0.0]].map(Point::from);
    /// let pairs: Vec<(Point<f64>, Point<f64>)> = from.into_iter().zip(to).collect();
    /// let fit = Motor::from_point_pairs(&pairs).unwrap();
    /// assert!(fit.residual(&pairs) < 1e-15);
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
        motor(pairs.iter().map(equal_weight), count(pairs))
    }

    /// The same with weights: `Σ wᵢ |yᵢ − M xᵢ ~M|²` is least. Pairs of weight zero are ignored,
    /// and only the ratios of the weights matter.
    ///
    /// # Errors
    /// Those of [`Motor::from_point_pairs`], and weights that are negative or not finite, or all
    /// zero.
    pub fn from_weighted_point_pairs(
        pairs: &[(S, Point<S>, Point<S>)],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        motor(pairs.iter().map(weighted), None)
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
    /// assert!(image.distance(Point::new(4.0, 4.0, 3.0)) < 1e-14 && fit.residual(&pairs) < 1e-15);
    /// ```
    pub fn from_point_pairs(pairs: &[(Point<S>, Point<S>)]) -> Result<Fit<Self, S>, FitError<S>> {
        similarity(pairs.iter().map(equal_weight), count(pairs))
    }

    /// The same with weights; see [`Motor::from_weighted_point_pairs`].
    ///
    /// # Errors
    /// Those of [`Motor::from_weighted_point_pairs`].
    pub fn from_weighted_point_pairs(
        pairs: &[(S, Point<S>, Point<S>)],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        similarity(pairs.iter().map(weighted), None)
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
        rotor(pairs.iter().map(equal_weight), count(pairs))
    }

    /// The same with weights: `Σ wᵢ |bᵢ − R aᵢ ~R|²` is least. Pairs of weight zero are ignored,
    /// and only the ratios of the weights matter.
    ///
    /// # Errors
    /// Those of [`Rotor::from_direction_pairs`], and weights that are negative or not finite, or
    /// all zero.
    pub fn from_weighted_direction_pairs(
        pairs: &[(S, [S; 3], [S; 3])],
    ) -> Result<Fit<Self, S>, FitError<S>> {
        rotor(pairs.iter().map(weighted), None)
    }
}

macro_rules! residuals {
    ($($Motion:ident $Member:ty: $left:ident;)*) => {$(
        impl<S: Real<Mask = bool>> Fit<$Motion<S>, S> {
            /// The root mean square of the distances that remain between the members of pairs,
            /// `√(Σ |yᵢ − xᵢ'|² / n)`: of the pairs that were fitted, or of others. Zero for no
            /// pairs; infinite or NaN where a number is not finite or a distance is beyond the
            /// range of the scalar.
            #[must_use]
            pub fn residual(&self, pairs: &[($Member, $Member)]) -> S {
                let left = |pair| {
                    let (weight, x, y) = equal_weight(pair);
                    (weight, self.alignment.$left(x, y).length())
                };
                root_mean_square(pairs.iter().map(left))
            }

            /// The same with weights: `√(Σ wᵢ |yᵢ − xᵢ'|² / Σ wᵢ)`.
            #[must_use]
            pub fn weighted_residual(&self, pairs: &[(S, $Member, $Member)]) -> S {
                let left = |pair| {
                    let (weight, x, y) = weighted(pair);
                    (weight, self.alignment.$left(x, y).length())
                };
                root_mean_square(pairs.iter().map(left))
            }
        }
    )*};
}

residuals! {
    Motor Point<S>: left_of_points;
    Similarity Point<S>: left_of_points;
    Rotor [S; 3]: left_of_directions;
}

/// `√(Σ w l² / Σ w)`, without overflow of the squares; zero where all weights are zero.
fn root_mean_square<S: Real<Mask = bool>>(lengths: impl Iterator<Item = (S, S)> + Clone) -> S {
    let zero = S::zero();
    let lengths = lengths.filter(|&(weight, _)| weight != zero);
    let largest = lengths
        .clone()
        .fold(zero, |most, (_, length)| most.max(length));
    // `max` skips NaN, which is then only in the sum.
    let unit = S::select(zero.less_than(largest), largest, S::one());
    let [sum, total] = lengths.fold([zero; 2], |[sum, total], (weight, length)| {
        let part = length / unit;
        [sum + part * part * weight, total + weight]
    });
    if total == zero {
        return zero;
    }
    (sum / total).sqrt() * unit
}

/// The sum of equal weights.
fn count<S: Real, T>(pairs: &[T]) -> Option<S> {
    Some(S::from_integer(pairs.len() as i64))
}

fn equal_weight<S: Real, T: Copy + Into<Vector<S>>>(&(x, y): &(T, T)) -> (S, Vector<S>, Vector<S>) {
    (S::one(), x.into(), y.into())
}

fn weighted<S: Real, T: Copy + Into<Vector<S>>>(
    &(weight, x, y): &(S, T, T),
) -> (S, Vector<S>, Vector<S>) {
    (weight, x.into(), y.into())
}

#[inline]
fn motor<S: Real<Mask = bool>>(
    pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)> + Clone,
    total: Option<S>,
) -> Result<Fit<Motor<S>, S>, FitError<S>> {
    let alignment = Alignment {
        factor: S::one(),
        ..Alignment::of::<1>(pairs, total)?
    };
    let motion = finite(alignment.shift()? * alignment.rotor)?;
    Ok(Fit { motion, alignment })
}

#[inline]
fn similarity<S: Real<Mask = bool>>(
    pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)> + Clone,
    total: Option<S>,
) -> Result<Fit<Similarity<S>, S>, FitError<S>> {
    let alignment = Alignment::of::<2>(pairs, total)?;
    let dilator = Dilator::from_factor(alignment.factor).ok_or(FitError::OutOfRange)?;
    let motion = finite(alignment.shift()? * alignment.rotor)? * dilator;
    Ok(Fit { motion, alignment })
}

#[inline]
fn rotor<S: Real<Mask = bool>>(
    pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)> + Clone,
    total: Option<S>,
) -> Result<Fit<Rotor<S>, S>, FitError<S>> {
    let units = pairs.clone().map(|(weight, x, y)| {
        let (x, y) = unit_pair(x, y);
        (weight, x, y)
    });
    let moments = Moments::<S, 1>::of(units, total);
    let found = moments.and_then(|moments| moments.rotation());
    let motion = match found {
        Some((rotor, _)) => rotor,
        None => rotor_of_any(pairs)?,
    };
    let alignment = Alignment {
        rotor: motion,
        factor: S::one(),
        centroids: [Vector::default(); 2],
    };
    Ok(Fit { motion, alignment })
}

#[cold]
#[inline(never)]
fn rotor_of_any<S: Real<Mask = bool>>(
    pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)>,
) -> Result<Rotor<S>, FitError<S>> {
    let mut pairs = counting(pairs, 2)?;
    for (index, pair) in &mut pairs {
        let of_length_one = |v: Vector<S>| {
            v.normalized()
                .ok_or(FitError::NoDirection { index: *index })
        };
        (pair.from, pair.to) = (of_length_one(pair.from)?, of_length_one(pair.to)?);
    }
    let pairs: Vec<_> = pairs.into_iter().map(|(_, pair)| pair).collect();
    let sides = Sides::measured(&pairs, [S::one(); 2])?;
    fixed_rotation(&pairs, sides)
}

/// Two directions with length 1; NaN where one has none, so that the sums over them are NaN too.
#[inline]
fn unit_pair<S: Real<Mask = bool>>(x: Vector<S>, y: Vector<S>) -> (Vector<S>, Vector<S>) {
    let none = S::zero() / S::zero();
    let unit = |v: Vector<S>| v.normalized().unwrap_or(Vector::new(none, none, none));
    (unit(x), unit(y))
}

/// The best rotation and scale factor between points relative to their centroids.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Alignment<S> {
    rotor: Rotor<S>,
    factor: S,
    centroids: [Vector<S>; 2],
}

impl<S: Real<Mask = bool>> Alignment<S> {
    #[inline]
    fn of<const N: usize>(
        pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)> + Clone,
        total: Option<S>,
    ) -> Result<Self, FitError<S>> {
        match Self::by_moments::<N>(pairs.clone(), total) {
            Some(found) => Ok(found),
            None => Self::centred(pairs),
        }
    }

    #[cold]
    #[inline(never)]
    fn centred(
        pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)>,
    ) -> Result<Self, FitError<S>> {
        let centred = Centred::from(pairs)?;
        let rotor = fixed_rotation(&centred.pairs, centred.sides)?;
        Ok(Self {
            rotor,
            factor: centred.factor(rotor),
            centroids: centred.centroids,
        })
    }

    /// In one pass, relative to the first pair, where that is accurate.
    #[inline]
    fn by_moments<const N: usize>(
        pairs: impl Iterator<Item = (S, Vector<S>, Vector<S>)> + Clone,
        total: Option<S>,
    ) -> Option<Self> {
        let (_, x0, y0) = pairs.clone().next()?;
        let about_first = pairs.map(|(weight, x, y)| (weight, x - x0, y - y0));
        let moments = Moments::<S, N>::of(about_first, total)?;
        let (rotor, factor) = moments.about_means()?.rotation()?;
        let [x, y] = moments.sums.map(|sum| sum.divided(moments.total));
        Some(Self {
            rotor,
            factor,
            centroids: [x0 + x, y0 + y],
        })
    }

    /// The translation that moves the image of the first centroid to the second.
    fn shift(&self) -> Result<Translator<S>, FitError<S>> {
        let [from, to] = self.centroids;
        let displacement = to - self.image(from);
        displacement
            .is_finite()
            .then(|| Translator::from_displacement(displacement.into()))
            .ok_or(FitError::OutOfRange)
    }

    /// The rotated and scaled vector.
    fn image(&self, vector: Vector<S>) -> Vector<S> {
        self.rotor
            .transform(Point::from(vector * self.factor))
            .into()
    }

    /// What is left of the second of two points, relative to the centroids, which keeps digits far
    /// from the origin.
    fn left_of_points(&self, x: Vector<S>, y: Vector<S>) -> Vector<S> {
        let [from, to] = self.centroids;
        (y - to) - self.image(x - from)
    }

    fn left_of_directions(&self, x: Vector<S>, y: Vector<S>) -> Vector<S> {
        let (x, y) = unit_pair(x, y);
        y - self.image(x)
    }
}

/// Pairs of points, relative to the centroid of the first points and of the second points.
struct Centred<S> {
    pairs: Vec<Pair<S>>,
    sides: Sides<S>,
    centroids: [Vector<S>; 2],
}

impl<S: Real<Mask = bool>> Centred<S> {
    fn from(
        pairs: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)>,
    ) -> Result<Self, FitError<S>> {
        let mut pairs: Vec<_> = counting(pairs, 3)?
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
fn counting<S: Real<Mask = bool>>(
    weighted: impl ExactSizeIterator<Item = (S, Vector<S>, Vector<S>)>,
    needed: usize,
) -> Result<Vec<(usize, Pair<S>)>, FitError<S>> {
    let mut largest = S::zero();
    let mut pairs = Vec::with_capacity(weighted.len());
    for (index, (weight, from, to)) in weighted.enumerate() {
        largest = largest.max(checked(index, weight)?);
        if !(from.is_finite() && to.is_finite()) {
            return Err(FitError::PairNotFinite { index });
        }
        pairs.push((index, Pair { weight, from, to }));
    }
    if !pairs.is_empty() && !S::zero().less_than(largest) {
        return Err(FitError::ZeroWeights);
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

fn finite<S: Real<Mask = bool>>(motion: Motor<S>) -> Result<Motor<S>, FitError<S>> {
    let is_finite = super::blend::is_finite(motion);
    is_finite.then_some(motion).ok_or(FitError::OutOfRange)
}
