//! Faults of the grammar of `ga!`, of its numbers and of its patterns.

// A statement after the value.
mod after_value {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { a; let b = a; b }
    }
}

// An assignment.
mod assignment {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { a += 1; a }
    }
}

// Comparisons in a row, and a mark that does not exist.
mod chain {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar, b: Scalar, c: Scalar) -> Scalar { select(a < b < c, 1, 0) }
    }

    ga! { ga_runtime::cga3;
        fn g(const a: Scalar) -> Scalar { a }
    }
}

// A fault in a closure.
mod closure {
    fn g() -> f64 {
        ga_runtime::ga! { ga_runtime::cga3; |p: Point, q: Point| -> Scalar { p | r } };
        0.0
    }
}

// Arrays whose length is not the declared one, and elements beyond the end.
mod elements {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> [Scalar; 3] { [a, a] }
        fn g(a: [Scalar; 2]) -> Scalar { a[2] }
        fn h(a: Scalar) -> Scalar { a[0] }
        fn i(a: [Scalar; 2]) -> Scalar { a * 2 }
    }
}

// A block without a function.
mod empty {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3; }
}

// Nothing at all.
mod empty_macro {
    ga_runtime::ga! {}
}

// A body without a value.
mod empty_body {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { let b = a; }
    }
}

// A function that names the parameter for its scalar, and one that names its scalar.
mod generic {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f<S>(a: Scalar) -> Scalar { a }
    }

    ga! { ga_runtime::cga3;
        fn g(p: Point<f64>) -> Point { p }
    }
}

// Keywords of Rust.
mod keyword {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { if a { 1 } else { 2 } }
    }
}

// A `let` without its semicolon.
mod let_semicolon {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point, q: Point) -> Line {
            let pair = p ^ q
            pair ^ ei
        }
    }
}

// A `let` whose value does not have the stated type.
mod let_type {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point, q: Point) -> Scalar { let line: Line = p ^ q; norm(line) }
    }
}

// A formula that nests too deep.
mod levels {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar {
            ----------------------------------------------------------------
            ----------------------------------------------------------------
            -a
        }
    }
}

// Products and sums mixed without parentheses.
mod mixed_operators {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point, q: Point, r: Point) -> PointPair { p ^ q - r }
    }
}

// A function without the type of its result.
mod no_result {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) { a }
    }
}

// Numbers that are too large and too small. Long ones are not an error.
mod number_range {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(x: Scalar) -> Scalar { x * 1000000007 * 1000000009 * 1000000021 * 1000000033 * 1000000087 }
        fn g(x: Scalar) -> Scalar { x * 3.14159265358979 }
    }

    ga! { ga_runtime::cga3;
        fn h(x: Scalar) -> Scalar { x * 1e60 }
    }

    ga! { ga_runtime::cga3;
        fn i(x: Scalar) -> Scalar { x * 3.14159265358979323846e-60 }
    }
}

// A number with a type suffix.
mod number_suffix {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: Point) -> RoundVector { 2.0_f64 * p }
    }
}

// A path without its semicolon.
mod path_semicolon {
    ga_runtime::ga! { ga_runtime::cga3 fn f(a: Scalar) -> Scalar { a } }
}

// A type with its path.
mod path_of_type {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: ga_runtime::cga3::Point) -> Scalar { p | p }
    }
}

// Patterns that do not match their values.
mod pattern {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: (Scalar, Scalar)) -> Scalar { let (x, y, z) = a; x }
        fn g(a: Scalar) -> Scalar { let [x] = a; x }
    }
}

// A mutable pattern.
mod pattern_mutable {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(a: Scalar) -> Scalar { let mut x = a; x }
    }
}

// References.
mod reference {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn f(p: &Point, q: &Point) -> Scalar { p | q }
    }
}

// All functions of a module.
mod use_of_all {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        use super::closure::*;
        fn f(a: Scalar) -> Scalar { a }
    }
}

fn main() {}
