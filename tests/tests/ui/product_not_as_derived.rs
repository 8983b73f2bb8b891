//! The result of a product is of another weight than its type.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2 }
        #[hull(Sums)]
        #[facts(weight(e3))]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1, e2, e3 }

        products {
            sandwich(Vector, Point) -> Point;
        }
    }
}

fn main() {}
