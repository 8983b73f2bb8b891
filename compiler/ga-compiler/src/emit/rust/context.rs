//! What all emitters need: paths, generics, reading and building types.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, Needs, body};
use crate::define::{Definition, Parameter, TypeDefinition};
use crate::expression::Expression;
use crate::typed;

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
    pub(super) fn bound(&self, needs: Needs) -> TokenStream {
        let (runtime, name) = (self.runtime, format_ident!("{}", needs.name()));
        quote! { #runtime::scalar::#name }
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
        let mut values = values.iter();
        let Some(parameters) = &kind.parameters else {
            let fields = kind.stored().map(|c| &c.name);
            return quote! { #name { #(#fields: #values),* } };
        };
        let fields = parameters.list.iter().map(|parameter| {
            let own = values.by_ref().take(parameter.kind.count());
            let own: Vec<TokenStream> = own.cloned().collect();
            let kind = parameter.index.map(|_| &parameter.kind);
            let (field, value) = (&parameter.name, self.build(kind, &own));
            quote! { #field: #value }
        });
        quote! { #name { #(#fields),* } }
    }

    /// The body of an expression over operands called by the given names, with the finished result
    /// as its tail.
    pub(super) fn compile(
        &self,
        operands: &[(&TypeDefinition, Ident)],
        expression: &Expression,
        result: Option<&TypeDefinition>,
    ) -> (TokenStream, Needs) {
        self.compile_scaled(operands, &[], expression, result)
    }

    /// The same with plain numbers as further operands.
    pub(super) fn compile_scaled(
        &self,
        operands: &[(&TypeDefinition, Ident)],
        scalars: &[Ident],
        expression: &Expression,
        result: Option<&TypeDefinition>,
    ) -> (TokenStream, Needs) {
        let scalar = TypeDefinition::scalar();
        let mut kinds: Vec<_> = operands.iter().map(|(kind, _)| *kind).collect();
        kinds.extend(scalars.iter().map(|_| &scalar));
        let mut inputs = fields(operands);
        inputs.extend(scalars.iter().map(|name| quote! { #name }));
        let kernel = match typed::compile(self.definition, &kinds, expression, result) {
            Ok(kernel) => kernel,
            Err(error) => {
                let message = format!("a formula of a type by parameters: {error}");
                return (quote! { ::core::compile_error!(#message) }, Needs::Ring);
            }
        };
        let Body {
            statements,
            outputs,
            needs,
            ..
        } = body(&kernel, self.runtime, &inputs);
        let built = self.build(result, &outputs);
        (quote! { #statements #built }, needs)
    }
}

/// `name.field` for all stored coefficients of all operands.
pub(super) fn fields(operands: &[(&TypeDefinition, Ident)]) -> Vec<TokenStream> {
    let of_operand =
        |(kind, operand): &(&TypeDefinition, Ident)| numbers(kind, &quote! { #operand });
    operands.iter().flat_map(of_operand).collect()
}

/// The numbers that a member is stored as, given its expression.
fn numbers(kind: &TypeDefinition, value: &TokenStream) -> Vec<TokenStream> {
    let Some(parameters) = &kind.parameters else {
        let fields = kind.stored().map(|c| &c.name);
        return fields.map(|field| quote! { #value.#field }).collect();
    };
    let of_parameter = |parameter: &Parameter| {
        let field = &parameter.name;
        let value = quote! { #value.#field };
        match parameter.index {
            None => vec![value],
            Some(_) => numbers(&parameter.kind, &value),
        }
    };
    parameters.list.iter().flat_map(of_parameter).collect()
}

/// The receiver of a method.
pub(super) fn receiver() -> Ident {
    format_ident!("self")
}

/// The second operand of an operator.
pub(super) fn other() -> Ident {
    format_ident!("other")
}
