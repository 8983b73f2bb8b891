//! Collected coefficients lose no more than a few roundings against the plain form, near-degenerate
//! inputs included. Both are computed in `f32`, and compared to the plain form in `f64`.

use ga_compiler::ir::{Arena, Function, Node, Value};
use ga_compiler::kernel::{Kernel, wanted};
use ga_compiler::lower::Choice;
use ga_compiler::parse::{Block, parse_functions};
use ga_compiler::resolve::resolve;
use ga_compiler::task::Task;

use crate::algebras;

/// How many times the error of the plain form is allowed.
const ALLOWED: f64 = 8.0;
const SAMPLES: usize = 400;

/// A reproducible sequence of numbers in −1 … 1.
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        #[allow(clippy::cast_precision_loss)]
        let unit = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        2.0 * unit - 1.0
    }

    fn vector(&mut self, size: f64) -> [f64; 3] {
        [(); 3].map(|()| size * self.number())
    }

    fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = self.vector(1.0);
            let norm = dot(v, v).sqrt();
            if norm > 0.1 {
                return v.map(|x| x / norm);
            }
        }
    }

    /// A motor that takes `from` to `to`: scalar, e12, e13, e23, e1i, e2i, e3i, e123i.
    fn motor(&mut self, angle: f64, from: [f64; 3], to: [f64; 3]) -> Vec<f64> {
        let (axis, half) = (self.direction(), 0.5 * angle);
        let (w, s) = (half.cos(), half.sin());
        let q = axis.map(|a| s * a);
        // x' = x + 2 (w q × x + q × (q × x)).
        let first = cross(q, from);
        let second = cross(q, first);
        let t: Vec<f64> = (0..3)
            .map(|i| to[i] - from[i] - 2.0 * (w * first[i] + second[i]))
            .collect();
        let [a, b, c] = [-q[2], q[1], -q[0]];
        // (1 − t ei/2)(w + a e12 + b e13 + c e23)
        let h = [-0.5 * t[0], -0.5 * t[1], -0.5 * t[2]];
        vec![
            w,
            a,
            b,
            c,
            h[0] * w - h[1] * a - h[2] * b,
            h[1] * w + h[0] * a - h[2] * c,
            h[2] * w + h[0] * b + h[1] * c,
            h[0] * c - h[1] * b + h[2] * a,
        ]
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn plus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn single(x: f64) -> f64 {
    #[allow(clippy::cast_possible_truncation)]
    let rounded = x as f32;
    f64::from(rounded)
}

/// The outputs of a kernel, every operation rounded. Rounding to `f32` after an operation in `f64`
/// gives what the operation in `f32` gives.
fn evaluate(kernel: &Kernel, inputs: &[f64], round: fn(f64) -> f64) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::new();
    for id in kernel.arena.ids() {
        let scaled = |value: &Value| {
            let (n, d) = (value.factor.numerator(), value.factor.denominator());
            #[allow(clippy::cast_precision_loss)]
            let factor = n as f64 / d as f64;
            round(round(factor) * values[value.node.index()])
        };
        let value = match kernel.arena.node(id) {
            Node::One => 1.0,
            Node::Input(number) => inputs[*number],
            Node::Sum(terms) => {
                let mut terms = terms.iter();
                let first = terms.next().map_or(0.0, scaled);
                terms.fold(first, |sum, term| round(sum + scaled(term)))
            }
            Node::Product(a, b) => round(values[a.index()] * values[b.index()]),
            Node::Quotient(a, b) => round(values[a.index()] / values[b.index()]),
            Node::Function(function, arguments) => {
                let arguments: Vec<f64> = arguments.iter().map(scaled).collect();
                round(scalar_function(*function, &arguments))
            }
        };
        values.push(value);
    }
    let one = |output: &Value| {
        let (n, d) = (output.factor.numerator(), output.factor.denominator());
        #[allow(clippy::cast_precision_loss)]
        let factor = n as f64 / d as f64;
        round(factor * values[output.node.index()])
    };
    kernel.outputs.iter().map(one).collect()
}

