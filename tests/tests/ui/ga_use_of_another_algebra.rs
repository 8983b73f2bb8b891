//! A function of another algebra has no meaning here.

mod kernels {
    ga_runtime::ga! { ga_runtime::pga3;
        /// The join of two points.
        pub fn joined(p: Point, q: Point) -> Line { p & q }
    }
}

ga_runtime::ga! { ga_runtime::cga3;
    use kernels::joined;
    fn all(p: Point, q: Point) -> Scalar { joined(p, q) | ei }
}

fn main() {}
