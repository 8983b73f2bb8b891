//! Euler angles.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::cga3::Rotor;
use crate::geometry::number::are_numbers;
use crate::scalar::Real;
use crate::vga3::Vector;

/// The axes of three rotations, in the order in which their angles are listed.
///
/// Six orders have three different axes (Tait–Bryan angles), six have the first axis again as the
/// third (proper Euler angles). Each can be read in two ways:
///
/// - *intrinsic*: each rotation is about an axis of the frame that the rotations before it have
///   moved, `R = R₁ R₂ R₃`: [`Rotor::from_euler`], [`Rotor::to_euler`];
/// - *extrinsic*: each rotation is about a fixed axis, `R = R₃ R₂ R₁`:
///   [`Rotor::from_euler_extrinsic`], [`Rotor::to_euler_extrinsic`].
///
/// Yaw, pitch and roll of an aircraft, with x forwards and z down, are the intrinsic angles of
/// [`Zyx`](Self::Zyx).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EulerOrder {
    /// About x, then y, then z.
    Xyz,
    /// About x, then z, then y.
    Xzy,
    /// About y, then x, then z.
    Yxz,
    /// About y, then z, then x.
    Yzx,
    /// About z, then x, then y.
    Zxy,
    /// About z, then y, then x.
    Zyx,
    /// About x, then y, then x.
    Xyx,
    /// About x, then z, then x.
    Xzx,
    /// About y, then x, then y.
    Yxy,
    /// About y, then z, then y.
    Yzy,
    /// About z, then x, then z.
    Zxz,
    /// About z, then y, then z.
    Zyz,
}

impl EulerOrder {
    /// All twelve orders.
    pub const ALL: [Self; 12] = [
        Self::Xyz,
        Self::Xzy,
        Self::Yxz,
        Self::Yzx,
        Self::Zxy,
        Self::Zyx,
        Self::Xyx,
        Self::Xzx,
        Self::Yxy,
        Self::Yzy,
        Self::Zxz,
        Self::Zyz,
    ];

    /// The three axes, 0 for x, 1 for y, 2 for z.
    #[must_use]
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Zyx => [2, 1, 0],
            Self::Xyx => [0, 1, 0],
            Self::Xzx => [0, 2, 0],
            Self::Yxy => [1, 0, 1],
            Self::Yzy => [1, 2, 1],
            Self::Zxz => [2, 0, 2],
            Self::Zyz => [2, 1, 2],
        }
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation with the given intrinsic Euler angles in radians, `R = R₁ R₂ R₃`: about the
    /// first axis, then about the second axis as moved by the first rotation, then about the third
    /// as moved by both. `None` where an angle is not finite.
    ///
    /// ```
    /// use ga_runtime::{cga3::Rotor, geometry::EulerOrder};
    /// let (yaw, pitch, roll) = (0.3_f64, -0.2, 0.1);
    /// let rotor = Rotor::from_euler(EulerOrder::Zyx, [yaw, pitch, roll]).unwrap();
    /// let about = |axis, angle| Rotor::from_axis_angle(axis, angle).unwrap();
    /// let product = about([0.0, 0.0, 1.0], yaw)
    ///     * about([0.0, 1.0, 0.0], pitch)
    ///     * about([1.0, 0.0, 0.0], roll);
    /// assert_eq!(rotor, product);
    /// let again = rotor.to_euler(EulerOrder::Zyx);
    /// assert!((again[0] - yaw).abs() < 1e-15 && (again[1] - pitch).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_euler(order: EulerOrder, angles: [S; 3]) -> Option<Self> {
        if !are_numbers(angles) {
            return None;
        }
        let [i, j, k] = order.axes();
        let [a, b, c] = angles;
        Some(about_axis(i, a) * about_axis(j, b) * about_axis(k, c))
    }

    /// The rotation with the given extrinsic Euler angles in radians, `R = R₃ R₂ R₁`: about the
    /// first axis, then the second, then the third, all of them fixed. It is the intrinsic one with
    /// the axes and the angles in reverse order. `None` where an angle is not finite.
    #[must_use]
    pub fn from_euler_extrinsic(order: EulerOrder, angles: [S; 3]) -> Option<Self> {
        if !are_numbers(angles) {
            return None;
        }
        let [i, j, k] = order.axes();
        let [a, b, c] = angles;
        Some(about_axis(k, c) * about_axis(j, b) * about_axis(i, a))
    }

    /// The intrinsic Euler angles of the rotation in radians, for
    /// [`from_euler`](Self::from_euler). The first and the third are in [−π, π]; the second is in
    /// [−½π, ½π] for three different axes, in [0, π] where the first axis is also the third. A
    /// rotor and its negative have the same angles. NaN stays NaN.
    ///
    /// At an end of the second angle's range only the sum or the difference of the other two is
    /// defined (gimbal lock). There, within 16 ε, the third angle is zero; close to there the other
    /// two are ill-conditioned, but the rotation that all three give is not.
    ///
    /// The formula takes sums and differences of the outer angles from the quaternion (Bernardes
    /// and Viollet, Quaternion to Euler angles conversion, PLoS ONE 17, 2022).
    ///
    /// ```
    /// use ga_runtime::{cga3::Rotor, geometry::EulerOrder};
    /// use std::f64::consts::FRAC_PI_2;
    /// let lock = Rotor::from_euler(EulerOrder::Xyz, [0.3_f64, FRAC_PI_2, 0.5]).unwrap();
    /// let [x, y, z] = lock.to_euler(EulerOrder::Xyz);
    /// assert!((x - 0.8).abs() < 1e-15 && (y - FRAC_PI_2).abs() < 1e-15 && z == 0.0);
    /// ```
    #[must_use]
    pub fn to_euler(self, order: EulerOrder) -> [S; 3] {
        let [i, j, k] = order.axes();
        let [a, b, c] = extrinsic_angles(self, [k, j, i], Outer::First);
        [c, b, a]
    }

    /// The extrinsic Euler angles of the rotation in radians, for
    /// [`from_euler_extrinsic`](Self::from_euler_extrinsic), with the ranges and the choice at
    /// gimbal lock of [`to_euler`](Self::to_euler).
    #[must_use]
    pub fn to_euler_extrinsic(self, order: EulerOrder) -> [S; 3] {
        extrinsic_angles(self, order.axes(), Outer::Third)
    }
}

