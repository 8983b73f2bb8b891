//! Groups of spellings: the types of the operands and the result, and formulas that mean the same.

pub(super) type Group = (&'static str, &'static [&'static str]);

pub(super) const CGA3: &[Group] = &[
    (
        "m: Motor, n: Motor -> Motor",
        &["rev(m * n)", "rev(n) * rev(m)"],
    ),
    ("m: Motor, n: Motor -> Motor", &["rev(m) * (m * n)", "n"]),
    (
        "m: Motor, n: Motor, p: Point -> Point",
        &[
            "sandwich(rev(m) * n, p)",
            "sandwich(rev(m), sandwich(n, p))",
            "rev(m) * n * p * rev(n) * m",
            "inverse(m) * (n * p * inverse(n)) * m",
        ],
    ),
    (
        "a: Motor, b: Motor, c: Motor, p: Point -> Point",
        &[
            "sandwich(a * b * c, p)",
            "sandwich(a, sandwich(b, sandwich(c, p)))",
            "sandwich(a * b, sandwich(c, p))",
            "a * b * c * p * rev(c) * rev(b) * rev(a)",
            "let k = b * c; a * (k * p * rev(k)) * rev(a)",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point -> Line",
        &[
            "sandwich(m, p ^ q ^ ei)",
            "sandwich(m, p) ^ sandwich(m, q) ^ ei",
            "m * (p ^ q ^ ei) * rev(m)",
            "ei ^ sandwich(m, p) ^ sandwich(m, q)",
            "let a = sandwich(m, p); let b = sandwich(m, q); a ^ b ^ ei",
            "-(sandwich(m, q) ^ sandwich(m, p) ^ ei)",
        ],
    ),
    (
        "p: Point, q: Point -> Scalar",
        &[
            "p | q",
            "q | p",
            "grade(p * q, 0)",
            "scalar_product(p, q)",
            "(p * q + q * p) / 2",
            "right_contraction(p, q)",
        ],
    ),
    (
        "p: Point, q: Point -> Scalar",
        &[
            "-((p - q) | (p - q)) / 2",
            "let d = q - p; scalar_product(d, d) / -2",
        ],
    ),
    (
        "a: Line, b: Line -> MotorGenerator",
        &[
            "commutator(a, b)",
            "(a * b - b * a) / 2",
            "0.5 * a * b - 0.5 * b * a",
            "-commutator(b, a)",
            "grade(a * b, 2) * 1",
        ],
    ),
    (
        "a: Sphere, b: Sphere -> Circle",
        &[
            "a & b",
            "undual(dual(a) ^ dual(b))",
            "-dual(dual(a) ^ dual(b))",
            "dual(a) | b",
            "let i = e123oi; ((a * inverse(i)) ^ (b * inverse(i))) * i",
        ],
    ),
    (
        "m: Motor, a: Sphere, b: Plane -> Circle",
        &["sandwich(m, a & b)", "sandwich(m, a) & sandwich(m, b)"],
    ),
    (
        "m: Similarity, x: Point -> Point",
        &[
            "let p = sandwich(m, x); p / p.eo",
            "let p = sandwich(m, x); p * (1 / p.eo)",
            "let p = sandwich(m, x); (1 / p.eo) * p",
            "let p = sandwich(m, x); recip(p.eo) * p",
            "let p = sandwich(m, x); -p / (-p.eo)",
            "let p = sandwich(m, x); p / -(p | ei)",
        ],
    ),
    (
        "a: Rotor, b: Rotor -> Rotor",
        &[
            "a * b * rev(a)",
            "sandwich(a, b)",
            "a * b * inverse(a)",
            "a * (b * rev(a))",
            "rev(a * rev(b) * rev(a))",
            "rev(a * rev(a * b))",
        ],
    ),
    (
        "t: Translator, r: Rotor, d: Dilator, p: Point -> RoundVector",
        &[
            "sandwich(t * r * d, p)",
            "sandwich(t * r, sandwich(d, p))",
            "sandwich(t, sandwich(r * d, p))",
            "t * r * d * p * rev(d) * rev(r) * rev(t)",
            "let m = t * r; let x = d * p * rev(d); m * x * rev(m)",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point -> RoundVector",
        &[
            "sandwich(m, p + q)",
            "sandwich(m, p) + sandwich(m, q)",
            "sandwich(m, q + p)",
            "m * q * rev(m) + m * p * rev(m)",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point -> RoundVector",
        &[
            "sandwich(m, (p + q) / 2)",
            "(sandwich(m, p) + sandwich(m, q)) / 2",
            "0.5 * sandwich(m, p) + sandwich(m, q) * 0.5",
        ],
    ),
    (
        "m: Motor -> Motor",
        &["m * m", "let k = m; k * m", "rev(rev(m) * rev(m))"],
    ),
    ("m: Motor -> Motor", &["m * m * m", "m * (m * m)"]),
    (
        "m: Motor -> Motor",
        &["m * m * m * m", "let k = m * m; k * k", "m * (m * m) * m"],
    ),
    (
        "m: Motor, p: Point -> Point",
        &["sandwich(m * m, p)", "sandwich(m, sandwich(m, p))"],
    ),
    (
        "s: RoundVector, p: Point -> RoundVector",
        &["sandwich(s, p)", "-(s * p * rev(s))", "-(s * p * s)"],
    ),
    (
        "s: DualPlane, p: Point -> RoundVector",
        &["-(s * p * s)", "sandwich(s, p)"],
    ),
    (
        "s: DualPlane, t: DualPlane, p: Point -> RoundVector",
        &[
            "sandwich(s, sandwich(t, p))",
            "sandwich(s * t, p)",
            "s * t * p * t * s",
            "s * (t * p * rev(t)) * rev(s)",
        ],
    ),
    (
        "s: DualPlane, p: Point -> Point",
        &[
            "-(s * p * inverse(s))",
            "-(s * p * s) / (s * s)",
            "sandwich(s, p) / (s | s)",
            "sandwich(s, p) / norm_squared(s)",
        ],
    ),
    (
        "a: RoundVector, b: RoundVector, c: RoundVector -> RoundVector",
        &["a + b + c", "a + (b + c)", "c + a + b", "2 * a + b - a + c"],
    ),
    (
        "s: Scalar, p: RoundVector, q: RoundVector -> PointPair",
        &[
            "s * (p ^ q)",
            "(s * p) ^ q",
            "(p ^ q) * s",
            "p ^ (q * s)",
            "-(q ^ (s * p))",
        ],
    ),
    (
        "p: RoundVector, q: RoundVector, r: RoundVector -> PointPair",
        &["p ^ (q + r)", "(p ^ q) + (p ^ r)"],
    ),
    (
        "m: Motor, n: Motor, k: Motor -> DualQuaternion",
        &["m * (n + k)", "m * n + m * k"],
    ),
    (
        "p: Point, q: Point -> Scalar",
        &[
            "sqrt(-2 * (p | q))",
            "sqrt(2 * -(q | p))",
            "sqrt((p - q) | (p - q))",
            "norm(p - q)",
        ],
    ),
    (
        "p: RoundVector, q: RoundVector -> Scalar",
        &[
            "(p + q) | (p + q)",
            "grade((p + q) * (p + q), 0)",
            "norm_squared(p + q)",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point -> PointPair",
        &[
            "sandwich(m, p ^ q)",
            "sandwich(m, p) ^ sandwich(m, q)",
            "m * (p ^ q) * rev(m)",
            "let a = sandwich(m, p); let b = sandwich(m, q); a ^ b",
            "-(sandwich(m, q) ^ sandwich(m, p))",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point, r: Point -> Circle",
        &[
            "sandwich(m, p ^ q ^ r)",
            "sandwich(m, p) ^ sandwich(m, q) ^ sandwich(m, r)",
            "sandwich(m, p ^ q) ^ sandwich(m, r)",
            "sandwich(m, p) ^ sandwich(m, q ^ r)",
            "m * (p ^ q ^ r) * rev(m)",
            "-sandwich(m, q ^ p ^ r)",
            "let a = p ^ q; sandwich(m, a ^ r)",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point, r: Point -> Plane",
        &[
            "sandwich(m, p ^ q ^ r ^ ei)",
            "sandwich(m, p) ^ sandwich(m, q) ^ sandwich(m, r) ^ ei",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point, r: Point, s: Point -> Sphere",
        &[
            "sandwich(m, p ^ q ^ r ^ s)",
            "sandwich(m, p) ^ sandwich(m, q) ^ sandwich(m, r) ^ sandwich(m, s)",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point, x: RoundVector -> PointPair",
        &[
            "sandwich(m, p ^ (q + x))",
            "sandwich(m, p ^ q) + sandwich(m, p ^ x)",
            "sandwich(m, p) ^ sandwich(m, q + x)",
            "sandwich(m, p) ^ (sandwich(m, q) + sandwich(m, x))",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point, r: Point -> PointPair",
        &[
            "sandwich(m, p ^ (q + r))",
            "sandwich(m, p ^ q) + sandwich(m, p ^ r)",
            "sandwich(m, p) ^ sandwich(m, q + r)",
            "sandwich(m, p) ^ (sandwich(m, q) + sandwich(m, r))",
        ],
    ),
    (
        "m: Motor, p: Point, q: Point -> Scalar",
        &[
            "sandwich(m, p) | sandwich(m, q)",
            "p | q",
            "grade(m * p * rev(m) * m * q * rev(m), 0)",
            "scalar_product(m * q * rev(m), sandwich(m, p))",
        ],
    ),
    (
        "m: Motor, p: Point -> Point",
        &[
            "rev(m) * (m * p * rev(m)) * m",
            "p",
            "sandwich(inverse(m), sandwich(m, p))",
            "m * (rev(m) * p * m) * rev(m)",
        ],
    ),
    (
        "m: Motor, n: Motor, p: Point -> Point",
        &[
            "sandwich(m * n, p)",
            "sandwich(m, sandwich(n, p))",
            "let k = m * n; sandwich(k, p)",
            "(m * n) * p * rev(m * n)",
            "let k = m * n; k * p * rev(k)",
            "m * n * p * inverse(m * n)",
            "m * n * p * rev(n) * rev(m)",
        ],
    ),
    (
        "m: Motor, n: Motor, p: Point -> (Point, Motor)",
        &[
            "let k = m * n; (sandwich(k, p), k)",
            "(sandwich(m, sandwich(n, p)), m * n)",
            "(m * n * p * rev(m * n), rev(rev(n) * rev(m)))",
        ],
    ),
    (
        "uniform m: Motor, uniform n: Motor, p: Point -> Point",
        &[
            "sandwich(m * n, p)",
            "sandwich(m, sandwich(n, p))",
            "m * n * p * rev(n) * rev(m)",
        ],
    ),
    (
        "uniform m: Motor, n: Motor, p: Point -> Point",
        &[
            "sandwich(m * n, p)",
            "sandwich(m, sandwich(n, p))",
            "m * n * p * rev(n) * rev(m)",
        ],
    ),
    (
        "uniform m: Motor, p: Point, q: Point -> Line",
        &[
            "sandwich(m, p ^ q ^ ei)",
            "sandwich(m, p) ^ sandwich(m, q) ^ ei",
        ],
    ),
    (
        "t: Translator, r: Rotor, d: Dilator, p: Point -> Point",
        &[
            "let q = sandwich(t * r * d, p); q / q.eo",
            "let q = sandwich(t, sandwich(r, sandwich(d, p))); q / q.eo",
            "let q = t * r * d * p * rev(t * r * d); q * (1 / q.eo)",
        ],
    ),
    (
        "m: Motor, a: Line, b: Line -> Scalar",
        &[
            "sandwich(m, a) | sandwich(m, b)",
            "a | b",
            "scalar_product(b, a)",
        ],
    ),
    (
        "m: Motor, a: Plane, b: Line -> FlatPoint",
        &[
            "sandwich(m, a & b)",
            "sandwich(m, a) & sandwich(m, b)",
            "undual(dual(sandwich(m, a)) ^ dual(sandwich(m, b)))",
        ],
    ),
    (
        "m: Motor, a: Sphere -> DualSphere",
        &[
            "dual(sandwich(m, a))",
            "sandwich(m, dual(a))",
            "sandwich(m, a) * inverse(e123oi)",
            "-sandwich(m, a) * e123oi",
        ],
    ),
    (
        "r: Rotor, s: Rotor -> Rotor",
        &[
            "r * s * rev(r)",
            "sandwich(r, s)",
            "let k = r * s; k * rev(r)",
        ],
    ),
    (
        "p: Point, q: Point, r: Point -> Circle",
        &[
            "p ^ q ^ r",
            "p ^ (q ^ r)",
            "-(q ^ p ^ r)",
            "wedge(wedge(p, q), r)",
            "r ^ p ^ q",
        ],
    ),
    (
        "p: Point, q: Point, r: Point -> Plane",
        &["p ^ q ^ r ^ ei", "-(ei ^ p ^ q ^ r)", "(p ^ q) ^ (r ^ ei)"],
    ),
    (
        "p: Point, a: DualPlane -> RoundVector",
        &[
            "(p ^ a) * inverse(a)",
            "(p ^ a) * a / (a | a)",
            "p - (p | a) * inverse(a)",
            "p - (a | p) * a / (a * a)",
        ],
    ),
    (
        "p: Point, a: Plane -> RoundVector",
        &[
            "(p | a) * inverse(a)",
            "(p | a) * a / (a * a)",
            "(p | a) | inverse(a)",
            "((p | a) | a) / (a | a)",
        ],
    ),
    (
        "a: DualPlane, p: Point -> Point",
        &[
            "-(a * p * inverse(a))",
            "sandwich(a, p) / (a * a)",
            "p - 2 * (a | p) / (a | a) * a",
            "p - 2 * (p | a) * inverse(a)",
        ],
    ),
    (
        "s: RoundVector, p: Point -> RoundVector",
        &[
            "sandwich(s, p)",
            "(s | s) * p - 2 * (s | p) * s",
            "(s * s) * p - 2 * s * (p | s)",
        ],
    ),
    (
        "m: Motor, n: Motor, p: Point, q: Point -> Scalar",
        &[
            "sandwich(m, p) | sandwich(n, q)",
            "p | sandwich(rev(m) * n, q)",
            "sandwich(rev(n) * m, p) | q",
        ],
    ),
    (
        "m: Motor, p: Point, a: Plane -> Scalar",
        &[
            "(sandwich(m, p) ^ a).e123oi",
            "-(sandwich(m, p) | dual(a))",
            "(p ^ sandwich(rev(m), a)).e123oi",
        ],
    ),
    (
        "m: Rotor -> Rotor",
        &[
            "m * m * m * m * m",
            "m * (m * m) * (m * m)",
            "let k = m * m; k * k * m",
        ],
    ),
    (
        "p: Point, q: Point -> Scalar",
        &[
            "norm_squared(p ^ q)",
            "grade((p ^ q) * rev(p ^ q), 0)",
            "-((p ^ q) | (p ^ q))",
            "-(p | q) * (p | q)",
        ],
    ),
    (
        "a: RoundVector, b: RoundVector -> Even",
        &["a * b", "(a | b) + (a ^ b)", "rev(b * a)"],
    ),
    (
        "g: MotorGenerator, t: Scalar -> Motor",
        &[
            "exp(t * g)",
            "exp(g * t)",
            "exp(g / (1 / t))",
            "exp((t * g))",
            "exp(t / 2 * g + t / 2 * g)",
            "rev(exp(-t * g))",
        ],
    ),
    (
        "m: Motor, t: Scalar -> Motor",
        &[
            "exp(t * log(m))",
            "exp(log(m) * t)",
            "let g = log(m); exp(t * g)",
            "exp(t / 2 * log(m) + log(m) * t / 2)",
            "rev(exp(-t * log(m)))",
        ],
    ),
    (
        "m: Motor, n: Motor, t: Scalar -> Motor",
        &[
            "m * exp(t * log(rev(m) * n))",
            "let d = rev(m) * n; m * exp(log(d) * t)",
            "m * exp(t * log(inverse(m) * n))",
            "m * exp(t * log(rev(rev(n) * m)))",
            "m * rev(exp(-t * log(rev(m) * n)))",
        ],
    ),
    (
        "p: Point, d: Direction, c: Point, r: Scalar -> Scalar",
        &[
            "norm_squared((p ^ d) & undual(c - r * r / 2 * ei))",
            "norm_squared(undual(c - r * r / 2 * ei) & (p ^ d))",
            "let s = c - ei * r * r / 2; norm_squared(s | (p ^ d))",
            "let k = (c - r * r / 2 * ei) | (p ^ d); k | k",
            "let k = (c - 0.5 * r * r * ei) | (p ^ d); grade(k * k, 0)",
        ],
    ),
    (
        "c: Point, r: Scalar, p: Point -> Point",
        &[
            "point(sandwich(c - r * r / 2 * ei, p))",
            "let q = sandwich(c - r * r / 2 * ei, p); q / q.eo",
            "let s = c - ei * r * r / 2; let q = s * p * s; q / -(q | ei)",
            "let s = c - ei * r * r / 2; point(s * p * inverse(s))",
            "let q = sandwich(c - r * r / 2 * ei, p); q * (1 / q.eo)",
        ],
    ),
    (
        "p: Point, a: Point, b: Point -> Point",
        &[
            "let l = a ^ b ^ ei; point((p | l) * inverse(l))",
            "let l = b ^ a ^ ei; point((p | l) * inverse(l))",
            "let l = a ^ b ^ ei; point((p | l) * l / (l * l))",
            "let l = a ^ b ^ ei; point((p | l) | l)",
            "let l = a ^ b ^ ei; let q = (p | l) | l; point(q / (l | l))",
        ],
    ),
    (
        "s: Similarity, t: Similarity, x: Point -> Point",
        &[
            "point(sandwich(s * t, x))",
            "let q = sandwich(s * t, x); q / q.eo",
            "point(sandwich(s, sandwich(t, x)))",
            "let k = s * t; point(k * x * rev(k))",
            "let q = sandwich(s, sandwich(t, x)); q * (1 / q.eo)",
        ],
    ),
    (
        "a: Point, b: Point, c: Point -> Point",
        &[
            "point(a ^ b ^ c)",
            "point(c ^ b ^ a)",
            "let k = a ^ b ^ c; let q = k * ei * k; q / q.eo",
            "let k = a ^ b ^ c; point(k * ei * inverse(k))",
            "let k = a ^ (b ^ c); let q = k * ei * rev(k); q / -(q | ei)",
        ],
    ),
    (
        "m: Motor, n: Motor, a: Scalar, b: Scalar, x: Point -> Point",
        &[
            "sandwich(normalize(a * m + b * n), x)",
            "sandwich(normalize(n * b + m * a), x)",
            "let k = normalize(a * m + b * n); k * x * rev(k)",
            "let k = normalize(a * m + b * n); k * x * inverse(k)",
            "sandwich(normalize(2 * a * m + b * n + n * b) , x)",
        ],
    ),
    (
        "p: Point, d: Direction, s: DualSphere -> (Point, Point)",
        &[
            "endpoints((p ^ d) & undual(s))",
            "endpoints(s | (p ^ d))",
            "endpoints(undual(s) & (p ^ d))",
            "let k = s | (p ^ d); endpoints(k)",
            "endpoints((s | (p ^ d)) * 1)",
        ],
    ),
];

pub(super) const PGA3: &[Group] = &[
    (
        "m: Motor, n: Motor, a: Plane, b: Plane -> Scalar",
        &[
            "sandwich(m, a) | sandwich(n, b)",
            "a | sandwich(rev(m) * n, b)",
        ],
    ),
    (
        "m: Motor, n: Motor, p: Point -> Point",
        &[
            "sandwich(m * n, p)",
            "sandwich(m, sandwich(n, p))",
            "m * n * p * rev(n) * rev(m)",
            "m * n * p * inverse(m * n)",
        ],
    ),
    (
        "m: Motor, a: Plane, b: Plane -> Line",
        &[
            "sandwich(m, a ^ b)",
            "sandwich(m, a) ^ sandwich(m, b)",
            "-(sandwich(m, b) ^ sandwich(m, a))",
        ],
    ),
    (
        "m: Motor, p: Point -> Point",
        &["rev(m) * (m * p * rev(m)) * m", "p"],
    ),
    ("m: Motor -> Motor", &["m * m", "rev(rev(m) * rev(m))"]),
    (
        "p: Point, q: Point -> Line",
        &["p & q", "undual(dual(p) ^ dual(q))", "vee(p, q)"],
    ),
    (
        "a: Plane, b: Plane -> Scalar",
        &["a | b", "b | a", "grade(a * b, 0)", "(a * b + b * a) / 2"],
    ),
    (
        "r: Rotor, s: Rotor -> Rotor",
        &["r * s * rev(r)", "sandwich(r, s)", "r * (s * inverse(r))"],
    ),
    (
        "m: Motor, a: Plane, b: Plane -> Plane",
        &[
            "sandwich(m, a + b)",
            "sandwich(m, a) + sandwich(m, b)",
            "m * b * rev(m) + m * a * rev(m)",
        ],
    ),
];

pub(super) const MINKOWSKI: &[Group] = &[
    (
        "a: Vector, v: Vector -> Vector",
        &[
            "-(a * v * inverse(a))",
            "sandwich(a, v) / (a * a)",
            "v - 2 * (a | v) / (a | a) * a",
        ],
    ),
    (
        "m: Boost, n: Boost, v: Vector -> Vector",
        &[
            "sandwich(m * n, v)",
            "sandwich(m, sandwich(n, v))",
            "m * n * v * rev(n) * rev(m)",
        ],
    ),
    (
        "m: Boost, v: Vector, w: Vector -> Bivector",
        &["sandwich(m, v ^ w)", "sandwich(m, v) ^ sandwich(m, w)"],
    ),
    (
        "m: Boost, v: Vector, w: Vector -> Scalar",
        &[
            "sandwich(m, v) | sandwich(m, w)",
            "v | w",
            "(v * w + w * v) / 2",
        ],
    ),
    (
        "v: Vector, w: Vector -> Bivector",
        &[
            "v ^ w",
            "-(w ^ v)",
            "(v * w - w * v) / 2",
            "commutator(v, w)",
        ],
    ),
    (
        "s: Scalar, v: Vector, w: Vector -> Bivector",
        &["s * (v ^ w)", "(s * v) ^ w", "v ^ (w * s)"],
    ),
];
