//! Every rule rounds about as well as the plain meaning, near degenerate cases too.
//!
//! Kernels are evaluated in `f64` and compared with the plain form in twice the precision. A rule
//! may have at most [`MOST`] times the largest error of the plain form, or as many units in the
//! last place of the largest value, for each coefficient of the result.

mod members;
mod number;
#[path = "../../../../../tests/src/twofold.rs"]
mod twofold;

use ga_compiler::define::Definition;
use ga_compiler::forms::FormRule;
use ga_compiler::ir::{Function, Node, Value};
use ga_compiler::kernel::{Kernel, wanted};
use ga_compiler::lower::{
    Choice, Choices, InnerRule, JoinRule, MeetRule, ProjectionRule, SandwichRule,
};
use ga_compiler::parse::{Block, parse_functions};
use ga_compiler::resolve::{Resolved, resolve};
use ga_compiler::task::Task;

use crate::algebras::cga3;
use members::{Family, Source};
use number::Number;
use twofold::Twofold;

/// How much worse than the plain form a rule may be.
const MOST: f64 = 8.0;

/// How many members are tried of each family.
const SAMPLES: u64 = 60;

/// Actions with the rules for actions.
const ACTIONS: [&str; 20] = [
    "m: Motor, x: Point -> RoundVector { sandwich(m, x) }",
    "m: Motor, x: RoundVector -> RoundVector { sandwich(m, x) }",
    "m: Motor, x: Line -> Line { sandwich(m, x) }",
    "m: Motor, x: Circle -> Circle { sandwich(m, x) }",
    "m: DualSphere, x: Point -> RoundVector { sandwich(m, x) }",
    "m: DualSphere, x: RoundVector -> RoundVector { sandwich(m, x) }",
    "m: DualSphere, x: Line -> Circle { sandwich(m, x) }",
    "m: DualPlane, x: Point -> RoundVector { sandwich(m, x) }",
    "m: DualPlane, x: Circle -> Circle { sandwich(m, x) }",
    "m: Plane, x: Line -> Line { sandwich(m, x) }",
    "m: Sphere, x: PointPair -> PointPair { sandwich(m, x) }",
    "m: EvenVersor, x: Point -> RoundVector { sandwich(m, x) }",
    "m: OddVersor, x: Point -> RoundVector { sandwich(m, x) }",
    "m: OddVersor, x: Line -> Circle { sandwich(m, x) }",
    "m: Similarity, x: Point -> RoundVector { sandwich(m, x) }",
    "m: Similarity, x: Line -> Line { sandwich(m, x) }",
    "m: Similarity, x: Circle -> Circle { sandwich(m, x) }",
    "m: Similarity, x: Sphere -> Sphere { sandwich(m, x) }",
    "m: EvenVersor, x: RoundVector -> RoundVector { sandwich(m, x) }",
    "m: Similarity, x: Point -> Point { sandwich(m, x) / sandwich(m, x).eo }",
];

/// Rules that are worse than the plain form somewhere, and cost more than another rule there.
const WORSE: [(&str, SandwichRule); 7] = [
    (
        "m: EvenVersor, x: RoundVector -> RoundVector",
        SandwichRule::LinearMap,
    ),
    (
        "m: EvenVersor, x: Point -> RoundVector",
        SandwichRule::UnitCommutator,
    ),
    (
        "m: OddVersor, x: Point -> RoundVector",
        SandwichRule::LinearMap,
    ),
    (
        "m: OddVersor, x: Line -> Circle",
        SandwichRule::UnitCommutator,
    ),
    ("m: OddVersor, x: Line -> Circle", SandwichRule::LinearMap),
    (
        "m: Similarity, x: Circle -> Circle",
        SandwichRule::UnitCommutator,
    ),
    (
        "m: Similarity, x: Circle -> Circle",
        SandwichRule::LinearMap,
    ),
];

#[test]
fn rules_for_actions_round_well() {
    let rules = SandwichRule::ALL.map(Choice::from);
    check(&ACTIONS, &rules);
}

#[test]
fn what_is_chosen_for_actions_rounds_well() {
    check(&ACTIONS, &[]);
}

/// Images divided by their weight with the rules for that.
const PROJECTIONS: [&str; 3] = [
    "m: Similarity, x: Point -> Point { sandwich(m, x) / sandwich(m, x).eo }",
    "m: Dilator, x: Point -> Point { sandwich(m, x) / sandwich(m, x).eo }",
    "m: Motor, d: Dilator, x: Point -> Point {
        let y = sandwich(m, sandwich(d, x));
        y / y.eo
    }",
];

#[test]
fn rules_for_projections_round_well() {
    let rules = ProjectionRule::ALL.map(|projection| Choice {
        projection,
        ..Choice::default()
    });
    check(&PROJECTIONS, &rules);
}

