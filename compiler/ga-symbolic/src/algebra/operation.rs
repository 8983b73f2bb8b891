//! What the operations of an algebra do to basis blades.

use super::{Algebra, Blade, BladeSum, Product, Ratio, Unary};

impl Product {
    /// The product of two basis blades.
    #[must_use]
    pub fn of_blades(self, algebra: &Algebra, left: Blade, right: Blade) -> BladeSum {
        let make = || self.made(algebra, left, right).into();
        algebra.products.get(self, left, right, make)
    }

    fn made(self, algebra: &Algebra, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
        let (r, s) = (left.grade(), right.grade());
        let of_grade = |grade: Option<u32>| -> Vec<(Blade, Ratio)> {
            let Some(grade) = grade else { return vec![] };
            let mut terms = algebra.geometric(left, right).to_vec();
            terms.retain(|(blade, _)| blade.grade() == grade);
            terms
        };
        match self {
            Self::Geometric => algebra.geometric(left, right).to_vec(),
            Self::Wedge => {
                if left.0 & right.0 != 0 {
                    return vec![];
                }
                let sign = if left.wedge_is_negative(right) { -1 } else { 1 };
                vec![(Blade(left.0 | right.0), Ratio::integer(sign))]
            }
            Self::LeftContraction => of_grade(s.checked_sub(r)),
            Self::RightContraction => of_grade(r.checked_sub(s)),
            Self::ScalarProduct => of_grade(Some(0)),
            Self::Commutator => commutator(algebra, left, right),
            Self::Vee => vee(algebra, left, right),
        }
    }
}

impl Unary {
    /// The operation on a basis blade.
    #[must_use]
    pub fn of_blade(self, algebra: &Algebra, blade: Blade) -> Vec<(Blade, Ratio)> {
        let signed = |is_negative: bool| {
            let sign = if is_negative { -1 } else { 1 };
            vec![(blade, Ratio::integer(sign))]
        };
        match self {
            Self::Reverse => signed(blade.reverse_is_negative()),
            Self::Involute => signed(blade.involute_is_negative()),
            Self::Conjugate => signed(blade.conjugate_is_negative()),
            Self::Dual => algebra.dual(blade),
            Self::Undual => algebra.undual(blade),
            Self::Grade(grade) if blade.grade() == grade => signed(false),
            Self::Grade(_) => vec![],
        }
    }
}

fn commutator(algebra: &Algebra, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
    let half = Ratio::ONE / Ratio::integer(2);
    let mut sums = Sums::default();
    for &(blade, value) in algebra.geometric(left, right).iter() {
        sums.add(blade, value * half);
    }
    for &(blade, value) in algebra.geometric(right, left).iter() {
        sums.add(blade, -(value * half));
    }
    sums.finish()
}

fn vee(algebra: &Algebra, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
    let mut sums = Sums::default();
    for (a, first) in algebra.dual(left) {
        for (b, second) in algebra.dual(right) {
            for &(joined, third) in Product::Wedge.of_blades(algebra, a, b).iter() {
                for (blade, fourth) in algebra.undual(joined) {
                    sums.add(blade, first * second * third * fourth);
                }
            }
        }
    }
    sums.finish()
}

#[derive(Default)]
struct Sums(std::collections::BTreeMap<Blade, Ratio>);

impl Sums {
    fn add(&mut self, blade: Blade, value: Ratio) {
        let sum = self.0.entry(blade).or_insert(Ratio::ZERO);
        *sum = *sum + value;
    }

    fn finish(self) -> Vec<(Blade, Ratio)> {
        self.0
            .into_iter()
            .filter(|(_, value)| !value.is_zero())
            .collect()
    }
}
