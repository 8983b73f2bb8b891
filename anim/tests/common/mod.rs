//! What the tests share: big data beside the project, and comparison with a bound.

use std::path::PathBuf;

/// A file beside the project, too big to be part of it, or `None` with a message when it is not
/// there.
pub(crate) fn shared(path: &str) -> Option<PathBuf> {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../shared")
        .join(path);
    if !file.exists() {
        println!("passed over: {path} is not in ../shared");
        return None;
    }
    Some(file)
}

/// Fails unless `found` is within `bound` of `expected`, relative to the greater of |`expected`|
/// and 1.
#[track_caller]
#[allow(dead_code, reason = "not every test file compares numbers")]
pub(crate) fn assert_relative(found: f64, expected: f64, bound: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(
        error <= bound,
        "{found} instead of {expected}: relative error {error:e}"
    );
}