#[test]
fn what_is_chosen_for_projections_rounds_well() {
    check(&PROJECTIONS, &[]);
}

/// Joins and inner products of points with the rules for them.
const PRODUCTS: [&str; 12] = [
    "a: Point, b: Point -> Scalar { a | b }",
    "a: Point, b: Point -> PointPair { a ^ b }",
    "a: Point, b: Point, c: Point -> Circle { a ^ b ^ c }",
    "a: Point, b: Point, c: Point -> Plane { a ^ b ^ c ^ ei }",
    "a: Point, b: Point -> Scalar { norm_squared(a ^ b) }",
    "a: Point, b: Point, c: Point -> Scalar { norm_squared(a ^ b ^ c) }",
    "a: Point, b: Point, c: Point -> Scalar { norm_squared(a ^ b ^ c ^ ei) }",
    "a: Point, b: Point, c: Point, d: Point -> Scalar { (a ^ b) | (c ^ d) }",
    "a: Point, b: Point, c: Point -> Scalar {
        norm_squared(a ^ b ^ c) / norm_squared(a ^ b ^ c ^ ei)
    }",
    "a: Point, b: Point, c: Point, p: Point, q: Point -> FlatPoint {
        (a ^ b ^ c ^ ei) & (p ^ q ^ ei)
    }",
    "s: Plane, p: Point, q: Point -> FlatPoint { (p ^ q ^ ei) & s }",
    "s: Sphere, p: Point, q: Point -> PointPair { s & (p ^ q ^ ei) }",
];

#[test]
fn rules_for_products_round_well() {
    let joins = JoinRule::ALL.map(|join| Choice {
        join,
        ..Choice::default()
    });
    let inner = InnerRule::ALL.map(|inner| Choice {
        inner,
        ..Choice::default()
    });
    let meets = MeetRule::ALL.map(|meet| Choice {
        meet,
        ..Choice::default()
    });
    check(&PRODUCTS, &[joins.as_slice(), &inner, &meets].concat());
}

/// The plain form of a distance between near points cancels, and the test shows it.
#[test]
fn cancellation_is_noticed() {
    let definition = cga3();
    let case = Case::new(&definition, PRODUCTS[0]);
    let distance = Choice {
        inner: InnerRule::Distance,
        ..Choice::default()
    };
    let [plain, distance] = [Choice::default(), distance].map(|rule| case.compile(Some(rule)));
    let samples = case.samples(Family::Close);
    let exact = samples.iter().map(|sample| evaluate(&plain, sample));
    let exact: Vec<Vec<Twofold>> = exact.collect();
    let [plain, distance] = [plain, distance].map(|kernel| errors(&kernel, &samples, &exact)[0]);
    assert!(plain > 1000.0 * distance, "{plain}, {distance}");
}

#[test]
fn what_is_chosen_for_products_rounds_well() {
    check(&PRODUCTS, &[]);
}

