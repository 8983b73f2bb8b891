//! Velocities in the frame of an observer, below the speed of light, which is 1.

use core::fmt::{Display, Formatter, Result as FormatResult};

use crate::scalar::Real;
use crate::vga3::Vector;

/// The error for a velocity that is not below the speed of light: of size 1 or more, or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotSlowerThanLight<S> {
    /// The velocity.
    pub velocity: [S; 3],
}

impl<S: Display> Display for NotSlowerThanLight<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        let [x, y, z] = &self.velocity;
        write!(
            f,
            "the velocity [{x}, {y}, {z}] is not slower than light, which has velocity 1"
        )
    }
}

impl<S: core::fmt::Debug + Display> core::error::Error for NotSlowerThanLight<S> {}

/// The relativistic sum of velocities, `(u + v_∥ + v_⊥/γ(u)) / (1 + u·v)`: the velocity, in the
/// frame of the observer, of a body that has the velocity v in a frame that moves at the velocity
/// u. It is also the velocity of the boost by u after the boost by v; in the other order the size
/// is the same and the direction is different. A result that would round to the speed of light or
/// above is returned a few ε below it.
///
/// # Errors
///
/// [`NotSlowerThanLight`] with the velocity whose size is not below 1.
///
/// ```
/// use ga_runtime::geometry::velocity_sum;
/// let [x, _, _] = velocity_sum([0.5_f64, 0.0, 0.0], [0.5, 0.0, 0.0]).unwrap();
/// assert!((x - 0.8).abs() < 1e-15);
/// assert!(velocity_sum([0.5, 0.0, 0.0], [0.0, 1.0, 0.0]).is_err());
/// ```
pub fn velocity_sum<S: Real<Mask = bool>>(
    u: [S; 3],
    v: [S; 3],
) -> Result<[S; 3], NotSlowerThanLight<S>> {
    let gamma = lorentz_factor(u).ok_or(NotSlowerThanLight { velocity: u })?;
    lorentz_factor(v).ok_or(NotSlowerThanLight { velocity: v })?;
    // v_∥ + v_⊥/γ = v/γ + (1 − 1/γ) v_∥, and (1 − 1/γ)/u² = γ/(1 + γ).
    let (u, v) = (Vector::from(u), Vector::from(v));
    let along = u.dot(v);
    let share = S::one() + gamma / (S::one() + gamma) * along;
    let total = u * share + v.divided(gamma);
    let sum = total.divided(S::one() + along);
    if lorentz_factor(sum.into()).is_some() {
        return Ok(sum.into());
    }
    // The exact sum is below the speed of light; only rounding has raised it that far.
    let scale = (S::one() - S::epsilon() * S::from_integer(4)) / sum.length();
    Ok((sum * scale).into())
}

/// The velocity, in a frame that moves at the velocity u, of a body that has the velocity v in the
/// frame of the observer: the [`velocity_sum`] of −u and v.
///
/// # Errors
///
/// [`NotSlowerThanLight`] with the velocity whose size is not below 1.
///
/// ```
/// use ga_runtime::geometry::relative_velocity;
/// let [x, _, _] = relative_velocity([0.5_f64, 0.0, 0.0], [0.8, 0.0, 0.0]).unwrap();
/// assert!((x - 0.5).abs() < 1e-15);
/// ```
pub fn relative_velocity<S: Real<Mask = bool>>(
    u: [S; 3],
    v: [S; 3],
) -> Result<[S; 3], NotSlowerThanLight<S>> {
    match velocity_sum(u.map(|x| -x), v) {
        Err(_) if lorentz_factor(u).is_none() => Err(NotSlowerThanLight { velocity: u }),
        other => other,
    }
}

/// γ = 1/√(1 − v²); `None` where |v| is not below 1.
pub(super) fn lorentz_factor<S: Real<Mask = bool>>(velocity: [S; 3]) -> Option<S> {
    let speed = Vector::from(velocity).length();
    let rest = (S::one() - speed) * (S::one() + speed);
    S::zero().less_than(rest).then(|| rest.sqrt().recip())
}
