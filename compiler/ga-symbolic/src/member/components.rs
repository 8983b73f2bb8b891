//! The unit versors of a type, by the components of their variety.
//!
//! A component is what the identity component of the group acts on: the unit versors V that the
//! bivectors of the type, and of its vectors, generate. With a seed U, one member, it is `V U`, or
//! `V U ~V` where the products leave the type. Without a bivector whose square is not zero, M and
//! −M lie in different components: a translation with a stored scalar is one with 1 or with −1.

use super::membership::membership;
use super::numbers::{Numbers, add, coefficient, product, scaled, unary};
use super::stored::from_stored;
use crate::algebra::{Algebra, Blade, Product, Unary};
use crate::define::{Role, TypeDefinition};
use crate::ir::{Function, Number, NumberSequence, Real, Residue};
use crate::order::Order as _;

/// The components of a type of unit versors.
pub(super) struct Components<'a> {
    algebra: &'a Algebra,
    kind: &'a TypeDefinition,
    /// The bivectors, with their squares, which are scalars.
    generators: Vec<(Numbers, Number)>,
    /// A member of each component, or of each two of opposite signs.
    seeds: Vec<Numbers>,
    is_of_vectors: bool,
}

/// A random member of a component, with the tangents of the family that it was drawn from.
struct Draw {
    member: Numbers,
    versor: Numbers,
    /// The factors of the versor.
    factors: Vec<Numbers>,
    is_action: bool,
}

impl<'a> Components<'a> {
    pub(super) fn new(algebra: &'a Algebra, kind: &'a TypeDefinition) -> Self {
        let directions = directions(kind);
        let generators = generators(algebra, &directions);
        let seeds = seeds(algebra, starts(kind, &directions), &generators);
        let is_of_vectors = kind.coefficients.iter().all(|c| c.blade.grade() == 1);
        Self {
            algebra,
            kind,
            generators,
            seeds,
            is_of_vectors,
        }
    }

    /// How many components there may be.
    pub(super) fn count(&self) -> usize {
        self.seeds.len() * if self.has_both_signs() { 1 } else { 2 }
    }

    /// Whether −1 lies in the identity component.
    fn has_both_signs(&self) -> bool {
        let mut squares = self.generators.iter().map(|(_, square)| *square);
        squares.any(|square| !square.is_zero())
    }

    /// A random member; `None` where none is found.
    pub(super) fn sample(&self, sequence: &mut NumberSequence) -> Option<Numbers> {
        let count = self.count();
        let first = match count {
            0 => return None,
            1 => 0,
            _ => sequence.below(count),
        };
        let mut places = (first..count).chain(0..first);
        places.find_map(|place| self.draw(place, sequence).map(|draw| draw.member))
    }

    /// Whether random members have every blade of the type, and no component is known of which they
    /// are only a part.
    pub(super) fn are_whole(&self, sequence: &mut NumberSequence) -> bool {
        let mut blades: Vec<Blade> = Vec::new();
        for place in 0..self.count() {
            let Some(draw) = self.draw(place, sequence) else {
                let seed = self.signed_seed(place);
                if membership(self.algebra, Some(self.kind), &seed).is_empty() {
                    return false;
                }
                continue;
            };
            let is_group = self.seeds.len() == 1 && !draw.is_action;
            if !is_group && !self.is_component(&draw) {
                return false;
            }
            let nonzero = draw.member.iter().filter(|(_, v)| !v.is_zero());
            blades.extend(nonzero.map(|(blade, _)| *blade));
        }
        let mut coefficients = self.kind.coefficients.iter();
        coefficients.all(|c| blades.contains(&c.blade))
    }

    fn signed_seed(&self, place: usize) -> Numbers {
        let seed = &self.seeds[place % self.seeds.len()];
        if place < self.seeds.len() {
            seed.clone()
        } else {
            scaled(seed, -Number::ONE)
        }
    }

    /// A member of a component: a product with its seed, or else its image.
    fn draw(&self, place: usize, sequence: &mut NumberSequence) -> Option<Draw> {
        let one = Numbers::from([(Blade::SCALAR, Number::ONE)]);
        let mut versor = one.clone();
        let mut factors = Vec::new();
        for (bivector, square) in &self.generators {
            let factor = unit_factor(self.algebra, bivector, *square, sequence.next_number());
            versor = self.geometric(&versor, &factor);
            factors.push(factor);
        }
        let seed = self.signed_seed(place);
        for is_action in [false, true] {
            if self.is_of_vectors && !is_action {
                continue;
            }
            let member = if !is_action && seed == one {
                versor.clone()
            } else {
                self.member(&versor, &seed, &versor, is_action)
            };
            if membership(self.algebra, Some(self.kind), &member).is_empty() {
                return Some(Draw {
                    member,
                    versor,
                    factors,
                    is_action,
                });
            }
        }
        None
    }

