//! Motion from BVH files: a real one with known joints and values, made ones with known faults.

use crate::assert_relative;
use ga_anim::bvh::{self, Bvh, BvhWarning, Channel, PositionChannels};
use nullcone_shared_data::shared;
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::Value;

fn truth() -> Value {
    let truth: Value = serde_json::from_str(include_str!("../data/bvh.json")).unwrap();
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

/// By a matrix for each channel in turn, apart from any motor.
fn places_by_matrices(joints: &[Link], frame: &[f64]) -> Vec<[f64; 3]> {
    let mut values = frame.iter();
    let (mut turn, mut place) = (
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [0.0; 3],
    );
    let mut places = Vec::new();
    for (channels, offset) in joints {
        let (mut shift, above) = (*offset, turn);
        for channel in channels {
            let value = values.next().unwrap();
            match *channel {
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

#[test]
fn every_fault_is_named_with_its_line() {
    for (line, text, message) in [
        (1, "MOTION", "line 1: expected HIERARCHY, found \"MOTION\""),
        (2, "JOINT Hip", "line 2: expected ROOT, found \"JOINT\""),
        (2, "ROOT", "line 3: expected a name, found \"{\""),
        (3, "", "line 4: expected {, found \"OFFSET\""),
        (4, "OFFSET 0 0", "line 5: \"CHANNELS\" is not a number"),
        (
            4,
            "OFFSET 0 0 nan",
            "line 4: \"nan\" is not a finite number",
        ),
        (
            4,
            "OFFSET 0 0 0 0",
            "line 4: expected OFFSET, CHANNELS, JOINT, End Site or }, found \"0\"",
        ),
        (
            4,
            "",
            "line 15: joint \"Hip\" has 0 OFFSET lines instead of one",
        ),
        (
            9,
            "",
            "line 14: joint \"Knee\" has 0 CHANNELS lines instead of one",
        ),
        (
            9,
            "OFFSET 1 1 1",
            "line 9: joint \"Knee\" has 2 OFFSET lines instead of one",
        ),
        (
            5,
            "CHANNELS 4 Xposition Zrotation Xrotation",
            "line 6: \"JOINT\" is not a channel",
        ),
        (
            5,
            "CHANNELS 2 Xposition Zrotation Xrotation",
            "line 5: expected OFFSET, CHANNELS, JOINT, End Site or }, found \"Xrotation\"",
        ),
        (
            5,
            "CHANNELS 2 Xposition Wrotation",
            "line 5: \"Wrotation\" is not a channel",
        ),
        (
            5,
            "CHANNELS 2 Xrotation xRotation",
            "line 5: joint \"Hip\" has channel xRotation twice",
        ),
        (
            5,
            "CHANNELS many",
            "line 5: expected a count, found \"many\"",
        ),
        (5, "CHANNELS -1", "line 5: expected a count, found \"-1\""),
        (6, "JOINT Hip", "line 6: two joints are called \"Hip\""),
        (10, "End", "line 11: expected Site, found \"{\""),
        (13, "End Site", "line 13: expected }, found \"End\""),
        (
            15,
            "",
            "line 16: expected OFFSET, CHANNELS, JOINT, End Site or }, found \"MOTION\"",
        ),
        (
            16,
            "",
            "line 17: expected ROOT or MOTION, found \"Frames:\"",
        ),
        (
            17,
            "Frames 2",
            "line 17: expected Frames:, found \"Frames\"",
        ),
        (
            17,
            "Frames: 2.5",
            "line 17: expected a count, found \"2.5\"",
        ),
        (
            17,
            "Frames: 0",
            "line 20: the file announces 0 frames and has 2",
        ),
        (
            17,
            "Frames: 4",
            "line 20: the file announces 4 frames and has 2",
        ),
        (
            18,
            "Frame Time: 0",
            "line 18: the frame time must be greater than 0 seconds, but is 0",
        ),
        (
            18,
            "Frame Time: -0.1",
            "line 18: the frame time must be greater than 0 seconds, but is -0.1",
        ),
        (
            18,
            "Frame Time: inf",
            "line 18: \"inf\" is not a finite number",
        ),
        (
            18,
            "Frame Time: 0.01 7",
            "line 18: expected the end of the line, found \"7\"",
        ),
        (
            19,
            "1 2 3",
            "line 19: a frame has 4 numbers, but this one has 3",
        ),
        (
            19,
            "1 2 3 4 5",
            "line 19: a frame has 4 numbers, but this one has 5",
        ),
        (20, "1 2 x 4", "line 20: \"x\" is not a number"),
        (20, "1 2 NaN 4", "line 20: \"NaN\" is not a finite number"),
        (20, "1 2 3 \0", "line 20: the file is not UTF-8 text"),
    ] {
        let error = bvh::parse(small_with(line, text).as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let still = SMALL
        .replace("CHANNELS 3 Xposition Zrotation Xrotation", "CHANNELS 0")
        .replace("1 Xrotation", "0");
    let message = bvh::parse(still.as_bytes()).unwrap_err().to_string();
    assert_eq!(message, "line 16: no joint has a channel");
    assert_eq!(
        bvh::parse(b"").unwrap_err().to_string(),
        "line 1: the file ends; expected HIERARCHY"
    );
    let binary = bvh::parse(b"HIERARCHY\nROOT \xff\n").unwrap_err();
    assert_eq!(binary.to_string(), "line 2: the file is not UTF-8 text");
}

/// A file that ends with its last frame but one is like one that announces a frame too many.
#[test]
fn a_file_cut_short_anywhere_is_an_error_or_one_frame_short() {
    let end = SMALL.trim_end().len();
    let first_frame = SMALL.find("5 6 7 8").unwrap();
    for length in 0..end {
        let cut = bvh::parse(&SMALL.as_bytes()[..length]);
        if (first_frame - 1..=first_frame).contains(&length) {
            let motion = cut.unwrap();
            assert_eq!((motion.frame_count(), motion.warnings().len()), (1, 1));
        } else {
            assert!(cut.is_err(), "cut at byte {length}");
        }
    }
    assert!(
        bvh::parse(&SMALL.as_bytes()[..end])
            .unwrap()
            .warnings()
            .is_empty()
    );
}

#[test]
fn a_frame_more_or_fewer_than_announced_is_a_warning() {
    for announced in [1, 3] {
        let motion =
            bvh::parse(small_with(17, &format!("Frames: {announced}")).as_bytes()).unwrap();
        assert_eq!(motion.frame_count(), 2);
        assert_eq!(motion.frame(1).unwrap(), [5.0, 6.0, 7.0, 8.0]);
        assert_eq!(
            motion.warnings(),
            [BvhWarning::FrameCount {
                line: 17,
                announced,
                found: 2
            }]
        );
        assert_eq!(
            motion.warnings()[0].to_string(),
            format!("line 17 announces {announced} frames, but the file has 2, which are used")
        );
    }
    // A recording without frames is not one frame short.
    let text = small_with(17, "Frames: 1");
    let empty = &text[..text.find("1 2 3 4").unwrap()];
    let message = bvh::parse(empty.as_bytes()).unwrap_err().to_string();
    assert_eq!(message, "line 18: the file announces 1 frames and has 0");
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
    let added = [[0.5, 9.0, 1.0], [0.0; 3], [0.1, 0.0, 0.0]];
    // In place of the offsets, the root's as well.
    let in_place = [[0.5, 10.0, 1.0], [0.0, -4.0, 1.0], [3.1, 0.0, 0.0]];
    let added = bvh::parse(six_channels(added, 1.0).as_bytes()).unwrap();
    let in_place = bvh::parse(six_channels(in_place, 1.0).as_bytes()).unwrap();
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
        let motion = bvh::parse(text.as_bytes()).unwrap();
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
    assert_eq!(bvh::parse(dense.as_bytes()), bvh::parse(SMALL.as_bytes()));
}

#[test]
fn names_may_be_of_several_words_and_roots_may_be_several() {
    let text = SMALL.replace(
        "MOTION",
        "ROOT  left hand\n{ CHANNELS 0 OFFSET 1 2 3 }\nMOTION",
    );
    let motion = bvh::parse(text.as_bytes()).unwrap();
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
    let motion = bvh::parse(text.as_bytes()).unwrap();
    assert_eq!(
        (motion.joints().len(), motion.frame_count()),
        (depth + 1, 0)
    );
}

#[test]
fn errors_name_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("walk.bvh");
    std::fs::write(&path, &SMALL[..SMALL.len() - 3]).unwrap();
    let message = bvh::read(&path).unwrap_err().to_string();
    assert_eq!(
        message,
        format!(
            "{}: line 20: a frame has 4 numbers, but this one has 3",
            path.display()
        )
    );
    let message = bvh::read(folder.path().join("none.bvh"))
        .unwrap_err()
        .to_string();
    assert!(
        message.starts_with("cannot read ") && message.contains("none.bvh: "),
        "{message}"
    );
}

/// The channels and the offset of a joint.
type Link = (Vec<Channel>, [f64; 3]);

/// A chain of joints with channels in any order, and frames, as text and as values.
fn chains() -> impl Strategy<Value = (String, Vec<Link>, Vec<Vec<f64>>)> {
    use Channel::{Position, Rotation};
    let all = [
        Position(0),
        Position(1),
        Position(2),
        Rotation(0),
        Rotation(1),
        Rotation(2),
    ];
    let channels = Just(all.to_vec())
        .prop_shuffle()
        .prop_flat_map(|all| (1..=6usize).prop_map(move |n| all[..n].to_vec()));
    let joint = (channels, proptest::array::uniform3(-10.0..10.0f64));
    (vec(joint, 1..6), 0usize..4).prop_flat_map(|(joints, frames)| {
        let width = joints
            .iter()
            .map(|(channels, _)| channels.len())
            .sum::<usize>();
        let frames = vec(vec(-180.0..180.0f64, width), frames);
        (Just(joints), frames).prop_map(|(joints, frames)| {
            let mut text = "HIERARCHY\n".to_owned();
            for (index, (channels, [x, y, z])) in joints.iter().enumerate() {
                let names: Vec<String> = channels.iter().copied().map(channel_name).collect();
                let keyword = if index == 0 { "ROOT" } else { "JOINT" };
                let (count, names) = (names.len(), names.join(" "));
                text += &format!(
                    "{keyword} j{index}\n{{\nOFFSET {x} {y} {z}\nCHANNELS {count} {names}\n"
                );
            }
            text += &"}\n".repeat(joints.len());
            text += &format!("MOTION\nFrames: {}\nFrame Time: 0.5\n", frames.len());
            for frame in &frames {
                text += &frame
                    .iter()
                    .map(f64::to_string)
                    .collect::<Vec<_>>()
                    .join(" ");
                text.push('\n');
            }
            (text, joints, frames)
        })
    })
}

fn check(motion: &Bvh, joints: &[Link], frames: &[Vec<f64>]) -> Result<(), TestCaseError> {
    prop_assert_eq!(motion.joints().len(), joints.len());
    let mut first = 0;
    for (index, (joint, (channels, offset))) in motion.joints().iter().zip(joints).enumerate() {
        prop_assert_eq!(&joint.channels, channels);
        prop_assert_eq!(&joint.offset, offset);
        prop_assert_eq!(joint.parent, index.checked_sub(1));
        prop_assert_eq!(joint.first_channel, first);
        first += channels.len();
    }
    prop_assert_eq!(motion.frame_count(), frames.len());
    for (index, frame) in frames.iter().enumerate() {
        prop_assert_eq!(motion.frame(index), Some(&frame[..]));
    }
    Ok(())
}

proptest! {
    #[test]
    fn what_was_written_is_read((text, joints, frames) in chains()) {
        check(&bvh::parse(text.as_bytes()).unwrap(), &joints, &frames)?;
    }

    #[test]
    fn any_order_of_channels_is_obeyed((text, joints, frames) in chains()) {
        let motion = bvh::parse(text.as_bytes()).unwrap();
        for (index, frame) in frames.iter().enumerate() {
            let places = motion.joint_positions(index).unwrap();
            for (ours, known) in places.iter().zip(places_by_matrices(&joints, frame)) {
                for (ours, known) in ours.iter().zip(known) {
                    prop_assert!((ours - known).abs() < 1e-11, "{} is not {}", ours, known);
                }
            }
        }
    }

    #[test]
    fn no_damage_makes_it_panic_or_yield_a_number_that_is_not_finite(
        (text, ..) in chains(),
        damage in vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let mut bytes = text.into_bytes();
        for (place, byte) in damage {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if let Ok(motion) = bvh::parse(&bytes) {
            for frame in 0..motion.frame_count() {
                prop_assert!(motion.frame(frame).unwrap().iter().all(|x| x.is_finite()));
            }
        }
    }

    #[test]
    fn no_bytes_make_it_panic(bytes in vec(any::<u8>(), 0..200)) {
        let _ = bvh::parse(&bytes);
    }
}
