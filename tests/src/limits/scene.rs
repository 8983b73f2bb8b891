//! Scenes of one size at one distance, and the measuring of what is found in them.

use ga_runtime::cga3::{Point, PointPair};
use ga_runtime::scalar::Real;

use crate::plain::{Vector, dot, largest, length, minus, plus, times};
use crate::random::SplitMix64;
use crate::twofold::Twofold;

/// A precision, with the largest distance at which rounds of some millimetres are measured.
pub trait Precision: Real<Mask = bool> + Into<f64> {
    /// `f32` or `f64`.
    const NAME: &'static str;
    /// The largest distance from the origin.
    const FARTHEST: f64;
}

impl Precision for f32 {
    const NAME: &'static str = "f32";
    const FARTHEST: f64 = 1e4;
}

impl Precision for f64 {
    const NAME: &'static str = "f64";
    const FARTHEST: f64 = 1e8;
}

/// The sizes that are measured: from two millimetres to forty metres.
pub const SIZES: [f64; 2] = [2e-3, 40.0];

/// A vector from the place of a scene, in twofold precision.
pub(super) type Offset = [Twofold; 3];

/// What lies about a place, in the scalar's precision.
pub(super) struct Scene<S> {
    pub(super) place: Vector,
    pub(super) distance: f64,
    pub(super) size: S,
    pub(super) numbers: SplitMix64,
}

impl<S: Precision> Scene<S> {
    pub(super) fn new(distance: f64, size: f64, seed: u64) -> Self {
        let mut numbers = SplitMix64(seed);
        let place = times(numbers.axis(), distance).map(|x| S::from_f64(x).into());
        Self {
            place,
            distance: length(place),
            size: S::from_f64(size),
            numbers,
        }
    }

    pub(super) fn size(&self) -> f64 {
        self.size.into()
    }

    pub(super) fn at(&self, offset: Vector) -> Point<S> {
        Point::from(plus(self.place, offset).map(S::from_f64))
    }

    pub(super) fn offset(&self, point: Point<S>) -> Offset {
        let coordinates = point.coordinates().map(Into::into);
        std::array::from_fn(|k| Twofold::sum(coordinates[k], -self.place[k]))
    }

    /// Points at the distance of the size from the place, with their offsets.
    pub(super) fn points<const N: usize>(&mut self) -> ([Point<S>; N], [Offset; N]) {
        let directions = [(); N].map(|()| self.numbers.axis());
        let points = directions.map(|direction| self.at(times(direction, self.size())));
        (points, points.map(|point| self.offset(point)))
    }

    /// A number that differs from 1 by some ε, by a tenth or by anything between.
    pub(super) fn nearly_one(&mut self) -> f64 {
        let power = self.numbers.unit() * S::epsilon().into().log10();
        let difference = 0.1 * 10_f64.powf(power);
        if self.numbers.unit() < 0.5 {
            1.0 + difference
        } else {
            1.0 - difference
        }
    }

    /// Whether positions so far away can express this size.
    pub(super) fn resolves(&self, size: f64) -> bool {
        size >= 64.0 * S::epsilon().into() * self.distance
    }

    /// How far a point that was found lies from the offset expected.
    pub(super) fn away(&self, found: Option<Point<S>>, expected: Offset) -> f64 {
        found.map_or(f64::INFINITY, |point| {
            norm(minus(self.offset(point), expected)).rounded()
        })
    }

    /// How far the ends of a pair lie from the offsets expected, in either order.
    pub(super) fn ends_away(&self, pair: PointPair<S>, [p, q]: [Offset; 2]) -> f64 {
        let Some([a, b]) = pair.endpoints() else {
            return f64::INFINITY;
        };
        let away = |p, q| largest([self.away(Some(a), p), self.away(Some(b), q)]);
        away(p, q).min(away(q, p))
    }

    /// An error, where positions so far away can express the size, and the length ε times of which
    /// it is compared with.
    pub(super) fn measured(&self, error: f64, condition: f64) -> Measured {
        let unit = self.distance + self.size() * condition;
        self.resolves(self.size()).then_some((error, unit))
    }

    /// The same for the figure through some points, of which the height can be expressed too.
    pub(super) fn measured_of_points(&self, error: f64, condition: f64) -> Measured {
        let is_flat = !self.resolves(self.size() / condition / 32.0);
        self.measured(error, condition).filter(|_| !is_flat)
    }
}

/// An error, and the length ε times of which it is compared with.
pub(super) type Measured = Option<(f64, f64)>;

/// The difference of a number that was found and the number expected.
pub(super) fn off<S: Precision>(found: Option<S>, expected: Twofold) -> f64 {
    found.map_or(f64::INFINITY, |found| {
        (exact(found) - expected).rounded().abs()
    })
}

pub(super) fn exact<S: Precision>(number: S) -> Twofold {
    Twofold::from(number.into())
}

pub(super) fn norm(vector: Offset) -> Twofold {
    dot(vector, vector).sqrt()
}

pub(super) fn unit_of(vector: Offset) -> Offset {
    let norm = norm(vector);
    vector.map(|x| x / norm)
}
