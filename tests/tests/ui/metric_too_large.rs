//! Products of blades would have coefficients beyond 64 bits.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3, e4;
        metric e1*e1 = 1, e2*e2 = 900000, e3*e3 = 1000000, e1*e4 = 1000*1000 - 1, e2*e3 = 700000;

        struct Vector { e1, e2, e3, e4 }
    }
}

fn main() {}
