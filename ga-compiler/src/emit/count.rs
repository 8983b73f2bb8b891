//! A count of operations, read from the Rust code that is emitted.
//!
//! The count is taken of the code itself and not of the graph that it was written from, so that it holds whatever an
//! emitter does. What is counted: `+` and `-` are an addition, `*` a multiplication (also one by 2 or ½), `/` and `recip` a
//! division, a fused multiplication and addition is one of each, `sqrt` a root; a negation and a call of any other function are
//! each one *other*. Reading, naming and building cost nothing. Anything that is not known here is an error, so that no
//! operation is overlooked.

use std::fmt;
use std::ops::AddAssign;

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{BinOp, Block, Error, Expr, Item, ItemFn, Pat, Result, Stmt, UnOp};

/// Numbers of operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Multiplications.
    pub multiplications: usize,
    /// Additions and subtractions.
    pub additions: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
    /// Negations and calls of other functions.
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

/// The functions of some code with the operations of each, in order; methods come as `Type::method`.
///
/// # Errors
/// The code is no list of items, or holds a construct that is not counted; the error names it.
///
/// ```
/// let code = quote::quote! { fn f(x: f64, y: f64) -> f64 { let t = x * x; (t + y * y).sqrt() / -t } };
/// let [(name, found)] = &ga_compiler::emit::count::functions(code)?[..] else { panic!("one function") };
/// assert_eq!(name, "f");
/// assert_eq!(found.to_string(), "2 mul, 1 add, 1 div, 1 sqrt, 1 other");
/// # Ok::<(), syn::Error>(())
/// ```
pub fn functions(code: TokenStream) -> Result<Vec<(String, Operations)>> {
    let mut found = Vec::new();
    for item in syn::parse2::<syn::File>(code)?.items {
        match item {
            Item::Fn(ItemFn { sig, block, .. }) => {
                found.push((sig.ident.to_string(), of_block(&block)?));
            }
            Item::Impl(implementation) => {
                let owner = owner(&implementation.self_ty);
                for item in &implementation.items {
                    match item {
                        syn::ImplItem::Fn(method) => {
                            let name = format!("{owner}::{}", method.sig.ident);
                            found.push((name, of_block(&method.block)?));
                        }
                        syn::ImplItem::Type(_) => {}
                        other => return Err(unknown("this part of an implementation", other)),
                    }
                }
            }
            Item::Struct(_) | Item::Use(_) => {}
            other => return Err(unknown("this item", &other)),
        }
    }
    Ok(found)
}

/// The operations of an expression.
///
/// # Errors
/// A construct that is not counted; the error names it.
pub fn expression(code: TokenStream) -> Result<Operations> {
    of_expression(&syn::parse2(code)?)
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

fn of_block(block: &Block) -> Result<Operations> {
    let mut count = Operations::default();
    for statement in &block.stmts {
        match statement {
            Stmt::Local(local) => {
                check_pattern(&local.pat)?;
                if let Some(init) = &local.init {
                    if let Some((_, diverge)) = &init.diverge {
                        return Err(unknown("`let … else`", diverge));
                    }
                    count += of_expression(&init.expr)?;
                }
            }
            Stmt::Expr(expression, _) => count += of_expression(expression)?,
            Stmt::Item(Item::Use(_)) => {}
            Stmt::Item(item) => return Err(unknown("an item inside a function", item)),
            Stmt::Macro(call) => return Err(unknown("a call of a macro", call)),
        }
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

fn of_expression(expression: &Expr) -> Result<Operations> {
    match expression {
        Expr::Path(_) | Expr::Lit(_) => Ok(Operations::default()),
        Expr::Paren(inner) => of_expression(&inner.expr),
        Expr::Group(inner) => of_expression(&inner.expr),
        Expr::Block(inner) if inner.label.is_none() => of_block(&inner.block),
        Expr::Field(field) => of_expression(&field.base),
        Expr::Index(index) if matches!(*index.index, Expr::Lit(_)) => of_expression(&index.expr),
        Expr::Reference(inner) => of_expression(&inner.expr),
        Expr::Unary(unary) => match unary.op {
            UnOp::Deref(_) => of_expression(&unary.expr),
            UnOp::Neg(_) if matches!(*unary.expr, Expr::Lit(_)) => Ok(Operations::default()),
            UnOp::Neg(_) => {
                let mut count = of_expression(&unary.expr)?;
                count.others += 1;
                Ok(count)
            }
            other => Err(unknown("the operator", &other)),
        },
        Expr::Binary(binary) => {
            let mut count = of_expression(&binary.left)?;
            count += of_expression(&binary.right)?;
            match binary.op {
                BinOp::Mul(_) => count.multiplications += 1,
                BinOp::Add(_) | BinOp::Sub(_) => count.additions += 1,
                BinOp::Div(_) => count.divisions += 1,
                other => return Err(unknown("the operator", &other)),
            }
            Ok(count)
        }
        Expr::Tuple(tuple) => all(&tuple.elems),
        Expr::Array(array) => all(&array.elems),
        Expr::Struct(literal) if literal.rest.is_none() => {
            let mut count = Operations::default();
            for field in &literal.fields {
                count += of_expression(&field.expr)?;
            }
            Ok(count)
        }
        Expr::Call(call) => {
            let name = match &*call.func {
                Expr::Path(path) => path.path.segments.last().map(|last| last.ident.to_string()),
                _ => None,
            };
            let Some(name) = name else {
                return Err(unknown("a call of", &call.func));
            };
            let mut count = all(&call.args)?;
            count += of_call(&name, call.args.len(), &call.func)?;
            Ok(count)
        }
        Expr::MethodCall(call) => {
            let mut count = of_expression(&call.receiver)?;
            count += all(&call.args)?;
            count += of_call(&call.method.to_string(), call.args.len() + 1, &call.method)?;
            Ok(count)
        }
        other => Err(unknown("the expression", other)),
    }
}

fn all<P>(expressions: &Punctuated<Expr, P>) -> Result<Operations> {
    let mut count = Operations::default();
    for expression in expressions {
        count += of_expression(expression)?;
    }
    Ok(count)
}

/// What a call costs beyond its arguments.
fn of_call(name: &str, arguments: usize, place: &impl ToTokens) -> Result<Operations> {
    let mut count = Operations::default();
    match (name, arguments) {
        // Constants, and types put together.
        ("zero" | "one", 0) | ("from_integer" | "from_f64", 1) | ("from_ratio", 2) => {}
        ("new_unchecked", _) => {}
        ("mul_add" | "mul_sub" | "neg_mul_add", 3) => {
            count.multiplications += 1;
            count.additions += 1;
        }
        ("recip", 1) => count.divisions += 1,
        ("sqrt", 1) => count.roots += 1,
        ("abs" | "sin" | "cos" | "sin_cos" | "exp" | "ln", 1)
        | ("versor_exponential", 1)
        | ("atan2" | "versor_logarithm", 2) => count.others += 1,
        _ => return Err(unknown("a call of", place)),
    }
    Ok(count)
}

fn unknown(what: &str, place: &(impl ToTokens + Spanned)) -> Error {
    let text = place.to_token_stream().to_string();
    let mut shown: String = text.chars().take(60).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    Error::new(place.span(), format!("not counted: {what} `{shown}`"))
}
