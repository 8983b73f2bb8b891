//! The motion and the similarity nearest to an affine map.

use super::affine::{Affine, NotConformal, similarity};
use super::matrix::{Matrix, symmetric_eigen};
use super::motion::moments::horn;
use crate::cga3::{EvenVersor, Motor, Odd, OddVersor, Rotor, Similarity, Translator};
use crate::geometry::number::are_numbers;
use crate::scalar::Real;

/// The versor nearest to an affine map, and how far the map is from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<V, S> {
    /// The motion or the similarity whose matrix is nearest.
    pub versor: V,
    /// The factors by which the linear part stretches along its principal axes, the largest first:
    /// its singular values. They are equal for a similarity, and 1 for a motion.
    pub stretches: [S; 3],
    /// `√Σ (L − s R)²`, the root of the sum of the squared deviations of all entries of the
    /// matrix, which are those of the linear part. Zero for a map that is the versor's.
    pub residual: S,
}

impl<S: Real<Mask = bool>> Affine<S> {
    /// The motion whose matrix is nearest in the sense of least squares of all entries: the
    /// rotation of the polar decomposition `L = R P` (Higham, Computing the polar decomposition,
    /// 1986), found as the eigenvector of Horn's matrix, and the translation as it is. For a 3×3
    /// matrix take any translation; for a 4×4 matrix see
    /// [`with_projective_part`](Self::with_projective_part).
    ///
    /// # Errors
    /// Numbers that are not finite, a linear part that reverses orientation
    /// ([`NotConformal::Mirrors`]), or one of rank below 2, to which no rotation is nearer than all
    /// others ([`NotConformal::Singular`]).
    ///
    /// ```
    /// use ga_runtime::geometry::Affine;
    /// let stretch = Affine::new([[0.0, -3.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [5.0; 3]);
    /// let nearest = stretch.nearest_motion().unwrap();
    /// let (axis, angle): ([f64; 3], f64) = nearest.versor.rotor().to_axis_angle();
    /// assert!((axis[2] - 1.0).abs() < 1e-15);
    /// assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// assert!((nearest.stretches[0] - 3.0).abs() < 1e-14);
    /// assert!((nearest.residual - 5.0_f64.sqrt()).abs() < 1e-14);
    /// ```
    pub fn nearest_motion(self) -> Result<Nearest<Motor<S>, S>, NotConformal> {
        let polar = Polar::direct(self)?;
        Ok(Nearest {
            versor: Translator::from_displacement(self.translation) * polar.rotor,
            stretches: polar.stretches,
            residual: polar.residual(S::one()),
        })
    }

    /// The similarity whose matrix is nearest in the sense of least squares of all entries: the
    /// rotation of [`nearest_motion`](Self::nearest_motion), and the mean of the stretches as the
    /// factor.
    ///
    /// # Errors
    /// Those of [`nearest_motion`](Self::nearest_motion).
    ///
    /// ```
    /// use ga_runtime::geometry::Affine;
    /// let nearest = Affine::scaling([1.0, 2.0, 3.0]).nearest_similarity().unwrap();
    /// assert!((nearest.versor.factor() - 2.0_f64).abs() < 1e-15);
    /// assert!((nearest.residual - 2.0_f64.sqrt()).abs() < 1e-15);
    /// ```
    pub fn nearest_similarity(self) -> Result<Nearest<Similarity<S>, S>, NotConformal> {
        let polar = Polar::direct(self)?;
        let factor = polar.factor();
        Ok(Nearest {
            versor: similarity(polar.rotor, factor, self.translation)?,
            stretches: polar.stretches,
            residual: polar.residual(factor),
        })
    }

    /// The opposite similarity, one that reverses orientation, whose matrix is nearest: that of
    /// [`nearest_similarity`](Self::nearest_similarity) for `−L`, after the reflection in the
    /// origin.
    ///
    /// # Errors
    /// Numbers that are not finite, a linear part that does not reverse orientation
    /// ([`NotConformal::DoesNotMirror`]), or one of rank below 2.
    ///
    /// ```
    /// use ga_runtime::{cga3::Point, geometry::Affine};
    /// let mirror = Affine::new([[1.0, 0.01, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]], [0.0; 3]);
    /// let nearest = mirror.nearest_opposite_similarity().unwrap();
    /// let image = nearest.versor.transform_point(Point::new(0.0, 0.0, 2.0)).unwrap();
    /// assert!((image.z() + 2.0_f64).abs() < 1e-4 && nearest.residual < 0.01);
    /// ```
    pub fn nearest_opposite_similarity(self) -> Result<Nearest<OddVersor<S>, S>, NotConformal> {
        let polar = Polar::of(self)?;
        if !polar.mirrors {
            return Err(NotConformal::DoesNotMirror);
        }
        let factor = polar.factor();
        let direct = similarity(polar.rotor, factor, self.translation)?;
        let central = OddVersor::normalize(Odd {
            e123: S::one(),
            ..Odd::default()
        });
        Ok(Nearest {
            versor: EvenVersor::from(direct) * central.ok_or(NotConformal::NotFinite)?,
            stretches: polar.stretches,
            residual: polar.residual(factor),
        })
    }

