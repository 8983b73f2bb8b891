//! Versors as products of reflections and inversions.

use alloc::vec::Vec;

use super::odd_versor::even_part;
use crate::cga3::{Even, EvenVersor, OddVersor, RoundVector};
use crate::scalar::Real;
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> EvenVersor<S> {
    /// Unit vectors whose product is this versor, at most four: dual planes, which reflect, and
    /// dual spheres with a real radius, in which space is inverted; the last acts first. None for
    /// the identity, and for −1 a vector and its negative.
    ///
    /// Every versor has such factors (the theorem of Cartan and Dieudonné). They are found by
    /// reflecting the image of one vector of an orthonormal frame after the other onto the vector
    /// itself, beginning with the imaginary unit sphere about the origin; so those of a motion are
    /// planes. The directions in which the image deviates are computed without cancellation, so
    /// that the factors are accurate near the identity too. A deviation below 32 ε counts as none.
    /// The error of the product is a few `ε |V|²`, like that of `V ~V = 1`.
    ///
    /// `None` where a coefficient is not finite, or products of them are beyond the range of the
    /// scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{EvenVersor, Rotor, Translator};
    /// let rotation = Rotor::from_axis_angle([0.0, 0.0, 1.0], 1e-9_f64).unwrap();
    /// let planes = EvenVersor::from(rotation).reflections().unwrap();
    /// assert_eq!(planes.len(), 2);
    /// assert!(((planes[0] * planes[1]).e12 - rotation.e12()).abs() < 1e-15);
    /// // A translation is two reflections in planes at half its distance.
    /// let translation = Translator::from_displacement([0.0, 0.0, 4.0]);
    /// let planes = EvenVersor::from(translation).reflections().unwrap();
    /// let distance: f64 = planes[0].ei - planes[1].ei;
    /// assert_eq!(distance.abs(), 2.0);
    /// ```
    #[must_use]
    pub fn reflections(self) -> Option<Vec<RoundVector<S>>> {
        let even = Even::from(self);
        Versor {
            even,
            is_odd: false,
        }
        .factors()
    }
}

impl<S: Real<Mask = bool>> OddVersor<S> {
    /// Unit vectors whose product is this versor, one, three or five: dual planes and dual spheres,
    /// of which the last acts first; see [`EvenVersor::reflections`].
    ///
    /// ```
    /// use ga_runtime::cga3::{DualPlane, DualSphere, OddVersor, Point, RoundVector};
    /// let mirror = RoundVector::from(DualPlane::new(0.0, 1.0, 0.0, 3.0));
    /// let versor = OddVersor::reflection(DualPlane::new(0.0, 1.0, 0.0, 3.0)).unwrap();
    /// let factors = versor.reflections().unwrap();
    /// let [e1, e2, e3] = [factors[0].e1, factors[0].e2, factors[0].e3];
    /// assert_eq!((factors.len(), [e1, e2, e3], factors[0].ei), (1, [0.0, 1.0, 0.0], mirror.ei));
    /// ```
    #[must_use]
    pub fn reflections(self) -> Option<Vec<RoundVector<S>>> {
        let even = even_part(self.into());
        Versor { even, is_odd: true }.factors()
    }
}

/// Components in the orthonormal frame e₋, e₊, e1, e2, e3 with `e₋ = eo + ½ ei`, whose square is
/// −1, and `e₊ = eo − ½ ei`.
pub(super) fn components<S: Real>(vector: RoundVector<S>) -> [S; 5] {
    let half = S::from_ratio(1, 2);
    let (near, far) = (vector.eo * half, vector.ei);
    [near + far, near - far, vector.e1, vector.e2, vector.e3]
}

pub(super) fn vector_of<S: Real>([minus, plus, e1, e2, e3]: [S; 5]) -> RoundVector<S> {
    RoundVector::new(
        e1,
        e2,
        e3,
        minus + plus,
        (minus - plus) * S::from_ratio(1, 2),
    )
}

/// An orthogonal map of conformal vectors that preserves the direction of time, by components in
/// the frame of [`components`].
pub(super) trait Isometry<S>: Sized {
    /// The change `f(x) − x` of a basis vector.
    fn change(&self, place: usize) -> [S; 5];
    /// This map, and then the reflection in the hyperplane perpendicular to a unit vector.
    fn reflected(self, mirror: [S; 5]) -> Self;
}

