//! Geometric algebra of the plane.

crate::algebra! {
    /// Geometric algebra of the plane: vectors, oriented areas, and the complex numbers that rotate
    /// them.
    ///
    /// # Basis
    ///
    /// e1, e2 span the plane, `e1² = e2² = 1`. `I = e12`, `I² = −1`, `dual(a) = a I⁻¹ = −a I`,
    /// `undual(a) = a I`: `undual` rotates a vector by 90° from e1 towards e2, `dual` back.
    /// `a ∨ b = undual(dual a ∧ dual b)`.
    ///
    /// # Types
    ///
    /// A rotor R acts as `x' = R x ~R`, and in a product the right factor acts first.
    ///
    /// | type | blades | grade | as geometry | as a transformation |
    /// | --- | --- | --- | --- | --- |
    /// | [`Vector`] | e1 e2 | 1 | direction with length | reflection |
    /// | [`Bivector`] | e12 | 2 | oriented area | generator of a rotation |
    /// | [`Rotor`] | scalar e12 | even | | rotation by θ, `exp(−½θ e12)` |
    /// | [`Complex`] | scalar e12 | even | complex number `re + im e12` | rotation with scaling |
    /// | [`Multivector`] | all 4 | all | | |
    ///
    /// # Products
    ///
    /// `a * b` geometric, `a ^ b` wedge, `a | b` left contraction; [`Rotor::transform`] rotates.
    /// The rotor of a rotation by θ contains *half* the angle, with the minus sign of `−½θ`; as a
    /// complex number the rotation is `cos θ + sin θ e12`, see [`Rotor::to_complex`].
    ///
    /// ```
    /// use ga_runtime::vga2::{Bivector, Complex, Rotor, Vector};
    ///
    /// let (a, b) = (Vector::new(3.0, 0.0), Vector::new(1.0, 2.0));
    /// assert_eq!(a | b, 3.0);
    /// assert_eq!(a ^ b, Bivector::new(6.0));
    /// // Both in one product: the complex number that takes a to b, times |a|².
    /// assert_eq!(a * b, Complex::new(3.0, 6.0));
    ///
    /// let quarter = Rotor::from_angle(std::f64::consts::FRAC_PI_2).unwrap();
    /// let rotated = quarter.transform(a);
    /// assert!(rotated.e1.abs() < 1e-15 && (rotated.e2 - 3.0).abs() < 1e-15);
    /// ```
    pub mod vga2 {
        basis e1, e2;
        signature 2, 0, 0;

        /// A vector of the plane.
        ///
        /// ```
        /// use ga_runtime::vga2::{Bivector, Vector};
        /// let (a, b) = (Vector::new(3.0, 0.0), Vector::new(1.0, 4.0));
        /// assert_eq!((a | b, a ^ b), (3.0, Bivector::new(12.0)));
        /// assert_eq!(a.normalized(), Some(Vector::E1));
        /// ```
        struct Vector { e1, e2 }
        /// An oriented area: positive from e1 towards e2.
        struct Bivector { e12 }
        /// A rotation about the origin: `R = exp(−½θ e12) = cos ½θ − sin ½θ e12`.
        ///
        /// ```
        /// use ga_runtime::vga2::{Rotor, Vector};
        /// let quarter: Rotor<f64> = Rotor::from_angle(std::f64::consts::FRAC_PI_2).unwrap();
        /// assert!((quarter.transform(Vector::E1) - Vector::E2).length() < 1e-15);
        /// ```
        #[hull(Complex)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12 }
        /// The complex number `re + im e12`; `e12² = −1`. Sums and multiples of rotors are such
        /// numbers.
        ///
        /// ```
        /// use ga_runtime::vga2::Complex;
        /// let i = Complex::new(0.0, 1.0);
        /// assert_eq!((1.0 + 2.0 * i) * i, -2.0 + i);
        /// ```
        struct Complex { scalar, e12 }
        /// All 4 blades.
        struct Multivector { scalar, e1, e2, e12 }

        products {
            wedge(Vector, Vector) -> Bivector;
            left_contraction(Vector, Vector) -> Scalar;
            left_contraction(Vector, Bivector) -> Vector;
            left_contraction(Bivector, Bivector) -> Scalar;
            right_contraction(Bivector, Vector) -> Vector;
            vee(Vector, Vector) -> Scalar;
            dual(Vector) -> Vector;
            undual(Vector) -> Vector;
            dual(Bivector) -> Scalar;
            undual(Bivector) -> Scalar;
            geometric(Vector, Vector) -> Complex;
            geometric({Rotor, Complex}, Vector) -> Vector;
            geometric(Vector, {Rotor, Complex}) -> Vector;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Complex, Complex) -> Complex;
            geometric(Multivector, Multivector) -> Multivector;
            sandwich({Rotor, Vector}, Vector) -> Self;
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
