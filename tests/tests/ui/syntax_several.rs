//! Each item that leaves the grammar is reported.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2; e3 }
        struct Bivector;
        #[hull]
        struct Trivector { e123 }
        struct Even { scalar, e12, e13, e23 }
        products {
            wedge[Vector, Vector];
            geometric(Even, Even) => Even;
            geometric(Vector, Vector) -> Even;
        }
    }
}

fn main() {}
