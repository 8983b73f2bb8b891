//! How snakes move.

/// How a snake moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SnakeOptions {
    /// α: how strongly the curve contracts, in square pixels.
    pub tension: f64,
    /// β: how strongly the curve resists bending, in fourth powers of a pixel.
    pub rigidity: f64,
    /// The snake has settled when no point moves farther than this in two steps, in pixels.
    pub tolerance: f64,
    /// The greatest distance that a point moves in a step, in pixels.
    pub greatest_move: f64,
    /// The greatest number of steps.
    pub steps: usize,
    /// After so many steps each, the points are placed at equal distances along the curve, if the
    /// energy does not rise by that.
    pub resampled_every: Option<usize>,
}

impl Default for SnakeOptions {
    /// α = 0.5, β = 50, at most 2500 steps of at most 8 pixels until none is above 0.01 pixels,
    /// without resampling.
    fn default() -> Self {
        Self {
            tension: 0.5,
            rigidity: 50.0,
            tolerance: 0.01,
            greatest_move: 8.0,
            steps: 2500,
            resampled_every: None,
        }
    }
}
