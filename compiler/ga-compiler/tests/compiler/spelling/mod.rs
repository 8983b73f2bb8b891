//! Spelling does not matter: formulas with the same meaning cost the same.

mod groups;
mod random;

use ga_compiler::count;
use ga_compiler::define::Definition;
use quote::quote;

use crate::algebras::{self, compile};
use groups::{Group, MINKOWSKI, PGA3, cga3};

/// Multiplications, additions, divisions and roots: of each call, and those done once.
type Cost = [(usize, usize, usize, usize); 2];

/// The cost of a function, of which the operands and the result are `types`.
#[track_caller]
fn count(definition: &Definition, types: &str, formula: &str) -> Cost {
    let (operands, result) = types.rsplit_once(" -> ").expect("a signature");
    let text = format!("fn kernel({operands}) -> {result} {{ {formula} }}");
    let function = compile(definition, &text);
    let counted = count::function(definition, &quote!(algebra), &function);
    let counted = counted.expect("operations that are known");
    [counted.call, counted.uniform].map(|found| {
        let count::Operations {
            multiplications,
            additions,
            divisions,
            roots,
            ..
        } = found;
        (multiplications, additions, divisions, roots)
    })
}

/// The types by parameters as those of all multivectors of their grades.
const BY_BLADES: [(&str, &str); 3] = [
    ("PointPair", "Bivector"),
    ("Circle", "Trivector"),
    ("Sphere", "Quadvector"),
];

/// The names in [`algebras::renamed`].
const RENAMED: [(&str, &str); 12] = [
    ("RoundVector", "Weighted"),
    ("Bivector", "Pair"),
    ("Point", "Place"),
    ("Motor", "Motion"),
    ("Plane", "Flat"),
    ("Quadvector", "Ball"),
    ("Line", "Axis"),
    ("Trivector", "Ring"),
    ("Rotor", "Rotation"),
    ("Translator", "Translation"),
    ("ei", "infinity"),
    ("eo", "origin"),
];

fn renamed(text: &str, names: &[(&str, &str)]) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut result = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| is_word(c) != is_word(first));
        let (word, after) = rest.split_at(end.unwrap_or(rest.len()));
        let name = names.iter().find(|(name, _)| *name == word);
        result += name.map_or(word, |(_, name)| name);
        rest = after;
    }
    result
}

/// Compares the spellings of each group; `change` brings them into the algebra. Returns the costs.
fn check(definition: &Definition, groups: &[Group], change: impl Fn(&str) -> String) -> Vec<Cost> {
    let mut missed = String::new();
    let mut found = Vec::new();
    for (types, spellings) in groups {
        let costs: Vec<Cost> = spellings
            .iter()
            .map(|spelling| count(definition, &change(types), &change(spelling)))
            .collect();
        if costs.iter().any(|cost| *cost != costs[0]) {
            missed += &format!("{types}\n");
            for (cost, spelling) in costs.iter().zip(*spellings) {
                missed += &format!("    {cost:?} {{ {spelling} }}\n");
            }
        }
        found.push(costs[0]);
    }
    assert!(missed.is_empty(), "{missed}");
    found
}

#[test]
fn spellings_cost_the_same() {
    check(&algebras::cga3(), &cga3(), str::to_owned);
    check(&algebras::pga3(), PGA3, str::to_owned);
    check(&algebras::minkowski(), MINKOWSKI, str::to_owned);
}

#[test]
fn spellings_cost_the_same_under_other_names() {
    let is_there = |(types, spellings): &Group| {
        let text = spellings.concat() + types;
        let others = [
            "Scalar",
            "Dual",
            "Similarity",
            "Dilator",
            "Generator",
            "FlatPoint",
            "Even",
            "e1",
        ];
        !others.iter().any(|other| text.contains(other)) || *types == "p: Point, q: Point -> Scalar"
    };
    let groups: Vec<Group> = cga3().into_iter().filter(is_there).collect();
    assert!(groups.len() > 12, "{}", groups.len());
    let by_blades = |text: &str| renamed(text, &BY_BLADES);
    let other = check(&algebras::renamed(), &groups, |text| {
        renamed(&by_blades(text), &RENAMED)
    });
    let cga3 = check(&algebras::cga3(), &groups, by_blades);
    for ((group, [other, _]), [cga3, _]) in groups.iter().zip(other).zip(cga3) {
        assert_eq!(other, cga3, "{group:?}");
    }
}

/// A function that is called costs what its body does in place of the call.
#[test]
fn calls_cost_what_their_bodies_cost() {
    let cga3 = algebras::cga3();
    let both = "fn both(m: Motor, n: Motor, p: Point) -> Point { move_by(m * n, p) } \
                fn move_by(k: Motor, x: Point) -> Point { k * x * rev(k) }";
    let nested = "fn both(m: Motor, n: Motor, p: Point) -> Point { move_by(m, move_by(n, p)) } \
                  fn move_by(k: Motor, x: Point) -> Point { sandwich(k, x) }";
    for text in [both, nested] {
        let kernel = compile(&cga3, text).kernel;
        let cost = kernel.cost();
        assert_eq!((cost.multiplications, cost.additions), (42, 36), "{text}");
    }
}