    /// The affine map of the first three rows of a 4×4 matrix, and what is left of the last row,
    /// both divided by the last entry: `(x', w) = M (x, 1)`. Zero is left for an affine map;
    /// otherwise a point x is also divided by `1 + r·x`.
    ///
    /// Where only an exact last row is acceptable, use
    /// [`from_homogeneous`](Self::from_homogeneous).
    ///
    /// # Errors
    /// An entry that is not finite, or a last entry by which the others cannot be divided
    /// ([`NotConformal::Projective`]), as where the origin is mapped to infinity.
    ///
    /// ```
    /// use ga_runtime::geometry::Affine;
    /// let rows = [
    ///     [2.0, 0.0, 0.0, 4.0],
    ///     [0.0, 2.0, 0.0, 6.0],
    ///     [0.0, 0.0, 2.0, 8.0],
    ///     [0.0, 0.0, 0.5, 2.0],
    /// ];
    /// let (map, rest) = Affine::with_projective_part(rows).unwrap();
    /// assert_eq!((map, rest), (Affine::from_translation([2.0, 3.0, 4.0]), [0.0, 0.0, 0.25]));
    /// ```
    pub fn with_projective_part(rows: [[S; 4]; 4]) -> Result<(Self, [S; 3]), NotConformal> {
        if !rows.into_iter().all(are_numbers) {
            return Err(NotConformal::NotFinite);
        }
        let [a, b, c, d] = rows.map(|row| row.map(|x| x / rows[3][3]));
        if ![a, b, c, d].into_iter().all(are_numbers) {
            return Err(NotConformal::Projective);
        }
        let linear = [a, b, c].map(|[x, y, z, _]| [x, y, z]);
        Ok((Self::new(linear, [a[3], b[3], c[3]]), [d[0], d[1], d[2]]))
    }
}

/// The decomposition `±L = R P`.
struct Polar<S> {
    rotor: Rotor<S>,
    stretches: [S; 3],
    mirrors: bool,
}

impl<S: Real<Mask = bool>> Polar<S> {
    fn direct(map: Affine<S>) -> Result<Self, NotConformal> {
        let polar = Self::of(map)?;
        if polar.mirrors {
            return Err(NotConformal::Mirrors);
        }
        Ok(polar)
    }

    fn of(map: Affine<S>) -> Result<Self, NotConformal> {
        if !(map.linear.into_iter().all(are_numbers) && are_numbers(map.translation)) {
            return Err(NotConformal::NotFinite);
        }
        let entries = map.linear.into_iter().flatten();
        let largest = entries.fold(S::zero(), |most, x| most.max(x.abs()));
        if !S::zero().less_than(largest) {
            return Err(NotConformal::Singular);
        }
        let unit = map.linear.map(|row| row.map(|x| x / largest));
        let rounding = S::epsilon() * S::from_integer(16);
        let determinant = Affine::new(unit, map.translation).determinant();
        let mirrors = determinant.less_than(-rounding);
        let unit = if mirrors {
            unit.map(|row| row.map(|x| -x))
        } else {
            unit
        };
        let columns: Matrix<S, 3> = core::array::from_fn(|i| unit.map(|row| row[i]));
        let [(first, [w, x, y, z]), (second, _), ..] = symmetric_eigen(horn(columns));
        if !rounding.less_than(first - second) {
            return Err(NotConformal::Singular);
        }
        let rotor = Rotor::from_quaternion([x, y, z], w).ok_or(NotConformal::Singular)?;
        let rotation = rotor.to_matrix();
        let product = |i: usize, j: usize| {
            (0..3).fold(S::zero(), |sum, k| rotation[k][i].mul_add(unit[k][j], sum))
        };
        let half = S::from_ratio(1, 2);
        let stretch: Matrix<S, 3> = core::array::from_fn(|i| {
            core::array::from_fn(|j| (product(i, j) + product(j, i)) * half)
        });
        Ok(Self {
            rotor,
            stretches: symmetric_eigen(stretch).map(|(value, _)| value * largest),
            mirrors,
        })
    }

    /// The factor s for which `Σ (L − s R)²` is least.
    fn factor(&self) -> S {
        let [a, b, c] = self.stretches;
        (a + b + c) / S::from_integer(3)
    }

    fn residual(&self, factor: S) -> S {
        let deviations = self.stretches.map(|stretch| stretch - factor);
        crate::vga3::Vector::from(deviations).length()
    }
}
