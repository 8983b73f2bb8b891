use ga_mesh::gltf::Skin;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::placement::inverse_bind_map;
use super::player::LocalFrame;
use super::{NodePose, Player};
use crate::file_error::MotionFileError;

/// The nodes of a document in the pose in which its skins were bound, which need not be the one in
/// which the nodes stand: files are saved in the middle of an animation.
///
/// With the inverse bind matrix B of a joint and the frame F of its node, `F B` takes the mesh to
/// the world, and is the same map C for all joints in the pose at rest (glTF 2.0, 3.7.3). C is the
/// map that is nearest to those of all joints of a skin. A joint that is elsewhere gets the frame
/// `C B⁻¹`; all other nodes keep their frames relative to their parents.
///
/// # Errors
///
/// Those of [`Player::pose`].
pub(crate) fn bind_pose(player: &Player) -> Result<NodePose, MotionFileError> {
    let document = player.document();
    let mut pose = player.pose(None, 0.0)?;
    let mut bound: Vec<Option<Affine<f64>>> = vec![None; document.nodes.len()];
    let mut is_moved = false;
    for skin in document.nodes.iter().filter_map(|node| node.skin) {
        for (node, map) in bound_joints(&document.skins[skin], &pose) {
            is_moved |= map.is_some();
            bound[node] = map.or(bound[node]).or(Some(pose.world[node]));
        }
    }
    if !is_moved {
        return Ok(pose);
    }
    let before = pose.world.clone();
    for &node in player.parents_before_children() {
        let parent = player.parents()[node];
        let above = parent.map_or_else(Affine::default, |parent| pose.world[parent]);
        let is_above_kept = parent.is_none_or(|parent| above == before[parent]);
        match bound[node] {
            Some(frame) if !(is_above_kept && frame == before[node]) => {
                let Some(back) = above.inverse() else {
                    continue;
                };
                pose.locals[node] = LocalFrame::Matrix(back * frame);
                pose.world[node] = frame;
            }
            _ => pose.world[node] = above * pose.locals[node].to_affine(),
        }
    }
    Ok(pose)
}

/// The joints of a skin, and the frame in which each one was bound where it is elsewhere.
fn bound_joints(skin: &Skin, pose: &NodePose) -> Vec<(usize, Option<Affine<f64>>)> {
    let joints = skin.joints.iter().zip(&skin.inverse_bind_matrices);
    let maps: Vec<(usize, Affine<f64>, Affine<f64>)> = joints
        .map(|(&node, inverse)| {
            let inverse = inverse_bind_map(inverse);
            (node, inverse, pose.world[node] * inverse)
        })
        .collect();
    let places = maps
        .iter()
        .map(|&(node, _, _)| Vector::from(pose.world[node].translation));
    let bounds = places.fold(None, |bounds: Option<[Vector<f64>; 2]>, place| {
        let [low, high] = bounds.unwrap_or([place; 2]);
        Some([low.min(place), high.max(place)])
    });
    let extent = bounds.map_or(0.0, |[low, high]| low.distance(high));
    let sum = |map: &Affine<f64>| {
        let distances = maps
            .iter()
            .map(|(_, _, other)| distance(map, other, extent));
        distances.sum::<f64>()
    };
    let sums = maps.iter().map(|(_, _, map)| (sum(map), *map));
    let Some((_, common)) = sums.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return Vec::new();
    };
    /// What rounding to single precision makes of matrices that are equal.
    const NEAR: f64 = 1e-3;
    maps.into_iter()
        .map(|(node, inverse, map)| {
            let is_elsewhere = distance(&map, &common, extent) > NEAR;
            let frame = inverse.inverse().filter(|_| is_elsewhere);
            (node, frame.map(|back| common * back))
        })
        .collect()
}

/// How unlike two maps are: in their linear parts relative to the size of these, and in their
/// translations relative to the extent of the joints.
fn distance(a: &Affine<f64>, b: &Affine<f64>, extent: f64) -> f64 {
    let [linear, size] = [
        |a: &f64, b: &f64| (a - b).powi(2),
        |a: &f64, b: &f64| a * a + b * b,
    ]
    .map(|term| {
        let entries = a.linear.as_flattened().iter().zip(b.linear.as_flattened());
        entries.map(|(a, b)| term(a, b)).sum::<f64>().sqrt()
    });
    let apart = Vector::from(a.translation).distance(b.translation.into());
    linear / size.max(f64::MIN_POSITIVE) + apart / extent.max(f64::MIN_POSITIVE)
}
