//! Warnings, made errors here: products and results that are zero for all operands.

#![deny(deprecated)]

// Products that are zero by their grades, by a common factor, and since points are null.
mod products {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn grades(p: Point, s: Sphere) -> Scalar { (s | p) + 1 }
        fn outer(s: Sphere, l: Line) -> Scalar { 2 + wedge(s, l) }
        fn common(p: Point, l: Line) -> Plane { (p ^ l) + (l ^ ei) }
        fn null(p: Point) -> Scalar { let square = p * p; square + 1 }
        // Once for the product, not again for the result.
        fn once(p: Point) -> Scalar { p | p }
        // Written where it stands, not where it is called.
        fn caller(p: Point) -> Scalar { once(p) + 1 }
    }
}

// Results.
mod results {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn difference(p: Point, q: Point) -> Scalar { (p | q) - (q | p) }
        fn part(m: Motor) -> (Scalar, Scalar) { (m.scalar, scalar_product(grade(m, 4), e12)) }
    }

    fn closure() -> f64 {
        let zero = ga! { ga_runtime::cga3; |x: Scalar| -> Scalar { x - x } };
        zero(1.0)
    }
}

// None of these warns.
mod silent {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        fn number() -> Scalar { 0 }
        fn numbers(p: Point) -> [Scalar; 2] { [p.e1, 0] }
        fn factor(p: Point) -> RoundVector { p + 0 * ei }
        #[allow(deprecated)]
        fn allowed(p: Point) -> Scalar { p | p }
    }
}

fn main() {}
