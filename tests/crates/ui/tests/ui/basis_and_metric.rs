//! Faults of the basis and of the metric.

// There are more basis vectors than are supported.
ga_runtime::algebra! {
    mod basis_too_large {
        basis x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15, x16, x17;
        signature 17, 0, 0;

        struct Vector { x1, x17 }
    }
}

// A basis vector is named `scalar`, like the scalar coefficient.
ga_runtime::algebra! {
    mod basis_vector_scalar {
        basis e1, e2, scalar;
        signature 3, 0, 0;

        struct Vector { e1, e2 }
    }
}

// A basis vector is listed twice.
ga_runtime::algebra! {
    mod basis_vector_twice {
        basis e1, e2, e2;
        signature 3, 0, 0;

        struct Vector { e1, e2 }
    }
}

// An entry of the metric is written as a decimal fraction.
ga_runtime::algebra! {
    mod metric_entry_decimal {
        basis e1, e2;
        metric e1*e1 = 0.5, e2*e2 = 1;

        struct Vector { e1, e2 }
    }
}

// An entry of the metric is not a number.
ga_runtime::algebra! {
    mod metric_entry_not_constant {
        basis e1, e2;
        metric e1*e1 = 1, e2*e2 = 2*e1;

        struct Vector { e1, e2 }
    }
}

// An entry of the metric is stated twice.
ga_runtime::algebra! {
    mod metric_entry_twice {
        basis e1, e2;
        metric e1*e1 = 1, e2*e2 = 1, e1*e1 = 1;

        struct Vector { e1, e2 }
    }
}

// Two entries of the metric contradict each other.
ga_runtime::algebra! {
    mod metric_not_symmetric {
        basis e1, e2;
        metric e1*e1 = 1, e1*e2 = 1, e2*e1 = -1;

        struct Vector { e1, e2 }
    }
}

// Products of blades would have coefficients beyond 64 bits.
ga_runtime::algebra! {
    mod metric_too_large {
        basis e1, e2, e3, e4;
        metric e1*e1 = 1, e2*e2 = 900000, e3*e3 = 1000000, e1*e4 = 1000*1000 - 1, e2*e3 = 700000;

        struct Vector { e1, e2, e3, e4 }
    }
}

// The metric names a vector that is not in the basis.
ga_runtime::algebra! {
    mod metric_unknown_vector {
        basis e1, e2;
        metric e1*e1 = 1, e3*e3 = 1;

        struct Vector { e1, e2 }
    }
}

// Squares stand beside some vectors only.
ga_runtime::algebra! {
    mod squares_incomplete {
        basis e0 = 0, e1, e2 = 1;

        struct Vector { e0, e1, e2 }
    }
}

// A square is stated beside the vector and in the metric.
ga_runtime::algebra! {
    mod squares_twice {
        basis e1 = 1, eo = 0, ei = 0;
        metric eo*ei = -1, e1*e1 = 1;

        struct Vector { e1, eo, ei }
    }
}

// Squares stand beside the vectors, and a signature is given.
ga_runtime::algebra! {
    mod squares_and_signature {
        basis e0 = 0, e1 = 1, e2 = 1;
        signature 2, 0, 1;

        struct Vector { e0, e1, e2 }
    }
}

// A square is not a number.
ga_runtime::algebra! {
    mod squares_not_constant {
        basis e0 = e1, e1 = 1;

        struct Vector { e0, e1 }
    }
}

// There is no metric.
ga_runtime::algebra! {
    mod no_metric {
        basis e0, e1;

        struct Vector { e0, e1 }
    }
}

// The signature counts more basis vectors than are named.
ga_runtime::algebra! {
    mod signature_count {
        basis e1, e2, e3;
        signature 2, 0, 2;

        struct Vector { e1, e2, e3 }
    }
}

fn main() {}
