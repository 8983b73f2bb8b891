//! Random formulas, each spelled in several random ways.

use crate::algebras;
use crate::random::Random;

use super::count;

/// A multivector formula, by what it means.
#[derive(Clone, Debug)]
enum Formula {
    Name(&'static str),
    /// The product of two versors.
    Composed(Box<Formula>, Box<Formula>),
    Reversed(Box<Formula>),
    /// The action of a versor.
    Moved(Box<Formula>, Box<Formula>),
    /// The outer product of vectors.
    Joined(Vec<Formula>),
    Sum(Box<Formula>, Box<Formula>),
    Multiple(&'static str, Box<Formula>),
    Quotient(Box<Formula>, &'static str),
    /// The inner product of vectors.
    Inner(Box<Formula>, Box<Formula>),
    /// The regressive product.
    Met(Box<Formula>, Box<Formula>),
}

use Formula::{Composed, Inner, Joined, Met, Moved, Multiple, Name, Quotient, Reversed, Sum};

const OPERANDS: &str = "m: Motor, n: Motor, r: Rotor, p: Point, q: Point, x: RoundVector, \
                        a: Quadvector, b: Plane, s: Scalar, t: Scalar";

fn boxed(formula: Formula) -> Box<Formula> {
    Box::new(formula)
}

fn versor(random: &mut Random, depth: usize) -> Formula {
    match random.below(if depth == 0 { 3 } else { 6 }) {
        0..=2 => Name(random.pick(&["m", "n", "r"])),
        3 | 4 => Composed(
            boxed(versor(random, depth - 1)),
            boxed(versor(random, depth - 1)),
        ),
        _ => Reversed(boxed(versor(random, depth - 1))),
    }
}

fn vector(random: &mut Random, depth: usize) -> Formula {
    match random.below(if depth == 0 { 2 } else { 7 }) {
        0 | 1 => Name(random.pick(&["p", "q", "x"])),
        2 | 3 => Moved(boxed(versor(random, 1)), boxed(vector(random, depth - 1))),
        4 => Sum(
            boxed(vector(random, depth - 1)),
            boxed(vector(random, depth - 1)),
        ),
        5 => Multiple(
            random.pick(&["2", "s", "0.5"]),
            boxed(vector(random, depth - 1)),
        ),
        _ => Quotient(
            boxed(vector(random, depth - 1)),
            random.pick(&["s", "t", "4"]),
        ),
    }
}

/// A formula and the type of its value.
fn formula(random: &mut Random) -> (Formula, &'static str) {
    match random.below(6) {
        0 => (vector(random, 3), "RoundVector"),
        1 => {
            let pair = Joined(vec![vector(random, 1), vector(random, 1)]);
            (pair, "Bivector")
        }
        2 => {
            let pair = Joined(vec![vector(random, 0), vector(random, 0)]);
            (Moved(boxed(versor(random, 1)), boxed(pair)), "Bivector")
        }
        3 => {
            let inner = Inner(boxed(vector(random, 2)), boxed(vector(random, 1)));
            (inner, "Scalar")
        }
        4 => {
            let met = Met(boxed(Name("a")), boxed(Name("b")));
            (Moved(boxed(versor(random, 1)), boxed(met)), "Trivector")
        }
        _ => {
            let versor = versor(random, 2);
            (Composed(boxed(versor), boxed(Name("m"))), "Motor")
        }
    }
}

/// The formula in one of its spellings.
fn spell(formula: &Formula, random: &mut Random) -> String {
    if random.below(12) == 0 {
        return format!("(-(-{}))", spell(formula, random));
    }
    match formula {
        Name(name) => (*name).to_owned(),
        Composed(a, b) => {
            if random.below(4) == 0 {
                let (a, b) = (Reversed(a.clone()), Reversed(b.clone()));
                let (a, b) = (spell(&a, random), spell(&b, random));
                return format!("rev({b} * {a})");
            }
            if let Composed(first, second) = &**a
                && random.below(2) == 0
            {
                let inner = Composed(second.clone(), b.clone());
                return spell(&Composed(first.clone(), boxed(inner)), random);
            }
            format!("({} * {})", spell(a, random), spell(b, random))
        }
        Reversed(a) => match &**a {
            Reversed(a) if random.below(2) == 0 => spell(a, random),
            Composed(a, b) if random.below(2) == 0 => {
                let (a, b) = (Reversed(a.clone()), Reversed(b.clone()));
                spell(&Composed(boxed(b), boxed(a)), random)
            }
            a => {
                let name = random.pick(&["rev", "reverse", "inverse", "inv"]);
                format!("{name}({})", spell(a, random))
            }
        },
        Moved(m, x) => spell_moved(m, x, random),
        Joined(parts) => {
            let parts: Vec<String> = parts.iter().map(|part| spell(part, random)).collect();
            let [a, b] = parts.as_slice() else {
                panic!("two vectors")
            };
            match random.below(4) {
                0 | 1 => format!("({a} ^ {b})"),
                2 => format!("(-({b} ^ {a}))"),
                _ => format!("((({a} * {b}) - ({b} * {a})) / 2)"),
            }
        }
        Sum(a, b) => {
            let (a, b) = (spell(a, random), spell(b, random));
            match random.below(3) {
                0 => format!("({a} + {b})"),
                1 => format!("({b} + {a})"),
                _ => format!("({a} - (-{b}))"),
            }
        }
        Multiple(scalar, a) => {
            let a = spell(a, random);
            match random.below(2) {
                0 => format!("({scalar} * {a})"),
                _ => format!("({a} * {scalar})"),
            }
        }
        Quotient(a, scalar) => {
            let a = spell(a, random);
            match random.below(3) {
                0 => format!("({a} / {scalar})"),
                1 => format!("({a} * (1 / {scalar}))"),
                _ => format!("(-{a} / (-{scalar}))"),
            }
        }
        Inner(a, b) => {
            let (a, b) = (spell(a, random), spell(b, random));
            match random.below(5) {
                0 => format!("({a} | {b})"),
                1 => format!("({b} | {a})"),
                2 => format!("scalar_product({a}, {b})"),
                3 => format!("grade({a} * {b}, 0)"),
                _ => format!("(({a} * {b} + {b} * {a}) / 2)"),
            }
        }
        Met(a, b) => {
            let (a, b) = (spell(a, random), spell(b, random));
            match random.below(3) {
                0 => format!("({a} & {b})"),
                1 => format!("undual(dual({a}) ^ dual({b}))"),
                _ => format!("vee({a}, {b})"),
            }
        }
    }
}

/// An action, written as a product, moved over the parts of its operand, split or composed.
fn spell_moved(m: &Formula, x: &Formula, random: &mut Random) -> String {
    let moved = |x: &Formula| Moved(boxed(m.clone()), boxed(x.clone()));
    if random.below(2) == 0 {
        match (m, x) {
            (Composed(a, b), x) if random.below(2) == 0 => {
                let inner = Moved(b.clone(), boxed(x.clone()));
                return spell(&Moved(a.clone(), boxed(inner)), random);
            }
            (_, Moved(n, x)) => {
                let both = Composed(boxed(m.clone()), n.clone());
                return spell(&Moved(boxed(both), x.clone()), random);
            }
            (_, Sum(a, b)) => return spell(&Sum(boxed(moved(a)), boxed(moved(b))), random),
            (_, Joined(parts)) => {
                return spell(&Joined(parts.iter().map(moved).collect()), random);
            }
            (_, Met(a, b)) => return spell(&Met(boxed(moved(a)), boxed(moved(b))), random),
            (_, Multiple(scalar, x)) => {
                return spell(&Multiple(scalar, boxed(moved(x))), random);
            }
            (_, Quotient(x, scalar)) => {
                return spell(&Quotient(boxed(moved(x)), scalar), random);
            }
            _ => {}
        }
    }
    let (left, x, right) = (spell(m, random), spell(x, random), spell(m, random));
    match random.below(5) {
        0 => format!("sandwich({left}, {x})"),
        1 => format!("transform({left}, {x})"),
        2 => format!("({left} * {x} * rev({right}))"),
        3 => format!("({left} * ({x} * rev({right})))"),
        _ => format!("({left} * {x} * inverse({right}))"),
    }
}

/// The types of the operands that a formula names, so that no spelling has others.
fn operands(formula: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let words: Vec<&str> = formula.split(|c| !is_word(c)).collect();
    let used: Vec<&str> = OPERANDS
        .split(", ")
        .filter(|operand| words.contains(&operand.split(':').next().expect("a name")))
        .collect();
    used.join(", ")
}

#[test]
fn random_spellings_cost_the_same() {
    let groups = std::env::var("SPELLING_GROUPS").map_or(24, |n| n.parse().expect("a number"));
    let seed = std::env::var("SPELLING_SEED").map_or(1, |n| n.parse().expect("a number"));
    let cga3 = algebras::cga3();
    let mut missed = String::new();
    for group in 0..groups {
        let mut random = Random((seed + group as u64) * 7919 + 17);
        let (formula, result) = formula(&mut random);
        let mut costs = Vec::new();
        let mut operand_list = None;
        for _ in 0..4 {
            let text = spell(&formula, &mut random);
            let types = operand_list.get_or_insert_with(|| operands(&text)).clone();
            if operands(&text) != types {
                continue;
            }
            costs.push((count(&cga3, &format!("{types} -> {result}"), &text), text));
        }
        if costs.iter().any(|(cost, _)| *cost != costs[0].0) {
            missed += &format!("{group}: {formula:?}\n");
            for (cost, text) in costs {
                missed += &format!("    {cost:?}  {{ {text} }}\n");
            }
        }
    }
    assert!(missed.is_empty(), "{missed}");
}
