//! Operations on classes, in a canonical form: constant factors stand outside, factors of chains
//! are flat, scalars come first, and operands of products that commute are in order.

use super::FormRule;
use super::class::{ClassId, Operation, Term};
use super::classes::Classes;
use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::ir::{Function, Number};
use crate::limit::SearchLimit;
use crate::member::{Numbers, numbers};
use crate::order::Order as _;

/// The greatest number of factors that a product is made of whose parts are products.
const MOST_FACTORS: usize = 32;

/// A class, or none where the result is zero.
pub(super) type Made = Option<Term>;

impl Classes<'_> {
    /// The class of the number 1.
    pub(super) fn one(&mut self) -> Made {
        self.blade(Blade::SCALAR)
    }

    pub(super) fn blade(&mut self, blade: Blade) -> Made {
        let points = self.points();
        let value = Numbers::from([(blade, Number::ONE)]);
        self.insert(Operation::Blade(blade), |_| vec![value; points], None)
    }

    fn points(&self) -> usize {
        self.ids()
            .next()
            .map_or(1, |first| self.class(first).values.len())
    }

    pub(super) fn unary(&mut self, unary: Unary, a: Term, rule: Option<FormRule>) -> Made {
        let operation = Operation::Unary(unary, a.class);
        let of = |classes: &Self| {
            classes.each(a.class, |value| {
                numbers::unary(classes.algebra, unary, value)
            })
        };
        self.insert(operation, of, rule)
            .map(|term| term.scaled(a.factor))
    }

    pub(super) fn coefficient(&mut self, a: Term, blade: Blade) -> Made {
        let of = |classes: &Self| {
            classes.each(a.class, |value| {
                Numbers::from([(Blade::SCALAR, numbers::coefficient(value, blade))])
            })
        };
        self.insert(Operation::Coefficient(a.class, blade), of, None)
            .map(|term| term.scaled(a.factor))
    }

    pub(super) fn quotient(&mut self, a: Term, b: Term, rule: Option<FormRule>) -> Made {
        let factor = a.factor / b.factor;
        if self.class(b.class).is_constant {
            let number = self.class(b.class).ways.first().map(|way| &way.operation);
            if number == Some(&Operation::Blade(Blade::SCALAR)) {
                return Some(Term::of(a.class).scaled(factor));
            }
        }
        if let Some(number) = self.number_within(b.class, a.class) {
            return Some(Term::of(a.class).scaled(factor / number));
        }
        // `a / (x/y) = a y / x`, also where y is zero: what is divided by infinity is zero.
        if let Some((x, y, scale)) = self.as_quotient(b.class) {
            let dividend = self.product(Product::Geometric, a, y, rule)?;
            return self.quotient(dividend, x.scaled(scale * b.factor), rule);
        }
        let of = |classes: &Self| {
            classes.each_of_two(a.class, b.class, |a, b| {
                let divisor = numbers::coefficient(b, Blade::SCALAR);
                numbers::scaled(a, divisor.recip())
            })
        };
        self.insert(Operation::Quotient(a.class, b.class), of, rule)
            .map(|term| term.scaled(factor))
    }

    /// The dividend, the divisor and the factor in front of a class that is written as a quotient.
    fn as_quotient(&self, id: ClassId) -> Option<(Term, Term, Ratio)> {
        self.class(id)
            .ways
            .iter()
            .find_map(|way| match way.operation {
                Operation::Quotient(a, b) if way.rule.is_none() => {
                    Some((Term::of(a), Term::of(b), way.factor))
                }
                _ => None,
            })
    }

    pub(super) fn function(
        &mut self,
        function: Function,
        arguments: Vec<Term>,
        values: Vec<Numbers>,
    ) -> Made {
        let mut arguments = arguments;
        let (outer, inner) = function.outer_factor(arguments[0].factor);
        arguments[0].factor = inner;
        let scale = Number::from_ratio(Ratio::ONE / outer);
        let of = |_: &Self| {
            values
                .iter()
                .map(|value| numbers::scaled(value, scale))
                .collect()
        };
        self.insert(Operation::Function(function, arguments), of, None)
            .map(|term| term.scaled(outer))
    }

    pub(super) fn sandwich(&mut self, m: Term, x: Term, rule: Option<FormRule>) -> Made {
        let factor = m.factor * m.factor * x.factor;
        let is_odd = self.parity(m.class) == Some(true);
        let of = |classes: &Self| {
            classes.each_of_two(m.class, x.class, |m, x| {
                numbers::sandwich(classes.algebra, m, is_odd, x)
            })
        };
        self.insert(Operation::Sandwich(m.class, x.class), of, rule)
            .map(|term| term.scaled(factor))
    }

    /// A sum, with the terms of sums in it.
    pub(super) fn sum(&mut self, terms: &[Term], rule: Option<FormRule>) -> Made {
        let mut flat: Vec<Term> = Vec::new();
        for &term in terms {
            match self.terms(term.class) {
                Some((inner, factor)) => {
                    flat.extend(inner.iter().map(|t| t.scaled(factor * term.factor)));
                }
                None => flat.push(term),
            }
        }
        self.sum_of(&flat, rule)
    }

    /// A sum of some terms as they are.
    pub(super) fn sum_of(&mut self, terms: &[Term], rule: Option<FormRule>) -> Made {
        let mut flat = terms.to_vec();
        flat.order_by(|a, b| self.compare(a.class, b.class));
        flat.dedup_by(|next, kept| {
            let is_same = next.class == kept.class;
            if is_same {
                kept.factor = kept.factor + next.factor;
            }
            is_same
        });
        flat.retain(|term| !term.factor.is_zero());
        match flat.as_slice() {
            [] => return None,
            [single] => return Some(*single),
            _ => {}
        }
        let all = flat.clone();
        let of = |classes: &Self| {
            let points = 0..classes.points();
            points
                .map(|point| {
                    let mut sum = Numbers::new();
                    for term in &all {
                        let factor = Number::from_ratio(term.factor);
                        for (&blade, &number) in &classes.class(term.class).values[point] {
                            numbers::add(&mut sum, blade, number * factor);
                        }
                    }
                    sum
                })
                .collect()
        };
        self.insert(Operation::Sum(flat), of, rule)
    }

    /// The terms of a class that is written as a sum, and the factor in front of it.
    pub(super) fn terms(&self, id: ClassId) -> Option<(Vec<Term>, Ratio)> {
        let class = self.class(id);
        if class.is_leaf() {
            return None;
        }
        class.ways.iter().find_map(|way| match &way.operation {
            Operation::Sum(terms) if way.rule.is_none() => Some((terms.clone(), way.factor)),
            _ => None,
        })
    }

    /// A product of two.
    pub(super) fn product(
        &mut self,
        product: Product,
        a: Term,
        b: Term,
        rule: Option<FormRule>,
    ) -> Made {
        let factor = a.factor * b.factor;
        let (mut a, mut b) = (a.class, b.class);
        let mut product = product;
        let (scalar_left, scalar_right) = (self.is_scalar(a), self.is_scalar(b));
        let (left, right) = (self.grade(a), self.grade(b));
        let is_same_grade = left.is_some() && left == right;
        match product {
            Product::Wedge if scalar_left || scalar_right => product = Product::Geometric,
            Product::LeftContraction if scalar_left => product = Product::Geometric,
            Product::RightContraction if scalar_right => product = Product::Geometric,
            Product::LeftContraction | Product::RightContraction if is_same_grade => {
                product = Product::ScalarProduct;
            }
            _ => {}
        }
        let mut factor = factor;
        if self.compare(a, b).is_gt() {
            match product {
                Product::ScalarProduct => std::mem::swap(&mut a, &mut b),
                Product::Commutator => {
                    std::mem::swap(&mut a, &mut b);
                    factor = -factor;
                }
                _ => {}
            }
        }
        if matches!(product, Product::Geometric | Product::Wedge) {
            return self
                .chain(product, &[a, b], rule)
                .map(|term| term.scaled(factor));
        }
        let of = |classes: &Self| {
            classes.each_of_two(a, b, |a, b| {
                numbers::product(classes.algebra, product, a, b)
            })
        };
        let operation = Operation::Product(product, vec![a, b]);
        self.insert(operation, of, rule)
            .map(|term| term.scaled(factor))
    }

    /// A geometric or an outer product of classes, with the factors of those that are such
    /// products.
    pub(super) fn chain(
        &mut self,
        product: Product,
        parts: &[ClassId],
        rule: Option<FormRule>,
    ) -> Made {
        let (flat, moved) = self.flat(product, parts);
        self.chain_of(product, parts, flat, moved, rule)
    }

    /// A geometric product of classes as they are, whatever they are made of.
    pub(super) fn grouped(&mut self, parts: &[ClassId], rule: Option<FormRule>) -> Made {
        self.chain_of(Product::Geometric, parts, parts.to_vec(), Ratio::ONE, rule)
    }

    /// The product of some parts, which is a multiple of that of all their factors.
    fn chain_of(
        &mut self,
        product: Product,
        parts: &[ClassId],
        flat: Vec<ClassId>,
        moved: Ratio,
        rule: Option<FormRule>,
    ) -> Made {
        let (flat, sign) = self.in_order(product, flat);
        let factor = moved * sign;
        if let [single] = flat.as_slice() {
            return Some(Term::of(*single).scaled(factor));
        }
        let of = |classes: &Self| {
            let scale = Number::from_ratio(Ratio::ONE / factor);
            let points = 0..classes.points();
            points
                .map(|point| {
                    let mut values = parts.iter().map(|id| &classes.class(*id).values[point]);
                    let first = values.next().cloned().unwrap_or_default();
                    let first = numbers::scaled(&first, scale);
                    values.fold(first, |whole, next| {
                        numbers::product(classes.algebra, product, &whole, next)
                    })
                })
                .collect()
        };
        self.insert(Operation::Product(product, flat), of, rule)
            .map(|term| term.scaled(factor))
    }

    /// The factors of some parts of a product, and the factor in front of them. Where they would be
    /// too many, as those of a square of a square of a square are, the parts themselves.
    pub(super) fn flat(&mut self, product: Product, parts: &[ClassId]) -> (Vec<ClassId>, Ratio) {
        let mut flat = Vec::new();
        let mut moved = Ratio::ONE;
        for part in parts {
            match self.factors(product, *part) {
                Some((inner, own)) => {
                    moved = moved * own;
                    flat.extend(inner);
                }
                None => flat.push(*part),
            }
        }
        if flat.len() <= MOST_FACTORS || flat.len() == parts.len() {
            return (flat, moved);
        }
        self.reached.push(SearchLimit::Factors);
        (parts.to_vec(), Ratio::ONE)
    }

    /// Adds a geometric product of some parts as it is written, besides that of all their factors:
    /// a part may be read elsewhere too.
    pub(super) fn add_written(&mut self, parts: &[ClassId], whole: Term) {
        let (parts, sign) = self.in_order(Product::Geometric, parts.to_vec());
        if parts.len() > 1 {
            let operation = Operation::Product(Product::Geometric, parts);
            self.add_way(operation, whole.scaled(sign), None);
        }
    }

    /// The factors of a class that is a chain, and the factor in front of it.
    pub(super) fn factors(&self, product: Product, id: ClassId) -> Option<(Vec<ClassId>, Ratio)> {
        let class = self.class(id);
        if class.is_leaf() {
            return None;
        }
        let chains = class.ways.iter().filter_map(|way| match &way.operation {
            Operation::Product(other, factors)
                if *other == product
                    && factors.iter().all(|part| !self.is_chain(product, *part)) =>
            {
                Some((factors, way.factor))
            }
            _ => None,
        });
        let shortest = chains.min_by_key(|(factors, _)| factors.len());
        shortest.map(|(factors, factor)| (factors.clone(), factor))
    }

    /// Whether a class is a chain, so that a chain with it as a factor is not flat.
    fn is_chain(&self, product: Product, id: ClassId) -> bool {
        let class = self.class(id);
        let mut ways = class.ways.iter().map(|way| &way.operation);
        !class.is_leaf()
            && ways.any(|way| matches!(way, Operation::Product(other, _) if *other == product))
    }

    /// The factors in order, and the sign of the rearrangement: scalars first in a geometric
    /// product without the number 1, all of an outer product.
    fn in_order(&self, product: Product, factors: Vec<ClassId>) -> (Vec<ClassId>, Ratio) {
        if product == Product::Geometric {
            let (mut scalars, rest): (Vec<_>, Vec<_>) =
                factors.into_iter().partition(|id| self.is_scalar(*id));
            scalars.order_by(|a, b| self.compare(*a, *b));
            let is_one = |id: &ClassId| {
                let way = self.class(*id).ways.first();
                way.is_some_and(|way| way.operation == Operation::Blade(Blade::SCALAR))
            };
            let one = scalars.iter().copied().find(is_one);
            scalars.retain(|id| !is_one(id));
            scalars.extend(rest);
            if scalars.is_empty() {
                scalars.extend(one);
            }
            return (scalars, Ratio::ONE);
        }
        let mut factors = factors;
        let mut is_negative = false;
        // By insertion, since every exchange of two factors may change the sign.
        for end in 1..factors.len() {
            let mut place = end;
            while place > 0 {
                let (a, b) = (factors[place - 1], factors[place]);
                let (Some(r), Some(s)) = (self.grade(a), self.grade(b)) else {
                    break;
                };
                if self.compare(a, b).is_le() {
                    break;
                }
                factors.swap(place - 1, place);
                is_negative ^= r * s % 2 == 1;
                place -= 1;
            }
        }
        let sign = if is_negative { -Ratio::ONE } else { Ratio::ONE };
        (factors, sign)
    }
}
