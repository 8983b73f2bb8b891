//! Programs to graphs, one step at a time.

use std::collections::BTreeSet;

use super::chain::{Part, Places};
use super::factors::Factors;
use super::operand::rederived;
use super::piece::Pieces;
use super::projection::{Image, keeps_weight};
use super::{Choice, Choices, InnerRule, JoinRule, MeetRule, ProjectionRule, Rule, SandwichRule};
use super::{gram, meet};
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Facts, Function, Multivector, Value};
use crate::program::{Program, Step, StepId, Support};

/// Lowers the wanted steps of a program over operands that are already in the arena, and what they
/// need. A step with a piece is computed by its graph.
#[must_use]
pub fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    program: &Program<'_>,
    operands: &[Multivector],
    wanted: &[StepId],
    choices: &Choices,
    pieces: &Pieces<'_>,
) -> Lowered {
    let mut lowering = Lowering {
        arena,
        algebra,
        program,
        operands,
        choice: choices.all,
        sites: &choices.sites,
        site: None,
        acted: Vec::new(),
        images: Vec::new(),
        values: vec![Multivector::default(); program.len()],
        factors: Factors::new(program, pieces, wanted),
    };
    let needed = lowering.factors.needed(wanted);
    for (id, step) in program.steps().filter(|(id, _)| needed[id.index()]) {
        lowering.site = Some(id);
        if let Some(piece) = pieces.get(&id) {
            lowering.values[id.index()] = piece.lower(lowering.arena, &lowering.values);
            continue;
        }
        let value = lowering.step(id, step);
        let facts = value.facts.and(program.stated(id));
        // Terms of the other parity are zero, though the graph does not show it.
        let value = match program.parity(id) {
            Some(parity) => value.filtered(|blade| parity.allows(blade)),
            None => value,
        };
        let value = match program.support(id) {
            Some(support) => {
                let all = value;
                let value = supported(lowering.arena, &all, support);
                let mut images = lowering.images.iter_mut();
                if let Some(image) = images.find(|image| image.value.terms() == all.terms()) {
                    image.value = value.clone();
                }
                value
            }
            None => value,
        };
        let value = value.with_facts(facts);
        lowering.values[id.index()] = match program.kind(id) {
            Some(kind) if choices.all.rederive => {
                let value = rederived(lowering.arena, kind, &value);
                lowering.applied(Rule::Rederive, value)
            }
            _ => value,
        };
    }
    let value = |id: &StepId| lowering.values[id.index()].clone();
    Lowered {
        values: wanted.iter().map(value).collect(),
        acted: lowering.acted,
    }
}

/// A lowered program.
pub struct Lowered {
    /// The wanted steps.
    pub values: Vec<Multivector>,
    /// The steps in which a versor acts.
    pub acted: Vec<StepId>,
}

struct Lowering<'a> {
    arena: &'a mut Arena,
    algebra: &'a Algebra,
    program: &'a Program<'a>,
    operands: &'a [Multivector],
    choice: Choice,
    sites: &'a [(StepId, SandwichRule)],
    /// The step at work.
    site: Option<StepId>,
    /// The steps in which a versor acts.
    acted: Vec<StepId>,
    /// The actions so far.
    images: Vec<Image>,
    values: Vec<Multivector>,
    factors: Factors<'a>,
}

