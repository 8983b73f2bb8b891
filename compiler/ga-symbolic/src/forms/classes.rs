//! Classes of equal multivectors, each with the operations that give it.
//!
//! A class is an e-class and a way an e-node of an e-graph, and the rules are applied by equality
//! saturation (Tate et al. 2009; Willsey et al., egg, 2021).
//!
//! Two multivectors are taken as equal if they are equal at the random points of the program's
//! witness, in residues and, where signs matter, in real numbers. For polynomials and quotients of
//! them an error has a probability below 2⁻⁵⁰, by the lemma of Schwartz and Zippel. So a rule only
//! proposes an operation: what it gives is computed, and decides the class it joins. A rule that is
//! wrong proposes an operation that joins another class, and is not used for this one. Only where a
//! rule states a way directly, since it groups what was there, is nothing computed.
//!
//! Equal values at the points do not mean equal formulas everywhere where there are choices, which
//! hold at random there, and where a root keeps the sign of its argument fixed. Such programs are
//! not taken apart, see `import.rs`.
//!
//! Multiples of one multivector by a constant share a class. Values with other divisors, or other
//! arguments of functions, have classes of their own: `x/y*y` and `x` differ where y is zero. Two
//! values with the same limits share a class, and in the finished graph `y/x*x` may be y, since a
//! common factor of a dividend and a divisor cancels there.

use std::cmp::Ordering;

use rustc_hash::FxHashMap;

use super::FormRule;
use super::class::{Class, ClassId, Limit, Operation, Term, Way};
use crate::algebra::{Algebra, Blade, Ratio};
use crate::ir::{Number, Residue};
use crate::limit::SearchLimit;
use crate::member::{Numbers, numbers};
use crate::order::Order as _;
use crate::program::Support;

/// The largest numerator and denominator of a constant that is recognised.
const LARGEST: u64 = 1 << 16;

pub(super) struct Classes<'a> {
    pub(super) algebra: &'a Algebra,
    classes: Vec<Class>,
    known: FxHashMap<Operation, Term>,
    by_value: FxHashMap<Vec<u64>, Vec<ClassId>>,
    pub(super) ways: usize,
    /// The limits of what is zero at all points: of `x/y*y - x`, or of `abs(x) - x` besides the
    /// root of x. It is not zero where its limits are not kept.
    limits_of_zeros: Vec<Limit>,
    /// The limits of the search that were reached.
    pub(super) reached: Vec<SearchLimit>,
}

impl<'a> Classes<'a> {
    pub(super) fn new(algebra: &'a Algebra) -> Self {
        Self {
            algebra,
            classes: Vec::new(),
            known: FxHashMap::default(),
            by_value: FxHashMap::default(),
            ways: 0,
            limits_of_zeros: Vec::new(),
            reached: Vec::new(),
        }
    }

    pub(super) fn class(&self, id: ClassId) -> &Class {
        &self.classes[id.0]
    }

    pub(super) fn len(&self) -> usize {
        self.classes.len()
    }

    pub(super) fn ids(&self) -> impl Iterator<Item = ClassId> + use<> {
        (0..self.classes.len()).map(ClassId)
    }

    /// The blades that a class has.
    pub(super) fn blades(&self, id: ClassId) -> Vec<Blade> {
        let values = &self.class(id).values;
        let mut blades: Vec<Blade> = values.iter().flat_map(|v| v.keys().copied()).collect();
        blades.order();
        blades.dedup();
        blades
    }

    /// The coefficients of vectors that are the same for all operands.
    pub(super) fn constants(&self, id: ClassId) -> Vec<(Blade, Ratio)> {
        let coefficients = self.coefficients(id).into_iter();
        coefficients
            .filter(|(blade, _)| blade.grade() == 1)
            .filter_map(|(blade, number)| Some((blade, number?)))
            .collect()
    }

    /// The blades that a multiple of a class has, with the numbers that some coefficients are.
    /// Where all are, one must tell whether the class exists.
    pub(super) fn support(&self, id: ClassId, factor: Ratio) -> Support {
        let mut support = self.coefficients(id);
        let is_open = support.iter().any(|(_, number)| number.is_none());
        let is_told = is_open || self.class(id).limits.is_empty();
        for (_, number) in &mut support {
            *number = number.filter(|_| is_told).map(|number| number * factor);
        }
        support
    }

