//! Where a primitive is during a search: a frame at a point of it, and its curvature.

use crate::cga3::{Direction, Motor, MotorGenerator, Point, Rotor, Translator};
use crate::scalar::Real;
use crate::vga3::Vector;

/// A motor that takes the primitive in its standard position to its place, and its curvature.
///
/// In the standard position a round primitive passes through the origin, where its normal is the
/// third axis, and its centre is on that axis, at `1/κ`. So it has a place for every curvature κ,
/// also for zero and below, where it is flat or its centre is on the other side. The second axis is
/// the axis of a cylinder, the normal of a circle's plane, and the direction of a line, which
/// passes through the origin itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place<S> {
    pub(super) motor: Motor<S>,
    pub(super) curvature: S,
}

/// A change of a place: the angular and the linear velocity in its frame, and that of the
/// curvature.
pub(super) struct Step<S> {
    pub(super) angular: [S; 3],
    pub(super) linear: [S; 3],
    pub(super) curvature: S,
}

impl<S: Real<Mask = bool>> Place<S> {
    /// The place of a frame with a given origin, second and third axis, which are orthonormal.
    pub(super) fn new(
        origin: Vector<S>,
        second: Vector<S>,
        third: Vector<S>,
        curvature: S,
    ) -> Option<Self> {
        let columns = [second.cross(third), second, third].map(Vector::coordinates);
        let rows = [0, 1, 2].map(|row| columns.map(|axis| axis[row]));
        let motor = Translator::from_displacement(origin.into()) * Rotor::from_matrix(rows)?;
        Some(Self { motor, curvature })
    }

    /// The place of the round `A x² + B·x + C = 0`, which is a dual sphere with its centre in the
    /// plane of B or of `fallback`, seen from the point of it nearest to the origin. `second` is
    /// perpendicular to B, or `None` for any axis. `None` where there are no real points.
    pub(super) fn of_round(
        [a, c]: [S; 2],
        b: Vector<S>,
        second: Option<Vector<S>>,
    ) -> Option<Self> {
        let square = b.length_squared() - a * c * S::from_integer(4);
        if !S::zero().less_than(square) {
            return None;
        }
        let length = square.sqrt();
        let length = if a.less_than(S::zero()) {
            -length
        } else {
            length
        };
        let (a, b, c) = (a / length, b.divided(length), c / length);
        // Where the origin is the centre, all points are equally near.
        let slope = b.length();
        let third = if S::epsilon().less_than(slope) {
            -b.divided(slope)
        } else {
            let axis = second.unwrap_or(Vector::new(S::zero(), S::zero(), S::one()));
            axis.orthonormal_pair()[0]
        };
        let second = match second {
            Some(axis) => axis,
            None => third.orthonormal_pair()[0],
        };
        let height = (c + c) / (S::one() + slope);
        Self::new(third * height, second, third, a + a)
    }

    /// The coordinates of a point in the frame.
    #[inline]
    pub(super) fn local(to_frame: Motor<S>, place: Vector<S>) -> [S; 3] {
        to_frame.transform(Point::from(place)).coordinates()
    }

    pub(super) fn moved(self, step: &Step<S>) -> Self {
        let [angular, linear] = [step.angular, step.linear].map(Direction::from);
        let motion = MotorGenerator::from_velocities(angular, linear).exp();
        Self {
            motor: self.motor * motion,
            curvature: self.curvature + step.curvature,
        }
    }

    pub(super) fn origin(self) -> Vector<S> {
        self.motor.translator().displacement().into()
    }

    pub(super) fn axes(self) -> [Vector<S>; 3] {
        let rows = self.motor.rotor().to_matrix();
        [0, 1, 2].map(|axis| Vector::from(rows.map(|row| row[axis])))
    }

    /// The same place seen from a centroid c and with a unit of length u, where `x = c + u x'`.
    pub(super) fn seen_from(self, centroid: Vector<S>, unit: S) -> Self {
        let origin = (self.origin() - centroid).divided(unit);
        self.at(origin, self.curvature * unit)
    }

    fn at(self, origin: Vector<S>, curvature: S) -> Self {
        let motor = Translator::from_displacement(origin.into()) * self.motor.rotor();
        Self { motor, curvature }
    }

    /// The place outside of a centroid and unit; the inverse of [`seen_from`](Self::seen_from).
    pub(super) fn outside(self, centroid: Vector<S>, unit: S) -> Self {
        self.at(centroid + self.origin() * unit, self.curvature / unit)
    }

    /// The same primitive with a curvature that is not negative.
    pub(super) fn facing_centre(self) -> Self {
        if self.curvature.less_than(S::zero()) {
            let turned = self.half_turn([S::zero(), S::one(), S::zero()]);
            return Self {
                curvature: -self.curvature,
                ..turned
            };
        }
        self
    }

    /// The same with an axis of the frame reversed, and another one, where the component of largest
    /// magnitude of the first one is negative.
    pub(super) fn oriented(self, axis: usize, about: usize) -> Self {
        let direction = self.axes()[axis].coordinates();
        let largest = direction.into_iter().fold(S::zero(), |most, x| {
            if most.abs().less_than(x.abs()) {
                x
            } else {
                most
            }
        });
        if largest.less_than(S::zero()) {
            let mut unit = [S::zero(); 3];
            unit[about] = S::one();
            return self.half_turn(unit);
        }
        self
    }

    /// Rotated by 180° about an axis of the frame.
    fn half_turn(self, [x, y, z]: [S; 3]) -> Self {
        // The rotor of a half turn is a unit bivector, the product of two unit vectors.
        let rotor = Rotor::new_unchecked(S::zero(), -z, y, -x);
        Self {
            motor: self.motor * rotor,
            ..self
        }
    }
}