    /// `V U`, or `V U ~W`.
    fn member(&self, left: &Numbers, seed: &Numbers, right: &Numbers, is_action: bool) -> Numbers {
        let half = self.geometric(left, seed);
        if !is_action {
            return half;
        }
        self.geometric(&half, &unary(self.algebra, Unary::Reverse, right))
    }

    fn geometric(&self, a: &Numbers, b: &Numbers) -> Numbers {
        product(self.algebra, Product::Geometric, a, b)
    }

    /// Whether the family has as many dimensions as the variety `M ~M = 1` has here.
    fn is_component(&self, draw: &Draw) -> bool {
        let reverse = unary(self.algebra, Unary::Reverse, &draw.member);
        let directions = directions(self.kind);
        let equations = directions.iter().map(|(_, direction)| {
            let left = self.geometric(direction, &reverse);
            sum(left.clone(), &unary(self.algebra, Unary::Reverse, &left))
        });
        let equations: Vec<Numbers> = equations.collect();
        let dimension = directions.len() - rank(equations);
        rank(self.tangents(draw)) == dimension
    }

    /// The derivatives of the member, up to factors. That of a factor f = (1 + αb)/(1 − αb) is a
    /// multiple of f b.
    fn tangents(&self, draw: &Draw) -> Vec<Numbers> {
        let seed = self.recovered_seed(draw);
        let one = Numbers::from([(Blade::SCALAR, Number::ONE)]);
        let mut left = one.clone();
        let mut tangents = Vec::new();
        for (place, (bivector, _)) in self.generators.iter().enumerate() {
            left = self.geometric(&left, &draw.factors[place]);
            let right = draw.factors[place + 1..].iter();
            let right = right.fold(one.clone(), |right, factor| self.geometric(&right, factor));
            let change = self.geometric(&self.geometric(&left, bivector), &right);
            let mut tangent = self.member(&change, &seed, &draw.versor, draw.is_action);
            if draw.is_action {
                let other = self.member(&draw.versor, &seed, &change, true);
                tangent = sum(tangent, &other);
            }
            tangents.push(tangent);
        }
        tangents
    }

    /// `~V M`, or `~V M V`.
    fn recovered_seed(&self, draw: &Draw) -> Numbers {
        let reverse = unary(self.algebra, Unary::Reverse, &draw.versor);
        self.member(&reverse, &draw.member, &reverse, draw.is_action)
    }
}

/// What each stored coefficient adds to a member, with the blade that it is named after: blades
/// that are derived as multiples of it belong to it.
fn directions(kind: &TypeDefinition) -> Vec<(Blade, Numbers)> {
    let count = kind.stored().count();
    let mut stored = vec![Number::ZERO; count];
    let mut directions = Vec::new();
    for (place, c) in kind.stored().enumerate() {
        stored[place] = Number::ONE;
        let mut direction = from_stored(kind, &stored);
        stored[place] = Number::ZERO;
        direction.retain(|blade, number| {
            let role = kind.coefficient(*blade).map(|c| &c.role);
            let is_constant = matches!(role, Some(Role::Constant(_)));
            let is_of_grade = blade.grade() == c.blade.grade();
            !number.is_zero() && !is_constant && is_of_grade
        });
        directions.push((c.blade, direction));
    }
    directions
}

/// The bivectors among the directions and of their vectors, with their squares.
fn generators(algebra: &Algebra, directions: &[(Blade, Numbers)]) -> Vec<(Numbers, Number)> {
    let of_grade = |grade: u32| {
        let found = directions.iter().filter(move |(b, _)| b.grade() == grade);
        found.map(|(_, direction)| direction)
    };
    let mut bivectors: Vec<Numbers> = of_grade(2).cloned().collect();
    let vectors: Vec<&Numbers> = of_grade(1).collect();
    for (place, a) in vectors.iter().enumerate() {
        let others = vectors[place + 1..].iter();
        bivectors.extend(others.map(|b| product(algebra, Product::Wedge, a, b)));
    }
    for bivector in &mut bivectors {
        bivector.retain(|_, number| !number.is_zero());
        let first = bivector.values().next().copied().unwrap_or(Number::ONE);
        *bivector = scaled(bivector, first.recip());
    }
    // What differs in an order differs in a residue.
    let residues = |bivector: &Numbers| -> Vec<(Blade, Option<Residue>)> {
        let coefficients = bivector.iter();
        coefficients
            .map(|(blade, number)| (*blade, number.residue()))
            .collect()
    };
    bivectors.order_by_key(residues);
    bivectors.dedup();
    let with_square = bivectors.into_iter().map(|bivector| {
        let square = product(algebra, Product::Geometric, &bivector, &bivector);
        let scalar = only_scalar(&square)?;
        Some((bivector, scalar))
    });
    with_square.flatten().collect()
}

