//! The two angles between two circles.

use super::tolerance::rounding;
use super::{Figure, hypotenuse, parallel};
use crate::geometry::number::logarithm_above_one;
use crate::scalar::Real;

/// How two circles are inclined to each other: two numbers that all conformal maps preserve.
///
/// In dual form a real circle is a plane of the algebra's vectors, spanned by two dual spheres that
/// contain it. Two planes have two principal angles (Clifford, 1873; Jordan, 1875), with the
/// cosines as the singular values of the inner products of two orthonormal bases. From the
/// invariants of the unit dual blades A and B: `cos α cos β = −A·B`, and
/// `sin² α sin² β = (A∧B)²`. Here the bases are the sphere about the centre through the circle and
/// the circle's plane. For centres c, d, radii r, s, and unit normals n, m the inner products are
///
/// ```text
/// (r² + s² − (c − d)²)/(2 r s)    m·(c − d)/r
/// n·(d − c)/s                     n·m
/// ```
///
/// Opposite orientation of one of the circles changes β to π − β.
///
/// ```
/// use ga_runtime::cga3::{Circle, Point};
/// use ga_runtime::geometry::relation::CircleAngles;
/// use std::f64::consts::PI;
///
/// let circle = |centre: [f64; 3], normal, radius| {
///     Circle::from_centre_normal_radius(Point::from(centre), normal, radius).unwrap()
/// };
/// let ring = circle([0.0; 3], [0.0, 0.0, 1.0], 1.0);
/// // A circle that crosses the ring twice, at a right angle.
/// let crossing = circle([0.0; 3], [1.0, 0.0, 0.0], 1.0);
/// assert_eq!(ring.angle_to(crossing), Some(CircleAngles::Linked([0.0, PI / 2.0])));
/// // A circle through the ring, like the next link of a chain.
/// let linked = circle([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], 1.0);
/// let Some(CircleAngles::Linked([alpha, beta])) = ring.angle_to(linked) else { panic!() };
/// assert!((alpha - PI / 3.0).abs() < 1e-15 && (beta - PI / 2.0).abs() < 1e-15);
/// // A circle about the same axis, of twice the radius: cosh d = (r/s + s/r)/2.
/// let around = circle([0.0; 3], [0.0, 0.0, 1.0], 2.0);
/// let Some(CircleAngles::Apart { distance, angle }) = ring.angle_to(around) else { panic!() };
/// assert!((distance - 2.0_f64.ln()).abs() < 1e-15 && angle == 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CircleAngles<S> {
    /// The circles are linked, or they meet: the angles α and β in radians, with α in [0, ½π] and β
    /// in [α, π − α].
    ///
    /// α is zero where they have a point in common or lie on a common sphere or plane; then β is
    /// the angle at which they cross, between their tangents as oriented. α counts as zero where
    /// its cosine is 1 within rounding, that is for α below some 10⁻⁷ in `f64`. Both are ½π where
    /// each circle is the axis of the other, as for a circle and a line along its axis.
    Linked([S; 2]),
    /// The circles neither meet nor are linked. There is a sphere that crosses both at right
    /// angles; in the hyperbolic space inside it they are two straight lines.
    Apart {
        /// The distance of these lines along their common perpendicular, without unit: the inverse
        /// hyperbolic cosine of the larger singular value. For circles in one plane it is
        /// Coxeter's inversive distance.
        distance: S,
        /// The angle between the lines as oriented, in [0, π].
        angle: S,
    },
}

/// The angles of two figures that are circles.
pub(super) fn circle_angles<S: Real<Mask = bool>>(
    a: Figure<S>,
    b: Figure<S>,
) -> Option<CircleAngles<S>> {
    let Figure::Circle {
        centre: c,
        normal: n,
        radius: r,
    } = a
    else {
        return None;
    };
    let Figure::Circle {
        centre: d,
        normal: m,
        radius: s,
    } = b
    else {
        return None;
    };
    if !S::zero().less_than(r) || !S::zero().less_than(s) {
        return None;
    }
    let (zero, one, half) = (S::zero(), S::one(), S::from_ratio(1, 2));
    let between = d - c;
    let distance = between.length();
    // The differences of the diagonal from 1, which do not cancel for circles that nearly coincide.
    let off_spheres = half * ((distance - r + s) / r) * ((distance + r - s) / s);
    let off_planes = half * (n - m).length_squared();
    let (g12, g21) = (-m.dot(between) / r, n.dot(between) / s);
    let mean = half * (off_spheres + off_planes);
    // The singular values of [[a, b], [c, d]] are the sum and the difference of √(e² + h²) and
    // √(f² + g²), with e, f = ½(a ± d) and g, h = ½(c ± b).
    let same = hypotenuse(one - mean, half * (g21 - g12));
    let other = hypotenuse(half * (off_planes - off_spheres), half * (g21 + g12));
    let (larger, smaller) = (same + other, same - other);
    let size = one + larger + rounding(c, r) / r + rounding(d, s) / s;
    if !size.is_finite() {
        return None;
    }
    // The larger value less 1, in the order that keeps the most digits: same² − 1 as a difference.
    let skew = half * (g21 - g12);
    let above = (mean * (mean - (one + one)) + skew * skew) / (same + one) + other;
    let slack = parallel::<S>() * size;
    let of_cosine = |x: S| {
        let x = x.max(-one).min(one);
        ((one - x) * (one + x)).sqrt().atan2(x)
    };
    if slack.less_than(above) {
        // arcosh(1 + y) = ln(1 + y + √(y (y + 2))).
        let root = (above * (above + one + one)).sqrt();
        return Some(CircleAngles::Apart {
            distance: logarithm_above_one(above + root),
            angle: of_cosine(smaller),
        });
    }
    let alpha = if (-slack).less_than(above) {
        zero
    } else {
        ((-above) * (larger + one)).sqrt().atan2(larger)
    };
    Some(CircleAngles::Linked([alpha, of_cosine(smaller)]))
}
