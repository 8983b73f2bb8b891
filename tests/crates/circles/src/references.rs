//! Which files the code of a crate uses, by the paths that are written in it.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{
    Arm, Attribute, Block, ExprClosure, ExprForLoop, ExprIf, ExprLet, ExprWhile, Field,
    GenericParam, Generics, ImplItem, Item, ItemMacro, ItemMod, ItemUse, Local, Macro, PatIdent,
    Path, Stmt, TraitItem, Variant, Visibility,
};

use crate::attributes;
use crate::scope::Scope;
use crate::tree::{Definition, Tree};
use crate::uses;

/// For each pair of files, what the first uses of the second.
pub(crate) type Uses = BTreeMap<(usize, usize), BTreeSet<String>>;

/// The uses between the files of a crate.
pub(crate) fn between_files(tree: &Tree) -> Uses {
    let mut uses = Uses::new();
    for (index, module) in tree.modules.iter().enumerate() {
        let mut references = References {
            tree,
            module: index,
            scope: Scope::default(),
            uses: &mut uses,
        };
        for item in &module.items {
            references.visit_item(item);
        }
    }
    uses
}

/// Macros whose tokens are code of other crates.
const QUOTING: [&str; 3] = ["quote!", "quote_spanned!", "parse_quote!"];

struct References<'a> {
    tree: &'a Tree,
    module: usize,
    scope: Scope,
    uses: &'a mut Uses,
}

impl References<'_> {
    fn add(&mut self, path: &[String]) {
        for definition in self.tree.definitions(self.module, path) {
            self.add_definition(definition);
        }
    }

    fn add_definition(&mut self, used: Definition) {
        let user = self.tree.modules[self.module].file;
        if user != used.file {
            self.uses
                .entry((user, used.file))
                .or_default()
                .insert(used.name);
        }
    }

    /// A path in code, which may begin with the name of a variable or of a type parameter.
    fn add_path(&mut self, path: &[String]) {
        if path.first().is_some_and(|first| !self.scope.has(first)) {
            self.add(path);
        }
    }

    fn add_macro(&mut self, mut path: Vec<String>) {
        if let Some(last) = path.last_mut() {
            last.push('!');
        }
        if let [name] = path.as_slice() {
            let here = self.tree.modules[self.module].file;
            let defined: Vec<Definition> = self.tree.macros(name).collect();
            if defined.iter().all(|definition| definition.file != here) {
                defined
                    .into_iter()
                    .for_each(|definition| self.add_definition(definition));
            }
        }
        self.add(&path);
    }

    /// The paths among the tokens of a macro. A name alone counts where it is called or begins with
    /// a capital letter; others may be anything that the macro reads.
    fn add_tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at] {
                TokenTree::Group(group) => self.add_tokens(group.stream()),
                TokenTree::Ident(first) => {
                    let length = path_length(&tokens[at..]);
                    let path = || {
                        tokens[at..at + length]
                            .iter()
                            .filter_map(ident)
                            .map(name)
                            .collect()
                    };
                    let before = at.checked_sub(1).map(|before| &tokens[before]);
                    let next = tokens.get(at + length);
                    let is_root = first == "crate";
                    if is_punct(next, '!') && !is_punct(tokens.get(at + length + 1), '=') {
                        self.add_macro(path());
                    } else if is_root
                        || !preceded_by_mark(before) && (length > 1 || is_item(first, next))
                    {
                        self.add_path(&path());
                    }
                    at += length - 1;
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
            at += 1;
        }
    }

    /// Visits with names that are forgotten afterwards.
    fn scoped(&mut self, visit: impl FnOnce(&mut Self)) {
        let opened = self.scope.open();
        visit(self);
        self.scope.close(opened);
    }
}

/// How many tokens the path has with which these begin.
fn path_length(tokens: &[TokenTree]) -> usize {
    let mut length = 1;
    while is_punct(tokens.get(length), ':')
        && is_punct(tokens.get(length + 1), ':')
        && tokens.get(length + 2).and_then(ident).is_some()
    {
        length += 3;
    }
    length
}

fn ident(token: &TokenTree) -> Option<&Ident> {
    match token {
        TokenTree::Ident(ident) => Some(ident),
        _ => None,
    }
}

fn name(ident: &Ident) -> String {
    ident.to_string()
}

