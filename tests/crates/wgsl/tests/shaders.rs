//! Shaders of functions of every kind: they are valid and, if there is an adapter to run them on,
//! correct.

use ga_compiler::define::Definition;
use ga_compiler::emit::wgsl;
use ga_compiler::function::{CompiledFunction, Shape};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use nullcone_wgsl_tests::{Gpu, Shader, cga3, compile, evaluate, validate};

/// The types that a motor moves.
const MOVED: [&str; 12] = [
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
    "Motor",
];

/// Functions of arithmetic alone.
const ARITHMETIC: [&str; 18] = [
    "fn product(m: Motor, n: Motor) -> Motor { m * n }",
    "fn turns(a: Rotor, b: Rotor) -> Rotor { a * b }",
    "fn shifts(a: Translator, b: Translator) -> Translator { a * b }",
    "fn difference(p: Point, q: Point) -> RoundVector { p - q }",
    "fn pair(p: Point, q: Point) -> PointPair { p ^ q }",
    "fn circle(p: Point, q: Point, r: Point) -> Circle { p ^ q ^ r }",
    "fn sphere(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }",
    "fn line(p: Point, q: Point, i: Infinity) -> Line { p ^ q ^ i }",
    "fn plane(p: Point, q: Point, r: Point) -> Plane { p ^ q ^ r ^ ei }",
    "fn meet(a: Sphere, b: Sphere) -> Circle { a & b }",
    "fn meet_flat(a: Line, b: Plane) -> FlatPoint { a & b }",
    "fn inner(p: Point, q: Point) -> Scalar { p | q }",
    "fn quotient(p: Point, s: Scalar) -> RoundVector { (2 * p) / (s * s + 3) }",
    "fn both(m: Motor, x: [Point; 2]) -> [Point; 2] { [sandwich(m, x[0]), sandwich(m, x[1])] }",
    "fn two(p: Point, q: Point, t: Scalar) -> (Scalar, RoundVector) { (t * (p | q), p - q) }",
    "fn once(uniform m: Motor, p: Point) -> Point { sandwich(m, p) }",
    "fn once_line(x: Line, uniform m: Motor) -> Line { sandwich(m, x) }",
    "fn constant(p: Point) -> Infinity { ei }",
];

/// Functions that call others.
const TRANSCENDENTAL: [&str; 11] = [
    "fn distance(p: Point, q: Point) -> Scalar { sqrt(abs(p | q)) }",
    "fn turned(t: Scalar) -> Rotor { cos(t) + sin(t) * e12 }",
    "fn angle(s: Scalar, t: Scalar) -> Scalar { atan2(s, t) }",
    "fn growth(t: Scalar) -> Scalar { exp(t) + ln(t * t + 1) }",
    "fn hyperbolic(t: Scalar) -> (Scalar, Scalar, Scalar) { (sinh(t), cosh(t), tanh(100 * t)) }",
    "fn length(s: Scalar, t: Scalar) -> Scalar { hypot(s, t) + hypot(t - t, 0) }",
    "fn powers(t: Scalar) -> Scalar { pow(1 + t * t, 5/4) + pow(2 + tan(t), -2) + acos(t / (1 + t * t)) }",
    "fn exponential(g: MotorGenerator) -> Motor { exp(g) }",
    "fn logarithm(m: Motor) -> MotorGenerator { log(m) }",
    "fn half(m: Motor) -> Motor { exp(log(m) / 2) }",
    "fn swung(uniform g: MotorGenerator, p: Point) -> Point { sandwich(exp(g), p) }",
];

