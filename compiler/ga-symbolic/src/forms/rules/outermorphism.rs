//! The action of a unit versor is an automorphism of the algebra: `M (a b) ~M = (M a ~M)(M b ~M)`,
//! since `~M M = 1`.
//!
//! It keeps grades, so it is one for every product that consists of grades of the geometric product
//! (outer and inner products), for the commutator, and for reversal and the grade involution. What
//! it leaves alone, such as infinity under motions or a scalar, may be taken for an image of
//! itself. In one direction the parts of a product are moved, in the other the whole is.

use crate::algebra::{Product, Ratio, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Outermorphism);

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    match &way.operation {
        Operation::Sandwich(versor, operand) => inwards(classes, *versor, *operand),
        Operation::Product(product, factors) => outwards(classes, *product, factors),
        Operation::Unary(unary, a) => {
            for other in classes.class(*a).ways.clone() {
                if let Operation::Sandwich(versor, operand) = other.operation
                    && is_natural(*unary)
                    && classes.is_unit(versor)
                    && let Some(part) = classes.unary(*unary, Term::of(operand), RULE)
                {
                    classes.sandwich(Term::of(versor), part, RULE);
                }
            }
        }
        _ => {}
    }
}

/// Whether a unit versor's action commutes with an operation, at least up to sign.
fn is_natural(unary: Unary) -> bool {
    match unary {
        Unary::Reverse
        | Unary::Involute
        | Unary::Conjugate
        | Unary::Dual
        | Unary::Undual
        | Unary::Grade(_) => true,
    }
}

/// The images of the parts instead of the image of the whole.
fn inwards(classes: &mut Classes<'_>, versor: ClassId, operand: ClassId) {
    if classes.class(operand).is_leaf() || !classes.is_unit(versor) {
        return;
    }
    let versor = Term::of(versor);
    for way in classes.class(operand).ways.clone() {
        match &way.operation {
            // Of a geometric product the whole is moved more cheaply.
            Operation::Product(product, factors)
                if *product != Product::Geometric
                    && (*product == Product::Wedge || !cancels(classes, factors)) =>
            {
                let images: Option<Vec<Term>> = factors
                    .iter()
                    .map(|factor| classes.sandwich(versor, Term::of(*factor), RULE))
                    .collect();
                if let Some(images) = images {
                    product_of(classes, *product, &images);
                }
            }
            Operation::Unary(unary, a) if is_natural(*unary) => {
                if let Some(image) = classes.sandwich(versor, Term::of(*a), RULE) {
                    classes.unary(*unary, image, RULE);
                }
            }
            _ => {}
        }
    }
}

/// Whether a product of the factors takes differences of them: two have a weight in common. The
/// images would be rounded before that.
pub(in crate::forms) fn cancels(classes: &Classes<'_>, factors: &[ClassId]) -> bool {
    let weights = factors.iter().filter(|id| !classes.class(**id).is_constant);
    let mut seen = Vec::new();
    for blade in weights.flat_map(|id| classes.constants(*id)) {
        if seen.contains(&blade.0) {
            return true;
        }
        seen.push(blade.0);
    }
    false
}

/// The image of the product of what all factors are images of.
fn outwards(classes: &mut Classes<'_>, product: Product, factors: &[ClassId]) {
    let mut versors: Vec<ClassId> = Vec::new();
    for factor in factors {
        for way in &classes.class(*factor).ways {
            if let Operation::Sandwich(versor, _) = way.operation
                && !versors.contains(&versor)
            {
                versors.push(versor);
            }
        }
    }
    for versor in versors {
        if !classes.is_unit(versor) {
            continue;
        }
        let mut originals = Vec::new();
        for &factor in factors {
            let Some(original) = original(classes, versor, factor) else {
                break;
            };
            originals.push(original);
        }
        if originals.len() == factors.len()
            && let Some(whole) = product_of(classes, product, &originals)
        {
            classes.sandwich(Term::of(versor), whole, RULE);
        }
    }
}

/// What a class is the image of.
fn original(classes: &mut Classes<'_>, versor: ClassId, id: ClassId) -> Option<Term> {
    let found = classes
        .class(id)
        .ways
        .iter()
        .find_map(|way| match way.operation {
            Operation::Sandwich(other, operand) if other == versor => {
                Some(Term::of(operand).scaled(way.factor))
            }
            _ => None,
        });
    if found.is_some() {
        return found;
    }
    let class = classes.class(id);
    if !class.is_constant && !classes.is_scalar(id) {
        return None;
    }
    let image = classes.sandwich(Term::of(versor), Term::of(id), RULE)?;
    (image == Term::of(id)).then_some(image)
}

fn product_of(classes: &mut Classes<'_>, product: Product, parts: &[Term]) -> Option<Term> {
    if product == Product::Wedge {
        // All factors at once, since a product of some of them may have other factors too.
        let factor = parts.iter().fold(Ratio::ONE, |all, part| all * part.factor);
        let ids: Vec<ClassId> = parts.iter().map(|part| part.class).collect();
        let is_scalar = |id: &ClassId| classes.is_scalar(*id);
        if !ids.iter().any(is_scalar) {
            let whole = classes.chain(product, &ids, RULE)?;
            return Some(whole.scaled(factor));
        }
    }
    let (first, rest) = parts.split_first()?;
    rest.iter().try_fold(*first, |whole, part| {
        classes.product(product, whole, *part, RULE)
    })
}
