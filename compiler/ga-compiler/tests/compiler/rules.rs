//! The named rules: each keeps the meaning of what it is applied to, and a broken rule is refused.

use crate::algebras::{cga3, minkowski};
use ga_compiler::algebra::Product;
use ga_compiler::define::{Definition, TypeDefinition};
use ga_compiler::expression::Expression;
use ga_compiler::ir::{Arena, Node, NodeId, Value};
use ga_compiler::kernel::{Kernel, wanted};
use ga_compiler::lower::{
    Choice, InnerRule, JoinRule, MeetRule, ProjectionRule, Rule, SandwichRule,
};
use ga_compiler::parse::{Block, parse_functions};
use ga_compiler::passes::schedule;
use ga_compiler::resolve::resolve;
use ga_compiler::task::Task;
use ga_compiler::verify;

/// An expression with the types of its operands and of its result.
struct Case<'a> {
    definition: &'a Definition,
    operands: Vec<&'a TypeDefinition>,
    expression: Expression,
    result: Option<&'a TypeDefinition>,
}

impl<'a> Case<'a> {
    fn new(
        definition: &'a Definition,
        operands: &[&str],
        expression: Expression,
        result: &str,
    ) -> Self {
        let kind = |name: &str| definition.type_named(name).expect("a declared type");
        Self {
            definition,
            operands: operands.iter().map(|name| kind(name)).collect(),
            expression,
            result: (result != "Scalar").then(|| kind(result)),
        }
    }

    fn compile(&self, choice: Choice) -> Kernel {
        let blades = wanted(self.result);
        let algebra = &self.definition.algebra;
        Task::of_expression(algebra, &self.operands, &self.expression, blades)
            .with_choices(choice)
            .compile()
    }

    /// Whether the kernel agrees with the plain meaning at random members of the operands' types.
    fn agrees(&self, kernel: &Kernel) -> bool {
        let algebra = &self.definition.algebra;
        (0..4)
            .all(|seed| kernel.agrees(algebra, &self.operands, &self.expression, self.result, seed))
    }
}

fn operand(number: usize) -> Expression {
    Expression::Operand(number)
}

fn wedge(factors: usize) -> Expression {
    (1..factors).fold(operand(0), |product, next| {
        Expression::binary(Product::Wedge, product, operand(next))
    })
}

fn sandwich() -> Expression {
    Expression::sandwich(operand(0), operand(1))
}

/// Every rule that departs from the plain meaning.
fn rules() -> Vec<(Choice, Rule)> {
    let sandwiches = SandwichRule::ALL.map(|rule| (rule.into(), Rule::Sandwich(rule)));
    let joins = JoinRule::ALL.map(|join| {
        let choice = Choice {
            join,
            ..Choice::default()
        };
        (choice, Rule::Join(join))
    });
    let meet = Choice {
        meet: MeetRule::Factors,
        ..Choice::default()
    };
    let mut rules: Vec<_> = sandwiches.into_iter().chain(joins).collect();
    rules.extend([InnerRule::Distance, InnerRule::Gram].map(|inner| {
        let choice = Choice {
            inner,
            ..Choice::default()
        };
        (choice, Rule::Inner(inner))
    }));
    rules.push((meet, Rule::Meet(MeetRule::Factors)));
    rules
}

