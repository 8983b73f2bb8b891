//! Declarations mean the same wherever they stand: under any names, and in any crate.

mod embedding;
mod shadowing;
