//! Feet that stand: made walks on legs of other proportions, and a real recording.

use std::fmt::Write as _;
use std::ops::Range;

use ga_anim::bvh::{self, Bvh};
use ga_anim::gltf::character;
use ga_anim::pose::Pose;
use ga_anim::recording::RecordingError;
use ga_anim::retarget::{Alignment, FootLocking, JointMap, LockedFeet, Options, Retarget, Soles};
use ga_anim::rig;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;
use proptest::prelude::*;

/// Name, parent and place of the joints of a body, in metres.
const BODY: [(&str, Option<usize>, [f64; 3]); 11] = [
    ("hips", None, [0.0, 1.0, 0.0]),
    ("chest", Some(0), [0.0, 1.4, 0.0]),
    ("head", Some(1), [0.0, 1.7, 0.0]),
    ("thigh l", Some(0), [0.1, 0.95, 0.0]),
    ("shin l", Some(3), [0.1, 0.5, 0.0]),
    ("foot l", Some(4), [0.1, 0.08, 0.0]),
    ("toes l", Some(5), [0.1, 0.02, 0.15]),
    ("thigh r", Some(0), [-0.1, 0.95, 0.0]),
    ("shin r", Some(7), [-0.1, 0.5, 0.0]),
    ("foot r", Some(8), [-0.1, 0.08, 0.0]),
    ("toes r", Some(9), [-0.1, 0.02, 0.15]),
];
const THIGH: f64 = 0.45;
const SHIN: f64 = 0.42;
const FRAME_TIME: f64 = 0.01;

/// The angles about x of thigh, shin and foot, in degrees, by which an ankle is at a place below a
/// hip and the foot stays level, by the law of cosines.
fn leg_angles([hip_y, hip_z]: [f64; 2], [ankle_y, ankle_z]: [f64; 2]) -> [f64; 3] {
    let (y, z) = (ankle_y - hip_y, ankle_z - hip_z);
    let length = y.hypot(z);
    let cosine = (THIGH * THIGH + length * length - SHIN * SHIN) / (2.0 * THIGH * length);
    let thigh = f64::atan2(-z, -y) - cosine.clamp(-1.0, 1.0).acos();
    let knee = [-THIGH * thigh.cos(), -THIGH * thigh.sin()];
    let shin = f64::atan2(-(z - knee[1]), -(y - knee[0]));
    [thigh, shin - thigh, -shin].map(f64::to_degrees)
}

/// A walk: the feet step in turn and stand in between, while the hips go on and sway.
struct Walk {
    source: Bvh,
    /// The frames in which the left and the right foot stand.
    stands: [Vec<Range<usize>>; 2],
}

fn walk(stride: f64, steps: usize) -> Walk {
    const HALF: usize = 60;
    let frames = HALF * (steps + 1);
    let mut stands: [Vec<Range<usize>>; 2] = [
        vec![Range { start: 0, end: 1 }],
        vec![Range { start: 0, end: 1 }],
    ];
    let mut text = String::new();
    let mut at = [0.0, 0.0];
    for frame in 0..frames {
        let (step, part) = (frame / HALF, (frame % HALF) as f64 / HALF as f64);
        // In every half cycle but the first one foot goes forward.
        let foot = step % 2;
        let goes = step > 0;
        let mut places = at.map(|z| [0.08, z]);
        if goes {
            let from = at[foot];
            let to = at[1 - foot] + stride;
            let t = part * part * (3.0 - 2.0 * part);
            let lift = 0.12 * (std::f64::consts::PI * part).sin().powi(2);
            places[foot] = [0.08 + lift, from + (to - from) * t];
        }
        for (k, stands) in stands.iter_mut().enumerate() {
            let is_still = !(goes && k == foot);
            match stands.last_mut().filter(|run| run.end == frame) {
                Some(run) if is_still => run.end = frame + 1,
                _ if is_still => stands.push(frame..frame + 1),
                _ => {}
            }
        }
        let hip_z = 0.5 * (places[0][1] + places[1][1]);
        let time = frame as f64 * FRAME_TIME;
        let hip_y = 0.86 - 0.03 * (7.0 * time).sin();
        let mut numbers = vec![0.0, hip_y + 0.05 - 1.0, hip_z, 0.0, 0.0, 0.0];
        numbers.extend([0.0, 4.0 * (3.0 * time).sin(), 0.0, 0.0, 0.0, 0.0]);
        for place in places {
            let [thigh, shin, foot] = leg_angles([hip_y, hip_z], place);
            for angle in [thigh, shin, foot, 0.0] {
                numbers.extend([angle, 0.0, 0.0]);
            }
        }
        let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
        writeln!(text, "{}", numbers.join(" ")).unwrap();
        if goes && frame % HALF == HALF - 1 {
            at[foot] = at[1 - foot] + stride;
        }
    }
    let source = bvh::decode(format!("{}{text}", header(frames)).as_bytes()).unwrap();
    Walk { source, stands }
}

