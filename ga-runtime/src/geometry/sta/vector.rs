//! Vectors of spacetime: events, velocities, momenta.

use super::velocity::{NotSlowerThanLight, lorentz_factor};
use crate::geometry::number::{are_numbers, is_number};
use crate::scalar::{Real, Ring};
use crate::sta::Vector;
use crate::vga3;

impl<S: Ring> Vector<S> {
    /// The event with a time and a position in the frame of the observer g0:
    /// `t g0 + x g1 + y g2 + z g3`.
    #[inline]
    #[must_use]
    pub fn from_time_place(time: S, [x, y, z]: [S; 3]) -> Self {
        Self::new(time, x, y, z)
    }

    /// The time, the coefficient of g0.
    #[inline]
    #[must_use]
    pub fn time(self) -> S {
        self.g0
    }

    /// The position, the coefficients of g1, g2, g3: those of the relative vector `x∧g0`.
    #[inline]
    #[must_use]
    pub fn place(self) -> [S; 3] {
        [self.g1, self.g2, self.g3]
    }

    /// The squared interval `x² = t² − r²`: positive for timelike vectors, zero on the light cone,
    /// negative for spacelike ones.
    ///
    /// ```
    /// use ga_runtime::sta::Vector;
    /// let event = Vector::from_time_place(5.0, [0.0, 3.0, 0.0]);
    /// assert_eq!(event.interval_squared(), 16.0);
    /// assert_eq!(event.interval_squared(), event | event);
    /// ```
    #[inline]
    #[must_use]
    pub fn interval_squared(self) -> S {
        self.g0 * self.g0 - vga3::Vector::from(self.place()).length_squared()
    }
}

impl<S: Real<Mask = bool>> Vector<S> {
    /// The proper time that passes along a timelike vector, for a clock that moves uniformly,
    /// `√(t² − r²)`; negative for a vector to the past. `None` for spacelike vectors, and where a
    /// number is not finite.
    ///
    /// Computed from `(|t| − r)(|t| + r)`, which is accurate close to the light cone.
    ///
    /// ```
    /// use ga_runtime::sta::Vector;
    /// assert_eq!(Vector::from_time_place(5.0, [3.0, 0.0, 0.0]).proper_time(), Some(4.0));
    /// assert_eq!(Vector::from_time_place(1.0, [3.0, 0.0, 0.0]).proper_time(), None);
    /// ```
    #[must_use]
    pub fn proper_time(self) -> Option<S> {
        let (time, distance) = (self.time().abs(), vga3::Vector::from(self.place()).length());
        if time.less_than(distance) || !time.is_finite() || !distance.is_finite() {
            return None;
        }
        let proper = root_of_difference(time, distance);
        let proper = if self.time().less_than(S::zero()) {
            -proper
        } else {
            proper
        };
        Some(proper)
    }

    /// The proper length of a spacelike vector, in the frame in which its ends are simultaneous,
    /// `√(r² − t²)`. `None` for timelike vectors, and where a number is not finite.
    #[must_use]
    pub fn proper_distance(self) -> Option<S> {
        let (time, distance) = (self.time().abs(), vga3::Vector::from(self.place()).length());
        if distance.less_than(time) || !time.is_finite() || !distance.is_finite() {
            return None;
        }
        Some(root_of_difference(distance, time))
    }

    /// The velocity `r/t` in the frame of the observer g0, of size 1 for light; `None` for a vector
    /// that is neither timelike nor lightlike, or is not finite.
    #[must_use]
    pub fn velocity(self) -> Option<[S; 3]> {
        let (time, distance) = (self.time(), vga3::Vector::from(self.place()).length());
        if time.abs().less_than(distance) || !time.is_finite() {
            return None;
        }
        let velocity = self.place().map(|x| x / time);
        are_numbers(velocity).then_some(velocity)
    }

    /// The proper velocity `γ (g0 + v)` of a body with velocity v: a vector with square 1.
    ///
    /// # Errors
    ///
    /// [`NotSlowerThanLight`] where |v| is not below 1, or is NaN.
    ///
    /// ```
    /// use ga_runtime::sta::Vector;
    /// let u = Vector::from_velocity([0.6_f64, 0.0, 0.0]).unwrap();
    /// assert!((u.g0 - 1.25).abs() < 1e-15 && (u.g1 - 0.75).abs() < 1e-15);
    /// assert!(Vector::from_velocity([1.0, 0.0, 0.0]).is_err());
    /// ```
    pub fn from_velocity(velocity: [S; 3]) -> Result<Self, NotSlowerThanLight<S>> {
        let gamma = lorentz_factor(velocity).ok_or(NotSlowerThanLight { velocity })?;
        Ok(Self::from_time_place(gamma, velocity.map(|v| v * gamma)))
    }

    /// The mass of a momentum `E g0 + p`, `√(E² − p²)`: the same as
    /// [`proper_time`](Self::proper_time) of an event.
    #[must_use]
    pub fn mass(self) -> Option<S> {
        self.proper_time()
    }

    /// The rapidity, `artanh |v|`; `None` for a vector that is not timelike.
    #[must_use]
    pub fn rapidity(self) -> Option<S> {
        let (time, distance) = (self.time().abs(), vga3::Vector::from(self.place()).length());
        let proper = self.proper_time()?.abs();
        if !S::zero().less_than(proper) {
            return None;
        }
        // artanh v = ln((t + r)/√(t² − r²)), computed by arsinh for small r.
        let sine = distance / proper;
        let cosine = time / proper;
        let rapidity = super::complex::arsinh(sine, cosine);
        is_number(rapidity).then_some(rapidity)
    }
}

/// `√(a² − b²)` for a ≥ b ≥ 0, without intermediate overflow or underflow.
fn root_of_difference<S: Real<Mask = bool>>(a: S, b: S) -> S {
    if !S::zero().less_than(a) {
        return S::zero();
    }
    let ratio = b / a;
    a * ((a - b) / a * (S::one() + ratio)).sqrt()
}
