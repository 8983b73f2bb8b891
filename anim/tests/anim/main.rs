//! Skeletons, recordings and skins, against known answers and against laws.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod binding;
mod bvh;
mod character;
mod clip;
mod compressed;
mod curve;
mod distance_weights;
mod foot_locking;
mod gait;
mod geodesic_weights;
mod gltf;
mod inverse_kinematics;
mod joint_map;
mod kinematics;
mod leg;
mod limits;
mod poses;
mod recording;
mod recording_edit;
mod recording_gltf;
mod retarget;
mod retarget_faults;
mod retarget_pairs;
mod retarget_real;
mod retarget_reference;
mod retarget_rigs;
mod retarget_target;
mod rig;
mod skin;
mod skin_oracle;
mod unit;
mod walker;
mod written_file;
mod written_motion;

/// Fails unless `found` is within `bound` of `expected`, relative to the greater of |`expected`|
/// and 1.
#[track_caller]
fn assert_relative(found: f64, expected: f64, bound: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(
        error <= bound,
        "{found} instead of {expected}: relative error {error:e}"
    );
}
