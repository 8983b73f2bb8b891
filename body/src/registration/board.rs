//! The two poses of a camera that sees a planar board.
//!
//! A planar board is seen almost alike in two poses (G. Schweighofer and A. Pinz, "Robust pose
//! estimation from a planar target", IEEE Transactions on Pattern Analysis and Machine Intelligence
//! 28, 2006): the board is reflected in the plane through its middle that is perpendicular to the
//! line of sight. With the normal n of the board, its middle b, and the line of sight d from the
//! camera to there, the pose M of the one is the pose M T of the other, with the product T of the
//! reflections in the planes through b with the normals n and d:
//!
//! ```text
//! T = the rotation by 2 ∠(n, d) about the line through b along n × d
//! ```
//!
//! In a world whose board lies on the floor, a camera with the wrong pose is upside down above the
//! floor, and people are below it, with their feet at the floor. Files of cameras do not say where
//! the middle of the board is: it is taken where the rays of joints meet best.

use ga_camera::Camera;
use ga_runtime::cga3::{Direction, Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use crate::Observation;
use crate::gap::median_gap;

/// A camera is upside down where its upper side points downwards by more than this.
const UPSIDE_DOWN: f64 = -0.5;
/// The other poses are taken where rays miss each other by less than this part of what they do in
/// the poses that are given.
const BETTER: f64 = 0.5;
/// How many frames are used at most, spread over all.
const FRAMES: usize = 24;
/// The middle of the board is searched at these distances in metres, so many times to both sides
/// of the origin, and from the best one with half the distance each, until that is small.
const DISTANCE: f64 = 0.25;
const TIMES: i32 = 6;
const SMALL: f64 = 0.005;

/// The cameras, with those in the other pose that are upside down above the plane of two axes of
/// the world, and the numbers of these; `None` where rays do not meet far better so.
pub(crate) fn other_poses(
    cameras: &[Camera],
    observations: &[Observation],
) -> Option<(Vec<Camera>, Vec<usize>)> {
    let every = observations.len().div_ceil(FRAMES).max(1);
    let some: Vec<Observation> = observations.iter().step_by(every).cloned().collect();
    let given = median_gap(cameras, &some)?;
    let axes = [Vector::X, Vector::Y, Vector::Z];
    let found = (0..3).flat_map(|axis| [axes[axis], -axes[axis]].map(|normal| (axis, normal)));
    let found = found.filter_map(|(axis, normal)| {
        let is_above = |camera: &Camera| Vector::from(camera.centre()).dot(normal) > 0.0;
        let views = 0..cameras.len();
        let views = views.filter(|&view| is_upside_down(&cameras[view], normal));
        let views: Vec<usize> = views.collect();
        (!views.is_empty() && cameras.iter().all(is_above)).then(|| {
            let beside = [axes[(axis + 1) % 3], axes[(axis + 2) % 3]];
            let (gap, moved) = best(cameras, &views, normal, beside, &some);
            (gap, moved, views)
        })
    });
    let (gap, moved, views) = found.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (gap < BETTER * given).then_some((moved, views))
}

/// Whether a camera is upside down in a world in which this direction is up.
pub(crate) fn is_upside_down(camera: &Camera, up: Vector<f64>) -> bool {
    let to_world = camera.world_to_camera.reverse();
    let upper_side = to_world.transform(Direction::new(0.0, -1.0, 0.0));
    Vector::from(upper_side.vector()).dot(up) < UPSIDE_DOWN
}

/// The cameras in the other poses for the middle of the board where rays meet best, after how far
/// these then miss each other.
fn best(
    cameras: &[Camera],
    views: &[usize],
    normal: Vector<f64>,
    beside: [Vector<f64>; 2],
    observations: &[Observation],
) -> (f64, Vec<Camera>) {
    let moved = |[u, v]: [f64; 2]| {
        let middle = beside[0] * u + beside[1] * v;
        let mut moved = cameras.to_vec();
        for &view in views {
            moved[view] = other_pose(&cameras[view], normal, middle);
        }
        moved
    };
    let measured = |place: [f64; 2]| {
        let gap = median_gap(&moved(place), observations);
        (gap.unwrap_or(f64::INFINITY), place)
    };
    let around = |middle: [f64; 2], distance: f64, times: i32| {
        let places = (-times..=times).flat_map(|i| (-times..=times).map(move |j| [i, j]));
        let places: Vec<[i32; 2]> = places.collect();
        let places = places
            .par_iter()
            .map(|by| [0, 1].map(|k| middle[k] + distance * f64::from(by[k])));
        let all: Vec<(f64, [f64; 2])> = places.map(measured).collect();
        let least = all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        least.unwrap_or((f64::INFINITY, middle))
    };
    let (mut gap, mut place) = around([0.0; 2], DISTANCE, TIMES);
    let mut distance = 0.5 * DISTANCE;
    while distance > SMALL {
        let near = around(place, distance, 1);
        match near.0 < gap {
            true => (gap, place) = near,
            false => distance *= 0.5,
        }
    }
    (gap, moved(place))
}

/// The other pose in which a camera sees a board with this normal and middle almost alike.
fn other_pose(camera: &Camera, normal: Vector<f64>, middle: Vector<f64>) -> Camera {
    let sight = middle - Vector::from(camera.centre());
    let axis = normal.cross(sight);
    let angle = 2.0 * axis.length().atan2(normal.dot(sight));
    // Straight above the board both poses are one.
    let rotor = Rotor::from_axis_angle(axis.into(), angle).unwrap_or_default();
    let [there, back] = [middle, -middle].map(|way| Translator::from_displacement(way.into()));
    let turned: Motor<f64> = there * rotor * back;
    Camera {
        world_to_camera: camera.world_to_camera * turned,
        ..*camera
    }
}
