//! Closures report as functions do.

fn g() -> f64 {
    ga_runtime::ga! { ga_runtime::cga3; |p: Point, q: Point| -> Scalar { p | r } };
    0.0
}

fn main() {}
