//! Types by parameters whose formulas do not fit.

// A parameter of an unknown type, and a formula of a name that is none.
ga_runtime::algebra! {
    mod unknown_names {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }
        struct RoundVector { e1, e2, e3, eo, ei }

        #[hull(RoundVector)]
        struct Ball { centre: Pont, squared_radius; self = centre - squared_radius/2 * ei; }
        #[hull(RoundVector)]
        struct Shell { centre: Point, squared_radius; self = middle - squared_radius/2 * ei; }
    }
}

// A parameter is not read, one is read twice, another is bound by `let`, and one is not there.
ga_runtime::algebra! {
    mod readings {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }
        struct RoundVector { e1, e2, e3, eo, ei }

        #[hull(RoundVector)]
        struct Ball {
            centre: Point, squared_radius;
            self = centre - squared_radius/2 * ei;
            squared_radius = self | self;
        }
        #[hull(RoundVector)]
        struct Twice {
            centre: Point, squared_radius;
            self = centre - squared_radius/2 * ei;
            squared_radius = self | self;
            squared_radius = self | self;
        }
        #[hull(RoundVector)]
        struct Bound {
            centre: Point, squared_radius;
            self = centre - squared_radius/2 * ei;
            let squared_radius = self | self;
        }
        #[hull(RoundVector)]
        struct Other {
            centre: Point, squared_radius;
            self = centre - squared_radius/2 * ei;
            radius = self | self;
        }
    }
}

// What is read is another parameter than the one that was written.
ga_runtime::algebra! {
    mod another_parameter {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }
        struct RoundVector { e1, e2, e3, eo, ei }

        #[hull(RoundVector)]
        struct Ball {
            centre: Point, squared_radius;
            self = centre - squared_radius/2 * ei;
            squared_radius = 2 * (self | self);
            centre = self + (self | self)/2 * ei;
        }
    }
}

// What is read is not of the type of the parameter.
ga_runtime::algebra! {
    mod another_type {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }
        struct RoundVector { e1, e2, e3, eo, ei }

        #[hull(RoundVector)]
        struct Ball {
            centre: Point, squared_radius;
            self = centre - squared_radius/2 * ei;
            squared_radius = self | self;
            centre = self;
        }
    }
}

// The multivector is not in the hull, and there is no hull.
ga_runtime::algebra! {
    mod hulls {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }
        struct RoundVector { e1, e2, e3, eo, ei }

        #[hull(Point)]
        struct Ball { centre: Point, squared_radius; self = centre - squared_radius/2 * ei; }
        struct Shell { centre: Point, squared_radius; self = centre - squared_radius/2 * ei; }
        #[hull(Skin)]
        struct Skin { centre: Point, squared_radius; self = centre - squared_radius/2 * ei; }
    }
}

fn main() {}
