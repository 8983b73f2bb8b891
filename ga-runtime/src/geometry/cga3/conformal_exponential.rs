//! The exponential of any bivector, and of the generators of similarities.
//!
//! The square of a bivector is `B² = s + q` with a scalar s and a 4-vector `q = B∧B` that commutes
//! with B and has a scalar square. So `exp B = cosh √(B²) + B sinh √(B²)/√(B²)`, and both functions
//! have a power series in B². In closed form they follow from the two commuting 2-blades whose sum
//! is B, `B = B₁ + B₂` with `B₁² = λ₁ ≥ B₂² = λ₂`, `λ₁ + λ₂ = s`, `4 λ₁ λ₂ = q²` (Dorst and
//! Valkenburg, Square Root and Logarithm of Rotors in 3D Conformal Geometric Algebra Using Polar
//! Decomposition, 2011; Roelfs and De Keninck, Graded Symmetry Groups: Plane and Simple, 2023). λ₂
//! is never positive: one of the two parts is always a rotation, which may be by zero.

use super::number_pair::{cosh_and_sinh_ratio, cosh_factors, nested_series, sinh_ratio_factors};
use crate::Element;
use crate::cga3::{Bivector, Even, EvenVersor, Quadvector, Similarity, SimilarityGenerator};
use crate::scalar::{Real, Ring};

impl<S: Real<Mask = bool>> Bivector<S> {
    /// The versor `exp(B)` of any bivector: for `B = −½θA` a rotation by θ about the circle or line
    /// whose dual is the unit bivector A, for `−½ t ei` a translation by t, for `½ ln s · eo∧ei` a
    /// scaling by s, for `−k eo` a [`Transversor`], for a sum the flow of their sum. Other
    /// generators convert by `From`.
    ///
    /// `None` where a coefficient is not finite, or the versor or the square of B is beyond the
    /// range of the scalar.
    ///
    /// [`Transversor`]: crate::cga3::Transversor
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Point, Bivector};
    /// // A half turn about a circle maps its centre to infinity, a quarter turn maps it to a point
    /// // of the axis at the distance of the radius.
    /// let [p, q, r] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0_f64, 0.0, 0.0]].map(Point::from);
    /// let axis = Circle::through(p, q, r).dual();
    /// let unit = axis * (axis.norm_squared().sqrt().recip() * std::f64::consts::FRAC_PI_4);
    /// let versor = Bivector::from(unit).exp().unwrap();
    /// let image = versor.transform_point(Point::default()).unwrap();
    /// assert!((image.coordinates()[2].abs() - 1.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn exp(self) -> Option<EvenVersor<S>> {
        let wedge = self.wedge(self);
        let [even, odd] =
            cosh_and_sinh_ratio_of(self.scalar_product(self), wedge.scalar_product(wedge));
        let bivector = self * odd[0] + times(self, wedge) * odd[1];
        let versor = assemble(even[0], bivector, wedge * even[1]);
        is_finite(versor.into()).then_some(versor)
    }
}

impl<S: Real<Mask = bool>> SimilarityGenerator<S> {
    /// The similarity `exp(G)`: for `½ ln s · eo∧ei` a scaling by s about the origin, with a
    /// rotation and a translation the similarity about its fixed point. `None` where a coefficient
    /// is not finite or the similarity is beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Dilator, Point};
    /// let growth = Dilator::from_factor(9.0).unwrap().about(Point::new(1.0, 0.0, 0.0));
    /// let half = (growth.log() * 0.5).exp().unwrap();
    /// let [x, _, _]: [f64; 3] = half.transform_point(Point::new(2.0, 0.0, 0.0)).coordinates();
    /// assert!((x - 4.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn exp(self) -> Option<Similarity<S>> {
        let versor = Bivector::from(self).exp()?;
        // Products of the blades of this type have no part with eo and without ei.
        Some(Similarity::new_unchecked(
            versor.scalar(),
            versor.e12(),
            versor.e13(),
            versor.e23(),
            versor.e1i(),
            versor.e2i(),
            versor.e3i(),
            versor.e123i(),
            versor.eoi(),
            versor.e12oi(),
            versor.e13oi(),
            versor.e23oi(),
        ))
    }
}

/// The bivector `B q` for a 4-vector q that commutes with B.
pub(super) fn times<S: Ring>(bivector: Bivector<S>, fourvector: Quadvector<S>) -> Bivector<S> {
    bivector | fourvector
}

/// `cosh √z` and `sinh √z / √z` of `z = scalar + q` for a q of the given square, each as its scalar
/// part and its coefficient of q.
fn cosh_and_sinh_ratio_of<S: Real<Mask = bool>>(scalar: S, square: S) -> [[S; 2]; 2] {
    let (zero, half) = (S::zero(), S::from_ratio(1, 2));
    if !S::one().less_than(scalar.abs() + square.abs().sqrt()) {
        let number = [scalar, S::one()];
        return [
            nested_series(number, square, cosh_factors()),
            nested_series(number, square, sinh_ratio_factors()),
        ];
    }
    let gap = (scalar * scalar - square).max(zero).sqrt();
    if gap.less_than(scalar.abs() * half) {
        // Two rotations by nearly the same angle: the values of z where q is plus and minus its
        // root.
        let root = square.sqrt();
        let at = |z: S| cosh_and_sinh_ratio(z.min(zero));
        let (plus, minus) = (at(scalar + root), at(scalar - root));
        let parts = |a: S, b: S| [(a + b) * half, (a - b) * half / root];
        return [parts(plus.0, minus.0), parts(plus.1, minus.1)];
    }
    // Of the two roots, the one that is computed without cancellation comes first.
    let quarter = half * half;
    let (first, second) = if scalar.less_than(zero) {
        let second = (scalar - gap) * half;
        (square * quarter / second, second)
    } else {
        let first = (scalar + gap) * half;
        (first, square * quarter / first)
    };
    let ((c1, s1), (c2, s2)) = (cosh_and_sinh_ratio(first), cosh_and_sinh_ratio(second));
    [
        [c1 * c2, s1 * s2 * half],
        [
            (first * (s1 * c2) - second * (c1 * s2)) / gap,
            (c1 * s2 - s1 * c2) * half / gap,
        ],
    ]
}

fn assemble<S: Ring>(scalar: S, b: Bivector<S>, q: Quadvector<S>) -> EvenVersor<S> {
    EvenVersor::new_unchecked(
        scalar, b.e12, b.e13, b.e23, b.e1o, b.e2o, b.e3o, b.e1i, b.e2i, b.e3i, b.eoi, q.e123o,
        q.e123i, q.e12oi, q.e13oi, q.e23oi,
    )
}

pub(super) fn is_finite<S: Real>(element: Even<S>) -> S::Mask {
    Element::is_finite(element)
}

pub(super) fn coefficients<S>(e: Even<S>) -> [S; 16] {
    [
        e.scalar, e.e12, e.e13, e.e23, e.e1o, e.e2o, e.e3o, e.e1i, e.e2i, e.e3i, e.eoi, e.e123o,
        e.e123i, e.e12oi, e.e13oi, e.e23oi,
    ]
}
