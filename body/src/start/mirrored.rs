//! Poses that one view hardly tells from a given one.
//!
//! The ray on which a camera sees the end of a bone meets the sphere around its other end twice: at
//! a bone that points towards the camera, and at one that points away from it. Each bone gives
//! another pose like that (C. Sminchisescu, B. Triggs, "Kinematic jump processes for monocular 3D
//! human tracking", CVPR 2003).

use ga_camera::Camera;
use ga_runtime::vga3::Vector;

use super::Start;
use super::assembly::{assemble, depth_below};
use super::depths::Places;
use super::links::Links;
use crate::chain::Chain;

/// The points of a body with one bone mirrored, for each bone with one end, and with all of them
/// mirrored, as starts.
///
/// What is below a bone moves with its end and keeps its direction.
pub(crate) fn mirrored(
    chain: &Chain<'_>,
    links: &Links,
    camera: &Camera,
    points: &[Vector<f64>],
) -> Vec<Start> {
    let bones = (0..chain.columns.len()).filter_map(|joint| {
        let end = only_end(chain, links, joint)?;
        let head = chain.model.skeleton().joints()[joint].head;
        let head = (0..points.len()).find(|&p| chain.model.points()[p].at_rest == head)?;
        let way = to_other_side(camera, points[head], points[end])?;
        let is_below = |point: usize| {
            let pivot = links.pivots[point];
            pivot.is_some_and(|pivot| depth_below(chain, pivot, joint).is_some())
        };
        let moved = (0..points.len()).map(|point| {
            let way = if is_below(point) {
                way
            } else {
                Vector::default()
            };
            Some(points[point] + way)
        });
        Some(moved.collect())
    });
    let sum = points
        .iter()
        .fold(Vector::default(), |sum, place| sum + *place);
    let middle = sum / points.len() as f64;
    let all = points
        .iter()
        .map(|place| Some(*place + to_other_side(camera, middle, *place)?));
    let starts = bones.chain([all.collect()]);
    let starts = starts.filter_map(|points: Vec<Option<Vector<f64>>>| {
        let state = assemble(chain, links, &points)?;
        let wrong = Vec::new();
        let places = Some(Places { points, wrong });
        Some(Start { state, places })
    });
    starts.collect()
}

/// The point that rotates about a joint, where it is the only one.
fn only_end(chain: &Chain<'_>, links: &Links, joint: usize) -> Option<usize> {
    if chain.columns[joint].count == 0 || chain.is_root(joint) {
        return None;
    }
    let mut about = (0..links.pivots.len()).filter(|&point| links.pivots[point] == Some(joint));
    let end = about.next()?;
    about.next().is_none().then_some(end)
}

/// The way along the ray of a point to where it is as far from another one.
fn to_other_side(camera: &Camera, from: Vector<f64>, to: Vector<f64>) -> Option<Vector<f64>> {
    let ray = to - Vector::from(camera.centre());
    let squared = ray.length_squared();
    (squared > 0.0).then(|| ray * (-2.0 * (to - from).dot(ray) / squared))
}
