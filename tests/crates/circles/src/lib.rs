//! Circles of source files: files of one crate that use each other's items, directly or through
//! other files.
//!
//! [`circles`] reads the `src` folder of a crate. File A uses file B where code of A names an item
//! that is defined in B. Names are followed through `use` and `pub use` to their definitions, so a
//! `mod.rs` that re-exports what lies in its children does not use them by that. Neither `mod`
//! items nor code for tests alone count.
//!
//! Names that no path shows are not seen: methods, fields, and what macros write. What is called as
//! `Type::function` counts as a use of the file that defines the type.

mod attributes;
mod components;
mod error;
mod references;
mod scope;
mod tree;
mod uses;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};

pub use error::Error;

use tree::Tree;

/// Files that use each other, and the names by which they do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Circle {
    /// For each pair of files, by their paths from the folder `src`, what the first uses of the
    /// second.
    pub uses: BTreeMap<(PathBuf, PathBuf), BTreeSet<String>>,
}

impl fmt::Display for Circle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for ((user, used), names) in &self.uses {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let (user, used) = (user.display(), used.display());
            writeln!(f, "  {user} uses of {used}: {}", names.join(", "))?;
        }
        Ok(())
    }
}

/// The circles among the files of the crate whose code lies in the folder `src`: of its library and
/// of its program, where it has both.
///
/// # Errors
///
/// [`Error`], if a file cannot be read or parsed, or the file of a module is absent.
pub fn circles(src: &Path) -> Result<Vec<Circle>, Error> {
    let mut found = Vec::new();
    for root in ["lib.rs", "main.rs"] {
        let root = src.join(root);
        if root.exists() {
            found.extend(circles_below(src, &root)?);
        }
    }
    Ok(found)
}

fn circles_below(src: &Path, root: &Path) -> Result<Vec<Circle>, Error> {
    let tree = Tree::read(root)?;
    let uses = references::between_files(&tree);
    let mut used = vec![Vec::new(); tree.files.len()];
    for &(a, b) in uses.keys() {
        used[a].push(b);
    }

    let shown = |file: usize| {
        let path = &tree.files[file];
        path.strip_prefix(src).unwrap_or(path).to_path_buf()
    };
    let circle = |files: Vec<usize>| {
        let inside = uses
            .iter()
            .filter(|((a, b), _)| files.contains(a) && files.contains(b))
            .map(|(&(a, b), names)| ((shown(a), shown(b)), names.clone()));
        Circle {
            uses: inside.collect(),
        }
    };
    let components = components::strongly_connected(&used);
    Ok(components
        .into_iter()
        .filter(|files| files.len() > 1)
        .map(circle)
        .collect())
}
