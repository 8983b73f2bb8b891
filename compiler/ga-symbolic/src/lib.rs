//! The symbolic part of Nullcone's compiler: from programs over an algebra to optimised graphs.
//!
//! Nothing here reads or writes Rust. So this crate needs no parser, and is built while `syn` is.
//! The crate `ga-compiler` makes programs from tokens and code from graphs.
//!
//! ```text
//! define → program ─→ forms → lower → passes → kernel
//!             └── member, verify ────────┘
//! ```
//!
//! Each module uses only those that stand before it in this list:
//!
//! - [`algebra`]: blades, metric, and the products of basis blades.
//! - [`ir`]: the graph, hash-consed, and multivectors over it.
//! - [`expression`]: formulas as trees, for what the compiler itself writes.
//! - [`define`]: a checked declaration as plain data; [`signature`]: the operands and the result of
//!   a function.
//! - [`member`]: the members of a type over the prime field; [`verify`] shows it to users.
//! - [`limit`]: what the search for the cheapest graph leaves out.
//! - [`program`]: the steps of a function, on whole multivectors; [`literals`]: long numbers in it
//!   as operands.
//! - [`forms`]: equivalent forms of a program.
//! - [`lower`]: steps to the graph, by named rules.
//! - [`passes`]: rewriting of graphs, order, stages, cost.
//! - [`kernel`]: one compiled graph; [`task`]: what is to be compiled; [`search`]: the form and the
//!   rules that make the cheapest graph; `staging`: whether to collect uniform coefficients;
//!   `stepwise`: programs operation by operation.
//! - `order`: one stable sort for lists of all types.

pub mod algebra;
pub mod define;
pub mod expression;
pub mod forms;
pub mod ir;
pub mod kernel;
pub mod limit;
pub mod literals;
pub mod lower;
pub mod member;
mod order;
pub mod passes;
pub mod program;
pub mod search;
pub mod signature;
mod staging;
mod stepwise;
pub mod task;
pub mod typed;
pub mod verify;
