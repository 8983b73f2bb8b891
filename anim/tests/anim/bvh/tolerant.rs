//! Files that other programs read although they deviate from the format: the same motion, with a
//! warning for each kind, and an error in a strict reading.

use ga_anim::bvh::{self, Bvh, BvhWarning};
use ga_files::Reading;
use proptest::collection::vec;
use proptest::prelude::*;

const HIERARCHY: &str = "HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine
  {
    OFFSET 0 10 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Head
    {
      OFFSET 0 8 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 5 0
      }
    }
  }
}
";
const ROWS: [&str; 3] = [
    "0 100 0 10 20 30 5 6 7 1 2 3",
    "1 101 0 11 21 31 6 7 8 2 3 4",
    "2 102 0 12 22 32 7 8 9 3 4 5",
];

fn valid() -> String {
    let rows = ROWS.join("\n");
    format!("{HIERARCHY}MOTION\nFrames: 3\nFrame Time: 0.0333333\n{rows}\n")
}

/// The numbers of all frames, so many in a line.
fn in_lines_of(length: usize, rows: &[&str]) -> String {
    let words: Vec<&str> = rows.iter().flat_map(|row| row.split(' ')).collect();
    let lines = words.chunks(length).map(|line| line.join(" ") + "\n");
    lines.collect()
}

/// What a file says without the names of its joints.
fn numbers(motion: &Bvh) -> (Vec<Vec<[f64; 3]>>, f64) {
    let frames = 0..motion.frame_count();
    let places = frames.map(|frame| motion.joint_positions(frame).unwrap());
    (places.collect(), motion.frame_time())
}

fn kinds(motion: &Bvh) -> Vec<(&str, Option<usize>)> {
    let warnings = motion.warnings().iter();
    warnings
        .map(|warning| (warning.kind(), warning.line()))
        .collect()
}

/// assimp 5.2 reads the wrapped rows, the carriage returns and the names as here, the Python
/// package bvh 0.3 most of the others: three joints and three frames.
#[test]
fn deviations_give_the_motion_that_other_readers_give() {
    let plain = bvh::decode(valid().as_bytes()).unwrap();
    assert_eq!(plain.warnings(), []);
    let with = |from: &str, to: &str| valid().replace(from, to);
    let wrapped: String = ROWS.iter().map(|row| in_lines_of(5, &[row])).collect();
    let rows = format!("{}\n", ROWS.join("\n"));
    for (text, kind, line) in [
        (with("End Site", "End Site Head_End"), "end_site_name", 14),
        (with("End Site", "End Site Head End"), "end_site_name", 14),
        (with("Frames: ", "Frames:"), "missing_blank", 22),
        (with("Frames: ", "Frames :"), "missing_blank", 22),
        (with("Frames: ", "Frames : "), "missing_blank", 22),
        (with("Frames: ", "Frames "), "missing_blank", 22),
        (with("Time: ", "Time:"), "missing_blank", 23),
        (with("Frames: 3", "Frames: 1"), "frame_count", 22),
        (with("Frames: 3", "Frames: 0"), "frame_count", 22),
        (with("Frames: 3", "Frames: 5"), "frame_count", 22),
        (with("Frames: 3", "Frames: 5000"), "frame_count", 22),
        (with(&rows, &wrapped), "wrapped_frames", 24),
        (with(&rows, &in_lines_of(7, &ROWS)), "wrapped_frames", 24),
        (with(&rows, &in_lines_of(1, &ROWS)), "wrapped_frames", 24),
        (with(&rows, &in_lines_of(36, &ROWS)), "wrapped_frames", 24),
        (with("JOINT Head", "JOINT Spine"), "duplicate_name", 10),
        (with("CHANNELS 6", "CHANNELS 3"), "channel_count", 5),
        (with("CHANNELS 6", "CHANNELS 7"), "channel_count", 5),
        (valid() + "end of file\nno more\n\n", "extra_text", 27),
        (with("MOTION", "MOTION data"), "extra_text", 21),
        (with("Frames: 3", "Frames: 3 in all"), "extra_text", 22),
        (with("0.0333333", "0.0333333 s"), "extra_text", 23),
        (with("\n", "\r"), "line_ends", 1),
    ] {
        let motion = bvh::decode(text.as_bytes()).unwrap();
        assert_eq!(numbers(&motion), numbers(&plain), "{kind} {line}");
        assert_eq!(kinds(&motion), [(kind, Some(line))]);
        // One frame more or fewer is a warning in either reading.
        let refused = bvh::decode_as(text.as_bytes(), Reading::Strict);
        let refused = refused.unwrap_err().to_string();
        let line = match kind {
            "frame_count" if text.contains("Frames: 5") => 26,
            "frame_count" if text.contains("Frames: 1") => 26,
            "frame_count" => 25,
            _ => line,
        };
        assert!(
            refused.starts_with(&format!("line {line}: ")),
            "{kind}: {refused}"
        );
    }
    for (text, expected) in [
        (with(" ", "\t"), &plain),
        (with("\n", "\r\n"), &plain),
        (with("\n", "\r\r\n"), &plain),
        (with("\n", "\n\n"), &plain),
        (valid().to_lowercase().replace("hips", "Hips"), &plain),
    ] {
        let motion = bvh::decode_as(text.as_bytes(), Reading::Strict).unwrap();
        assert_eq!(numbers(&motion), numbers(expected));
        assert_eq!(motion.warnings(), []);
    }
}

