//! The pieces of a curve with any number of channels, scaled to a safe range.

/// A curve as its coefficients, piece after piece and channel after channel, divided by a power of
/// two so that they are near 1.
pub(super) struct Path {
    pub(super) times: Vec<f64>,
    pub(super) dimension: usize,
    coefficients: Vec<[f64; 4]>,
    /// The values at the last key.
    last: Vec<f64>,
    /// By what the values were multiplied.
    pub(super) scale: f64,
    /// The largest coordinate of a key, before the scaling.
    pub(super) largest: f64,
}

impl Path {
    /// `coefficients` gives those of a piece and channel, and for the piece after the last one the
    /// value of the last key.
    pub(super) fn of(
        times: &[f64],
        dimension: usize,
        coefficients: impl Fn(usize, usize) -> [f64; 4],
    ) -> Self {
        let pieces = times.len() - 1;
        let (mut extent, mut largest) = (0.0_f64, 0.0_f64);
        for piece in 0..times.len() {
            let h = times.get(piece + 1).map_or(0.0, |next| next - times[piece]);
            for channel in 0..dimension {
                let [a, b, c, d] = coefficients(piece, channel);
                largest = largest.max(a.abs());
                extent = extent.max(a.abs()).max((b * h).abs());
                extent = extent.max((c * h * h).abs()).max((d * h * h * h).abs());
            }
        }
        let scale = power_of_two_below(extent).recip();
        let scaled = |piece: usize| {
            let coefficients = &coefficients;
            (0..dimension).map(move |channel| coefficients(piece, channel).map(|c| c * scale))
        };
        Self {
            times: times.to_vec(),
            dimension,
            coefficients: (0..pieces).flat_map(scaled).collect(),
            last: scaled(pieces).map(|c| c[0]).collect(),
            scale,
            largest,
        }
    }

    /// The coefficients of a piece, channel by channel.
    pub(super) fn piece(&self, index: usize) -> &[[f64; 4]] {
        &self.coefficients[index * self.dimension..][..self.dimension]
    }

    /// The piece that a time below that of the last key is in.
    pub(super) fn piece_at(&self, time: f64) -> usize {
        let after = self.times.partition_point(|&key| key <= time);
        after
            .saturating_sub(1)
            .min(self.times.len().saturating_sub(2))
    }

    /// The point at a time, rounded as [`Curve::value`](crate::curve::Curve::value) rounds it.
    pub(super) fn point_into(&self, time: f64, point: &mut [f64]) {
        if time >= self.times[self.times.len() - 1] {
            point.copy_from_slice(&self.last);
            return;
        }
        let index = self.piece_at(time);
        let s = time - self.times[index];
        for (x, [a, b, c, d]) in point.iter_mut().zip(self.piece(index)) {
            *x = ((d * s + c) * s + b) * s + a;
        }
    }

    /// The first key at which a piece does not end where the next one begins, beyond rounding.
    pub(super) fn jump(&self) -> Option<usize> {
        (1..self.times.len()).find(|&key| {
            let h = self.times[key] - self.times[key - 1];
            let next = |channel: usize| match key + 1 < self.times.len() {
                true => self.piece(key)[channel][0],
                false => self.last[channel],
            };
            self.piece(key - 1)
                .iter()
                .enumerate()
                .any(|(channel, &[a, b, c, d])| {
                    let terms = [a, b * h, c * h * h, d * h * h * h];
                    let sum: f64 = terms.iter().sum();
                    let size: f64 = terms.iter().map(|term| term.abs()).sum();
                    (sum - next(channel)).abs() > 32.0 * f64::EPSILON * (size + next(channel).abs())
                })
        })
    }
}

/// The greatest power of two that is not above a positive number, within a range whose reciprocals
/// are ordinary numbers too.
fn power_of_two_below(x: f64) -> f64 {
    let exponent = ((x.to_bits() >> 52) & 0x7ff).clamp(23, 2023);
    f64::from_bits(exponent << 52)
}
