//! How a fit searches.

/// How a fit searches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseFitOptions {
    /// Whether the body may be translated as a whole. Its rotation is that of its root joints.
    pub root_motion: bool,
    /// Whether the search begins with each joint rotated, from the root on, so that its bones point
    /// to their targets. That finds poses far from the start. Without it, the search stays near a
    /// start that is near, such as the frame before.
    pub align_first: bool,
    /// The greatest number of steps.
    pub iterations: usize,
    /// The search ends with a step whose parts, in radians and in lengths of the skeleton, have no
    /// greater sum of squares than the square of this.
    pub tolerance: f64,
}

impl Default for PoseFitOptions {
    /// With root motion and alignment, 100 steps, and 1e-10.
    fn default() -> Self {
        Self {
            root_motion: true,
            align_first: true,
            iterations: 100,
            tolerance: 1e-10,
        }
    }
}
