//! A count of operations, read from the Rust code that is emitted.
//!
//! The count is taken from the code itself and not from the graph behind it, so that it is right
//! for every emitter. What is counted: `+` and `-` are an addition, `*` a multiplication (also one
//! by 2 or ½), `/` and `recip` a division, a fused multiplication and addition is one of each,
//! `sqrt` a root; a negation, a comparison, a choice between two numbers and a call of any other
//! function are each one *other*. Reading, naming and building cost nothing. Anything that is not
//! known here is an error, so that no operation is overlooked.

use std::collections::{HashMap, HashSet};
use std::fmt;
use std::ops::AddAssign;

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{BinOp, Block, Error, Expr, Item, ItemFn, Pat, Result, Stmt, UnOp};

use crate::define::{Definition, Role};
use crate::emit::rust;
use crate::function::CompiledFunction;

/// Numbers of operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "source", derive(serde::Serialize))]
pub struct Operations {
    /// Multiplications.
    #[cfg_attr(feature = "source", serde(rename = "mul"))]
    pub multiplications: usize,
    /// Additions and subtractions.
    #[cfg_attr(feature = "source", serde(rename = "add"))]
    pub additions: usize,
    /// Divisions.
    #[cfg_attr(feature = "source", serde(rename = "div"))]
    pub divisions: usize,
    /// Square roots.
    #[cfg_attr(feature = "source", serde(rename = "sqrt"))]
    pub roots: usize,
    /// Negations and calls of other functions.
    #[cfg_attr(feature = "source", serde(rename = "other"))]
    pub others: usize,
}

impl Operations {
    /// All of them together.
    #[must_use]
    pub const fn total(self) -> usize {
        self.multiplications + self.additions + self.divisions + self.roots + self.others
    }
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Self) {
        self.multiplications += other.multiplications;
        self.additions += other.additions;
        self.divisions += other.divisions;
        self.roots += other.roots;
        self.others += other.others;
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            multiplications,
            additions,
            divisions,
            roots,
            others,
        } = self;
        write!(f, "{multiplications} mul, {additions} add")?;
        for (count, name) in [(divisions, "div"), (roots, "sqrt"), (others, "other")] {
            if *count > 0 {
                write!(f, ", {count} {name}")?;
            }
        }
        Ok(())
    }
}

/// The operations of a compiled function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "source", derive(serde::Serialize))]
pub struct FunctionCount {
    /// What is done in every call.
    #[cfg_attr(feature = "source", serde(flatten))]
    pub call: Operations,
    /// What is done once for the uniform operands.
    pub uniform: Operations,
}

/// Emits a function as Rust and counts the operations in its code. `path` is where that code finds
/// the algebra.
///
/// # Errors
/// The code holds a construct that is not counted; the error names it.
pub fn function(
    definition: &Definition,
    path: &TokenStream,
    function: &CompiledFunction,
) -> Result<FunctionCount> {
    // A closure stands inside an expression; under a name it is an item.
    let mut named = function.clone();
    named.name.get_or_insert_with(|| format_ident!("closure"));
    let is_staged = named.operands.iter().any(|operand| operand.is_uniform);
    let code = rust::functions(definition, path, std::slice::from_ref(&named));
    let counter = Counter::new(definition, &named);
    let mut count = FunctionCount::default();
    for (name, block) in bodies(code)? {
        let operations = |block| counter.block(block);
        match (is_staged, name.split_once("::").map(|(_, method)| method)) {
            (false, None) | (true, Some("apply")) => count.call += operations(&block)?,
            (true, None) => count.uniform += operations(&block)?,
            // It takes every number to another scalar by a function of the caller's.
            (true, Some("map")) => {}
            _ => {
                return Err(unknown(
                    "the function",
                    &format_ident!("{}", name.replace("::", "_")),
                ));
            }
        }
    }
    Ok(count)
}

/// The functions of some code with the operations of each, in order; methods come as
/// `Type::method`.
///
/// # Errors
/// The code is not a list of items, or holds a construct that is not counted; the error names it.
///
/// ```
/// let code =
///     quote::quote! { fn f(x: f64, y: f64) -> f64 { let t = x * x; (t + y * y).sqrt() / -t } };
/// let [(name, found)] = &ga_compiler::emit::count::functions(code)?[..] else {
///     panic!("one function")
/// };
/// assert_eq!(name, "f");
/// assert_eq!(found.to_string(), "2 mul, 1 add, 1 div, 1 sqrt, 1 other");
/// # Ok::<(), syn::Error>(())
/// ```
pub fn functions(code: TokenStream) -> Result<Vec<(String, Operations)>> {
    let counter = Counter::default();
    let counted = |(name, block)| Ok((name, counter.block(&block)?));
    bodies(code)?.into_iter().map(counted).collect()
}