    /// The blades that a class has, with the number that a coefficient is for all operands.
    fn coefficients(&self, id: ClassId) -> Support {
        let values = &self.class(id).values;
        let number = |blade: Blade| {
            let first = *values.first()?.get(&blade)?;
            let is_same = values.iter().all(|value| value.get(&blade) == Some(&first));
            constant(first).filter(|_| is_same)
        };
        let blades = self.blades(id).into_iter();
        blades.map(|blade| (blade, number(blade))).collect()
    }

    /// The number that a scalar is for all operands, as far as it exists, if the other value exists
    /// nowhere else.
    pub(super) fn number_within(&self, id: ClassId, other: ClassId) -> Option<Ratio> {
        let class = self.class(id);
        let (first, rest) = class.values.split_first()?;
        let is_number = first.len() == 1 && rest.iter().all(|value| value == first);
        let number = first.get(&Blade::SCALAR).filter(|_| is_number)?;
        let limits = &self.class(other).limits;
        let is_within = class.limits.iter().all(|limit| limits.contains(limit));
        constant(*number).filter(|_| is_within)
    }

    /// The grades that a class has, as a set of bits.
    pub(super) fn grades(&self, id: ClassId) -> u32 {
        let blades = self.class(id).values.iter().flat_map(|v| v.keys());
        blades.fold(0, |set, blade| set | 1 << blade.grade())
    }

    /// The only grade of a class, if there is only one.
    pub(super) fn grade(&self, id: ClassId) -> Option<u32> {
        let grades = self.grades(id);
        (grades.count_ones() == 1).then(|| grades.trailing_zeros())
    }

    pub(super) fn is_scalar(&self, id: ClassId) -> bool {
        self.grades(id) == 1
    }

    /// Whether all grades of a class are even, or all odd.
    pub(super) fn parity(&self, id: ClassId) -> Option<bool> {
        const ODD: u32 = 0xaaaa_aaaa;
        let grades = self.grades(id);
        match (grades & ODD, grades & !ODD) {
            (0, _) => Some(false),
            (_, 0) => Some(true),
            _ => None,
        }
    }

    /// Whether `M ~M = 1` and M maps vectors to vectors.
    pub(super) fn is_unit(&mut self, id: ClassId) -> bool {
        if let Some(known) = self.class(id).is_unit {
            return known;
        }
        let values = &self.class(id).values;
        let is_unit = self.parity(id).is_some() && {
            let mut values = values.iter();
            values.all(|value| numbers::is_unit_versor(self.algebra, value))
        };
        self.classes[id.0].is_unit = Some(is_unit);
        is_unit
    }

    /// Whether it was asked and found that a class is a unit versor.
    pub(super) fn known_unit(&self, id: ClassId) -> bool {
        self.class(id).is_unit == Some(true)
    }

    /// The order of classes that does not depend on how formulas are written: operands first, then
    /// by the operands that they are computed from, so that images are in the order of what is
    /// moved.
    pub(super) fn compare(&self, a: ClassId, b: ClassId) -> Ordering {
        let key = |id: ClassId| {
            let class = self.class(id);
            let operand = class.ways.iter().find_map(|way| match way.operation {
                Operation::Operand(number) => Some(number),
                _ => None,
            });
            let operand = operand.unwrap_or(usize::MAX);
            (class.is_constant, operand, &class.operands)
        };
        let numbers = |id: ClassId| {
            let values = self.class(id).values.iter().flatten();
            values.map(|(blade, number)| (blade.0, number.residue()))
        };
        let by_value = || numbers(a).cmp(numbers(b));
        key(a).cmp(&key(b)).then_with(by_value)
    }

    /// Whether a versor acts on a class.
    pub(super) fn is_moved(&self, id: ClassId) -> bool {
        let mut ways = self.classes.iter().flat_map(|class| &class.ways);
        ways.any(|way| matches!(way.operation, Operation::Sandwich(_, operand) if operand == id))
    }

