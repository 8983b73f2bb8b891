//! Faults of BVH files: each is named with its line, or is a warning.

use ga_anim::MotionFileError;
use ga_anim::bvh::{self, Bvh, BvhWarning};
use ga_files::Reading;

use super::{SMALL, small_with};

fn strict(text: &[u8]) -> Result<Bvh, MotionFileError> {
    bvh::decode_as(text, Reading::Strict)
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
            "line 5: joint \"Hip\" announces 4 channels and lists 3",
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
        let error = strict(small_with(line, text).as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let still = SMALL
        .replace("CHANNELS 3 Xposition Zrotation Xrotation", "CHANNELS 0")
        .replace("1 Xrotation", "0");
    let message = strict(still.as_bytes()).unwrap_err().to_string();
    assert_eq!(message, "line 16: no joint has a channel");
    assert_eq!(
        bvh::decode(b"").unwrap_err().to_string(),
        "line 1: the file ends; expected HIERARCHY"
    );
    let binary = strict(b"HIERARCHY\nROOT \xff\n").unwrap_err();
    assert_eq!(binary.to_string(), "line 2: the file is not UTF-8 text");
}

/// A file that ends with its last frame but one is like one that announces a frame too many.
#[test]
fn a_file_cut_short_anywhere_is_an_error_or_one_frame_short() {
    let end = SMALL.trim_end().len();
    let first_frame = SMALL.find("5 6 7 8").unwrap();
    for length in 0..end {
        let cut = strict(&SMALL.as_bytes()[..length]);
        if (first_frame - 1..=first_frame).contains(&length) {
            let motion = cut.unwrap();
            assert_eq!((motion.frame_count(), motion.warnings().len()), (1, 1));
        } else {
            assert!(cut.is_err(), "cut at byte {length}");
        }
    }
    assert!(
        bvh::decode(&SMALL.as_bytes()[..end])
            .unwrap()
            .warnings()
            .is_empty()
    );
}

#[test]
fn a_frame_more_or_fewer_than_announced_is_a_warning() {
    for announced in [1, 3] {
        let motion =
            bvh::decode(small_with(17, &format!("Frames: {announced}")).as_bytes()).unwrap();
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
    let message = bvh::decode(empty.as_bytes()).unwrap_err().to_string();
    assert_eq!(message, "line 18: the file announces 1 frames and has 0");
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
