//! Motion from BVH files: a real one with known joints and values, made ones with known faults.

mod faults;
mod properties;
mod tolerant;

use ga_anim::bvh::{self, Bvh, BvhWarning, Channel, PositionChannels};
use nullcone_shared_data::shared;
use serde_json::Value;

use crate::assert_relative;

fn truth() -> Value {
    let truth: Value = serde_json::from_str(include_str!("../../data/bvh.json")).unwrap();
    truth["bvh/01_01.bvh"].clone()
}

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect()
}

fn channel_name(channel: Channel) -> String {
    let (axis, what) = match channel {
        Channel::Position(axis) => (axis, "position"),
        Channel::Rotation(axis) => (axis, "rotation"),
    };
    format!("{}{what}", ["X", "Y", "Z"][axis])
}

#[test]
fn a_real_file_has_the_joints_and_frames_known_for_it() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let (motion, truth) = (bvh::read(path).unwrap(), truth());
    assert_eq!(
        motion.frame_count() as u64,
        truth["frames"].as_u64().unwrap()
    );
    assert_eq!(motion.frame_time(), truth["dt"].as_f64().unwrap());

    // The truth counts an End Site as one more joint, right after its own.
    let known = truth["joints"].as_array().unwrap();
    let mut index_of_known = Vec::new();
    let mut known_of_index = Vec::new();
    for (at, joint) in known.iter().enumerate() {
        if joint["channels"].as_array().unwrap().is_empty() {
            let above = motion.joints().get(known_of_index.len() - 1).unwrap();
            assert_eq!(above.end_site.unwrap()[..], numbers(&joint["offset"]));
            index_of_known.push(None);
            continue;
        }
        let ours = &motion.joints()[known_of_index.len()];
        index_of_known.push(Some(known_of_index.len()));
        known_of_index.push(at);
        assert_eq!(ours.name, joint["name"]);
        assert_eq!(ours.offset[..], numbers(&joint["offset"]));
        let names: Vec<String> = ours.channels.iter().copied().map(channel_name).collect();
        assert_eq!(Value::from(names), joint["channels"]);
        let parent = usize::try_from(joint["parent"].as_i64().unwrap()).ok();
        assert_eq!(
            ours.parent,
            parent.and_then(|parent| index_of_known[parent])
        );
    }
    assert_eq!(motion.joints().len(), known_of_index.len());
    for pose in truth["poses"].as_array().unwrap() {
        let frame = pose["frame"].as_u64().unwrap() as usize;
        assert_eq!(motion.frame(frame).unwrap(), numbers(&pose["channels"]));
    }
    assert_eq!(motion.frame(motion.frame_count()), None);
}

#[test]
fn the_joints_of_a_real_recording_are_where_they_should_be() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let (motion, truth) = (bvh::read(path).unwrap(), truth());
    let names: Vec<&str> = truth["joints"]
        .as_array()
        .unwrap()
        .iter()
        .map(|joint| joint["name"].as_str().unwrap())
        .collect();
    for pose in truth["poses"].as_array().unwrap() {
        let frame = pose["frame"].as_u64().unwrap() as usize;
        let joints = motion.joint_positions(frame).unwrap();
        let ends = motion.end_site_positions(frame).unwrap();
        for (name, known) in names.iter().zip(pose["joint_position"].as_array().unwrap()) {
            let ours = match name.strip_suffix("_end") {
                Some(name) => ends[motion.index(name).unwrap()].unwrap(),
                None => joints[motion.index(name).unwrap()],
            };
            for (ours, known) in ours.into_iter().zip(numbers(known)) {
                assert_relative(ours, known, 1e-12);
            }
        }
    }
    assert_eq!(motion.joint_positions(motion.frame_count()), None);
}

