//! From programs to the graph: operands become inputs, products become sums of products.

mod chain;
mod choice;
mod factors;
mod form_rule;
pub mod gram;
mod inner;
mod join;
mod linear_map;
pub mod meet;
pub mod null_image;
mod null_pair;
mod operand;
mod piece;
mod program;
pub mod projection;
pub mod reflection;
mod sandwich;
pub mod scaled_split;
pub mod split;

pub use choice::{Choice, Choices, Rule};
pub use form_rule::FormRule;
pub use inner::InnerRule;
pub use join::JoinRule;
pub use meet::MeetRule;
pub use operand::operand;
pub use piece::{Piece, Pieces};
pub use program::{Lowered, lower};
pub use projection::ProjectionRule;
pub use sandwich::SandwichRule;
