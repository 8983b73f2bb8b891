//! The proven distance between a chord and the part of a curve that it replaces.

use serde::Serialize;

use super::path::Path;

/// Which distance between a curve and the polyline through its vertices is bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Distance {
    /// From each point of the curve to the nearest point of the chord that replaces it. The curve
    /// is a path in space, and times do not matter.
    Geometric,
    /// From the curve at a time to the polyline at the same time, which goes at constant speed from
    /// vertex to vertex. It is never less than the geometric distance.
    EqualTime,
}

/// Half the distance from 1 to the next number: the relative error of one operation.
const UNIT: f64 = 0.5 * f64::EPSILON;
/// A chord is cut into parts of this share of its duration.
const PARTS: f64 = 16.0;

/// Measures chords of one path. The vectors have a component for each channel.
pub(super) struct Chords<'a> {
    path: &'a Path,
    distance: Distance,
    from: Vec<f64>,
    to: Vec<f64>,
    along: Vec<f64>,
    /// The square of the chord's length, or 0 where it is too short to have a direction.
    square: f64,
    /// The part of a piece that is being measured, by powers of the time since its beginning.
    local: Vec<[f64; 4]>,
}

/// What is known of the curve at one time.
#[derive(Clone, Copy)]
struct Sample {
    /// The distance to the chord's line, or to the point of the chord at the same time.
    distance: f64,
    /// The foot on the line, from 0 at the beginning of the chord to 1 at its end, and its
    /// velocity.
    foot: [f64; 2],
    /// The size of c″, or of its part across the chord.
    bend: f64,
}

impl<'a> Chords<'a> {
    pub(super) fn new(path: &'a Path, distance: Distance) -> Self {
        let zeros = vec![0.0; path.dimension];
        Self {
            path,
            distance,
            from: zeros.clone(),
            to: zeros.clone(),
            along: zeros,
            square: 0.0,
            local: vec![[0.0; 4]; path.dimension],
        }
    }

    /// An upper bound of the distance between the curve from `a` to `b` and the chord, in scaled
    /// units.
    pub(super) fn deviation(&mut self, a: f64, b: f64) -> f64 {
        let path = self.path;
        path.point_into(a, &mut self.from);
        path.point_into(b, &mut self.to);
        self.square = 0.0;
        for ((d, to), from) in self.along.iter_mut().zip(&self.to).zip(&self.from) {
            *d = to - from;
            self.square += *d * *d;
        }
        if self.square < 1e-200 {
            self.square = 0.0;
        }
        let mut largest = 0.0_f64;
        let mut index = path.piece_at(a);
        while index + 1 < path.times.len() && path.times[index] < b {
            let bound = self.piece_bound(index, a, b);
            if !bound.is_finite() {
                return f64::INFINITY;
            }
            largest = largest.max(bound);
            index += 1;
        }
        // Sums of squares and roots.
        largest * (1.0 + (path.dimension as f64 + 16.0) * 2.0 * f64::EPSILON)
    }

    fn piece_bound(&mut self, index: usize, a: f64, b: f64) -> f64 {
        let (start, end) = (self.path.times[index], self.path.times[index + 1]);
        let s0 = (a - start).max(0.0);
        let width = if b < end { b - start } else { end - start } - s0;
        if width <= 0.0 {
            return 0.0;
        }
        let rounding = self.localise(index, s0, width);
        let before = if s0 > 0.0 { 0.0 } else { start - a };
        let count = (PARTS * (width / (b - a))).ceil().clamp(1.0, PARTS);
        let step = width / count;
        let mut largest = 0.0_f64;
        let rounding_of_foot = (16.0 + self.path.dimension as f64) * UNIT;
        let mut first = self.sample(0.0, before / (b - a));
        for part in 1..=count as usize {
            let s = if part as f64 == count {
                width
            } else {
                step * part as f64
            };
            let second = self.sample(s, (before + s) / (b - a));
            let between = Between {
                first,
                second,
                step,
                rounding: rounding_of_foot,
            };
            let bound = match self.distance {
                Distance::Geometric => between.to_segment(self.square.sqrt()),
                Distance::EqualTime => between.to_line(),
            };
            // `max` would drop what is not a number.
            largest = if bound > largest || bound.is_nan() {
                bound
            } else {
                largest
            };
            first = second;
        }
        largest + rounding
    }

