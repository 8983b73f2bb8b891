//! What is constant in a clip, joint by joint, and which channels change.

use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, SymmetricEigen, Vector3};

use crate::transform::Transform;

/// A vector that changes along some of its principal axes,
///
/// ```text
/// v = constant + Σ u_k a_k,   k < live,
/// ```
///
/// where the a_k are the columns of a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    pub(super) constant: Vector<f32>,
    pub(super) live: usize,
    /// The rotation that takes the coordinate axes to the principal axes; the identity where `live`
    /// is 0.
    pub(super) axes: Rotor<f32>,
}

impl Part {
    pub(super) fn constant(value: Vector<f64>) -> Self {
        Self {
            constant: single(value),
            live: 0,
            axes: Rotor::default(),
        }
    }

    /// The principal axes of `deviations`, with those left out along which no deviation is greater
    /// than `negligible`.
    pub(super) fn of_deviations(
        constant: Vector<f64>,
        deviations: &[[f64; 3]],
        negligible: f64,
    ) -> Self {
        let still = Self::constant(constant);
        let greatest = deviations
            .iter()
            .map(|d| Vector::from(*d).length())
            .fold(0.0, f64::max);
        if greatest <= negligible {
            return still;
        }
        let axes = principal_axes(deviations);
        let along = |axis: usize| {
            let axis = Vector::from(axes[axis]);
            let lengths = deviations.iter().map(|d| Vector::from(*d).dot(axis).abs());
            lengths.fold(0.0, f64::max)
        };
        let columns = [0, 1, 2].map(|row| [axes[0][row], axes[1][row], axes[2][row]]);
        let rotor = Rotor::from_matrix(columns).unwrap_or_default();
        let live = (0..3).rev().find(|&axis| along(axis) > negligible);
        Self {
            axes: single_rotor(rotor),
            live: live.map_or(0, |axis| axis + 1),
            ..still
        }
    }

    /// The axes a_k.
    pub(super) fn directions(&self) -> [Vector<f64>; 3] {
        let rows = double_rotor(self.axes).to_matrix();
        [0, 1, 2].map(|k| rows.map(|row| row[k]).into())
    }
}

/// Unit vectors along the principal axes of deviations from 0, the greatest first, right-handed.
fn principal_axes(deviations: &[[f64; 3]]) -> [[f64; 3]; 3] {
    let mut moments = Matrix3::<f64>::zeros();
    for &deviation in deviations {
        let deviation = Vector3::from(deviation);
        moments += deviation * deviation.transpose();
    }
    let eigen = SymmetricEigen::new(moments);
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let axis = |k: usize| Vector::from(<[f64; 3]>::from(eigen.eigenvectors.column(order[k])));
    let (first, second) = (axis(0), axis(1));
    [first, second, first.cross(second)].map(Vector::coordinates)
}

/// The constants of a joint, and how many channels each part of its transform has.
///
/// The rotation is `constant * (1 + B)² / (1 + |B|²)` with the bivector B = tan(θ/4) I of the
/// rotation by θ in the plane of the unit bivector I, the stereographic projection of rotors, also
/// called modified Rodrigues parameters. It needs no trigonometric function, and its values are
/// bounded by 1 as any rotation is one by at most a half turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointLayout {
    pub(super) parent: Option<usize>,
    pub(super) translation: Part,
    pub(super) scale: Part,
    /// The channels of B.
    pub(super) rotation: Part,
    /// The rotation at B = 0.
    pub(super) middle: Rotor<f32>,
}

impl JointLayout {
    /// How many channels change.
    pub(super) fn channels(&self) -> usize {
        self.translation.live + self.scale.live + self.rotation.live
    }

    /// Whether the transform is the same in every frame.
    pub(super) fn is_still(&self) -> bool {
        self.channels() == 0
    }
}

/// The bivector B of a rotor in the order e12, e13, e23. It is bounded where the rotor's scalar is
/// not near −1.
pub(super) fn stereographic(rotor: Rotor<f64>) -> [f64; 3] {
    let scale = (1.0 + rotor.scalar()).recip();
    [rotor.e12(), rotor.e13(), rotor.e23()].map(|x| x * scale)
}

/// The rotor of a bivector B.
pub(super) fn from_stereographic(b: Vector<f64>) -> Rotor<f64> {
    let square = b.length_squared();
    let scale = (1.0 + square).recip();
    let [e12, e13, e23] = (b * (2.0 * scale)).coordinates();
    Rotor::new_unchecked((1.0 - square) * scale, e12, e13, e23)
}

/// The rotor in the middle of others: their mean, whatever their signs.
pub(super) fn middle(rotors: impl Iterator<Item = Rotor<f64>> + Clone) -> Rotor<f64> {
    let mut middle = rotors.clone().next().unwrap_or_default();
    for _ in 0..4 {
        let mut sum = [0.0; 4];
        for rotor in rotors.clone() {
            let rotor = coefficients(rotor);
            let sign = dot4(rotor, coefficients(middle)).signum();
            for (sum, x) in sum.iter_mut().zip(rotor) {
                *sum += sign * x;
            }
        }
        let length = dot4(sum, sum).sqrt();
        if length < 1e-9 {
            return middle;
        }
        let [s, e12, e13, e23] = sum.map(|x| x / length);
        middle = Rotor::new_unchecked(s, e12, e13, e23);
    }
    middle
}

/// B of the rotation in steps of 2⁻¹⁵ or so: a rotor of six bytes instead of sixteen.
pub(super) fn to_steps(rotor: Rotor<f32>) -> [i16; 3] {
    stereographic(double_rotor(rotor).canonical()).map(|b| (b * STEPS).round() as i16)
}

/// The rotor of [`to_steps`].
pub(super) fn from_steps(steps: [i16; 3]) -> Rotor<f32> {
    let b = steps.map(|step| f64::from(step) / STEPS);
    single_rotor(from_stereographic(b.into()))
}

const STEPS: f64 = 32_767.0;

pub(super) fn coefficients(rotor: Rotor<f64>) -> [f64; 4] {
    [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()]
}

pub(super) fn dot4(a: [f64; 4], b: [f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn single(v: Vector<f64>) -> Vector<f32> {
    v.coordinates().map(|x| x as f32).into()
}

pub(super) fn double(v: Vector<f32>) -> Vector<f64> {
    v.coordinates().map(f64::from).into()
}

pub(super) fn single_rotor(rotor: Rotor<f64>) -> Rotor<f32> {
    let [s, e12, e13, e23] = coefficients(rotor).map(|x| x as f32);
    Rotor::new_unchecked(s, e12, e13, e23)
}

pub(super) fn double_rotor(rotor: Rotor<f32>) -> Rotor<f64> {
    let parts = [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()];
    let [s, e12, e13, e23] = parts.map(f64::from);
    Rotor::new_unchecked(s, e12, e13, e23)
}

pub(crate) fn double_transform(transform: &Transform<f32>) -> Transform<f64> {
    Transform::from_parts(
        double(transform.translation()),
        double_rotor(transform.rotor()),
        double(transform.scale),
    )
}
