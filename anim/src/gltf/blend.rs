//! The blend of joints whose transforms are affine.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use crate::weights::{Influence, SkinWeights};

/// How the transforms of several joints are combined into that of a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Blend {
    /// The weighted mean of the places to which the joints would take the vertex.
    #[default]
    Linear,
    /// The weighted mean of the joints' motors, after the weighted mean of what scales and shears.
    Motor,
    /// The weighted mean of the joints' motors alone, as L. Kavan, S. Collins, J. Žára and
    /// C. O'Sullivan have it: scale is dropped.
    DualQuaternion,
}

/// Moves vertices by their joints. The error is a joint whose transform has no rotation.
pub(super) fn blend(
    positions: &[Point<f64>],
    weights: &SkinWeights,
    palette: &[Affine<f64>],
    method: Blend,
) -> Result<Vec<Point<f64>>, usize> {
    if method == Blend::Linear {
        let moved = positions.iter().zip(weights.iter());
        return Ok(moved.map(|(&p, row)| mean(row, palette, p)).collect());
    }
    let split = |(joint, &map): (usize, &Affine<f64>)| split(map).ok_or(joint);
    let split: Vec<_> = palette
        .iter()
        .enumerate()
        .map(split)
        .collect::<Result<_, _>>()?;
    let (motors, stretches): (Vec<_>, Vec<_>) = split.into_iter().unzip();
    let moved = positions.iter().zip(weights.iter()).map(|(&p, row)| {
        let weighted = row
            .iter()
            .map(|influence| (influence.weight, motors[influence.joint as usize]));
        let stretched = match method {
            Blend::Motor => mean(row, &stretches, p),
            _ => p,
        };
        let motor = Motor::blend_influences(weighted);
        motor.map_or(stretched, |motor| motor.transform(stretched))
    });
    Ok(moved.collect())
}

fn mean(row: &[Influence], palette: &[Affine<f64>], place: Point<f64>) -> Point<f64> {
    let mut sum = Vector::default();
    for influence in row {
        let image = palette[influence.joint as usize].transform(place);
        sum += Vector::from(image.coordinates()) * influence.weight;
    }
    Point::from(sum)
}

/// The motor and the stretch whose product the map is: L = R S with S symmetric.
fn split(map: Affine<f64>) -> Option<(Motor<f64>, Affine<f64>)> {
    let sign = if map.determinant() < 0.0 { -1.0 } else { 1.0 };
    let linear = map.linear.map(|row| row.map(|x| x * sign));
    let columns = [0, 1, 2].map(|column| linear.map(|row| row[column]));
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // The rotation nearest to L has the greatest trace of ~R L, so it fits the images of the axes
    // weighted by their length.
    let pairs: Vec<(f64, [f64; 3], [f64; 3])> = axes
        .into_iter()
        .zip(columns)
        .map(|(axis, image)| (Vector::from(image).length(), axis, image))
        .collect();
    let rotor = Rotor::from_weighted_direction_pairs(&pairs).ok()?.motion;
    let motor = Translator::from_displacement(map.translation) * rotor;
    let stretch = Affine::from(rotor.reverse()) * Affine::new(map.linear, [0.0; 3]);
    Some((motor, stretch))
}