/// Cases in which every rule applies somewhere.
fn cases<'a>(cga3: &'a Definition, minkowski: &'a Definition) -> Vec<Case<'a>> {
    let mut cases = Vec::new();
    let moved = [
        "Point",
        "RoundVector",
        "DualPlane",
        "PointPair",
        "FlatPoint",
        "Direction",
        "MotorGenerator",
        "Circle",
        "Line",
        "Sphere",
        "Plane",
    ];
    for versor in ["Rotor", "Translator", "Motor"] {
        for kind in moved.into_iter().chain(["Motor"]) {
            cases.push(Case::new(cga3, &[versor, kind], sandwich(), kind));
        }
    }
    for versor in ["Dilator", "Similarity"] {
        // A scaling maps a point to a weighted point.
        let scaled = Case::new(cga3, &[versor, "Point"], sandwich(), "RoundVector");
        cases.push(scaled);
        for kind in &moved[1..] {
            cases.push(Case::new(cga3, &[versor, kind], sandwich(), kind));
        }
    }
    for kind in ["RoundVector", "PointPair", "Circle", "Sphere"] {
        cases.push(Case::new(cga3, &["RoundVector", kind], sandwich(), kind));
    }
    for kind in ["Point", "RoundVector", "Line", "Circle", "Sphere"] {
        let image = match kind {
            "Point" => "RoundVector",
            "Line" => "Circle",
            other => other,
        };
        for versor in [
            "DualPlane",
            "DualSphere",
            "Plane",
            "Sphere",
            "EvenVersor",
            "OddVersor",
        ] {
            cases.push(Case::new(cga3, &[versor, kind], sandwich(), image));
        }
    }
    let joined = ["PointPair", "Circle", "Sphere", "Pseudoscalar"];
    for (result, factors) in joined.into_iter().zip(2..) {
        for kind in ["Point", "RoundVector"] {
            let operands = vec![kind; factors];
            cases.push(Case::new(cga3, &operands, wedge(factors), result));
        }
        let mut mixed = vec!["Point"; factors];
        mixed[factors / 2] = "RoundVector";
        cases.push(Case::new(cga3, &mixed, wedge(factors), result));
    }
    cases.push(Case::new(
        cga3,
        &["Point", "Point", "Infinity"],
        wedge(3),
        "Line",
    ));
    cases.push(Case::new(
        cga3,
        &["Infinity", "Point", "Point", "Point"],
        wedge(4),
        "Plane",
    ));
    for product in [
        Product::LeftContraction,
        Product::RightContraction,
        Product::ScalarProduct,
    ] {
        let inner = Expression::binary(product, operand(0), operand(1));
        for pair in [
            ["Point", "Point"],
            ["Point", "RoundVector"],
            ["DualPlane", "Point"],
        ] {
            cases.push(Case::new(cga3, &pair, inner.clone(), "Scalar"));
        }
    }
    let join = |factors: std::ops::Range<usize>| {
        factors
            .map(operand)
            .reduce(|product, next| Expression::binary(Product::Wedge, product, next))
            .expect("a factor")
    };
    for size in [2, 3] {
        let square = Expression::binary(Product::ScalarProduct, join(0..size), join(0..size));
        cases.push(Case::new(cga3, &vec!["Point"; size], square, "Scalar"));
    }
    let inner = Expression::binary(Product::LeftContraction, join(0..2), join(2..4));
    cases.push(Case::new(cga3, &["Point"; 4], inner, "Scalar"));
    let plane = ["Point", "Point", "Point", "Infinity"];
    let line = ["Point", "Infinity", "Point"];
    for (left, right) in [(plane.as_slice(), line.as_slice()), (&line, &plane)] {
        let (first, all) = (left.len(), left.len() + right.len());
        let meet = Expression::binary(Product::Vee, join(0..first), join(first..all));
        cases.push(Case::new(cga3, &[left, right].concat(), meet, "FlatPoint"));
    }
    for (sphere, count) in [("Sphere", 2), ("Plane", 3), ("Circle", 3), ("Circle", 4)] {
        let meet = Expression::binary(Product::Vee, operand(0), join(1..count + 1));
        let operands = [&[sphere], vec!["RoundVector"; count].as_slice()].concat();
        cases.push(Case::new(cga3, &operands, meet, "Multivector"));
    }
    for (left, right) in [(2, 3), (3, 3), (3, 2)] {
        let meet = Expression::binary(Product::Vee, join(0..left), join(left..left + right));
        let operands = vec!["Event"; left + right];
        let blades = ["Scalar", "Vector", "Bivector"];
        cases.push(Case::new(
            minkowski,
            &operands,
            meet,
            blades[left + right - 4],
        ));
    }
    for kind in ["Vector", "Bivector", "Boost"] {
        cases.push(Case::new(minkowski, &["Boost", kind], sandwich(), kind));
    }
    cases.push(Case::new(cga3, &["Similarity", "Even"], sandwich(), "Even"));
    cases.push(Case::new(
        minkowski,
        &["Event", "Event"],
        wedge(2),
        "Bivector",
    ));
    cases
}