/// By a matrix for each channel in turn, apart from any motor. `root` is how the positions of the
/// first joint are meant.
fn places_by_matrices(joints: &[Link], frame: &[f64], root: PositionChannels) -> Vec<[f64; 3]> {
    let mut values = frame.iter();
    let (mut turn, mut place) = (
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [0.0; 3],
    );
    let mut places = Vec::new();
    for (index, (channels, offset)) in joints.iter().enumerate() {
        let (mut shift, above) = (*offset, turn);
        for channel in channels {
            let value = values.next().unwrap();
            match *channel {
                Channel::Position(axis) if index == 0 && root == PositionChannels::InPlace => {
                    shift[axis] = *value;
                }
                Channel::Position(axis) => shift[axis] += value,
                Channel::Rotation(axis) => {
                    let (sine, cosine) = value.to_radians().sin_cos();
                    let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
                    for row in &mut turn {
                        (row[b], row[c]) = (
                            cosine * row[b] + sine * row[c],
                            cosine * row[c] - sine * row[b],
                        );
                    }
                }
            }
        }
        for (axis, row) in above.iter().enumerate() {
            place[axis] += (0..3).map(|k| row[k] * shift[k]).sum::<f64>();
        }
        places.push(place);
    }
    places
}

const SMALL: &str = "HIERARCHY
ROOT Hip
{
OFFSET 0 0 0
CHANNELS 3 Xposition Zrotation Xrotation
JOINT Knee
{
OFFSET 0 -4 0
CHANNELS 1 Xrotation
End Site
{
OFFSET 0 -3 0
}
}
}
MOTION
Frames: 2
Frame Time: 0.01
1 2 3 4
5 6 7 8
";

/// `SMALL` with one line, counted from 1, replaced.
fn small_with(line: usize, text: &str) -> String {
    let mut lines: Vec<&str> = SMALL.lines().collect();
    lines[line - 1] = text;
    lines.join("\n")
}

/// Three joints whose channels are all six: with the offsets in the positions, or without.
fn six_channels(positions: [[f64; 3]; 3], offset_of_root: f64) -> String {
    let channels = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation";
    let mut text = format!(
        "HIERARCHY\nROOT a {{ OFFSET 0 {offset_of_root} 0 {channels}\nJOINT b {{ OFFSET 0 -4 1 {channels}\n\
         JOINT c {{ OFFSET 3 0 0 {channels}\nEnd Site {{ OFFSET 1 0 0 }} }} }} }}\n\
         MOTION\nFrames: 2\nFrame Time: 0.1\n"
    );
    for frame in 1..=2 {
        for [x, y, z] in positions {
            text += &format!("{x} {y} {z} {} {} {} ", 10 * frame, -20 * frame, 35 * frame);
        }
        text.push('\n');
    }
    text
}

#[test]
fn positions_below_the_root_are_added_to_offsets_or_take_their_place() {
    let added = [[0.5, 10.0, 1.0], [0.0; 3], [0.1, 0.0, 0.0]];
    let in_place = [[0.5, 10.0, 1.0], [0.0, -4.0, 1.0], [3.1, 0.0, 0.0]];
    let added = bvh::decode(six_channels(added, 1.0).as_bytes()).unwrap();
    let in_place = bvh::decode(six_channels(in_place, 1.0).as_bytes()).unwrap();
    assert_eq!(added.position_channels(), PositionChannels::Added);
    assert_eq!(in_place.position_channels(), PositionChannels::InPlace);
    for (motion, positions) in [
        (&added, PositionChannels::Added),
        (&in_place, PositionChannels::InPlace),
    ] {
        let warning = BvhWarning::PositionsBelowRoot {
            joints: 2,
            positions,
        };
        assert_eq!(motion.warnings(), [warning]);
    }
    assert_eq!(
        in_place.warnings()[0].to_string(),
        "2 joints below the root have position channels, which are used in place of the offsets"
    );
    for frame in 0..2 {
        let pairs = added.joint_positions(frame).unwrap();
        for (a, b) in pairs.iter().zip(in_place.joint_positions(frame).unwrap()) {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14));
        }
        // A length that the rotations do not change.
        let arm: f64 = (0..3).map(|k| (pairs[2][k] - pairs[1][k]).powi(2)).sum();
        assert!((arm.sqrt() - 3.1).abs() < 1e-14);
    }
}

