//! From programs to the graph: operands become inputs, products become sums of products.

mod choice;
mod inner;
mod join;
mod linear_map;
mod null_image;
mod null_pair;
mod operand;
mod program;
mod projection;
mod reflection;
mod sandwich;
mod scaled_split;
pub mod split;

pub use choice::{Choice, Choices, Rule};
pub use inner::InnerRule;
pub use join::JoinRule;
pub use operand::operand;
pub use program::{Lowered, lower};
pub use projection::ProjectionRule;
pub use sandwich::SandwichRule;
