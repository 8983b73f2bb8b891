//! Joins of differences: `a ∧ b = a ∧ (b − λ a)`, since `a ∧ a = 0`.
//!
//! With λ the quotient of two constant coefficients, such as the weights of points, that
//! coefficient is gone from all factors but the first. The difference is taken before anything is
//! rounded, so that afterwards the factors can be moved apart. As [`JoinRule::Difference`] does
//! within one product, for what acts on the product.
//!
//! In a product of images `M a ~M ∧ M b ~M` the second factor is the sum of the first and of a
//! moved difference: `M b ~M = λ M a ~M + M (b − λ a) ~M`, since an action is linear. Where the
//! type of the factors determines some coefficients by others, only the others of the moved
//! difference are needed. Where the first factor is subtracted again, it cancels before anything is
//! rounded.
//!
//! [`JoinRule::Difference`]: crate::lower::JoinRule::Difference

use crate::algebra::{Product, Ratio};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Difference);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    let Operation::Product(Product::Wedge, factors) = &way.operation else {
        return;
    };
    of_images(classes, factors);
    let is_vector = |id: &ClassId| classes.grade(*id) == Some(1) && !classes.class(*id).is_constant;
    let Some(&first) = factors.iter().find(|id| is_vector(id)) else {
        return;
    };
    // Only what acts on the product gains.
    if !classes.is_moved(id) {
        return;
    }
    let Some(&(blade, weight)) = classes.constants(first).first() else {
        return;
    };
    let mut whole: Option<Term> = None;
    let mut has_changed = false;
    for &factor in factors {
        let other = classes
            .constants(factor)
            .into_iter()
            .find(|(other, _)| *other == blade);
        let next = match other {
            Some((_, other)) if factor != first && classes.grade(factor) == Some(1) => {
                has_changed = true;
                let multiple = Term::of(first).scaled(-(other / weight));
                match classes.sum(&[Term::of(factor), multiple], RULE) {
                    Some(difference) => difference,
                    None => return,
                }
            }
            _ => Term::of(factor),
        };
        whole = match whole {
            None => Some(next),
            Some(whole) => classes.product(Product::Wedge, whole, next, RULE),
        };
        if whole.is_none() || !has_changed && factor == factors[factors.len() - 1] {
            return;
        }
    }
}

/// The first image among the factors that has a constant coefficient, with that coefficient, and
/// the other images that have one of the same blade.
pub(in crate::forms) struct Images {
    pub(in crate::forms) first: ClassId,
    weight: Ratio,
    pub(in crate::forms) others: Vec<(ClassId, Ratio)>,
}

impl Images {
    pub(in crate::forms) fn of(classes: &Classes<'_>, factors: &[ClassId]) -> Option<Self> {
        let is_image = |id: &&ClassId| !classes.class(**id).is_constant && classes.has_action(**id);
        let mut images = factors.iter().filter(is_image);
        let (first, blade, weight) = images.find_map(|id| {
            let (blade, weight) = classes.constants(*id).first().copied()?;
            (classes.grade(*id) == Some(1)).then_some((*id, blade, weight))
        })?;
        let others = images.filter_map(|id| {
            let mut constants = classes.constants(*id).into_iter();
            let (_, weight) = constants.find(|(other, _)| *other == blade)?;
            (classes.grade(*id) == Some(1)).then_some((*id, weight))
        });
        let others = others.collect();
        Some(Self {
            first,
            weight,
            others,
        })
    }
}

/// Each image after the first as a sum of that and of a moved difference.
fn of_images(classes: &mut Classes<'_>, factors: &[ClassId]) {
    let Some(images) = Images::of(classes, factors) else {
        return;
    };
    let actions = |classes: &Classes<'_>, id: ClassId| -> Vec<(ClassId, Term)> {
        let ways = classes.class(id).ways.iter();
        ways.filter_map(|way| match way.operation {
            Operation::Sandwich(versor, operand) => {
                Some((versor, Term::of(operand).scaled(way.factor)))
            }
            _ => None,
        })
        .collect()
    };
    let firsts = actions(classes, images.first);
    for (other, weight) in images.others {
        let multiple = weight / images.weight;
        for (versor, operand) in actions(classes, other) {
            let Some((_, first)) = firsts.iter().find(|(first, _)| *first == versor) else {
                continue;
            };
            if let Some(difference) = classes.sum(&[operand, first.scaled(-multiple)], RULE)
                && let Some(moved) = classes.sandwich(Term::of(versor), difference, RULE)
            {
                classes.sum_of(&[Term::of(images.first).scaled(multiple), moved], RULE);
            }
        }
    }
}
