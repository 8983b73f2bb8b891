//! The skin weights of the body: Cui, eq. 33, within each part of the body, and a smooth transition
//! from part to part.
//!
//! By distance alone the inside of one thigh would follow the other leg, and the flank the arm. So
//! the bones that may move a point are those of the part of the body whose solid made the surface
//! there. In each part eq. 33 gives their weights, and near a seam the weights of two parts are
//! mixed by the distances of the point from both solids. All of this is a smooth function of the
//! position.

use crate::landmarks::{HEEL, Landmarks};
use crate::shape::Body;
use crate::skeleton::{ARM, CHEST, COUNT, HEAD, HIPS, LEG, NECK, SPINE};
use crate::{Vector, mirror};
use ga_anim::distance_weights::distance_to_bone;
use ga_anim::skeleton::Skeleton;
use ga_anim::weights::SkinWeights;
use ga_runtime::scalar::smooth_step;

/// Exponent m of eq. 33: how sharply the bones share a bend.
const EXPONENT: f64 = 5.0;
/// Half the width of the seam between trunk and arms and of that between the legs, in metres of
/// distance to their solids.
const ARM_SEAM: f64 = 0.016;
const LEG_SEAM: f64 = 0.007;
/// Weights below this are dropped.
const LEAST: f64 = 0.02;
/// The most joints that move a vertex.
const INFLUENCES: usize = 4;

/// A bone as one or several segments; its distance is that of the nearest.
struct Bone {
    joint: usize,
    segments: Vec<[Vector; 2]>,
}

/// The weights of the vertices of the body at rest.
pub(crate) fn weights(
    body: &Body,
    landmarks: &Landmarks,
    skeleton: &Skeleton,
    positions: &[Vector],
) -> SkinWeights {
    let bone = |joint: usize| Bone {
        joint,
        segments: vec![
            [skeleton.joints()[joint].head, skeleton.joints()[joint].tail].map(Vector::from),
        ],
    };
    let limb = |first: usize| (first..first + 4).map(bone).collect::<Vec<_>>();
    let mut trunk: Vec<Bone> = [HIPS, SPINE, CHEST, NECK, HEAD, ARM[0], ARM[1]]
        .map(bone)
        .into();
    // The pelvis, the rib cage and the jaw are too broad for one segment.
    trunk[HIPS]
        .segments
        .push([Vector::new(-0.09, 0.95, 0.0), Vector::new(0.09, 0.95, 0.0)]);
    trunk[CHEST]
        .segments
        .push([Vector::new(-0.08, 1.32, 0.0), Vector::new(0.08, 1.32, 0.0)]);
    trunk[HEAD]
        .segments
        .push([Vector::new(0.0, 1.62, 0.0), Vector::new(0.0, 1.56, 0.085)]);
    let [left_arm, right_arm] = ARM.map(limb);
    let [mut left_leg, mut right_leg] = LEG.map(limb);
    // The heel belongs to the foot, though the shank ends as near to it.
    let sole = [landmarks.foot.point(HEEL, 0.0, 0.03), landmarks.ball];
    left_leg[2].segments.push(sole);
    right_leg[2].segments.push(sole.map(mirror));
    let parts = [trunk, left_arm, right_arm, left_leg, right_leg];

    let rows = positions.iter().map(|&point| {
        let mut row = [0.0; COUNT];
        for (bones, share) in parts.iter().zip(shares(body, point)) {
            if share > 1e-6 {
                for (joint, weight) in inverse_distance(bones, point) {
                    row[joint] += share * weight;
                }
            }
        }
        // What the fifth strongest has is taken off all, so that the fourth fades out before
        // another takes its place.
        let mut falling = row;
        falling.sort_by(|a, b| b.total_cmp(a));
        let least = falling[INFLUENCES].max(LEAST);
        let faded = (0..)
            .zip(row)
            .map(|(joint, w): (u32, f64)| (joint, (w - least).max(0.0)));
        faded.collect::<Vec<_>>()
    });
    SkinWeights::new(COUNT, rows).expect("the shares of the parts sum to 1")
}

/// Eq. 33 over all of some bones.
fn inverse_distance(bones: &[Bone], point: Vector) -> Vec<(usize, f64)> {
    let distance = |bone: &Bone| {
        let distances = bone
            .segments
            .iter()
            .map(|&ends| distance_to_bone(point.coordinates(), ends.map(Vector::coordinates)));
        distances.fold(f64::INFINITY, f64::min)
    };
    let distances: Vec<f64> = bones.iter().map(|bone| distance(bone).max(1e-6)).collect();
    let nearest = distances.iter().copied().fold(f64::INFINITY, f64::min);
    let powers: Vec<f64> = distances
        .iter()
        .map(|l| (nearest / l).powf(EXPONENT))
        .collect();
    let sum: f64 = powers.iter().sum();
    bones
        .iter()
        .zip(powers)
        .map(|(bone, power)| (bone.joint, power / sum))
        .collect()
}

/// The share of each part of the body in the weights at a point of the skin: trunk, left and right
/// arm, left and right leg.
fn shares(body: &Body, point: Vector) -> [f64; 5] {
    let [trunk, left_arm, right_arm, left_leg, right_leg] = body.parts(point, 0.3);
    let nearer = |a: f64, b: f64, seam: f64| 1.0 / (1.0 + ((a - b) / seam).exp());
    let (left_arm, right_arm) = (
        nearer(left_arm, trunk, ARM_SEAM),
        nearer(right_arm, trunk, ARM_SEAM),
    );
    let core = (1.0 - left_arm - right_arm).max(0.0);
    // The crease of the hip rises from the crotch to the sides.
    let crease = 0.860 + 0.045 * smooth_step(0.0, 0.13, point.e1.abs());
    let above = smooth_step(-0.1, 0.1, point.e2 - crease);
    let left = nearer(left_leg, right_leg, LEG_SEAM);
    let legs = core * (1.0 - above);
    [
        core * above,
        left_arm,
        right_arm,
        legs * left,
        legs * (1.0 - left),
    ]
}
