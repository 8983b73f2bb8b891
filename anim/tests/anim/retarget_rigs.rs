//! Retargeting to rigs of glTF files that stand in a pose of an animation, or whose feet hang on
//! the root.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use ga_anim::bvh::{self, Bvh};
use ga_anim::gltf::{Player, Rigged};
use ga_anim::recording::{Recording, RecordingError};
use ga_anim::retarget::{BodyProblem, JointMap, Options, Retarget};
use ga_anim::skeleton::{Joint, Skeleton};
use ga_mesh::gltf::Document;
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

fn rig(path: &str) -> Option<Document> {
    Some(ga_mesh::gltf::read(shared(&format!("cases/motion/{path}"))?).unwrap())
}

fn motion(path: &str) -> Option<Bvh> {
    Some(ga_anim::bvh::read(shared(&format!("cases/motion/{path}"))?).unwrap())
}

/// The document with the motion as its only animation.
fn moved(document: &Document, motion: &Bvh) -> Document {
    let rigged = Rigged::new(document).unwrap();
    let retarget = Retarget::new(motion, rigged.skeleton(), &Options::default()).unwrap();
    let clip = retarget.clip(0..=motion.frame_count() - 1).unwrap();
    rigged.with_clip("motion", &clip).unwrap().0
}

/// Where a node is in the world at the frames of the motion, as any viewer has it.
fn path(document: &Document, motion: &Bvh, node: &str) -> Vec<Vector<f64>> {
    let index = document
        .nodes
        .iter()
        .position(|other| other.name.as_deref() == Some(node));
    let index = index.unwrap();
    let player = Player::new(document).unwrap();
    let place = |frame: usize| {
        let time = frame as f64 * motion.frame_time();
        player.pose(Some(0), time).unwrap().world[index]
            .translation
            .into()
    };
    (0..motion.frame_count()).map(place).collect()
}

#[test]
fn a_foot_that_hangs_on_the_root_stays_at_the_end_of_its_shin() {
    let (Some(ik), Some(fk), Some(walk)) = (
        rig("foot-under-root/ik_rig.gltf"),
        rig("foot-under-root/fk_rig.gltf"),
        motion("foot-under-root/walk.bvh"),
    ) else {
        return;
    };
    let names: Vec<String> = fk
        .nodes
        .iter()
        .filter_map(|node| node.name.clone())
        .collect();
    let [ik, fk] = [ik, fk].map(|document| moved(&document, &walk));
    let mut compared = 0;
    for name in names {
        if !ik
            .nodes
            .iter()
            .any(|node| node.name.as_deref() == Some(&name))
        {
            continue;
        }
        compared += 1;
        let pairs = path(&ik, &walk, &name)
            .into_iter()
            .zip(path(&fk, &walk, &name));
        for (frame, (a, b)) in pairs.enumerate() {
            assert!(a.distance(b) < 1e-5, "{name} in frame {frame}: {a:?} {b:?}");
        }
    }
    assert!(compared > 10);
}

/// Two files of one skin; in one of them an arm is bent without an animation.
#[test]
fn the_rest_of_a_character_is_the_pose_in_which_it_was_bound() {
    let (Some(posed), Some(bind), Some(arms_out)) = (
        rig("node-pose-not-bind-pose/posed.gltf"),
        rig("node-pose-not-bind-pose/bind.gltf"),
        motion("node-pose-not-bind-pose/tpose.bvh"),
    ) else {
        return;
    };
    let names: Vec<String> = bind
        .nodes
        .iter()
        .filter_map(|node| node.name.clone())
        .collect();
    let stands = |document: &Document| Rigged::new(document).unwrap().skeleton().clone();
    for (a, b) in stands(&posed).joints().iter().zip(stands(&bind).joints()) {
        let apart = Vector::from(a.head).distance(b.head.into());
        assert!(a.name == b.name && apart < 1e-5, "{}: {apart}", a.name);
    }
    let [posed, bind] = [posed, bind].map(|document| moved(&document, &arms_out));
    for name in names {
        let pairs = path(&posed, &arms_out, &name)
            .into_iter()
            .zip(path(&bind, &arms_out, &name));
        for (frame, (a, b)) in pairs.enumerate() {
            assert!(a.distance(b) < 1e-5, "{name} in frame {frame}: {a:?} {b:?}");
        }
    }
}

