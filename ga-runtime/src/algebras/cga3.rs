//! Conformal geometric algebra of space.

crate::algebra! {
    /// Conformal geometric algebra of space: points, spheres, planes, circles and lines as blades,
    /// motions as versors.
    ///
    /// # Basis
    ///
    /// e1, e2, e3 span space; eo stands for the origin and ei for infinity. `e1² = e2² = e3² = 1`,
    /// `eo² = ei² = 0`, `eo·ei = −1`. A blade such as `e1oi` is the outer product of its vectors in
    /// the order of its name. `I = e1∧e2∧e3∧eo∧ei`, `I² = −1`, `dual(a) = a I⁻¹ = −a I`,
    /// `undual(a) = a I`, `a ∨ b = undual(dual a ∧ dual b)`.
    ///
    /// # Types
    ///
    /// An object X in *direct* form, an outer product of its points, consists of the points x with
    /// `x ∧ X = 0`; in *dual* form, `X I⁻¹`, of those with `x·X = 0`. The form is part of the type:
    /// [`Circle`] is direct, [`DualCircle`] dual; `dual` and `undual` convert between them.
    /// Conversions by `From` keep the coefficients of blades. An even versor M acts as
    /// `x' = M x ~M`, and in a product the right factor acts first.
    ///
    /// Spheres, circles and point pairs are *rounds*. They are stored by their parameters, centre
    /// c, weight or direction, and squared radius r², from which their coefficients follow. Sums of
    /// rounds are of the types of all blades of a grade, which hold flats too: [`RoundVector`],
    /// [`Bivector`], [`Trivector`], [`Quadvector`].
    ///
    /// Objects:
    ///
    /// | type | blades, or parameters | grade | object |
    /// | --- | --- | --- | --- |
    /// | [`Point`] | e1 e2 e3, eo = 1, ei = ½x² | 1 | the point x |
    /// | [`RoundVector`] | e1 e2 e3 eo ei | 1 | weighted point, dual sphere or dual plane |
    /// | [`DualSphere`] | `weight centre radius_squared` | 1 | dual sphere `w (c − ½r² ei)` |
    /// | [`DualPlane`] | e1 e2 e3 ei | 1 | dual plane `n + d ei` |
    /// | [`PointPair`] | `centre direction radius_squared` | 2 | two points `p∧q` |
    /// | [`Bivector`] | all ten of grade 2 | 2 | sums of pairs, dual circles, dual lines |
    /// | [`DualCircle`] | `centre normal radius_squared` | 2 | circle, the meet `σ∧τ` |
    /// | [`FlatPoint`] | e1i e2i e3i eoi | 2 | point and infinity `p∧ei` |
    /// | [`Direction`] | e1i e2i e3i | 2 | free vector `v∧ei` |
    /// | [`MotorGenerator`] | e12 e13 e23 e1i e2i e3i | 2 | dual line, meet `π∧ρ` of dual planes |
    /// | [`Circle`] | `centre normal radius_squared` | 3 | circle `p∧q∧r` |
    /// | [`Trivector`] | all ten of grade 3 | 3 | sums of circles, lines, dual pairs |
    /// | [`DualPointPair`] | `centre direction radius_squared` | 3 | two points, `σ∧τ∧υ` |
    /// | [`DualFlatPoint`] | e123 e12i e13i e23i | 3 | flat point, the meet of three dual planes |
    /// | [`DualDirection`] | e12i e13i e23i | 3 | free bivector `B∧ei`, attitude of a plane |
    /// | [`Line`] | e12i e13i e23i e1oi e2oi e3oi | 3 | line `p∧q∧ei` |
    /// | [`Sphere`] | `weight centre radius_squared` | 4 | sphere `p∧q∧r∧s` |
    /// | [`Quadvector`] | all five of grade 4 | 4 | weighted sphere or plane, and sums |
    /// | [`Plane`] | e12oi e13oi e23oi e123i | 4 | plane `p∧q∧r∧ei` |
    /// | [`Pseudoscalar`] | e123oi | 5 | all of space |
    ///
    /// Versors:
    ///
    /// | type | blades | transformation |
    /// | --- | --- | --- |
    /// | [`Rotor`] | scalar e12 e13 e23 | rotation about an axis through the origin, `exp(−½θB)` |
    /// | [`Translator`] | scalar = 1, e1i e2i e3i | translation by t, `1 − ½ t ei` |
    /// | [`Motor`] | scalar e12 e13 e23 e1i e2i e3i e123i | rigid motion `T R`, a screw motion |
    /// | [`Dilator`] | scalar eoi | scaling about the origin |
    /// | [`Similarity`] | Motor and eoi e12oi e13oi e23oi | rigid motion and scaling |
    /// | [`Transversor`] | scalar = 1, e1o e2o e3o | special conformal map `1 − k eo` |
    /// | [`EvenVersor`] | all sixteen of even grade | conformal map that preserves orientation |
    /// | [`DualPlane`] | e1 e2 e3 ei | reflection in the plane |
    /// | [`DualSphere`], [`RoundVector`] | as above | inversion, reflection |
    /// | [`OddVersor`] | all sixteen of odd grade | conformal map that reverses orientation |
    ///
    /// Logarithms and sums:
    ///
    /// | type | blades | used as |
    /// | --- | --- | --- |
    /// | [`MotorGenerator`] | e12 e13 e23 e1i e2i e3i | log of a motor, velocity of a motion |
    /// | [`SimilarityGenerator`] | MotorGenerator and eoi | log of a similarity |
    /// | [`Bivector`] | all ten of grade 2 | log of a conformal map |
    /// | [`Quaternion`] | as [`Rotor`] | sums of rotors |
    /// | [`DualQuaternion`] | as [`Motor`] | sums of motors |
    /// | [`Even`], [`Odd`] | all sixteen of even, of odd grade | sums of versors |
    /// | [`Multivector`] | all 32 | any sum |
    ///
    /// [`E1`], [`E2`], [`E3`], [`Origin`] and [`Infinity`] are the basis vectors as zero-sized
    /// types, so that `p ^ q ^ Infinity` is a line at no cost.
    ///
    /// # Products
    ///
    /// `a * b` geometric, `a ^ b` wedge, `a | b` left contraction, `a & b` vee;
    /// `right_contraction`, `scalar_product`, `commutator` = (ab − ba)/2, `sandwich` and
    /// `transform` are methods. In Rust `^ & |` bind looser than `+ *`, so `a + b ^ c` is
    /// `(a + b) ^ c`.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Line, Plane, Point};
    ///
    /// let (p, q) = (Point::new(1.0, 0.0, 0.0), Point::new(1.0, 2.0, 0.0));
    /// // The inner product of two points is −½ times their squared distance.
    /// assert_eq!(p | q, -2.0);
    /// // A line and a plane meet in a flat point.
    /// let line: Line<f64> = p ^ q ^ Infinity;
    /// let plane: Plane<f64> = Point::new(0.0, 1.0, 0.0)
    ///     ^ Point::new(1.0, 1.0, 0.0)
    ///     ^ Point::new(0.0, 1.0, 1.0)
    ///     ^ Infinity;
    /// let meet = line & plane;
    /// assert_eq!(
    ///     [
    ///         meet.e1i / meet.eoi,
    ///         meet.e2i / meet.eoi,
    ///         meet.e3i / meet.eoi
    ///     ],
    ///     [1.0, 1.0, 0.0]
    /// );
    /// ```
    pub mod cga3 {
        basis e1, e2, e3, eo, ei;
        metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;

        /// The basis vector e1, a unit vector of space.
        struct E1 { e1 = 1 }
        /// The basis vector e2, a unit vector of space.
        struct E2 { e2 = 1 }
        /// The basis vector e3, a unit vector of space.
        struct E3 { e3 = 1 }
        /// The basis vector eo, the point at the origin.
        struct Origin { eo = 1 }
        /// The basis vector ei, the point at infinity.
        struct Infinity { ei = 1 }

        /// The point x. It stores three numbers, and every product takes it as the whole conformal
        /// vector `x + eo + ½x² ei` (Cui, eqs. 27 and 28).
        ///
        /// Its weight, the coefficient of eo, is 1, and it is null: `P² = 0`. Sums of points are
        /// [`RoundVector`]s.
        ///
        /// ```
        /// use ga_runtime::cga3::Point;
        /// let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::from([1.0, 2.0, 7.0]));
        /// assert_eq!(p.coordinates(), [1.0, 2.0, 3.0]);
        /// assert_eq!((p.distance(q), p | q), (4.0, -8.0));
        /// ```
        #[hull(RoundVector)]
        #[facts(null, weight(eo))]
        struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }

        /// Any vector of the algebra: a weighted point, a dual sphere `c − ½r² ei` about the point
        /// c, a dual plane, and their sums.
        ///
        /// ```
        /// use ga_runtime::cga3::{Point, RoundVector};
        /// // The sum of two points is a dual sphere about the place between them, with weight 2.
        /// let sum: RoundVector<f64> = Point::new(1.0, 0.0, 0.0) + Point::new(3.0, 0.0, 0.0);
        /// assert_eq!(sum.centre(), Some(Point::new(2.0, 0.0, 0.0)));
        /// assert_eq!(sum.radius_squared(), Some(-1.0));
        /// // Its norm is the squared radius times the squared weight: positive for a real sphere.
        /// assert_eq!(sum.norm_squared(), -4.0);
        /// ```
        struct RoundVector { e1, e2, e3, eo, ei }

        /// The dual sphere `w (c − ½r² ei)` about the point c: the points x with `x·σ = 0`. It is a
        /// point for r = 0 and imaginary for r² < 0.
        ///
        /// It is stored as its weight w, its centre c and its squared radius r², so that a small
        /// sphere far from the origin keeps its size, which the coefficient of ei would lose in
        /// c². A vector without a weight is a dual plane, and no dual sphere: [`RoundVector`]
        /// holds either.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualSphere, Point};
        /// let sphere = DualSphere::from_centre_radius(Point::new(1.0, 0.0, 0.0), 2.0);
        /// assert_eq!(Point::new(3.0, 0.0, 0.0) | sphere, 0.0);
        /// // The norm is the squared radius times the squared weight.
        /// assert_eq!(sphere.norm_squared(), 4.0);
        /// ```
        #[hull(RoundVector)]
        struct DualSphere {
            weight, centre: Point, radius_squared;
            self = weight * (centre - radius_squared / 2 * ei);
            weight = -(ei | self);
            let unit = self / weight;
            radius_squared = unit | unit;
            centre = unit + radius_squared / 2 * ei;
        }

        /// The dual plane `n + d ei`: the points x with `n·x = d`, where n is the normal.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualPlane, Point};
        /// let plane = DualPlane::from_normal_distance([0.0, 0.0, 1.0], 2.0);
        /// assert_eq!(plane | Point::new(5.0, 5.0, 2.0), 0.0);
        /// assert_eq!(plane.normal(), [0.0, 0.0, 1.0]);
        /// ```
        struct DualPlane { e1, e2, e3, ei }

        /// Any multivector of grade 2: point pairs, dual circles and lines, flat points, and their
        /// sums.
        ///
        /// ```
        /// use ga_runtime::cga3::{Bivector, Point, PointPair};
        /// let pair: PointPair<f64> = Point::new(1.0, 0.0, 0.0) ^ Point::new(3.0, 0.0, 0.0);
        /// let sum: Bivector<f64> = pair + pair;
        /// assert_eq!(PointPair::try_from(sum), Ok(pair * 2.0));
        /// ```
        struct Bivector { e12, e13, e23, e1o, e2o, e3o, e1i, e2i, e3i, eoi }

        /// Any multivector of grade 3: circles, lines, dual point pairs, and their sums.
        ///
        /// ```
        /// use ga_runtime::cga3::{Circle, Line, Point, Trivector};
        /// let circle = Circle::from_centre_normal_radius(Point::ORIGIN, [0.0, 0.0, 1.0], 2.0);
        /// let line = Line::through(Point::ORIGIN, Point::new(1.0, 0.0, 0.0));
        /// let sum = Trivector::from(circle.unwrap()) + Trivector::from(line);
        /// assert!(Circle::try_from(Trivector::from(line)).is_err());
        /// assert_eq!(sum.e1oi, line.e1oi);
        /// ```
        struct Trivector { e123, e12o, e13o, e23o, e12i, e13i, e23i, e1oi, e2oi, e3oi }

        /// Two points, `p∧q`; they are real, coinciding or imaginary if its squared radius is
        /// positive, zero or negative.
        ///
        /// It is stored as the centre c, half way between the points, the direction d = q − p, the
        /// length of which is the weight, and the squared radius r², a quarter of the squared
        /// distance: `(c + ½r² ei) ∧ (d + (c·d) ei)`. [`Bivector`] holds sums of pairs.
        ///
        /// ```
        /// use ga_runtime::cga3::{Point, PointPair};
        /// let pair = PointPair::through(Point::new(1.0, 0.0, 0.0), Point::new(3.0, 0.0, 0.0));
        /// assert_eq!(pair.centre(), Some(Point::new(2.0, 0.0, 0.0)));
        /// assert_eq!(pair.radius(), Some(1.0));
        /// // The norm is minus the square: negative for a real pair.
        /// assert_eq!((pair.square(), pair.norm_squared()), (4.0, -4.0));
        /// ```
        #[hull(Bivector)]
        struct PointPair {
            centre: Point, direction: Direction, radius_squared;
            self = (centre + radius_squared / 2 * ei) ^ (centre | direction);
            let flat = ei | self;
            direction = -flat ^ ei;
            radius_squared = (self | self) / (flat | flat);
            centre = -self * ei * self / (2 * (flat | flat));
        }

        /// A circle in dual form, the meet `σ∧τ` of two dual spheres or planes that contain it. Its
        /// square is negative where the circle is real.
        ///
        /// It is stored as centre, normal and squared radius, as the [`Circle`] is.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualCircle, DualPlane, DualSphere, Point};
        /// let sphere = DualSphere::from_centre_radius(Point::ORIGIN, 5.0);
        /// let plane = DualPlane::from_normal_distance([0.0, 0.0, 1.0], 3.0);
        /// let circle: DualCircle<f64> = sphere ^ plane;
        /// assert_eq!(circle.radius(), Some(4.0));
        /// // The norm is positive for a real circle.
        /// assert!(circle.norm_squared() > 0.0);
        /// ```
        #[hull(Bivector)]
        struct DualCircle {
            centre: Point, normal: Direction, radius_squared;
            self = (centre - radius_squared / 2 * ei) ^ (centre | normal);
            let flat = ei | self;
            normal = -flat ^ ei;
            radius_squared = -(self | self) / (flat | flat);
            centre = -self * ei * self / (2 * (flat | flat));
        }

        /// A point and infinity, `p∧ei`: the meet of a line and a plane.
        ///
        /// ```
        /// use ga_runtime::cga3::{FlatPoint, Infinity, Point};
        /// let p = Point::new(1.0, 2.0, 3.0);
        /// let flat: FlatPoint<f64> = p ^ Infinity;
        /// assert_eq!(flat.to_point(), Some(p));
        /// assert_eq!(FlatPoint::from(p), flat);
        /// ```
        struct FlatPoint { e1i, e2i, e3i, eoi }

        /// A free vector, `v∧ei`. Motions rotate it and do not translate it.
        ///
        /// ```
        /// use ga_runtime::cga3::{Direction, Line, Point};
        /// let direction = Direction::from_vector([0.0, 0.0, 2.0]);
        /// assert_eq!(direction.vector(), [0.0, 0.0, 2.0]);
        /// let line: Line<f64> = Point::new(1.0, 0.0, 0.0) ^ direction;
        /// assert_eq!(line.unit_direction(), Some([0.0, 0.0, 1.0]));
        /// ```
        struct Direction { e1i, e2i, e3i }

        /// The generator of a rigid motion, a dual line: `−½θB` for a rotation by θ in the plane of
        /// the unit bivector B through the origin, `−½ t ei` for a translation by t.
        ///
        /// ```
        /// use ga_runtime::cga3::{Motor, MotorGenerator, Translator};
        /// let translation = Motor::from(Translator::from_displacement([2.0, 0.0, 0.0]));
        /// let generator: MotorGenerator<f64> = translation.log();
        /// assert_eq!(generator, MotorGenerator::new(0.0, 0.0, 0.0, -1.0, 0.0, 0.0));
        /// assert_eq!((generator * 0.5).exp().translator().displacement(), [1.0, 0.0, 0.0]);
        /// ```
        struct MotorGenerator { e12, e13, e23, e1i, e2i, e3i }

        /// A circle, `p∧q∧r` for three of its points.
        ///
        /// It is stored as its centre c, its normal n, the length of which is the weight, and its
        /// squared radius r²: `((c − ½r² ei) ∧ (n + (c·n) ei)) I`. Three points on a line have no
        /// circle: their product has the normal zero. [`Line`] and [`Trivector`] hold lines.
        ///
        /// ```
        /// use ga_runtime::cga3::{Circle, Point};
        /// let centre = Point::new(1.0, 2.0, 3.0);
        /// let circle = Circle::from_centre_normal_radius(centre, [0.0, 0.0, 2.0], 4.0).unwrap();
        /// assert_eq!(circle.radius(), Some(4.0));
        /// assert_eq!(circle.unit_normal(), Some([0.0, 0.0, 1.0]));
        /// // The norm is negative for a real circle, positive for an imaginary one.
        /// assert!(circle.norm_squared() < 0.0);
        /// ```
        #[hull(Trivector)]
        struct Circle {
            centre: Point, normal: Direction, radius_squared;
            self = undual((centre - radius_squared / 2 * ei) ^ (centre | normal));
            let dual = dual(self);
            let flat = ei | dual;
            normal = -flat ^ ei;
            radius_squared = -(dual | dual) / (flat | flat);
            centre = -dual * ei * dual / (2 * (flat | flat));
        }

        /// A point pair in dual form, the meet `σ∧τ∧υ` of three dual spheres or planes, stored as
        /// the [`PointPair`] is.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualPointPair, Point, PointPair};
        /// let pair = PointPair::through(Point::new(1.0, 0.0, 0.0), Point::new(3.0, 0.0, 0.0));
        /// let dual: DualPointPair<f64> = pair.dual();
        /// assert_eq!(dual.undual(), pair);
        /// // The norm is positive for a real pair.
        /// assert!(dual.norm_squared() > 0.0);
        /// ```
        #[hull(Trivector)]
        struct DualPointPair {
            centre: Point, direction: Direction, radius_squared;
            self = dual((centre + radius_squared / 2 * ei) ^ (centre | direction));
            let pair = undual(self);
            let flat = ei | pair;
            direction = -flat ^ ei;
            radius_squared = (pair | pair) / (flat | flat);
            centre = -pair * ei * pair / (2 * (flat | flat));
        }

        /// A flat point in dual form, the meet `π∧ρ∧σ` of three dual planes.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualFlatPoint, FlatPoint, Point};
        /// let flat = FlatPoint::from(Point::new(1.0, 2.0, 3.0));
        /// let dual: DualFlatPoint<f64> = flat.dual();
        /// assert_eq!(dual.undual(), flat);
        /// ```
        struct DualFlatPoint { e123, e12i, e13i, e23i }

        /// A free bivector `B∧ei`: the attitude of a plane or circle, and the dual form of the
        /// direction of its normal.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualDirection, Plane, Point};
        /// let plane = Plane::from_point_normal(Point::new(1.0, 2.0, 3.0), [0.0, 0.0, 2.0]);
        /// let attitude: DualDirection<f64> = plane.attitude();
        /// assert_eq!(attitude.normal(), [0.0, 0.0, 2.0]);
        /// ```
        struct DualDirection { e12i, e13i, e23i }

        /// A line, `p∧q∧ei` for two of its points: direction `q − p` in minus the coefficients of
        /// e1oi, e2oi, e3oi, moment `p∧q` in those of e12i, e13i, e23i.
        ///
        /// ```
        /// use ga_runtime::cga3::{Infinity, Line, Point};
        /// let (p, q) = (Point::new(0.0, 1.0, 0.0), Point::new(2.0, 1.0, 0.0));
        /// let line = Line::through(p, q);
        /// assert_eq!(line, p ^ q ^ Infinity);
        /// assert_eq!(line.direction(), [2.0, 0.0, 0.0]);
        /// assert_eq!(line.distance(Point::new(7.0, 1.0, 3.0)), Some(3.0));
        /// ```
        struct Line { e12i, e13i, e23i, e1oi, e2oi, e3oi }

        /// Any multivector of grade 4: a weighted sphere or plane, or a sum of them.
        ///
        /// ```
        /// use ga_runtime::cga3::{Plane, Point, Quadvector, Sphere};
        /// let sphere = Sphere::from_centre_radius(Point::new(1.0, 2.0, 3.0), 2.0);
        /// let plane = Plane::from_point_normal(Point::ORIGIN, [0.0, 0.0, 1.0]);
        /// // A sum of a sphere and a plane is a sphere through their circle.
        /// let sum: Quadvector<f64> = Quadvector::from(sphere) + Quadvector::from(plane);
        /// assert!(Sphere::try_from(sum).is_ok());
        /// assert!(Sphere::try_from(Quadvector::from(plane)).is_err());
        /// ```
        struct Quadvector { e123o, e123i, e12oi, e13oi, e23oi }

        /// A sphere, `p∧q∧r∧s` for four of its points, `w (c − ½r² ei) I`.
        ///
        /// It is stored as its weight w, its centre c and its squared radius r², as the
        /// [`DualSphere`] is. Four points in a plane have no sphere: their product has the weight
        /// zero, and [`Plane`] and [`Quadvector`] hold planes.
        ///
        /// ```
        /// use ga_runtime::cga3::{Point, Sphere};
        /// let sphere = Sphere::from_centre_radius(Point::new(1.0, 2.0, 3.0), 2.0);
        /// assert_eq!(sphere.centre(), Some(Point::new(1.0, 2.0, 3.0)));
        /// // The norm is minus the squared radius times the squared weight.
        /// assert_eq!(sphere.norm_squared(), -4.0);
        /// ```
        #[hull(Quadvector)]
        struct Sphere {
            weight, centre: Point, radius_squared;
            self = undual(weight * (centre - radius_squared / 2 * ei));
            let dual = dual(self);
            weight = -(ei | dual);
            let unit = dual / weight;
            radius_squared = unit | unit;
            centre = unit + radius_squared / 2 * ei;
        }

        /// A plane, `p∧q∧r∧ei` for three of its points.
        ///
        /// ```
        /// use ga_runtime::cga3::{Plane, Point};
        /// let plane = Plane::from_point_normal(Point::new(0.0, 0.0, 2.0), [0.0, 0.0, 3.0]);
        /// assert_eq!(plane.unit_normal(), Some([0.0, 0.0, 1.0]));
        /// assert_eq!(plane.signed_distance(Point::new(1.0, 1.0, 5.0)), Some(3.0));
        /// ```
        struct Plane { e123i, e12oi, e13oi, e23oi }

        /// A multiple of I = e1∧e2∧e3∧eo∧ei.
        ///
        /// ```
        /// use ga_runtime::cga3::{Plane, Point, Pseudoscalar};
        /// let plane = Plane::from_point_normal(Point::new(0.0, 0.0, 2.0), [0.0, 0.0, 1.0]);
        /// // Zero for a point of the plane.
        /// assert_eq!(plane ^ Point::new(4.0, 5.0, 2.0), Pseudoscalar::new(0.0));
        /// ```
        struct Pseudoscalar { e123oi }

        /// A rotation about an axis through the origin: `R = exp(−½θB) = cos ½θ − sin ½θ B`.
        ///
        /// ```
        /// use ga_runtime::cga3::{Direction, Rotor};
        /// let angle = std::f64::consts::FRAC_PI_2;
        /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap();
        /// let [x, y, z] = quarter.transform(Direction::from_vector([1.0, 0.0, 3.0])).vector();
        /// assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 3.0);
        /// ```
        #[hull(Quaternion)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }

        /// A translation by t: `T = 1 − ½ t ei`.
        ///
        /// ```
        /// use ga_runtime::cga3::{Point, Translator};
        /// let translation = Translator::from_displacement([1.0, 0.0, 0.0]);
        /// assert_eq!(translation.transform(Point::new(1.0, 2.0, 3.0)), Point::new(2.0, 2.0, 3.0));
        /// ```
        #[hull(DualQuaternion)]
        #[facts(unit_versor)]
        struct Translator { scalar = 1, e1i, e2i, e3i }

        /// A rigid motion: `M = T R`, with `M ~M = 1` in every grade.
        ///
        /// ```
        /// use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
        /// let half = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::PI).unwrap();
        /// // Rotated first, then moved.
        /// let motor: Motor<f64> = Translator::from_displacement([5.0, 0.0, 0.0]) * half;
        /// let moved = motor.transform(Point::new(1.0, 0.0, 0.0));
        /// assert!(moved.distance(Point::new(4.0, 0.0, 0.0)) < 1e-15);
        /// assert_eq!(motor * Motor::IDENTITY, motor);
        /// ```
        #[hull(DualQuaternion)]
        #[facts(unit_versor)]
        struct Motor { scalar, e12, e13, e23, e1i, e2i, e3i, e123i }

        /// A scaling by s about the origin: `D = exp(½ ln s · eo∧ei)`. The image of a point has
        /// weight 1/s.
        ///
        /// ```
        /// use ga_runtime::cga3::{Dilator, Point};
        /// let dilator = Dilator::from_factor(4.0).unwrap();
        /// let image = dilator.transform_point(Point::new(1.0, 2.0, 0.0));
        /// assert_eq!(image, Point::new(4.0, 8.0, 0.0));
        /// ```
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Dilator { scalar, eoi }

        /// A rigid motion with a scaling, `T R D`.
        ///
        /// ```
        /// use ga_runtime::cga3::{Point, Rotor, Similarity};
        /// let similarity = Similarity::from_parts([1.0, 0.0, 0.0], Rotor::IDENTITY, 4.0).unwrap();
        /// let image: Point<f64> = similarity.transform_point(Point::new(1.0, 2.0, 0.0));
        /// assert!(image.distance(Point::new(5.0, 8.0, 0.0)) < 1e-14);
        /// ```
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Similarity {
            scalar, e12, e13, e23, e1i, e2i, e3i, e123i, eoi, e12oi, e13oi, e23oi
        }

        /// The special conformal map `K = 1 − k eo`: inversion in the unit sphere about the origin,
        /// translation by k, inversion again. It fixes the origin and maps x to
        /// `(x + k x²)/(1 + 2 k·x + k² x²)`.
        ///
        /// ```
        /// use ga_runtime::cga3::{Point, Transversor};
        /// let versor = Transversor::from_vector([1.0, 0.0, 0.0]);
        /// let image = versor.transform_point(Point::new(1.0, 0.0, 0.0));
        /// assert_eq!(image, Some(Point::new(0.5, 0.0, 0.0)));
        /// ```
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Transversor { scalar = 1, e1o, e2o, e3o }

        /// Any conformal map of space that preserves orientation, `V ~V = 1` in every grade.
        ///
        /// An even versor with `V ~V = −1` is not a member: it is the pseudoscalar I times an
        /// [`OddVersor`] and reverses orientation as that does.
        ///
        /// ```
        /// use ga_runtime::cga3::{EvenVersor, Point, Translator, Transversor};
        /// let translation = Translator::from_displacement([1.0, 0.0, 0.0]);
        /// let bend = Transversor::from_vector([1.0, 0.0, 0.0]);
        /// let versor: EvenVersor<f64> = EvenVersor::from(translation) * EvenVersor::from(bend);
        /// let image = versor.transform_point(Point::new(1.0, 0.0, 0.0)).unwrap();
        /// assert!(image.distance(Point::new(1.5, 0.0, 0.0)) < 1e-15);
        /// ```
        #[hull(Even)]
        #[facts(unit_versor)]
        struct EvenVersor {
            scalar,
            e12, e13, e23, e1o, e2o, e3o, e1i, e2i, e3i, eoi,
            e123o, e123i, e12oi, e13oi, e23oi
        }

        /// Any conformal map of space that reverses orientation, `V ~V = 1` in every grade: a
        /// reflection in a plane, an inversion in a real sphere, or one of them and then an
        /// [`EvenVersor`]. It acts as `x' = V x̂ ~V` with the grade involution x̂.
        ///
        /// An odd versor with `V ~V = −1`, such as a dual sphere of negative square, is not a
        /// member: it is I times an [`EvenVersor`] and preserves orientation as that does.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualSphere, OddVersor, Point};
        /// let sphere = DualSphere::from_centre_radius(Point::ORIGIN, 2.0);
        /// let inversion = OddVersor::inversion(sphere).unwrap();
        /// let image = inversion.transform_point(Point::new(1.0, 0.0, 0.0)).unwrap();
        /// assert!(image.distance(Point::new(4.0, 0.0, 0.0)) < 1e-14);
        /// ```
        #[hull(Odd)]
        #[facts(unit_versor)]
        struct OddVersor {
            e1, e2, e3, eo, ei,
            e123, e12o, e13o, e23o, e12i, e13i, e23i, e1oi, e2oi, e3oi,
            e123oi
        }

        /// The generator of a similarity: that of a motion and `½ ln s · eo∧ei` for a scaling by s.
        ///
        /// ```
        /// use ga_runtime::cga3::{Rotor, Similarity, SimilarityGenerator};
        /// let similarity = Similarity::from_parts([0.0; 3], Rotor::default(), 4.0_f64).unwrap();
        /// let generator: SimilarityGenerator<f64> = similarity.log();
        /// assert!((generator.eoi - 0.5 * 4.0_f64.ln()).abs() < 1e-15);
        /// ```
        struct SimilarityGenerator { e12, e13, e23, e1i, e2i, e3i, eoi }

        /// Sums and multiples of rotors: the quaternions.
        ///
        /// ```
        /// use ga_runtime::cga3::{Quaternion, Rotor};
        /// let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.0_f64).unwrap();
        /// let sum: Quaternion<f64> = Rotor::IDENTITY + rotor;
        /// let middle = Rotor::normalize(sum).unwrap();
        /// assert!((middle.to_axis_angle().1 - 0.5).abs() < 1e-15);
        /// ```
        struct Quaternion { scalar, e12, e13, e23 }

        /// Sums and multiples of motors: the dual quaternions. A weighted sum of motors,
        /// normalised, is their blend.
        ///
        /// ```
        /// use ga_runtime::cga3::{DualQuaternion, Motor, Translator};
        /// let translation = Motor::from(Translator::from_displacement([2.0, 0.0, 0.0]));
        /// let sum: DualQuaternion<f64> = Motor::default() * 0.75 + translation * 0.25;
        /// assert_eq!(sum.normalize().unwrap().translator().displacement(), [0.5, 0.0, 0.0]);
        /// ```
        struct DualQuaternion { scalar, e12, e13, e23, e1i, e2i, e3i, e123i }

        /// All blades of even grade.
        ///
        /// ```
        /// use ga_runtime::cga3::{Even, RoundVector};
        /// let (a, b) = (RoundVector::E1, RoundVector::E2);
        /// let product: Even<i64> = a * b;
        /// assert_eq!(product, Even { e12: 1, ..Even::ZERO });
        /// assert_eq!(product * product, -Even::ONE);
        /// ```
        struct Even {
            scalar,
            e12, e13, e23, e1o, e2o, e3o, e1i, e2i, e3i, eoi,
            e123o, e123i, e12oi, e13oi, e23oi
        }

        /// All blades of odd grade.
        ///
        /// ```
        /// use ga_runtime::cga3::{Odd, RoundVector};
        /// let vector = RoundVector::new(1.0, 2.0, 3.0, 4.0, 5.0);
        /// assert_eq!(Odd::from(vector).extract_round_vector(), vector);
        /// ```
        struct Odd {
            e1, e2, e3, eo, ei,
            e123, e12o, e13o, e23o, e12i, e13i, e23i, e1oi, e2oi, e3oi,
            e123oi
        }

        /// All 32 blades.
        ///
        /// ```
        /// use ga_runtime::cga3::{Multivector, Point};
        /// let (p, q) = (Point::new(1.0, 0.0, 0.0), Point::new(3.0, 0.0, 0.0));
        /// let product = Multivector::from(p) * Multivector::from(q);
        /// assert_eq!((product.scalar, product.grade(0)), (p | q, Multivector::ONE * (p | q)));
        /// // Back to a type, if it is a member of that.
        /// assert_eq!(Point::try_from(Multivector::from(p)), Ok(p));
        /// assert!(Point::try_from(product).is_err());
        /// ```
        struct Multivector {
            scalar,
            e1, e2, e3, eo, ei,
            e12, e13, e23, e1o, e2o, e3o, e1i, e2i, e3i, eoi,
            e123, e12o, e13o, e23o, e12i, e13i, e23i, e1oi, e2oi, e3oi,
            e123o, e123i, e12oi, e13oi, e23oi,
            e123oi
        }

        products {
            // Joins: of points to pairs, circles and spheres, and with infinity to flats. What may
            // be none of these is of the type of its sums.
            wedge(Point, Point) -> PointPair;
            wedge(RoundVector, {Point, RoundVector}) -> Bivector;
            wedge(Point, RoundVector) -> Bivector;
            wedge(PointPair, Point) -> Circle;
            wedge(Point, PointPair) -> Circle;
            wedge(Bivector, {Point, RoundVector}) -> Trivector;
            wedge({Point, RoundVector}, Bivector) -> Trivector;
            wedge(PointPair, RoundVector) -> Trivector;
            wedge(RoundVector, PointPair) -> Trivector;
            wedge(Circle, Point) -> Sphere;
            wedge(Point, Circle) -> Sphere;
            wedge(Trivector, {Point, RoundVector}) -> Quadvector;
            wedge({Point, RoundVector}, Trivector) -> Quadvector;
            wedge(Circle, RoundVector) -> Quadvector;
            wedge(RoundVector, Circle) -> Quadvector;
            wedge({Sphere, Quadvector, Plane}, {Point, RoundVector}) -> Pseudoscalar;
            wedge({Point, RoundVector}, {Sphere, Quadvector, Plane}) -> Pseudoscalar;
            wedge(PointPair, PointPair) -> Sphere;
            wedge(Bivector, Bivector) -> Quadvector;
            wedge(PointPair, {Circle, Line}) -> Pseudoscalar;
            wedge({Circle, Line}, PointPair) -> Pseudoscalar;
            wedge(Bivector, Trivector) -> Pseudoscalar;
            wedge(Trivector, Bivector) -> Pseudoscalar;
            wedge(FlatPoint, {Point, RoundVector}) -> Line;
            wedge({Point, RoundVector}, FlatPoint) -> Line;
            wedge({Point, RoundVector}, Direction) -> Line;
            wedge(Direction, {Point, RoundVector}) -> Line;
            wedge({Line, PointPair}, FlatPoint) -> Plane;
            wedge(Line, {Point, RoundVector}) -> Plane;
            wedge({Point, RoundVector}, Line) -> Plane;
            wedge({Point, RoundVector}, Infinity) -> FlatPoint;
            wedge({PointPair, Bivector}, Infinity) -> Line;
            wedge({Circle, Trivector}, Infinity) -> Plane;
            wedge({Sphere, Quadvector}, Infinity) -> Pseudoscalar;

            // The same with the basis vectors, which cost nothing.
            wedge(Origin, Point) -> PointPair;
            wedge(Point, Origin) -> PointPair;
            wedge(Origin, RoundVector) -> Bivector;
            wedge(RoundVector, Origin) -> Bivector;
            wedge({E1, E2, E3}, {Point, RoundVector}) -> Bivector;
            wedge({Point, RoundVector}, {E1, E2, E3}) -> Bivector;
            wedge(PointPair, Origin) -> Circle;
            wedge({PointPair, Bivector}, {E1, E2, E3}) -> Trivector;
            wedge(Circle, Origin) -> Sphere;
            wedge({Circle, Trivector}, {E1, E2, E3}) -> Quadvector;
            wedge(FlatPoint, {E1, E2, E3, Origin}) -> Line;
            wedge(Line, {E1, E2, E3, Origin}) -> Plane;
            wedge(Infinity, {Point, RoundVector}) -> FlatPoint;
            wedge(Infinity, {PointPair, Bivector}) -> Line;
            wedge(Infinity, {Circle, Trivector}) -> Plane;
            left_contraction({E1, E2, E3, Origin}, {Point, RoundVector}) -> Scalar;
            left_contraction({Point, RoundVector}, {E1, E2, E3, Origin, Infinity}) -> Scalar;

            // Meeting.
            vee({Sphere, Plane}, Sphere) -> Circle;
            vee(Sphere, Plane) -> Circle;
            vee(Quadvector, Quadvector) -> Trivector;
            vee(Plane, Plane) -> Line;
            vee({Sphere, Plane}, Circle) -> PointPair;
            vee(Circle, {Sphere, Plane}) -> PointPair;
            vee(Quadvector, Trivector) -> Bivector;
            vee(Trivector, Quadvector) -> Bivector;
            vee(Sphere, blade Line) -> PointPair;
            vee(blade Line, Sphere) -> PointPair;
            vee(Plane, Line) -> FlatPoint;
            vee(Line, Plane) -> FlatPoint;
            vee({Circle, Line}, {Circle, Line}) -> RoundVector;
            vee({Sphere, Quadvector, Plane}, {Point, RoundVector}) -> Scalar;
            vee({Point, RoundVector}, {Sphere, Quadvector, Plane}) -> Scalar;

            // Meeting in dual form.
            wedge(DualPlane, DualPlane) -> MotorGenerator;
            wedge(DualSphere, {DualSphere, DualPlane}) -> DualCircle;
            wedge(DualPlane, DualSphere) -> DualCircle;
            wedge(DualCircle, {DualSphere, DualPlane}) -> DualPointPair;
            wedge(blade MotorGenerator, DualSphere) -> DualPointPair;
            wedge(MotorGenerator, DualPlane) -> DualFlatPoint;

            // Measuring: inner products and contractions.
            left_contraction({Point, RoundVector, DualPlane}, {Point, RoundVector, DualPlane}) -> Scalar;
            left_contraction({Point, DualSphere}, DualSphere) -> Scalar;
            left_contraction({Point, RoundVector, DualPlane}, {PointPair, Bivector}) -> RoundVector;
            left_contraction({Point, RoundVector, DualPlane}, {Circle, Trivector, Line}) -> Bivector;
            left_contraction({Point, RoundVector, DualPlane}, {Sphere, Quadvector, Plane}) -> Trivector;
            left_contraction(Point, Pseudoscalar) -> Sphere;
            left_contraction(RoundVector, Pseudoscalar) -> Quadvector;
            left_contraction(DualPlane, Pseudoscalar) -> Plane;
            left_contraction(PointPair, PointPair) -> Scalar;
            left_contraction(Bivector, Bivector) -> Scalar;
            left_contraction(Bivector, Trivector) -> RoundVector;
            left_contraction(Bivector, Quadvector) -> Bivector;
            left_contraction(PointPair, {Circle, Line, Sphere, Plane}) -> Multivector;
            left_contraction(MotorGenerator, MotorGenerator) -> Scalar;
            left_contraction({Circle, Line}, {Circle, Line}) -> Scalar;
            left_contraction(Trivector, Trivector) -> Scalar;
            left_contraction({Circle, Line}, {Sphere, Plane}) -> RoundVector;
            left_contraction({Sphere, Quadvector, Plane}, {Sphere, Quadvector, Plane}) -> Scalar;
            left_contraction(Infinity, {Point, RoundVector}) -> Scalar;
            left_contraction(Infinity, {PointPair, Bivector}) -> RoundVector;
            left_contraction(Infinity, {Circle, Trivector}) -> Bivector;
            left_contraction(Infinity, Line) -> Direction;
            left_contraction(Infinity, {Sphere, Quadvector}) -> Trivector;
            right_contraction({PointPair, Bivector}, {Point, RoundVector}) -> RoundVector;
            right_contraction({Circle, Trivector, Line}, {Point, RoundVector}) -> Bivector;
            right_contraction({Sphere, Quadvector, Plane}, {Point, RoundVector}) -> Trivector;
            scalar_product({Point, RoundVector, DualPlane}, {Point, RoundVector, DualPlane}) -> Scalar;
            scalar_product(PointPair, PointPair) -> Scalar;
            scalar_product(Bivector, Bivector) -> Scalar;
            scalar_product(Trivector, Trivector) -> Scalar;
            scalar_product(Quadvector, Quadvector) -> Scalar;
            scalar_product(FlatPoint, FlatPoint) -> Scalar;
            scalar_product(MotorGenerator, MotorGenerator) -> Scalar;
            scalar_product(Circle, {Circle, Line}) -> Scalar;
            scalar_product(Line, {Circle, Line}) -> Scalar;
            scalar_product(Sphere, {Sphere, Plane}) -> Scalar;
            scalar_product(Plane, {Sphere, Plane}) -> Scalar;
            scalar_product(Multivector, Multivector) -> Scalar;

            // Conversion to the dual form and back.
            dual(Point) -> Sphere;
            undual(Point) -> Sphere;
            dual(RoundVector) -> Quadvector;
            undual(RoundVector) -> Quadvector;
            dual(Quadvector) -> RoundVector;
            undual(Quadvector) -> RoundVector;
            dual(DualPlane) -> Plane;
            undual(DualPlane) -> Plane;
            dual(Bivector) -> Trivector;
            undual(Bivector) -> Trivector;
            dual(Trivector) -> Bivector;
            undual(Trivector) -> Bivector;
            dual(PointPair) -> DualPointPair;
            undual(DualPointPair) -> PointPair;
            dual(FlatPoint) -> DualFlatPoint;
            undual(DualFlatPoint) -> FlatPoint;
            dual(Direction) -> DualDirection;
            undual(DualDirection) -> Direction;
            dual(MotorGenerator) -> Line;
            undual(MotorGenerator) -> Line;
            dual(Circle) -> DualCircle;
            undual(DualCircle) -> Circle;
            dual(Line) -> MotorGenerator;
            undual(Line) -> MotorGenerator;
            dual(Sphere) -> DualSphere;
            undual(DualSphere) -> Sphere;
            dual(Plane) -> DualPlane;
            undual(Plane) -> DualPlane;
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
            geometric(Transversor, Transversor) -> Transversor;
            geometric(Quaternion, Quaternion) -> Quaternion;
            geometric(DualQuaternion, DualQuaternion) -> DualQuaternion;
            geometric(DualPlane, DualPlane) -> DualQuaternion;
            geometric(RoundVector, RoundVector) -> Even;
            geometric(Line, Line) -> DualQuaternion;
            geometric(MotorGenerator, MotorGenerator) -> DualQuaternion;
            geometric(Even, Even) -> Even;
            geometric(Multivector, Multivector) -> Multivector;

            commutator(MotorGenerator, MotorGenerator) -> MotorGenerator;
            commutator(MotorGenerator, Line) -> Line;
            commutator(Line, Line) -> MotorGenerator;
            commutator(PointPair, PointPair) -> Bivector;
            commutator(Bivector, Bivector) -> Bivector;
            commutator(Multivector, Multivector) -> Multivector;

            wedge(Multivector, Multivector) -> Multivector;
            left_contraction(Multivector, Multivector) -> Multivector;
            right_contraction(Multivector, Multivector) -> Multivector;
            vee(Multivector, Multivector) -> Multivector;
            sandwich(Multivector, Multivector) -> Multivector;

            // Actions of versors.
            sandwich(
                {Rotor, Translator, Motor},
                {
                    Point, RoundVector, DualSphere, DualPlane, PointPair, DualCircle, Bivector, FlatPoint, Direction,
                    MotorGenerator, Circle, DualPointPair, Trivector, Line, Sphere, Quadvector, Plane, Motor
                }
            ) -> Self;
            sandwich(
                {Dilator, Similarity},
                {
                    RoundVector, DualSphere, DualPlane, PointPair, DualCircle, Bivector, FlatPoint, Direction,
                    MotorGenerator, Circle, DualPointPair, Trivector, Line, Sphere, Quadvector, Plane
                }
            ) -> Self;
            sandwich({Dilator, Similarity}, Point) -> RoundVector;
            sandwich(Transversor, {Point, RoundVector}) -> RoundVector;
            sandwich(Even, RoundVector) -> Multivector;
            // Reflections and inversions.
            sandwich(
                DualPlane,
                {
                    RoundVector, DualSphere, DualPlane, PointPair, DualCircle, Bivector, FlatPoint, Circle,
                    DualPointPair, Trivector, Line, Sphere, Quadvector, Plane
                }
            ) -> Self;
            sandwich(RoundVector, {RoundVector, Bivector, Trivector, Quadvector}) -> Self;
            sandwich({DualPlane, RoundVector}, Point) -> RoundVector;
        }
    }
}
