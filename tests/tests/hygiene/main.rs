//! Hygiene: declarations mean the same under any names and in any crate.

mod embedding;
mod shadowing;
