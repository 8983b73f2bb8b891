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
    let squares = check_squares(basis, diagnostics);
    let metric = match metric {
        MetricSyntax::Signature(_, span) if !squares.is_empty() => {
            let message = "the squares stand beside the basis vectors: leave out `signature`";
            diagnostics.error(*span, message);
            Metric::zero(names.len())
        }
        MetricSyntax::Signature(counts, span) => {
            // Saturating, so that counts that overflow lead to the message below.
            let sum = counts.iter().fold(0_usize, |a, &b| a.saturating_add(b));
            if sum == names.len() {
                warn_of_order(basis, counts, diagnostics);
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
        MetricSyntax::Entries(entries) => {
            let entries: Vec<_> = squares.iter().chain(entries).collect();
            check_entries(&names, basis, &entries, diagnostics)
        }
        MetricSyntax::Squares => {
            let entries: Vec<_> = squares.iter().collect();
            check_entries(&names, basis, &entries, diagnostics)
        }
    };
    Ok(Algebra::new(&names, metric))
}

/// The squares that stand beside the vectors, as entries of the metric.
fn check_squares(basis: &BasisSyntax, diagnostics: &mut Diagnostics) -> Vec<MetricEntrySyntax> {
    let mut entries: Vec<MetricEntrySyntax> = Vec::new();
    for (name, square) in basis.names.iter().zip(&basis.squares) {
        match square {
            // A name that is listed twice has its error already.
            Some(_) if entries.iter().any(|entry| entry.left == *name) => {}
            Some(square) => entries.push(MetricEntrySyntax {
                left: name.clone(),
                right: name.clone(),
                value: square.clone(),
            }),
            None => {}
        }
    }
    for (name, square) in basis.names.iter().zip(&basis.squares) {
        if square.is_none() && !entries.is_empty() {
            let message = format!(
                "squares stand beside all basis vectors or beside none: write `{name} = 1`, or \
                 another square"
            );
            diagnostics.error(name.span(), message);
        }
    }
    entries
}

/// Warns where a signature makes another vector null than the one with the number 0, which is null
/// in other libraries.
fn warn_of_order(basis: &BasisSyntax, counts: &[usize; 3], diagnostics: &mut Diagnostics) {
    let [positive, negative, null] = *counts;
    let names: Vec<String> = basis.names.iter().map(|n| n.unraw().to_string()).collect();
    let is_zeroth = |name: &String| {
        let stem = name.strip_suffix('0');
        stem.is_some_and(|stem| names.iter().all(|other| other.starts_with(stem)))
    };
    let Some(zeroth) = names.iter().position(is_zeroth) else {
        return;
    };
    if null == 0 || zeroth >= positive + negative {
        return;
    }
    let square = |place: usize| match place {
        place if place < positive => "1",
        place if place < positive + negative => "-1",
        _ => "0",
    };
    let written = |square: &dyn Fn(usize) -> &'static str| {
        let vectors = names.iter().enumerate();
        let vectors = vectors.map(|(place, name)| format!("{name} = {}", square(place)));
        format!("basis {};", vectors.collect::<Vec<_>>().join(", "))
    };
    let null_first = written(&|place| match place {
        place if place == zeroth => "0",
        place if place < zeroth => square(place),
        place => square(place - 1),
    });
    let name = &names[zeroth];
    let message = format!(
        "`{name}² = {}` and `{}² = 0`, since a signature gives its squares in the order of the \
         names; other libraries make `{name}` null, which is `{null_first}` without `signature`, \
         while this is `{}`",
        square(zeroth),
        names[positive + negative],
        written(&square)
    );
    diagnostics.warning(basis.names[zeroth].span(), message);
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
    entries: &[&MetricEntrySyntax],
    diagnostics: &mut Diagnostics,
) -> Metric {
    let mut metric = Metric::zero(names.len());
    let mut stated: Vec<(usize, usize, Ratio)> = Vec::new();
    for &MetricEntrySyntax { left, right, value } in entries {
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
    let height = |entry: &&&MetricEntrySyntax| constant(&entry.value).map_or(0, Ratio::height);
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
