//! Conformal geometric algebra of the plane.

crate::algebra! {
    /// Conformal geometric algebra of the plane: points, circles and lines as blades, motions and
    /// scalings as versors.
    ///
    /// # Basis
    ///
    /// e1, e2 span the plane; eo stands for the origin and ei for infinity. `e1² = e2² = 1`,
    /// `eo² = ei² = 0`, `eo·ei = −1`, as in [`cga3`](crate::cga3) without e3. `I = e1∧e2∧eo∧ei`,
    /// `I² = −1`, `dual(a) = a I⁻¹ = −a I`, `undual(a) = a I`, `a ∨ b = undual(dual a ∧ dual b)`.
    ///
    /// # Types
    ///
    /// An object X in *direct* form consists of the points x with `x ∧ X = 0`; in *dual* form of
    /// those with `x·X = 0`. An even versor M acts as `x' = M x ~M`, and in a product the right
    /// factor acts first.
    ///
    /// | type | blades | grade | as geometry | as a transformation |
    /// | --- | --- | --- | --- | --- |
    /// | [`Point`] | e1 e2, eo = 1, ei = ½x² | 1 | the point x | |
    /// | [`RoundVector`] | e1 e2 eo ei | 1 | dual circle `c − ½r² ei`, weighted point | inversion |
    /// | [`DualLine`] | e1 e2 ei | 1 | dual line `n + d ei` | reflection |
    /// | [`PointPair`] | all six of two vectors | 2 | two points `p∧q` | |
    /// | [`FlatPoint`] | e1i e2i eoi | 2 | point and infinity `p∧ei` | |
    /// | [`Direction`] | e1i e2i | 2 | free vector `v∧ei` | |
    /// | [`MotorGenerator`] | e12 e1i e2i | 2 | dual flat point | log of a motor, velocity |
    /// | [`Circle`] | e12o e12i e1oi e2oi | 3 | circle `p∧q∧r` | |
    /// | [`Line`] | e12i e1oi e2oi | 3 | line `p∧q∧ei` | |
    /// | [`Pseudoscalar`] | e12oi | 4 | all of the plane | |
    /// | [`Rotor`] | scalar e12 | even | | rotation about the origin, `exp(−½θ e12)` |
    /// | [`Translator`] | scalar = 1, e1i e2i | even | | translation by t, `1 − ½ t ei` |
    /// | [`Motor`] | scalar e12 e1i e2i | even | | rigid motion `T R` |
    /// | [`Dilator`] | scalar eoi | even | | scaling about the origin |
    /// | [`Similarity`] | Motor and eoi e12oi | even | | motion and scaling |
    /// | [`Even`] | all eight of even grade | even | sums of versors | |
    /// | [`Multivector`] | all 16 | all | | |
    ///
    /// ```
    /// use ga_runtime::cga2::{Circle, Point};
    ///
    /// let [p, q, r] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]].map(Point::from);
    /// let circle: Circle<f64> = p ^ q ^ r;
    /// assert_eq!(circle.centre().unwrap().coordinates(), [0.0, 0.0]);
    /// assert_eq!(circle.radius(), Some(1.0));
    /// // The inner product of two points is −½ times their squared distance.
    /// assert_eq!(p | r, -2.0);
    /// ```
    pub mod cga2 {
        basis e1, e2, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, eo*ei = -1;

        /// The basis vector eo, the point at the origin.
        struct Origin { eo = 1 }
        /// The basis vector ei, the point at infinity.
        struct Infinity { ei = 1 }

        /// The point x. It stores two numbers, and every product takes it as the whole conformal
        /// vector `x + eo + ½x² ei`.
        ///
        /// Its weight, the coefficient of eo, is 1, and it is null: `P² = 0`. Sums of points are
        /// [`RoundVector`]s.
        ///
        /// ```
        /// use ga_runtime::cga2::Point;
        /// let (p, q) = (Point::new(1.0, 1.0), Point::from([1.0, 6.0]));
        /// assert_eq!((p.distance(q), p | q), (5.0, -12.5));
        /// ```
        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, eo = 1, ei = (e1*e1 + e2*e2)/2 }

        /// A vector of the algebra: a dual circle `c − ½r² ei` about the point c, a dual line, a
        /// weighted point.
        struct RoundVector { e1, e2, eo, ei }

        /// The dual line `n + d ei`: the points x with `n·x = d`, where n is the normal.
        struct DualLine { e1, e2, ei }

        /// Two points, `p∧q`; they are real, coinciding or imaginary if its square is positive,
        /// zero or negative.
        ///
        /// ```
        /// use ga_runtime::cga2::{Point, PointPair};
        /// let pair: PointPair<f64> = Point::new(1.0, 0.0) ^ Point::new(3.0, 0.0);
        /// // The norm is minus the square: negative for a real pair.
        /// assert_eq!(pair.norm_squared(), -4.0);
        /// ```
        struct PointPair { e12, e1o, e2o, e1i, e2i, eoi }

        /// A point and infinity, `p∧ei`: the meet of two lines.
        struct FlatPoint { e1i, e2i, eoi }

        /// A free vector, `v∧ei`. Motions rotate it and do not translate it.
        struct Direction { e1i, e2i }

        /// The generator of a rigid motion: `−½θ e12` for a rotation by θ about the origin,
        /// `−½ t ei` for a translation by t.
        struct MotorGenerator { e12, e1i, e2i }

        /// A circle, `p∧q∧r` for three of its points; a line where one of them is infinity.
        ///
        /// ```
        /// use ga_runtime::cga2::{Circle, Point};
        /// let (p, q, r) = (Point::new(1.0, 0.0), Point::new(0.0, 1.0), Point::new(-1.0, 0.0));
        /// let circle: Circle<f64> = p ^ q ^ r;
        /// assert_eq!(circle.centre(), Some(Point::new(0.0, 0.0)));
        /// // The norm is negative for a real circle.
        /// assert!(circle.norm_squared() < 0.0);
        /// ```
        struct Circle { e12o, e12i, e1oi, e2oi }

        /// A line, `p∧q∧ei` for two of its points: direction `q − p` in minus the coefficients of
        /// e1oi, e2oi, moment `p∧q` in that of e12i.
        ///
        /// ```
        /// use ga_runtime::cga2::{Infinity, Line, Point};
        /// let line: Line<f64> = Point::new(0.0, 2.0) ^ Point::new(1.0, 2.0) ^ Infinity;
        /// assert_eq!(line.direction(), [1.0, 0.0]);
        /// assert_eq!(line.signed_distance(Point::new(5.0, 3.0)), Some(1.0));
        /// ```
        struct Line { e12i, e1oi, e2oi }

        /// A multiple of I = e1∧e2∧eo∧ei.
        struct Pseudoscalar { e12oi }

        /// A rotation about the origin: `R = exp(−½θ e12) = cos ½θ − sin ½θ e12`.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12 }

        /// A translation by t: `T = 1 − ½ t ei`.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Translator { scalar = 1, e1i, e2i }

        /// A rigid motion: `M = T R`.
        ///
        /// ```
        /// use ga_runtime::cga2::{Motor, Point, Rotor, Translator};
        /// let half = Rotor::from_angle(std::f64::consts::PI).unwrap();
        /// let motor: Motor<f64> = Translator::from_displacement([5.0, 0.0]) * half;
        /// assert!(motor.transform(Point::new(1.0, 0.0)).distance(Point::new(4.0, 0.0)) < 1e-15);
        /// ```
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Motor { scalar, e12, e1i, e2i }

        /// A scaling by s about the origin: `D = exp(½ ln s · eo∧ei)`. The image of a point has
        /// weight 1/s.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Dilator { scalar, eoi }

        /// A rigid motion with a scaling, `T R D`.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Similarity { scalar, e12, e1i, e2i, eoi, e12oi }

        /// All blades of even grade.
        struct Even { scalar, e12, e1o, e2o, e1i, e2i, eoi, e12oi }

        /// All 16 blades.
        struct Multivector {
            scalar, e1, e2, eo, ei, e12, e1o, e2o, e1i, e2i, eoi, e12o, e12i, e1oi, e2oi, e12oi
        }

        products {
            // Joining.
            wedge({Point, RoundVector}, {Point, RoundVector}) -> PointPair;
            wedge(PointPair, {Point, RoundVector}) -> Circle;
            wedge({Point, RoundVector}, PointPair) -> Circle;
            wedge({Circle, Line}, {Point, RoundVector}) -> Pseudoscalar;
            wedge({Point, RoundVector}, {Circle, Line}) -> Pseudoscalar;
            wedge(PointPair, PointPair) -> Pseudoscalar;
            wedge({Point, RoundVector}, FlatPoint) -> Line;
            wedge(FlatPoint, {Point, RoundVector}) -> Line;
            wedge({Point, RoundVector}, Direction) -> Line;
            wedge({Point, RoundVector}, Infinity) -> FlatPoint;
            wedge(PointPair, Infinity) -> Line;
            wedge({Point, RoundVector}, Origin) -> PointPair;

            // Meeting.
            vee(Circle, {Circle, Line}) -> PointPair;
            vee(Line, Circle) -> PointPair;
            vee(Line, Line) -> FlatPoint;
            vee({Circle, Line}, {Point, RoundVector}) -> Scalar;
            vee({Point, RoundVector}, {Circle, Line}) -> Scalar;

            // Measuring.
            left_contraction({Point, RoundVector, DualLine}, {Point, RoundVector, DualLine}) -> Scalar;
            left_contraction({Point, RoundVector, DualLine}, PointPair) -> RoundVector;
            left_contraction({Point, RoundVector, DualLine}, {Circle, Line}) -> PointPair;
            left_contraction(PointPair, PointPair) -> Scalar;
            left_contraction(PointPair, {Circle, Line}) -> RoundVector;
            left_contraction(MotorGenerator, MotorGenerator) -> Scalar;
            left_contraction({Circle, Line}, {Circle, Line}) -> Scalar;
            left_contraction(Infinity, {Point, RoundVector}) -> Scalar;
            left_contraction(Infinity, PointPair) -> RoundVector;
            left_contraction(Infinity, Circle) -> PointPair;
            left_contraction(Infinity, Line) -> Direction;

            // Conversion to the dual form and back.
            dual({Point, RoundVector}) -> Circle;
            undual({Point, RoundVector}) -> Circle;
            dual(DualLine) -> Line;
            undual(DualLine) -> Line;
            dual(PointPair) -> PointPair;
            undual(PointPair) -> PointPair;
            dual(FlatPoint) -> MotorGenerator;
            undual(FlatPoint) -> MotorGenerator;
            dual(MotorGenerator) -> FlatPoint;
            undual(MotorGenerator) -> FlatPoint;
            dual(Circle) -> RoundVector;
            undual(Circle) -> RoundVector;
            dual(Line) -> DualLine;
            undual(Line) -> DualLine;
            dual(Pseudoscalar) -> Scalar;
            undual(Pseudoscalar) -> Scalar;
            dual(Multivector) -> Multivector;
            undual(Multivector) -> Multivector;

            // Composing transformations; the right one acts first.
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Translator, Translator) -> Translator;
            geometric(Translator, Rotor) -> Motor;
            geometric(Rotor, Translator) -> Motor;
            geometric(Motor, {Rotor, Translator, Motor}) -> Motor;
            geometric({Rotor, Translator}, Motor) -> Motor;
            geometric(Dilator, Dilator) -> Dilator;
            geometric({Rotor, Translator, Motor}, Dilator) -> Similarity;
            geometric(Dilator, {Rotor, Translator, Motor}) -> Similarity;
            geometric(Similarity, {Rotor, Translator, Motor, Dilator, Similarity}) -> Similarity;
            geometric({Rotor, Translator, Motor, Dilator}, Similarity) -> Similarity;
            geometric(RoundVector, RoundVector) -> Even;
            geometric(Even, Even) -> Even;
            geometric(Multivector, Multivector) -> Multivector;
            commutator(MotorGenerator, MotorGenerator) -> Direction;
            commutator(PointPair, PointPair) -> PointPair;

            wedge(Multivector, Multivector) -> Multivector;
            vee(Multivector, Multivector) -> Multivector;
            left_contraction(Multivector, Multivector) -> Multivector;
            right_contraction(Multivector, Multivector) -> Multivector;
            scalar_product(Multivector, Multivector) -> Scalar;
            commutator(Multivector, Multivector) -> Multivector;

            // Actions of versors.
            sandwich(
                {Rotor, Translator, Motor},
                {Point, RoundVector, DualLine, PointPair, FlatPoint, Direction, MotorGenerator, Circle, Line, Motor}
            ) -> Self;
            sandwich(
                {Dilator, Similarity},
                {RoundVector, DualLine, PointPair, FlatPoint, Direction, MotorGenerator, Circle, Line}
            ) -> Self;
            sandwich({Dilator, Similarity}, Point) -> RoundVector;
            // Reflections and inversions.
            sandwich(DualLine, {RoundVector, DualLine, PointPair, FlatPoint, Circle, Line}) -> Self;
            sandwich(RoundVector, {RoundVector, PointPair, Circle}) -> Self;
            sandwich({DualLine, RoundVector}, Point) -> RoundVector;
        }
    }
}