/// Functions with the rules for forms.
const FORMS: [(FormRule, &str); 29] = [
    (
        FormRule::Vector,
        "p: Point, a: DualPlane -> RoundVector { (p ^ a) * inverse(a) }",
    ),
    (
        FormRule::Adjoint,
        "m: Motor, p: Point, a: DualPlane -> Scalar { p | sandwich(m, a) }",
    ),
    (
        FormRule::Difference,
        "m: Motor, a: Point, b: Point, c: Point -> Circle { sandwich(m, a ^ b ^ c) }",
    ),
    (
        FormRule::Difference,
        "m: Motor, a: Point, b: Point -> Line { sandwich(m, a ^ b ^ ei) }",
    ),
    (
        FormRule::Associativity,
        "m: Motor, n: Motor, k: Motor -> DualQuaternion { m * n * k }",
    ),
    (
        FormRule::Composition,
        "m: Motor, n: Motor, x: Point -> RoundVector { sandwich(m * n, x) }",
    ),
    (
        FormRule::Composition,
        "m: Motor, n: Motor, x: Line -> Line { sandwich(m, sandwich(n, x)) }",
    ),
    (
        FormRule::Conjugation,
        "m: Motor, n: Motor -> DualQuaternion { n * m * n * rev(m) }",
    ),
    (
        FormRule::Outermorphism,
        "m: Motor, a: Point, b: Point -> PointPair { sandwich(m, a) ^ sandwich(m, b) }",
    ),
    (
        FormRule::Outermorphism,
        "m: Motor, a: Point, b: Point -> PointPair { sandwich(m, a ^ b) }",
    ),
    (
        FormRule::Outermorphism,
        "m: Motor, a: Point, b: Point, c: Point -> Plane { sandwich(m, a ^ b ^ c ^ ei) }",
    ),
    (
        FormRule::Outermorphism,
        "m: Motor, a: Point, b: Point -> Scalar { sandwich(m, a) | sandwich(m, b) }",
    ),
    (
        FormRule::Outermorphism,
        "m: Motor, a: Sphere, b: Plane -> Circle { sandwich(m, a) & sandwich(m, b) }",
    ),
    (
        FormRule::Linearity,
        "m: Motor, a: Point, b: Point -> RoundVector { sandwich(m, a) - sandwich(m, b) }",
    ),
    (
        FormRule::InvariantPart,
        "m: Motor, n: Motor -> DualQuaternion { m * n * rev(m) }",
    ),
    (FormRule::Power, "m: Motor -> DualQuaternion { m * m }"),
    (
        FormRule::Power,
        "m: Motor -> DualQuaternion { m * m * m * m }",
    ),
    (
        FormRule::Definition,
        "a: Line, b: Line -> MotorGenerator { (a * b - b * a) / 2 }",
    ),
    (
        FormRule::Duality,
        "a: Sphere, b: Sphere -> Circle { undual(dual(a) ^ dual(b)) }",
    ),
    (
        FormRule::Quotient,
        "s: RoundVector, a: Point, b: RoundVector -> PointPair { (a / s.eo) ^ b }",
    ),
    (
        FormRule::Distribution,
        "a: Point, b: Point, c: Point -> PointPair { (a ^ b) - (a ^ c) }",
    ),
    (
        FormRule::Distribution,
        "a: Point, b: Point -> Scalar { (a - b) | (a - b) }",
    ),
    (
        FormRule::Reversal,
        "m: Motor, n: Motor -> DualQuaternion { rev(m * n) }",
    ),
    (
        FormRule::Frame,
        "a: Point, b: Point, c: Point -> Point { point(a ^ b ^ c) }",
    ),
    (
        FormRule::Frame,
        "p: Point, a: Point, b: Point -> Point { point((p | (a ^ b ^ ei)) * inverse(a ^ b ^ ei)) }",
    ),
    (
        FormRule::Frame,
        "c: Point, r: Scalar, p: Point -> Point { point(sandwich(c - r * r / 2 * ei, p)) }",
    ),
    (
        FormRule::Frame,
        "p: Point, d: Direction, c: Point, r: Scalar -> Scalar {
            norm_squared((p ^ d) & undual(c - r * r / 2 * ei))
        }",
    ),
    (
        FormRule::Unnormalised,
        "m: Motor, n: Motor, t: Scalar, p: Point -> Point { sandwich(normalize(m + t * n), p) }",
    ),
    (
        FormRule::ScalarFactor,
        "s: Scalar, a: Point, b: Point, c: Point -> Circle { (s * (a ^ b)) ^ c }",
    ),
];

#[test]
fn rules_for_forms_round_well() {
    let mut missed = String::new();
    let definition = cga3();
    for rule in FormRule::ALL {
        assert!(FORMS.iter().any(|(other, _)| *other == rule), "{rule:?}");
    }
    for (rule, source) in FORMS {
        let case = Case::new(&definition, source);
        let plain = case.compile(Some(Choice::default()));
        compare(
            &case,
            source,
            &plain,
            &[case.compile_form(rule)],
            &mut missed,
        );
    }
    assert!(missed.is_empty(), "{missed}");
}

#[test]
fn what_is_chosen_of_forms_rounds_well() {
    let sources: Vec<&str> = FORMS.iter().map(|(_, source)| *source).collect();
    check(&sources, &[]);
}

/// Compares every rule, or the kernel that is chosen if none is given, with the plain form, in
/// every case and family.
fn check(cases: &[&str], rules: &[Choice]) {
    let definition = cga3();
    let mut missed = String::new();
    for source in cases {
        let case = Case::new(&definition, source);
        let plain = case.compile(Some(Choice::default()));
        let is_worse = |choice: &Choice| {
            let mut worse = WORSE.iter();
            worse.any(|(name, rule)| source.starts_with(name) && choice.sandwich == *rule)
        };
        let rules = rules.iter().filter(|choice| !is_worse(choice));
        let mut kernels: Vec<Kernel> = rules.map(|rule| case.compile(Some(*rule))).collect();
        if kernels.is_empty() {
            kernels.push(case.compile(None));
        }
        compare(&case, source, &plain, &kernels, &mut missed);
    }
    assert!(missed.is_empty(), "{missed}");
}

/// Compares kernels with the plain form in every family.
fn compare(case: &Case<'_>, source: &str, plain: &Kernel, kernels: &[Kernel], missed: &mut String) {
    for family in Family::ALL {
        let samples = case.samples(family);
        let exact = samples.iter().map(|sample| evaluate(plain, sample));
        let exact: Vec<Vec<Twofold>> = exact.collect();
        let before = errors(plain, &samples, &exact);
        for kernel in kernels {
            let after = errors(kernel, &samples, &exact);
            for (place, (after, before)) in after.iter().zip(&before).enumerate() {
                let worst = after / before;
                if worst > MOST {
                    let names = kernel.choices.names();
                    *missed += &format!("{source} {family:?} {names:?} [{place}]: {worst:.1}\n");
                }
            }
        }
    }
}