/// The rotation by an angle about a coordinate axis.
fn about_axis<S: Real<Mask = bool>>(axis: usize, angle: S) -> Rotor<S> {
    let (sine, cosine) = (angle * S::from_ratio(1, 2)).sin_cos();
    let zero = S::zero();
    match axis {
        0 => Rotor::new_unchecked(cosine, zero, zero, -sine),
        1 => Rotor::new_unchecked(cosine, zero, sine, zero),
        _ => Rotor::new_unchecked(cosine, -sine, zero, zero),
    }
}

/// Which of the outer angles is zero at gimbal lock.
#[derive(Clone, Copy, PartialEq)]
enum Outer {
    First,
    Third,
}

/// For rotations about axes i, j, i, the quaternion is `cos ½β (cos σ + sin σ i)` +
/// `sin ½β (cos δ j + sin δ i j)`, where σ and δ are half the sum and half the difference of the
/// outer angles, third less first. Three different axes are reduced to that by a quarter turn about
/// j.
fn extrinsic_angles<S: Real<Mask = bool>>(
    rotor: Rotor<S>,
    axes: [usize; 3],
    lock: Outer,
) -> [S; 3] {
    let (vector, w) = rotor.to_quaternion();
    let [i, j, last] = axes;
    let is_proper = i == last;
    let k = 3 - i - j;
    // Whether i, j, k is a cyclic permutation of x, y, z, so that i j = k.
    let is_even = (i + 1) % 3 == j;
    let (x, y) = (vector[i], vector[j]);
    let z = if is_even { vector[k] } else { -vector[k] };
    let [a, b, c, d] = if is_proper {
        [w, x, y, z]
    } else {
        [w - y, x + z, y + w, z - x]
    };
    let [of_sum, of_difference] =
        [(a, b), (c, d)].map(|(a, b)| Vector::new(a, b, S::zero()).length());
    let half_middle = of_difference.atan2(of_sum);
    let least = S::epsilon() * S::from_integer(16);
    let (mut sum, mut difference) = (b.atan2(a), d.atan2(c));
    let sign = if lock == Outer::Third {
        -S::one()
    } else {
        S::one()
    };
    if of_difference.less_than(least) {
        difference = sum * sign;
    } else if of_sum.less_than(least) {
        sum = difference * sign;
    }
    let middle = half_middle + half_middle;
    let (first, third) = (wrapped(sum - difference), wrapped(sum + difference));
    if is_proper {
        return [first, middle, third];
    }
    let third = if is_even { third } else { -third };
    [first, middle - S::from_f64(FRAC_PI_2), third]
}

/// An angle between −2π and 2π, brought into [−π, π].
fn wrapped<S: Real<Mask = bool>>(angle: S) -> S {
    let half = S::from_f64(PI);
    if half.less_than(angle) {
        angle - (half + half)
    } else if angle.less_than(-half) {
        angle + (half + half)
    } else {
        angle
    }
}
