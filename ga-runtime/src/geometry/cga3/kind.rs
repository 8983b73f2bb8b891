//! The kind of a blade, found at run time.

use crate::Element;
use crate::cga3::{
    Bivector, Circle, DualCircle, DualPlane, DualPointPair, DualSphere, FlatPoint, Line,
    MotorGenerator, Plane, Point, PointPair, Quadvector, RoundVector, Sphere, Trivector,
};
use crate::geometry::number::are_numbers;
use crate::scalar::Real;
use crate::vga3::Vector;

/// The kind of geometric object that a blade represents, up to a tolerance.
///
/// The classification is that of Dorst, Fontijne and Mann, Geometric Algebra for Computer Science
/// (2007), chapter 14: *rounds* are point pairs, circles and spheres, real, imaginary or of radius
/// zero; *flats* are points, lines and planes, that is rounds through infinity; *free* blades have
/// a direction and no position.
///
/// # Tolerance
///
/// The tolerance τ is dimensionless; choose the unit of the coordinates so that the scene has a
/// size of about 1.
///
/// - A flat is treated as free where it is at a distance of 1/τ or more. Of the general types
///   `RoundVector`, `Bivector`, `Trivector` and `Quadvector`, a round is treated as flat where its
///   centre is at such a distance, and a round about the origin with a radius of √(2/τ) or more
///   cannot be distinguished from infinity and is free too.
/// - A squared radius is treated as zero where `|r²| ≤ τ (c² + |c² − r²|)`, c being the centre. The
///   coefficients of a general blade determine it no more accurately than to τ = ε; the types of
///   rounds store it, so that a tolerance of zero asks for its sign. Whether that is within the
///   rounding of a meet depends on what met: see
///   [What if two objects nearly touch?](crate::conventions#rounds)
/// - A sum is not a blade where its outer product with itself exceeds τ times the product of its
///   coefficients.
///
/// For results of a few products, 1e-12 is a good choice in f64 and 1e-5 in f32. With a tolerance
/// that is negative or NaN every comparison fails.
///
/// ```
/// use ga_runtime::cga3::{Plane, Point, Sphere};
/// use ga_runtime::geometry::Kind;
/// let sphere = Sphere::from_centre_radius(Point::new(0.0_f64, 0.0, 0.0), 2.0);
/// let wall = |x: f64| Plane::from_point_normal(Point::new(x, 0.0, 0.0), [1.0, 0.0, 0.0]);
/// let kinds = [1.0, 2.0, 3.0].map(|x| (sphere & wall(x)).kind(1e-12));
/// assert_eq!(kinds, [Kind::Real, Kind::Tangent, Kind::Imaginary]);
/// // Three points on a line do not make a circle: it has no weight.
/// let on_a_line = [0.0, 1.0, 5.0].map(|x| Point::new(x, 2.0, 2.0));
/// let [p, q, r] = on_a_line;
/// assert_eq!((p ^ q ^ r).kind(1e-12), Kind::Zero);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A round with r² > 0: two points, a circle, a sphere.
    Real,
    /// A round with r² = 0: a point with a direction (for a pair), with a plane (for a circle), or
    /// by itself (for a sphere).
    Tangent,
    /// A round with r² < 0: no real point is on it.
    Imaginary,
    /// A flat point, line or plane.
    Flat,
    /// A direction, a free bivector or, for a sphere, the point at infinity.
    Free,
    /// All coefficients are zero, or the weight of a type that has no flats.
    Zero,
    /// Not a geometric object: a sum that is not an outer product of vectors, or an element with a
    /// coefficient that is not finite.
    NotABlade,
}

impl Kind {
    /// Whether it is a round: a pair, circle or sphere, real or not.
    #[inline]
    #[must_use]
    pub fn is_round(self) -> bool {
        matches!(self, Self::Real | Self::Tangent | Self::Imaginary)
    }
}

macro_rules! of_parameters {
    ($($Type:ident: $what:literal, $weight:expr;)*) => {$(
        impl<S: Real<Mask = bool>> $Type<S> {
            #[doc = concat!("The kind, up to a [tolerance](Kind#tolerance), of the ", $what, ".")]
            ///
            /// It is decided by the squared radius that the type stores.
            #[must_use]
            pub fn kind(self, tolerance: S) -> Kind {
                let weight: [S; 3] = $weight(self);
                of_round(weight, self.centre, self.radius_squared, tolerance)
            }
        }
    )*};
}

