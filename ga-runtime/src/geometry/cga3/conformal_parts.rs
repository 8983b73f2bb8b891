//! Conformal versors as products of a similarity and another versor.

use crate::Element;
use crate::cga3::{Even, EvenVersor, OddVersor, RoundVector, Similarity, Transversor};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> EvenVersor<S> {
    /// The factors of `V = S K`: a transversor, which acts first, and a similarity, which has the
    /// parts [displacement](Similarity::displacement), [rotor](Similarity::rotor) and
    /// [factor](Similarity::factor). The transversor is 1 for a similarity.
    ///
    /// `None` where V maps the origin to infinity, within ε, which no `S K` does, or a coefficient
    /// is not finite. Every versor is a product of [reflections](EvenVersor::reflections).
    ///
    /// The vector of K is read from the image of infinity under the inverse,
    /// `~V ei V = λ (ei − 2k + 2k² eo)`.
    ///
    /// ```
    /// use ga_runtime::cga3::{EvenVersor, Rotor, Similarity, Transversor};
    /// let rotation = Rotor::from_axis_angle([1.0, 2.0, 3.0], 0.7).unwrap();
    /// let similarity = Similarity::from_parts([1.0, 2.0, 3.0], rotation, 2.0).unwrap();
    /// let bend = Transversor::from_vector([0.25, 0.0, -0.5]);
    /// let versor = EvenVersor::from(similarity) * EvenVersor::from(bend);
    /// let (found, transversor) = versor.similarity_and_transversor().unwrap();
    /// let [x, y, z]: [f64; 3] = transversor.vector();
    /// assert!((x - 0.25).abs() < 1e-15 && y.abs() < 1e-15 && (z + 0.5).abs() < 1e-15);
    /// assert!((found.factor() - 2.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn similarity_and_transversor(self) -> Option<(Similarity<S>, Transversor<S>)> {
        let pole = self.reverse().transform(infinity());
        let across = Vector::new(pole.e1, pole.e2, pole.e3);
        let rest = Vector::new(across.length(), pole.eo, S::zero()).length();
        if !(rest * S::epsilon()).less_than(pole.ei) {
            return None;
        }
        let vector = across.divided(pole.ei) * S::from_ratio(-1, 2);
        let transversor = Transversor::from_vector(vector.coordinates());
        let similarity = self * EvenVersor::from(transversor.reverse());
        Some((similarity_part(similarity)?, transversor))
    }
}

impl<S: Real<Mask = bool>> OddVersor<S> {
    /// The factors of `V = S n`: the inversion in a sphere or the reflection in a plane n, a unit
    /// vector, which acts first, and a similarity.
    ///
    /// The centre of the sphere is the point p that V maps to infinity, and its squared radius
    /// `1 + p²`. Where V maps infinity to itself, n is a plane through the origin, perpendicular to
    /// the axis of the rotation that V makes beside the reflection; so the similarity of a
    /// reflection is a translation.
    ///
    /// `None` where a coefficient is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{DualSphere, OddVersor, Point};
    /// let sphere = DualSphere::from_centre_radius(Point::new(1.0, 2.0, 0.0), 2.0);
    /// let versor = OddVersor::inversion(sphere).unwrap();
    /// let (similarity, inversion) = versor.similarity_and_inversion().unwrap();
    /// assert!(inversion.centre().unwrap().distance(Point::new(1.0, 2.0, 0.0)) < 1e-15);
    /// // By the radius √6 instead of 2.
    /// assert!((similarity.factor() - 4.0_f64 / 6.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn similarity_and_inversion(self) -> Option<(Similarity<S>, RoundVector<S>)> {
        let pole = self.reverse().transform(infinity());
        let across = Vector::new(
            Vector::new(pole.e1, pole.e2, pole.e3).length(),
            pole.eo,
            S::zero(),
        );
        let size = across.length();
        let vector = if (pole.ei * S::epsilon()).less_than(size) {
            let [e1, e2, e3, eo] = [pole.e1, pole.e2, pole.e3, pole.eo].map(|x| x / size);
            RoundVector::new(e1, e2, e3, eo, eo * S::from_ratio(-1, 2))
        } else {
            let axis = Vector::new(self.e1(), self.e2(), self.e3()).normalized();
            let axis = axis.unwrap_or(Vector::new(S::one(), S::zero(), S::zero()));
            RoundVector::new(axis[0], axis[1], axis[2], S::zero(), S::zero())
        };
        let similarity = self * OddVersor::from_vector(vector)?;
        Some((similarity_part(similarity)?, vector))
    }
}

fn infinity<S: Ring>() -> RoundVector<S> {
    let zero = S::zero();
    RoundVector::new(zero, zero, zero, zero, S::one())
}

/// The similarity that a versor is, without the blades in which it has rounding.
fn similarity_part<S: Real<Mask = bool>>(versor: EvenVersor<S>) -> Option<Similarity<S>> {
    let even = Even::from(versor);
    let similarity = Similarity::from_coefficients_unchecked(&mut |blade| even.coefficient(blade));
    similarity.is_finite().then_some(similarity)
}
