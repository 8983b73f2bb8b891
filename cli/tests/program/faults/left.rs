//! What is in a folder and the folders below it.

use std::collections::BTreeMap;
use std::path::Path;

/// The contents of all files by their paths.
pub(super) type Files = BTreeMap<String, Vec<u8>>;

pub(super) fn files(folder: &Path) -> Files {
    let mut all = Files::new();
    add(folder, "", &mut all);
    all
}

fn add(folder: &Path, prefix: &str, all: &mut Files) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = format!("{prefix}{}", entry.file_name().to_str().unwrap());
        match entry.file_type().unwrap().is_dir() {
            true => add(&entry.path(), &format!("{name}/"), all),
            false => {
                all.insert(name, std::fs::read(entry.path()).unwrap());
            }
        }
    }
}

/// What earlier files hold.
pub(super) const EARLIER: &[u8] = b"earlier";

/// Writes earlier files of the same paths.
pub(super) fn write_earlier(folder: &Path, files: &Files) {
    for name in files.keys() {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, EARLIER).unwrap();
    }
}
