//! Projective geometric algebra of space.

crate::algebra! {
    /// Projective geometric algebra of space: planes as vectors, lines and points as their meets,
    /// motions as versors.
    ///
    /// # Basis
    ///
    /// `e1² = e2² = e3² = 1`, `e0² = 0`. The metric is degenerate, so `I = e1∧e2∧e3∧e0` has no
    /// inverse: `dual` is the right complement (`a ∧ dual a = I` for basis blades), `undual` its
    /// inverse, and `a ∨ b = undual(dual a ∧ dual b)`.
    ///
    /// # Types
    ///
    /// A motor M acts as `x' = M x ~M`, and in a product the right factor acts first.
    ///
    /// | type | blades | grade | as geometry | as a transformation |
    /// | --- | --- | --- | --- | --- |
    /// | [`Plane`] | e1 e2 e3 e0 | 1 | `n·x + d = 0` as `n + d e0` | reflection |
    /// | [`Line`] | e12 e13 e23, e10 e20 e30 | 2 | meet of two planes | generator of a screw |
    /// | [`Point`] | e123, e120 e130 e230 | 3 | meet of three planes | |
    /// | [`Direction`] | e120 e130 e230 | 3 | free vector, ideal point | |
    /// | [`Pseudoscalar`] | e1230 | 4 | all of space | |
    /// | [`Rotor`] | scalar e12 e13 e23 | even | axis through the origin | rotation, `exp(−½θB)` |
    /// | [`Translator`] | scalar = 1, e10 e20 e30 | even | | translation by t, `1 + ½ t e0` |
    /// | [`Motor`] | scalar, all bivectors, e1230 | even | screw axis | rigid motion `T R` |
    /// | [`MotorSum`] | those of Motor | even | sums of motors | |
    /// | [`Multivector`] | all 16 | all | | |
    ///
    /// `^` is the meet of planes, `&` the join of points.
    ///
    /// # Signs
    ///
    /// A line with direction d and moment `m = p × d` is `d1 e23 − d2 e13 + d3 e12 − m∧e0`. `Π ∧ Ρ`
    /// has the direction of the cross product of the normals, `P ∨ Q` that of `P − Q`, and
    /// `P ∨ Q ∨ R` the normal `(Q − P) × (R − P)`. So `exp(−½θL)` rotates right-handed about the
    /// direction of L, and [`Line::through`] returns a line directed from its first point to its
    /// second.
    ///
    /// klein and ganja.js write the same elements over other blades: their e01 is −e10, their e31
    /// is −e13, and their points `e123 + x e032 + y e013 + z e021` are equal to those here, since
    /// `e032 = −e230`, `e013 = e130`, `e021 = −e120`. Translators are
    /// `1 − ½ (t1 e01 + t2 e02 + t3 e03)` in both. ganja's examples rotate by
    /// `cos ½θ + sin ½θ (P ∨ Q)`; that is right-handed about `Q − P`, the same as here. Versions of
    /// klein differ in the sign of the sine in the rotor made from an axis; to find the sign of a
    /// version, rotate a point.
    ///
    /// ```
    /// use ga_runtime::pga3::Plane;
    /// // The planes x = 1, y = 2, z = 3 meet in the point (1, 2, 3).
    /// let (x, y, z) = (
    ///     Plane::new(1.0, 0.0, 0.0, -1.0),
    ///     Plane::new(0.0, 1.0, 0.0, -2.0),
    ///     Plane::new(0.0, 0.0, 1.0, -3.0),
    /// );
    /// let point = x ^ y ^ z;
    /// assert_eq!([-point.e230, point.e130, -point.e120], [1.0, 2.0, 3.0]);
    /// assert_eq!(point.e123, 1.0);
    /// ```
    pub mod pga3 {
        basis e1, e2, e3, e0;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1;

        /// The plane of the points with `n·x + d = 0`, as `n + d e0`.
        ///
        /// ```
        /// use ga_runtime::pga3::{Plane, Point};
        /// let plane = Plane::from_normal_distance([0.0, 0.0, 1.0], 2.0);
        /// assert_eq!(plane.signed_distance(Point::from([1.0, 1.0, 5.0])), Some(3.0));
        /// ```
        struct Plane { e1, e2, e3, e0 }
        /// The meet of two planes. A bivector with `L∧L` not zero is not a meet; it generates a
        /// screw.
        ///
        /// ```
        /// use ga_runtime::pga3::{Line, Plane};
        /// let line: Line<f64> = Plane::new(1.0, 0.0, 0.0, -1.0) ^ Plane::new(0.0, 1.0, 0.0, -2.0);
        /// assert_eq!(line.direction(), [0.0, 0.0, 1.0]);
        /// ```
        struct Line { e12, e13, e23, e10, e20, e30 }
        /// The meet of three planes; the point (x, y, z) is `e123 − x e230 + y e130 − z e120`.
        ///
        /// ```
        /// use ga_runtime::pga3::Point;
        /// let point = Point::from([1.0, 2.0, 3.0]);
        /// assert_eq!((point * 2.0).coordinates(), Some([1.0, 2.0, 3.0]));
        /// assert_eq!(Point::from([0.0; 3]), Point::ORIGIN);
        /// ```
        struct Point { e123, e120, e130, e230 }
        /// A free vector v, the ideal point `−v1 e230 + v2 e130 − v3 e120`. Motions rotate it and
        /// do not translate it.
        struct Direction { e120, e130, e230 }
        /// A multiple of I = e1∧e2∧e3∧e0.
        struct Pseudoscalar { e1230 }
        /// A rotation about an axis through the origin: `R = exp(−½θB) = cos ½θ − sin ½θ B`.
        #[hull(MotorSum)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }
        /// A translation by t: `T = 1 + ½ t e0`.
        #[hull(MotorSum)]
        #[facts(unit_versor)]
        struct Translator { scalar = 1, e10, e20, e30 }
        /// A rigid motion, with `M ~M = 1` in every grade.
        ///
        /// ```
        /// use ga_runtime::pga3::{Motor, Point, Rotor, Translator};
        /// let half = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::PI).unwrap();
        /// let motor: Motor<f64> = Translator::from_displacement([5.0, 0.0, 0.0]) * half;
        /// let [x, y, z] = motor.transform(Point::from([1.0, 0.0, 0.0])).coordinates().unwrap();
        /// assert!((x - 4.0).abs() < 1e-15 && y.abs() < 1e-15 && z == 0.0);
        /// ```
        #[hull(MotorSum)]
        #[facts(unit_versor)]
        struct Motor { scalar, e12, e13, e23, e10, e20, e30, e1230 }
        /// Sums and multiples of motors.
        struct MotorSum { scalar, e12, e13, e23, e10, e20, e30, e1230 }
        /// All 16 blades.
        struct Multivector {
            scalar, e1, e2, e3, e0, e12, e13, e23, e10, e20, e30, e123, e120, e130, e230, e1230
        }

        products {
            wedge(Plane, Plane) -> Line;
            wedge(Plane, Line) -> Point;
            wedge(Line, Plane) -> Point;
            wedge(Plane, Point) -> Pseudoscalar;
            wedge(Line, Line) -> Pseudoscalar;
            vee(Point, Point) -> Line;
            vee(Point, Direction) -> Line;
            vee(Direction, Point) -> Line;
            vee(Point, Line) -> Plane;
            vee(Line, Point) -> Plane;
            vee(Line, Line) -> Scalar;
            vee(Plane, Point) -> Scalar;
            left_contraction(Plane, Plane) -> Scalar;
            left_contraction(Line, Line) -> Scalar;
            left_contraction(Plane, Line) -> Plane;
            left_contraction(Plane, Point) -> Line;
            left_contraction(Line, Point) -> Plane;
            dual(Plane) -> Point;
            undual(Point) -> Plane;
            dual(Line) -> Line;
            undual(Line) -> Line;
            dual(Point) -> Plane;
            undual(Plane) -> Point;
            geometric(Plane, Plane) -> MotorSum;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Translator, Translator) -> Translator;
            geometric(Translator, Rotor) -> Motor;
            geometric(Rotor, Translator) -> Motor;
            geometric(Motor, {Motor, Rotor, Translator}) -> Motor;
            geometric({Rotor, Translator}, Motor) -> Motor;
            geometric(MotorSum, MotorSum) -> MotorSum;
            geometric(Multivector, Multivector) -> Multivector;
            commutator(Line, Line) -> Line;
            sandwich({Rotor, Translator, Motor}, {Plane, Line, Point, Direction, Motor}) -> Self;
            sandwich(Plane, {Plane, Line, Point, Direction}) -> Self;
            wedge(Multivector, Multivector) -> Multivector;
            vee(Multivector, Multivector) -> Multivector;
            right_contraction(Multivector, Multivector) -> Multivector;
            scalar_product(Multivector, Multivector) -> Scalar;
        }
    }
}
