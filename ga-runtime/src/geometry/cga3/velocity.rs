//! Velocities of rigid motions.

use crate::cga3::{Direction, MotorGenerator, Point};
use crate::scalar::Field;

impl<S: Field> MotorGenerator<S> {
    /// The generator of a motion that rotates with the angular velocity ω, in radians per unit of
    /// time, and moves the origin with the velocity u: `−½ (ω1 e23 − ω2 e13 + ω3 e12) − ½ u ei`.
    /// The pair of both is the *twist* of robotics.
    #[inline]
    #[must_use]
    pub fn from_velocities(angular: Direction<S>, linear: Direction<S>) -> Self {
        let minus_half = S::from_ratio(-1, 2);
        let [x, y, z] = angular.vector().map(|x| x * minus_half);
        let [u, v, w] = linear.vector().map(|x| x * minus_half);
        Self::new(z, -y, x, u, v, w)
    }

    /// The angular velocity ω of the motion `exp(t G)`: the axis of the rotation, right-handed,
    /// with the angle in radians per unit of t as its length. All points have the same.
    #[inline]
    #[must_use]
    pub fn angular_velocity(self) -> Direction<S> {
        let two = S::from_integer(2);
        let axis = [-self.e23, self.e13, -self.e12];
        Direction::from_vector(axis.map(|x| x * two))
    }

    /// The velocity of a point x under the motion `exp(t G)`, in units of length per unit of t:
    /// `ω × x + u`, where u is the velocity of the origin.
    ///
    /// In blades the conformal point moves with `Ẋ = d/dt (exp(t G) X exp(−t G)) = G X − X G`,
    /// twice the [commutator](Self::commutator) product, which is `v + (x·v) ei`; the result is
    /// `Ẋ∧ei`.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, Line, Point};
    /// use ga_runtime::geometry::Screw;
    /// // Two radians per second about the vertical axis through (1, 0, 0), three metres per second
    /// // up.
    /// let axis = Line::from_point_direction(Point::new(1.0, 0.0, 0.0), [0.0, 0.0, 1.0]);
    /// let rates = Screw { axis, angle: 2.0, displacement: 3.0 };
    /// let generator = rates.generator().unwrap();
    /// let velocity = generator.velocity_at(Point::new(1.5, 0.0, 7.0));
    /// assert_eq!(velocity, Direction::new(0.0, 1.0, 3.0));
    /// assert_eq!(generator.angular_velocity(), Direction::new(0.0, 0.0, 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn velocity_at(self, point: Point<S>) -> Direction<S> {
        let two = S::from_integer(2);
        let [x, y, z] = point.coordinates();
        let velocity = [
            self.e12 * y + self.e13 * z - self.e1i,
            self.e23 * z - self.e12 * x - self.e2i,
            -(self.e13 * x) - self.e23 * y - self.e3i,
        ];
        Direction::from_vector(velocity.map(|v| v * two))
    }
}
