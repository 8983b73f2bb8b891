//! Projective geometric algebra of the plane.

crate::algebra! {
    /// Projective geometric algebra of the plane: lines as vectors, points as their meets, motions
    /// as versors.
    ///
    /// # Basis
    ///
    /// `e1² = e2² = 1`, `e0² = 0`. The metric is degenerate, so `I = e1∧e2∧e0` has no inverse:
    /// `dual` is the right complement (`a ∧ dual a = I` for basis blades), `undual` its inverse,
    /// and `a ∨ b = undual(dual a ∧ dual b)`.
    ///
    /// # Types
    ///
    /// A motor M acts as `x' = M x ~M`, and in a product the right factor acts first.
    ///
    /// | type | blades | grade | as geometry | as a transformation |
    /// | --- | --- | --- | --- | --- |
    /// | [`Line`] | e1 e2 e0 | 1 | `n·x + d = 0` as `n + d e0` | reflection |
    /// | [`Point`] | e12 e20 e01 | 2 | point, ideal where e12 = 0 | generator of a rotation |
    /// | [`Pseudoscalar`] | e120 | 3 | all of the plane | |
    /// | [`Rotor`] | scalar e12 | even | | rotation about the origin |
    /// | [`Translator`] | scalar = 1, e20 e01 | even | | translation by t, `1 + ½ t e0` |
    /// | [`Motor`] | scalar e12 e20 e01 | even | | rigid motion |
    /// | [`MotorSum`] | those of Motor | even | sums and multiples of motors | |
    /// | [`Multivector`] | all 8 | all | | |
    ///
    /// `^` is the meet of lines, `&` the join of points. The point (x, y) is `e12 + x e20 + y e01`,
    /// with the signs of ganja.js. The rotation by θ about a point P of weight 1 is `exp(−½θP)`,
    /// positive from e1 towards e2.
    ///
    /// ```
    /// use ga_runtime::pga2::{Line, Point};
    ///
    /// // The lines x = 1 and y = 2 meet in the point (1, 2).
    /// let meet = Line::new(1.0, 0.0, -1.0) ^ Line::new(0.0, 1.0, -2.0);
    /// assert_eq!(meet, Point::from_coordinates([1.0, 2.0]));
    /// // The join of two points is the line through both.
    /// let join = meet & Point::from_coordinates([4.0, 2.0]);
    /// assert_eq!(join ^ meet, Default::default());
    /// assert_eq!(join.signed_distance(Point::from_coordinates([1.0, 5.0])), Some(3.0));
    /// ```
    pub mod pga2 {
        basis e1, e2, e0;
        metric e1*e1 = 1, e2*e2 = 1;

        /// The line of the points with `n·x + d = 0`, as `n + d e0`.
        ///
        /// ```
        /// use ga_runtime::pga2::{Line, Point};
        /// // The line y = 2.
        /// let line = Line::new(0.0, 1.0, -2.0);
        /// assert_eq!(line.signed_distance(Point::from_coordinates([1.0, 5.0])), Some(3.0));
        /// ```
        struct Line { e1, e2, e0 }
        /// The meet of two lines. The point (x, y) is `e12 + x e20 + y e01`; with zero for e12 it
        /// is a direction.
        ///
        /// ```
        /// use ga_runtime::pga2::Point;
        /// let point = Point::from_coordinates([1.0, 2.0]);
        /// assert_eq!((point * 2.0).coordinates(), Some([1.0, 2.0]));
        /// ```
        struct Point { e12, e20, e01 }
        /// A multiple of I = e1∧e2∧e0.
        struct Pseudoscalar { e120 }
        /// A rotation about the origin: `R = exp(−½θ e12) = cos ½θ − sin ½θ e12`.
        #[hull(MotorSum)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12 }
        /// A translation by t: `T = 1 + ½ t e0`.
        #[hull(MotorSum)]
        #[facts(unit_versor)]
        struct Translator { scalar = 1, e20, e01 }
        /// A rigid motion of the plane: `M = T R`.
        #[hull(MotorSum)]
        #[facts(unit_versor)]
        struct Motor { scalar, e12, e20, e01 }
        /// Sums and multiples of motors.
        struct MotorSum { scalar, e12, e20, e01 }
        /// All 8 blades.
        struct Multivector { scalar, e1, e2, e0, e12, e20, e01, e120 }

        products {
            wedge(Line, Line) -> Point;
            wedge(Line, Point) -> Pseudoscalar;
            wedge(Point, Line) -> Pseudoscalar;
            vee(Point, Point) -> Line;
            vee(Point, Line) -> Scalar;
            vee(Line, Point) -> Scalar;
            left_contraction(Line, Line) -> Scalar;
            left_contraction(Line, Point) -> Line;
            left_contraction(Point, Point) -> Scalar;
            dual(Line) -> Point;
            undual(Line) -> Point;
            dual(Point) -> Line;
            undual(Point) -> Line;
            geometric(Line, Line) -> MotorSum;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Translator, Translator) -> Translator;
            geometric(Translator, Rotor) -> Motor;
            geometric(Rotor, Translator) -> Motor;
            geometric(Motor, {Motor, Rotor, Translator}) -> Motor;
            geometric({Rotor, Translator}, Motor) -> Motor;
            geometric(MotorSum, MotorSum) -> MotorSum;
            geometric(Multivector, Multivector) -> Multivector;
            commutator(Point, Point) -> Point;
            sandwich({Rotor, Translator, Motor}, {Line, Point, Motor}) -> Self;
            sandwich(Line, {Line, Point}) -> Self;
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
