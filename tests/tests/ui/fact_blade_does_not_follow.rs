//! Not every bivector of four dimensions is a blade.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3, e4;
        signature 4, 0, 0;

        #[hull(Sums)]
        #[facts(blade)]
        struct Plane { e12, e13, e14, e23, e24, e34 }
        struct Sums { e12, e13, e14, e23, e24, e34 }
    }
}

fn main() {}
