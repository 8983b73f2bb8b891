//! From expressions to the graph: operands become inputs, products become sums of products.

mod operand;
mod program;
mod sandwich;
pub mod split;

pub use operand::operand;
pub use program::lower;
pub use sandwich::SandwichRule;
