//! What all emitters need: paths, generics, reading and building types.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, body};
use crate::define::{Definition, TypeDefinition};
use crate::expression::Expression;
use crate::kernel::wanted;
use crate::task::Task;

/// A definition under emission.
pub(super) struct Context<'a> {
    pub(super) definition: &'a Definition,
    pub(super) runtime: &'a TokenStream,
}

impl<'a> Context<'a> {
    pub(super) fn new(definition: &'a Definition) -> Self {
        Self {
            definition,
            runtime: &definition.runtime,
        }
    }

    pub(super) fn kind(&self, index: usize) -> &'a TypeDefinition {
        &self.definition.types[index]
    }

    /// The type of sums and multiples.
    pub(super) fn hull(&self, kind: &'a TypeDefinition) -> &'a TypeDefinition {
        kind.hull.map_or(kind, |index| self.kind(index))
    }

    /// `Point<S>`, or `Infinity` for a type without stored coefficients.
    pub(super) fn path(&self, kind: &TypeDefinition) -> TokenStream {
        let name = &kind.name;
        if kind.is_constant() {
            quote! { #name }
        } else {
            quote! { #name<S> }
        }
    }

    /// The type of a result, or the scalar.
    pub(super) fn result_path(&self, result: Option<&TypeDefinition>) -> TokenStream {
        result.map_or_else(|| quote! { S }, |kind| self.path(kind))
    }

    /// The weakest trait that a body requires of the scalar.
    pub(super) fn bound(&self, needs_field: bool) -> TokenStream {
        let runtime = self.runtime;
        if needs_field {
            quote! { #runtime::scalar::Field }
        } else {
            quote! { #runtime::scalar::Ring }
        }
    }

    /// `Path { field: value, … }`, or the value itself for a scalar.
    pub(super) fn build(
        &self,
        result: Option<&TypeDefinition>,
        values: &[TokenStream],
    ) -> TokenStream {
        let Some(kind) = result else {
            return values.first().cloned().unwrap_or_default();
        };
        let name = &kind.name;
        if kind.is_constant() {
            return quote! { #name };
        }
        let fields = kind.stored().map(|c| &c.name);
        quote! { #name { #(#fields: #values),* } }
    }

    /// The body of an expression over operands called by the given names, with the finished result
    /// as its tail.
    pub(super) fn compile(
        &self,
        operands: &[(&TypeDefinition, Ident)],
        expression: &Expression,
        result: Option<&TypeDefinition>,
    ) -> (TokenStream, bool) {
        self.compile_scaled(operands, &[], expression, result)
    }

    /// The same with plain numbers as further operands.
    pub(super) fn compile_scaled(
        &self,
        operands: &[(&TypeDefinition, Ident)],
        scalars: &[Ident],
        expression: &Expression,
        result: Option<&TypeDefinition>,
    ) -> (TokenStream, bool) {
        let scalar = TypeDefinition::scalar();
        let mut kinds: Vec<_> = operands.iter().map(|(kind, _)| *kind).collect();
        kinds.extend(scalars.iter().map(|_| &scalar));
        let mut inputs = fields(operands);
        inputs.extend(scalars.iter().map(|name| quote! { #name }));
        let algebra = &self.definition.algebra;
        let kernel = Task::of_expression(algebra, &kinds, expression, wanted(result)).compile();
        let Body {
            statements,
            outputs,
            needs_field,
            ..
        } = body(&kernel, self.runtime, &inputs);
        let built = self.build(result, &outputs);
        (quote! { #statements #built }, needs_field)
    }
}

/// `name.field` for all stored coefficients of all operands.
pub(super) fn fields(operands: &[(&TypeDefinition, Ident)]) -> Vec<TokenStream> {
    operands
        .iter()
        .flat_map(|(kind, operand)| {
            kind.stored().map(move |c| {
                let field = &c.name;
                quote! { #operand.#field }
            })
        })
        .collect()
}

/// The receiver of a method.
pub(super) fn receiver() -> Ident {
    format_ident!("self")
}

/// The second operand of an operator.
pub(super) fn other() -> Ident {
    format_ident!("other")
}