fn header(frames: usize) -> String {
    fn joint(index: usize, text: &mut String) {
        let (name, parent, place) = BODY[index];
        let above = parent.map_or([0.0; 3], |parent| BODY[parent].2);
        let [x, y, z]: [f64; 3] = std::array::from_fn(|k| place[k] - above[k]);
        let (keyword, channels) = match parent {
            None => ("ROOT", "6 Xposition Yposition Zposition"),
            Some(_) => ("JOINT", "3"),
        };
        let angles = "Xrotation Yrotation Zrotation";
        *text +=
            &format!("{keyword} {name}\n{{\nOFFSET {x} {y} {z}\nCHANNELS {channels} {angles}\n");
        for child in (0..BODY.len()).filter(|&child| BODY[child].1 == Some(index)) {
            joint(child, text);
        }
        *text += "}\n";
    }
    let mut text = "HIERARCHY\n".to_owned();
    joint(0, &mut text);
    text + &format!("MOTION\nFrames: {frames}\nFrame Time: {FRAME_TIME}\n")
}

/// The body with other lengths: of thighs, shins and feet, and the distance between the hips; all
/// of it in another size.
fn target([thigh, shin, foot, hips]: [f64; 4], size: f64) -> Skeleton {
    let mut places = BODY.map(|(_, _, place)| place);
    for (side, top) in [(1.0, 3), (-1.0, 7)] {
        let x = side * 0.1 * hips;
        let ankle = 0.08;
        let knee = ankle + SHIN * shin;
        let hip = knee + THIGH * thigh;
        places[top] = [x, hip, 0.0];
        places[top + 1] = [x, knee, 0.0];
        places[top + 2] = [x, ankle, 0.0];
        places[top + 3] = [x, 0.02, 0.15 * foot];
    }
    let raised = places[3][1] - BODY[3].2[1];
    for place in &mut places[..3] {
        place[1] += raised;
    }
    let places = places.map(|place| place.map(|x| x * size));
    let joints = BODY.iter().enumerate().map(|(index, &(name, parent, _))| {
        let child = (0..BODY.len()).find(|&child| BODY[child].1 == Some(index));
        Joint {
            name: name.into(),
            parent,
            head: places[index],
            tail: child.map_or(places[index], |child| places[child]),
        }
    });
    Skeleton::new(joints.collect()).unwrap()
}

fn heads(pose: &Pose, skeleton: &Skeleton) -> Vec<Vector<f64>> {
    let bones = pose.bones(skeleton).unwrap();
    bones.into_iter().map(|[head, _]| head.into()).collect()
}

/// The heads of the joints in every frame, without and with foot locking.
fn both(
    retarget: &Retarget,
    locked: &LockedFeet,
    skeleton: &Skeleton,
    frames: usize,
) -> [Vec<Vec<Vector<f64>>>; 2] {
    let frames = || 0..frames;
    [
        frames()
            .map(|frame| heads(&retarget.pose(frame).unwrap(), skeleton))
            .collect(),
        frames()
            .map(|frame| heads(&locked.pose(frame).unwrap(), skeleton))
            .collect(),
    ]
}

