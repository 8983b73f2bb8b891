//! Public items of the crates, found in the sources by the paths under which users know them.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use syn::{Attribute, ImplItem, Item, ItemMod, Meta, TraitItem, Type, UseTree, Visibility};

/// More re-exports than any path goes through, so that two modules that export each other end.
const MOST_HOPS: usize = 24;

/// The files of the crates, each parsed once.
pub(crate) struct Sources {
    crates: HashMap<String, PathBuf>,
    parsed: RefCell<HashMap<PathBuf, Rc<Vec<Item>>>>,
}

/// A module: its file, where the files of modules within it are, and its items.
#[derive(Clone)]
struct Module {
    file: PathBuf,
    folder: PathBuf,
    items: Rc<Vec<Item>>,
    /// The types that a macro declares, where the module is the expansion of one.
    declared: Vec<String>,
}

/// What a path leads to.
enum Found {
    Module(Vec<String>),
    Item { file: PathBuf, name: String },
}

impl Sources {
    /// Those of the crates in these folders.
    pub(crate) fn new(folders: &[PathBuf]) -> Self {
        let name = |folder: &PathBuf| {
            let manifest = fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest");
            let line = manifest.lines().find(|line| line.starts_with("name = "));
            let name = line.and_then(|line| line.split('"').nth(1));
            name.expect("a name").replace('-', "_")
        };
        let crates = folders.iter().map(|folder| (name(folder), folder.clone()));
        Self {
            crates: crates.collect(),
            parsed: RefCell::default(),
        }
    }

    /// The files that define the public item of a path such as `ga_anim::curve::Curve`: that of the
    /// item itself, and for a path that ends in a method, a variant or a field, those of `files` in
    /// which the type has it.
    pub(crate) fn defining(&self, path: &str, files: &[PathBuf]) -> Vec<PathBuf> {
        let words: Vec<String> = path.split("::").map(str::to_owned).collect();
        if let Some(Found::Item { file, .. }) = self.resolve(&words, true, 0) {
            return vec![file];
        }
        let Some((part, owner)) = words.split_last() else {
            return Vec::new();
        };
        let Some(Found::Item { name, .. }) = self.resolve(owner, true, 0) else {
            return Vec::new();
        };
        let has = |file: &&PathBuf| has_part(&self.items(file), &name, part);
        files.iter().filter(has).cloned().collect()
    }

    fn items(&self, file: &Path) -> Rc<Vec<Item>> {
        let parse = || {
            let text = fs::read_to_string(file);
            let text = text.unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            let parsed = syn::parse_file(&text);
            Rc::new(
                parsed
                    .unwrap_or_else(|error| panic!("{}: {error}", file.display()))
                    .items,
            )
        };
        let mut all = self.parsed.borrow_mut();
        Rc::clone(all.entry(file.to_owned()).or_insert_with(parse))
    }

    /// What a path from a crate on leads to, over public items alone or also over those that the
    /// crate has for itself.
    fn resolve(&self, words: &[String], is_public: bool, hops: usize) -> Option<Found> {
        let (first, rest) = words.split_first()?;
        self.crates.get(first)?;
        let mut at = vec![first.clone()];
        for (index, word) in rest.iter().enumerate() {
            match self.find(&at, word, is_public, hops)? {
                Found::Module(module) => at = module,
                item if index + 1 == rest.len() => return Some(item),
                Found::Item { .. } => return None,
            }
        }
        Some(Found::Module(at))
    }

    /// A name in a module: one of its items, or what it has from elsewhere.
    fn find(&self, at: &[String], word: &str, is_public: bool, hops: usize) -> Option<Found> {
        if hops > MOST_HOPS {
            return None;
        }
        let module = self.module(at)?;
        if module.declared.iter().any(|name| name == word) {
            return Some(Found::Item {
                file: module.file,
                name: word.to_owned(),
            });
        }
        let is_seen =
            |visibility: &Visibility| !is_public || matches!(visibility, Visibility::Public(_));
        let inner = || Found::Module(at.iter().cloned().chain([word.to_owned()]).collect());
        for item in module.items.iter() {
            match item {
                Item::Mod(inside) if inside.ident == word && is_seen(&inside.vis) => {
                    return Some(inner());
                }
                Item::Macro(call) if declared(&call.mac).is_some_and(|(name, _)| name == word) => {
                    return Some(inner());
                }
                item if named(item).is_some_and(|(name, vis)| name == word && is_seen(vis)) => {
                    let (file, name) = (module.file, word.to_owned());
                    return Some(Found::Item { file, name });
                }
                _ => {}
            }
        }
        let imports = module.items.iter().filter_map(|item| match item {
            Item::Use(import) if is_seen(&import.vis) => Some(&import.tree),
            _ => None,
        });
        imports
            .into_iter()
            .find_map(|tree| self.imported(tree, at, Vec::new(), word, hops + 1))
    }

