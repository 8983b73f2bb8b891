//! A faulty metric is reported with faults of types and products; results are not judged.

ga_runtime::algebra! {
    mod vga2 {
        basis e1, e2;
        metric e1*e1 = 1, e2*e2 = 1, e1*e2 = 1, e2*e1 = 2;

        struct Vector { e1, e2 }
        struct Bivector { e12, e21 }

        products {
            geometric(Vector, Vector) -> Scalar;
            wedge(Vector, Vectors);
        }
    }
}

fn main() {}
