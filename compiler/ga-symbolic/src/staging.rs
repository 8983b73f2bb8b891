//! Whether a kernel gets cheaper with its uniform coefficients collected.
//!
//! Collecting makes nearly the same graph of whatever the rules lowered, so that few rules need to
//! be tried: those that were found without it, and the plain ones for actions of versors.

use crate::order::Order as _;
use rustc_hash::FxHashSet;

use crate::kernel::Kernel;
use crate::lower::{Choice, Choices, SandwichRule};
use crate::task::{Staged, Task};

/// How many graphs go through all passes.
const MOST: usize = 3;

/// The kernel, or a cheaper one of the task with uniform coefficients. The kernel may be that of
/// another form of the program.
pub(crate) fn staged(task: &Task<'_>, kernel: Kernel) -> Kernel {
    if !task.has_uniform() {
        return kernel;
    }
    let (each, _) = kernel.rank();
    let mut candidates: Vec<Staged> = Vec::new();
    let mut seen = FxHashSet::default();
    for choices in tried(&kernel.choices) {
        let lowered = task.lowered(&choices);
        if seen.insert(lowered.fingerprint()) {
            candidates.extend(task.staged(lowered));
        }
    }
    // The other passes save less than half of a graph's operations.
    candidates.retain(|staged| staged.price.0 < 2 * each);
    match cheapest(candidates) {
        Some(next) if next.rank() < kernel.rank() => next,
        _ => kernel,
    }
}

/// The kernel of the cheapest graph.
pub(crate) fn cheapest(mut candidates: Vec<Staged>) -> Option<Kernel> {
    candidates.order_by_key(|staged| staged.price);
    // Equal prices are nearly always those of equal graphs.
    candidates.dedup_by_key(|staged| staged.price);
    let kernels = candidates.into_iter().take(MOST).map(Staged::kernel);
    kernels.min_by_key(Kernel::rank)
}

/// The rules that were found, and plain ones.
fn tried(found: &Choices) -> Vec<Choices> {
    let all = Choice {
        staged: true,
        ..found.all
    };
    // The steps with rules of their own are those of the form that was found.
    let sites = match found.forms.is_empty() {
        true => found.sites.clone(),
        false => Vec::new(),
    };
    let mut tried = vec![Choices {
        sites,
        ..all.into()
    }];
    for sandwich in [
        SandwichRule::LeftFirst,
        SandwichRule::UnitCommutator,
        SandwichRule::LinearMap,
    ] {
        for rederive in [found.all.rederive, false] {
            let choices = Choices::from(Choice {
                sandwich,
                rederive,
                ..all
            });
            if !tried.contains(&choices) {
                tried.push(choices);
            }
        }
    }
    tried
}