/// Functions with conditions.
const CONDITIONAL: [&str; 8] = [
    "fn nearer(o: Point, p: Point, q: Point) -> Point { select((o | p) > (o | q), p, q) }",
    "fn positive_part(x: Scalar) -> Scalar { max(x, 0) + sign(x) / 4 }",
    "fn clamped(x: Scalar, a: Scalar) -> Scalar { clamp(x, -abs(a) / 2, abs(a) / 2) }",
    "fn inside(x: Scalar, y: Scalar) -> Scalar {
        let is_inside = x > -0.5 && x < 0.5 && !(y >= 0.25 || y == x);
        select(is_inside, 1, 0)
    }",
    "fn both(x: Scalar, y: Scalar) -> (Scalar, Scalar) {
        let (a, b) = select(x <= y, (x, y), (y, x));
        (select(x <= y && a != b, a, b), b - a)
    }",
    "fn hit(uniform c: RoundVector, uniform limit: Scalar, p: Point) -> RoundVector {
        let d = -2 * (c | p);
        select(limit < 0.5, select(d < limit, c, p), p - c)
    }",
    "fn uniform_condition(uniform a: Scalar, uniform b: Scalar, x: Scalar) -> Scalar {
        select(a < b, x, select(a < b, a, b) * x)
    }",
    "fn least(uniform a: Scalar, x: Scalar, y: Scalar) -> Scalar { min(min(x, y), a + 0.25) }",
];

fn sandwiches() -> Vec<String> {
    MOVED
        .iter()
        .map(|kind| format!("fn moved(m: Motor, x: {kind}) -> {kind} {{ sandwich(m, x) }}"))
        .collect()
}

fn all() -> Vec<String> {
    let others = ARITHMETIC.iter().chain(&TRANSCENDENTAL).chain(&CONDITIONAL);
    sandwiches()
        .into_iter()
        .chain(others.map(ToString::to_string))
        .collect()
}

#[track_caller]
fn assert_valid(text: &str) {
    if let Err(error) = validate(text) {
        panic!("{error}\n{text}");
    }
}

#[test]
fn modules_are_valid() {
    let definition = cga3();
    for text in all() {
        let function = compile(&definition, &text);
        assert_valid(&wgsl::module(&definition, std::slice::from_ref(&function)));
        assert_valid(&Shader::new(&definition, &function).text);
    }
    // All in one module, which declares every structure once.
    let functions: Vec<_> = all()
        .iter()
        .map(|text| compile(&definition, text))
        .collect();
    assert_valid(&wgsl::module(&definition, &functions));
}

#[test]
fn what_is_no_wgsl_is_refused() {
    let definition = cga3();
    let text = wgsl::module(&definition, &[compile(&definition, ARITHMETIC[0])]);
    assert!(validate(&text.replace("n.e12", "n.e21")).is_err());
    assert!(validate(&text.replace("e12: f32", "e12: i32")).is_err());
}

#[test]
fn words_of_the_language_are_not_names() {
    use naga::keywords::wgsl::{BUILTIN_IDENTIFIERS, RESERVED};
    let definition = cga3();
    let mut words = 0;
    for word in RESERVED.iter().chain(BUILTIN_IDENTIFIERS) {
        // A few are not identifiers in Rust, not even as raw identifiers.
        let Ok(_) = syn::parse_str::<syn::Ident>(&format!("r#{word}")) else {
            continue;
        };
        words += 1;
        let texts = [
            format!("fn r#{word}(p: Point) -> Point {{ p }}"),
            format!("fn f(r#{word}: Point) -> Point {{ r#{word} }}"),
        ];
        let functions = texts.map(|text| compile(&definition, &text));
        let module = wgsl::module(&definition, &functions);
        assert_valid(&module);
        // Predeclared names may be redeclared, which another module in the same shader may not
        // expect.
        let is_declared =
            module.contains(&format!("fn {word}(")) || module.contains(&format!("({word}:"));
        assert!(!is_declared, "{word}: {module}");
    }
    assert!(words > 380, "{words}");
    // The emitted helper functions keep their meaning beside functions of such names.
    let texts = [
        "fn cos(t: Scalar) -> Scalar { sin(t) }",
        "fn versor_sine(g: MotorGenerator) -> Motor { exp(g) }",
    ];
    let functions = texts.map(|text| compile(&definition, text));
    assert_valid(&wgsl::module(&definition, &functions));
}

