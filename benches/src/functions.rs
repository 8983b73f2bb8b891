//! The functions of `ga!` that are measured.

ga_runtime::ga! { ga_runtime::cga3;
    /// The circle through three points.
    pub fn circle_through(p: Point, q: Point, r: Point) -> Circle { p ^ q ^ r }

    /// The sphere through four points.
    pub fn sphere_through(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }
}
