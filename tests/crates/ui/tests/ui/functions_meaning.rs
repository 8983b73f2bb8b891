//! Functions of `ga!` whose names, types or values do not fit.

// An operand that is marked as a blade without need, and an argument that may not be one.
mod blade_mark {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(blade m: Motor) -> Motor { m }
        fn g(blade p: Point) -> Point { p }
        fn inverted(blade c: Trivector) -> Trivector { inverse(c) }
        fn h(c: Trivector, p: Bivector, q: Point) -> Trivector { inverted(c) + inverted(p ^ q) }
        fn i(p: Point, q: Point, r: Point) -> Trivector { inverted(p ^ q ^ r) }
        fn j(c: Trivector) -> Trivector { inverse(c) }
    }
}

// A coefficient that the operand's type does not have.
mod blade_missing {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: Motor) -> Scalar { m.e12oi }
        fn g(m: Motor) -> Scalar { m.length }
    }
}

// Conditions and multivectors in each other's places.
mod condition {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn compared(p: Point, q: Point) -> Scalar { select(p == q, 1, 0) }
        fn no_condition(x: Scalar) -> Scalar { select(x, 1, 0) }
        fn no_number(x: Scalar) -> Scalar { 2 * (x < 1) }
        fn result(x: Scalar) -> Scalar { x < 1 }
        fn shapes(x: Scalar) -> [Scalar; 2] { select(x < 1, [x, x], x) }
        fn types(x: Scalar, p: Point, v: RoundVector) -> Point { select(x > 0, p, v) }
    }
}

// A divisor that is not a scalar.
mod divisor {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point, q: RoundVector) -> Even { p / q }
    }
}

// A divisor that is always zero.
mod divisor_zero {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point) -> Scalar { 1 / (p | p) }
        fn g(p: Point) -> Scalar { recip(p | p) }
        fn h(p: Point) -> Point { inverse(p) }
    }
}

// The exponential of a vector.
mod exp {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point) -> Even { exp(p) }
        fn g(b: Bivector) -> Even { exp(b) }
    }
}

// A function with the name of an operation.
mod function_named_like_operation {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn reverse(a: Scalar) -> Scalar { -a }
        fn f(m: Motor) -> Motor { reverse(m) }
    }
}

// Two functions with the same name.
mod function_twice {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { a }
        fn f(a: Scalar) -> Scalar { a + 1 }
    }
}

// A grade that is not a whole number.
mod grade {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: Motor, k: Scalar) -> Motor { grade(m, k) }
        fn g(m: Motor) -> Scalar { grade(m, 0.5) }
    }
}

// A result with blades that its type lacks.
mod left_over {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point, q: Point) -> Line { p ^ q }
        fn g(p: Point, q: Point) -> Scalar { p * q }
    }
}

// The logarithm of something that is not a unit versor.
mod log {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: DualQuaternion) -> MotorGenerator { log(m) }
        fn g(p: Plane) -> Plane { sqrt(p) }
    }
}

// A result that is a motor only up to its norm.
mod not_unit {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: Motor, n: Motor) -> Motor { m + n }
    }
}

// Too few operands and too many.
mod operand_count {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: Motor, p: Point) -> Point { sandwich(m) }
        fn g(m: Motor, p: Point) -> Point { h(m, p, p) }
        fn h(m: Motor, p: Point) -> Point { m * p * rev(m, m) }
    }
}

// A call whose operand has the wrong type.
mod operand_type {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point, q: Point) -> Scalar { g(p ^ q, p) }
        fn g(a: Circle, p: Point) -> Scalar { norm_squared(a | p) }
    }
}

// Two functions that call each other.
mod recursion {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { g(a - 1) }
        fn g(a: Scalar) -> Scalar { a * f(a) }
    }

    ga! { ga_runtime::cga3;
        fn first(a: Scalar) -> Scalar { second(a - 1) }
        fn second(a: Scalar) -> Scalar { a * third(a) }
        fn third(a: Scalar) -> Scalar { first(a) + 1 }
        fn caller(a: Scalar) -> Scalar { third(a) }
    }
}

// A function of scalars, applied to a vector.
mod scalar_function {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point) -> Scalar { sin(p) }
        fn g(p: Point, q: Point) -> Scalar { atan2(p | q, p) }
    }
}

// Each function's first fault is reported.
mod several_faults {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { a + b }
        fn g(a: Scalar) -> Scalr { a }
        fn h(p: Point) -> Plane { p ^ ei }
    }
}

// A quotient by a norm of either sign is not a unit versor; too few random points would miss it.
mod sign_unknown {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn a(x: Scalar, y: Scalar) -> Dilator { let e = x + y * eoi; e / norm(e) }
        fn b(x: Scalar, y: Scalar) -> Dilator { let e = y + 2 * x * eoi; e / norm(e) }
        fn c(x: Scalar, y: Scalar) -> Dilator { let e = 3 * x + y * eoi; e / norm(e) }
        fn d(x: Scalar, y: Scalar) -> Dilator { let e = x + 4 * y * eoi; e / norm(e) }
    }
}

// Places of what has none, and in algebras without points.
mod place {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(e: Plane) -> Point { point(e) }
        fn g(l: Line) -> Point { point(l) }
        fn h(d: DualPlane) -> Point { point(d) }
        fn i(c: Circle) -> (Point, Point) { endpoints(c) }
        fn j(p: FlatPoint) -> (Point, Point) { endpoints(p) }
        fn k(p: PointPair) -> Point { endpoints(p) }
    }

    ga! { ga_runtime::pga3;
        fn l(p: Point) -> Point { point(p) }
    }
}

// Unknown names, one of them close to the name of an operand.
mod unknown_name {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(motor: Motor, p: Point) -> Point { moter * p * rev(motor) }
        fn g(p: Point) -> Scalar { p | e4 }
    }
}

// Operations that are neither built in nor functions of the block.
mod unknown_operation {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: Motor, p: Point) -> Point { m * p * reversed(m) }
        fn g(m: Motor) -> Motor { m.square() }
    }
}

// Unknown types.
mod unknown_type {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(m: Motr, p: Point) -> Point { m * p * rev(m) }
        fn g(p: Point) -> f64 { p | p }
    }
}

// A function of another algebra.
mod use_of_another_algebra {
    mod kernels {
        ga_runtime::ga! { ga_runtime::pga3;
            /// The join of two points.
            pub fn joined(p: Point, q: Point) -> Line { p & q }
        }
    }

    ga_runtime::ga! { ga_runtime::cga3;
        use kernels::joined;
        fn all(p: Point, q: Point) -> Scalar { joined(p, q) | ei }
    }
}

// Points whose weight is not 1; the message suggests the division.
mod weight {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(s: Sphere, p: Point) -> Point { sandwich(s, p) }
        fn g(x: RoundVector) -> Point { x }
    }
}

fn main() {}