impl Lowering<'_> {
    fn step(&mut self, id: StepId, step: &Step) -> Multivector {
        let value = |id: &StepId| self.values[id.index()].clone();
        let scalar = |id: &StepId| self.values[id.index()].coefficient(Blade::SCALAR);
        match step {
            Step::Operand(number) => self.operands[*number].clone(),
            Step::Constant(blade, factor) => {
                Multivector::new(self.arena, [(*blade, Value::constant(*factor))])
            }
            Step::Unary(operation, a) => {
                let a = value(a);
                let facts = match operation {
                    Unary::Reverse => a.facts.of_reverse(),
                    Unary::Involute
                    | Unary::Conjugate
                    | Unary::Dual
                    | Unary::Undual
                    | Unary::Grade(_) => Facts::default(),
                };
                a.unary(self.arena, self.algebra, *operation)
                    .with_facts(facts)
            }
            Step::Binary(Product::Geometric, ..) => {
                let factors = self.factors.of_product(id, Product::Geometric);
                self.chain(&factors)
            }
            Step::Binary(Product::Wedge, ..) => {
                let factors = self.factors.of_product(id, Product::Wedge);
                let factors: Vec<_> = factors.iter().map(value).collect();
                self.join(&factors)
            }
            Step::Binary(product, a, b) => {
                let (left, right) = (value(a), value(b));
                self.by_factors(*product, *a, *b)
                    .unwrap_or_else(|| self.product(*product, &left, &right))
            }
            Step::Sandwich(versor, operand) => {
                let (versor, operand) = (value(versor), value(operand));
                self.sandwich(&versor, &operand)
            }
            Step::Sum(a, b) => {
                let (a, b) = (value(a), value(b));
                a.sum(self.arena, &b)
            }
            Step::Quotient(a, b) => {
                let (dividend, divisor) = (value(a), scalar(b));
                if let Some(image) = self.projected(&dividend, divisor) {
                    return self.applied(Rule::Projection(self.choice.projection), image);
                }
                let quotients: Vec<_> = dividend
                    .terms()
                    .iter()
                    .filter_map(|&(blade, value)| {
                        Some((blade, self.arena.quotient(value, divisor)?))
                    })
                    .collect();
                Multivector::new(self.arena, quotients)
            }
            Step::Negative(a) => {
                let a = value(a);
                // −M acts as M does, and has the same norm.
                let facts = Facts {
                    weight: None,
                    ..a.facts
                };
                a.scaled(Ratio::integer(-1)).with_facts(facts)
            }
            Step::Coefficient(a, blade) => {
                let coefficient = value(a).coefficient(*blade);
                Multivector::new(self.arena, [(Blade::SCALAR, coefficient)])
            }
            Step::Select(condition, a, b) => {
                let (condition, a, b) = (scalar(condition), value(a), value(b));
                self.select(condition, &a, &b)
            }
            Step::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(scalar).collect();
                let result = self.arena.function(*function, &arguments);
                Multivector::new(self.arena, [(Blade::SCALAR, result)])
            }
        }
    }

    /// One of two values, blade by blade.
    fn select(&mut self, condition: Value, a: &Multivector, b: &Multivector) -> Multivector {
        let blades = a.terms().iter().chain(b.terms()).map(|(blade, _)| *blade);
        let blades: BTreeSet<Blade> = blades.collect();
        let terms: Vec<_> = blades
            .into_iter()
            .map(|blade| {
                let arguments = [condition, a.coefficient(blade), b.coefficient(blade)];
                (blade, self.arena.function(Function::Select, &arguments))
            })
            .collect();
        Multivector::new(self.arena, terms).with_facts(a.facts.common(b.facts))
    }

    fn sandwich(&mut self, versor: &Multivector, operand: &Multivector) -> Multivector {
        let own = self.sites.iter().find(|(site, _)| Some(*site) == self.site);
        let rule = own.map_or(self.choice.sandwich, |(_, rule)| *rule);
        if let Some(site) = self.site
            && self.acted.last() != Some(&site)
        {
            self.acted.push(site);
        }
        let value = self.acted(rule, versor, operand);
        if self.choice.projection != ProjectionRule::Division {
            self.images.push(Image {
                rule,
                versor: versor.clone(),
                operand: operand.clone(),
                value: value.clone(),
            });
        }
        value
    }

    fn acted(
        &mut self,
        rule: SandwichRule,
        versor: &Multivector,
        operand: &Multivector,
    ) -> Multivector {
        match rule.lower(self.arena, self.algebra, versor, operand) {
            Some(value) => self.applied(Rule::Sandwich(rule), value),
            None => SandwichRule::LeftFirst
                .lower(self.arena, self.algebra, versor, operand)
                .unwrap_or_default(),
        }
    }

    /// The quotient of an image by its weight, or by a multiple of that, without a division.
    fn projected(&mut self, dividend: &Multivector, divisor: Value) -> Option<Multivector> {
        if self.choice.projection == ProjectionRule::Division {
            return None;
        }
        let is_weight = |(blade, value): &&(Blade, Value)| {
            blade.grade() == 1 && value.node == divisor.node && value.as_constant().is_none()
        };
        let mut weights = dividend.terms().iter().filter(is_weight);
        let (quotient, weight) = weights.find_map(|(blade, weight)| {
            let quotient = self.unit_weight(dividend, *blade)?;
            Some((quotient, weight))
        })?;
        let facts = quotient.facts;
        let multiple = weight.factor / divisor.factor;
        Some(quotient.scaled(multiple).with_facts(facts))
    }

    /// An image divided by the coefficient of a vector.
    fn unit_weight(&mut self, value: &Multivector, weight: Blade) -> Option<Multivector> {
        let place = self
            .images
            .iter()
            .position(|image| image.value.terms() == value.terms())?;
        let image = &self.images[place];
        let rule = self.choice.projection;
        if let Some(quotient) = rule.lower(self.arena, self.algebra, image, weight) {
            return Some(quotient);
        }
        let (versor, operand) = (image.versor.clone(), image.operand.clone());
        let sandwich = image.rule;
        let operand = self.unit_weight(&operand, weight)?;
        let value = self.acted(sandwich, &versor, &operand);
        if keeps_weight(self.algebra, &versor, weight) {
            return Some(value);
        }
        let image = Image {
            rule: sandwich,
            versor,
            operand,
            value,
        };
        rule.lower(self.arena, self.algebra, &image, weight)
    }

    fn join(&mut self, factors: &[Multivector]) -> Multivector {
        let rule = self.choice.join;
        match rule.lower(self.arena, self.algebra, factors) {
            Some(value) => self.applied(Rule::Join(rule), value),
            None => JoinRule::LeftFirst
                .lower(self.arena, self.algebra, factors)
                .unwrap_or_default(),
        }
    }

    fn product(
        &mut self,
        product: Product,
        left: &Multivector,
        right: &Multivector,
    ) -> Multivector {
        let rule = self.choice.inner;
        let is_inner = matches!(
            product,
            Product::LeftContraction | Product::RightContraction | Product::ScalarProduct
        );
        if is_inner
            && rule != InnerRule::Plain
            && let Some(value) = rule.lower(self.arena, self.algebra, left, right)
        {
            return self.applied(Rule::Inner(rule), value);
        }
        left.product(self.arena, self.algebra, product, right, |_| true)
    }

    /// A product of two outer products of vectors by their factors. For an I with an inverse,
    /// `dual(a)⌋b = (a I⁻¹)⌋b` is the meet `a ∨ b`.
    fn by_factors(&mut self, product: Product, a: StepId, b: StepId) -> Option<Multivector> {
        let is_inner = matches!(
            product,
            Product::LeftContraction | Product::RightContraction | Product::ScalarProduct
        );
        let (rule, a, multiple) = match (product, self.undualised(a)) {
            (Product::Vee, _) => (Rule::Meet(self.choice.meet), a, Ratio::ONE),
            (Product::LeftContraction, Some((a, multiple))) => {
                (Rule::Meet(self.choice.meet), a, multiple)
            }
            _ if is_inner => (Rule::Inner(self.choice.inner), a, Ratio::ONE),
            _ => return None,
        };
        let [(left, first), (right, second)] = [a, b].map(|id| {
            let (factors, is_negative) = self.factors.of_outer_product(id);
            let factors: Vec<_> = factors.into_iter().map(|id| self.value(id)).collect();
            (factors, is_negative)
        });
        let value = match rule {
            Rule::Meet(MeetRule::Factors) => meet::lower(self.arena, self.algebra, &left, &right)?,
            Rule::Inner(InnerRule::Gram) => gram::lower(self.arena, self.algebra, &left, &right)?,
            _ => return None,
        };
        let sign = if first == second { 1 } else { -1 };
        Some(self.applied(rule, value.scaled(multiple * Ratio::integer(sign))))
    }

    /// The operand of a dual, or of its negative, with the factor of `a I⁻¹`.
    fn undualised(&self, id: StepId) -> Option<(StepId, Ratio)> {
        let square = self.algebra.metric().pseudoscalar_square();
        let (mut id, mut sign) = (id, Ratio::ONE);
        while let Step::Negative(a) = self.program.step(id) {
            (id, sign) = (*a, -sign);
        }
        match self.program.step(id) {
            _ if square.is_zero() => None,
            Step::Unary(Unary::Dual, a) => Some((*a, sign)),
            Step::Unary(Unary::Undual, a) => Some((*a, square * sign)),
            _ => None,
        }
    }

    /// The result of a rule. If the rule is to be broken, the sign of its last coefficient that is
    /// not constant is wrong.
    fn applied(&self, rule: Rule, value: Multivector) -> Multivector {
        if self.choice.broken != Some(rule) {
            return value;
        }
        value.with_last_negated()
    }

    /// A product of factors. `M … ~M` with an even M is the action of a versor: the longest action
    /// inside is taken first, then the rest from left to right.
    fn chain(&mut self, factors: &[StepId]) -> Multivector {
        let places = Places::new(self.program, factors);
        let mut open = vec![Part::Factors(0..factors.len())];
        let mut done: Vec<Multivector> = Vec::new();
        while let Some(part) = open.pop() {
            let range = match part {
                Part::Factors(range) => range,
                Part::Action(versor) => {
                    let operand = done.pop().unwrap_or_default();
                    let versor = self.values[versor.index()].clone();
                    done.push(self.sandwich(&versor, &operand));
                    continue;
                }
                Part::Product => {
                    let (right, left) = (done.pop(), done.pop());
                    let (left, right) = (left.unwrap_or_default(), right.unwrap_or_default());
                    let facts = left.facts.of_product(right.facts);
                    let product = Product::Geometric;
                    let whole = left.product(self.arena, self.algebra, product, &right, |_| true);
                    done.push(whole.with_facts(facts));
                    continue;
                }
            };
            if range.len() < 2 {
                let value = factors[range].first();
                done.push(value.map_or_else(Default::default, |id| self.value(*id)));
                continue;
            }
            let versor = |place: usize| is_even(&self.values[factors[place].index()]);
            match places.action(&range).filter(|start| versor(*start)) {
                Some(start) if start == range.start => {
                    open.push(Part::Action(factors[start]));
                    open.push(Part::Factors(start + 1..range.end - 1));
                }
                inside => {
                    let middle = inside.unwrap_or(range.end - 1);
                    open.push(Part::Product);
                    open.push(Part::Factors(middle..range.end));
                    open.push(Part::Factors(range.start..middle));
                }
            }
        }
        done.pop().unwrap_or_default()
    }

    fn value(&self, id: StepId) -> Multivector {
        self.values[id.index()].clone()
    }
}

/// A value without the coefficients that cancel, and with the numbers that some of them are.
fn supported(arena: &mut Arena, value: &Multivector, support: &Support) -> Multivector {
    let terms = support.iter().map(|&(blade, number)| {
        let found = value.coefficient(blade);
        (blade, number.map_or(found, Value::constant))
    });
    let terms: Vec<_> = terms.collect();
    Multivector::new(arena, terms)
}

fn is_even(value: &Multivector) -> bool {
    value
        .terms()
        .iter()
        .all(|(blade, _)| !blade.involute_is_negative())
}