    /// Whether a class is the image under an action.
    pub(super) fn has_action(&self, id: ClassId) -> bool {
        let mut ways = self.class(id).ways.iter();
        ways.any(|way| matches!(way.operation, Operation::Sandwich(..)))
    }

    /// The known class of a multivector, if there is one. Quotients and functions in the given
    /// classes limit where it exists.
    pub(super) fn find(&self, values: &[Numbers], from: &[ClassId]) -> Option<Term> {
        self.lookup(values, &normalised(values)?, &self.limits(from))
    }

    /// The class of what an operation gives; none if it is zero. `uniform` tells of operands.
    pub(super) fn insert(
        &mut self,
        operation: Operation,
        values: impl FnOnce(&Self) -> Vec<Numbers>,
        rule: Option<FormRule>,
    ) -> Option<Term> {
        if let Some(&known) = self.known.get(&operation) {
            return (!known.factor.is_zero()).then_some(known);
        }
        let values: Vec<Numbers> = values(self).into_iter().map(without_zeros).collect();
        let reads = operation.reads();
        let mut limits = self.limits(&reads);
        let is_constant = reads.iter().all(|id| self.class(*id).is_constant);
        let mut numbers = values.iter().flat_map(|value| value.values());
        // A constant that is a real number exists everywhere.
        if !is_constant || reads.is_empty() || !numbers.all(|x| x.real().is_known()) {
            limits.extend(self.own_limit(&operation));
        }
        limits.order();
        limits.dedup();
        if values.iter().all(Numbers::is_empty) {
            self.limits_of_zeros.extend(limits);
            let zero = Term {
                class: ClassId(0),
                factor: Ratio::ZERO,
            };
            self.known.insert(operation, zero);
            return None;
        }
        let normalised = normalised(&values);
        let found = normalised
            .as_ref()
            .and_then(|of| self.lookup(&values, of, &limits));
        let term = match found {
            Some(term) => term,
            None => {
                let class = ClassId(self.classes.len());
                let all = |test: fn(&Class) -> bool| reads.iter().all(|id| test(self.class(*id)));
                let is_leaf = matches!(operation, Operation::Operand(_));
                let of_reads = reads.iter().flat_map(|id| self.class(*id).operands.iter());
                let mut operands: Vec<usize> = of_reads.copied().collect();
                if let Operation::Operand(number) = operation {
                    operands.push(number);
                }
                operands.order();
                operands.dedup();
                self.classes.push(Class {
                    is_constant: !is_leaf && all(|class| class.is_constant),
                    is_uniform: !is_leaf && all(|class| class.is_uniform),
                    values,
                    limits,
                    ways: Vec::new(),
                    operands,
                    is_unit: None,
                });
                // What cannot be told apart by its residues equals nothing else.
                if let Some((key, _)) = normalised {
                    self.by_value.entry(key).or_default().push(class);
                }
                Term::of(class)
            }
        };
        self.add_way(operation, term, rule);
        Some(term)
    }

    /// Whether a value exists only where all that was found to be zero does, so that it does not
    /// matter that this was left out.
    pub(super) fn covers_zeros(&self, made: Option<Term>) -> bool {
        let limits = made.map_or(&[][..], |term| &self.class(term.class).limits);
        let mut zeros = self.limits_of_zeros.iter();
        zeros.all(|limit| limits.contains(limit))
    }

    /// Marks an operand as uniform.
    pub(super) fn set_uniform(&mut self, id: ClassId) {
        self.classes[id.0].is_uniform = true;
    }

    /// Adds an operation that is known to give a multiple of a class, by a rule that needs no
    /// check since it only groups what was there.
    pub(super) fn add_way(&mut self, operation: Operation, term: Term, rule: Option<FormRule>) {
        if self.known.contains_key(&operation) {
            return;
        }
        self.known.insert(operation.clone(), term);
        if operation.reads().contains(&term.class) {
            return;
        }
        self.ways += 1;
        self.classes[term.class.0].ways.push(Way {
            operation,
            factor: Ratio::ONE / term.factor,
            rule,
        });
    }

