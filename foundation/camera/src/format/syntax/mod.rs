//! The syntaxes of files: what each gives are named values with their lines.

pub(super) mod json;
mod lines;
pub(super) mod toml;
pub(super) mod xml;
pub(super) mod yaml;