fn scalar_function(function: Function, arguments: &[f64]) -> f64 {
    let x = arguments[0];
    let root = x.abs().sqrt();
    match function {
        Function::SquareRoot => x.sqrt(),
        Function::Absolute => x.abs(),
        Function::Select if x == 0.0 => arguments[2],
        Function::Select => arguments[1],
        Function::Less => f64::from(u8::from(x < arguments[1])),
        Function::StumpffCosine => root.cos(),
        Function::StumpffSine if root < 1e-3 => 1.0 + x / 6.0,
        Function::StumpffSine => root.sin() / root,
        Function::StumpffSineSlope if root < 1e-2 => 1.0 / 6.0 + x / 60.0,
        Function::StumpffSineSlope => (root.cos() - root.sin() / root) / (2.0 * x),
        Function::VersorAngle | Function::VersorAngleSlope => {
            let sine = arguments[1].abs().sqrt();
            let angle = sine.atan2(x);
            let square = -angle * angle;
            let [s, slope] = [Function::StumpffSine, Function::StumpffSineSlope]
                .map(|function| scalar_function(function, &[square]));
            match function {
                Function::VersorAngle => 1.0 / s,
                _ => -2.0 * slope / (s * s * s),
            }
        }
        _ => unreachable!("not in these kernels"),
    }
}

/// Compiles a function with its uniform coefficients collected and by its plain meaning, and
/// compares their errors.
#[track_caller]
fn check(source: &str, mut inputs: impl FnMut(&mut Random) -> Vec<f64>) {
    let cga3 = algebras::cga3();
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
    let task = Task::of_program(&cga3.algebra, &resolved.program, outputs);
    let plain = task.clone().with_choices(Choice::default()).compile();
    let staged = Choice {
        staged: true,
        ..Choice::default()
    };
    let staged = task
        .with_uniform(&resolved.uniform)
        .with_choices(staged)
        .compile();
    assert_ne!(nodes(&staged.arena), nodes(&plain.arena), "{source}");
    let mut random = Random(7);
    let mut worst = vec![[0.0_f64; 2]; staged.outputs.len()];
    for _ in 0..SAMPLES {
        let inputs: Vec<f64> = inputs(&mut random).into_iter().map(single).collect();
        let truth = evaluate(&plain, &inputs, |x| x);
        for (number, kernel) in [&staged, &plain].into_iter().enumerate() {
            let found = evaluate(kernel, &inputs, single);
            for ((worst, truth), found) in worst.iter_mut().zip(&truth).zip(found) {
                let error = (found - truth).abs();
                assert!(error.is_finite(), "{source}: {found} for {truth}");
                // A value that is exact by the plain form may have one rounding.
                let least = f64::from(f32::EPSILON) * truth.abs() / ALLOWED;
                worst[number] = worst[number].max(error).max(least);
            }
        }
    }
    for (place, [staged, plain]) in worst.into_iter().enumerate() {
        assert!(
            staged <= ALLOWED * plain,
            "{source}: output {place} has the error {staged:.2e}, by the plain form {plain:.2e}"
        );
    }
}

fn nodes(arena: &Arena) -> Vec<Node> {
    arena.ids().map(|id| arena.node(id).clone()).collect()
}

fn joined<const N: usize>(parts: [&[f64]; N]) -> Vec<f64> {
    parts.concat()
}

#[test]
fn distance_of_a_point_to_a_plane_far_from_the_origin() {
    check(
        "fn f(uniform n: DualPlane, p: Point) -> Scalar { (n | p) / norm(n) }",
        |random| {
            let (n, far) = (random.direction(), random.vector(1e4));
            let near = plus(far, random.vector(1e-2));
            joined([&n, &[dot(n, far)], &near])
        },
    );
}

