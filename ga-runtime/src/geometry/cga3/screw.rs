//! Rigid motions as screws: an axis, an angle about it and a displacement along it.

use super::logarithm::length_and_direction;
use crate::cga3::{Line, Motor, MotorGenerator, Point};
use crate::geometry::number::{are_numbers, is_number};
use crate::scalar::Real;
use crate::vga3::Vector;

/// A rigid motion as a screw: a rotation about an axis and a displacement along it, in any order.
/// Every rigid motion is a screw (Chasles, 1830).
///
/// With n the direction of the axis and `m = p × n` its moment, for any point p of the axis, the
/// generator `log M` is
///
/// ```text
/// −½ angle (n1 e23 − n2 e13 + n3 e12) − ½ (displacement n + angle m) ei
/// ```
///
/// The result of [`Motor::screw`] has an axis with a direction of length 1, an angle in [0, 2π]
/// and, for a rotation by more than zero, a displacement of either sign. Other screws may have an
/// axis of any weight and any angle.
///
/// ```
/// use ga_runtime::cga3::{Line, Point};
/// use ga_runtime::geometry::Screw;
/// // A quarter turn about the vertical axis through (1, 0, 0), and three units up.
/// let screw = Screw {
///     axis: Line::from_point_direction(Point::new(1.0, 0.0, 0.0), [0.0, 0.0, 1.0]),
///     angle: std::f64::consts::FRAC_PI_2,
///     displacement: 3.0,
/// };
/// let motor = screw.to_motor().unwrap();
/// let [x, y, z] = motor.transform(Point::new(2.0, 0.0, 0.0)).coordinates();
/// assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && (z - 3.0).abs() < 1e-15);
/// let again = motor.screw().unwrap();
/// assert!((again.axis.support().unwrap().e1() - 1.0).abs() < 1e-15);
/// assert!((again.pitch().unwrap() - 6.0 / std::f64::consts::PI).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screw<S> {
    /// The axis. The rotation is right-handed about its direction.
    pub axis: Line<S>,
    /// The angle of the rotation in radians.
    pub angle: S,
    /// The displacement along the direction of the axis.
    pub displacement: S,
}

impl<S: Real<Mask = bool>> Screw<S> {
    /// The pitch: the displacement for each radian of the rotation, in the unit of length. `None`
    /// where there is no rotation, or the quotient is beyond the range of the scalar; some books
    /// call 2π times this the pitch.
    #[must_use]
    pub fn pitch(self) -> Option<S> {
        let pitch = self.displacement / self.angle;
        is_number(pitch).then_some(pitch)
    }

    /// The fraction t of the screw: t times the angle and t times the displacement, with the same
    /// axis.
    #[inline]
    #[must_use]
    pub fn part(self, t: S) -> Self {
        Self {
            axis: self.axis,
            angle: self.angle * t,
            displacement: self.displacement * t,
        }
    }

    /// The motor, which is the exponential of the [generator](Self::generator), from the sine and
    /// cosine of half the angle. `None` where the axis has no direction, or a number is not finite.
    #[must_use]
    pub fn to_motor(self) -> Option<Motor<S>> {
        let half = S::from_ratio(1, 2);
        let axis = self.axis.normalized()?;
        let (n, m) = (axis.direction(), axis.moment());
        let (sine, cosine) = (half * self.angle).sin_cos();
        let advance = half * self.displacement;
        let [x, y, z] = n.map(|x| x * sine);
        let [t1, t2, t3] = [0, 1, 2].map(|k| -(advance * cosine * n[k] + sine * m[k]));
        let usable = are_numbers([sine, cosine, advance]) && are_numbers([t1, t2, t3]);
        usable.then(|| Motor::new_unchecked(cosine, -z, y, -x, t1, t2, t3, advance * sine))
    }

    /// The generator of the motion. `None` as for [`to_motor`](Self::to_motor).
    #[must_use]
    pub fn generator(self) -> Option<MotorGenerator<S>> {
        let minus_half = S::from_ratio(-1, 2);
        let axis = self.axis.normalized()?;
        let (n, m) = (axis.direction(), axis.moment());
        let turn = n.map(|x| x * (minus_half * self.angle));
        let shift = [0, 1, 2].map(|k| minus_half * (self.displacement * n[k] + self.angle * m[k]));
        let usable = are_numbers(turn) && are_numbers(shift);
        usable
            .then(|| MotorGenerator::new(turn[2], -turn[1], turn[0], shift[0], shift[1], shift[2]))
    }
}

impl<S: Real<Mask = bool>> MotorGenerator<S> {
    /// The screw of the motion with this generator, or, for a velocity, its instantaneous screw:
    /// the axis, and the angle and the displacement, or their rates. The angle is not negative.
    ///
    /// Without a rotation the axis passes through the origin along the translation, with a
    /// displacement that is not negative; for zero it is the axis e3. A rotation so small that its
    /// axis is beyond the range of the scalar is ignored. `None` where a coefficient is not finite,
    /// or the result would be beyond the range of the scalar.
    #[must_use]
    pub fn screw(self) -> Option<Screw<S>> {
        let two = S::from_integer(2);
        let turn = Vector::new(-self.e23, self.e13, -self.e12) * two;
        let velocity = Vector::new(self.e1i, self.e2i, self.e3i) * -two;
        let (angle, n) = length_and_direction(turn);
        if !is_number(angle) || !velocity.is_finite() {
            return None;
        }
        let along = n.dot(velocity);
        let moment = (velocity - n * along).divided(angle);
        if let Some(axis) = Line::from_direction_moment(n.into(), moment.into()) {
            return is_number(along).then_some(Screw {
                axis,
                angle,
                displacement: along,
            });
        }
        let (length, direction) = length_and_direction(velocity);
        let upright = Vector::new(S::zero(), S::zero(), S::one());
        let direction = if S::zero().less_than(length) {
            direction
        } else {
            upright
        };
        is_number(length).then(|| Screw {
            axis: Line::from_point_direction(Point::default(), direction.into()),
            angle: S::zero(),
            displacement: length,
        })
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The screw of the motion, with an angle in [0, 2π]: that of [`log`](Self::log). A motor and
    /// its negative have the same axis with opposite directions, and angles that add to 2π.
    ///
    /// | motion | axis | angle | displacement |
    /// | --- | --- | --- | --- |
    /// | identity | e3, through the origin | 0 | 0 |
    /// | translation by t | t, through the origin | 0 | length of t |
    /// | half turn | its axis, in the direction that the sign of M gives | π | of either sign |
    /// | `−1` | −e3, through the origin | 2π | 0 |
    /// | minus a translation by t | along t, through the origin | 2π | of either sign |
    ///
    /// The error of the axis's position is the rounding of the translation perpendicular to it,
    /// divided by the sine of half the angle; so it grows as the angle approaches 0 or 2π. `None`
    /// where a coefficient is not finite, or the result would be beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let translation = Motor::from(Translator::from_displacement([0.0, 3.0, 4.0]));
    /// let screw = translation.screw().unwrap();
    /// assert_eq!((screw.angle, screw.displacement, screw.pitch()), (0.0, 5.0, None));
    /// assert_eq!(screw.axis.direction(), [0.0, 0.6, 0.8]);
    /// ```
    #[must_use]
    pub fn screw(self) -> Option<Screw<S>> {
        self.log().screw()
    }
}
