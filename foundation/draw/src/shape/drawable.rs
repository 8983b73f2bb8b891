//! Which elements can be drawn, and which cannot.

use super::Shape;
use super::error::NotDrawable;

/// An element that can be drawn.
///
/// It is implemented for the types of [`cga3`](ga_runtime::cga3) over `f64`, for
/// [`Trajectory`](super::Trajectory) and for [`Shape`] itself. Types of a single vector
/// ([`RoundVector`](ga_runtime::cga3::RoundVector), [`DualPlane`](ga_runtime::cga3::DualPlane)) and
/// the dual line ([`MotorGenerator`](ga_runtime::cga3::MotorGenerator)) are read in dual form, all
/// other blades in direct form.
///
/// A squared radius counts as zero where it is at most 1e-12 times the squared distance of the
/// centre from the origin.
///
/// ```
/// use ga_draw::{Drawable, Shape};
/// use ga_runtime::cga3::{Point, Sphere};
/// let [a, b] = [0.0, 1.0].map(|x| Sphere::from_centre_radius(Point::new(x, 0.0, 0.0), 1.0));
/// let Shape::Circle { centre, radius, imaginary, .. } = (a & b).shape()? else { panic!() };
/// assert_eq!((centre, imaginary), (Point::new(0.5, 0.0, 0.0), false));
/// assert!((radius * radius - 0.75).abs() < 1e-15);
/// # Ok::<(), ga_draw::NotDrawable>(())
/// ```
pub trait Drawable {
    /// The Euclidean shape of the element.
    ///
    /// # Errors
    ///
    /// [`NotDrawable`] where it has no place, or numbers that cannot be drawn.
    fn shape(&self) -> Result<Shape, NotDrawable>;
}

impl Drawable for Shape {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        self.clone().checked()
    }
}

impl<D: Drawable + ?Sized> Drawable for &D {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        (**self).shape()
    }
}

/// Fails where a coefficient is not finite, or all are zero.
pub(super) fn check_coefficients(
    coefficients: impl IntoIterator<Item = f64>,
) -> Result<(), NotDrawable> {
    let mut all_zero = true;
    for coefficient in coefficients {
        if !coefficient.is_finite() {
            return Err(NotDrawable::NotFinite(coefficient));
        }
        all_zero &= coefficient == 0.0;
    }
    if all_zero {
        return Err(NotDrawable::Zero);
    }
    Ok(())
}

/// An element divided by a power of two such that its largest coefficient is about 1 and products
/// of coefficients stay in range; an error where a coefficient is not finite or all are zero.
pub(super) fn balanced<E: ga_runtime::Element<Scalar = f64>>(
    element: &E,
) -> Result<E, NotDrawable> {
    let coefficients = || E::BLADES.iter().map(|&blade| element.coefficient(blade));
    check_coefficients(coefficients())?;
    let largest = coefficients().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // In two steps, since the reciprocals of the smallest numbers are out of range.
    let root = (-0.5 * largest.log2()).round().exp2();
    Ok(E::from_coefficients_unchecked(&mut |blade| {
        element.coefficient(blade) * root * root
    }))
}
