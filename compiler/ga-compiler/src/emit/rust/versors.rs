//! Inverses, and for types of unit versors the constructors that check or normalise.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::arithmetic::type_of_multiples;
use super::body::{Needs, body, constant};
use super::coefficients::needs;
use super::context::{Context, fields, receiver};
use crate::algebra::{Blade, NamedBlade, Product, Ratio, Unary};
use crate::define::{Coefficient, Role, TypeDefinition};
use crate::expression::Expression;
use crate::ir::Facts;
use crate::task::Task;
use crate::verify;

pub(super) fn emit<'a>(context: &Context<'a>, kind: &'a TypeDefinition) -> TokenStream {
    if kind.is_constant() {
        return TokenStream::new();
    }
    if !kind.facts.unit_versor {
        return try_inverse(context, kind);
    }
    let mut items = inverse(context, kind);
    if !kind.facts_are_implied {
        items.extend(try_new(context, kind));
        items.extend(normalize(context, kind));
    }
    items
}

/// `x ~x` of operand 0.
fn norm() -> Expression {
    let reverse = Expression::unary(Unary::Reverse, Expression::Operand(0));
    Expression::binary(Product::Geometric, Expression::Operand(0), reverse)
}

fn inverse(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let algebra = &context.definition.algebra;
    let reverse = Expression::unary(Unary::Reverse, Expression::Operand(0));
    // The reverse is not in the type if it negates a constant coefficient.
    let stays = verify::result_fits(algebra, &[kind], &reverse, Some(kind)).is_ok();
    let result = if stays { kind } else { context.hull(kind) };
    let (code, needs) = context.compile(&[(kind, receiver())], &reverse, Some(result));
    let (path, output, bound) = (
        context.path(kind),
        context.path(result),
        context.bound(needs),
    );
    quote! {
        impl<S: #bound> #path {
            /// The inverse, which is the reverse for a unit versor.
            #[inline]
            #[must_use]
            pub fn inverse(self) -> #output { #code }
        }
    }
}

/// `~x / (x ~x)`, for types of which every member has a scalar `x ~x`.
fn try_inverse<'a>(context: &Context<'a>, kind: &'a TypeDefinition) -> TokenStream {
    let algebra = &context.definition.algebra;
    let has_scalar_norm = verify::result_fits(algebra, &[kind], &norm(), None).is_ok();
    if !has_scalar_norm {
        return TokenStream::new();
    }
    let (path, output) = (
        context.path(kind),
        context.path(type_of_multiples(context, kind)),
    );
    let field = context.bound(Needs::Field.max(needs(context, kind)));
    let runtime = context.runtime;
    quote! {
        impl<S: #field> #path {
            /// The inverse `~x / (x ~x)`, or `None` where `x ~x` is zero; of lanes, where it is
            /// zero in one of them.
            #[inline]
            #[must_use]
            pub fn try_inverse(self) -> ::core::option::Option<#output> {
                let norm = self.norm_squared();
                if !<S as #runtime::scalar::Field>::is_invertible(norm) {
                    return ::core::option::Option::None;
                }
                ::core::option::Option::Some(self.reverse() / norm)
            }
        }
    }
}

/// The type without its facts, since the argument of a caller may not satisfy them.
fn unknown(kind: &TypeDefinition) -> TypeDefinition {
    TypeDefinition {
        facts: Facts::default(),
        facts_are_implied: true,
        ..kind.clone()
    }
}