/// The directions and the constant blades, the scalar first.
fn starts(kind: &TypeDefinition, directions: &[(Blade, Numbers)]) -> Vec<(Blade, Numbers)> {
    let constants = kind.coefficients.iter();
    let constants = constants.filter(|c| matches!(c.role, Role::Constant(_)));
    let constants = constants.map(|c| (c.blade, Numbers::from([(c.blade, Number::ONE)])));
    let mut starts: Vec<_> = directions.iter().cloned().chain(constants).collect();
    starts.order_by_key(|(blade, _)| (blade.grade(), *blade));
    starts
}

/// A unit versor of each component that has one among the starts.
///
/// With a bivector b whose square is not zero, the identity component of the group has a multiple
/// of b, over the complex numbers at least. So blades that differ by such bivectors lie together.
fn seeds(
    algebra: &Algebra,
    starts: Vec<(Blade, Numbers)>,
    generators: &[(Numbers, Number)],
) -> Vec<Numbers> {
    let mut basis: Vec<u32> = Vec::new();
    let reduced = |basis: &[u32], mask: u32| {
        basis
            .iter()
            .fold(mask, |mask, vector| mask.min(mask ^ vector))
    };
    for (bivector, square) in generators {
        let mask = bivector.keys().next().map_or(0, |blade| blade.0);
        let mask = reduced(&basis, mask);
        if !square.is_zero() && mask != 0 {
            basis.push(mask);
            basis.order_by(|a, b| b.cmp(a));
        }
    }
    let mut classes: Vec<u32> = Vec::new();
    let mut seeds = Vec::new();
    for (blade, direction) in &starts {
        let class = reduced(&basis, blade.0);
        if classes.contains(&class) {
            continue;
        }
        let reverse = unary(algebra, Unary::Reverse, direction);
        let norm = product(algebra, Product::Geometric, direction, &reverse);
        if let Some(size) = only_scalar(&norm).and_then(size) {
            classes.push(class);
            seeds.push(scaled(direction, size.recip()));
        }
    }
    seeds
}

/// The root of a positive whole number, if it has one.
fn size(norm: Number) -> Option<Number> {
    let norm = norm.residue()?;
    // Negative numbers and fractions are large residues.
    let is_positive = norm.is_real() && (1..1 << 40).contains(&norm.residue());
    let root = norm.square_root().filter(|root| root.is_real())?;
    let real = Real::function(Function::SquareRoot, &[Real::exact(norm.residue() as f64)]);
    is_positive.then_some(Number::new(Some(root), real))
}

fn only_scalar(value: &Numbers) -> Option<Number> {
    let mut others = value.iter().filter(|(blade, _)| **blade != Blade::SCALAR);
    let is_scalar = others.all(|(_, number)| number.is_zero());
    is_scalar.then(|| coefficient(value, Blade::SCALAR))
}

/// `(1 + αb)²/(1 − α²b²)`, a unit versor for every bivector b whose square is a scalar.
fn unit_factor(algebra: &Algebra, bivector: &Numbers, square: Number, alpha: Number) -> Numbers {
    let norm = (Number::ONE - alpha * alpha * square).recip();
    let mut root = scaled(bivector, alpha);
    root.insert(Blade::SCALAR, Number::ONE);
    let versor = product(algebra, Product::Geometric, &root, &root);
    scaled(&versor, norm)
}

fn sum(mut a: Numbers, b: &Numbers) -> Numbers {
    for (&blade, &number) in b {
        add(&mut a, blade, number);
    }
    a
}

/// The dimension of the space that multivectors span, by elimination.
fn rank(mut rows: Vec<Numbers>) -> usize {
    let mut rank = 0;
    while let Some(mut row) = rows.pop() {
        row.retain(|_, number| !number.is_zero());
        let Some((&blade, &pivot)) = row.iter().next() else {
            continue;
        };
        rank += 1;
        for other in &mut rows {
            let factor = -(coefficient(other, blade) * pivot.recip());
            *other = sum(std::mem::take(other), &scaled(&row, factor));
        }
    }
    rank
}
