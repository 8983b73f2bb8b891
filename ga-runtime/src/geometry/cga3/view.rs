//! The frame of a camera or an eye that looks at a point.

use core::fmt::{Display, Formatter, Result as FormatResult};

use crate::cga3::{Direction, Motor, Point, Rotor, Translator};
use crate::scalar::Real;
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> Motor<S> {
    /// The motor from the world into the frame of an eye that looks at a target: the view
    /// transformation. [`reverse`](Self::reverse) gives the pose of the eye, the motor from its
    /// frame into the world.
    ///
    /// The frame is right-handed, with x to the right, y up and z backwards: the eye is at its
    /// origin and looks along −z, as in OpenGL. The picture's y axis is as close to `up` as the
    /// viewing direction allows. For a frame with x to the right, y down and z forwards, as is
    /// usual in computer vision, follow it by the half turn about the x axis,
    /// `Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0) * Motor::look_at(…)?`.
    ///
    /// # Errors
    /// As for [`Rotor::look_along`]; [`LookAtError::NoDirection`] where the two points coincide.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, Motor, Point};
    /// let (eye, target) = (Point::new(0.0, 0.0, 5.0), Point::new(0.0, 0.0, 0.0));
    /// let view = Motor::look_at(eye, target, Direction::new(0.0, 1.0, 0.0)).unwrap();
    /// assert_eq!(view.transform(eye), Point::new(0.0, 0.0, 0.0));
    /// // The target is in front of the eye, at a depth of 5.
    /// assert_eq!(view.transform(target), Point::new(0.0, 0.0, -5.0));
    /// assert_eq!(view.transform(Point::new(1.0, 2.0, 0.0)), Point::new(1.0, 2.0, -5.0));
    /// ```
    pub fn look_at(eye: Point<S>, target: Point<S>, up: Direction<S>) -> Result<Self, LookAtError> {
        let rotor = Rotor::look_along(eye.to(target), up)?;
        let place = -Vector::from(eye);
        if !place.is_finite() {
            return Err(LookAtError::NotFinite);
        }
        Ok(rotor * Translator::from_displacement(place.coordinates()))
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation from the world's axes to those of an eye that looks along a direction f: the
    /// rotation of [`Motor::look_at`]. It takes f to −z, and `up`, without its part along f, to +y.
    ///
    /// Its matrix has the rows `r = f × up / |f × up|`, `r × f/|f|` and `−f/|f|`.
    ///
    /// # Errors
    /// [`LookAtError`] where a number is not finite, a direction is zero, or `up` is along the
    /// viewing direction: where the sine of their angle is at most √ε.
    pub fn look_along(forward: Direction<S>, up: Direction<S>) -> Result<Self, LookAtError> {
        let (forward, up) = (Vector::from(forward), Vector::from(up));
        if !(forward.is_finite() && up.is_finite()) {
            return Err(LookAtError::NotFinite);
        }
        let forward = forward.normalized().ok_or(LookAtError::NoDirection)?;
        let up = up.normalized().ok_or(LookAtError::UpIsZero)?;
        let across = forward.cross(up);
        let right = across
            .normalized()
            .filter(|_| S::epsilon().sqrt().less_than(across.length()))
            .ok_or(LookAtError::UpAlongView)?;
        let rows = [right, right.cross(forward), -forward].map(Vector::coordinates);
        Self::from_matrix(rows).ok_or(LookAtError::NotFinite)
    }
}

/// Why an eye, a target and an upward direction do not define a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LookAtError {
    /// A coordinate, or the difference of two, is infinite or not a number.
    NotFinite,
    /// The viewing direction is zero: the target is at the eye.
    NoDirection,
    /// The upward direction is zero.
    UpIsZero,
    /// The upward direction is parallel to the viewing direction.
    UpAlongView,
}

impl Display for LookAtError {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        f.write_str(match self {
            Self::NotFinite => {
                "a coordinate of the eye, the target or the upward direction is not finite"
            }
            Self::NoDirection => "the viewing direction is zero",
            Self::UpIsZero => "the upward direction is zero",
            Self::UpAlongView => "the upward direction is parallel to the viewing direction",
        })
    }
}

impl core::error::Error for LookAtError {}
