//! Retargeting: a real recording on a real body.

use ga_anim::bvh::{self, Bvh};
use ga_anim::pose::Pose;
use ga_anim::retarget::{Options, Retarget, Soles};
use ga_anim::rig;
use ga_anim::skeleton::Skeleton;
use ga_anim::skin::{BodyReport, Method};
use ga_anim::weights::SkinWeights;
use ga_mesh::Mesh;
use ga_mesh::obj;
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

/// The CMU recording 01_01 and the MakeHuman body in metres: a person who jumps forward, turns
/// round and jumps back.
struct Real {
    source: Bvh,
    skeleton: Skeleton,
    body: Mesh,
    weights: SkinWeights,
}

fn real() -> Option<Real> {
    let whole = obj::read(shared("data/anim/human_base.obj")?)
        .unwrap()
        .scaled(rig::METRES_PER_UNIT)
        .unwrap();
    let skeleton = rig::read(shared("data/anim/human/rig.cmu_mb.json")?)
        .unwrap()
        .scaled(rig::METRES_PER_UNIT)
        .unwrap();
    let weights = shared("data/anim/human/weights.cmu_mb.json")?;
    let weights = rig::read_weights(weights, &skeleton, whole.vertex_count()).unwrap();
    let body = whole.part("body").unwrap();
    Some(Real {
        source: bvh::read(shared("data/anim/bvh/01_01.bvh")?).unwrap(),
        skeleton,
        weights: weights.select(&body.vertices).unwrap(),
        body: body.mesh,
    })
}

impl Real {
    fn retarget(&self) -> Retarget<'_> {
        let soles = Soles::of_mesh(self.body.positions(), &self.weights).unwrap();
        Retarget::new(
            &self.source,
            &self.skeleton,
            &Options {
                soles: Some(&soles),
                ..Options::default()
            },
        )
        .unwrap()
    }

    fn report(&self, pose: &Pose) -> BodyReport {
        let (positions, weights) = (self.body.positions(), &self.weights);
        BodyReport::new(positions, weights, &self.skeleton, pose, Method::Linear).unwrap()
    }
}

#[test]
fn the_real_person_stays_whole_and_upright_and_touches_the_ground() {
    let Some(real) = real() else { return };
    let retarget = real.retarget();
    assert_eq!(
        retarget.unmatched().collect::<Vec<_>>(),
        ["LeftHandFinger1", "RightHandFinger1"]
    );
    for frame in (0..real.source.frame_count()).step_by(10) {
        let report = real.report(&retarget.pose(frame).unwrap());
        assert!(
            report.bone_length_error < 1e-14,
            "frame {frame}: {report:?}"
        );
        // Crouching for a jump included.
        assert!(
            report.up[1] > 0.65 && (1.2..1.8).contains(&report.height),
            "frame {frame}: {report:?}"
        );
        assert!(report.lowest > -0.06, "frame {frame}: {report:?}");
        match frame {
            300..=340 | 680..=700 | 900..=1000 | 1380..=1460 | 1660..=1700 | 2300..=2340 => {
                assert!(report.up[1] > 0.93, "frame {frame}: {report:?}");
                assert!(report.lowest.abs() < 0.02, "frame {frame}: {report:?}");
                assert!(
                    (1.55..1.7).contains(&report.height),
                    "frame {frame}: {report:?}"
                );
            }
            // In the air.
            240..=260 | 620 | 800..=820 | 1300..=1320 | 2240 => {
                assert!(report.lowest > 0.1, "frame {frame}: {report:?}");
            }
            _ => {}
        }
    }
}

#[test]
fn the_scale_is_that_of_the_real_legs() {
    let Some(real) = real() else { return };
    let (mut ours, mut there) = (0.0, 0.0);
    for side in ["Left", "Right"] {
        for (from, to) in [("UpLeg", "Leg"), ("Leg", "Foot")] {
            let [from, to] = [from, to].map(|part| format!("{side}{part}"));
            let place = |name: &str| real.skeleton.joint(name).unwrap().head;
            ours += Vector::from(place(&to)).distance(place(&from).into());
            let offset = real.source.joints()[real.source.index(&to).unwrap()].offset;
            there += Vector::from(offset).length();
        }
    }
    assert!((real.retarget().scale() - ours / there).abs() < 1e-15);
}

#[test]
fn the_real_recording_begins_with_the_arms_out() {
    let Some(real) = real() else { return };
    let bones = real
        .retarget()
        .pose(0)
        .unwrap()
        .bones(&real.skeleton)
        .unwrap();
    let place = |name: &str| Vector::from(bones[real.skeleton.index(name).unwrap()][0]);
    for side in ["Left", "Right"] {
        let arm = place(&format!("{side}Hand")) - place(&format!("{side}Arm"));
        let outward = if side == "Left" { arm.e1 } else { -arm.e1 };
        assert!(outward > 0.99 * arm.length(), "{side}: {arm:?}");
    }
}

/// While a foot of the recording stands, the foot of the body stands too.
#[test]
fn the_real_feet_slide_no_more_than_recorded() {
    let Some(real) = real() else { return };
    let retarget = real.retarget();
    const WINDOW: usize = 12;
    let frames = 0..real.source.frame_count();
    let bones: Vec<_> = frames
        .clone()
        .map(|frame| retarget.pose(frame).unwrap().bones(&real.skeleton).unwrap())
        .collect();
    let recorded: Vec<_> = frames
        .map(|frame| real.source.joint_positions(frame).unwrap())
        .collect();
    for name in ["LeftFoot", "LeftToeBase", "RightFoot", "RightToeBase"] {
        let (ours, there) = (
            real.skeleton.index(name).unwrap(),
            real.source.index(name).unwrap(),
        );
        let (mut slides, mut recorded_slides) = (Vec::new(), Vec::new());
        for frame in 0..bones.len() - WINDOW {
            let [before, after] = [frame, frame + WINDOW];
            let place = |frame: usize| Vector::from(recorded[frame][there]) * retarget.scale();
            let step = place(after) - place(before);
            if step.length() < 0.01 {
                recorded_slides.push(step.e1.hypot(step.e3));
                let head = |frame: usize| Vector::from(bones[frame][ours][0]);
                let step = head(after) - head(before);
                slides.push(step.e1.hypot(step.e3));
            }
        }
        let mean = |list: &[f64]| list.iter().sum::<f64>() / list.len() as f64;
        assert!(slides.len() > 1000);
        assert!(
            mean(&slides) < 1.05 * mean(&recorded_slides),
            "{name}: {}",
            mean(&slides)
        );
        assert!(slides.iter().all(|&slide| slide < 0.02), "{name}");
    }
}
