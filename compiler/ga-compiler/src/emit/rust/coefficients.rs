//! Coefficients of a type computed from what is stored, and what they require of the scalar.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Needs, body};
use super::context::{Context, receiver};
use crate::algebra::NamedBlade;
use crate::define::{Coefficient, Role, TypeDefinition};
use crate::expression::Expression;
use crate::task::Task;

/// The coefficient of a blade as declared, computed from `self`.
pub(super) fn coefficient_body(
    context: &Context<'_>,
    kind: &TypeDefinition,
    coefficient: &Coefficient,
) -> (TokenStream, Needs) {
    let wanted = vec![NamedBlade {
        blade: coefficient.blade,
        is_negative: coefficient.is_negative,
    }];
    let (algebra, operand) = (&context.definition.algebra, Expression::Operand(0));
    let kernel = Task::of_expression(algebra, &[kind], &operand, wanted).compile();
    let inputs = super::context::fields(&[(kind, receiver())]);
    let body = body(&kernel, context.runtime, &inputs);
    let (statements, output) = (body.statements, &body.outputs[0]);
    (quote! { #statements #output }, body.needs)
}

/// What the coefficients of the type require of the scalar, and its readings, which divide.
pub(super) fn needs(context: &Context<'_>, kind: &TypeDefinition) -> Needs {
    if kind.parameters.is_some() {
        let hull = context.hull(kind);
        let of = |from, to| {
            let (_, needs) =
                context.compile(&[(from, receiver())], &Expression::Operand(0), Some(to));
            needs
        };
        let read = match kind.is_readable() {
            true => of(hull, kind),
            false => Needs::Ring,
        };
        return of(kind, hull).max(read).max(Needs::Field);
    }
    let each = kind.coefficients.iter().map(|c| match &c.role {
        Role::Constant(value) if !value.is_integer() => Needs::Field,
        Role::Stored | Role::Constant(_) => Needs::Ring,
        Role::Derived(_) => coefficient_body(context, kind, c).1,
    });
    each.max().unwrap_or(Needs::Ring)
}