/// As assimp: the joint is there and does not move.
#[test]
fn a_joint_without_channels_does_not_move() {
    let spine = "    CHANNELS 3 Zrotation Xrotation Yrotation\n    JOINT";
    let rows = "0 100 0 10 20 30 1 2 3\n1 101 0 11 21 31 2 3 4\n";
    let text = valid().replace(spine, "    JOINT");
    let text = text.replace(&format!("{}\n{}\n{}\n", ROWS[0], ROWS[1], ROWS[2]), rows);
    let text = text.replace("Frames: 3", "Frames: 2");
    let motion = bvh::decode(text.as_bytes()).unwrap();
    assert_eq!(kinds(&motion), [("no_channels", Some(18))]);
    assert_eq!(
        motion.warnings()[0].to_string(),
        "line 18: joint \"Spine\" has 0 CHANNELS lines instead of one; the joint does not move"
    );
    assert_eq!(motion.joints().len(), 3);
    let same = text.replace("OFFSET 0 10 0\n", "OFFSET 0 10 0\n CHANNELS 0\n");
    let same = bvh::decode(same.as_bytes()).unwrap();
    assert_eq!(
        (numbers(&motion), same.warnings()),
        (numbers(&same), &[][..])
    );
}

#[test]
fn later_joints_of_a_name_get_another() {
    let text = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xrotation\nJOINT a { OFFSET 0 1 0 CHANNELS 0\n\
                JOINT a { OFFSET 0 1 0 CHANNELS 0\nJOINT a.001 { OFFSET 0 1 0 CHANNELS 0 } } } }\n\
                MOTION Frames: 1 Frame Time: 1\n0\n";
    let motion = bvh::decode(text.as_bytes()).unwrap();
    let names: Vec<&str> = motion
        .joints()
        .iter()
        .map(|joint| &joint.name[..])
        .collect();
    assert_eq!(names, ["a", "a.002", "a.003", "a.001"]);
    assert_eq!(
        motion.warnings()[0].to_string(),
        "line 2: two joints are called \"a\"; the later one is read as \"a.002\" (2 such lines)"
    );
}

#[test]
fn names_in_other_encodings_are_read_and_said() {
    for (name, expected, encoding) in [
        (&b"R\xfccken"[..], "Rücken", "Latin-1"),
        (b"\x8f\xe3\x94\xbc\x90g", "上半身", "Shift-JIS"),
        (b"\x83Z\x83\x93\x83^\x81[", "センター", "Shift-JIS"),
    ] {
        let [before, after] = valid()
            .split_once("Spine")
            .map(|(before, after)| [before.to_owned(), after.to_owned()])
            .unwrap();
        let bytes = [before.as_bytes(), name, after.as_bytes()].concat();
        let motion = bvh::decode(&bytes).unwrap();
        assert_eq!(motion.joints()[1].name, expected);
        let message = format!("line 6: the file is not UTF-8 text; it is read as {encoding}");
        assert_eq!(motion.warnings()[0].to_string(), message);
        let refused = bvh::decode_as(&bytes, Reading::Strict).unwrap_err();
        assert_eq!(refused.to_string(), "line 6: the file is not UTF-8 text");
    }
}

