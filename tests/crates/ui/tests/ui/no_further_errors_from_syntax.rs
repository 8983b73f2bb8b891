//! The types of a declaration with a fault of syntax can be used without further errors.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23
        }
        struct Trivector { e123: S }

        products { wedge(Vector, Vector); }
    }
}

mod tests {
    ga_runtime::testing::product_tests!(super::vga3);
}

mod everything {
    use super::vga3::*;

    pub fn volume(a: Vector<f64>, b: Vector<f64>, c: Vector<f64>) -> Trivector<f64> {
        let area: Bivector<f64> = a ^ b;
        area ^ c
    }
}

fn main() {
    use vga3::Vector;

    let vectors = [Vector::new(1.0, 2.0, 3.0); 3];
    println!("{}", everything::volume(vectors[0], vectors[1], vectors[2]).e123);
}
