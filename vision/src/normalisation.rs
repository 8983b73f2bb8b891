//! Similarities that bring pixels near the origin, so that systems of equations are
//! well-conditioned.

/// The similarity that takes the centroid of places to the origin and makes their root mean square
/// distance from it √2 (R. Hartley, "In defense of the eight-point algorithm", IEEE Transactions on
/// Pattern Analysis and Machine Intelligence 19, 1997).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Normalisation {
    /// The centroid.
    pub(crate) centre: [f64; 2],
    /// The factor of all distances.
    pub(crate) scale: f64,
}

impl Normalisation {
    /// `None` where all places are the same, or one is not finite.
    pub(crate) fn new(places: impl ExactSizeIterator<Item = [f64; 2]> + Clone) -> Option<Self> {
        let count = places.len() as f64;
        let sum = |axis: usize| places.clone().map(|place| place[axis]).sum::<f64>();
        let centre = [sum(0) / count, sum(1) / count];
        let squares = places.map(|[x, y]| (x - centre[0]).powi(2) + (y - centre[1]).powi(2));
        let scale = (2.0 * count / squares.sum::<f64>()).sqrt();
        let numbers = [scale, scale * centre[0], scale * centre[1]];
        let is_finite = numbers.iter().all(|x| x.is_finite());
        is_finite.then_some(Self { centre, scale })
    }

    pub(crate) fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v] = self.centre;
        [(x - u) * self.scale, (y - v) * self.scale]
    }
}
