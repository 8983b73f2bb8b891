//! The unit of a recording, for bodies that were written in a known one.

use std::path::PathBuf;

use ga_anim::bvh;
use ga_anim::unit::{LikelyUnit, likely_unit};

fn unit_of(name: &str) -> LikelyUnit {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/units");
    let motion = bvh::read(folder.join(name)).unwrap();
    likely_unit(&motion)
}

#[test]
fn the_unit_does_not_depend_on_the_pose_at_rest() {
    // Legs are spread by 55 degrees at rest.
    let spread = unit_of("cmu_unit.bvh");
    assert!(
        spread.is_clear() && spread.metres == 0.0254 / 0.45,
        "{spread:?}"
    );
    // The body lies along x at rest.
    let lying = unit_of("lying_cm.bvh");
    assert!(lying.is_clear() && lying.metres == 0.01, "{lying:?}");
}

#[test]
fn recordings_of_cmu_have_its_unit() {
    let Some(path) = nullcone_shared_data::shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    assert_eq!(likely_unit(&bvh::read(path).unwrap()).metres, 0.0254 / 0.45);
}
