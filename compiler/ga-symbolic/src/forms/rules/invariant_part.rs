//! A unit versor leaves scalars alone: `M ⟨X⟩₀ ~M = ⟨X⟩₀ M ~M = ⟨X⟩₀`. So only the rest of an X
//! with a scalar part is moved: `M X ~M = ⟨X⟩₀ + M (X − ⟨X⟩₀) ~M`. The same holds for any other
//! grade that turns out to be left alone, as the pseudoscalar is by an even versor.

use crate::algebra::Unary;
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::InvariantPart);

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    let Operation::Sandwich(versor, operand) = way.operation else {
        return;
    };
    let grades = classes.grades(operand);
    let top = 1 << classes.algebra.dimension();
    if grades.count_ones() < 2 || grades & (1 | top) == 0 || !classes.is_unit(versor) {
        return;
    }
    let versor = Term::of(versor);
    let (mut kept, mut moved) = (Vec::new(), Vec::new());
    for grade in (0..u32::BITS).filter(|grade| grades & 1 << grade != 0) {
        let Some(part) = classes.unary(Unary::Grade(grade), Term::of(operand), RULE) else {
            continue;
        };
        let is_kept =
            (1_u32 << grade) & (1 | top) != 0 && classes.sandwich(versor, part, RULE) == Some(part);
        if is_kept {
            kept.push(part)
        } else {
            moved.push(part)
        }
    }
    if kept.is_empty() {
        return;
    }
    if let Some(rest) = classes.sum(&moved, RULE)
        && let Some(image) = classes.sandwich(versor, rest, RULE)
    {
        kept.push(image);
    }
    classes.sum(&kept, RULE);
}