/// The greatest distance between two of some places.
fn diameter(places: &[Vector<f64>]) -> f64 {
    let pairs = places
        .iter()
        .flat_map(|a| places.iter().map(|b| a.distance(*b)));
    pairs.fold(0.0, f64::max)
}

/// Only thighs and shins have other directions, and bones keep their lengths. `legs` has hip, knee
/// and ankle of each leg.
fn only_legs_deviate(
    skeleton: &Skeleton,
    legs: &[[usize; 3]],
    free: &[Vec<Vector<f64>>],
    locked: &[Vec<Vector<f64>>],
) {
    let joints = skeleton.joints();
    for (frame, (free, locked)) in free.iter().zip(locked).enumerate() {
        for (joint, parent) in joints
            .iter()
            .enumerate()
            .filter_map(|(k, j)| Some((k, j.parent?)))
        {
            let [before, after] = [free, locked].map(|heads| heads[joint] - heads[parent]);
            let name = &joints[joint].name;
            assert!(
                (before.length() - after.length()).abs() < 1e-9,
                "{name} in frame {frame}"
            );
            let between = |top: usize, end: usize| {
                let mut above = Some(joint);
                while let Some(j) = above.filter(|&j| j != end && j != top) {
                    above = joints[j].parent;
                }
                above == Some(end)
            };
            let is_leg = legs
                .iter()
                .any(|&[hip, _, ankle]| joint == ankle || (between(ankle, hip) && joint != hip));
            if !is_leg {
                assert!(
                    before.distance(after) < 1e-9,
                    "{name} in frame {frame}: {before:?} and {after:?}"
                );
            }
        }
        let is_leg_joint = |joint: usize| {
            let mut above = Some(joint);
            while let Some(j) = above {
                if legs.iter().any(|&[hip, ..]| joint != hip && j == hip) {
                    return true;
                }
                above = joints[j].parent;
            }
            false
        };
        for joint in (0..joints.len()).filter(|&joint| !is_leg_joint(joint)) {
            assert!(free[joint].distance(locked[joint]) < 1e-9);
        }
    }
}

/// The greatest step of a joint from one frame to the next.
fn greatest_step(places: &[Vec<Vector<f64>>], joint: usize) -> f64 {
    let steps = places
        .windows(2)
        .map(|pair| pair[0][joint].distance(pair[1][joint]));
    steps.fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn standing_feet_of_other_legs_stand(
        stride in 0.1..0.4f64,
        thigh in 0.7..1.4f64,
        shin in 0.7..1.4f64,
        foot in 0.7..1.5f64,
        hips in 0.6..1.6f64,
        size in 0.3..3.0f64,
    ) {
        let walk = walk(stride, 4);
        let skeleton = target([thigh, shin, foot, hips], size);
        let retarget = Retarget::new(&walk.source, &skeleton, &Options::default()).unwrap();
        let locked = retarget.with_foot_locking(&FootLocking::new(1.0)).unwrap();
        let [free, fixed] = both(&retarget, &locked, &skeleton, walk.source.frame_count());
        only_legs_deviate(&skeleton, &[[3, 4, 5], [7, 8, 9]], &free, &fixed);
        let lowest = |heads: &[Vector<f64>], ankle: usize| heads[ankle + 1].e2.min(heads[ankle].e2);
        for (ankle, stands) in [5, 9].into_iter().zip(&walk.stands) {
            let mut slides: f64 = 0.0;
            for run in stands.iter().filter(|run| run.len() > 2) {
                let places: Vec<_> = fixed[run.clone()].iter().map(|heads| heads[ankle]).collect();
                prop_assert!(diameter(&places) <= 1e-9, "{run:?}: {}", diameter(&places));
                let places: Vec<_> = free[run.clone()].iter().map(|heads| heads[ankle]).collect();
                slides = slides.max(diameter(&places));
                // The toes are on the ground, or where the leg reaches.
                let low = lowest(&fixed[run.start], ankle);
                prop_assert!(low.abs() < 0.03 * size, "{low}");
            }
            // Otherwise there would be nothing to do.
            if (thigh / shin - 1.0).abs() > 0.2 {
                prop_assert!(slides > 0.002 * size, "{slides}");
            }
            let [before, after] = [&free, &fixed].map(|places| greatest_step(places, ankle));
            prop_assert!(after <= 1.5 * before + 0.005 * size, "{after} after {before}");
            let [before, after] = [&free, &fixed].map(|places| greatest_step(places, ankle - 1));
            prop_assert!(after <= 2.0 * before + 0.02 * size, "knee: {after} after {before}");
        }
        for contact in locked.contacts() {
            prop_assert!(contact.slide <= 1e-9 && contact.short_by <= 0.03 * size, "{contact:?}");
        }
    }
}

