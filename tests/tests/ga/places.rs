//! Where `ga!` may be used, and by which paths an algebra may be named.

ga_runtime::algebra! {
    /// The plane, at the root of a module.
    pub mod plane {
        basis e1, e2;
        signature 2;
        struct Vector { e1, e2 }
        struct Complex { scalar, e12 }
    }
}

pub mod inner {
    //! The same algebra by each kind of path.
    #![deny(warnings, missing_docs, clippy::all, clippy::pedantic)]
    #![allow(unreachable_pub)]

    use super::plane as alias;

    ga_runtime::ga! { super::plane;
        /// By `super`, with **markup** and a second line.
        /// # Examples
        /// None.
        #[must_use]
        pub fn by_super(a: Vector, b: Vector) -> Complex { a * b }
    }
    ga_runtime::ga! { alias;
        /// By another name.
        #[must_use]
        pub fn by_alias(a: Vector, b: Vector) -> Complex { a * b }
    }
    ga_runtime::ga! { crate::places::plane;
        /// From the root of the crate.
        #[must_use]
        pub fn by_crate(a: Vector, b: Vector) -> Complex { a * b }
    }
    ga_runtime::ga! { ::ga_runtime::cga3;
        /// From another crate.
        #[must_use]
        pub fn absolute(p: Point, uniform q: Point) -> Scalar { p | q }
    }
    ga_runtime::ga! { self::alias;
        /// Visible in this crate only.
        pub(crate) fn by_self(a: Vector, b: Vector) -> Complex { only_here(a, b) }
        pub(super) fn to_parent(a: Vector) -> Vector { 2 * a }
        fn only_here(a: Vector, b: Vector) -> Complex { a * b }
        pub(in crate::places) fn within(a: Vector) -> Vector { 3 * a }
    }
}

/// An algebra and functions inside a function, with the name of the module shadowed.
fn local() -> (i64, i64) {
    ga_runtime::algebra! {
        mod numbers {
            basis e1;
            signature 1;
            struct Vector { e1 }
            struct All { scalar, e1 }
        }
    }
    ga_runtime::ga! { numbers; fn squared(a: All) -> All { a * a } }
    let square = squared(numbers::All::new(2, 3));
    (square.scalar, square.e1)
}

mod importing {
    ga_runtime::ga! { super::plane;
        use super::inner::by_super;
        use crate::places::inner::by_super as other;
        pub fn sum(a: Vector, b: Vector) -> Complex { by_super(a, b) + other(b, a) }
        pub fn twice(a: Vector) -> Vector { a + a }
    }
}

mod importing_several {
    ga_runtime::ga! { super::plane;
        use super::{importing::{sum, twice as double}, inner::by_super};
        pub fn sums(a: Vector, b: Vector) -> Complex { sum(a, double(b)) + by_super(b, a) }
    }
}

#[test]
fn every_path_leads_to_the_algebra() {
    let (a, b) = (plane::Vector::new(1, 2), plane::Vector::new(3, 5));
    let product = plane::Complex::new(13, -1);
    assert_eq!(inner::by_super(a, b), product);
    assert_eq!(inner::by_alias(a, b), product);
    assert_eq!(inner::by_crate(a, b), product);
    assert_eq!(inner::by_self(a, b), product);
    assert_eq!(inner::to_parent(a) + inner::within(a), a * 5);
    assert_eq!(local(), (13, 12));
    assert_eq!(importing::sum(a, b), plane::Complex::new(26, 0));
    // a 2b + 2b a = 4 a·b = 52, and b a = 13 + e12.
    assert_eq!(importing_several::sums(a, b), plane::Complex::new(65, 1));
    use ga_runtime::cga3::Point;
    let (origin, p) = (Point::new(0.0, 0.0, 0.0), Point::new(1.0, 1.0, 0.0));
    assert_eq!(inner::absolute(origin).apply(p), -1.0);
}
