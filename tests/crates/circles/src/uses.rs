//! `use` declarations as lists of paths.

use syn::{ItemUse, UseTree, Visibility};

/// One name that a `use` declaration brings into a module.
#[derive(Clone, Debug)]
pub(crate) struct Import {
    /// The name in the module; none for `*`, which brings all.
    pub(crate) name: Option<String>,
    pub(crate) path: Vec<String>,
    /// Whether other modules may use the name, too.
    pub(crate) shared: bool,
}

/// What a `use` declaration brings.
pub(crate) fn imports(item: &ItemUse) -> Vec<Import> {
    let mut found = Vec::new();
    // A path that begins with `::` leads to another crate.
    if item.leading_colon.is_none() {
        let shared = !matches!(item.vis, Visibility::Inherited);
        collect(&item.tree, &mut Vec::new(), shared, &mut found);
    }
    found
}

fn collect(tree: &UseTree, prefix: &mut Vec<String>, shared: bool, found: &mut Vec<Import>) {
    let leaf = |name: Option<String>, last: &str, prefix: &[String]| {
        let mut path = prefix.to_vec();
        if last != "self" {
            path.push(last.to_owned());
        }
        let name = name.map(|name| {
            if name == "self" {
                path.last().cloned().unwrap_or(name)
            } else {
                name
            }
        });
        Import { name, path, shared }
    };
    match tree {
        UseTree::Path(path) => {
            prefix.push(path.ident.to_string());
            collect(&path.tree, prefix, shared, found);
            prefix.pop();
        }
        UseTree::Name(name) => {
            let name = name.ident.to_string();
            found.push(leaf(Some(name.clone()), &name, prefix));
        }
        UseTree::Rename(rename) => {
            let name = rename.rename.to_string();
            found.push(leaf(Some(name), &rename.ident.to_string(), prefix));
        }
        UseTree::Glob(_) => found.push(Import {
            name: None,
            path: prefix.clone(),
            shared,
        }),
        UseTree::Group(group) => {
            for part in &group.items {
                collect(part, prefix, shared, found);
            }
        }
    }
}
