//! Lorentz transformations as matrices: of spacetime, and of spinors.

use core::fmt::{Display, Formatter, Result as FormatResult};

use super::complex::Complex;
use crate::cga3;
use crate::geometry::number::are_numbers;
use crate::scalar::{Real, Ring};
use crate::sta::{Rotor, Vector};
use crate::vga3;

impl<S: Ring> Rotor<S> {
    /// The matrix of the transformation by rows, for vectors `[t, x, y, z]`: `x' = matrix · x`.
    #[must_use]
    pub fn to_matrix(self) -> [[S; 4]; 4] {
        let columns = [0, 1, 2, 3].map(|axis| {
            let mut unit = [S::zero(); 4];
            unit[axis] = S::one();
            let [t, x, y, z] = unit;
            let image = self.transform(Vector::new(t, x, y, z));
            [image.g0, image.g1, image.g2, image.g3]
        });
        [0, 1, 2, 3].map(|row| columns.map(|column| column[row]))
    }

    /// The complex 2×2 matrix of the rotor, an element of SL(2, ℂ), by rows, each entry as
    /// `[real part, imaginary part]`: products of rotors correspond to products of matrices in the
    /// same order.
    ///
    /// The relative vectors σ1, σ2, σ3 become the Pauli matrices and I the imaginary unit. A vector
    /// `t g0 + x g1 + y g2 + z g3` times g0 becomes the Hermitian matrix
    /// `X = [t + z, x − i y; x + i y, t − z]`, whose determinant is the squared interval, and the
    /// transformation becomes `X' = A X A†`.
    ///
    /// ```
    /// use ga_runtime::sta::Rotor;
    /// let boost = Rotor::from_rapidity([0.0, 0.0, 1.0], 2.0).unwrap();
    /// let [[a, b], [c, d]] = boost.to_sl2c();
    /// let e = 1.0_f64.exp();
    /// assert!((a[0] - e).abs() < 1e-14 && (d[0] - 1.0 / e).abs() < 1e-14);
    /// assert_eq!((b, c), ([0.0, 0.0], [0.0, 0.0]));
    /// ```
    #[must_use]
    pub fn to_sl2c(self) -> [[[S; 2]; 2]; 2] {
        let (s, p) = (self.scalar(), self.g0123());
        [
            [
                [s + self.g30(), p + self.g21()],
                [self.g10() + self.g13(), self.g32() - self.g20()],
            ],
            [
                [self.g10() - self.g13(), self.g32() + self.g20()],
                [s - self.g30(), p - self.g21()],
            ],
        ]
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotor of a Lorentz transformation, from its matrix by rows for vectors `[t, x, y, z]`:
    /// the one of the two, R and −R, whose rotation is by at most π. It is found as a boost, whose
    /// velocity is in the first column, after a rotation.
    ///
    /// The entries of the matrix are as large as the Lorentz factor γ, the first of them, so that
    /// they determine the rotation only up to errors of about ε γ.
    ///
    /// # Errors
    /// [`NotLorentz`] where an entry is not finite, where the matrix does not preserve intervals
    /// within √ε, or where it reverses time or space. A matrix with γ above some `1/√ε` has lost
    /// its rotation by rounding and is not accepted either.
    ///
    /// ```
    /// use ga_runtime::geometry::NotLorentz;
    /// use ga_runtime::sta::Rotor;
    /// let rotor = Rotor::from_velocity([0.6, 0.0, 0.0]).unwrap()
    ///     * Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.0).unwrap();
    /// let again: Rotor<f64> = Rotor::from_matrix(rotor.to_matrix()).unwrap();
    /// assert!((again.g10() - rotor.g10()).abs() < 1e-15);
    /// let mut matrix = rotor.to_matrix();
    /// matrix[1] = matrix[1].map(|x| -x);
    /// assert_eq!(Rotor::from_matrix(matrix), Err(NotLorentz::ReversesSpace));
    /// ```
    pub fn from_matrix(rows: [[S; 4]; 4]) -> Result<Self, NotLorentz> {
        if !rows.into_iter().all(are_numbers) {
            return Err(NotLorentz::NotFinite);
        }
        if let Some(rotor) = proper(rows) {
            return Ok(rotor);
        }
        let with_signs = |time: S, space: S| {
            rows.map(|[t, x, y, z]| [t * time, x * space, y * space, z * space])
        };
        let (one, minus) = (S::one(), -S::one());
        Err(if proper(with_signs(one, minus)).is_some() {
            NotLorentz::ReversesSpace
        } else if [one, minus]
            .into_iter()
            .any(|space| proper(with_signs(minus, space)).is_some())
        {
            NotLorentz::ReversesTime
        } else {
            NotLorentz::ChangesIntervals
        })
    }

    /// The rotor of a complex 2×2 matrix of determinant 1, by rows, each entry as
    /// `[real part, imaginary part]`; see [`to_sl2c`](Self::to_sl2c). A determinant that differs
    /// from 1 by more than rounding is divided out: the matrix is divided by its square root.
    ///
    /// # Errors
    /// [`NotLorentz::NotFinite`] where an entry or the determinant is not finite, and
    /// [`NotLorentz::Determinant`] where the determinant differs from 1 by √ε or more, relative to
    /// the size of its two products where that is above 1, or by ½ or more.
    ///
    /// ```
    /// use ga_runtime::geometry::NotLorentz;
    /// use ga_runtime::sta::Rotor;
    /// let (zero, one, two) = ([0.0, 0.0], [1.0, 0.0], [2.0, 0.0]);
    /// assert_eq!(Rotor::from_sl2c([[one, zero], [zero, one]]), Ok(Rotor::default()));
    /// assert_eq!(Rotor::from_sl2c([[two, zero], [zero, one]]), Err(NotLorentz::Determinant));
    /// ```
    pub fn from_sl2c(rows: [[[S; 2]; 2]; 2]) -> Result<Self, NotLorentz> {
        let [[a, b], [c, d]] = rows.map(|row| row.map(|[re, im]| Complex::new(re, im)));
        let one = Complex::new(S::one(), S::zero());
        let (ad, bc) = (a.times(d), b.times(c));
        let determinant = ad.plus(bc.negative());
        if !(rows.into_iter().flatten().all(are_numbers)
            && are_numbers([determinant.real, determinant.imaginary]))
        {
            return Err(NotLorentz::NotFinite);
        }
        let off = determinant.plus(one.negative()).modulus();
        let size = ad.modulus().max(bc.modulus()).max(S::one());
        let half = S::from_ratio(1, 2);
        if !off.less_than(half.min(S::epsilon().sqrt() * size)) {
            return Err(NotLorentz::Determinant);
        }
        // The determinant of a rotor's own matrix differs from 1 by this much, which to divide by
        // would only add to the errors.
        let largest = [a, b, c, d]
            .map(Complex::modulus)
            .into_iter()
            .fold(S::one(), S::max);
        let is_one = off.less_than(S::from_integer(8) * S::epsilon() * largest * largest);
        let root = if is_one { one } else { determinant.root() };
        let [a, b, c, d] = [a, b, c, d].map(|entry| entry.divided_by(root));
        let mean = |x: S, y: S| half * (x + y);
        Ok(Self::new_unchecked(
            mean(a.real, d.real),
            mean(b.real, c.real),
            mean(c.imaginary, -b.imaginary),
            mean(a.real, -d.real),
            mean(b.imaginary, c.imaginary),
            mean(b.real, -c.real),
            mean(a.imaginary, -d.imaginary),
            mean(a.imaginary, d.imaginary),
        ))
    }
}

/// The rotor whose matrix is the given one within √ε.
fn proper<S: Real<Mask = bool>>(rows: [[S; 4]; 4]) -> Option<Rotor<S>> {
    let column = |k: usize| vga3::Vector::new(rows[1][k], rows[2][k], rows[3][k]);
    // The first column is the proper velocity γ (1, v) of what was at rest.
    let (gamma, proper_velocity) = (rows[0][0], column(0));
    if !S::zero().less_than(gamma) {
        return None;
    }
    let (one, half) = (S::one(), S::from_ratio(1, 2));
    // With L the boost by v, the columns of the rotation ~L Λ are x − (1 − 1/γ) v v·x/v².
    let share = (gamma * (one + gamma)).recip();
    let rotated = [1, 2, 3].map(|k| {
        let x = column(k);
        x - proper_velocity * (proper_velocity.dot(x) * share)
    });
    let rotation = [0, 1, 2].map(|row| rotated.map(|x| x[row]));
    let (vector, scalar) = cga3::Rotor::from_matrix(rotation)?.to_quaternion();
    let cosh = ((gamma + one) * half).sqrt();
    let sinh = proper_velocity * (half / cosh);
    let rotor = Rotor::boost(cosh, sinh.into()) * Rotor::rotation(scalar, vector.map(|x| -x));
    let largest = |rows: [[S; 4]; 4]| {
        let entries = rows.into_iter().flatten();
        entries.fold(S::zero(), |largest, x| largest.max(x.abs()))
    };
    let again = rotor.to_matrix();
    let off = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| again[i][j] - rows[i][j]));
    largest(off)
        .less_than(S::epsilon().sqrt() * largest(rows))
        .then_some(rotor)
}

/// Why a matrix is not that of a rotor: not a proper Lorentz transformation that keeps the
/// direction of time, or not in SL(2, ℂ).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotLorentz {
    /// An entry is infinite or not a number.
    NotFinite,
    /// The matrix does not preserve intervals.
    ChangesIntervals,
    /// It is a Lorentz transformation that exchanges future and past.
    ReversesTime,
    /// It is a Lorentz transformation that keeps the direction of time and mirrors space.
    ReversesSpace,
    /// The determinant of a spinor matrix is not 1.
    Determinant,
}

impl Display for NotLorentz {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        f.write_str(match self {
            Self::NotFinite => "an entry of the matrix is not finite",
            Self::ChangesIntervals => "the matrix does not preserve intervals",
            Self::ReversesTime => "the transformation exchanges future and past",
            Self::ReversesSpace => "the transformation mirrors space",
            Self::Determinant => "the determinant of the spinor matrix is not 1",
        })
    }
}

impl core::error::Error for NotLorentz {}