/// One function.
struct Case<'a> {
    definition: &'a Definition,
    resolved: Resolved<'a>,
}

/// The inputs of a kernel, in twice the precision.
type Sample = Vec<Twofold>;

impl<'a> Case<'a> {
    fn new(definition: &'a Definition, source: &str) -> Self {
        let (operands, rest) = source.split_once(" -> ").expect("a signature");
        let tokens = format!("fn kernel({operands}) -> {rest}").parse();
        let block = Block {
            functions: parse_functions(tokens.expect("tokens")).expect("a function"),
            imports: Vec::new(),
        };
        let resolved = resolve(definition, &block.functions[0], &block);
        Self {
            definition,
            resolved: resolved.expect("names have a meaning"),
        }
    }

    /// The kernel by given rules, or by those that are chosen.
    fn compile(&self, choice: Option<Choice>) -> Kernel {
        let outputs = self.resolved.outputs.iter();
        let outputs = outputs.map(|(step, kind)| (*step, wanted(*kind)));
        let algebra = &self.definition.algebra;
        let task = Task::of_program(algebra, &self.resolved.program, outputs.collect());
        match choice {
            Some(choice) => task.with_choices(choice).compile(),
            None => task.with_witness(&self.resolved.witness).compile(),
        }
    }

    /// The kernel of the form that a rule leads to.
    fn compile_form(&self, rule: FormRule) -> Kernel {
        let outputs = self.resolved.outputs.iter();
        let outputs = outputs.map(|(step, kind)| (*step, wanted(*kind)));
        let choices = Choices {
            forms: vec![rule],
            ..Choices::default()
        };
        let kernel = Task::of_program(
            &self.definition.algebra,
            &self.resolved.program,
            outputs.collect(),
        )
        .with_witness(&self.resolved.witness)
        .with_choices(choices)
        .compile();
        assert!(kernel.choices.forms.contains(&rule), "no form by {rule:?}");
        kernel
    }

    fn samples(&self, family: Family) -> Vec<Sample> {
        let samples = (0..SAMPLES).map(|seed| {
            let mut source = Source::new(&self.definition.algebra, family, seed);
            let operands = self.resolved.program.operands.iter();
            operands.flat_map(|kind| source.member(kind)).collect()
        });
        samples.collect()
    }
}

/// The largest error of each output, at least a unit in the last place of its largest value.
fn errors(kernel: &Kernel, samples: &[Sample], exact: &[Vec<Twofold>]) -> Vec<f64> {
    let mut errors = vec![f64::MIN_POSITIVE; kernel.outputs.len()];
    for (sample, exact) in samples.iter().zip(exact) {
        let rounded: Vec<f64> = sample.iter().map(|number| number.rounded()).collect();
        let found = evaluate(kernel, &rounded);
        for ((error, found), exact) in errors.iter_mut().zip(found).zip(exact) {
            let difference = Twofold::of(found).sum(exact.product(Twofold::of(-1.0)));
            let unit = f64::EPSILON * exact.rounded().abs();
            *error = error.max(difference.rounded().abs()).max(unit);
        }
    }
    errors
}

/// The outputs of a kernel.
fn evaluate<N: Number>(kernel: &Kernel, inputs: &[N]) -> Vec<N> {
    let mut results: Vec<N> = Vec::new();
    let scaled = |results: &[N], value: &Value| {
        let node: N = results[value.node.index()];
        node.product(N::of_ratio(value.factor))
    };
    for id in kernel.arena.ids() {
        let result = match kernel.arena.node(id) {
            Node::One => N::of(1.0),
            Node::Input(number) => inputs[*number],
            Node::Sum(terms) => {
                let mut terms = terms.iter().map(|term| scaled(&results, term));
                let first = terms.next().expect("a term");
                terms.fold(first, N::sum)
            }
            Node::Product(a, b) => results[a.index()].product(results[b.index()]),
            Node::Quotient(a, b) => results[a.index()].quotient(results[b.index()]),
            Node::Function(Function::SquareRoot, arguments) => {
                scaled(&results, &arguments[0]).root()
            }
            Node::Function(Function::Divisor, arguments) => scaled(&results, &arguments[0]),
            Node::Function(Function::Reciprocal, arguments) => {
                N::of(1.0).quotient(scaled(&results, &arguments[0]))
            }
            Node::Function(..) => panic!("kernels of arithmetic and roots only"),
        };
        results.push(result);
    }
    let outputs = kernel.outputs.iter();
    outputs.map(|output| scaled(&results, output)).collect()
}
