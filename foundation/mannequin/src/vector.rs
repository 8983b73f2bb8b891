//! Vectors of the body, and its plane of symmetry.

/// A vector or a place: x to the left of the body, y up, z to the front, in metres.
pub(crate) type Vector = ga_runtime::vga3::Vector<f64>;

/// The mirror image in the plane x = 0, the body's plane of symmetry.
pub(crate) fn mirror(v: Vector) -> Vector {
    Vector::new(-v.e1, v.e2, v.e3)
}
