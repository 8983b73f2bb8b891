//! What a blade is, told at run time.

use super::round::RoundBivector;
use super::vector3::dot;
use crate::Element;
use crate::cga3::{
    Circle, DualCircle, DualPlane, DualPointPair, DualSphere, FlatPoint, Line, MotorGenerator,
    Plane, PointPair, Sphere,
};
use crate::scalar::Real;

/// What a blade stands for, up to a tolerance.
///
/// The classification is that of Dorst, Fontijne and Mann, Geometric Algebra for Computer Science (2007), chapter 14: *rounds* are point pairs,
/// circles and spheres, real, imaginary or of radius zero; *flats* are points, lines and planes, rounds through infinity;
/// *free* blades have a direction and no place.
///
/// # Tolerance
///
/// The tolerance τ has no unit. Coefficients count as zero where they are at most τ times the largest of all, so coordinates should
/// be such that the scene has a size of about 1. A squared radius counts as zero where it is at most τ times the numbers from whose
/// difference it comes, `|r²| ≤ τ (c² + |c² ± r²|)`: less than that no blade can tell. In f64, 1e-12 is a good choice for results of a few
/// products, in f32 1e-4.
///
/// ```
/// use ga_runtime::cga3::{Plane, Point, Sphere};
/// use ga_runtime::geometry::Kind;
/// let sphere = Sphere::from_centre_radius(Point::new(0.0_f64, 0.0, 0.0), 2.0);
/// let wall = |x: f64| Plane::from_point_normal(Point::new(x, 0.0, 0.0), [1.0, 0.0, 0.0]);
/// let kinds = [1.0, 2.0, 3.0].map(|x| (sphere & wall(x)).kind(1e-12));
/// assert_eq!(kinds, [Kind::Real, Kind::Tangent, Kind::Imaginary]);
/// // Three points on a line do not make a circle.
/// let on_a_line = [0.0, 1.0, 5.0].map(|x| Point::new(x, 2.0, 2.0));
/// let [p, q, r] = on_a_line;
/// assert_eq!((p ^ q ^ r).kind(1e-12), Kind::Flat);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A round with r² > 0: two points, a circle, a sphere.
    Real,
    /// A round with r² = 0: a point with a direction (pair), with a plane (circle), or alone (sphere).
    Tangent,
    /// A round with r² < 0: no real point is on it.
    Imaginary,
    /// A flat point, line or plane.
    Flat,
    /// A direction, a free bivector, or for a sphere infinity itself.
    Free,
    /// All coefficients are zero.
    Zero,
    /// No geometric object: a sum that is no outer product of vectors, or a coefficient that is not finite.
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

macro_rules! kinds {
    ($($Type:ident: $what:literal, $sign:expr, $bivector:expr;)*) => {$(
        impl<S: Real<Mask = bool>> $Type<S> {
            #[doc = concat!("What the ", $what, " is, up to a [tolerance](Kind#tolerance).")]
            #[must_use]
            pub fn kind(self, tolerance: S) -> Kind {
                of_bivector($bivector(self), $sign, tolerance)
            }
        }
    )*};
}

// The sign of 2β − c² that makes a real round, and the form in which it has one.
kinds! {
    PointPair: "pair", 1, DualCircle::from;
    DualPointPair: "pair", 1, |pair: Self| DualCircle::from(pair.undual());
    Circle: "circle", -1, |circle: Self| circle.dual();
    DualCircle: "circle", -1, core::convert::identity;
}

impl<S: Real<Mask = bool>> DualSphere<S> {
    /// What the sphere is, up to a [tolerance](Kind#tolerance).
    #[must_use]
    pub fn kind(self, tolerance: S) -> Kind {
        let Some(sphere) = scaled_to_one(self) else {
            return without_size(self);
        };
        let normal = [sphere.e1, sphere.e2, sphere.e3];
        if is_at_most(sphere.eo, tolerance) {
            let is_free = normal.into_iter().all(|x| is_at_most(x, tolerance));
            return if is_free { Kind::Free } else { Kind::Flat };
        }
        let centre = normal.map(|x| x / sphere.eo);
        of_difference(
            dot(centre, centre),
            (sphere.ei + sphere.ei) / sphere.eo,
            tolerance,
        )
    }
}

