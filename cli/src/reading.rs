//! How the program reads files of meshes and motions: the option `--strict`.

use std::sync::atomic::{AtomicBool, Ordering};

use ga_files::Reading;

static IS_STRICT: AtomicBool = AtomicBool::new(false);

/// Makes deviations from formats errors.
pub(crate) fn be_strict() {
    IS_STRICT.store(true, Ordering::Relaxed);
}

/// What becomes of deviations from formats.
pub(crate) fn reading() -> Reading {
    match IS_STRICT.load(Ordering::Relaxed) {
        true => Reading::Strict,
        false => Reading::Tolerant,
    }
}
