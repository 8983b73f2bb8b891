//! The intermediate representation: a graph of scalar operations, and multivectors over it.
//!
//! An [`Arena`] holds scalar [`Node`]s, each stored once: building the same sum or product again
//! gives the same node, so that common subexpressions are shared from the start. What flows between
//! nodes is a [`Value`], a node with a constant factor; signs and constant factors move outwards
//! while a graph is built, so that `a − b` and `b − a` are the same node with factors 1 and −1.
//!
//! A [`Multivector`] is a sparse list of blades, each with its value, and the [`Facts`] known of
//! it. The compiler lowers expressions to multivectors, and from then on only the wanted values
//! count: a node that none of them reaches is never emitted.

mod arena;
mod evaluate;
mod facts;
mod fingerprint;
mod function;
mod multivector;
mod node;
mod number;
mod plucker;
mod real;
mod residue;
mod splice;
mod stand_in;

pub use arena::Arena;
pub use facts::Facts;
pub use function::{Function, Properties};
pub use multivector::Multivector;
pub use node::{Node, NodeId, Value};
pub(crate) use number::Parts;
pub use number::{Number, NumberSequence};
pub use plucker::plucker;
pub use real::Real;
pub use residue::{Residue, Residue as Prime};
pub use residue::{ResidueSequence, ResidueSequence as PrimeSequence};
pub use stand_in::Outcomes;