fn is_punct(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

/// After these a name is a field, a lifetime, a parameter of a macro, or the rest of a path.
fn preceded_by_mark(before: Option<&TokenTree>) -> bool {
    ['.', '\'', '$', ':', '#']
        .iter()
        .any(|&mark| is_punct(before, mark))
}

fn is_item(name: &Ident, next: Option<&TokenTree>) -> bool {
    let is_called = matches!(next, Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis);
    is_called || starts_with_capital(name)
}

fn starts_with_capital(name: &Ident) -> bool {
    name.to_string().starts_with(char::is_uppercase)
}

fn names(path: &Path) -> Vec<String> {
    path.segments
        .iter()
        .map(|segment| segment.ident.to_string())
        .collect()
}

impl<'ast> Visit<'ast> for References<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if !attributes::for_tests(attributes::of_item(item)) {
            self.scoped(|this| visit::visit_item(this, item));
        }
    }

    // Modules are visited one by one.
    fn visit_item_mod(&mut self, _: &'ast ItemMod) {}

    // To re-export is not to use: what uses the name is led to its definition.
    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        for import in uses::imports(item) {
            if import.name.is_some() && !import.shared {
                let mut path = import.path;
                self.add(&path);
                if let Some(last) = path.last_mut() {
                    last.push('!');
                }
                self.add(&path);
            }
        }
    }

    fn visit_impl_item(&mut self, item: &'ast ImplItem) {
        let attributes = match item {
            ImplItem::Const(item) => &item.attrs,
            ImplItem::Fn(item) => &item.attrs,
            ImplItem::Type(item) => &item.attrs,
            ImplItem::Macro(item) => &item.attrs,
            _ => return,
        };
        if !attributes::for_tests(attributes) {
            self.scoped(|this| visit::visit_impl_item(this, item));
        }
    }

    fn visit_trait_item(&mut self, item: &'ast TraitItem) {
        self.scoped(|this| visit::visit_trait_item(this, item));
    }

    fn visit_field(&mut self, field: &'ast Field) {
        if !attributes::for_tests(&field.attrs) {
            visit::visit_field(self, field);
        }
    }

    fn visit_variant(&mut self, variant: &'ast Variant) {
        if !attributes::for_tests(&variant.attrs) {
            visit::visit_variant(self, variant);
        }
    }

    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_generics(&mut self, generics: &'ast Generics) {
        for parameter in &generics.params {
            match parameter {
                GenericParam::Type(parameter) => self.scope.add(&parameter.ident),
                GenericParam::Const(parameter) => self.scope.add(&parameter.ident),
                GenericParam::Lifetime(_) => {}
            }
        }
        visit::visit_generics(self, generics);
    }

    fn visit_block(&mut self, block: &'ast Block) {
        self.scoped(|this| {
            for statement in &block.stmts {
                match statement {
                    Stmt::Item(Item::Fn(item)) => this.scope.add(&item.sig.ident),
                    Stmt::Item(Item::Const(item)) => this.scope.add(&item.ident),
                    Stmt::Item(Item::Struct(item)) => this.scope.add(&item.ident),
                    Stmt::Item(Item::Enum(item)) => this.scope.add(&item.ident),
                    _ => {}
                }
            }
            visit::visit_block(this, block);
        });
    }

    fn visit_local(&mut self, local: &'ast Local) {
        if attributes::for_tests(&local.attrs) {
            return;
        }
        // What is bound does not hide names in the value that it is bound to.
        if let Some(init) = &local.init {
            visit::visit_local_init(self, init);
        }
        self.visit_pat(&local.pat);
    }

    fn visit_expr_let(&mut self, expr: &'ast ExprLet) {
        self.visit_expr(&expr.expr);
        self.visit_pat(&expr.pat);
    }

    fn visit_expr_if(&mut self, expr: &'ast ExprIf) {
        self.scoped(|this| {
            this.visit_expr(&expr.cond);
            this.visit_block(&expr.then_branch);
        });
        if let Some((_, otherwise)) = &expr.else_branch {
            self.visit_expr(otherwise);
        }
    }

    fn visit_expr_while(&mut self, expr: &'ast ExprWhile) {
        self.scoped(|this| visit::visit_expr_while(this, expr));
    }

    fn visit_expr_for_loop(&mut self, expr: &'ast ExprForLoop) {
        self.visit_expr(&expr.expr);
        self.scoped(|this| {
            this.visit_pat(&expr.pat);
            this.visit_block(&expr.body);
        });
    }

    fn visit_expr_closure(&mut self, expr: &'ast ExprClosure) {
        self.scoped(|this| visit::visit_expr_closure(this, expr));
    }

    fn visit_arm(&mut self, arm: &'ast Arm) {
        if !attributes::for_tests(&arm.attrs) {
            self.scoped(|this| visit::visit_arm(this, arm));
        }
    }

    fn visit_pat_ident(&mut self, pattern: &'ast PatIdent) {
        if starts_with_capital(&pattern.ident) {
            self.add_path(&[name(&pattern.ident)]);
        } else {
            self.scope.add(&pattern.ident);
        }
        visit::visit_pat_ident(self, pattern);
    }

    fn visit_path(&mut self, path: &'ast Path) {
        if path.leading_colon.is_none() {
            self.add_path(&names(path));
        }
        visit::visit_path(self, path);
    }

    fn visit_item_macro(&mut self, item: &'ast ItemMacro) {
        match &item.ident {
            Some(_) => self.add_tokens(item.mac.tokens.clone()),
            None => self.visit_macro(&item.mac),
        }
    }

    fn visit_macro(&mut self, called: &'ast Macro) {
        let path = names(&called.path);
        let quotes = path
            .last()
            .is_some_and(|last| QUOTING.contains(&format!("{last}!").as_str()));
        if called.path.leading_colon.is_none() {
            self.add_macro(path);
        }
        if !quotes {
            self.add_tokens(called.tokens.clone());
        }
    }
}
