//! The conformal map nearest to a linear map of conformal vectors.

use super::affine::NotConformal;
use super::even_versor::from_even;
use super::matrix::{Matrix, inverse, transposed};
use super::odd_versor::times_pseudoscalar;
use super::reflections::{Isometry, Versor, components, reflections_of, vector_of};
use crate::cga3::{Even, EvenVersor, OddVersor, RoundVector};
use crate::geometry::number::are_numbers;
use crate::linear::LinearMap;
use crate::scalar::Real;

/// The versor nearest to a linear map of conformal vectors, and how far the map is from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestVersor<V, S> {
    /// The versor V.
    pub versor: V,
    /// The number w by which the map multiplies vectors beside the action of V. It is of no
    /// consequence for what the vectors represent.
    pub weight: S,
    /// `√Σ (H − 1)²` over the entries of the matrix of the symmetric part H, in the frame
    /// `eo + ½ ei, eo − ½ ei, e1, e2, e3`. Zero for a map that is conformal.
    pub residual: S,
}

impl<S: Real<Mask = bool>> EvenVersor<S> {
    /// The versor nearest to a linear map of conformal vectors: the orthogonal part of its polar
    /// decomposition `f = w V(H)`, with `V(x) = V x ~V`, a positive determinant of w H, and a map H
    /// that is its own adjoint, `H(a)·b = a·H(b)` (Higham, Mackey, Mackey and Tisseur, Computing
    /// the polar decomposition and the matrix sign decomposition in matrix groups, 2004; by
    /// Newton's iteration). It does not depend on the frame. The sign of V is not determined.
    ///
    /// # Errors
    /// Numbers that are not finite; a singular map; a map that reverses orientation
    /// ([`NotConformal::Mirrors`]); or one so far from any conformal map that it has no such
    /// decomposition ([`NotConformal::Shears`]).
    ///
    /// ```
    /// use ga_runtime::cga3::{EvenVersor, RoundVector, Transversor};
    /// use ga_runtime::linear::LinearMap;
    /// let bend = EvenVersor::from(Transversor::from_vector([0.1, 0.2, 0.0]));
    /// let map = LinearMap::of(|x: RoundVector<f64>| bend.transform(x) * 3.0);
    /// let nearest = EvenVersor::nearest_to(&map).unwrap();
    /// assert!((nearest.weight - 3.0).abs() < 1e-14 && nearest.residual < 1e-14);
    /// assert!((nearest.versor.e2o() / nearest.versor.scalar() + 0.2).abs() < 1e-14);
    /// ```
    pub fn nearest_to(
        map: &LinearMap<RoundVector<S>, RoundVector<S>>,
    ) -> Result<NearestVersor<Self, S>, NotConformal> {
        let (Versor { even, is_odd }, weight, residual) = nearest(map)?;
        if is_odd {
            return Err(NotConformal::Mirrors);
        }
        Ok(NearestVersor {
            versor: from_even(even),
            weight,
            residual,
        })
    }
}

impl<S: Real<Mask = bool>> OddVersor<S> {
    /// The versor nearest to a linear map of conformal vectors that reverses orientation; see
    /// [`EvenVersor::nearest_to`].
    ///
    /// # Errors
    /// Those of [`EvenVersor::nearest_to`], with [`NotConformal::DoesNotMirror`] for a map that
    /// preserves orientation.
    ///
    /// ```
    /// use ga_runtime::cga3::{DualPlane, OddVersor, RoundVector};
    /// use ga_runtime::linear::LinearMap;
    /// let mirror = OddVersor::reflection(DualPlane::new(1.0, 0.0, 0.0, 0.5)).unwrap();
    /// let map = LinearMap::of(|x: RoundVector<f64>| mirror.transform(x) + x * 1e-6);
    /// let nearest = OddVersor::nearest_to(&map).unwrap();
    /// assert!((nearest.versor.e1().abs() - 1.0).abs() < 1e-5 && nearest.residual < 1e-5);
    /// ```
    pub fn nearest_to(
        map: &LinearMap<RoundVector<S>, RoundVector<S>>,
    ) -> Result<NearestVersor<Self, S>, NotConformal> {
        let (Versor { even, is_odd }, weight, residual) = nearest(map)?;
        if !is_odd {
            return Err(NotConformal::DoesNotMirror);
        }
        Ok(NearestVersor {
            versor: times_pseudoscalar(even),
            weight,
            residual,
        })
    }
}

