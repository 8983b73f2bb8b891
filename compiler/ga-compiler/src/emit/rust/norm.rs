//! The squared norm `⟨x ~x⟩₀` of a type, and in words what sign it has.

use proc_macro2::TokenStream;
use quote::quote;
use syn::ext::IdentExt;

use super::context::{Context, receiver};
use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::define::{Coefficient, TypeDefinition};
use crate::expression::Expression;
use crate::ir::Facts;
use crate::verify;

pub(super) fn emit(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let norm = norm();
    // By the facts of a versor this is 1; callers want to know how far rounding has changed it.
    let without_facts = TypeDefinition {
        facts: Facts::default(),
        ..kind.clone()
    };
    let (body, needs) = context.compile(&[(&without_facts, receiver())], &norm, None);
    let (path, bound) = (context.path(kind), context.bound(needs));
    let sign = sign(context, kind);
    quote! {
        impl<S: #bound> #path {
            /// `⟨x ~x⟩₀`, computed from the coefficients without regard to the facts of the type.
            #[doc = ""]
            #[doc = #sign]
            #[inline]
            #[must_use]
            pub fn norm_squared(self) -> S { #body }
        }
    }
}

/// `⟨x ~x⟩₀` of operand 0.
fn norm() -> Expression {
    let reverse = Expression::unary(Unary::Reverse, Expression::Operand(0));
    Expression::binary(Product::ScalarProduct, Expression::Operand(0), reverse)
}

/// Which sign the squared norm of a member has.
fn sign(context: &Context<'_>, kind: &TypeDefinition) -> String {
    if kind.facts.unit_versor {
        return "It is 1 for every member, up to rounding.".to_owned();
    }
    let algebra = &context.definition.algebra;
    if verify::result_blades(algebra, &[kind], &norm()).is_empty() {
        return "It is zero for every member.".to_owned();
    }
    if !kind.is_linear() {
        return String::new();
    }
    let form = Form::of(context, kind);
    let formula = form
        .formula(kind)
        .map_or_else(String::new, |formula| format!(" It is `{formula}`."));
    let (positive, negative) = form.inertia();
    let zero = positive + negative < form.rows.len();
    let sign = match (positive > 0, negative > 0, zero) {
        (_, false, false) => "It is positive for every element except zero.",
        (_, false, true) => "It is never negative, and zero for some elements other than zero.",
        (false, true, false) => "It is negative for every element except zero.",
        (false, true, true) => "It is never positive, and zero for some elements other than zero.",
        (true, true, _) => {
            "It is positive for some elements, negative for others, and zero for null ones."
        }
    };
    format!("{sign}{formula}")
}

/// The symmetric bilinear form `⟨a ~b⟩₀` on the blades of a type.
struct Form {
    rows: Vec<Vec<Ratio>>,
}

impl Form {
    fn of(context: &Context<'_>, kind: &TypeDefinition) -> Self {
        let algebra = &context.definition.algebra;
        let entry = |a: &Coefficient, b: &Coefficient| {
            let product = algebra.geometric(a.blade, b.blade);
            let scalar = product.iter().find(|(blade, _)| *blade == Blade::SCALAR);
            let value = scalar.map_or(Ratio::ZERO, |(_, value)| *value);
            let is_negative = a.is_negative ^ b.is_negative ^ b.blade.reverse_is_negative();
            if is_negative { -value } else { value }
        };
        let row = |a| kind.coefficients.iter().map(|b| entry(a, b)).collect();
        Self {
            rows: kind.coefficients.iter().map(row).collect(),
        }
    }

    /// The numbers of positive and of negative squares in a diagonal form.
    fn inertia(&self) -> (usize, usize) {
        let mut rows = self.rows.clone();
        let (mut positive, mut negative) = (0, 0);
        while let Some((i, j)) = pivot(&rows) {
            if i != j {
                // With x_i + x_j for x_i, the diagonal entry is 2 a_ij.
                let added = rows[j].clone();
                for (entry, other) in rows[i].iter_mut().zip(added) {
                    *entry = *entry + other;
                }
                for row in &mut rows {
                    row[i] = row[i] + row[j];
                }
            }
            let pivot = rows[i][i];
            if pivot.is_negative() {
                negative += 1;
            } else {
                positive += 1;
            }
            let eliminated = rows[i].clone();
            for row in &mut rows {
                let factor = row[i] / pivot;
                for (entry, other) in row.iter_mut().zip(&eliminated) {
                    *entry = *entry - factor * *other;
                }
            }
        }
        (positive, negative)
    }

    /// The form as a polynomial, if it is short.
    fn formula(&self, kind: &TypeDefinition) -> Option<String> {
        const MOST_TERMS: usize = 6;
        let name = |k: usize| kind.coefficients[k].name.unraw().to_string();
        let mut text = String::new();
        let mut terms = 0;
        for (i, row) in self.rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate().skip(i) {
                let value = if i == j { *entry } else { *entry + *entry };
                if value.is_zero() {
                    continue;
                }
                terms += 1;
                let sign = match (text.is_empty(), value.is_negative()) {
                    (true, false) => "",
                    (true, true) => "−",
                    (false, false) => " + ",
                    (false, true) => " − ",
                };
                let size = match value.abs() {
                    Ratio::ONE => String::new(),
                    size => format!("{size} "),
                };
                let factors = if i == j {
                    format!("{}²", name(i))
                } else {
                    format!("{} {}", name(i), name(j))
                };
                text += &format!("{sign}{size}{factors}");
            }
        }
        (terms <= MOST_TERMS).then_some(text)
    }
}

/// A diagonal entry that is not zero, else any entry that is not.
fn pivot(rows: &[Vec<Ratio>]) -> Option<(usize, usize)> {
    let places = || (0..rows.len()).flat_map(|i| (i..rows.len()).map(move |j| (i, j)));
    let is_present = |&(i, j): &(usize, usize)| !rows[i][j].is_zero();
    let diagonal = places().filter(|(i, j)| i == j).find(is_present);
    diagonal.or_else(|| places().find(is_present))
}