    /// The class of an operation that is known.
    pub(super) fn known(&self, operation: &Operation) -> Option<Term> {
        self.known
            .get(operation)
            .copied()
            .filter(|t| !t.factor.is_zero())
    }

    fn limits(&self, from: &[ClassId]) -> Vec<Limit> {
        let mut limits: Vec<Limit> = from
            .iter()
            .flat_map(|id| self.class(*id).limits.iter().cloned())
            .collect();
        limits.order();
        limits.dedup();
        limits
    }

    /// What an operation adds to the limits.
    fn own_limit(&self, operation: &Operation) -> Option<Limit> {
        match operation {
            Operation::Quotient(_, divisor) => {
                (!self.class(*divisor).is_constant).then_some(Limit(None, *divisor, None))
            }
            Operation::Function(function, _) if function.properties().is_without_limit => None,
            Operation::Function(function, arguments) => {
                // Functions of other multiples of a number have other limits.
                let factor = arguments[0].factor;
                Some(Limit(Some(*function), arguments[0].class, Some(factor)))
            }
            _ => None,
        }
    }

    /// The class with the same values up to a simple fraction, in residues and in real numbers, and
    /// the same limits.
    fn lookup(
        &self,
        values: &[Numbers],
        (key, scale): &(Vec<u64>, Residue),
        limits: &[Limit],
    ) -> Option<Term> {
        let found = self.by_value.get(key)?.iter().copied();
        let mut same = found.filter(|class| self.class(*class).limits == limits);
        same.find_map(|class| {
            let known = &self.class(class).values;
            let (_, own) = normalised(known)?;
            let factor = fraction(*scale * own.recip())?;
            let scale = Number::from_ratio(factor);
            let mut pairs = known.iter().zip(values);
            pairs
                .all(|(known, value)| numbers::equal(&numbers::scaled(known, scale), value))
                .then_some(Term { class, factor })
        })
    }

    // What operations give.

    pub(super) fn each(&self, id: ClassId, of: impl Fn(&Numbers) -> Numbers) -> Vec<Numbers> {
        self.class(id).values.iter().map(of).collect()
    }

    pub(super) fn each_of_two(
        &self,
        a: ClassId,
        b: ClassId,
        of: impl Fn(&Numbers, &Numbers) -> Numbers,
    ) -> Vec<Numbers> {
        let pairs = self.class(a).values.iter().zip(&self.class(b).values);
        pairs.map(|(a, b)| of(a, b)).collect()
    }
}

fn without_zeros(mut value: Numbers) -> Numbers {
    value.retain(|_, number| !number.is_zero());
    value
}

/// The residues of some values divided by the first one, as a key, and that residue. `None` of
/// zero, and where residues are missing or are zero for what is not.
fn normalised(values: &[Numbers]) -> Option<(Vec<u64>, Residue)> {
    let residue = |number: &Number| number.residue().filter(|residue| *residue != Residue::ZERO);
    let scale = residue(values.iter().flat_map(|value| value.values()).next()?)?;
    let inverse = scale.recip();
    let mut key = Vec::new();
    for value in values {
        for (blade, number) in value {
            key.push(u64::from(blade.0));
            let number = residue(number)? * inverse;
            key.push(number.residue());
            if !number.is_real() {
                // No residue is as large, so that the parts of different numbers are not confused.
                key.extend([u64::MAX - 1, number.imaginary()]);
            }
        }
        key.push(u64::MAX);
    }
    Some((key, scale))
}

/// The fraction of small height that a residue is.
fn fraction(residue: Residue) -> Option<Ratio> {
    let units = [Ratio::ONE, Ratio::integer(-1)].into_iter();
    let mut units = units.filter(|unit| Residue::from_ratio(*unit) == residue);
    units.next().or_else(|| residue.to_ratio(LARGEST))
}

/// The fraction of small height that a number is.
fn constant(number: Number) -> Option<Ratio> {
    let found = fraction(number.residue()?)?;
    (Number::from_ratio(found) == number).then_some(found)
}