/// Reproducible numbers in [−1, 1).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn three(&mut self) -> [f64; 3] {
        [self.next(), self.next(), self.next()]
    }

    fn motor(&mut self) -> Motor<f64> {
        let axis = [self.next(), self.next(), self.next() + 2.0];
        let angle = 2.5 * self.next();
        let rotor = Rotor::from_axis_angle(axis, angle).expect("an axis");
        Translator::from_displacement(self.three()) * rotor
    }

    /// The stored numbers of a member of a shape.
    fn member(&mut self, definition: &Definition, shape: &Shape) -> Vec<f64> {
        let mut numbers = Vec::new();
        for leaf in shape.leaves(definition) {
            let Some(kind) = leaf else {
                numbers.push(self.next());
                continue;
            };
            let m = self.motor();
            let coefficients = [
                m.scalar(),
                m.e12(),
                m.e13(),
                m.e23(),
                m.e1i(),
                m.e2i(),
                m.e3i(),
                m.e123i(),
            ];
            match kind.name.to_string().as_str() {
                "Motor" => numbers.extend(coefficients),
                "Rotor" => {
                    let size = coefficients[..4].iter().map(|x| x * x).sum::<f64>().sqrt();
                    numbers.extend(coefficients[..4].iter().map(|x| x / size));
                }
                _ => numbers.extend((0..kind.stored().count()).map(|_| self.next())),
            }
        }
        numbers
    }
}

/// Runs a function over many members and compares with its graph in double precision.
fn assert_runs(gpu: &Gpu, definition: &Definition, function: &CompiledFunction, bound: f64) {
    const ELEMENTS: usize = 100;
    let shader = Shader::new(definition, function);
    if shader.inputs == 0 || shader.outputs == 0 {
        return;
    }
    let mut numbers = Numbers(7);
    let mut inputs: Vec<f32> = Vec::new();
    for _ in 0..ELEMENTS {
        for operand in &function.operands {
            let member = numbers.member(definition, &operand.shape);
            inputs.extend(member.into_iter().map(|x| x as f32));
        }
    }
    if function
        .operands
        .iter()
        .any(|operand| operand.shape.stored(definition) == 0)
    {
        // Such an operand still occupies a number in a buffer.
        return;
    }
    let found = gpu.run(&shader, &inputs);
    assert_eq!(found.len(), ELEMENTS * shader.outputs);
    for (element, result) in inputs
        .chunks(shader.inputs)
        .zip(found.chunks(shader.outputs))
    {
        let element: Vec<f64> = element.iter().map(|&x| x.into()).collect();
        let expected = evaluate(function, &element);
        let size = expected.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
        for (&found, expected) in result.iter().zip(&expected) {
            let error = (f64::from(found) - expected).abs();
            assert!(
                error <= bound * size,
                "{:?}: {found} instead of {expected} on {} for {element:?}",
                function.name,
                gpu.name
            );
        }
    }
}

#[test]
fn shaders_give_what_the_graph_gives() {
    let Some(gpu) = Gpu::find() else { return };
    let definition = cga3();
    let exact = ARITHMETIC.into_iter().chain(CONDITIONAL);
    for text in sandwiches().iter().map(String::as_str).chain(exact) {
        assert_runs(&gpu, &definition, &compile(&definition, text), 1e-5);
    }
    for text in TRANSCENDENTAL {
        assert_runs(&gpu, &definition, &compile(&definition, text), 1e-4);
    }
}

#[test]
fn shaders_give_what_the_types_give() {
    let Some(gpu) = Gpu::find() else { return };
    let definition = cga3();
    let mut numbers = Numbers(11);
    for text in [
        "fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }",
        "fn moved(uniform m: Motor, p: Point) -> Point { m * p * reverse(m) }",
    ] {
        let shader = Shader::new(&definition, &compile(&definition, text));
        for _ in 0..16 {
            let (m, p) = (numbers.motor(), numbers.three());
            let element = [
                m.scalar(),
                m.e12(),
                m.e13(),
                m.e23(),
                m.e1i(),
                m.e2i(),
                m.e3i(),
                m.e123i(),
                p[0],
                p[1],
                p[2],
            ];
            let found = gpu.run(&shader, &element.map(|x| x as f32));
            let expected = m.transform(Point::from(p)).coordinates();
            for (found, expected) in found.into_iter().zip(expected) {
                assert!(
                    (f64::from(found) - expected).abs() < 1e-5,
                    "{found} instead of {expected}"
                );
            }
        }
    }
}