/// Unit vectors whose reflections, the last one first, are an isometry, and what is left when they
/// are undone: the identity.
pub(super) fn reflections_of<S: Real<Mask = bool>, F: Isometry<S>>(
    mut map: F,
) -> Option<(Vec<[S; 5]>, F)> {
    let mut found = Vec::new();
    let none = S::epsilon() * S::from_integer(32);
    for place in 0..5 {
        let change = map.change(place);
        let mut across = [S::zero(); 5];
        across[place + 1..].copy_from_slice(&change[place + 1..]);
        let (distance, unit) = length_and_unit(across);
        let cosine = S::one() + change[place];
        if !distance.is_finite() || !cosine.is_finite() {
            return None;
        }
        let is_back = cosine.less_than(S::zero());
        if !none.less_than(distance) && !is_back {
            continue;
        }
        let [along, across] = halves(place == 0, cosine, distance);
        let mut mirror = unit.map(|x| x * across);
        mirror[place] = along;
        map = map.reflected(mirror);
        found.push(mirror);
    }
    Some((found, map))
}

/// A versor E, or E I with the pseudoscalar I, which commutes with everything; `I² = I ~I = −1`.
pub(super) struct Versor<S> {
    pub(super) even: Even<S>,
    pub(super) is_odd: bool,
}

impl<S: Real<Mask = bool>> Isometry<S> for Versor<S> {
    /// As `±V x ~V − x V ~V`, in which what does not change x has no part.
    fn change(&self, place: usize) -> [S; 5] {
        let (even, blade) = (self.even, Even::from(basis_vector(place).undual()));
        let (left, right) = (even * blade, blade * even);
        let between = if self.is_odd {
            left + right
        } else {
            left - right
        };
        components((between * even.reverse()).extract_quadvector().dual())
    }

    /// The product `n V`.
    fn reflected(self, mirror: [S; 5]) -> Self {
        let product = Even::from(vector_of(mirror).dual()) * self.even;
        Self {
            even: if self.is_odd { -product } else { product },
            is_odd: !self.is_odd,
        }
    }
}

impl<S: Real<Mask = bool>> Versor<S> {
    /// Unit vectors whose product this is.
    fn factors(self) -> Option<Vec<RoundVector<S>>> {
        let (found, rest) = reflections_of(self)?;
        let mut found: Vec<_> = found.into_iter().map(vector_of).collect();
        // What is left is the identity, with a sign.
        if rest.even.scalar.less_than(S::zero()) {
            match found.first_mut() {
                Some(first) => *first = -*first,
                None => found.extend([basis_vector(2), -basis_vector(2)]),
            }
        }
        Some(found)
    }
}

fn basis_vector<S: Real>(place: usize) -> RoundVector<S> {
    vector_of(core::array::from_fn(|k| {
        if k == place { S::one() } else { S::zero() }
    }))
}

/// The components along x and along the unit vector u of the unit vector that reflects x to
/// `cos x + sin u`: the sine and the cosine of half the angle, hyperbolic ones for x with the
/// square −1. The one that does not vanish is computed from the cosine.
fn halves<S: Real<Mask = bool>>(is_hyperbolic: bool, cosine: S, sine: S) -> [S; 2] {
    let (half, one) = (S::from_ratio(1, 2), S::one());
    if is_hyperbolic {
        // cosh² − sinh² = 1 holds only up to rounding, and the sine alone is accurate near 1.
        let cosine = one.hypot(sine);
        let across = ((cosine + one) * half).sqrt();
        return [sine * half / across, across];
    }
    let size = cosine.hypot(sine);
    let (cosine, sine) = (cosine / size, sine / size);
    if cosine.less_than(S::zero()) {
        let along = ((one - cosine) * half).sqrt();
        [-along, sine * half / along]
    } else {
        let across = ((one + cosine) * half).sqrt();
        [-(sine * half / across), across]
    }
}

fn length_and_unit<S: Real<Mask = bool>>(across: [S; 5]) -> (S, [S; 5]) {
    let [minus, plus, x, y, z] = across;
    let ends = Vector::new(minus, plus, S::zero()).length();
    let length = Vector::new(Vector::new(x, y, z).length(), ends, S::zero()).length();
    let divisor = if S::zero().less_than(length) {
        length
    } else {
        S::one()
    };
    (length, across.map(|x| x / divisor))
}