#[test]
fn both_sides_of_every_rule_agree() {
    let (cga3, minkowski) = (cga3(), minkowski());
    for (number, case) in cases(&cga3, &minkowski).iter().enumerate() {
        for (choice, rule) in rules() {
            let kernel = case.compile(choice);
            assert!(case.agrees(&kernel), "{rule:?} in case {number}");
        }
        for held in [false, true] {
            let choice = Choice {
                held,
                ..Choice::default()
            };
            assert!(
                case.agrees(&case.compile(choice)),
                "held {held} in case {number}"
            );
        }
    }
}

#[test]
fn a_broken_rule_is_refused() {
    let (cga3, minkowski) = (cga3(), minkowski());
    let cases = cases(&cga3, &minkowski);
    for (choice, rule) in rules() {
        let broken = Choice {
            broken: Some(rule),
            ..choice
        };
        let mut refused = 0;
        for (number, case) in cases.iter().enumerate() {
            let (sound, spoiled) = (case.compile(choice), case.compile(broken));
            // A sign that does not affect any output is not a fault.
            if evaluate(case, &spoiled) != evaluate(case, &sound) {
                assert!(!case.agrees(&spoiled), "{rule:?} in case {number}");
                refused += 1;
            }
        }
        assert!(refused > 0, "{rule:?} was never applied");
    }
}

/// Whole functions, in which the types of the steps are known.
#[test]
fn a_broken_rule_is_refused_in_functions() {
    let cga3 = cga3();
    for (source, choice, rule) in [
        (
            "fn moved(m: Motor, p: Point) -> RoundVector { m * p * rev(m) }",
            Choice {
                rederive: true,
                ..Choice::default()
            },
            Rule::Rederive,
        ),
        (
            "fn distance(m: Motor, p: Point, q: Point) -> Scalar { sqrt(-2 * (sandwich(m, p) | q)) }",
            Choice {
                inner: InnerRule::Distance,
                ..SandwichRule::UnitCommutator.into()
            },
            Rule::Inner(InnerRule::Distance),
        ),
        (
            "fn twice(a: Motor, b: Motor, l: Line) -> Line { a * b * l * rev(b) * rev(a) }",
            SandwichRule::Split.into(),
            Rule::Sandwich(SandwichRule::Split),
        ),
        (
            "fn scaled(s: Similarity, p: Point) -> RoundVector { sandwich(s, p) / sandwich(s, p).eo }",
            Choice {
                projection: ProjectionRule::Image,
                ..Choice::default()
            },
            Rule::Projection(ProjectionRule::Image),
        ),
        (
            "fn scaled(m: Motor, d: Dilator, p: Point) -> RoundVector {
                let q = sandwich(m, sandwich(d, p));
                q / (2 * (q | ei))
            }",
            Choice {
                projection: ProjectionRule::Reciprocal,
                ..Choice::default()
            },
            Rule::Projection(ProjectionRule::Reciprocal),
        ),
        (
            "fn moved(uniform m: Motor, uniform n: Motor, p: Point) -> Point {
                sandwich(m, sandwich(n, p))
            }",
            Choice {
                staged: true,
                ..Choice::default()
            },
            Rule::UniformCoefficients,
        ),
    ] {
        let functions = parse_functions(source.parse().expect("tokens")).expect("a function");
        let block = Block {
            functions,
            imports: Vec::new(),
        };
        let resolved = resolve(&cga3, &block.functions[0], &block).expect("names have a meaning");
        let outputs: Vec<_> = resolved
            .outputs
            .iter()
            .map(|(step, kind)| (*step, wanted(*kind)))
            .collect();
        let (program, uniform) = (&resolved.program, &resolved.uniform);
        let agrees = |choice: Choice| {
            Task::of_program(&cga3.algebra, program, outputs.clone())
                .with_uniform(uniform)
                .with_choices(choice)
                .compile()
                .agrees_with(program, &resolved.witness, &outputs)
        };
        assert!(agrees(choice), "{source}");
        assert!(
            !agrees(Choice {
                broken: Some(rule),
                ..choice
            }),
            "{rule:?} in {source}"
        );
    }
}

