//! The modules of a crate, with what they define and import, and which items a path names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Item, ItemMod, ItemUse, Visibility};

use crate::attributes;
use crate::error::Error;
use crate::uses::{self, Import};

/// One module. The root of the crate is the first.
pub(crate) struct Module {
    pub(crate) file: usize,
    parent: usize,
    /// Its items, without inline modules and without what is for tests.
    pub(crate) items: Vec<Item>,
    /// The names that it defines. Those of macros end in `!`.
    defined: BTreeSet<String>,
    children: BTreeMap<String, usize>,
    imports: Vec<Import>,
    /// Whether a macro is called among its items, which may define names that no one sees here.
    written_by_macros: bool,
}

/// All modules of a crate.
pub(crate) struct Tree {
    pub(crate) files: Vec<PathBuf>,
    pub(crate) modules: Vec<Module>,
    /// Where each macro by example is defined, by its name with `!`.
    macros: BTreeMap<String, BTreeSet<usize>>,
}

/// An item and the file that defines it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Definition {
    pub(crate) file: usize,
    pub(crate) name: String,
}

/// What a path leads to.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    Module(usize),
    Item(Definition),
}

/// The imports that are being followed, by module and place, so that none is followed in a loop.
type Followed = Vec<(usize, usize)>;

impl Tree {
    /// Reads the crate whose root is the file `root`.
    pub(crate) fn read(root: &Path) -> Result<Tree, Error> {
        let mut tree = Tree {
            files: Vec::new(),
            modules: Vec::new(),
            macros: BTreeMap::new(),
        };
        let folder = root.parent().unwrap_or(Path::new("")).to_path_buf();
        tree.add_file(root.to_path_buf(), folder, 0)?;
        Ok(tree)
    }

    /// Adds the module in `path`, whose child modules lie in `folder`, unless it is for tests.
    fn add_file(
        &mut self,
        path: PathBuf,
        folder: PathBuf,
        parent: usize,
    ) -> Result<Option<usize>, Error> {
        let text = fs::read_to_string(&path).map_err(|source| Error::Read {
            path: path.clone(),
            source,
        })?;
        let parsed = syn::parse_file(&text).map_err(|source| Error::Parse {
            path: path.clone(),
            source,
        })?;
        if attributes::for_tests(&parsed.attrs) {
            return Ok(None);
        }
        self.files.push(path);
        self.add_module(self.files.len() - 1, parsed.items, &folder, parent)
            .map(Some)
    }

    fn add_module(
        &mut self,
        file: usize,
        items: Vec<Item>,
        folder: &Path,
        parent: usize,
    ) -> Result<usize, Error> {
        let index = self.modules.len();
        self.modules.push(Module {
            file,
            parent,
            items: Vec::new(),
            defined: BTreeSet::new(),
            children: BTreeMap::new(),
            imports: Vec::new(),
            written_by_macros: false,
        });
        for item in items {
            if attributes::for_tests(attributes::of_item(&item)) {
                continue;
            }
            match item {
                Item::Mod(module) => self.add_child(index, module, folder)?,
                item => self.add_item(index, item),
            }
        }
        Ok(index)
    }

    fn add_child(&mut self, parent: usize, module: ItemMod, folder: &Path) -> Result<(), Error> {
        let file = self.modules[parent].file;
        let name = module.ident.to_string();
        let below = folder.join(&name);
        let child = match (module.content, attributes::path(&module.attrs)) {
            (Some((_, items)), _) => Some(self.add_module(file, items, &below, parent)?),
            (None, Some(path)) => {
                let beside = self.files[file]
                    .parent()
                    .unwrap_or(Path::new(""))
                    .to_path_buf();
                let path = beside.join(path);
                let below = path.parent().unwrap_or(Path::new("")).to_path_buf();
                self.add_file(path, below, parent)?
            }
            (None, None) => {
                let candidates = [folder.join(format!("{name}.rs")), below.join("mod.rs")];
                let path = candidates.into_iter().find(|path| path.exists());
                let declared = || Error::NoFile {
                    path: self.files[file].clone(),
                    module: name.clone(),
                };
                let path = path.ok_or_else(declared)?;
                self.add_file(path, below, parent)?
            }
        };
        if let Some(child) = child {
            self.modules[parent].children.insert(name, child);
        }
        Ok(())
    }

    fn add_item(&mut self, index: usize, item: Item) {
        let module = &mut self.modules[index];
        match &item {
            Item::Macro(item) => match &item.ident {
                Some(name) => {
                    let name = format!("{name}!");
                    self.macros
                        .entry(name.clone())
                        .or_default()
                        .insert(module.file);
                    module.defined.insert(name);
                }
                None => module.written_by_macros = true,
            },
            Item::ExternCrate(item) if item.ident == "self" => {
                let name = item.rename.as_ref().map(|(_, name)| name.to_string());
                let shared = !matches!(item.vis, Visibility::Inherited);
                let path = vec!["crate".to_owned()];
                module.imports.push(Import { name, path, shared });
            }
            item => module.defined.extend(name_of(item)),
        }
        let mut imports = Imports(Vec::new());
        imports.visit_item(&item);
        module.imports.extend(imports.0);
        module.items.push(item);
    }