#[test]
fn a_point_projected_onto_a_plane_far_from_the_origin() {
    let source = "fn f(uniform l: Plane, p: Point) -> FlatPoint { ((p ^ ei) | l) * inverse(l) }";
    check(source, |random| {
        let (n, far) = (random.direction(), random.vector(1e4));
        let near = plus(far, random.vector(1e-2));
        joined([&[dot(n, far), n[2], -n[1], n[0]], &near])
    });
}

#[test]
fn motors_that_bring_a_far_point_to_the_origin() {
    let source = "fn f(uniform m: Motor, uniform n: Motor, p: Point) -> Point {
        sandwich(m, sandwich(n, p))
    }";
    for angle in [1e-3, 1.0, 3.1] {
        check(source, |random| {
            let [far, between] = [1e3, 1e2].map(|size| random.vector(size));
            let n = random.motor(angle, far, between);
            let m = random.motor(angle, between, [0.0; 3]);
            joined([&m, &n, &plus(far, random.vector(1e-1))])
        });
    }
}

#[test]
fn a_sphere_through_points_that_nearly_lie_in_a_plane() {
    let source = "fn f(uniform a: Point, uniform b: Point, uniform c: Point, uniform d: Point,
        p: Point) -> Pseudoscalar { a ^ b ^ c ^ d ^ p }";
    for distance in [0.0, 1e2] {
        check(source, |random| {
            let centre = random.vector(distance);
            let mut points = Vec::new();
            for height in [0.0, 1e-3, -1e-3, 2e-3, 1e-2] {
                let [x, y, _] = random.vector(1.0);
                points.extend(plus(centre, [x, y, height]));
            }
            points
        });
    }
}

#[test]
fn inversions_in_spheres_far_from_the_origin() {
    let source = "fn f(uniform s: DualSphere, p: Point) -> RoundVector { sandwich(s, p) }";
    for distance in [1.0, 1e3] {
        check(source, |random| {
            let centre = random.vector(distance);
            let near = plus(centre, random.vector(1.0));
            joined([&[1.0], &centre, &[1e-2], &near])
        });
    }
}

#[test]
fn lines_that_nearly_touch_a_sphere() {
    let source = "fn f(uniform s: DualSphere, p: Point, q: Point) -> Point {
        endpoints((p ^ q ^ ei) & undual(s)).0
    }";
    for depth in [1e-2, 0.5] {
        check(source, |random| {
            let (centre, axis) = (random.vector(10.0), random.direction());
            let across = cross(axis, random.direction());
            let across = across.map(|x| x / dot(across, across).sqrt());
            // The nearest point of the line lies this deep in the sphere of radius 1.
            let nearest = plus(centre, across.map(|x| x * (1.0 - depth)));
            let [p, q] = [-2.0, 3.0].map(|way| plus(nearest, axis.map(|x| x * way)));
            joined([&[1.0], &centre, &[1.0], &p, &q])
        });
    }
}

#[test]
fn similarities_of_points_far_from_the_origin() {
    let source = "fn f(uniform s: Similarity, p: Point) -> RoundVector { sandwich(s, p) }";
    check(source, |random| {
        // Without a scaling: a motor, whose other coefficients are zero.
        let far = random.vector(1e3);
        let m = random.motor(2.0, far, [0.0; 3]);
        let mut similarity = m.clone();
        similarity.truncate(8);
        similarity.splice(8.., [0.0; 4]);
        joined([&similarity, &plus(far, random.vector(1.0))])
    });
}

#[test]
fn paths_between_near_and_opposite_motions() {
    let source = "fn f(uniform m: Motor, uniform n: Motor, t: Scalar) -> Motor { exp(t * log(n * rev(m))) * m }";
    for angle in [1e-2, 1.0, 2.9] {
        check(source, |random| {
            let [from, to] = [(); 2].map(|()| random.vector(1e1));
            let m = random.motor(0.0, [0.0; 3], [0.0; 3]);
            let n = random.motor(angle, from, to);
            let t = random.number();
            joined([&m, &n, &[t]])
        });
    }
}
