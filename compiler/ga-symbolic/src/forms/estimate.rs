//! What an operation costs, roughly: the operations of its graph before any pass.

use crate::order::Order as _;
use rustc_hash::FxHashMap;

use super::class::{ClassId, Operation};
use super::classes::Classes;
use crate::algebra::{Blade, Product, Unary};
use crate::ir::{Arena, Facts, Multivector, Number, Value};
use crate::lower::SandwichRule;
use crate::passes::{cost, varying_cost};

/// What an operation counts.
const OPERATION: usize = 64;

/// Costs of operations.
pub(super) struct Estimates {
    supports: Vec<Support>,
    actions: FxHashMap<(Support, Support, Support, bool), usize>,
}

/// The blades of a class, and whether each coefficient is 1 or −1 for all operands.
type Support = Vec<(Blade, Option<bool>)>;

impl Estimates {
    pub(super) fn new(classes: &Classes<'_>) -> Self {
        let supports = classes.ids().map(|id| support(classes, id)).collect();
        Self {
            supports,
            actions: FxHashMap::default(),
        }
    }

    /// The cost of an operation that gives a class.
    pub(super) fn cost(
        &mut self,
        classes: &mut Classes<'_>,
        id: ClassId,
        operation: &Operation,
    ) -> usize {
        let whole = self.supports[id.index()].len();
        let operations = match operation {
            Operation::Operand(_) | Operation::Blade(_) => return 0,
            Operation::Unary(Unary::Grade(_), _) | Operation::Coefficient(..) => return 1,
            Operation::Unary(..) => return 2,
            Operation::Product(product, factors) => self.product(classes, *product, factors, id),
            Operation::Sandwich(versor, operand) => self.sandwich(classes, *versor, *operand, id),
            Operation::Sum(terms) => {
                let each = terms
                    .iter()
                    .map(|term| self.supports[term.class.index()].len());
                each.sum::<usize>().saturating_sub(whole)
            }
            Operation::Quotient(..) => whole + 1,
            Operation::Function(..) => 4,
        };
        let is_uniform = classes.class(id).is_uniform;
        // Inner products have more rules than geometric ones that give the same.
        let is_general = matches!(operation, Operation::Product(Product::Geometric, _));
        4 + usize::from(is_general && classes.is_scalar(id))
            + operations * if is_uniform { 1 } else { OPERATION }
    }

    fn product(
        &self,
        classes: &Classes<'_>,
        product: Product,
        factors: &[ClassId],
        id: ClassId,
    ) -> usize {
        let algebra = classes.algebra;
        let mut left = self.supports[factors[0].index()].clone();
        let mut operations = 0;
        for (place, factor) in factors.iter().enumerate().skip(1) {
            let is_last = place + 1 == factors.len();
            let mut terms: FxHashMap<Blade, usize> = FxHashMap::default();
            for (a, first) in &left {
                for (b, second) in &self.supports[factor.index()] {
                    for &(blade, _) in product.of_blades(algebra, *a, *b).iter() {
                        let is_wanted = !is_last
                            || self.supports[id.index()]
                                .iter()
                                .any(|(other, _)| *other == blade);
                        if is_wanted {
                            *terms.entry(blade).or_default() += 1;
                            operations += usize::from(first.is_none() && second.is_none());
                        }
                    }
                }
            }
            operations += terms.values().map(|count| count - 1).sum::<usize>();
            left = terms.into_keys().map(|blade| (blade, None)).collect();
            left.order();
        }
        operations
    }

    fn sandwich(
        &mut self,
        classes: &mut Classes<'_>,
        versor: ClassId,
        operand: ClassId,
        id: ClassId,
    ) -> usize {
        let is_staged = classes.class(versor).is_uniform && !classes.class(operand).is_uniform;
        let supports = [versor, operand, id].map(|id| self.supports[id.index()].clone());
        let [m, x, image] = supports;
        let unit_versor = classes.is_unit(versor);
        let key = (m, x, image, is_staged);
        if let Some(&known) = self.actions.get(&key) {
            return known;
        }
        let (m, x, image, _) = &key;
        let mut least = usize::MAX;
        for rule in SandwichRule::ALL {
            let mut arena = Arena::default();
            let facts = Facts {
                unit_versor,
                ..Facts::default()
            };
            let m = stand_in(&mut arena, m).with_facts(facts);
            let uniform = vec![is_staged; arena.inputs()];
            let x = stand_in(&mut arena, x);
            let Some(value) = rule.lower(&mut arena, classes.algebra, &m, &x) else {
                continue;
            };
            let outputs: Vec<Value> = image
                .iter()
                .map(|(blade, _)| value.coefficient(*blade))
                .collect();
            let found = if is_staged {
                varying_cost(&arena, &outputs, &uniform)
            } else {
                cost(&arena, &outputs).total()
            };
            least = least.min(found);
        }
        self.actions.insert(key, least);
        least
    }
}

/// A multivector of the given blades with unknown coefficients.
fn stand_in(arena: &mut Arena, support: &Support) -> Multivector {
    let terms: Vec<_> = support
        .iter()
        .map(|&(blade, constant)| {
            let value = match constant {
                None => arena.input(),
                Some(true) => -Value::ONE,
                Some(false) => Value::ONE,
            };
            (blade, value)
        })
        .collect();
    Multivector::new(arena, terms)
}

fn support(classes: &Classes<'_>, id: ClassId) -> Support {
    let class = classes.class(id);
    let constant = |blade: Blade| {
        let mut values = class.values.iter();
        let of = |number: Number| values.all(|value| value.get(&blade) == Some(&number));
        let first = class.values.first()?.get(&blade).copied()?;
        let is_same = { of }(first);
        if !is_same {
            return None;
        }
        let signs = [(Number::ONE, false), (-Number::ONE, true)];
        let mut signs = signs.into_iter().filter(|(one, _)| first == *one);
        signs.next().map(|(_, is_negative)| is_negative)
    };
    let blades = classes.blades(id).into_iter();
    blades.map(|blade| (blade, constant(blade))).collect()
}
