//! The algebra that functions are written in.

use std::path::Path;

use anyhow::{Result, bail};
use ga_compiler::define::Definition;
use ga_compiler::parse::parse_outline;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::source::{Source, calls};

/// An algebra, and where emitted code finds it.
pub(super) struct Algebra {
    pub(super) definition: Definition,
    pub(super) path: TokenStream,
}

/// Receives the declaration of an algebra from its macro, as text.
macro_rules! declaration {
    ([$($runtime:tt)*] { $($declaration:tt)* }) => {
        stringify!($($declaration)*)
    };
}

/// The names of algebras with their declarations.
macro_rules! with_declarations {
    ($($name:ident),*) => {
        &[$((stringify!($name), ga_runtime::$name! { [declaration] })),*]
    };
}

/// The algebras that ship, with their declarations.
const SHIPPED: &[(&str, &str)] = ga_runtime::__algebras!(with_declarations);

impl Algebra {
    /// The algebra of that name or in that file; without either, the one that the functions name.
    pub(super) fn find(wanted: Option<&str>, functions: &Source) -> Result<Self> {
        let named = functions.algebra();
        if let Some(wanted) = wanted {
            if let Some(found) = Self::shipped(wanted)? {
                return Ok(found);
            }
            if !Path::new(wanted).exists() {
                let names: Vec<&str> = SHIPPED.iter().map(|(name, _)| *name).collect();
                let names = names.join(", ");
                bail!("--algebra {wanted}: this is neither one of {names} nor a file");
            }
            let source = Source::read(Path::new(wanted))?;
            return Self::declared(&source, named.as_deref());
        }
        let Some(named) = named else {
            return Self::find(Some("cga3"), functions);
        };
        if !declarations(functions).is_empty() {
            return Self::declared(functions, Some(&named));
        }
        match Self::shipped(&named)? {
            Some(found) => Ok(found),
            None => bail!(
                "{} is written in the algebra {named}: give its file with --algebra",
                functions.name()
            ),
        }
    }

    fn shipped(name: &str) -> Result<Option<Self>> {
        let Some((_, text)) = SHIPPED.iter().find(|(shipped, _)| *shipped == name) else {
            return Ok(None);
        };
        let source = Source::of_text(name, text)?;
        let name = quote::format_ident!("{name}");
        Self::check(&source, source.tokens(), quote! { ga_runtime::#name }).map(Some)
    }

    /// The algebra that a text declares; of several, the one of that name.
    fn declared(source: &Source, named: Option<&str>) -> Result<Self> {
        let mut declarations = declarations(source);
        if declarations.is_empty() {
            // The text is a declaration without the macro around it.
            declarations.push(source.tokens());
        }
        let name_of = |declaration: &TokenStream| {
            let outline = parse_outline(declaration.clone());
            outline.ok().map(|outline| outline.name)
        };
        let chosen = match declarations.as_slice() {
            [single] => single,
            several => {
                let is_named = |declaration: &&TokenStream| {
                    name_of(declaration)
                        .is_some_and(|name| Some(name.to_string().as_str()) == named)
                };
                match several.iter().find(is_named) {
                    Some(found) => found,
                    None => bail!("{} declares several algebras", source.name()),
                }
            }
        };
        let path = name_of(chosen).map(|name| name.into_token_stream());
        Self::check(source, chosen.clone(), path.unwrap_or_default())
    }

    fn check(source: &Source, declaration: TokenStream, path: TokenStream) -> Result<Self> {
        let definition = ga_compiler::check_types(declaration, quote! { ga_runtime })
            .map_err(|error| source.error(&error))?;
        Ok(Self { definition, path })
    }
}

/// The declarations in the calls of `algebra! { … }`.
fn declarations(source: &Source) -> Vec<TokenStream> {
    calls(&source.tokens(), "algebra")
        .into_iter()
        .map(|call| call.contents)
        .collect()
}
