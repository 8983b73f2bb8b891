//! Checks the basis vectors and the metric.

use syn::ext::IdentExt;
use syn::{Error, Ident, Result};

use super::polynomial::constant;
use crate::algebra::{Algebra, MAX_DIMENSION, Metric, Ratio, SCALAR};
use crate::diag::Diagnostics;
use crate::parse::{BasisSyntax, MetricEntrySyntax, MetricSyntax};

/// The algebra, with a metric of zeros if the declared one has errors.
///
/// # Errors
/// There are too many basis vectors, so that no blade can be read.
pub(super) fn check(
    basis: &BasisSyntax,
    metric: &MetricSyntax,
    diagnostics: &mut Diagnostics,
) -> Result<Algebra> {
    if let Some(surplus) = basis.names.get(MAX_DIMENSION) {
        let message = format!("at most {MAX_DIMENSION} basis vectors are supported");
        return Err(Error::new(surplus.span(), message));
    }
    let mut names: Vec<String> = Vec::new();
    for ident in &basis.names {
        let name = ident.unraw().to_string();
        if name == SCALAR {
            diagnostics.error(ident.span(), "`scalar` names the scalar coefficient");
        } else if names.contains(&name) {
            diagnostics.error(
                ident.span(),
                format!("basis vector `{name}` is listed twice"),
            );
        } else {
            names.push(name);
        }
    }
    let metric = match metric {
        MetricSyntax::Signature(counts, span) => {
            // Saturating, so that counts that overflow lead to the message below.
            let sum = counts.iter().fold(0_usize, |a, &b| a.saturating_add(b));
            if sum == names.len() {
                Metric::signature(counts[0], counts[1], counts[2])
            } else {
                let named = basis.names.len();
                if sum != named {
                    let message = format!(
                        "the signature counts {sum} basis vectors, but {named} are named; \
                         its squares go to the names as they are written{}",
                        assigned(&names, counts)
                    );
                    diagnostics.error(*span, message);
                }
                Metric::zero(names.len())
            }
        }
        MetricSyntax::Entries(entries) => check_entries(&names, basis, entries, diagnostics),
    };
    Ok(Algebra::new(&names, metric))
}

/// The squares that a signature gives to the names, as far as both go.
fn assigned(names: &[String], [positive, negative, null]: &[usize; 3]) -> String {
    let squares = [(*positive, "1"), (*negative, "-1"), (*null, "0")];
    let squares = squares
        .into_iter()
        .flat_map(|(count, square)| std::iter::repeat_n(square, count.min(MAX_DIMENSION)));
    let texts: Vec<String> = names
        .iter()
        .zip(squares)
        .map(|(name, square)| format!("{name}² = {square}"))
        .collect();
    if texts.is_empty() {
        return String::new();
    }
    format!(": {}", texts.join(", "))
}

fn check_entries(
    names: &[String],
    basis: &BasisSyntax,
    entries: &[MetricEntrySyntax],
    diagnostics: &mut Diagnostics,
) -> Metric {
    let mut metric = Metric::zero(names.len());
    let mut stated: Vec<(usize, usize, Ratio)> = Vec::new();
    for MetricEntrySyntax { left, right, value } in entries {
        let mut place = |ident: &Ident| {
            let found = names.iter().position(|name| ident.unraw() == name);
            // Errors in the list of basis vectors have been reported there.
            if found.is_none() && !basis.names.contains(ident) {
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
        let entry = quote::quote!(#left * #right);
        if stated.iter().any(|&(r, c, _)| (r, c) == (row, column)) {
            diagnostics.error_at(entry, format!("`{left} * {right}` is stated twice"));
            continue;
        }
        let mirrored = stated.iter().find(|&&(r, c, _)| (r, c) == (column, row));
        if let Some(&(_, _, other)) = mirrored
            && other != value
        {
            let message = format!(
                "the metric is not symmetric: `{right} * {left}` is {other}, `{left} * {right}` is {value}"
            );
            diagnostics.error_at(entry, message);
            continue;
        }
        stated.push((row, column, value));
        metric.set(row, column, value);
    }
    let height = |entry: &&MetricEntrySyntax| constant(&entry.value).map_or(0, Ratio::height);
    if !metric.products_fit()
        && let Some(largest) = entries.iter().max_by_key(height)
    {
        let message =
            "the numbers of the metric are too large: products of blades would not fit 64 bits";
        diagnostics.error_at(&largest.value, message);
        return Metric::zero(names.len());
    }
    metric
}
