//! Points on primitives, by plain arithmetic.

use nullcone_tests::plain::{Vector, along, frame, plus};
use nullcone_tests::random::SplitMix64;

/// A primitive by a point, a unit vector and a radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Figure {
    pub(crate) point: Vector,
    pub(crate) axis: Vector,
    pub(crate) radius: f64,
}

impl Figure {
    /// A figure up to a distance from the origin, of a radius between the limits.
    pub(crate) fn random(random: &mut SplitMix64, distance: f64, radii: [f64; 2]) -> Self {
        let exponent = radii[0].ln() + random.unit() * (radii[1] / radii[0]).ln();
        Self {
            point: random.vector(distance),
            axis: random.axis(),
            radius: exponent.exp(),
        }
    }

    /// The point of the sphere at an angle from the axis, and an angle about it.
    pub(crate) fn on_sphere(&self, from_axis: f64, about: f64) -> Vector {
        let height = along(self.point, self.radius * from_axis.cos(), self.axis);
        Self {
            point: height,
            radius: self.radius * from_axis.sin(),
            ..*self
        }
        .on_circle(about)
    }

    /// The point of the circle at an angle about the axis.
    pub(crate) fn on_circle(&self, about: f64) -> Vector {
        let [u, v] = frame(self.axis);
        let (sine, cosine) = about.sin_cos();
        along(
            along(self.point, self.radius * cosine, u),
            self.radius * sine,
            v,
        )
    }

    /// The point of the cylinder at an angle about the axis, and a height along it.
    pub(crate) fn on_cylinder(&self, about: f64, height: f64) -> Vector {
        along(self.on_circle(about), height, self.axis)
    }

    /// The point of the plane with these coordinates.
    pub(crate) fn on_plane(&self, x: f64, y: f64) -> Vector {
        let [u, v] = frame(self.axis);
        along(along(self.point, x, u), y, v)
    }
}

/// A number of the normal distribution of variance 1, by the method of Box and Muller.
pub(crate) fn normal(random: &mut SplitMix64) -> f64 {
    let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.unit()).cos()
}

/// A point moved by noise of a standard deviation in each coordinate.
pub(crate) fn noisy(random: &mut SplitMix64, point: Vector, deviation: f64) -> Vector {
    plus(point, std::array::from_fn(|_| deviation * normal(random)))
}
