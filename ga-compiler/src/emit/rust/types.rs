//! The struct of a type, its constructors and accessors, and how it prints.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::body::{body, constant};
use super::context::{Context, receiver};
use super::versors;
use crate::algebra::{Blade, NamedBlade, Ratio};
use crate::define::{Coefficient, PolynomialStep, Role, TypeDefinition};
use crate::expression::Expression;
use crate::task::Task;

pub(super) fn emit(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    if kind.is_constant() {
        return constant_type(kind);
    }
    let parts = [
        structure(kind),
        constructor(context, kind),
        versors::emit(context, kind),
        accessors(context, kind),
        default(context, kind),
        element(context, kind),
    ];
    parts.into_iter().collect()
}

fn constant_type(kind: &TypeDefinition) -> TokenStream {
    let (docs, name, table) = (&kind.docs, &kind.name, coefficients_text(kind));
    quote! {
        #docs
        #[doc = ""]
        #[doc = #table]
        #[derive(
            ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq,
            ::core::default::Default
        )]
        pub struct #name;
    }
}

fn structure(kind: &TypeDefinition) -> TokenStream {
    let (docs, name, table) = (&kind.docs, &kind.name, coefficients_text(kind));
    let fields = kind.stored().map(|c| {
        let (field, text) = (&c.name, format!("Coefficient of `{}`.", c.name));
        // The fields of a type with facts are private; other types are used by their fields.
        let visibility = kind.is_linear().then(|| quote! { pub });
        quote! { #[doc = #text] #visibility #field: S }
    });
    quote! {
        #docs
        #[doc = ""]
        #[doc = #table]
        #[derive(
            ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq
        )]
        #[repr(C)]
        pub struct #name<S> { #(#fields),* }
    }
}

/// One line that says where each coefficient comes from.
fn coefficients_text(kind: &TypeDefinition) -> String {
    let name = |index: usize| kind.coefficients[index].name.to_string();
    let entries: Vec<_> = kind
        .coefficients
        .iter()
        .map(|c| match &c.role {
            Role::Stored => format!("`{}`", c.name),
            Role::Constant(value) => format!("`{} = {value}`", c.name),
            Role::Derived(polynomial) => format!("`{} = {}`", c.name, polynomial.to_text(&name)),
        })
        .collect();
    format!("Coefficients: {}.", entries.join(", "))
}

/// `new`, where any coefficients make a member.
fn constructor(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    if !kind.facts_are_implied {
        return TokenStream::new();
    }
    let name = format_ident!("new");
    build_from_stored(
        context,
        kind,
        &name,
        "The member with these stored coefficients.",
    )
}

/// `new_unchecked`, where some coefficients make no member. It comes last on the page of a type,
/// since the other constructors check.
pub(super) fn unchecked_constructor(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    if kind.facts_are_implied {
        return TokenStream::new();
    }
    let name = format_ident!("new_unchecked");
    let text = "The member with these stored coefficients. The caller makes sure that the facts of the type hold; products of anything else are wrong.";
    build_from_stored(context, kind, &name, text)
}

fn build_from_stored(
    context: &Context<'_>,
    kind: &TypeDefinition,
    name: &Ident,
    text: &str,
) -> TokenStream {
    let path = context.path(kind);
    let fields: Vec<_> = kind.stored().map(|c| &c.name).collect();
    quote! {
        impl<S> #path {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub const fn #name(#(#fields: S),*) -> Self {
                Self { #(#fields),* }
            }
        }
    }
}

