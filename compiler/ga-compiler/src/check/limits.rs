//! Bounds on declarations, within which an expansion takes at most about two seconds and 500 MB
//! with an optimised compiler.

use syn::{Error, Result};

use crate::algebra::{Algebra, Product};
use crate::define::{Operation, TypeDefinition};
use crate::parse::{ProductSyntax, TypeSyntax};

/// The largest number of types.
const MAX_TYPES: usize = 128;

/// The largest sum of the squares of the numbers of blades: methods of a type take time with the
/// square of that number at least.
const MAX_SQUARES: usize = 1 << 17;

/// The largest number of products.
const MAX_PRODUCTS: usize = 1 << 13;

/// The largest number of terms of all products together: products of two basis blades, each as
/// often as it has blades.
pub(super) const MAX_TERMS: usize = 1 << 17;

/// Up to how many pairs of blades the terms of a product need not be counted.
const FEW_PAIRS: usize = 1 << 10;

/// Checks how many types there are, and of how many blades.
///
/// # Errors
/// The first type beyond a bound.
pub(super) fn check_types(types: &[TypeSyntax]) -> Result<()> {
    if let Some(surplus) = types.get(MAX_TYPES) {
        let message = format!("an algebra has at most {MAX_TYPES} types");
        return Err(Error::new(surplus.name.span(), message));
    }
    let mut sum = 0_usize;
    for kind in types {
        let count = kind.coefficients.len();
        sum = sum.saturating_add(count.saturating_mul(count));
        if sum > MAX_SQUARES {
            let message = format!(
                "the types have too many blades: the squares of their numbers may have the sum \
                 {MAX_SQUARES}, that of two types of 256 blades"
            );
            return Err(Error::new(kind.name.span(), message));
        }
    }
    Ok(())
}

/// Checks how many products there are.
///
/// # Errors
/// The first line beyond the bound.
pub(super) fn check_products(products: &[ProductSyntax]) -> Result<()> {
    let mut sum = 0_usize;
    for line in products {
        let choices = line.operands.iter().map(Vec::len);
        sum = sum.saturating_add(choices.fold(1, usize::saturating_mul));
        if sum > MAX_PRODUCTS {
            let message = format!("an algebra has at most {MAX_PRODUCTS} products");
            return Err(Error::new(line.operation.span(), message));
        }
    }
    Ok(())
}

/// How many terms a product has, counted up to a bound above the largest number.
pub(super) fn terms(
    algebra: &Algebra,
    operation: Operation,
    operands: &[&TypeDefinition],
) -> usize {
    let blades = |kind: &TypeDefinition| kind.coefficients.len();
    let [left, right] = operands else {
        return operands.iter().map(|kind| blades(kind)).sum();
    };
    let pairs = blades(left) * blades(right);
    if pairs <= FEW_PAIRS {
        return pairs;
    }
    let (product, actions) = match operation {
        // Two products, one after the other.
        Operation::Sandwich => (Product::Geometric, 2),
        Operation::Product(product) => (product, 1),
        Operation::Unary(_) => return pairs,
    };
    let mut count = 0;
    for a in &left.coefficients {
        for b in &right.coefficients {
            count += actions * product.of_blades(algebra, a.blade, b.blade).len();
            if count > MAX_TERMS {
                return count;
            }
        }
    }
    count
}
