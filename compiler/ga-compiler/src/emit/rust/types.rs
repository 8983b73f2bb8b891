//! The struct of a type, its constructors and accessors, and how it prints.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::body::{Needs, constant};
use super::coefficients::{coefficient_body, needs};
use super::context::Context;
use super::versors;
use crate::algebra::{Blade, Ratio};
use crate::define::{Coefficient, Parameter, Parameters, PolynomialStep, Role, TypeDefinition};
use crate::expression::Expression;
use crate::ir::Facts;
use crate::verify;

pub(super) fn emit<'a>(context: &Context<'a>, kind: &'a TypeDefinition) -> TokenStream {
    if kind.is_constant() {
        return constant_type(kind);
    }
    let mut items: TokenStream = [
        structure(context, kind),
        constructor(context, kind),
        versors::emit(context, kind),
        accessors(context, kind),
        default(context, kind),
    ]
    .into_iter()
    .collect();
    if kind.is_readable() {
        items.extend(element(context, kind));
    }
    items
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

fn structure(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let (docs, name, table) = (&kind.docs, &kind.name, coefficients_text(kind));
    if let Some(parameters) = &kind.parameters {
        let fields = parameters.list.iter().map(|parameter| {
            let (field, path) = (&parameter.name, parameter_path(context, parameter));
            let text = format!("The parameter `{field}`.");
            quote! { #[doc = #text] pub #field: #path }
        });
        return quote! {
            #docs
            #[doc = ""]
            #[doc = #table]
            #[derive(
                ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug,
                ::core::cmp::PartialEq
            )]
            #[repr(C)]
            pub struct #name<S> { #(#fields),* }
        };
    }
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

/// The type of a parameter in Rust.
fn parameter_path(context: &Context<'_>, parameter: &Parameter) -> TokenStream {
    context.result_path(parameter.index.map(|_| &parameter.kind))
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
        match kind.parameters {
            None => "The member with these stored coefficients.",
            Some(_) => "The member with these parameters.",
        },
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
    let (fields, paths): (Vec<&Ident>, Vec<TokenStream>) = match &kind.parameters {
        None => kind.stored().map(|c| (&c.name, quote! { S })).unzip(),
        Some(parameters) => {
            let list = parameters.list.iter();
            list.map(|p| (&p.name, parameter_path(context, p))).unzip()
        }
    };
    quote! {
        impl<S> #path {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub const fn #name(#(#fields: #paths),*) -> Self {
                Self { #(#fields),* }
            }
        }
    }
}

fn accessors(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    // Those of a type by parameters are read of its hull.
    if kind.parameters.is_some() {
        return TokenStream::new();
    }
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
                context.bound(match value.is_integer() {
                    true => Needs::Ring,
                    false => Needs::Field,
                }),
                constant(runtime, *value),
                format!("Coefficient of `{name}`, which is always {value}."),
            ),
            Role::Derived(polynomial) => {
                let (value, needs) = coefficient_body(context, kind, c);
                let lookup = |index: usize| kind.coefficients[index].name.to_string();
                let formula = polynomial.to_text(&lookup);
                (
                    context.bound(needs),
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
    if let Some(parameters) = &kind.parameters {
        return default_of_parameters(context, kind, parameters);
    }
    let (path, ring) = (context.path(kind), context.bound(Needs::Ring));
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

/// The member of the default parameters, zero for a number, if the types of all have one.
fn default_of_parameters(
    context: &Context<'_>,
    kind: &TypeDefinition,
    parameters: &Parameters,
) -> TokenStream {
    let has_default = |p: &Parameter| p.index.is_none() || !default(context, &p.kind).is_empty();
    if !parameters.list.iter().all(has_default) {
        return TokenStream::new();
    }
    let (path, ring) = (context.path(kind), context.bound(Needs::Ring));
    let fields = parameters.list.iter().map(|parameter| {
        let field = &parameter.name;
        let value = match parameter.index {
            None => constant(context.runtime, Ratio::ZERO),
            Some(_) => quote! { ::core::default::Default::default() },
        };
        quote! { #field: #value }
    });
    quote! {
        impl<S: #ring> ::core::default::Default for #path {
            #[inline]
            fn default() -> Self { Self { #(#fields),* } }
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
    let zero = constant(runtime, Ratio::ZERO);
    let hull = context.hull(kind);
    let hull_path = context.path(hull);
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
    let (coefficient, built) = match kind.parameters {
        None => (
            quote! { match blade { #(#arms,)* _ => #zero } },
            context.build(Some(kind), &values),
        ),
        Some(_) => (
            quote! {
                let whole: #hull_path = ::core::convert::From::from(*self);
                #runtime::Element::coefficient(&whole, blade)
            },
            {
                let whole = format_ident!("whole");
                let identity = Expression::Operand(0);
                let (read, _) = context.compile(&[(hull, whole)], &identity, Some(kind));
                quote! {
                    let whole: #hull_path = #runtime::Element::from_coefficients_unchecked(
                        &mut |blade| match Self::BLADES.contains(&blade) {
                            true => coefficient(blade),
                            false => #zero,
                        }
                    );
                    #read
                }
            },
        ),
    };
    let bound = context.bound(needs(context, kind));
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
    let (unit_versor, free) = (kind.facts.unit_versor, is_free(context, kind));
    let numbers = kind
        .parameters
        .as_ref()
        .map(|parameters| numbers(context, parameters));
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
                #coefficient
            }
            fn from_coefficients_unchecked(
                coefficient: &mut dyn ::core::ops::FnMut(#usize) -> S
            ) -> Self {
                #built
            }
            #numbers
            #facts
        }
    }
}

/// The numbers that a member is made of, by their places: those of its parameters.
fn numbers(context: &Context<'_>, parameters: &Parameters) -> TokenStream {
    let (runtime, usize) = (context.runtime, quote! { ::core::primitive::usize });
    let element = quote! { #runtime::Element };
    let (mut arms, mut fields, mut next) = (Vec::new(), Vec::new(), 0_usize);
    for parameter in &parameters.list {
        let (field, first) = (&parameter.name, next);
        match parameter.index {
            None => {
                next += 1;
                arms.push(quote! { #first => self.#field });
                fields.push(quote! { #field: number(#first) });
            }
            Some(_) => {
                next += parameter.kind.coefficients.len();
                let last = next - 1;
                arms.push(quote! {
                    #first ..= #last => #element::number(&self.#field, place - #first)
                });
                fields.push(quote! {
                    #field: #element::from_numbers(&mut |place| number(#first + place))
                });
            }
        }
    }
    let zero = constant(runtime, Ratio::ZERO);
    quote! {
        fn number(&self, place: #usize) -> S {
            match place { #(#arms,)* _ => #zero }
        }
        fn from_numbers(number: &mut dyn ::core::ops::FnMut(#usize) -> S) -> Self {
            Self { #(#fields),* }
        }
    }
}

/// Whether any coefficients of its blades make a member.
fn is_free(context: &Context<'_>, kind: &TypeDefinition) -> bool {
    if kind.parameters.is_none() {
        return kind.facts_are_implied;
    }
    let of_blades = TypeDefinition {
        parameters: None,
        facts: Facts::default(),
        ..kind.clone()
    };
    let identity = Expression::Operand(0);
    let algebra = &context.definition.algebra;
    verify::result_fits(algebra, &[&of_blades], &identity, Some(kind)).is_ok()
}
