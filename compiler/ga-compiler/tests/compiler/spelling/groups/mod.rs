//! Groups of spellings: the types of the operands and the result, and formulas that mean the same.

mod formulas;
mod moved;
mod products;

pub(super) type Group = (&'static str, &'static [&'static str]);

/// The groups of cga3.
pub(super) fn cga3() -> Vec<Group> {
    [products::GROUPS, moved::GROUPS, formulas::GROUPS].concat()
}

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
