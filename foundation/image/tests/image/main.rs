//! Tests of pictures: files of every format, filters, edges, sizes, quality.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod canny;
mod edges;
mod files;
mod films;
mod hostile;
mod oriented;
mod other_formats;
mod quality;
mod scaling;
mod stream;
mod warp;
mod white;

use std::path::PathBuf;

/// A file of this crate's test data.
fn data(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests/data", name]
        .iter()
        .collect()
}