fn try_new(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let (runtime, algebra) = (context.runtime, &context.definition.algebra);
    let candidate = unknown(kind);
    let defect = Expression::difference(norm(), Expression::Constant(Ratio::ONE));
    let blades = wanted(verify::result_blades(algebra, &[&candidate], &defect));
    let kernel = Task::of_expression(algebra, &[&candidate], &defect, blades).compile();
    let arguments: Vec<_> = kind.stored().map(|c| &c.name).collect();
    // Read from the fields, since a variable of the code could be named like a blade.
    let inputs = fields(&[(kind, format_ident!("versor"))]);
    let code = body(&kernel, runtime, &inputs);
    let (statements, defects) = (code.statements, code.outputs);
    let (path, real) = (context.path(kind), quote! { #runtime::scalar::Real });
    quote! {
        impl<S: #real<Mask = ::core::primitive::bool>> #path {
            /// The unit versor with these coefficients, or `None` where some coefficient of
            /// `M ~M − 1` is larger than the tolerance, or not a number.
            #[must_use]
            pub fn try_new(
                #(#arguments: S,)* tolerance: S
            ) -> ::core::option::Option<Self> {
                let versor = Self { #(#arguments),* };
                #statements
                #runtime::__private::are_within(&[#(#defects),*], tolerance).then_some(versor)
            }
        }
    }
}

/// The check of the facts, a method of `Element`; nothing where they are implied. It runs over
/// numbers that know how large the terms are that cancel in them.
pub(super) fn facts(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    if kind.facts_are_implied || kind.is_constant() {
        return TokenStream::new();
    }
    let (runtime, name) = (context.runtime, &kind.name);
    let fields = kind.stored().map(|c| &c.name);
    let relative = quote! { #runtime::__private::Relative };
    quote! {
        fn satisfies_facts(&self, tolerance: S) -> ::core::primitive::bool
        where
            S: #runtime::scalar::Real<Mask = ::core::primitive::bool>
        {
            #name::<#relative<S>>::try_new(
                #(#relative::new(self.#fields),)* #relative::new(tolerance)
            ).is_some()
        }
    }
}

/// With `M ~M = n + P`, n the scalar and P² = s a scalar, a unit versor near M is
/// `(n + P)^(−½) M = (M (n + r) − P M)/(r √(2 (n + r)))`, where `r = √(n² − s)`.
///
/// P is zero for rotors. For motors it is the defect of the Study condition, s is 0, and the versor
/// is `(M − P M/(2n))/√n`. Where s is not 0, this is done if P is a multiple of one blade.
fn normalize(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let algebra = &context.definition.algebra;
    let candidate = unknown(kind);
    let is_whole = kind.coefficients.iter().all(|c| c.role == Role::Stored);
    let scalar = Expression::unary(Unary::Grade(0), norm());
    let rest = Expression::difference(norm(), scalar);
    let square = Expression::binary(Product::Geometric, rest.clone(), rest.clone());
    let change = Expression::binary(Product::Geometric, rest.clone(), Expression::Operand(0));
    let squares = verify::result_blades(algebra, &[&candidate], &square);
    let is_null = squares.is_empty();
    let is_multiple_of_blade = || {
        verify::result_blades(algebra, &[&candidate], &rest).len() == 1
            && squares == [Blade::SCALAR]
    };
    let applies = is_whole
        && (is_null || is_multiple_of_blade())
        && verify::result_fits(algebra, &[&candidate], &change, Some(&candidate)).is_ok();
    let (Some(hull), true) = (kind.hull, applies) else {
        return TokenStream::new();
    };
    let square = (!is_null).then_some(square);
    normalize_body(context, &candidate, context.kind(hull), change, square)
}

fn normalize_body(
    context: &Context<'_>,
    candidate: &TypeDefinition,
    hull: &TypeDefinition,
    change: Expression,
    square: Option<Expression>,
) -> TokenStream {
    let value = format_ident!("value");
    let (taken, _) = context.compile(
        &[(hull, value.clone())],
        &Expression::Operand(0),
        Some(candidate),
    );
    let operand = [(candidate, value)];
    // The norm of a candidate, since by the facts of the type it would be 1.
    let (norm, _) = context.compile(&operand, &norm(), None);
    let (path, whole, runtime) = (context.path(candidate), context.path(hull), context.runtime);
    let (real, mask) = (
        quote! { #runtime::scalar::Real },
        quote! { #runtime::scalar::Mask },
    );
    let (formula, factors) = normalizing_factors(context, &operand, square);
    let scalars = [format_ident!("whole"), format_ident!("part")];
    let scaled = |expression, number| {
        Expression::binary(Product::Geometric, expression, Expression::Operand(number))
    };
    let nearest = Expression::difference(scaled(Expression::Operand(0), 1), scaled(change, 2));
    let (nearest, _) = context.compile_scaled(&operand, &scalars, &nearest, Some(candidate));
    let (least, most) = (
        constant(runtime, Ratio::ONE / Ratio::integer(1024)),
        constant(runtime, Ratio::integer(1024)),
    );
    let fields: Vec<_> = candidate.stored().map(|c| &c.name).collect();
    let measured = in_norm(context, candidate);
    let name = &candidate.name;
    let text = format!(
        "The unit versor nearest to an element of the hull: with `M ~M = n + P`, n the scalar, it is {formula}, or a \
         coefficient of the element or of the versor is not finite. Large and small elements lose nothing. Blades that \
         `{name}` does not have are ignored."
    );
    quote! {
        #runtime::__private::surface! { { renormalized #name } }
        impl<S: #real> #path {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub fn normalize(value: #whole) -> #runtime::scalar::Maybe<Self, S> {
                let mut value: Self = { #taken };
                let mut norm = { #norm };
                let is_regular =
                    <S as #real>::less_than(#least, norm) & <S as #real>::less_than(norm, #most);
                if !#mask::all(is_regular) {
                    // The squares may have left the range of S; those of coefficients up to one do
                    // not.
                    let [#(#fields),*] = #runtime::__private::divided_by_largest(
                        is_regular,
                        [#(value.#fields),*],
                        [#(value.#measured),*],
                    );
                    value = Self { #(#fields),* };
                    norm = { #norm };
                }
                #factors
                let versor: Self = { #nearest };
                let is_finite = #(<S as #real>::is_finite(versor.#fields))&*;
                #mask::when(exists & is_finite, versor)
            }
        }
    }
}

/// The formula of `normalize`, and the statements that compute its two factors, `whole` of M and
/// `part` of `P M`, from `norm`.
fn normalizing_factors(
    context: &Context<'_>,
    operand: &[(&TypeDefinition, Ident)],
    square: Option<Expression>,
) -> (&'static str, TokenStream) {
    let runtime = context.runtime;
    let (real, field) = (
        quote! { #runtime::scalar::Real },
        quote! { #runtime::scalar::Field },
    );
    let zero = constant(runtime, Ratio::ZERO);
    if let Some(square) = square {
        let (square, _) = context.compile(operand, &square, None);
        let factors = quote! {
            let square = { #square };
            let root = <S as #real>::sqrt(norm * norm - square);
            // norm + root, without cancellation for a negative norm.
            let mut sum = norm + root;
            let is_negative = <S as #real>::less_than(norm, #zero);
            if #runtime::scalar::Mask::any(is_negative) {
                sum = #runtime::scalar::Select::select(is_negative, -square / (root - norm), sum);
            }
            let exists = <S as #real>::less_than(#zero, sum);
            let part = <S as #field>::recip(root * <S as #real>::sqrt(sum + sum));
            let whole = sum * part;
        };
        let formula = "`(M (n + r) − P M)/(r √(2 (n + r)))` with `r = √(n² − P²)`. `None` where there is none";
        (formula, factors)
    } else {
        let factors = quote! {
            let exists = <S as #real>::less_than(#zero, norm);
            let whole = <S as #field>::recip(<S as #real>::sqrt(norm));
            let part = whole * <S as #field>::recip(norm + norm);
        };
        (
            "`(M − P M/(2n))/√n`. `None` where n is not positive",
            factors,
        )
    }
}

/// The stored coefficients that `⟨x ~x⟩₀` depends on.
pub(super) fn in_norm<'a>(context: &Context<'_>, kind: &'a TypeDefinition) -> Vec<&'a Ident> {
    let algebra = &context.definition.algebra;
    let gives_scalar = |a: Blade, b: Blade| {
        let product = algebra.geometric(a, b);
        product.iter().any(|(blade, _)| *blade == Blade::SCALAR)
    };
    let matters = |a: &&Coefficient| kind.stored().any(|b| gives_scalar(a.blade, b.blade));
    kind.stored().filter(matters).map(|c| &c.name).collect()
}

fn wanted(blades: Vec<Blade>) -> Vec<NamedBlade> {
    let rising = |blade| NamedBlade {
        blade,
        is_negative: false,
    };
    blades.into_iter().map(rising).collect()
}
