//! What is made of moved elements in cga3, with uniform versors too.

use super::Group;

pub(super) const GROUPS: &[Group] = &[
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
];
