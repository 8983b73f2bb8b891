//! Retargeting to rigs of glTF files that stand in a pose of an animation, or whose feet hang on
//! the root.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use ga_anim::bvh::Bvh;
use ga_anim::gltf::{Player, Rigged};
use ga_anim::retarget::{Options, Retarget};
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
    rigged.with_clip("motion", &clip).unwrap()
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
