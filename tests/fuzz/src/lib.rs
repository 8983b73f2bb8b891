//! Programs of the repository as lists of tokens, and edits of them that bytes describe.

pub mod edit;
pub mod limits;
pub mod programs;