/// The columns of a map are the images of the basis vectors.
struct Columns<S>([[S; 5]; 5]);

impl<S: Real<Mask = bool>> Isometry<S> for Columns<S> {
    fn change(&self, place: usize) -> [S; 5] {
        let mut change = self.0[place];
        change[place] -= S::one();
        change
    }

    fn reflected(self, mirror: [S; 5]) -> Self {
        Self(self.0.map(|column| {
            let dot = (1..5).fold(-(column[0] * mirror[0]), |sum, k| {
                column[k].mul_add(mirror[k], sum)
            });
            core::array::from_fn(|k| mirror[k].neg_mul_add(dot + dot, column[k]))
        }))
    }
}

/// The versor, the weight and the residual.
fn nearest<S: Real<Mask = bool>>(
    map: &LinearMap<RoundVector<S>, RoundVector<S>>,
) -> Result<(Versor<S>, S, S), NotConformal> {
    let columns: [[S; 5]; 5] = core::array::from_fn(|place| {
        let unit = core::array::from_fn(|k| if k == place { S::one() } else { S::zero() });
        components(map.apply(vector_of(unit)))
    });
    if !columns.into_iter().all(are_numbers) {
        return Err(NotConformal::NotFinite);
    }
    let largest = columns
        .iter()
        .flatten()
        .fold(S::zero(), |most, x| most.max(x.abs()));
    if !S::zero().less_than(largest) {
        return Err(NotConformal::Singular);
    }
    let unit = columns.map(|column| column.map(|x| x / largest));
    let determinant = LinearMap::of(|x: RoundVector<S>| map.apply(x) / largest)
        .determinant()
        .abs();
    if !S::zero().less_than(determinant) {
        return Err(NotConformal::Singular);
    }
    let size = (determinant.ln() / S::from_integer(5)).exp();
    // The direction of time is preserved; it is that of the weights of points.
    let size = if unit[0][0].less_than(S::zero()) {
        -size
    } else {
        size
    };
    let scaled = unit.map(|column| column.map(|x| x / size));
    let orthogonal = orthogonal_part(scaled)?;
    let (mirrors, _) = reflections_of(Columns(orthogonal)).ok_or(NotConformal::Shears)?;
    let one = Versor {
        even: Even {
            scalar: S::one(),
            ..Even::default()
        },
        is_odd: false,
    };
    let versor = mirrors
        .iter()
        .rev()
        .fold(one, |versor, &mirror| versor.reflected(mirror));
    // H is the adjoint of the orthogonal part times the map.
    let rows = transposed(adjoint(orthogonal));
    let mut square = S::zero();
    for (place, column) in scaled.into_iter().enumerate() {
        for (k, row) in rows.into_iter().enumerate() {
            let entry = (0..5).fold(S::zero(), |sum, m| row[m].mul_add(column[m], sum));
            let deviation = if k == place { entry - S::one() } else { entry };
            square = deviation.mul_add(deviation, square);
        }
    }
    Ok((versor, size * largest, square.sqrt()))
}

/// The limit of `X ← ½ (X + X⁻*)` with the inverse of the adjoint.
fn orthogonal_part<S: Real<Mask = bool>>(
    mut columns: Matrix<S, 5>,
) -> Result<Matrix<S, 5>, NotConformal> {
    let (half, enough) = (S::from_ratio(1, 2), S::epsilon().sqrt());
    for _ in 0..40 {
        let other = inverse(adjoint(columns)).ok_or(NotConformal::Shears)?;
        let (mut change, mut largest) = (S::zero(), S::zero());
        for (column, other) in columns.iter_mut().zip(other) {
            for (x, y) in column.iter_mut().zip(other) {
                let next = (*x + y) * half;
                change = change.max((next - *x).abs());
                largest = largest.max(next.abs());
                *x = next;
            }
        }
        if !change.is_finite() {
            return Err(NotConformal::Shears);
        }
        // The convergence is quadratic, so that this change was the last above rounding.
        if change.less_than(enough * largest) {
            return Ok(columns);
        }
    }
    Err(NotConformal::Shears)
}

/// The adjoint map: the transposed matrix, with the signs of the squares of both basis vectors.
fn adjoint<S: Real>(columns: Matrix<S, 5>) -> Matrix<S, 5> {
    core::array::from_fn(|place| {
        core::array::from_fn(|k| {
            let entry = columns[k][place];
            if (place == 0) == (k == 0) {
                entry
            } else {
                -entry
            }
        })
    })
}