#[test]
fn poses_of_its_skeleton_are_those_of_the_recording() {
    let mut texts = vec![six_channels(
        [[0.5, 9.0, 1.0], [0.0; 3], [0.1, 0.2, 0.0]],
        1.0,
    )];
    texts.push(six_channels(
        [[0.5, 9.0, 1.0], [0.0, -4.0, 1.0], [3.1, 0.0, 0.0]],
        2.0,
    ));
    if let Some(path) = shared("data/anim/bvh/01_01.bvh") {
        texts.push(std::fs::read_to_string(path).unwrap());
    }
    for text in texts {
        let motion = bvh::decode(text.as_bytes()).unwrap();
        let skeleton = motion.skeleton().unwrap();
        for frame in (0..motion.frame_count()).step_by(500) {
            let bones = motion.pose(frame).unwrap().bones(&skeleton).unwrap();
            let joints = motion.joint_positions(frame).unwrap();
            let ends = motion.end_site_positions(frame).unwrap();
            for (index, [head, tail]) in bones.into_iter().enumerate() {
                let near = |a: [f64; 3], b: [f64; 3]| {
                    for (a, b) in a.into_iter().zip(b) {
                        assert_relative(a, b, 1e-12);
                    }
                };
                near(head, joints[index]);
                if let Some(end) = ends[index] {
                    near(tail, end);
                }
            }
        }
        assert_eq!(motion.pose(motion.frame_count()), None);
    }
}

#[test]
fn layout_and_case_of_keywords_do_not_matter() {
    let dense = "hierarchy root Hip { Offset 0 0 0 channels 3 xposition ZROTATION Xrotation
        joint Knee { OFFSET 0 -4 0 CHANNELS 1 Xrotation end site { OFFSET 0 -3 0 } } }
        motion frames: 2 frame time: 0.01\r\n\r\n1 2 3 4\r\n\n5 6 7 8";
    assert_eq!(bvh::decode(dense.as_bytes()), bvh::decode(SMALL.as_bytes()));
}

#[test]
fn names_may_be_of_several_words_and_roots_may_be_several() {
    let text = SMALL.replace(
        "MOTION",
        "ROOT  left hand\n{ CHANNELS 0 OFFSET 1 2 3 }\nMOTION",
    );
    let motion = bvh::decode(text.as_bytes()).unwrap();
    let hand = motion.index("left hand").unwrap();
    assert_eq!((hand, motion.joints()[hand].parent), (2, None));
}

#[test]
fn a_deep_hierarchy_is_no_danger() {
    let depth = 2_000;
    let joint = |index: usize| format!("JOINT j{index} {{ OFFSET 0 1 0 CHANNELS 1 Zrotation\n");
    let joints: String = (0..depth).map(joint).collect();
    let text = format!(
        "HIERARCHY ROOT r {{ OFFSET 0 0 0 CHANNELS 0 {joints} {} }} MOTION Frames: 0 Frame Time: 1",
        "}".repeat(depth).replace('}', "} ")
    );
    let motion = bvh::decode(text.as_bytes()).unwrap();
    assert_eq!(
        (motion.joints().len(), motion.frame_count()),
        (depth + 1, 0)
    );
}

/// The channels and the offset of a joint.
type Link = (Vec<Channel>, [f64; 3]);

/// A leg that hangs from a root, whose place is given with its offset, or relative to it.
#[test]
fn positions_of_a_root_replace_its_offset_unless_only_the_sum_stands_on_the_ground() {
    let leg = |height: f64| {
        let text = format!(
            "HIERARCHY\nROOT hips {{ OFFSET 3 0 90 CHANNELS 3 Xposition Yposition Zposition\n\
             JOINT foot {{ OFFSET 0 0 -85 CHANNELS 1 Xrotation }} }}\n\
             MOTION\nFrames: 2\nFrame Time: 0.1\n1 2 {height} 0\n1 2 {height} 0\n"
        );
        bvh::decode(text.as_bytes()).unwrap()
    };
    let place = |motion: &Bvh| motion.joint_positions(1).unwrap()[0];
    let absolute = leg(88.0);
    assert_eq!(place(&absolute), [1.0, 2.0, 88.0]);
    assert_eq!(absolute.warnings(), []);
    let relative = leg(-2.0);
    assert_eq!(place(&relative), [4.0, 2.0, 88.0]);
    assert_eq!(relative.warnings(), [BvhWarning::RootPositionsAdded]);
    // Neither stands on the ground.
    assert_eq!(place(&leg(400.0)), [1.0, 2.0, 400.0]);
}