/// Passes rewrite graphs; any mistake of theirs shows as a wrong node.
#[test]
fn any_wrong_node_or_output_is_refused() {
    let cga3 = cga3();
    let mut faults = 0;
    for case in [
        Case::new(&cga3, &["Motor", "Point"], sandwich(), "Point"),
        Case::new(&cga3, &["Motor", "Circle"], sandwich(), "Circle"),
        Case::new(&cga3, &["Point", "Point", "Point"], wedge(3), "Circle"),
    ] {
        let blades = wanted(case.result);
        let algebra = &cga3.algebra;
        let kernel =
            Task::of_expression(algebra, &case.operands, &case.expression, blades).compile();
        assert!(case.agrees(&kernel));
        for wrong in schedule(&kernel.arena, &kernel.outputs).order {
            let (arena, outputs) = with_negated(&kernel, wrong);
            let spoiled = Kernel {
                arena,
                outputs,
                ..kernel.clone()
            };
            assert!(!case.agrees(&spoiled), "{wrong:?}");
            faults += 1;
        }
        for wrong in 0..kernel.outputs.len() {
            let mut spoiled = kernel.clone();
            spoiled.outputs[wrong] = -spoiled.outputs[wrong];
            assert!(!case.agrees(&spoiled), "output {wrong}");
        }
    }
    assert!(faults > 200, "{faults}");
}

/// The graph of a kernel with one node negated.
fn with_negated(kernel: &Kernel, wrong: NodeId) -> (Arena, Vec<Value>) {
    let mut copy = Arena::default();
    let inputs: Vec<Value> = (0..kernel.arena.inputs()).map(|_| copy.input()).collect();
    let mut images: Vec<Value> = Vec::new();
    let image = |images: &[Value], value: Value| images[value.node.index()].scaled(value.factor);
    for id in kernel.arena.ids() {
        let value = match kernel.arena.node(id) {
            Node::One => Value::ONE,
            Node::Input(number) => inputs[*number],
            Node::Sum(terms) => copy.sum(terms.iter().map(|&term| image(&images, term))),
            Node::Product(a, b) => copy.product(images[a.index()], images[b.index()]),
            Node::Quotient(a, b) => copy
                .quotient(images[a.index()], images[b.index()])
                .expect("a divisor"),
            Node::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|&v| image(&images, v)).collect();
                copy.function(*function, &arguments)
            }
        };
        images.push(if id == wrong { -value } else { value });
    }
    let outputs = kernel.outputs.iter().map(|&v| image(&images, v)).collect();
    (copy, outputs)
}

/// The outputs at a random point that the check does not use.
fn evaluate(case: &Case<'_>, kernel: &Kernel) -> Vec<ga_compiler::ir::Residue> {
    let mut sequence = verify::sequence(99);
    let inputs: Vec<_> = case
        .operands
        .iter()
        .flat_map(|kind| {
            let member = verify::sample(&case.definition.algebra, kind, &mut sequence);
            let stored = verify::stored(kind, &member.expect("a member")).into_iter();
            stored
                .map(|x| x.residue().expect("a residue"))
                .collect::<Vec<_>>()
        })
        .collect();
    kernel.evaluate(&inputs)
}
