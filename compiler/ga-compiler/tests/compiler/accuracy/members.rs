//! Members of the types of cga3 for tests of accuracy, in twice the precision of `f64`: objects
//! through points that are far from the origin, nearly equal or nearly on one line.

use std::collections::BTreeMap;

use ga_compiler::algebra::{Algebra, Blade, Product, Unary};
use ga_compiler::define::TypeDefinition;

use super::number::Number;
use super::twofold::Twofold;

/// A multivector.
type Numbers = BTreeMap<Blade, Twofold>;

/// How points lie to each other, and how versors move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Family {
    /// Within some units of the origin.
    Ordinary,
    /// Within a unit of each other, 10⁴ units from the origin; translations as long.
    Far,
    /// Within 10⁻⁶ of each other; rotations as small.
    Close,
    /// On one line up to 10⁻⁶.
    Sliver,
    /// Two by two within 10⁻⁶ of each other.
    Pairs,
}

impl Family {
    pub(crate) const ALL: [Self; 5] = [
        Self::Ordinary,
        Self::Far,
        Self::Close,
        Self::Sliver,
        Self::Pairs,
    ];
}

/// A source of members: a linear congruential generator (Knuth's MMIX).
pub(crate) struct Source<'a> {
    algebra: &'a Algebra,
    family: Family,
    state: u64,
    base: [f64; 3],
    direction: [f64; 3],
    /// How many points there are already.
    points: usize,
}

impl<'a> Source<'a> {
    pub(crate) fn new(algebra: &'a Algebra, family: Family, seed: u64) -> Self {
        let mut source = Self {
            algebra,
            family,
            state: seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1,
            base: [0.0; 3],
            direction: [0.0; 3],
            points: 0,
        };
        let reach = if family == Family::Far { 1e4 } else { 1.0 };
        source.base = [(); 3].map(|()| reach * source.next());
        source.direction = [(); 3].map(|()| source.next());
        source
    }