#[test]
fn what_has_no_meaning_stays_an_error() {
    let with = |from: &str, to: &str| valid().replace(from, to);
    for (text, message) in [
        (
            with(" 6 7 8", " 6 7"),
            "line 25: a frame has 12 numbers, but this one has 11",
        ),
        (
            with(" 6 7 8", " 6 7 8 9"),
            "line 25: a frame has 12 numbers, but this one has 13",
        ),
        (
            with("3 4 5", "3 4"),
            "line 26: a frame has 12 numbers, but this one has 11",
        ),
        (with(" 6 7 8", " 6 x 8"), "line 25: \"x\" is not a number"),
        (with("2 102", "x 102"), "line 26: \"x\" is not a number"),
        (
            with("2 102", "nan 102"),
            "line 26: \"nan\" is not a finite number",
        ),
        (
            with("1 101", "end\n1 101"),
            "line 25: \"end\" is not a number",
        ),
        (
            with("Frames: 3", "Frames: 4") + "end\n",
            "line 27: \"end\" is not a number",
        ),
        (
            with("2 102", "three frames\n2 102"),
            "line 26: \"three\" is not a number",
        ),
        (
            with("0.0333333", "0.0333333 7"),
            "line 23: expected the end of the line, found \"7\"",
        ),
        (
            with("CHANNELS 6 X", "CHANNELS 6 W"),
            "line 5: \"Wposition\" is not a channel",
        ),
        (
            with("    OFFSET 0 10 0\n", ""),
            "line 18: joint \"Spine\" has 0 OFFSET lines instead of one",
        ),
    ] {
        assert_eq!(
            bvh::decode(text.as_bytes()).unwrap_err().to_string(),
            message
        );
    }
    // What one frame lacks and another has too much would shift those between.
    let shifted = with(" 1 2 3\n", " 1 2\n").replace(" 3 4 5\n", " 3 4 5 6\n");
    let two = shifted
        .replace(ROWS[1], "")
        .replace("Frames: 3", "Frames: 2");
    for text in [shifted, two] {
        let message = bvh::decode(text.as_bytes()).unwrap_err().to_string();
        assert_eq!(
            message,
            "line 24: a frame has 12 numbers, but this one has 11"
        );
    }
    let none = valid();
    let none = &none[..none.find(ROWS[0]).unwrap()];
    let message = bvh::decode(none.as_bytes()).unwrap_err().to_string();
    assert_eq!(message, "line 23: the file announces 3 frames and has 0");
}

proptest! {
    /// Any of the deviations together change nothing in the motion, and each has its warning.
    #[test]
    fn deviations_do_not_change_the_motion(
        chosen in vec(any::<bool>(), 9),
        length in 1..40usize,
        ends in prop_oneof![Just("\n"), Just("\r\n"), Just("\r")],
    ) {
        let mut text = valid();
        let mut expected = Vec::new();
        let edits = [
            ("End Site", "End Site of Head", "end_site_name"),
            ("Frames: ", "Frames:", "missing_blank"),
            ("Time: ", "Time:", "missing_blank"),
            ("CHANNELS 6", "CHANNELS 5", "channel_count"),
            ("JOINT Head", "JOINT Spine", "duplicate_name"),
            ("MOTION", "MOTION of a person", "extra_text"),
            ("JOINT", "\t joint", ""),
            ("OFFSET", "Offset\t", ""),
        ];
        for ((from, to, kind), is_chosen) in edits.into_iter().zip(&chosen) {
            if *is_chosen {
                text = text.replace(from, to);
                expected.push(kind);
            }
        }
        if chosen[8] {
            let begin = text.find(ROWS[0]).unwrap();
            text.truncate(begin);
            text += &in_lines_of(length, &ROWS);
            if length != 12 {
                expected.push("wrapped_frames");
            }
        }
        if ends == "\r" {
            expected.push("line_ends");
        }
        let motion = bvh::decode(text.replace('\n', ends).as_bytes()).unwrap();
        let plain = bvh::decode(valid().as_bytes()).unwrap();
        prop_assert_eq!(numbers(&motion), numbers(&plain));
        expected.retain(|kind| !kind.is_empty());
        expected.sort_unstable();
        expected.dedup();
        let mut found: Vec<&str> = motion.warnings().iter().map(BvhWarning::kind).collect();
        found.sort_unstable();
        prop_assert_eq!(found, expected);
        let strict = bvh::decode_as(text.as_bytes(), Reading::Strict);
        let deviates = motion.warnings().iter().any(|warning| warning.kind() != "line_ends");
        prop_assert_eq!(strict.is_err(), deviates);
    }

    /// Words of the format in any places: what a strict reading takes is the same in a tolerant
    /// one.
    #[test]
    fn a_strict_reading_is_a_tolerant_one(
        edits in vec((any::<prop::sample::Index>(), 0..WORDS.len(), 0..3usize), 0..4),
    ) {
        let mut text = valid();
        for (place, word, removed) in edits {
            let place = place.index(text.len() - 3);
            text.replace_range(place..place + removed, WORDS[word]);
        }
        let read = bvh::decode(text.as_bytes());
        if let Ok(motion) = &read {
            for frame in 0..motion.frame_count() {
                let frame = motion.frame(frame).unwrap();
                prop_assert!(frame.iter().all(|x| x.is_finite()));
                prop_assert_eq!(frame.len(), motion.channel_count());
            }
        }
        if let Ok(motion) = bvh::decode_as(text.as_bytes(), Reading::Strict) {
            prop_assert_eq!(read.unwrap(), motion);
        }
    }
}

const WORDS: [&str; 14] = [
    "",
    " ",
    "\n",
    "\r",
    "{",
    "}",
    " 1 ",
    "\nEnd Site",
    " Xrotation ",
    ":",
    "x",
    "\nOFFSET 0 0 0",
    " nan ",
    "\nCHANNELS 1 Xrotation",
];