fn accessors(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let path = context.path(kind);
    let runtime = context.runtime;
    let methods = kind.coefficients.iter().map(|c| {
        let name = &c.name;
        let (bound, value, text) = match &c.role {
            // Public fields need no accessors.
            Role::Stored if kind.is_linear() => return TokenStream::new(),
            Role::Stored => (
                quote! { ::core::marker::Copy },
                quote! { self.#name },
                format!("Coefficient of `{name}`."),
            ),
            Role::Constant(value) => (
                context.bound(!value.is_integer()),
                constant(runtime, *value),
                format!("Coefficient of `{name}`, which is always {value}."),
            ),
            Role::Derived(polynomial) => {
                let (value, needs_field) = coefficient_body(context, kind, c);
                let lookup = |index: usize| kind.coefficients[index].name.to_string();
                let formula = polynomial.to_text(&lookup);
                (
                    context.bound(needs_field),
                    value,
                    format!("Coefficient of `{name}`, which follows: `{formula}`."),
                )
            }
        };
        quote! {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub fn #name(&self) -> S where S: #bound {
                #value
            }
        }
    });
    quote! { impl<S> #path { #(#methods)* } }
}

/// The coefficient of a blade as declared, computed from `self`.
fn coefficient_body(
    context: &Context<'_>,
    kind: &TypeDefinition,
    coefficient: &Coefficient,
) -> (TokenStream, bool) {
    let wanted = vec![NamedBlade {
        blade: coefficient.blade,
        is_negative: coefficient.is_negative,
    }];
    let (algebra, operand) = (&context.definition.algebra, Expression::Operand(0));
    let kernel = Task::of_expression(algebra, &[kind], &operand, wanted).compile();
    let inputs = super::context::fields(&[(kind, receiver())]);
    let body = body(&kernel, context.runtime, &inputs);
    let (statements, output) = (body.statements, &body.outputs[0]);
    (quote! { #statements #output }, body.needs_field)
}

/// Whether some coefficient of the type is computed with a fraction, so that its scalar must be a
/// field.
pub(super) fn needs_field(context: &Context<'_>, kind: &TypeDefinition) -> bool {
    kind.coefficients.iter().any(|c| match &c.role {
        Role::Stored => false,
        Role::Constant(value) => !value.is_integer(),
        Role::Derived(_) => coefficient_body(context, kind, c).1,
    })
}

/// The identity for unit versors with a scalar, else the member whose stored coefficients are zero,
/// which is the origin for a point. A type without such a member has no default.
fn default(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let stored = |c: &Coefficient| {
        let is_identity = kind.facts.unit_versor && c.blade == Blade::SCALAR;
        if is_identity { Ratio::ONE } else { Ratio::ZERO }
    };
    let is_member = kind.facts_are_implied || is_identity(kind, &stored);
    if !is_member {
        return TokenStream::new();
    }
    let (path, ring) = (context.path(kind), context.bound(false));
    let values: Vec<_> = kind
        .stored()
        .map(|c| constant(context.runtime, stored(c)))
        .collect();
    let built = context.build(Some(kind), &values);
    quote! {
        impl<S: #ring> ::core::default::Default for #path {
            #[inline]
            fn default() -> Self { #built }
        }
    }
}

/// Whether the member with these stored coefficients is 1.
pub(super) fn is_identity(kind: &TypeDefinition, stored: &dyn Fn(&Coefficient) -> Ratio) -> bool {
    let value = |c: &Coefficient| match &c.role {
        Role::Stored => stored(c),
        Role::Constant(value) => *value,
        Role::Derived(polynomial) => polynomial.evaluate(
            &mut |value| value,
            &mut |index| stored(&kind.coefficients[index]),
            &mut |step, a, b| match step {
                PolynomialStep::Sum => a + b,
                PolynomialStep::Product => a * b,
            },
        ),
    };
    let has_scalar = kind.coefficients.iter().any(|c| c.blade == Blade::SCALAR);
    let is_expected = |c: &Coefficient| match c.blade {
        Blade::SCALAR => value(c) == Ratio::ONE,
        _ => value(c).is_zero(),
    };
    has_scalar && kind.coefficients.iter().all(is_expected)
}

/// The type as a list of coefficients by blade, in rising order of vectors.
fn element(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let (path, runtime) = (context.path(kind), context.runtime);
    let usize = quote! { ::core::primitive::usize };
    let arms: Vec<_> = kind
        .coefficients
        .iter()
        .map(|c| {
            let (name, blade) = (&c.name, c.blade.0 as usize);
            let sign = c.is_negative.then(|| quote! { - });
            // Stored coefficients of linear types have no accessor.
            let call = (c.role != Role::Stored).then(|| quote! { () });
            quote! { #blade => #sign self.#name #call }
        })
        .collect();
    let values: Vec<_> = kind
        .stored()
        .map(|c| {
            let blade = c.blade.0 as usize;
            let sign = c.is_negative.then(|| quote! { - });
            quote! { #sign coefficient(#blade) }
        })
        .collect();
    let built = context.build(Some(kind), &values);
    let bound = context.bound(needs_field(context, kind));
    let blades = kind.coefficients.iter().map(|c| c.blade.0 as usize);
    let names = kind.coefficients.iter().map(|c| c.name.unraw().to_string());
    let mut reversed = kind
        .coefficients
        .iter()
        .filter(|c| c.is_negative)
        .map(|c| c.blade.0 as usize)
        .peekable();
    let reversed = reversed.peek().is_some().then(|| {
        let reversed = reversed.clone();
        quote! { const REVERSED: &'static [#usize] = &[#(#reversed),*]; }
    });
    let type_name = kind.name.unraw().to_string();
    let facts = versors::facts(context, kind);
    let (unit_versor, free) = (kind.facts.unit_versor, kind.facts_are_implied);
    let zero = constant(runtime, Ratio::ZERO);
    quote! {
        impl<S: #bound> #runtime::Element for #path {
            type Scalar = S;
            const NAME: &'static ::core::primitive::str = #type_name;
            const BASIS: &'static [&'static ::core::primitive::str] = BASIS;
            const BLADES: &'static [#usize] = &[#(#blades),*];
            const NAMES: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            #reversed
            const IS_UNIT_VERSOR: ::core::primitive::bool = #unit_versor;
            const IS_FREE: ::core::primitive::bool = #free;
            const METRIC: &'static [&'static [(::core::primitive::i64, ::core::primitive::i64)]] = METRIC;
            fn coefficient(&self, blade: #usize) -> S {
                match blade { #(#arms,)* _ => #zero }
            }
            fn from_coefficients_unchecked(
                coefficient: &mut dyn ::core::ops::FnMut(#usize) -> S
            ) -> Self {
                #built
            }
            #facts
        }
    }
}