    /// What `word` stands for because of an import.
    fn imported(
        &self,
        tree: &UseTree,
        at: &[String],
        mut before: Vec<String>,
        word: &str,
        hops: usize,
    ) -> Option<Found> {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.imported(&path.tree, at, before, word, hops)
            }
            UseTree::Group(group) => {
                let mut parts = group.items.iter();
                parts.find_map(|part| self.imported(part, at, before.clone(), word, hops))
            }
            UseTree::Name(name) if name.ident == word => {
                before.push(word.to_owned());
                self.resolve(&self.absolute(at, before)?, false, hops)
            }
            UseTree::Rename(renamed) if renamed.rename == word => {
                before.push(renamed.ident.to_string());
                self.resolve(&self.absolute(at, before)?, false, hops)
            }
            UseTree::Glob(_) => match self.resolve(&self.absolute(at, before)?, false, hops)? {
                Found::Module(module) => self.find(&module, word, true, hops),
                Found::Item { .. } => None,
            },
            _ => None,
        }
    }

    /// The path of an import in a module, from the crate on.
    fn absolute(&self, at: &[String], words: Vec<String>) -> Option<Vec<String>> {
        let (first, rest) = words.split_first()?;
        let base = match first.as_str() {
            "crate" => at[..1].to_vec(),
            "self" => at.to_vec(),
            "super" => at[..at.len() - 1].to_vec(),
            name if self.crates.contains_key(name) => vec![name.to_owned()],
            name => at.iter().cloned().chain([name.to_owned()]).collect(),
        };
        Some(base.into_iter().chain(rest.iter().cloned()).collect())
    }

    /// The module of a path, whoever sees it.
    fn module(&self, words: &[String]) -> Option<Module> {
        let (first, rest) = words.split_first()?;
        let folder = self.crates.get(first)?.join("src");
        let file = folder.join("lib.rs");
        let mut module = Module {
            items: self.items(&file),
            file,
            folder,
            declared: Vec::new(),
        };
        for word in rest {
            module = self.inner(&module, word)?;
        }
        Some(module)
    }

    fn inner(&self, outer: &Module, word: &str) -> Option<Module> {
        outer.items.iter().find_map(|item| match item {
            // Modules within a file are of tests and of documentation alone.
            Item::Mod(inside) if inside.ident == word && inside.content.is_none() => {
                Some(self.entered(outer, inside))
            }
            Item::Macro(call) => {
                let (_, declared) = declared(&call.mac).filter(|(name, _)| name == word)?;
                Some(Module {
                    items: Rc::default(),
                    declared,
                    ..outer.clone()
                })
            }
            _ => None,
        })
    }

    fn entered(&self, outer: &Module, inside: &ItemMod) -> Module {
        let name = inside.ident.to_string();
        let folder = outer.folder.join(&name);
        let named = inside.attrs.iter().find_map(path_attribute);
        let beside = outer.folder.join(format!("{name}.rs"));
        let file = match named {
            Some(path) => outer.file.with_file_name(path),
            None if beside.exists() => beside,
            None => folder.join("mod.rs"),
        };
        Module {
            items: self.items(&file),
            file,
            folder,
            declared: Vec::new(),
        }
    }
}

/// The value of `#[path = "…"]`.
fn path_attribute(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(pair) = &attribute.meta else {
        return None;
    };
    let syn::Expr::Lit(literal) = &pair.value else {
        return None;
    };
    match &literal.lit {
        syn::Lit::Str(path) if attribute.path().is_ident("path") => Some(path.value()),
        _ => None,
    }
}

/// The module of an algebra, and the types in it: `algebra!` has `pub mod NAME { … struct TYPE …`.
fn declared(call: &syn::Macro) -> Option<(String, Vec<String>)> {
    if call.path.segments.last()?.ident != "algebra" {
        return None;
    }
    let text = call.tokens.to_string();
    let words: Vec<&str> = text.split_whitespace().collect();
    let after = |keyword: &'static str| {
        let pairs = words.windows(2).filter(move |pair| pair[0] == keyword);
        pairs.map(|pair| pair[1].to_owned())
    };
    Some((after("mod").next()?, after("struct").collect()))
}

/// The name and the visibility of an item that is no module.
fn named(item: &Item) -> Option<(&syn::Ident, &Visibility)> {
    match item {
        Item::Const(item) => Some((&item.ident, &item.vis)),
        Item::Enum(item) => Some((&item.ident, &item.vis)),
        Item::Fn(item) => Some((&item.sig.ident, &item.vis)),
        Item::Static(item) => Some((&item.ident, &item.vis)),
        Item::Struct(item) => Some((&item.ident, &item.vis)),
        Item::Trait(item) => Some((&item.ident, &item.vis)),
        Item::Type(item) => Some((&item.ident, &item.vis)),
        _ => None,
    }
}

/// Whether a type of this name has a public method, a variant or a public field in these items.
fn has_part(items: &[Item], owner: &str, part: &str) -> bool {
    items.iter().any(|item| match item {
        Item::Impl(block) => {
            let Type::Path(path) = &*block.self_ty else {
                return false;
            };
            let is_of_owner = path
                .path
                .segments
                .last()
                .is_some_and(|last| last.ident == owner);
            let is_method = |item: &ImplItem| match item {
                ImplItem::Fn(method) => {
                    let is_public = matches!(method.vis, Visibility::Public(_));
                    method.sig.ident == part && (is_public || block.trait_.is_some())
                }
                _ => false,
            };
            is_of_owner && block.items.iter().any(is_method)
        }
        Item::Enum(item) if item.ident == owner => {
            item.variants.iter().any(|variant| variant.ident == part)
        }
        Item::Struct(item) if item.ident == owner => item.fields.iter().any(|field| {
            let is_named = field.ident.as_ref().is_some_and(|name| name == part);
            is_named && matches!(field.vis, Visibility::Public(_))
        }),
        Item::Trait(item) if item.ident == owner => item.items.iter().any(|item| match item {
            TraitItem::Fn(method) => method.sig.ident == part,
            _ => false,
        }),
        _ => false,
    })
}
