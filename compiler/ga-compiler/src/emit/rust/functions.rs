//! Functions: what `ga!` expands to.

use std::collections::HashMap;

use heck::ToUpperCamelCase;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::Visibility;
use syn::ext::IdentExt;

use super::body::{Body, Needs, Source, constant, stage_body};
use super::warnings;
use crate::define::{Definition, TypeDefinition};
use crate::function::CompiledFunction;
use crate::ir::{NodeId, Value};
use crate::parse::{FaultyFunctions, FunctionSyntax, ShapeSyntax};
use crate::passes::Stages;
use crate::resolve::resolve_shape;
use crate::signature::{Operand, Shape};

/// The functions as items, or a single closure as an expression. `path` is where the module of the
/// algebra is found.
#[must_use]
pub fn functions(
    definition: &Definition,
    path: &TokenStream,
    functions: &[CompiledFunction],
) -> TokenStream {
    let emitter = Emitter {
        definition,
        path,
        runtime: &definition.runtime,
    };
    if let [closure] = functions
        && closure.name.is_none()
    {
        let name = format_ident!("closure");
        let (items, warnings) = (emitter.function(closure, &name), always_zero(closure));
        return quote! { { #warnings #items #name } };
    }
    functions
        .iter()
        .map(|function| {
            let name = function.name.clone();
            let name = name.unwrap_or_else(|| format_ident!("closure"));
            let mut items = always_zero(function);
            items.extend(emitter.function(function, &name));
            items
        })
        .collect()
}

/// The code of [`functions`] as formatted text; functions have names.
///
/// # Errors
/// The code is not Rust, which is a defect of the compiler.
#[cfg(feature = "source")]
pub fn text(
    definition: &Definition,
    path: &TokenStream,
    compiled: &[CompiledFunction],
) -> syn::Result<String> {
    let file = syn::parse2(functions(definition, path, compiled))?;
    Ok(prettyplease::unparse(&file))
}

fn always_zero(function: &CompiledFunction) -> TokenStream {
    let (attributes, warnings) = (&function.attributes, &function.warnings);
    warnings::emit(attributes, warnings, "ALWAYS_ZERO", "function")
}

/// Functions of the same signatures that never return. They stand in for functions with errors, so
/// that their callers cause no further errors.
#[must_use]
pub fn function_stand_ins(
    definition: &Definition,
    path: &TokenStream,
    functions: &[FunctionSyntax],
) -> Option<TokenStream> {
    let emitter = Emitter {
        definition,
        path,
        runtime: &definition.runtime,
    };
    let mut items = TokenStream::new();
    for function in functions {
        let name = function.name.as_ref()?;
        let shape = |syntax: &ShapeSyntax| resolve_shape(definition, syntax).ok();
        if function.operands.iter().any(|operand| operand.is_uniform) {
            return None;
        }
        let parameters: Option<Vec<_>> = function
            .operands
            .iter()
            .map(|operand| {
                let (name, path) = (&operand.name, emitter.shape_path(&shape(&operand.shape)?));
                Some(quote! { #name: #path })
            })
            .collect();
        let (parameters, result) = (parameters?, emitter.shape_path(&shape(&function.result)?));
        let (visibility, runtime) = (&function.visibility, emitter.runtime);
        items.extend(quote! {
            #[doc(hidden)]
            #[allow(clippy::all, clippy::pedantic, unused_variables, missing_docs)]
            #visibility fn #name<S: #runtime::scalar::Ring>(#(#parameters),*) -> #result {
                loop {}
            }
        });
    }
    Some(items)
}

/// Stand-ins for functions of a faulty algebra: their names are imported from the module that holds
/// its errors.
#[must_use]
pub fn stand_ins_of_functions(faulty: &FaultyFunctions) -> TokenStream {
    let FaultyFunctions { path, functions } = faulty;
    if functions.is_empty() {
        return quote! { { use #path::__errors::closure; closure } };
    }
    let imports = functions.iter().map(|(visibility, name, is_staged)| {
        let prepared = is_staged.then(|| {
            let prepared = name.unraw().to_string().to_upper_camel_case();
            format_ident!("{prepared}", span = name.span())
        });
        let names = [name.clone()].into_iter().chain(prepared);
        quote! {
            #[allow(unused_imports)]
            #visibility use #path::__errors::{#(#names),*};
        }
    });
    imports.collect()
}

struct Emitter<'a> {
    definition: &'a Definition,
    path: &'a TokenStream,
    runtime: &'a TokenStream,
}

impl Emitter<'_> {
    fn function(&self, function: &CompiledFunction, name: &Ident) -> TokenStream {
        if function.operands.iter().any(|operand| operand.is_uniform) {
            return self.staged(function, name);
        }
        let (attributes, visibility) = (&function.attributes, &function.visibility);
        let inputs = self.inputs(function);
        let parameters = self.parameters(function.operands.iter());
        let result = self.shape_path(&function.result);
        let stages = function.kernel.stages();
        let source = Source {
            runtime: self.runtime,
            inputs: &inputs,
            given: &HashMap::new(),
            prefix: prefix(&function.operands),
        };
        let kernel = &function.kernel;
        let body = stage_body(&kernel.arena, stages.inner, &kernel.outputs, &source);
        let (bound, statements) = (self.bound(function, &body), &body.statements);
        let built = self.build(&function.result, &mut body.outputs.iter());
        quote! {
            #(#attributes)*
            #[inline]
            #[allow(clippy::all, clippy::pedantic, unused_variables)]
            #visibility fn #name<S: #bound>(#(#parameters),*) -> #result {
                #statements
                #built
            }
        }
    }

    /// A function of the uniform operands that returns a struct, whose method takes the others.
    fn staged(&self, function: &CompiledFunction, name: &Ident) -> TokenStream {
        let (attributes, visibility) = (&function.attributes, &function.visibility);
        let inputs = self.inputs(function);
        let kernel = &function.kernel;
        let Stages {
            prologue,
            inner,
            handed,
        } = kernel.stages();
        let prepared = Prepared::new(function, name, handed.len());
        let handed_values: Vec<_> = handed.iter().copied().map(Value::of).collect();
        let given: HashMap<NodeId, TokenStream> = handed
            .iter()
            .zip(&prepared.fields)
            .map(|(&node, field)| (node, quote! { self.#field }))
            .collect();
        let source = |given| Source {
            runtime: self.runtime,
            inputs: &inputs,
            given,
            prefix: prefix(&function.operands),
        };
        let nothing = HashMap::new();
        let first = stage_body(&kernel.arena, prologue, &handed_values, &source(&nothing));
        let second = stage_body(&kernel.arena, inner, &kernel.outputs, &source(&given));
        let uniform = self.parameters(function.operands.iter().filter(|o| o.is_uniform));
        let varying = self.parameters(function.operands.iter().filter(|o| !o.is_uniform));
        let result = self.shape_path(&function.result);
        let (first_bound, second_bound) =
            (self.bound(function, &first), self.bound(function, &second));
        let (statements, inner_statements) = (&first.statements, &second.statements);
        let built = self.build(&function.result, &mut second.outputs.iter());
        let structure = prepared.structure();
        let (prepared_name, prepared_value) = (&prepared.name, prepared.value(&first.outputs));
        quote! {
            #structure

            #[allow(clippy::all, clippy::pedantic, unused_variables, dead_code)]
            impl<S: #second_bound> #prepared_name<S> {
                /// The function's value for the operands that are not uniform.
                #[inline(always)]
                #[must_use]
                #visibility fn apply(&self, #(#varying),*) -> #result {
                    #inner_statements
                    #built
                }
            }

            #(#attributes)*
            #[inline]
            #[must_use]
            #[allow(clippy::all, clippy::pedantic, unused_variables)]
            #visibility fn #name<S: #first_bound>(#(#uniform),*) -> #prepared_name<S> {
                #statements
                #prepared_value
            }
        }
    }

    fn bound(&self, function: &CompiledFunction, body: &Body) -> TokenStream {
        let has_fraction = function
            .kernel
            .literals
            .iter()
            .any(|value| !value.is_integer());
        let runtime = self.runtime;
        let needs = match has_fraction {
            true => body.needs.max(Needs::Field),
            false => body.needs,
        };
        let name = format_ident!("{}", needs.name());
        quote! { #runtime::scalar::#name }
    }

    fn parameters<'o>(&self, operands: impl Iterator<Item = &'o Operand>) -> Vec<TokenStream> {
        operands
            .map(|operand| {
                let (name, path) = (&operand.name, self.shape_path(&operand.shape));
                quote! { #name: #path }
            })
            .collect()
    }

    fn shape_path(&self, shape: &Shape) -> TokenStream {
        match shape {
            Shape::Scalar => quote! { S },
            Shape::Type(index) => {
                let kind = &self.definition.types[*index];
                let (path, name) = (self.path, &kind.name);
                let scalar = (!kind.is_constant()).then(|| quote! { <S> });
                quote! { #path::#name #scalar }
            }
            Shape::Array(element, count) => {
                let element = self.shape_path(element);
                quote! { [#element; #count] }
            }
            Shape::Tuple(parts) => {
                let parts = parts.iter().map(|part| self.shape_path(part));
                quote! { (#(#parts,)*) }
            }
        }
    }

    /// The expressions of all stored coefficients of all operands, and numbers of the source.
    fn inputs(&self, function: &CompiledFunction) -> Vec<TokenStream> {
        let mut inputs = Vec::new();
        for operand in &function.operands {
            let name = &operand.name;
            self.coefficients(&operand.shape, &quote! { #name }, &mut inputs);
        }
        let literals = function.kernel.literals.iter();
        inputs.extend(literals.map(|&value| constant(self.runtime, value)));
        inputs
    }

    fn coefficients(&self, shape: &Shape, value: &TokenStream, inputs: &mut Vec<TokenStream>) {
        match shape {
            Shape::Scalar => inputs.push(value.clone()),
            Shape::Type(index) => {
                let kind = &self.definition.types[*index];
                let (path, name) = (self.path, &kind.name);
                if let Some(parameters) = &kind.parameters {
                    for parameter in &parameters.list {
                        let field = &parameter.name;
                        let part = quote! { #value.#field };
                        self.coefficients(&parameter.shape(), &part, inputs);
                    }
                    return;
                }
                inputs.extend(kind.stored().map(|coefficient| {
                    let field = &coefficient.name;
                    if kind.is_linear() {
                        quote! { #value.#field }
                    } else {
                        // By its path, since a trait in scope may have a method of that name.
                        quote! { #path::#name::#field(&#value) }
                    }
                }));
            }
            Shape::Array(element, count) => {
                for index in 0..*count {
                    let index = proc_macro2::Literal::usize_unsuffixed(index);
                    self.coefficients(element, &quote! { #value[#index] }, inputs);
                }
            }
            Shape::Tuple(parts) => {
                for (index, part) in parts.iter().enumerate() {
                    let index = proc_macro2::Literal::usize_unsuffixed(index);
                    self.coefficients(part, &quote! { #value.#index }, inputs);
                }
            }
        }
    }

    /// The result from its coefficients.
    fn build(&self, shape: &Shape, values: &mut dyn Iterator<Item = &TokenStream>) -> TokenStream {
        match shape {
            Shape::Scalar => values.next().cloned().unwrap_or_default(),
            Shape::Type(index) => self.member(&self.definition.types[*index], values),
            Shape::Array(element, count) => {
                let parts: Vec<_> = (0..*count).map(|_| self.build(element, values)).collect();
                quote! { [#(#parts),*] }
            }
            Shape::Tuple(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| self.build(part, values)).collect();
                quote! { (#(#parts,)*) }
            }
        }
    }

    fn member(
        &self,
        kind: &TypeDefinition,
        values: &mut dyn Iterator<Item = &TokenStream>,
    ) -> TokenStream {
        let (path, name) = (self.path, &kind.name);
        if kind.is_constant() {
            return quote! { #path::#name };
        }
        if let Some(parameters) = &kind.parameters {
            let fields = parameters.list.iter().map(|parameter| {
                let (field, value) = (&parameter.name, self.build(&parameter.shape(), values));
                quote! { #field: #value }
            });
            return quote! { #path::#name { #(#fields),* } };
        }
        let fields: Vec<_> = values.take(kind.stored().count()).collect();
        let constructor = if kind.facts_are_implied {
            format_ident!("new")
        } else {
            format_ident!("new_unchecked")
        };
        quote! { #path::#name::#constructor(#(#fields),*) }
    }
}

/// The struct that holds the values that a function computes once from its uniform operands.
struct Prepared<'a> {
    function: &'a Ident,
    visibility: &'a Visibility,
    name: Ident,
    fields: Vec<Ident>,
}

impl<'a> Prepared<'a> {
    fn new(compiled: &'a CompiledFunction, function: &'a Ident, count: usize) -> Self {
        let name = function.unraw().to_string().to_upper_camel_case();
        Self {
            function,
            visibility: &compiled.visibility,
            name: format_ident!("{name}", span = function.span()),
            fields: (0..count).map(|k| format_ident!("c{k}")).collect(),
        }
    }

    /// The declaration, with a method that converts it to another scalar.
    fn structure(&self) -> TokenStream {
        let Self {
            visibility,
            name,
            fields,
            ..
        } = self;
        let text = format!(
            " The values that [`{}`] computes once from its uniform operands.",
            self.function.unraw()
        );
        // A struct without fields must still mention its scalar type.
        let marker = fields
            .is_empty()
            .then(|| quote! { scalar: ::core::marker::PhantomData<S> });
        let mapped: Vec<_> = fields
            .iter()
            .map(|field| quote! { function(self.#field) })
            .collect();
        let mapped = self.value(&mapped);
        quote! {
            #[doc = #text]
            #[derive(
                ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq
            )]
            #visibility struct #name<S> { #(#fields: S,)* #marker }

            #[allow(clippy::all, clippy::pedantic, unused_variables, dead_code)]
            impl<S> #name<S> {
                /// The same over another scalar, number by number: lanes of one number each, for
                /// instance.
                #[inline(always)]
                #[must_use]
                #visibility fn map<T>(self, #[allow(unused_mut)] mut function: impl ::core::ops::FnMut(S) -> T) -> #name<T> {
                    #mapped
                }
            }
        }
    }

    /// The struct with the given values of its fields.
    fn value(&self, values: &[TokenStream]) -> TokenStream {
        let Self { name, fields, .. } = self;
        let marked = fields
            .is_empty()
            .then(|| quote! { scalar: ::core::marker::PhantomData });
        quote! { #name { #(#fields: #values,)* #marked } }
    }
}

/// The beginning of variables' names, so that they differ from all operands.
fn prefix(operands: &[Operand]) -> &'static str {
    let is_taken = |operand: &Operand| {
        let name = operand.name.to_string();
        let rest = name.strip_prefix('t');
        rest.is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    if operands.iter().any(is_taken) {
        "node"
    } else {
        "t"
    }
}