    /// Expands a piece about the time `s0` since its key, relative to the beginning of the chord,
    /// and bounds what rounding does to the distances over the next `width`.
    fn localise(&mut self, index: usize, s0: f64, width: f64) -> f64 {
        let mut squares = 0.0;
        let channels = self
            .path
            .piece(index)
            .iter()
            .zip(&self.from)
            .zip(&self.along);
        for (local, ((&[a, b, c, d], from), along)) in self.local.iter_mut().zip(channels) {
            let (origin, error) = if s0 > 0.0 {
                // The chord begins here: what remains is the error of Horner's rule.
                let terms = [a, 3.0 * b * s0, 5.0 * c * s0 * s0, 6.0 * d * s0 * s0 * s0];
                (
                    0.0,
                    1.01 * UNIT * terms.iter().map(|term| term.abs()).sum::<f64>(),
                )
            } else {
                (a - from, UNIT * (a - from).abs())
            };
            *local = [
                origin,
                b + s0 * (2.0 * c + 3.0 * d * s0),
                c + 3.0 * d * s0,
                d,
            ];
            let [b, c, d] = [b, c, d].map(f64::abs);
            let size = (b + s0 * (2.0 * c + 3.0 * d * s0)) * width
                + (c + 3.0 * d * s0) * width * width
                + d * width * width * width;
            let sum = error + UNIT * (8.0 * size + 4.0 * along.abs() + 2.0 * origin.abs());
            squares += sum * sum;
        }
        1.01 * squares.sqrt()
    }

    /// The curve at the time `s` since the beginning of the local expansion, where the polyline is
    /// at the place `at_time` of the chord at the same time.
    fn sample(&self, s: f64, at_time: f64) -> Sample {
        let offset = |c: &[f64; 4]| ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
        let velocity = |c: &[f64; 4]| (3.0 * c[3] * s + 2.0 * c[2]) * s + c[1];
        let bend = |c: &[f64; 4]| 6.0 * c[3] * s + 2.0 * c[2];
        let is_geometric = self.distance == Distance::Geometric && self.square > 0.0;
        let share = |dot: f64| if is_geometric { dot / self.square } else { 0.0 };
        let foot = share(self.dot(offset));
        let place = match self.distance {
            Distance::Geometric => foot,
            Distance::EqualTime => at_time,
        };
        let bend_along = share(self.dot(bend));
        let (mut distance, mut across, mut whole) = (0.0, 0.0, 0.0);
        for (c, &d) in self.local.iter().zip(&self.along) {
            distance += (offset(c) - place * d).powi(2);
            across += (bend(c) - bend_along * d).powi(2);
            whole += bend(c).powi(2);
        }
        Sample {
            distance: distance.sqrt(),
            foot: [foot, share(self.dot(velocity))],
            // Rounding of the difference is a share of the whole.
            bend: across.sqrt() + 16.0 * UNIT * whole.sqrt(),
        }
    }

    /// The inner product of a vector of the local expansion and the chord.
    fn dot(&self, vector: impl Fn(&[f64; 4]) -> f64) -> f64 {
        self.local
            .iter()
            .zip(&self.along)
            .map(|(c, d)| vector(c) * d)
            .sum()
    }
}

/// A part of a piece between two samples.
struct Between {
    first: Sample,
    second: Sample,
    step: f64,
    /// The relative error of the foot.
    rounding: f64,
}

impl Between {
    /// The distance to the chord's line, or at equal times: between the samples it is at most the
    /// larger one and Δ²/8 · max |c″|.
    fn to_line(&self) -> f64 {
        let bulge = (self.step * self.larger(|sample| sample.bend)) * self.step / 8.0;
        self.larger(|sample| sample.distance) + bulge
    }

    /// The distance to a chord of this length. The foot on its line is a cubic polynomial of time,
    /// and lies between the least and the largest of its four Bézier coefficients. How far these
    /// are beyond the ends of the chord counts too.
    fn to_segment(&self, length: f64) -> f64 {
        let third = self.step / 3.0;
        let ([from, leaving], [to, arriving]) = (self.first.foot, self.second.foot);
        let inner = [from + third * leaving, to - third * arriving];
        let [low, high] = [
            from.min(to).min(inner[0]).min(inner[1]),
            from.max(to).max(inner[0]).max(inner[1]),
        ];
        let beyond = (-low).max(high - 1.0).max(0.0);
        let rounding = self.rounding * (1.0 + low.abs().max(high.abs()));
        self.to_line().hypot((beyond + rounding) * length)
    }

    fn larger(&self, size: impl Fn(&Sample) -> f64) -> f64 {
        let [a, b] = [size(&self.first), size(&self.second)];
        if a > b || a.is_nan() { a } else { b }
    }
}
