//! Files beside the glTF file.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::super::problem::Problem;

/// The first `limit` bytes of a file.
pub(super) fn read_file(path: &Path, limit: u64) -> Result<Vec<u8>, Problem> {
    let read = || -> io::Result<Vec<u8>> {
        let file = File::open(path)?;
        if !file.metadata()?.is_file() {
            return Err(io::ErrorKind::InvalidInput.into());
        }
        let mut bytes = Vec::new();
        file.take(limit).read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    read().map_err(|error| {
        let (path, kind) = (path.to_path_buf(), error.kind());
        Problem::Io { path, kind }
    })
}
