//! Products of versors and of elements in cga3.

use super::Group;

pub(super) const GROUPS: &[Group] = &[
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
];