#[test]
fn a_leg_that_is_too_short_is_reported() {
    // The body glides along slowly with a foot that stays behind.
    let frames = 6000;
    let mut text = header(frames);
    for frame in 0..frames {
        let mut numbers = vec!["0".to_owned(); 36];
        numbers[2] = (0.0004 * f64::from(u32::try_from(frame).unwrap())).to_string();
        writeln!(text, "{}", numbers.join(" ")).unwrap();
    }
    let source = bvh::decode(text.as_bytes()).unwrap();
    let skeleton = target([1.0; 4], 1.0);
    let retarget = Retarget::new(&source, &skeleton, &Options::default()).unwrap();
    let locked = retarget.with_foot_locking(&FootLocking::new(1.0)).unwrap();
    assert_eq!(locked.contacts().len(), 2);
    for contact in locked.contacts() {
        assert_eq!(contact.frames, 0..=frames - 1);
        assert!((contact.slide_before - 0.0004 * (frames - 1) as f64).abs() < 1e-9);
        // The leg of 0.87 m cannot reach 1.2 m backwards and forwards.
        assert!(
            contact.short_by > 0.01 && contact.slide > 0.01,
            "{contact:?}"
        );
    }
    // The bones keep their lengths all the same.
    let places = heads(&locked.pose(0).unwrap(), &skeleton);
    assert!((places[3].distance(places[4]) - THIGH).abs() < 1e-9);
    // A speed above that is not a contact.
    let slow = FootLocking {
        speed: 0.03,
        ..FootLocking::new(1.0)
    };
    assert!(
        retarget
            .with_foot_locking(&slow)
            .unwrap()
            .contacts()
            .is_empty()
    );
}

#[test]
fn settings_that_are_no_numbers_are_errors() {
    let walk = walk(0.2, 1);
    let skeleton = target([1.0; 4], 1.0);
    let retarget = Retarget::new(&walk.source, &skeleton, &Options::default()).unwrap();
    for unit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = retarget
            .with_foot_locking(&FootLocking::new(unit))
            .unwrap_err();
        assert!(
            matches!(error, RecordingError::FootLocking { .. }),
            "{error}"
        );
    }
    let locked = retarget.with_foot_locking(&FootLocking::new(1.0)).unwrap();
    let frames = walk.source.frame_count();
    assert!(matches!(
        locked.pose(frames),
        Err(RecordingError::FrameRange { .. })
    ));
    assert!(matches!(
        locked.clip(0..=frames),
        Err(RecordingError::FrameRange { .. })
    ));
    assert_eq!(locked.clip(2..=9).unwrap().frames().len(), 8);
}

/// The frames in which an ankle is slower than 0.05 m/s to the next frame, as runs of both ends.
fn slow_runs(source: &Bvh, ankle: usize, metres_per_unit: f64) -> Vec<Range<usize>> {
    let places: Vec<Vector<f64>> = (0..source.frame_count())
        .map(|frame| source.joint_positions(frame).unwrap()[ankle].into())
        .collect();
    let mut runs: Vec<Range<usize>> = Vec::new();
    for frame in 0..places.len() - 1 {
        let speed =
            places[frame].distance(places[frame + 1]) * metres_per_unit / source.frame_time();
        if speed < 0.05 {
            match runs.last_mut().filter(|run| run.end == frame + 1) {
                Some(run) => run.end = frame + 2,
                None => runs.push(frame..frame + 2),
            }
        }
    }
    runs
}

