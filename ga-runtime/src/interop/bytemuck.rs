//! bytemuck 1: the types of the algebras here as plain memory.
//!
//! A type is `repr(C)` with one field for each stored coefficient, all of the scalar's type and so
//! without padding. If the scalar is [`Pod`](bytemuck_1::Pod), so is every type, and slices of
//! elements are cast to bytes or numbers and back at no cost:
//!
//! ```
//! use ga_runtime::cga3::Point;
//! let mut points = [Point::new(1.0_f32, 2.0, 3.0), Point::new(4.0, 5.0, 6.0)];
//! assert_eq!(bytemuck_1::cast_slice::<_, f32>(&points), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
//! bytemuck_1::cast_slice_mut::<_, f32>(&mut points)[3] = 0.0;
//! assert_eq!(points[1], Point::new(0.0, 5.0, 6.0));
//! assert_eq!(bytemuck_1::bytes_of(&points).len(), 24);
//! ```
//!
//! # What casts do not check
//!
//! Any bytes can be cast to any type. Where the facts of a type restrict its coefficients, as for a
//! [`Rotor`](crate::cga3::Rotor) or a [`Motor`](crate::cga3::Motor), a cast checks as little as
//! `new_unchecked`: the caller must ensure the facts, and otherwise products are wrong, though
//! never unsafe. Zero, for instance, is not a rotor. `try_new` checks and `normalize` repairs
//! coefficients from outside.
//!
//! # Types of your own algebras
//!
//! They have the same layout. Implementing these traits takes unsafe code, which the macros here
//! never emit into another crate; a crate that allows unsafe code implements them itself:
//!
//! ```
//! mod algebra {
//!     ga_runtime::algebra! {
//!         pub mod plane {
//!             basis e1, e2;
//!             signature 2;
//!             /// A vector.
//!             struct Vector { e1, e2 }
//!             products { left_contraction(Vector, Vector) -> Scalar; }
//!         }
//!     }
//! }
//! use algebra::plane::Vector;
//! // SAFETY: the type is repr(C) with two fields of type S, hence without padding, and any
//! // values of them are valid.
//! unsafe impl<S: bytemuck_1::Zeroable> bytemuck_1::Zeroable for Vector<S> {}
//! unsafe impl<S: bytemuck_1::Pod> bytemuck_1::Pod for Vector<S> {}
//!
//! # fn main() {
//! assert_eq!(
//!     bytemuck_1::cast::<_, [f32; 2]>(Vector::new(1.0_f32, 2.0)),
//!     [1.0, 2.0]
//! );
//! # }
//! ```

/// Passes the types with the number of their stored coefficients to a macro. That macro stands in
/// `unsafe_code/plain_memory.rs`.
macro_rules! declared_types {
    ($callback:ident) => {
        $callback! { cga3 {
            Point 3, RoundVector 5, DualSphere 5, DualPlane 4, Bivector 10, Trivector 10, Quadvector 5, PointPair 7,
            DualCircle 7, FlatPoint 4, Direction 3, MotorGenerator 6, Circle 7, DualPointPair 7, DualFlatPoint 4, DualDirection 3, Line 6, Sphere 5,
            Plane 4, Pseudoscalar 1, Rotor 4, Translator 3, Motor 8, Dilator 2, Similarity 12, Transversor 3,
            EvenVersor 16, OddVersor 16, SimilarityGenerator 7, Quaternion 4, DualQuaternion 8, Even 16, Odd 16,
            Multivector 32
        } }
        #[cfg(feature = "cga2")]
        $callback! { cga2 {
            Point 2, RoundVector 4, DualLine 3, PointPair 6, FlatPoint 3, Direction 2, MotorGenerator 3, Circle 4,
            Line 3, Pseudoscalar 1, Rotor 2, Translator 2, Motor 4, Dilator 2, Similarity 6, Even 8, Multivector 16
        } }
        #[cfg(feature = "pga3")]
        $callback! { pga3 {
            Plane 4, Line 6, Point 4, Direction 3, Pseudoscalar 1, Rotor 4, Translator 3, Motor 8, MotorSum 8,
            Multivector 16
        } }
        #[cfg(feature = "pga2")]
        $callback! { pga2 {
            Line 3, Point 3, Pseudoscalar 1, Rotor 2, Translator 2, Motor 4, MotorSum 4, Multivector 8
        } }
        $callback! { vga3 {
            Vector 3, Bivector 3, Trivector 1, Rotor 4, Quaternion 4, Multivector 8
        } }
        #[cfg(feature = "vga2")]
        $callback! { vga2 {
            Vector 2, Bivector 1, Rotor 2, Complex 2, Multivector 4
        } }
        #[cfg(feature = "sta")]
        $callback! { sta {
            Vector 4, Bivector 6, Trivector 4, Pseudoscalar 1, Rotor 8, Even 8, Multivector 16
        } }
    };
}

pub(crate) use declared_types;