    /// A number between −1 and 1.
    fn next(&mut self) -> f64 {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// The stored coefficients of the next member.
    pub(crate) fn member(&mut self, kind: &TypeDefinition) -> Vec<Twofold> {
        let value = if kind.facts.unit_versor {
            self.versor(kind)
        } else {
            self.object(kind)
        };
        kind.stored()
            .map(|c| {
                let found = value.get(&c.blade).copied().unwrap_or_default();
                let sign = if c.is_negative { -1.0 } else { 1.0 };
                found.product(Twofold::of(sign))
            })
            .collect()
    }

    fn place(&mut self) -> [f64; 3] {
        if self.family == Family::Pairs && self.points.is_multiple_of(2) {
            self.base = [(); 3].map(|()| self.next());
        }
        self.points += 1;
        let along = self.next();
        let noise = match self.family {
            Family::Ordinary | Family::Far => 1.0,
            Family::Close | Family::Sliver | Family::Pairs => 1e-6,
        };
        let along = if self.family == Family::Sliver {
            along
        } else {
            0.0
        };
        let (base, direction) = (self.base, self.direction);
        [0, 1, 2].map(|axis| base[axis] + along * direction[axis] + noise * self.next())
    }

    fn vector(&self, place: [f64; 3], weight: f64, square: Twofold) -> Numbers {
        let half = Twofold::of(0.5 * weight);
        let mut vector = self.named(&[
            ("e1", weight * place[0]),
            ("e2", weight * place[1]),
            ("e3", weight * place[2]),
            ("eo", weight),
        ]);
        vector.insert(self.blade("ei"), square.product(half));
        vector
    }

    fn point(&mut self) -> Numbers {
        let place = self.place();
        self.vector(place, 1.0, norm(place))
    }

    /// The wedge of points, and infinity where it is flat; other coefficients at random.
    fn object(&mut self, kind: &TypeDefinition) -> Numbers {
        let grade = kind.coefficients[0].blade.grade();
        let has = |name: &str| kind.coefficient(self.blade(name)).is_some();
        let has_origin = kind
            .coefficients
            .iter()
            .any(|c| c.blade.contains(3) && !c.blade.contains(4));
        match (grade, has_origin) {
            (1, true) if kind.facts.null => self.point(),
            (1, true) => {
                let (place, radius) = (self.place(), self.next());
                let square = norm(place).sum(Twofold::of(-radius * radius));
                let weight = 1.0 + self.next() / 2.0;
                rounded(self.vector(place, weight, square))
            }
            (1, false) if has("ei") => {
                // The plane through a point.
                let (place, normal) = (self.place(), self.direction.map(|x| x + 0.1));
                let distance = (0..3).fold(Twofold::default(), |sum, axis| {
                    sum.sum(Twofold::of(place[axis]).product(Twofold::of(normal[axis])))
                });
                let mut plane =
                    self.named(&[("e1", normal[0]), ("e2", normal[1]), ("e3", normal[2])]);
                plane.insert(self.blade("ei"), distance);
                rounded(plane)
            }
            (grade @ 2..=4, _) => {
                let points = if has_origin { grade } else { grade - 1 };
                let mut joined = self.point();
                for _ in 1..points {
                    let next = self.point();
                    joined = self.product(Product::Wedge, &joined, &next);
                }
                if !has_origin {
                    let infinity = self.named(&[("ei", 1.0)]);
                    joined = self.product(Product::Wedge, &joined, &infinity);
                }
                rounded(joined)
            }
            _ => kind
                .coefficients
                .iter()
                .map(|c| (c.blade, Twofold::of(self.next())))
                .collect(),
        }
    }

    /// A product of `(1 + αb)²/(1 − α²b²)` over the 2-blades b of the type, or those that its
    /// vectors span, times a vector for odd versors.
    fn versor(&mut self, kind: &TypeDefinition) -> Numbers {
        let blades = kind.coefficients.iter().map(|c| c.blade);
        let is_odd = blades.clone().all(|blade| blade.grade() % 2 == 1);
        let vectors: Vec<Blade> = blades.clone().filter(|b| b.grade() == 1).collect();
        let mut planes: Vec<Blade> = blades.filter(|b| b.grade() == 2).collect();
        for (place, a) in vectors.iter().enumerate() {
            planes.extend(vectors[place + 1..].iter().map(|b| Blade(a.0 | b.0)));
        }
        let size = if self.family == Family::Close {
            1e-6
        } else {
            0.7
        };
        let mut versor = if is_odd {
            self.named(&[("e1", 1.0)])
        } else {
            Numbers::from([(Blade::SCALAR, Twofold::of(1.0))])
        };
        for plane in planes {
            let is_translation = plane.contains(4) && !plane.contains(3);
            let size = if is_translation && self.family == Family::Far {
                1e4
            } else {
                size
            };
            let alpha = Twofold::of(size * self.next());
            let factor = self.factor(plane, alpha);
            versor = self.product(Product::Geometric, &factor, &versor);
        }
        versor
    }

    fn factor(&self, plane: Blade, alpha: Twofold) -> Numbers {
        let root = Numbers::from([(Blade::SCALAR, Twofold::of(1.0)), (plane, alpha)]);
        let reverse = self.unary(Unary::Reverse, &root);
        let norm = self.product(Product::ScalarProduct, &root, &reverse)[&Blade::SCALAR];
        let square = self.product(Product::Geometric, &root, &root);
        square
            .into_iter()
            .map(|(blade, value)| (blade, value.quotient(norm)))
            .collect()
    }

    fn blade(&self, name: &str) -> Blade {
        let named = self.algebra.names().resolve(name).expect("a blade");
        named.blade
    }

    fn named(&self, parts: &[(&str, f64)]) -> Numbers {
        parts
            .iter()
            .map(|(name, value)| (self.blade(name), Twofold::of(*value)))
            .collect()
    }

    fn product(&self, operation: Product, left: &Numbers, right: &Numbers) -> Numbers {
        let mut result = Numbers::new();
        for (&a, &first) in left {
            for (&b, &second) in right {
                for &(blade, factor) in operation.of_blades(self.algebra, a, b).iter() {
                    let term = first.product(second).product(Twofold::of_ratio(factor));
                    let sum = result.entry(blade).or_default();
                    *sum = sum.sum(term);
                }
            }
        }
        result
    }

    fn unary(&self, operation: Unary, operand: &Numbers) -> Numbers {
        let images = operand.iter().flat_map(|(&blade, &value)| {
            let images = operation.of_blade(self.algebra, blade);
            images
                .into_iter()
                .map(move |(image, factor)| (image, value.product(Twofold::of_ratio(factor))))
        });
        images.collect()
    }
}

fn norm(place: [f64; 3]) -> Twofold {
    place.iter().fold(Twofold::default(), |sum, &x| {
        sum.sum(Twofold::of(x).product(Twofold::of(x)))
    })
}

/// The coefficients as `f64` holds them.
fn rounded(value: Numbers) -> Numbers {
    value
        .into_iter()
        .map(|(blade, number)| (blade, Twofold::of(number.rounded())))
        .collect()
}
