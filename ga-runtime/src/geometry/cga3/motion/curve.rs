//! Curves of motions, given by control motions.

use crate::cga3::{Motor, Rotor};
use crate::scalar::Real;

impl<S: Real<Mask = bool>> Motor<S> {
    /// The Bézier curve of N control motors, of degree N − 1, by the algorithm of de Casteljau with
    /// screws in place of line segments: the motors `M₀ … Mₙ` are replaced by the motors
    /// `Mₖ exp(t log(~Mₖ Mₖ₊₁))`, and this is repeated until one is left (Park and Ravani, Bézier
    /// curves on Riemannian manifolds and Lie groups, Journal of Mechanical Design 117, 1995).
    ///
    /// It begins at the first motor at t = 0, with the velocity `(N − 1) log(~M₀ M₁)` in the frame
    /// of the moved body, and ends at the last at t = 1, with the velocity `(N − 1) log(~Mₙ₋₁ Mₙ)`;
    /// so curves are joined smoothly as Bézier curves of points are. The curve is the same run
    /// backwards, and it is equivariant: `A Mₖ B` as control motors give `A M B`. Control motors at
    /// equal steps of one screw give that screw at constant speed. Neighbours should be well within
    /// half a turn of each other: each segment takes the shorter rotation, and the curve jumps
    /// where that changes.
    ///
    /// With a single control motor the curve is constant; without any it does not compile. Outside
    /// [0, 1] the curve is extrapolated. A t that is not finite gives a motor with coefficients
    /// that are not finite, for two or more control motors.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let control = [[0.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0], [4.0, 0.0, 0.0]]
    ///     .map(|t: [f64; 3]| Motor::from(Translator::from_displacement(t)));
    /// // For translations it is the Bézier curve of points: here (P₀ + 3 P₁ + 3 P₂ + P₃)/8.
    /// assert_eq!(Motor::bezier(control, 0.5).translator().displacement(), [2.0, 3.0, 0.0]);
    /// ```
    #[must_use]
    pub fn bezier<const N: usize>(mut control: [Self; N], t: S) -> Self {
        const { assert!(N > 0, "a curve needs a control motor") };
        for count in (1..N).rev() {
            for k in 0..count {
                control[k] = control[k].interpolate(control[k + 1], t);
            }
        }
        control[0]
    }

    /// Spherical and quadrangle interpolation (squad), with screws in place of arcs: from one motor
    /// at t = 0 to another at t = 1, pulled towards two control motors in between (Shoemake,
    /// Quaternion calculus and fast animation, SIGGRAPH course notes 10, 1987):
    /// `s(s(M, N, t), s(A, B, t), 2t(1 − t))` with s as [`Motor::interpolate`].
    ///
    /// It starts with the velocity `log(~M N) + 2 log(~M A)` in the frame of the moved body, so
    /// with the controls of [`Motor::squad_control`] pieces of equal duration follow each other
    /// with a continuous velocity. For keys at arbitrary times use
    /// [`MotorSpline`](crate::geometry::motion::MotorSpline). A t that is not finite gives a motor
    /// with coefficients that are not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor};
    /// let rotation =
    ///     |angle: f64| Motor::from(Rotor::from_axis_angle([0.0, 1.0, 0.0], angle).unwrap());
    /// let keys = [0.0, 0.5, 1.5, 2.0].map(rotation);
    /// let from = Motor::squad_control(keys[0], keys[1], keys[2]);
    /// let to = Motor::squad_control(keys[1], keys[2], keys[3]);
    /// let middle = Motor::squad(keys[1], from, to, keys[2], 0.5);
    /// assert!((middle.rotor().to_axis_angle().1 - 1.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn squad(self, self_control: Self, other_control: Self, other: Self, t: S) -> Self {
        let (direct, drawn) = (
            self.interpolate(other, t),
            self_control.interpolate(other_control, t),
        );
        let parabola = (t + t) * (S::one() - t);
        direct.interpolate(drawn, parabola)
    }

    /// The control motor of [`Motor::squad`] beside a key, from the keys before and after it:
    /// `M exp(−¼(log(~M M₋) + log(~M M₊)))`, both logarithms of the shorter rotation. At the first
    /// and the last key, use the key itself.
    #[must_use]
    pub fn squad_control(before: Self, key: Self, after: Self) -> Self {
        let log = |other: Self| {
            let between = key.reverse() * other;
            if between.scalar().less_than(S::zero()) {
                (-between).log()
            } else {
                between.log()
            }
        };
        key * ((log(before) + log(after)) * S::from_ratio(-1, 4)).exp()
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The Bézier curve of N control rotors; see [`Motor::bezier`].
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let rotation = |angle: f64| Rotor::from_axis_angle([0.0, 1.0, 0.0], angle).unwrap();
    /// let middle = Rotor::bezier(
    ///     [rotation(0.0), rotation(0.0), rotation(1.0), rotation(1.0)],
    ///     0.5,
    /// );
    /// assert!((middle.to_axis_angle().1 - 0.5).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn bezier<const N: usize>(control: [Self; N], t: S) -> Self {
        Motor::bezier(control.map(Motor::from), t).rotor()
    }

    /// Spherical and quadrangle interpolation of rotors; see [`Motor::squad`].
    #[must_use]
    pub fn squad(self, self_control: Self, other_control: Self, other: Self, t: S) -> Self {
        let [from, near, far, to] = [self, self_control, other_control, other].map(Motor::from);
        from.squad(near, far, to, t).rotor()
    }

    /// The control rotor of [`Rotor::squad`] beside a key; see [`Motor::squad_control`].
    #[must_use]
    pub fn squad_control(before: Self, key: Self, after: Self) -> Self {
        Motor::squad_control(before.into(), key.into(), after.into()).rotor()
    }
}
