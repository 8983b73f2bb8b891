//! No crate of the workspace has circles of source files.

use std::fs;
use std::path::{Path, PathBuf};

use nullcone_circles::circles;

/// The folders of the repository in which crates lie side by side, and the repository itself.
const FOLDERS: [&str; 4] = ["", "compiler", "foundation", "tests/crates"];

fn crates() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let mut crates = Vec::new();
    for folder in FOLDERS {
        for entry in fs::read_dir(root.join(folder)).expect("the folder can be read") {
            let path = entry.expect("the entry can be read").path();
            if path.join("Cargo.toml").exists() && path.join("src").exists() {
                crates.push(path);
            }
        }
    }
    crates.sort();
    crates
}

#[test]
fn no_crate_has_circles_of_files() {
    let crates = crates();
    assert!(
        crates.len() > 20,
        "only these crates were found: {crates:?}"
    );

    let mut report = String::new();
    let mut count = 0;
    for path in crates {
        for circle in circles(&path.join("src")).expect("the crate can be read") {
            count += 1;
            let name = path.file_name().unwrap_or_default().display();
            report += &format!("\nfiles of {name} in a circle:\n{circle}");
        }
    }
    assert!(count == 0, "{count} circles of source files\n{report}");
}