of_parameters! {
    PointPair: "pair", |pair: Self| pair.direction.vector();
    DualPointPair: "pair", |pair: Self| pair.direction.vector();
    Circle: "circle", |circle: Self| circle.normal.vector();
    DualCircle: "circle", |circle: Self| circle.normal.vector();
    Sphere: "sphere", |sphere: Self| [sphere.weight, S::zero(), S::zero()];
    DualSphere: "sphere", |sphere: Self| [sphere.weight, S::zero(), S::zero()];
}

impl<S: Real<Mask = bool>> Bivector<S> {
    /// The kind, up to a [tolerance](Kind#tolerance), of what the coefficients are: a point pair or
    /// a flat point.
    #[must_use]
    pub fn kind(self, tolerance: S) -> Kind {
        of_bivector(self, 1, tolerance)
    }
}

impl<S: Real<Mask = bool>> Trivector<S> {
    /// The kind, up to a [tolerance](Kind#tolerance), of what the coefficients are: a circle or a
    /// line.
    #[must_use]
    pub fn kind(self, tolerance: S) -> Kind {
        of_bivector(self.dual(), -1, tolerance)
    }
}

impl<S: Real<Mask = bool>> Quadvector<S> {
    /// The kind, up to a [tolerance](Kind#tolerance), of what the coefficients are: a sphere or a
    /// plane.
    #[must_use]
    pub fn kind(self, tolerance: S) -> Kind {
        self.dual().kind(tolerance)
    }
}

impl<S: Real<Mask = bool>> RoundVector<S> {
    /// The kind, up to a [tolerance](Kind#tolerance), of the dual sphere or dual plane that the
    /// coefficients are: a point is a sphere of radius zero.
    #[must_use]
    pub fn kind(self, tolerance: S) -> Kind {
        let Some(sphere) = scaled_to_one(self) else {
            return without_size(self);
        };
        let normal = [sphere.e1, sphere.e2, sphere.e3];
        match shape(
            [sphere.eo.abs(), largest(normal), sphere.ei.abs()],
            tolerance,
        ) {
            Shape::Free => Kind::Free,
            Shape::Flat => Kind::Flat,
            Shape::Round => {
                let centre = normal.map(|x| x / sphere.eo);
                let twice = (sphere.ei + sphere.ei) / sphere.eo;
                of_difference(Vector::from(centre).length_squared(), twice, tolerance)
            }
        }
    }
}

macro_rules! kinds_through {
    ($($Type:ident: $what:literal, $larger:expr;)*) => {$(
        impl<S: Real<Mask = bool>> $Type<S> {
            #[doc = concat!("The kind, up to a [tolerance](Kind#tolerance), of the ", $what, ".")]
            #[must_use]
            pub fn kind(self, tolerance: S) -> Kind {
                $larger(self).kind(tolerance)
            }
        }
    )*};
}

kinds_through! {
    Plane: "plane: flat, or free where it is infinity itself", Quadvector::from;
    DualPlane: "plane: flat, or free where it is infinity itself", RoundVector::from;
    Line: "line: flat, or free where its direction vanishes", Trivector::from;
    MotorGenerator: "dual line: flat, or free where it is the generator of a translation", Bivector::from;
    FlatPoint: "flat point: flat, or free where its weight vanishes", Bivector::from;
}

/// The kind of a round by its parameters, the weight given by its components.
fn of_round<S: Real<Mask = bool>>(
    weight: [S; 3],
    centre: Point<S>,
    radius_squared: S,
    tolerance: S,
) -> Kind {
    if weight == [S::zero(); 3] {
        return Kind::Zero;
    }
    if !are_numbers(weight) || !are_numbers(centre.coordinates()) {
        return Kind::NotABlade;
    }
    // By halves, which do not overflow where the square of the centre does not.
    let half = S::from_ratio(1, 2);
    let (centre_squared, squared) = (
        Vector::from(centre).length_squared() * half,
        radius_squared * half,
    );
    let size = centre_squared + (centre_squared - squared).abs();
    by_square(squared, size, tolerance)
}

/// The kind of a round by its squared radius, which is compared with a size.
fn by_square<S: Real<Mask = bool>>(squared: S, size: S, tolerance: S) -> Kind {
    if !squared.is_finite() {
        Kind::NotABlade
    } else if is_at_most(squared, tolerance * size) {
        Kind::Tangent
    } else if squared.less_than(S::zero()) {
        Kind::Imaginary
    } else {
        Kind::Real
    }
}