    /// The items of this crate that a path in a module names. A path into an item, such as the
    /// variant of an enum, names the item.
    pub(crate) fn definitions(&self, module: usize, path: &[String]) -> Vec<Definition> {
        let items = self.targets(module, path, false, &mut Vec::new());
        let items = items.into_iter();
        items
            .filter_map(|target| match target {
                Target::Item(definition) => Some(definition),
                Target::Module(_) => None,
            })
            .collect()
    }

    /// The files that define a macro by example of this name, which ends in `!`. Such a macro may
    /// be called without a path.
    pub(crate) fn macros(&self, name: &str) -> impl Iterator<Item = Definition> {
        let files = self.macros.get(name).into_iter().flatten();
        files.map(|&file| Definition {
            file,
            name: name.to_owned(),
        })
    }

    /// What a path leads to. Where it `goes_on`, only the modules count.
    fn targets(
        &self,
        from: usize,
        path: &[String],
        goes_on: bool,
        followed: &mut Followed,
    ) -> BTreeSet<Target> {
        let Some((first, rest)) = path.split_first() else {
            return BTreeSet::new();
        };
        let mut targets = self.step(from, first, goes_on || !rest.is_empty(), followed);
        for (place, name) in rest.iter().enumerate() {
            let goes_on = goes_on || place + 1 < rest.len();
            // Where a function and a module have one name, only the module has anything in it.
            if targets
                .iter()
                .any(|target| matches!(target, Target::Module(_)))
            {
                targets.retain(|target| matches!(target, Target::Module(_)));
            }
            let mut next = BTreeSet::new();
            for target in targets {
                match target {
                    Target::Module(module) => {
                        let found = self.step(module, name, goes_on, followed);
                        let there = &self.modules[module];
                        if found.is_empty() && there.written_by_macros && !name.ends_with('!') {
                            let name = name.clone();
                            next.insert(Target::Item(Definition {
                                file: there.file,
                                name,
                            }));
                        }
                        next.extend(found);
                    }
                    item => {
                        next.insert(item);
                    }
                }
            }
            targets = next;
        }
        targets
    }

    /// What one part of a path leads to.
    fn step(
        &self,
        module: usize,
        name: &str,
        goes_on: bool,
        followed: &mut Followed,
    ) -> BTreeSet<Target> {
        match name {
            "crate" => BTreeSet::from([Target::Module(0)]),
            "self" => BTreeSet::from([Target::Module(module)]),
            "super" => BTreeSet::from([Target::Module(self.modules[module].parent)]),
            name => self.lookup(module, name, goes_on, followed),
        }
    }

    /// What a module knows by this name.
    fn lookup(
        &self,
        index: usize,
        name: &str,
        goes_on: bool,
        followed: &mut Followed,
    ) -> BTreeSet<Target> {
        let module = &self.modules[index];
        let mut found = BTreeSet::new();
        if module.defined.contains(name) {
            let name = name.to_owned();
            found.insert(Target::Item(Definition {
                file: module.file,
                name,
            }));
        }
        if let Some(&child) = module.children.get(name) {
            found.insert(Target::Module(child));
        }

        let plain = name.strip_suffix('!').unwrap_or(name);
        for (place, import) in module.imports.iter().enumerate() {
            if import.name.as_deref() == Some(plain) && !followed.contains(&(index, place)) {
                let mut path = import.path.clone();
                if let Some(last) = path.last_mut()
                    && plain != name
                {
                    last.push('!');
                }
                followed.push((index, place));
                found.extend(self.targets(index, &path, goes_on, followed));
                followed.pop();
            }
        }
        let is_item = |target: &Target| matches!(target, Target::Item(_));
        if found.iter().any(is_item) || (goes_on && !found.is_empty()) {
            return found;
        }

        // A module hides modules of its name that `*` brings, but not functions.
        let is_module = !found.is_empty();
        for (place, import) in module.imports.iter().enumerate() {
            if import.name.is_none() && !followed.contains(&(index, place)) {
                followed.push((index, place));
                for target in self.targets(index, &import.path, true, followed) {
                    if let Target::Module(source) = target {
                        let brought = self.lookup(source, name, goes_on, followed).into_iter();
                        found.extend(brought.filter(|target| match target {
                            Target::Module(_) => !is_module,
                            Target::Item(_) => true,
                        }));
                    }
                }
                followed.pop();
            }
        }
        found
    }
}

/// Collects `use` declarations of an item, also those in the bodies of functions.
struct Imports(Vec<Import>);

impl<'ast> Visit<'ast> for Imports {
    fn visit_item(&mut self, item: &'ast Item) {
        if !attributes::for_tests(attributes::of_item(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        self.0.extend(uses::imports(item));
    }
}

fn name_of(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::TraitAlias(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}
