//! Checks the basis vectors and the metric.

use syn::Expr;

use super::polynomial::constant;
use crate::algebra::{Algebra, MAX_DIMENSION, Metric, Ratio, SCALAR};
use crate::diag::Diagnostics;
use crate::parse::{BasisSyntax, MetricSyntax};

pub(super) fn check(
    basis: &BasisSyntax,
    metric: &MetricSyntax,
    diagnostics: &mut Diagnostics,
) -> Algebra {
    let mut names: Vec<String> = Vec::new();
    for ident in &basis.names {
        let name = ident.to_string();
        if name == SCALAR {
            diagnostics.error(ident.span(), "`scalar` names the scalar coefficient");
        } else if names.contains(&name) {
            diagnostics.error(
                ident.span(),
                format!("basis vector `{name}` is listed twice"),
            );
        } else if names.len() == MAX_DIMENSION {
            let message = format!("at most {MAX_DIMENSION} basis vectors are supported");
            diagnostics.error(ident.span(), message);
            break;
        } else {
            names.push(name);
        }
    }
    let metric = match metric {
        MetricSyntax::Signature(counts, span) => {
            // Saturating, so that absurd counts end in the message below.
            let sum = counts.iter().fold(0_usize, |a, &b| a.saturating_add(b));
            if sum == names.len() {
                Metric::signature(counts[0], counts[1], counts[2])
            } else {
                let message = format!(
                    "the signature counts {sum} basis vectors, but {} are named",
                    names.len()
                );
                diagnostics.error(*span, message);
                Metric::zero(names.len())
            }
        }
        MetricSyntax::Entries(entries) => check_entries(&names, entries, diagnostics),
    };
    Algebra::new(&names, metric)
}

fn check_entries(
    names: &[String],
    entries: &[(syn::Ident, syn::Ident, Expr)],
    diagnostics: &mut Diagnostics,
) -> Metric {
    let mut metric = Metric::zero(names.len());
    let mut stated: Vec<(usize, usize, Ratio)> = Vec::new();
    for (left, right, value) in entries {
        let mut place = |ident: &syn::Ident| {
            let found = names.iter().position(|name| ident == name);
            if found.is_none() {
                diagnostics.error(ident.span(), format!("unknown basis vector `{ident}`"));
            }
            found
        };
        let (row, column) = (place(left), place(right));
        let value = match constant(value) {
            Ok(value) => value,
            Err(error) => {
                diagnostics.push(error);
                continue;
            }
        };
        let (Some(row), Some(column)) = (row, column) else {
            continue;
        };
        if stated.iter().any(|&(r, c, _)| (r, c) == (row, column)) {
            let message = format!("the product `{left} * {right}` is stated twice");
            diagnostics.error(left.span(), message);
            continue;
        }
        let mirrored = stated.iter().find(|&&(r, c, _)| (r, c) == (column, row));
        if let Some(&(_, _, other)) = mirrored
            && other != value
        {
            let message = format!(
                "the metric is not symmetric: `{right} * {left}` is {other}, `{left} * {right}` is {value}"
            );
            diagnostics.error(left.span(), message);
            continue;
        }
        stated.push((row, column, value));
        metric.set(row, column, value);
    }
    metric
}
