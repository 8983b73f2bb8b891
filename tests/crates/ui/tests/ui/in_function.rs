//! A faulty declaration inside a function.

fn main() {
    ga_runtime::algebra! {
        mod vga2 {
            basis e1, e2;
            signature 2;

            struct Vector { e1, e2, e3 }
            struct Bivector { e12 }

            products { wedge(Vector, Vector); }
        }
    }
    use vga2::{Bivector, Vector};

    let area: Bivector<f64> = Vector::new(1.0, 0.0) ^ Vector::new(0.0, 1.0);
    println!("{}", area.e12);
}
