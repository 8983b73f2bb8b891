//! Standard output as the place of a file.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether a file goes to standard output.
static IS_TAKEN: AtomicBool = AtomicBool::new(false);

/// Leaves standard output to a file: what is said about the work goes to standard error.
pub(crate) fn take() {
    IS_TAKEN.store(true, Ordering::Relaxed);
}

/// Whether standard output is that of a file.
pub(crate) fn is_taken() -> bool {
    IS_TAKEN.load(Ordering::Relaxed)
}

/// Whether a path is that of standard input or output.
pub(crate) fn is_dash(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Whether what is written to a path goes to standard output.
pub(crate) fn is_standard_output(path: &Path) -> bool {
    is_dash(path) || ga_files::is_standard_output(path)
}
