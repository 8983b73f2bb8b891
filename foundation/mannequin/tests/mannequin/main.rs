//! The person made by formulas: a closed mesh of human proportions, weights without leaks, a walk
//! without slipping feet.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod closed;
mod compressed;
mod markers;
mod skin;
mod surface;
mod walking;
mod weighting;

use std::sync::LazyLock;

use ga_mannequin::Human;

/// Made once: that takes seconds without optimisation.
static HUMAN: LazyLock<Human> = LazyLock::new(Human::new);

fn positions() -> Vec<[f64; 3]> {
    HUMAN.mesh.coordinates().collect()
}

/// The index of a joint.
fn joint(name: &str) -> usize {
    HUMAN.skeleton.index(name).unwrap()
}
