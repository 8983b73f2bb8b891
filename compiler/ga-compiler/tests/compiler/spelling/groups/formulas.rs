//! Formulas of textbooks in cga3.

use super::Group;

pub(super) const GROUPS: &[Group] = &[
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
