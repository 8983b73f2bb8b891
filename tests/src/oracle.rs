//! Coefficients that other libraries computed. Extracts are in `data`, the complete set in the
//! shared data beside the repository.

use std::path::Path;
use std::sync::OnceLock;

use nullcone_shared_data::shared;
use serde_json::Value;

/// Reads an extract from this package, by its path in `data`.
///
/// # Panics
/// If it is absent or is not JSON.
pub fn extract(path: &str) -> Value {
    read(
        &Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("data")
            .join(path),
    )
}

/// All test vectors for cga3, where the shared data lies beside the repository.
///
/// # Panics
/// If the file is not JSON, or is absent although the environment demands it.
pub fn complete() -> Option<&'static Value> {
    static COMPLETE: OnceLock<Value> = OnceLock::new();
    let path = shared("oracle/ga/cga3_seed1.json")?;
    Some(COMPLETE.get_or_init(|| read(&path)))
}

/// The complete file of an [`extract`], by its path in the shared data, where that lies beside the
/// repository.
///
/// # Panics
/// As [`complete`].
pub fn whole(path: &str) -> Option<Value> {
    shared(&format!("oracle/{path}")).map(|path| read(&path))
}

fn read(path: &Path) -> Value {
    let text =
        std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
