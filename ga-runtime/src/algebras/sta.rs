//! Spacetime algebra.

crate::algebra! {
    /// Spacetime algebra: events and momenta as vectors, electromagnetic fields as bivectors,
    /// Lorentz transformations as rotors.
    ///
    /// # Basis
    ///
    /// g0 is the time axis of an observer and g1, g2, g3 are right-handed spatial axes: `g0² = 1`,
    /// `g1² = g2² = g3² = −1`, the signature (+ − − −) of Hestenes (Space-Time Algebra, 1966) and
    /// of Doran & Lasenby (Geometric Algebra for Physicists, 2003). The speed of light is 1, so
    /// that speeds are numbers below 1.
    ///
    /// `I = g0∧g1∧g2∧g3`, `I² = −1`, `dual(a) = a I⁻¹ = −a I`, `undual(a) = a I`,
    /// `a ∨ b = undual(dual a ∧ dual b)`. I commutes with even elements and anticommutes with odd
    /// ones.
    ///
    /// # Relative vectors
    ///
    /// The bivectors `σk = gk g0` are the observer's spatial vectors: `σk² = 1`, `σ1σ2σ3 = I`. The
    /// other three are `Iσ1 = g32`, `Iσ2 = g13`, `Iσ3 = g21`. So a field is `F = E + I B`, its
    /// coefficients g10 g20 g30 being E and g32 g13 g21 being B.
    ///
    /// # Types
    ///
    /// A rotor R acts as `x' = R x ~R`, an active transformation, and in a product the right factor
    /// acts first.
    ///
    /// | type | blades | grade | as geometry | as a transformation |
    /// | --- | --- | --- | --- | --- |
    /// | [`Vector`] | g0 g1 g2 g3 | 1 | event `t g0 + x`, velocity, momentum | reflection |
    /// | [`Bivector`] | g10 g20 g30, g32 g13 g21 | 2 | field `E + I B` | generator of a rotor |
    /// | [`Trivector`] | g123 g023 g013 g012 | 3 | hyperplane | |
    /// | [`Pseudoscalar`] | g0123 | 4 | volume of spacetime | |
    /// | [`Rotor`] | all eight of even grade | even | | boost `exp(½φσ)`, rotation `exp(−½θ Iσ)` |
    /// | [`Even`] | all eight of even grade | even | Dirac–Hestenes spinor | |
    /// | [`Multivector`] | all 16 | all | | |
    ///
    /// # Products
    ///
    /// `a * b` geometric, `a ^ b` wedge, `a | b` left contraction, `a & b` vee. `x | x` is the
    /// squared interval: positive for timelike, negative for spacelike vectors.
    ///
    /// ```
    /// use ga_runtime::sta::{Bivector, Rotor, Vector};
    ///
    /// // A clock moving with 3/5 of the speed of light along g1: γ = 5/4.
    /// let boost: Rotor<f64> = Rotor::from_velocity([0.6, 0.0, 0.0]).unwrap();
    /// let clock = boost.transform(Vector::new(1.0, 0.0, 0.0, 0.0));
    /// assert!((clock.g0 - 1.25).abs() < 1e-15 && (clock.g1 - 0.75).abs() < 1e-15);
    /// assert!(((clock | clock) - 1.0).abs() < 1e-15);
    ///
    /// // The force of a field F on a unit charge with proper velocity u is F·u, the commutator.
    /// // For a charge at rest it is E.
    /// let field = Bivector::from_fields([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]);
    /// let force = field.commutator(Vector::new(1.0, 0.0, 0.0, 0.0));
    /// assert_eq!(force, Vector::new(0.0, 1.0, 2.0, 3.0));
    /// ```
    pub mod sta {
        basis g0, g1, g2, g3;
        metric g0*g0 = 1, g1*g1 = -1, g2*g2 = -1, g3*g3 = -1;

        /// A vector of spacetime: the event `t g0 + x g1 + y g2 + z g3`, a velocity, a momentum.
        ///
        /// ```
        /// use ga_runtime::sta::Vector;
        /// let (time, space) = (Vector::new(2.0, 0.0, 0.0, 0.0), Vector::new(0.0, 3.0, 0.0, 0.0));
        /// // The norm is positive for timelike vectors and negative for spacelike ones.
        /// assert_eq!((time.norm_squared(), space.norm_squared()), (4.0, -9.0));
        /// assert_eq!(space.normalized(), Some(Vector::G1));
        /// ```
        struct Vector { g0, g1, g2, g3 }
        /// A bivector: the field `E + I B` with E in g10 g20 g30 and B in g32 g13 g21; a generator
        /// of boosts and rotations.
        ///
        /// ```
        /// use ga_runtime::sta::Bivector;
        /// // The norm is −E² + B² of an electromagnetic field.
        /// let field = Bivector::from_fields([1.0, 2.0, 3.0], [0.0, 0.0, 4.0]);
        /// assert_eq!(field.norm_squared(), 2.0);
        /// ```
        struct Bivector { g10, g20, g30, g32, g13, g21 }
        /// A trivector: an oriented volume in a hyperplane.
        struct Trivector { g123, g023, g013, g012 }
        /// A multiple of I = g0∧g1∧g2∧g3.
        struct Pseudoscalar { g0123 }
        /// A proper orthochronous Lorentz transformation, boosts and rotations in any order.
        ///
        /// ```
        /// use ga_runtime::sta::{Rotor, Vector};
        /// let boost: Rotor<f64> = Rotor::from_velocity([0.6, 0.0, 0.0]).unwrap();
        /// assert!((boost.transform(Vector::G0).g0 - 1.25).abs() < 1e-15);
        /// ```
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, g10, g20, g30, g32, g13, g21, g0123 }
        /// All blades of even grade: sums and multiples of rotors.
        struct Even { scalar, g10, g20, g30, g32, g13, g21, g0123 }
        /// All 16 blades.
        struct Multivector {
            scalar,
            g0, g1, g2, g3,
            g10, g20, g30, g32, g13, g21,
            g123, g023, g013, g012,
            g0123
        }

        products {
            wedge(Vector, Vector) -> Bivector;
            wedge(Vector, Bivector) -> Trivector;
            wedge(Bivector, Vector) -> Trivector;
            wedge(Bivector, Bivector) -> Pseudoscalar;
            wedge(Vector, Trivector) -> Pseudoscalar;
            wedge(Trivector, Vector) -> Pseudoscalar;
            vee(Trivector, Trivector) -> Bivector;
            vee(Trivector, Bivector) -> Vector;
            vee(Bivector, Trivector) -> Vector;
            left_contraction(Vector, Vector) -> Scalar;
            left_contraction(Vector, Bivector) -> Vector;
            left_contraction(Vector, Trivector) -> Bivector;
            left_contraction(Vector, Pseudoscalar) -> Trivector;
            left_contraction(Bivector, Bivector) -> Scalar;
            left_contraction(Bivector, Trivector) -> Vector;
            left_contraction(Trivector, Trivector) -> Scalar;
            right_contraction(Bivector, Vector) -> Vector;
            dual(Vector) -> Trivector;
            undual(Vector) -> Trivector;
            dual(Bivector) -> Bivector;
            undual(Bivector) -> Bivector;
            dual(Trivector) -> Vector;
            undual(Trivector) -> Vector;
            dual(Pseudoscalar) -> Scalar;
            undual(Pseudoscalar) -> Scalar;
            geometric(Vector, Vector) -> Even;
            geometric(Bivector, Bivector) -> Even;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Even, Even) -> Even;
            geometric(Multivector, Multivector) -> Multivector;
            commutator(Bivector, Bivector) -> Bivector;
            commutator(Bivector, Vector) -> Vector;
            sandwich(Rotor, {Vector, Bivector, Trivector, Rotor}) -> Self;
            sandwich(Vector, {Vector, Bivector}) -> Self;
            wedge(Multivector, Multivector) -> Multivector;
            vee(Multivector, Multivector) -> Multivector;
            left_contraction(Multivector, Multivector) -> Multivector;
            right_contraction(Multivector, Multivector) -> Multivector;
            scalar_product(Multivector, Multivector) -> Scalar;
            commutator(Multivector, Multivector) -> Multivector;
            dual(Multivector) -> Multivector;
            undual(Multivector) -> Multivector;
        }
    }
}