fn assert_real_feet_stand(skeleton: &Skeleton, soles: &Soles, map: &JointMap, source: &Bvh) {
    const UNIT: f64 = 0.056_444;
    for alignment in [Alignment::Limbs, Alignment::EveryBone] {
        let retarget = Retarget::new(
            source,
            skeleton,
            &Options {
                soles: Some(soles),
                map: Some(map),
                alignment,
                ..Options::default()
            },
        )
        .unwrap();
        let locked = retarget.with_foot_locking(&FootLocking::new(UNIT)).unwrap();
        let [free, fixed] = both(&retarget, &locked, skeleton, source.frame_count());
        let mut ankles: Vec<usize> = locked
            .contacts()
            .iter()
            .map(|contact| contact.ankle)
            .collect();
        ankles.dedup();
        assert_eq!(ankles.len(), 2);
        let parent = |joint: usize| skeleton.joints()[joint].parent.unwrap();
        let legs: Vec<[usize; 3]> = ankles
            .iter()
            .map(|&ankle| [parent(parent(ankle)), parent(ankle), ankle])
            .collect();
        only_legs_deviate(skeleton, &legs, &free, &fixed);
        for ankle in ankles {
            let runs = slow_runs(source, map.source_of()[ankle].unwrap(), UNIT);
            assert!(runs.len() > 10);
            let mut before: f64 = 0.0;
            for run in runs {
                let places = |of: &[Vec<Vector<f64>>]| -> Vec<Vector<f64>> {
                    of[run.clone()].iter().map(|heads| heads[ankle]).collect()
                };
                let slide = diameter(&places(&fixed));
                // At most 5 mm are asked for.
                assert!(slide <= 1e-6, "{alignment:?}, frames {run:?}: {slide}");
                before = before.max(diameter(&places(&free)));
            }
            assert!(before > 0.001, "{before}");
            let [before, after] = [&free, &fixed].map(|places| greatest_step(places, ankle));
            assert!(after <= 1.5 * before, "{after} after {before}");
        }
        let frames = [300, 320, 680, 1000, 1400, 1700];
        for (frame, &[_, _, ankle]) in frames
            .into_iter()
            .flat_map(|f| legs.iter().map(move |l| (f, l)))
        {
            let motions = locked.pose(frame).unwrap().motions(skeleton).unwrap();
            assert!(
                motions[ankle]
                    .to_matrix()
                    .as_flattened()
                    .iter()
                    .all(|x| x.is_finite())
            );
        }
    }
}

#[test]
fn real_feet_of_the_human_stand() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let source = bvh::read(path).unwrap();
    let skeleton = rig::read(shared("data/anim/human/rig.cmu_mb.json").unwrap()).unwrap();
    let skeleton = skeleton.scaled(rig::METRES_PER_UNIT).unwrap();
    let map = JointMap::by_names(&source, &skeleton);
    assert_real_feet_stand(&skeleton, &Soles::of_skeleton(&skeleton), &map, &source);
}

/// Without names, with a pose at rest in the middle of a step.
#[test]
fn real_feet_of_cesium_man_stand() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let source = bvh::read(path).unwrap();
    let document = ga_mesh::gltf::read(shared("data/anim/gltf/cesium_man.gltf").unwrap()).unwrap();
    let body = character(&document).unwrap();
    let map = JointMap::by_names_or_structure(&source, &body.skeleton).unwrap();
    let soles = Soles::of_mesh(body.mesh.positions(), &body.weights).unwrap();
    assert_real_feet_stand(&body.skeleton, &soles, &map, &source);
}