/// The operations of an expression.
///
/// # Errors
/// A construct that is not counted; the error names it.
pub fn expression(code: TokenStream) -> Result<Operations> {
    Counter::default().expression(&syn::parse2(code)?)
}

/// The bodies of all functions in a list of items.
fn bodies(code: TokenStream) -> Result<Vec<(String, Block)>> {
    let mut found = Vec::new();
    for item in syn::parse2::<syn::File>(code)?.items {
        match item {
            Item::Fn(ItemFn { sig, block, .. }) => found.push((sig.ident.to_string(), *block)),
            Item::Impl(implementation) => {
                let owner = owner(&implementation.self_ty);
                for item in implementation.items {
                    match item {
                        syn::ImplItem::Fn(method) => {
                            found.push((format!("{owner}::{}", method.sig.ident), method.block));
                        }
                        syn::ImplItem::Type(_) => {}
                        other => return Err(unknown("this part of an implementation", &other)),
                    }
                }
            }
            Item::Struct(_) | Item::Use(_) => {}
            // A warning.
            Item::Const(constant) if constant.ident == "_" => {}
            other => return Err(unknown("this item", &other)),
        }
    }
    Ok(found)
}

/// The name of the type of an implementation, without its parameters.
fn owner(kind: &syn::Type) -> String {
    match kind {
        syn::Type::Path(path) => match path.path.segments.last() {
            Some(segment) => segment.ident.to_string(),
            None => path.to_token_stream().to_string(),
        },
        other => other.to_token_stream().to_string(),
    }
}

/// Knows which calls cost nothing: those that read or build members of types.
#[derive(Default)]
struct Counter {
    /// The names under which methods give a stored coefficient.
    accessors: HashSet<String>,
    /// The types that are built of as many coefficients.
    types: HashMap<String, usize>,
    /// The types with the coefficients that they store and have readers for.
    readers: HashSet<(String, String)>,
}

impl Counter {
    fn new(definition: &Definition, function: &CompiledFunction) -> Self {
        let mut counter = Self::default();
        let (mut stored, mut others) = (HashSet::new(), HashSet::new());
        for operand in &function.operands {
            for kind in operand.shape.leaves(definition).into_iter().flatten() {
                for coefficient in &kind.coefficients {
                    let names = match coefficient.role {
                        Role::Stored => &mut stored,
                        Role::Constant(_) | Role::Derived(_) => &mut others,
                    };
                    names.insert(coefficient.name.to_string());
                }
            }
        }
        // Where one operand stores what another computes, the name does not tell which is read.
        counter.accessors = stored.difference(&others).cloned().collect();
        for kind in &definition.types {
            counter
                .types
                .insert(kind.name.to_string(), kind.stored().count());
            let readers = kind
                .stored()
                .map(|coefficient| coefficient.name.to_string());
            counter
                .readers
                .extend(readers.map(|reader| (kind.name.to_string(), reader)));
        }
        counter
    }

    fn block(&self, block: &Block) -> Result<Operations> {
        let mut count = Operations::default();
        for statement in &block.stmts {
            match statement {
                Stmt::Local(local) => {
                    check_pattern(&local.pat)?;
                    if let Some(init) = &local.init {
                        if let Some((_, diverge)) = &init.diverge {
                            return Err(unknown("`let … else`", diverge));
                        }
                        count += self.expression(&init.expr)?;
                    }
                }
                Stmt::Expr(expression, _) => count += self.expression(expression)?,
                Stmt::Item(Item::Use(_)) => {}
                Stmt::Item(item) => return Err(unknown("an item inside a function", item)),
                Stmt::Macro(call) => return Err(unknown("a call of a macro", call)),
            }
        }
        Ok(count)
    }