macro_rules! kinds_through {
    ($($Type:ident: $what:literal, $larger:expr;)*) => {$(
        impl<S: Real<Mask = bool>> $Type<S> {
            #[doc = concat!("What the ", $what, " is, up to a [tolerance](Kind#tolerance).")]
            #[must_use]
            pub fn kind(self, tolerance: S) -> Kind {
                $larger(self).kind(tolerance)
            }
        }
    )*};
}

kinds_through! {
    Sphere: "sphere", |sphere: Self| sphere.dual();
    Plane: "plane, flat, or free where it is infinity itself,", Sphere::from;
    DualPlane: "plane, flat, or free where it is infinity itself,", DualSphere::from;
    Line: "line, flat, or free where its direction vanishes,", Circle::from;
    MotorGenerator: "dual line, flat, or free where it is the generator of a shift,", DualCircle::from;
    FlatPoint: "flat point, flat, or free where its weight vanishes,", PointPair::from;
}

fn of_bivector<S: Real<Mask = bool>>(bivector: DualCircle<S>, sign: i64, tolerance: S) -> Kind {
    let Some(b) = scaled_to_one(bivector) else {
        return without_size(bivector);
    };
    let two = S::from_integer(2);
    // B is a blade where B∧B vanishes: five numbers.
    let outer = [
        b.e12 * b.e3o - b.e13 * b.e2o + b.e23 * b.e1o,
        b.e12 * b.e3i - b.e13 * b.e2i + b.e23 * b.e1i,
        b.e12 * b.eoi - b.e1o * b.e2i + b.e1i * b.e2o,
        b.e13 * b.eoi - b.e1o * b.e3i + b.e1i * b.e3o,
        b.e23 * b.eoi - b.e2o * b.e3i + b.e2i * b.e3o,
    ];
    if !outer.into_iter().all(|x| is_at_most(two * x, tolerance)) {
        return Kind::NotABlade;
    }
    let are_small = |list: [S; 3]| list.into_iter().all(|x| is_at_most(x, tolerance));
    if are_small([b.e1o, b.e2o, b.e3o]) {
        // Of a dual line the directions e12, e13, e23 are left, of a flat point eoi.
        let has_place = !is_at_most(b.eoi, tolerance) || !are_small([b.e12, b.e13, b.e23]);
        return if has_place { Kind::Flat } else { Kind::Free };
    }
    let Some(round) = RoundBivector::of(b) else {
        return Kind::NotABlade;
    };
    let (square, twice) = (
        dot(round.centre, round.centre),
        round.infinite + round.infinite,
    );
    if sign < 0 {
        of_difference(square, twice, tolerance)
    } else {
        of_difference(twice, square, tolerance)
    }
}

/// The kind of a round with r² = a − b.
fn of_difference<S: Real<Mask = bool>>(a: S, b: S, tolerance: S) -> Kind {
    let squared = a - b;
    if !squared.is_finite() {
        Kind::NotABlade
    } else if !(tolerance * (a.abs() + b.abs())).less_than(squared.abs()) {
        Kind::Tangent
    } else if squared.less_than(S::zero()) {
        Kind::Imaginary
    } else {
        Kind::Real
    }
}

fn is_at_most<S: Real<Mask = bool>>(x: S, tolerance: S) -> bool {
    !tolerance.less_than(x.abs())
}

/// The same with its largest coefficient 1 or −1; `None` where that is zero or not finite.
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

/// Zero, or not finite.
fn without_size<S: Real<Mask = bool>, T: Element<Scalar = S>>(element: T) -> Kind {
    let mut blades = T::BLADES.iter();
    if blades.all(|&blade| element.coefficient(blade).is_zero()) {
        Kind::Zero
    } else {
        Kind::NotABlade
    }
}
