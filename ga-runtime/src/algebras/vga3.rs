//! Geometric algebra of space.

crate::algebra! {
    /// Geometric algebra of space: vectors, oriented areas and volumes, and the rotors and
    /// quaternions that rotate them.
    ///
    /// # Basis
    ///
    /// e1, e2, e3 span space, right-handed, `e1² = e2² = e3² = 1`. `I = e123`, `I² = −1`,
    /// `dual(a) = a I⁻¹ = −a I`, `undual(a) = a I`, `a ∨ b = undual(dual a ∧ dual b)`. The dual of
    /// a plane's bivector is its right-handed normal: `dual(e12) = e3`, `dual(e13) = −e2`,
    /// `dual(e23) = e1`, so that `a × b = dual(a ∧ b)`.
    ///
    /// # Types
    ///
    /// A rotor R acts as `x' = R x ~R`, and in a product the right factor acts first.
    ///
    /// | type | blades | grade | as geometry | as a transformation |
    /// | --- | --- | --- | --- | --- |
    /// | [`Vector`] | e1 e2 e3 | 1 | direction with length | reflection in the plane normal to it |
    /// | [`Bivector`] | e12 e13 e23 | 2 | oriented area | generator of a rotation |
    /// | [`Trivector`] | e123 | 3 | oriented volume | |
    /// | [`Rotor`] | scalar e12 e13 e23 | even | axis through the origin | rotation, `exp(−½θB)` |
    /// | [`Quaternion`] | scalar e12 e13 e23 | even | sums of rotors | rotation with scaling |
    /// | [`Multivector`] | all 8 | all | | |
    ///
    /// # Products
    ///
    /// `a * b` geometric, `a ^ b` wedge, `a | b` left contraction, `a & b` vee;
    /// [`Rotor::transform`] rotates.
    ///
    /// The quaternion `w + x i + y j + z k` of a rotation is the rotor `w − x e23 + y e13 − z e12`:
    /// `i = −e23`, `j = e13`, `k = −e12`, which satisfy `ij = k`, and `q v q*` rotates as `R x ~R`
    /// does.
    ///
    /// ```
    /// use ga_runtime::vga3::{Rotor, Vector};
    ///
    /// let (a, b) = (Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 2.0, 0.0));
    /// assert_eq!((a ^ b).dual(), Vector::new(0.0, 0.0, 2.0));
    /// assert_eq!(a.cross(b), (a ^ b).dual());
    ///
    /// let rotor: Rotor<f64> = Rotor::between(a, b).unwrap();
    /// let rotated = rotor.transform(a);
    /// assert!(rotated.e1.abs() < 1e-15 && (rotated.e2 - 1.0).abs() < 1e-15);
    /// ```
    pub mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        /// A vector of space.
        ///
        /// ```
        /// use ga_runtime::vga3::Vector;
        /// let (a, b) = (Vector::new(3.0, 0.0, 0.0), Vector::from([0.0, 4.0, 0.0]));
        /// assert_eq!((a.dot(b), a.cross(b)), (0.0, Vector::Z * 12.0));
        /// assert_eq!((a + b).length(), 5.0);
        /// assert_eq!(Vector::new(0.0, 3.0, 4.0).normalized(), Some(Vector::new(0.0, 0.6, 0.8)));
        /// assert_eq!(Vector::<f64>::ZERO.normalized(), None);
        /// ```
        struct Vector { e1, e2, e3 }
        /// An oriented area: the plane that two vectors span, with its size.
        ///
        /// ```
        /// use ga_runtime::vga3::{Bivector, Vector};
        /// let area: Bivector<f64> = Vector::X ^ Vector::Y * 2.0;
        /// assert_eq!(area, Bivector::new(2.0, 0.0, 0.0));
        /// assert_eq!((area.area(), area.normal()), (2.0, [0.0, 0.0, 2.0]));
        /// ```
        struct Bivector { e12, e13, e23 }
        /// An oriented volume, a multiple of I = e123.
        ///
        /// ```
        /// use ga_runtime::vga3::{Trivector, Vector};
        /// let volume = Vector::X ^ Vector::Y ^ Vector::Z * 2.0;
        /// assert_eq!(volume, Trivector::new(2.0));
        /// ```
        struct Trivector { e123 }
        /// A rotation about an axis through the origin: `R = exp(−½θB) = cos ½θ − sin ½θ B`.
        ///
        /// ```
        /// use ga_runtime::vga3::{Rotor, Vector};
        /// let quarter: Rotor<f64> = Rotor::between(Vector::X, Vector::Y).unwrap();
        /// assert!((quarter.transform(Vector::X) - Vector::Y).length() < 1e-15);
        /// ```
        #[hull(Quaternion)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }
        /// Sums and multiples of rotors: the quaternions.
        ///
        /// ```
        /// use ga_runtime::vga3::{Quaternion, Vector};
        /// // The product of two vectors has their inner product and their oriented area.
        /// assert_eq!(Vector::new(1, 2, 0) * Vector::new(3, 4, 0), Quaternion::new(11, -2, 0, 0));
        /// ```
        struct Quaternion { scalar, e12, e13, e23 }
        /// All 8 blades.
        ///
        /// ```
        /// use ga_runtime::vga3::{Multivector, Vector};
        /// let sum: Multivector<f64> = 1.0 + Multivector::from(Vector::new(2.0, 0.0, 0.0));
        /// assert_eq!(sum.to_string(), "1 + 2 e1");
        /// assert_eq!("1 + 2 e1".parse(), Ok(sum));
        /// ```
        struct Multivector { scalar, e1, e2, e3, e12, e13, e23, e123 }

        products {
            wedge(Vector, Vector) -> Bivector;
            wedge(Vector, Bivector) -> Trivector;
            wedge(Bivector, Vector) -> Trivector;
            vee(Bivector, Bivector) -> Vector;
            vee(Bivector, Vector) -> Scalar;
            vee(Vector, Bivector) -> Scalar;
            left_contraction(Vector, Vector) -> Scalar;
            left_contraction(Vector, Bivector) -> Vector;
            left_contraction(Vector, Trivector) -> Bivector;
            left_contraction(Bivector, Bivector) -> Scalar;
            left_contraction(Bivector, Trivector) -> Vector;
            left_contraction(Trivector, Trivector) -> Scalar;
            right_contraction(Bivector, Vector) -> Vector;
            dual(Vector) -> Bivector;
            undual(Vector) -> Bivector;
            dual(Bivector) -> Vector;
            undual(Bivector) -> Vector;
            dual(Trivector) -> Scalar;
            undual(Trivector) -> Scalar;
            geometric(Vector, Vector) -> Quaternion;
            geometric(Bivector, Bivector) -> Quaternion;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Quaternion, Quaternion) -> Quaternion;
            geometric(Multivector, Multivector) -> Multivector;
            commutator(Bivector, Bivector) -> Bivector;
            sandwich(Rotor, {Vector, Bivector, Rotor}) -> Self;
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