    fn expression(&self, expression: &Expr) -> Result<Operations> {
        match expression {
            Expr::Path(_) | Expr::Lit(_) => Ok(Operations::default()),
            Expr::Paren(inner) => self.expression(&inner.expr),
            Expr::Group(inner) => self.expression(&inner.expr),
            Expr::Block(inner) if inner.label.is_none() => self.block(&inner.block),
            Expr::Field(field) => self.expression(&field.base),
            Expr::Index(index) if matches!(*index.index, Expr::Lit(_)) => {
                self.expression(&index.expr)
            }
            Expr::Reference(inner) => self.expression(&inner.expr),
            Expr::Unary(unary) => match unary.op {
                UnOp::Deref(_) => self.expression(&unary.expr),
                UnOp::Neg(_) if matches!(*unary.expr, Expr::Lit(_)) => Ok(Operations::default()),
                UnOp::Neg(_) | UnOp::Not(_) => {
                    let mut count = self.expression(&unary.expr)?;
                    count.others += 1;
                    Ok(count)
                }
                other => Err(unknown("the operator", &other)),
            },
            Expr::Binary(binary) => {
                let mut count = self.expression(&binary.left)?;
                count += self.expression(&binary.right)?;
                match binary.op {
                    BinOp::Mul(_) => count.multiplications += 1,
                    BinOp::Add(_) | BinOp::Sub(_) => count.additions += 1,
                    BinOp::Div(_) => count.divisions += 1,
                    BinOp::BitAnd(_) | BinOp::BitOr(_) => count.others += 1,
                    other => return Err(unknown("the operator", &other)),
                }
                Ok(count)
            }
            Expr::Tuple(tuple) => self.all(&tuple.elems),
            Expr::Array(array) => self.all(&array.elems),
            Expr::Struct(literal) if literal.rest.is_none() => {
                let mut count = Operations::default();
                for field in &literal.fields {
                    count += self.expression(&field.expr)?;
                }
                Ok(count)
            }
            Expr::Call(call) => {
                let Expr::Path(path) = &*call.func else {
                    return Err(unknown("a call of", &call.func));
                };
                let mut count = self.all(&call.args)?;
                if !self.is_free(&path.path, call.args.len()) {
                    let name = path.path.segments.last().map(|last| last.ident.to_string());
                    count += of_call(&name.unwrap_or_default(), call.args.len(), path)?;
                }
                Ok(count)
            }
            Expr::MethodCall(call) => {
                let mut count = self.expression(&call.receiver)?;
                count += self.all(&call.args)?;
                let name = call.method.to_string();
                if !(call.args.is_empty() && self.accessors.contains(&name)) {
                    count += of_call(&name, call.args.len() + 1, &call.method)?;
                }
                Ok(count)
            }
            other => Err(unknown("the expression", other)),
        }
    }

    fn all<P>(&self, expressions: &Punctuated<Expr, P>) -> Result<Operations> {
        let mut count = Operations::default();
        for expression in expressions {
            count += self.expression(expression)?;
        }
        Ok(count)
    }

    /// Whether a path is that of a function which puts a type together from its coefficients or
    /// reads one of them.
    fn is_free(&self, path: &syn::Path, arguments: usize) -> bool {
        let mut last = path
            .segments
            .iter()
            .rev()
            .map(|segment| segment.ident.to_string());
        let (Some(name), Some(kind)) = (last.next(), last.next()) else {
            return false;
        };
        let is_constructor = ["new", "new_unchecked"].contains(&name.as_str())
            && self.types.get(&kind) == Some(&arguments);
        is_constructor || (arguments == 1 && self.readers.contains(&(kind, name)))
    }
}

/// What a call costs beyond its arguments.
fn of_call(name: &str, arguments: usize, place: &(impl ToTokens + Spanned)) -> Result<Operations> {
    let mut count = Operations::default();
    match (name, arguments) {
        // Constants.
        ("zero" | "one", 0) | ("from_integer" | "from_f64", 1) | ("from_ratio", 2) => {}
        ("mul_add" | "mul_sub" | "neg_mul_add", 3) => {
            count.multiplications += 1;
            count.additions += 1;
        }
        ("recip" | "recip_or_zero", 1) | ("div_or_zero", 2) => count.divisions += 1,
        ("sqrt", 1) => count.roots += 1,
        ("abs" | "sin" | "cos" | "sin_cos" | "exp" | "ln" | "sinh" | "cosh" | "tanh", 1)
        | ("versor_exponential", 1)
        | ("atan2" | "hypot" | "versor_logarithm" | "min" | "max", 2)
        | ("less_than" | "less_or_equal" | "equals", 2)
        | ("select", 3) => count.others += 1,
        _ => return Err(unknown("a call of", place)),
    }
    Ok(count)
}

/// A pattern that only names parts.
fn check_pattern(pattern: &Pat) -> Result<()> {
    match pattern {
        Pat::Wild(_) => Ok(()),
        Pat::Ident(name) if name.subpat.is_none() => Ok(()),
        Pat::Paren(inner) => check_pattern(&inner.pat),
        Pat::Type(inner) => check_pattern(&inner.pat),
        Pat::Tuple(parts) => parts.elems.iter().try_for_each(check_pattern),
        Pat::Slice(parts) => parts.elems.iter().try_for_each(check_pattern),
        Pat::TupleStruct(parts) => parts.elems.iter().try_for_each(check_pattern),
        Pat::Struct(parts) => parts
            .fields
            .iter()
            .try_for_each(|field| check_pattern(&field.pat)),
        Pat::Rest(_) => Ok(()),
        other => Err(unknown("this pattern", other)),
    }
}

fn unknown(what: &str, place: &(impl ToTokens + Spanned)) -> Error {
    let text = place.to_token_stream().to_string();
    let mut shown: String = text.chars().take(60).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    Error::new(place.span(), format!("not counted: {what} `{shown}`"))
}
