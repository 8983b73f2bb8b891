//! Markers as thin discs that lie on the skin, for characters whose skin cannot be painted.

use ga_anim::MotionFileError;
use ga_anim::character::Character;
use ga_anim::weights::SkinWeights;
use ga_mesh::{CornerAttribute, Faces, Mesh};
use rayon::prelude::*;

use super::marker::Marker;
use super::skin::{Place, Skin};
use crate::Vector;

/// How far a disc is above the skin, in metres.
pub const DISC_LIFT: f64 = 0.001;
/// Rings of a disc about its centre, and the points of a ring.
const RINGS: usize = 4;
const SIDES: usize = 24;

/// A character with a disc for each marker, which lies on its skin and moves with it; and which of
/// the markers have none, as on a skin without triangles.
///
/// The texture coordinates are those that are given: of each disc, and of all the rest.
///
/// # Errors
/// [`MotionFileError::Mesh`] past 2³² − 1 vertices, and for coordinates that are not finite.
pub fn with_discs(
    character: &Character,
    discs: &[(&Marker, [f64; 2])],
    elsewhere: [f64; 2],
) -> Result<(Character, Vec<usize>), MotionFileError> {
    let Character {
        mesh,
        skeleton,
        weights,
    } = character;
    let mut positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let mut triangles = mesh.triangles();
    let influences = weights.iter().map(|influences| {
        let pairs = influences.iter();
        pairs
            .map(|influence| (influence.joint, influence.weight))
            .collect()
    });
    let mut rows: Vec<Vec<(u32, f64)>> = influences.collect();
    let mut coordinates = vec![elsewhere; positions.len()];
    let mut left_out = Vec::new();
    if let Some(skin) = Skin::new(mesh, skeleton, weights) {
        let points = discs.par_iter().map(|(marker, _)| skin.points(marker));
        let points: Vec<Option<Vec<Place>>> = points.collect();
        for (index, (points, (_, place))) in points.into_iter().zip(discs).enumerate() {
            let Some(points) = points else {
                left_out.push(index);
                continue;
            };
            let first = positions.len() as u32;
            triangles.extend(disc().map(|corners| corners.map(|corner| first + corner)));
            for point in points {
                let raised = point.position + point.normal * DISC_LIFT;
                positions.push(raised.coordinates());
                coordinates.push(*place);
                let shares = (0..).zip(point.weights);
                rows.push(shares.filter(|(_, weight)| *weight > 0.0).collect());
            }
        }
    } else {
        left_out.extend(0..discs.len());
    }
    let mesh = Mesh::new(positions, Faces::from_uniform(triangles)?)?;
    let coordinates = CornerAttribute::of_vertices(coordinates, mesh.faces());
    let dotted = Character {
        mesh: mesh.with_texture_coordinates(vec![coordinates])?,
        skeleton: skeleton.clone(),
        weights: SkinWeights::new(skeleton.len(), rows)?,
    };
    Ok((dotted, left_out))
}

impl Skin<'_> {
    /// The points of a disc on the skin: the centre, then ring by ring outwards, each
    /// counterclockwise about the normal.
    fn points(&self, marker: &Marker) -> Option<Vec<Place>> {
        let (centre, normal) = (Vector::from(marker.centre), Vector::from(marker.normal));
        let across = normal.cross(Vector::new(0.3, 0.5, 0.8)).normalized()?;
        let depth = normal.cross(across);
        let mut points = vec![self.nearest(centre)?];
        for ring in 1..=RINGS {
            let radius = marker.radius * ring as f64 / RINGS as f64;
            for side in 0..SIDES {
                let (sin, cos) = (std::f64::consts::TAU * side as f64 / SIDES as f64).sin_cos();
                let point = self.at_distance(centre, across * cos + depth * sin, radius)?;
                points.push(self.nearest(point)?);
            }
        }
        Some(points)
    }
}

/// The triangles of a disc by its points.
fn disc() -> impl Iterator<Item = [u32; 3]> {
    let at = |ring: usize, side: usize| (1 + (ring - 1) * SIDES + side % SIDES) as u32;
    let fan = (0..SIDES).map(move |side| [0, at(1, side), at(1, side + 1)]);
    let rings = (1..RINGS).flat_map(move |ring| {
        (0..SIDES).flat_map(move |side| {
            let [a, b] = [at(ring, side), at(ring, side + 1)];
            let [c, d] = [at(ring + 1, side), at(ring + 1, side + 1)];
            [[a, c, d], [a, d, b]]
        })
    });
    fan.chain(rings)
}