fn of_bivector<S: Real<Mask = bool>>(bivector: Bivector<S>, sign: i64, tolerance: S) -> Kind {
    let Some(b) = scaled_to_one(bivector) else {
        return without_size(bivector);
    };
    let weight = largest([b.e1o, b.e2o, b.e3o]);
    let middle = largest([b.e12, b.e13, b.e23]).max(b.eoi.abs());
    let last = largest([b.e1i, b.e2i, b.e3i]);
    // B is a blade where B∧B, which has five coefficients, vanishes.
    let (near, far) = (weight.max(middle), last.max(middle));
    let outer = [
        (b.e12 * b.e3o - b.e13 * b.e2o + b.e23 * b.e1o, middle * near),
        (b.e12 * b.e3i - b.e13 * b.e2i + b.e23 * b.e1i, middle * far),
        (b.e12 * b.eoi - b.e1o * b.e2i + b.e1i * b.e2o, near * far),
        (b.e13 * b.eoi - b.e1o * b.e3i + b.e1i * b.e3o, near * far),
        (b.e23 * b.eoi - b.e2o * b.e3i + b.e2i * b.e3o, near * far),
    ];
    if !outer
        .into_iter()
        .all(|(x, size)| is_at_most(x, tolerance * size))
    {
        return Kind::NotABlade;
    }
    match shape([weight, middle, last], tolerance) {
        Shape::Free => return Kind::Free,
        Shape::Flat => return Kind::Flat,
        Shape::Round => {}
    }
    let direction = Vector::new(-b.e1o, -b.e2o, -b.e3o);
    let moment = Vector::new(b.e23, -b.e13, b.e12);
    let square = direction.length_squared();
    let centre = (direction * b.eoi + direction.cross(moment)).divided(square);
    let last = direction.dot(Vector::new(b.e1i, b.e2i, b.e3i));
    let twice = (b.eoi * b.eoi - last) / square;
    let (twice, centre) = (twice + twice, centre.length_squared());
    if sign < 0 {
        of_difference(centre, twice, tolerance)
    } else {
        of_difference(twice, centre, tolerance)
    }
}

enum Shape {
    Round,
    Flat,
    Free,
}

/// The shape, from the sizes of the coefficients: those with eo, those with neither eo nor ei or
/// with both, and those with ei. The last two grow with the first and the second power of the
/// distance.
fn shape<S: Real<Mask = bool>>([weight, middle, last]: [S; 3], tolerance: S) -> Shape {
    let is_free = |x: S| is_at_most(x, tolerance * last);
    if is_free(weight) && is_free(middle) {
        Shape::Free
    } else if is_at_most(weight, tolerance * middle) {
        Shape::Flat
    } else {
        Shape::Round
    }
}

fn largest<S: Real<Mask = bool>>([x, y, z]: [S; 3]) -> S {
    x.abs().max(y.abs()).max(z.abs())
}

/// The kind of a round with r² = a − b.
fn of_difference<S: Real<Mask = bool>>(a: S, b: S, tolerance: S) -> Kind {
    by_square(a - b, a.abs() + b.abs(), tolerance)
}

fn is_at_most<S: Real<Mask = bool>>(x: S, bound: S) -> bool {
    x.abs().less_than(bound) || x.abs() == bound
}

/// The element divided by the size of its largest coefficient; `None` where that is zero or not
/// finite.
fn scaled_to_one<S: Real<Mask = bool>, T: Element<Scalar = S>>(element: T) -> Option<T> {
    let mut largest = S::zero();
    for &blade in T::BLADES {
        let size = element.coefficient(blade).abs();
        if !size.is_finite() {
            return None;
        }
        largest = largest.max(size);
    }
    let scaled = |blade| element.coefficient(blade) / largest;
    (!largest.is_zero()).then(|| T::from_coefficients_unchecked(&mut |blade| scaled(blade)))
}

/// The kind of an element that is zero or not finite.
fn without_size<S: Real<Mask = bool>, T: Element<Scalar = S>>(element: T) -> Kind {
    let mut blades = T::BLADES.iter();
    if blades.all(|&blade| element.coefficient(blade).is_zero()) {
        Kind::Zero
    } else {
        Kind::NotABlade
    }
}
