//! A semicolon is missing after a product.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        products { left_contraction(Vector, Vector) -> Scalar }
    }
}

fn main() {}
