//! What the paper computes with the joints and the depth that were found, for which the program has
//! no command: the leg both ways, modelling points at several levels, and weights by distance.

use anyhow::{Context as _, Result};
use ga_anim::character::Character;
use ga_anim::distance_weights::distance_weights;
use ga_anim::leg::Leg;
use ga_camera::rig::RectifiedRig;
use ga_image::plane::Plane;
use ga_runtime::cga3::Point;
use ga_vision::disparity::DisparityMap;
use ga_vision::modelling_points::{DistanceControls, ModellingPyramid};
use serde::Serialize;

/// The joints of the mannequin's left leg, from above.
pub(super) const LEG: [&str; 3] = ["LeftUpperLeg", "LeftLowerLeg", "LeftFoot"];
/// Levels of modelling points.
const LEVELS: usize = 6;
/// The standard deviation of the disparity of a pixel.
const PIXEL_DEVIATION: f64 = 0.25;
/// What eq. 2 leaves open.
const CONTROLS: DistanceControls = DistanceControls {
    position: 10.0,
    direction: 1.0,
    constant: 0.5,
};
/// The numbers of bones and of the descent that eq. 33 has.
const INFLUENCES: usize = 4;
const DESCENT: f64 = 4.0;

/// A leg solved backwards, from its ends to its angles, and forwards again.
#[derive(Clone, Debug, Serialize)]
pub(super) struct LegBothWays {
    pub(super) thigh_metres: f64,
    pub(super) calf_metres: f64,
    /// √(−2 P₀ · P₂).
    pub(super) hip_to_ankle_metres: f64,
    /// About z, y and x at the hip, and at the knee.
    pub(super) angles_degrees: [f64; 4],
    /// From the ankle that the angles lead to, to the one that was given.
    pub(super) ankle_error_metres: f64,
    /// From the knee that the angles lead to, to the one that the films show.
    pub(super) knee_error_millimetres: f64,
}

impl LegBothWays {
    /// The leg of a hip, a knee and an ankle.
    pub(super) fn new([hip, knee, ankle]: [Point<f64>; 3]) -> Result<Self> {
        let (thigh, calf) = (hip.distance(knee), knee.distance(ankle));
        let leg = Leg::new(thigh, calf, 0.2)?;
        let angles = leg.reach(hip, ankle, knee)?;
        let pose = leg.forward(hip, &angles)?;
        let all = [angles.hip_z, angles.hip_y, angles.hip_x, angles.knee];
        Ok(Self {
            thigh_metres: thigh,
            calf_metres: calf,
            hip_to_ankle_metres: hip.distance(ankle),
            angles_degrees: all.map(f64::to_degrees),
            ankle_error_metres: pose.ankle.distance(ankle),
            knee_error_millimetres: 1e3 * pose.knee.distance(knee),
        })
    }
}

/// The modelling points of a level.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Level {
    pub(super) level: usize,
    pub(super) points: usize,
    /// Of the point in the middle of the picture.
    pub(super) disparity_px: f64,
    pub(super) depth_metres: f64,
    pub(super) depth_deviation_metres: f64,
    /// K of eq. 2.
    pub(super) predicted_distance: f64,
}

/// The modelling points of a map at all levels.
pub(super) fn levels(map: &DisparityMap, rig: &RectifiedRig) -> Result<Vec<Level>> {
    let weights = Plane::filled(map.width(), map.height(), 1.0);
    let pyramid = ModellingPyramid::new(map, &weights, LEVELS, PIXEL_DEVIATION)?;
    let levels = (0..pyramid.levels()).map(|level| {
        let [columns, rows] = pyramid.size(level);
        let middle = [columns / 2, rows / 2];
        // The nearest cell to the middle that has a point.
        let apart = |cell: [usize; 2]| {
            let [x, y] = [0, 1].map(|k| cell[k].abs_diff(middle[k]));
            x * x + y * y
        };
        let points = pyramid.points(level);
        let nearest = points.min_by_key(|point| apart(point.cell));
        let point = nearest.context("no pixel has a disparity")?;
        let place = point.place(rig).context("a modelling point has no depth")?;
        Ok(Level {
            level,
            points: pyramid.points(level).count(),
            disparity_px: point.disparity_px,
            depth_metres: place.depth,
            depth_deviation_metres: place.depth_deviation,
            predicted_distance: point.predicted_distance(CONTROLS)?,
        })
    });
    levels.collect()
}

/// The weights of eq. 33 beside those of a character.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Weights {
    pub(super) influences: usize,
    pub(super) descent: f64,
    pub(super) vertices: usize,
    /// The part of vertices that follow the same bone most.
    pub(super) same_strongest: f64,
    /// Half the sum of the differences of all weights of a vertex, as a mean.
    pub(super) mean_difference: f64,
}

impl Weights {
    pub(super) fn new(character: &Character) -> Result<Self> {
        let joints = character.skeleton.joints();
        let bones: Vec<_> = joints
            .iter()
            .map(|joint| [joint.head, joint.tail])
            .collect();
        let points = character.mesh.coordinates();
        let weights = distance_weights(points, &bones, INFLUENCES, DESCENT)?;
        let vertices = character.mesh.vertex_count();
        let (mut same, mut difference) = (0, 0.0);
        for vertex in 0..vertices {
            let both = [&weights, &character.weights].map(|weights| {
                let mut all = vec![0.0; bones.len()];
                for influence in weights.influences(vertex) {
                    all[influence.joint as usize] += influence.weight;
                }
                all
            });
            let strongest = both.each_ref().map(|all| {
                let order = |a: &usize, b: &usize| all[*a].total_cmp(&all[*b]);
                (0..all.len()).max_by(order)
            });
            same += usize::from(strongest[0] == strongest[1]);
            let apart = both[0].iter().zip(&both[1]).map(|(a, b)| (a - b).abs());
            difference += 0.5 * apart.sum::<f64>();
        }
        let count = vertices.max(1) as f64;
        Ok(Self {
            influences: INFLUENCES,
            descent: DESCENT,
            vertices,
            same_strongest: same as f64 / count,
            mean_difference: difference / count,
        })
    }
}
