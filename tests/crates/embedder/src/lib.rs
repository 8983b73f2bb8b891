//! Uses ga-runtime as a crate outside the workspace would: as the only dependency, renamed, in
//! edition 2021.

use ga::cga3::{Motor, Point, Rotor, Translator};

ga::algebra! {
    /// The algebra of spacetime: one basis vector of square 1, three of square −1.
    pub mod sta {
        basis g0, g1, g2, g3;
        signature 1, 3;

        /// An event or a momentum.
        struct Vector { g0, g1, g2, g3 }
        /// The generator of a boost or a rotation, or the electromagnetic field.
        struct Bivector { g01, g02, g03, g12, g13, g23 }
        /// An element of even grade.
        struct Even { scalar, g01, g02, g03, g12, g13, g23, g0123 }
        /// A Lorentz transformation.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, g01, g02, g03, g12, g13, g23, g0123 }

        products {
            wedge(Vector, Vector);
            left_contraction(Vector, Vector) -> Scalar;
            left_contraction(Vector, Bivector) -> Vector;
            geometric(Vector, Vector) -> Even;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Even, Even) -> Even;
            sandwich(Rotor, {Vector, Bivector}) -> Self;
            dual(Bivector) -> Bivector;
        }
    }
}

/// Two modules may declare algebras of the same name, even with the same text.
pub mod first {
    ga::algebra! {
        /// The plane.
        pub mod plane {
            basis e1, e2;
            signature 2;
            /// A vector.
            struct Vector { e1, e2 }
            /// An area.
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }
}

/// The other of two algebras of the same name.
pub mod second {
    ga::algebra! {
        /// The plane.
        pub mod plane {
            basis e1, e2;
            signature 2;
            /// A vector.
            struct Vector { e1, e2 }
            /// An area.
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }
}

/// A declaration may state the path of the runtime.
pub mod with_a_path {
    pub use ga as engine;

    ga::algebra! {
        /// The complex numbers as the even subalgebra of the plane.
        pub mod complex {
            crate = crate::with_a_path::engine;
            basis e1, e2;
            signature 2;
            /// A complex number.
            struct Complex { scalar, e12 }
            products { geometric(Complex, Complex) -> Complex; }
        }
    }
}

/// A metric that is neither diagonal nor of whole numbers.
pub mod skew {
    ga::algebra! {
        /// An oblique basis: the vectors are not orthogonal, and their squares are fractions.
        pub mod oblique {
            basis a, b, c;
            metric a*a = 1, b*b = 1/2, c*c = -2, a*b = 1/3, b*c = -1, a*c = 1/4;
            /// A vector.
            struct Vector { a, b, c }
            /// A bivector, with blades in another order.
            struct Bivector { ba, ac, bc }
            /// A volume.
            struct Volume { abc }
            /// A general multivector.
            struct Multivector { scalar, a, b, c, ab, ac, bc, abc }
            products {
                wedge(Vector, {Vector, Bivector});
                left_contraction(Vector, Bivector) -> Vector;
                vee(Bivector, Bivector) -> Vector;
                geometric(Multivector, Multivector) -> Multivector;
                dual(Vector) -> Bivector;
                undual(Bivector) -> Vector;
                commutator(Bivector, Bivector) -> Bivector;
            }
        }
    }
}

/// An algebra may be declared where it is used: the area that two vectors span.
#[must_use]
pub fn area(a: [f64; 2], b: [f64; 2]) -> f64 {
    ga::algebra! {
        mod local {
            basis e1, e2;
            signature 2;
            /// A vector.
            struct Vector { e1, e2 }
            /// An area.
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }
    let [a, b] = [a, b].map(|[x, y]| local::Vector::new(x, y));
    (a ^ b).e12
}

/// The position of a point after a rotation by 90° about z and a translation along x.
#[must_use]
pub fn moved(point: [f64; 3]) -> [f64; 3] {
    let turn = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2);
    let motor: Motor<f64> =
        Translator::from_displacement([1.0, 0.0, 0.0]) * turn.unwrap_or_default();
    motor.transform(Point::from(point)).coordinates()
}

/// What every type of an algebra has, for one of this crate.
pub mod surface {
    #![deny(
        warnings,
        missing_docs,
        unused_qualifications,
        clippy::all,
        clippy::pedantic
    )]

    use crate::sta::{Bivector, Even, Rotor, Vector};

    /// At rest at the origin of time.
    pub const NOW: Vector<f64> = Vector::ZERO;

    /// The sum of momenta given as text; `None` where one is not a momentum.
    #[must_use]
    pub fn total<'a>(momenta: impl Iterator<Item = &'a str>) -> Option<Vector<f64>> {
        let momenta: Option<Vec<Vector<f64>>> = momenta.map(|text| text.parse().ok()).collect();
        momenta.map(|momenta| momenta.iter().sum())
    }

    /// One observer after another.
    #[must_use]
    pub fn composed(observers: &[Rotor<f64>]) -> Option<Rotor<f64>> {
        let mut product: Rotor<f64> = observers.iter().product();
        product *= &Rotor::IDENTITY;
        product.normalized()
    }

    /// The energy of a momentum, and the unit bivector of a field that is not null.
    #[must_use]
    pub fn read(momentum: &Vector<f64>, field: Bivector<f64>) -> Option<(f64, Bivector<f64>)> {
        let doubled = momentum + momentum;
        Some(((doubled / 2.0).coefficient_of("g0")?, field.normalized()?))
    }

    /// The boost of an even element, if it is one.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn boost(even: Even<f64>) -> Result<Rotor<f64>, ga::NotMember> {
        (even + 0.0).try_into()
    }
}

/// Functions compiled in an algebra of this crate.
pub mod functions {
    #![deny(
        warnings,
        missing_docs,
        unreachable_pub,
        missing_debug_implementations,
        clippy::all,
        clippy::pedantic
    )]

    ga::ga! { crate::sta;
        /// A momentum in the frame of another observer.
        pub fn observed(r: Rotor, p: Vector) -> Vector { reverse(r) * p * r }

        /// The boost of a rapidity along the first axis.
        #[must_use]
        pub fn boost(rapidity: Scalar) -> Rotor { exp(-rapidity / 2 * g01) }

        /// Many momenta in one frame.
        pub fn observing(uniform r: Rotor, p: Vector) -> Vector { observed(r, p) }
    }

    ga::ga! { ga::cga3;
        /// The power of a point with respect to a sphere through four others, up to the sphere's
        /// weight.
        #[must_use]
        pub fn power(p: Point, corners: [Point; 4]) -> Scalar {
            let [a, b, c, d] = corners;
            dual(a ^ b ^ c ^ d) | p
        }
    }

    ga::ga! { super::skew::oblique;
        /// A volume and its half.
        #[must_use]
        pub fn volumes(x: Vector, y: Vector, z: Vector) -> (Volume, Volume) {
            let volume = x ^ y ^ z;
            (volume, volume / 2)
        }
    }

    ga::ga! { crate::with_a_path::complex;
        /// A complex number times itself.
        #[must_use]
        pub fn square(z: Complex) -> Complex { z * z }
    }
}
