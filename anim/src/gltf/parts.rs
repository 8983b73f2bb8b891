//! Frames of nodes as translations, rotations and factors.

use ga_mesh::gltf::Transform as NodeTransform;
use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::LocalFrame;
use crate::transform::Transform;

/// A frame with any factors; `None` for a matrix that has none.
pub(crate) fn parts(frame: &LocalFrame) -> Option<Transform<f64>> {
    // Files write matrices in single precision, some with few digits.
    const TOLERANCE: f64 = 1e-5;
    let map = match frame {
        LocalFrame::Parts(parts) => return Some(*parts),
        LocalFrame::Matrix(map) => *map,
    };
    let column = |column: usize| Vector::from(map.linear.map(|row| row[column]));
    let mut factors = [0, 1, 2].map(|axis| column(axis).length());
    if map.determinant() < 0.0 {
        factors[0] = -factors[0];
    }
    with_factors(map, factors.into(), TOLERANCE)
}

/// A frame whose matrix, where it has one, scales uniformly.
pub(crate) fn uniform_parts(frame: &LocalFrame) -> Option<Transform<f64>> {
    match frame {
        LocalFrame::Parts(parts) => Some(*parts),
        LocalFrame::Matrix(map) => uniform(*map),
    }
}

/// The transform of a map that translates, rotates and scales uniformly, up to what files do that
/// write factors in single precision, some with few digits.
pub(crate) fn uniform(map: Affine<f64>) -> Option<Transform<f64>> {
    uniform_within(map, 1e-4)
}

/// As [`uniform`], up to a part of the factor.
pub(crate) fn uniform_within(map: Affine<f64>, tolerance: f64) -> Option<Transform<f64>> {
    let factor = map.determinant().cbrt();
    let factors = Vector::new(factor, factor, factor);
    let transform = || with_factors(map, factors, tolerance);
    // A mirrored map has no rotation.
    (factor > 0.0).then(transform).flatten()
}

/// The transform that a map is, with these factors: L = R diag(s), up to a part of the largest.
fn with_factors(map: Affine<f64>, factors: Vector<f64>, tolerance: f64) -> Option<Transform<f64>> {
    let pairs = [0, 1, 2].map(|axis| {
        let mut from = [0.0; 3];
        from[axis] = factors[axis].signum();
        (from, map.linear.map(|row| row[axis]))
    });
    let rotor = Rotor::from_direction_pairs(&pairs).ok()?.motion;
    let transform = Transform::from_parts(map.translation.into(), rotor, factors);
    let found = transform.to_affine().linear;
    let numbers = found.as_flattened().iter().zip(map.linear.as_flattened());
    let error = numbers.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let size = factors.abs().coordinates().into_iter().fold(0.0, f64::max);
    (error <= tolerance * size).then_some(transform)
}

/// A transform as that of a node.
pub(crate) fn to_node(local: &Transform<f64>) -> NodeTransform {
    let single = |v: Vector<f64>| v.coordinates().map(|x| x as f32);
    NodeTransform::Decomposed {
        translation: single(local.translation()),
        rotation: quaternion(local.rotor(), None),
        scale: single(local.scale),
    }
}

/// The quaternion of a rotor, with the sign that is nearer to the one before.
pub(crate) fn quaternion(rotor: Rotor<f64>, before: Option<&[f32; 4]>) -> [f32; 4] {
    let ([x, y, z], w) = rotor.to_quaternion();
    let key = [x, y, z, w].map(|x| x as f32);
    let along = before.map_or(1.0, |before| {
        before.iter().zip(key).map(|(a, b)| a * b).sum::<f32>()
    });
    if along < 0.0 { key.map(|x| -x) } else { key }
}
