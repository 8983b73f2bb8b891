//! The factors of a derived blade are small one by one, and too large together.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Nested { e1, e2, e3 = 1000000*(e1*1000000*(e2*(1000000*e1)*1000000*(e2*1000000))*1000000*1000000) }
        #[hull(Sums)]
        struct Power { e1, e2, e3 = (100*e1 + 100*e2)*(100*e1 - 100*e2)*(100*e1 - 100*e2) }
        #[hull(Sums)]
        struct Fractions { e1, e2, e3 = e1/1009 + e2/1013 }
        #[hull(Sums)]
        struct Exact { e1, e2, e3 = e1/1000000 + 999999*(e2/1000000) }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}