/// A fox stands on four legs: a person's motion does not fit it, unless a map says how.
#[test]
fn a_person_does_not_move_a_fox_without_a_map() {
    let (Some(fox), Some(walk)) = (
        shared("data/anim/gltf/Fox.glb"),
        motion("rest-not-upright/upright.bvh"),
    ) else {
        return;
    };
    let document = ga_mesh::gltf::read(fox).unwrap();
    let rigged = Rigged::new(&document).unwrap();
    let fox = rigged.skeleton();
    let refused = Retarget::new(&walk, fox, &Options::default()).unwrap_err();
    assert_eq!(
        refused,
        RecordingError::NotAPerson {
            body: "the skeleton".into(),
            problem: BodyProblem::FourLegs,
        }
    );
    assert!(refused.to_string().contains("four legs"), "{refused}");
    assert!(
        JointMap::by_structure(&walk, fox)
            .source_of()
            .iter()
            .all(Option::is_none)
    );
    let map =
        br#"{"Hips": "b_Hip_01", "Head": "b_Head_05", "LeftUpLeg": "b_LeftLeg01_015", "LeftLeg": "b_LeftLeg02_016",
        "LeftFoot": "b_LeftFoot01_017", "RightUpLeg": "b_RightLeg01_019",
        "RightLeg": "b_RightLeg02_020", "RightFoot": "b_RightFoot01_021"}"#;
    let map = JointMap::decode(map, &walk, fox).unwrap();
    let options = Options {
        map: Some(&map),
        ..Options::default()
    };
    let retarget = Retarget::new(&walk, fox, &options).unwrap();
    let pose = retarget.pose(1).unwrap();
    assert!(
        pose.bones(fox)
            .unwrap()
            .iter()
            .flatten()
            .flatten()
            .all(|x| x.is_finite())
    );
    // Its own motion needs no person.
    let own = Recording::from_gltf(&document, 1, 1.0, None).unwrap();
    let map = JointMap::found(&own, fox).unwrap().0;
    assert!(map.source_of().iter().all(Option::is_some));
}

/// A person whose hips, neck and head are called spine too, whose hands have other names, and whose
/// root lies on the ground, on itself with usual names.
#[test]
fn hips_and_head_are_found_in_a_spine() {
    let Some(walk) = motion("foot-under-root/walk.bvh") else {
        return;
    };
    let usual = walk.skeleton().unwrap();
    let side = |name: &str, part: &str| match name.strip_prefix("Left") {
        Some(_) => format!("{part}.L"),
        None => format!("{part}.R"),
    };
    let renamed = |name: &str| match name.trim_start_matches("Left").trim_start_matches("Right") {
        "Hips" => "spine".to_owned(),
        "Spine" => "spine.001".to_owned(),
        "Spine1" => "spine.002".to_owned(),
        "Neck" => "spine.003".to_owned(),
        "Head" => "spine.004".to_owned(),
        "Shoulder" => side(name, "shoulder"),
        "Arm" => side(name, "upper_arm"),
        "ForeArm" => side(name, "forearm"),
        "Hand" => side(name, "hand"),
        "UpLeg" => side(name, "thigh"),
        "Leg" => side(name, "shin"),
        "Foot" => side(name, "foot"),
        _ => side(name, "toe"),
    };
    let mut joints = vec![Joint {
        name: "world".into(),
        parent: None,
        head: [0.0; 3],
        tail: [0.0, 0.0, 10.0],
    }];
    let lowest = usual.joints().iter().map(|joint| joint.head[1]);
    let ground = lowest.fold(f64::INFINITY, f64::min);
    joints.extend(usual.joints().iter().map(|joint| Joint {
        name: renamed(&joint.name),
        parent: Some(joint.parent.map_or(0, |parent| parent + 1)),
        head: [joint.head[0], joint.head[1] - ground, joint.head[2]],
        tail: [joint.tail[0], joint.tail[1] - ground, joint.tail[2]],
    }));
    let target = Skeleton::new(joints).unwrap();
    let map = JointMap::by_names(&walk, &target);
    let expected = (0..usual.len()).map(Some);
    let expected: Vec<Option<usize>> = std::iter::once(None).chain(expected).collect();
    assert_eq!(map.source_of(), expected);
    let retarget = Retarget::new(&walk, &target, &Options::default()).unwrap();
    assert!(retarget.found_up_axis().is_some());
    let plain = Retarget::new(&walk, &usual, &Options::default()).unwrap();
    for frame in 0..walk.frame_count() {
        // The root on the ground is nothing that the body stands on.
        let ours = retarget.pose(frame).unwrap().bones(&target).unwrap();
        let truth = plain.pose(frame).unwrap().bones(&usual).unwrap();
        for (ours, truth) in ours[1..].iter().zip(truth) {
            let apart = Vector::from(ours[0]).distance(truth[0].into());
            assert!(apart < 1e-9, "frame {frame}: {apart}");
        }
    }
}

/// Where nothing moves the head of a character, its neck says the direction of the trunk.
#[test]
fn a_recording_without_a_head_moves_the_trunk() {
    let (Some(fk), Some(path)) = (
        rig("foot-under-root/fk_rig.gltf"),
        shared("cases/motion/foot-under-root/walk.bvh"),
    ) else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let walk = bvh::decode(text.replace("JOINT Head", "JOINT Face").as_bytes()).unwrap();
    let rigged = Rigged::new(&fk).unwrap();
    let target = rigged.skeleton();
    let retarget = Retarget::new(&walk, target, &Options::default()).unwrap();
    assert!(retarget.found_up_axis().is_some());
    for frame in 0..walk.frame_count() {
        let bones = retarget.pose(frame).unwrap().bones(target).unwrap();
        let places = walk.joint_positions(frame).unwrap();
        let ours = |name: &str| Vector::from(bones[target.index(name).unwrap()][0]);
        let there = |name: &str| Vector::from(places[walk.index(name).unwrap()]);
        let [ours, there] = [ours("Neck") - ours("Hips"), there("Neck") - there("Hips")];
        assert!(ours.angle(there).unwrap() < 1e-7);
    }
}
