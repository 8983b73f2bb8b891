//! The types of the algebras of ga-runtime that have coefficients. `bytemuck.rs` tests that none is
//! missing.

/// Passes the types, by algebra, to a macro.
macro_rules! every_type {
    ($callback:ident) => {
        $callback! {
            cga3 {
                Point, RoundVector, Bivector, Trivector, Quadvector, DualSphere, DualPlane, PointPair, DualCircle, FlatPoint, Direction,
                MotorGenerator, Circle, DualPointPair, DualFlatPoint, DualDirection, Line, Sphere, Plane,
                Pseudoscalar, Rotor, Translator, Motor, Dilator, Similarity, Transversor, EvenVersor, OddVersor,
                SimilarityGenerator, Quaternion, DualQuaternion, Even, Odd, Multivector
            },
            cga2 {
                Point, RoundVector, DualLine, PointPair, FlatPoint, Direction, MotorGenerator, Circle, Line,
                Pseudoscalar, Rotor, Translator, Motor, Dilator, Similarity, Even, Multivector
            },
            pga3 {
                Plane, Line, Point, Direction, Pseudoscalar, Rotor, Translator, Motor, MotorSum, Multivector
            },
            pga2 {
                Line, Point, Pseudoscalar, Rotor, Translator, Motor, MotorSum, Multivector
            },
            vga3 {
                Vector, Bivector, Trivector, Rotor, Quaternion, Multivector
            },
            vga2 {
                Vector, Bivector, Rotor, Complex, Multivector
            },
            sta {
                Vector, Bivector, Trivector, Pseudoscalar, Rotor, Even, Multivector
            }
        }
    };
}

pub(crate) use every_type;
