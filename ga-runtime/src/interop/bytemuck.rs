//! bytemuck 1: slices of elements as bytes, for buffers of a graphics card and for files.
//!
//! The bytes of a type with facts, such as a unit versor, are taken as they come, as `new_unchecked` takes its arguments.
//!
//! ```
//! use ga_runtime::cga3::Point;
//! let points = [Point::new(1.0_f32, 2.0, 3.0), Point::new(4.0, 5.0, 6.0)];
//! assert_eq!(bytemuck::cast_slice::<_, f32>(&points), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
//! ```
//!
//! bytemuck has these traits as `unsafe` only, and its derive writes the same and refuses generic structs of several fields; so
//! this module allows `unsafe` for the impls alone, with the argument at each.
#![allow(unsafe_code)]

use bytemuck::{Pod, Zeroable};

macro_rules! plain {
    ($algebra:ident: $($kind:ident)*) => { $(
        // SAFETY: the struct is `repr(C)` with fields of the type `S` alone, and zero bytes are an `S`.
        unsafe impl<S: Zeroable> Zeroable for crate::$algebra::$kind<S> {}
        // SAFETY: as above; fields of one type leave no padding, any bytes are an `S`, and no field has interior mutability
        // or a pointer since `S` has none. Facts of the type are promises about numbers: memory does not depend on them.
        unsafe impl<S: Pod> Pod for crate::$algebra::$kind<S> {}
    )* };
}

plain! { cga3:
    Point RoundVector DualPlane PointPair FlatPoint Direction MotorGenerator Circle Line Sphere Plane Pseudoscalar
    Rotor Translator Motor Dilator Similarity Quaternion DualQuaternion Even Multivector
}
plain! { pga3: Plane Line Point Pseudoscalar Rotor Translator Motor MotorSum Multivector }
