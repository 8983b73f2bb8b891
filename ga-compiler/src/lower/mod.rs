//! From expressions to the graph: operands become inputs, products become sums of products.

mod expression;
mod operand;
mod sandwich;
pub mod split;

pub use expression::lower;
pub use operand::operand;
pub use sandwich::SandwichRule;
