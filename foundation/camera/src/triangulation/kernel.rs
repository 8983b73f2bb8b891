//! The formulas of two pixels.

use ga_runtime::cga3::{Direction, Motor, Point, Rotor};
use ga_runtime::scalar::{Field, Real};

/// The two rays of a pair of pixels and their common perpendicular.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<S> {
    /// The direction a of the left ray, of depth 1 in the left camera's frame.
    pub(super) direction: Direction<S>,
    /// The direction a × b of the common perpendicular; its length is |a| |b| sin φ.
    pub(super) normal: Direction<S>,
    /// |a × b|².
    pub(super) square: S,
    /// a · b.
    pub(super) cosine: S,
    /// The depths of the feet on both rays, multiplied by |a × b|².
    pub(super) depths: [S; 2],
    /// What multiple of the normal joins the left foot to the right one, multiplied by |a × b|².
    pub(super) height: S,
}

#[allow(unreachable_pub)]
mod formulas {
    ga_runtime::ga! { ga_runtime::cga3;
        /// The common perpendicular of the rays of two pixels. With the duals ℓ and k of the lines
        /// o∧a∧ei and c∧b∧ei, where o and c are the centres as seen from the left one, it is the
        /// commutator (ℓk − kℓ)/2: a line of direction n = a × b and squared norm n². The foot on
        /// the left ray has the depth (mutual moment of the right ray and the line o∧n∧ei)/n², that
        /// on the right ray accordingly, and (mutual moment of both rays)/n² is what multiple of n
        /// joins the feet. The mutual moment of two lines is the coefficient of ei in their meet.
        /// The divisions by n² are left to the caller, who has other divisions to share with them.
        pub fn closest(
            uniform left: Rotor, uniform right: Motor,
            uniform k: [Scalar; 4], uniform m: [Scalar; 4],
            u: Scalar, v: Scalar, x: Scalar, y: Scalar,
        ) -> (Direction, Direction, Scalar, Scalar, Scalar, Scalar, Scalar) {
            let a = sandwich(left, ((u - k[2]) * k[0] * e1 + (v - k[3]) * k[1] * e2 + e3) ^ ei);
            let b = ((x - m[2]) * m[0] * e1 + (y - m[3]) * m[1] * e2 + e3) ^ ei;
            let first = eo ^ a;
            let second = sandwich(right, eo ^ b);
            let perpendicular = undual(commutator(dual(first), dual(second)));
            let n = ei | perpendicular;
            let square = -norm_squared(perpendicular);
            let s = eo | ((eo ^ n) & second);
            let t = -(eo | (first & (sandwich(right, eo) ^ n)));
            let h = -(eo | (first & second));
            (a, n, square, first | second, s, t, h)
        }

        /// The mutual moment of the rays o∧a∧ei and `M (o∧b∧ei) ~M`: 0 where they meet.
        pub fn mutual_moment(right: Motor, a: Direction, b: Direction) -> Scalar {
            eo | ((eo ^ a) & sandwich(right, eo ^ b))
        }

        /// The point at a multiple of a direction and a multiple of a perpendicular from a centre.
        pub fn place(centre: Point, a: Direction, s: Scalar, n: Direction, h: Scalar) -> Point {
            sandwich(1 - (s * a + h * n) / 2, centre)
        }
    }
}

pub(super) use formulas::mutual_moment;

/// Two pinhole cameras prepared for pairs of pixels: the linear maps from pixels to rays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rays<S> {
    closest: formulas::Closest<S>,
    centre: Point<S>,
}

impl Rays<f64> {
    /// From the rotation of the left camera's frame into the world, the motor that takes the right
    /// camera's frame to the axes of the world about the left centre, that centre, and for each
    /// camera `[1/f_x, 1/f_y, c_x, c_y]`.
    pub(super) fn new(
        left: Rotor<f64>,
        right: Motor<f64>,
        centre: Point<f64>,
        pixels: [[f64; 4]; 2],
    ) -> Self {
        Self {
            closest: formulas::closest(left, right, pixels[0], pixels[1]),
            centre,
        }
    }
}

impl<S: Field> Rays<S> {
    /// The rays of a pair of pixels and their common perpendicular.
    #[inline(always)]
    pub(super) fn pair(&self, [u, v]: [S; 2], [x, y]: [S; 2]) -> Pair<S> {
        let (direction, normal, square, cosine, s, t, height) = self.closest.apply(u, v, x, y);
        Pair {
            direction,
            normal,
            square,
            cosine,
            depths: [s, t],
            height,
        }
    }

    /// The middle of the common perpendicular, for the reciprocal of |a × b|².
    #[inline(always)]
    pub(super) fn middle(&self, pair: &Pair<S>, by_square: S) -> Point<S> {
        formulas::place(
            self.centre,
            pair.direction,
            pair.depths[0] * by_square,
            pair.normal,
            pair.height * (by_square * S::from_ratio(1, 2)),
        )
    }
}

impl<S: Real> Pair<S> {
    /// The angle between the rays.
    #[inline(always)]
    pub(super) fn angle(&self) -> RayAngle<S> {
        RayAngle {
            square: self.square,
            cosine: self.cosine,
        }
    }
}

/// The angle φ between two directions a and b.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayAngle<S> {
    /// |a × b|².
    pub(super) square: S,
    /// a · b.
    pub(super) cosine: S,
}

impl<S: Real> RayAngle<S> {
    /// |a|² |b|² = (a·b)² + |a×b|².
    #[inline(always)]
    pub(super) fn norm(&self) -> S {
        self.cosine * self.cosine + self.square
    }

    /// The sine of the angle between the rays.
    pub(super) fn sine(&self) -> S {
        (self.square / self.norm()).sqrt()
    }

    /// The distance of the rays and the angle between them in [0, π], for the mutual moment of the
    /// rays and the reciprocals of |a × b|² and of the [`norm`](Self::norm).
    ///
    /// The angle φ is that of `tan φ = |a×b| / a·b`. Twice the angle has the cosine
    /// `((a·b)² − |a×b|²)/(|a|² |b|²)` and the sine `2 (a·b) |a×b|/(|a|² |b|²)`, in which |a×b| is
    /// the only root; the length of a perpendicular has the same one.
    #[inline(always)]
    pub(super) fn gap_and_angle(&self, moment: S, by_square: S, by_norm: S) -> [S; 2] {
        let length = self.square.sqrt();
        let gap = moment.abs() * (length * by_square);
        let double = (self.cosine * self.cosine - self.square) * by_norm;
        let (by_sine, _) = double.abs().angle_by_sine();
        // The arc whose double has the sine of 2φ and a cosine that is not negative.
        let arc = by_sine * (self.cosine * length * by_norm);
        let straight = S::from_f64(std::f64::consts::PI);
        let right = S::from_f64(std::f64::consts::FRAC_PI_2);
        let away = S::select(self.cosine.less_than(S::zero()), straight + arc, arc);
        let angle = S::select(double.less_than(S::zero()), right - arc, away);
        [gap, angle]
    }
}
