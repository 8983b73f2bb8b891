//! The usual names of joints: Mixamo's (`mixamorig:LeftUpLeg`), MakeHuman's (`upperleg01.L`,
//! `thigh_l`), CMU's (`LeftUpLeg`, `LHipJoint`), 3ds Max Biped's (`Bip01 L Thigh`) and names such
//! as `UpperLeg_L`.

use std::ops::Range;

/// A side of a body, as its own left and right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

impl Side {
    /// The side that a word names, in any case.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let names = |known: [&str; 2]| known.iter().any(|known| word.eq_ignore_ascii_case(known));
        if names(["l", "left"]) {
            Some(Self::Left)
        } else {
            names(["r", "right"]).then_some(Self::Right)
        }
    }
}

/// A part of the body that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Part {
    Hips,
    /// The hips where the skeleton has no other name for them.
    Root,
    Spine,
    Neck,
    Head,
    /// A clavicle, or an upper arm where the skeleton has no other name for it.
    Shoulder,
    UpperArm,
    LowerArm,
    Hand,
    /// An upper leg where the skeleton has no other name for it.
    SideOfHips,
    UpperLeg,
    LowerLeg,
    Foot,
    Toes,
    /// The digit, 0 for the thumb, and the joint of the digit, 1 for the one at the hand.
    Digit(u8, u8),
}

/// The part and the side that a name stands for, if it is a usual one.
pub(super) fn meaning(name: &str) -> Option<(Part, Option<Side>)> {
    // What stands before a colon is the name of a scene or a rig.
    let name = name.rsplit(':').next()?;
    let (mut words, mut numbers, mut side) = (String::new(), String::new(), None);
    for word in words_of(name) {
        if let Some(found) = Side::of_word(&word) {
            side = Some(found);
            continue;
        }
        match word.as_str() {
            "mixamorig" | "bip" | "bone" | "def" | "jnt" | "joint" => {
                // The number of a Biped is not that of a joint.
                numbers.clear();
                if word == "joint" {
                    words += "joint";
                }
            }
            _ if word.bytes().all(|byte| byte.is_ascii_digit()) => numbers += &word,
            _ => words += &word,
        }
    }
    if side.is_none() {
        for (prefix, found) in [("left", Side::Left), ("right", Side::Right)] {
            if let Some(rest) = words.strip_prefix(prefix) {
                (words, side) = (rest.to_owned(), Some(found));
            }
        }
    }
    if name.to_ascii_lowercase().starts_with("bip") && words.is_empty() {
        return None;
    }
    let part = part(&words, &numbers)?;
    // A part of which there are two has a side, and the others have none.
    let in_the_middle = matches!(part, Part::Root | Part::Spine | Part::Neck | Part::Head);
    match (part, side) {
        (Part::Hips, Some(_)) => Some((Part::SideOfHips, side)),
        (Part::Hips, None) => Some((part, None)),
        _ => (side.is_none() == in_the_middle).then_some((part, side)),
    }
}

fn part(words: &str, numbers: &str) -> Option<Part> {
    Some(match words {
        "hips" | "hip" | "pelvis" => Part::Hips,
        "root" => Part::Root,
        "spine" | "chest" | "upperchest" | "torso" | "abdomen" | "lowerback" | "waist" => {
            Part::Spine
        }
        "neck" => Part::Neck,
        "head" => Part::Head,
        "shoulder" | "clavicle" | "collar" | "collarbone" => Part::Shoulder,
        "arm" | "upperarm" | "uparm" => Part::UpperArm,
        "forearm" | "lowerarm" | "lowarm" | "elbow" => Part::LowerArm,
        "hand" | "wrist" => Part::Hand,
        "upleg" | "upperleg" | "thigh" => Part::UpperLeg,
        "leg" | "lowerleg" | "lowleg" | "calf" | "shin" | "knee" => Part::LowerLeg,
        "foot" | "ankle" => Part::Foot,
        "toe" | "toes" | "toebase" | "ball" => Part::Toes,
        _ => return digit(words.strip_prefix("hand").unwrap_or(words), numbers),
    })
}

/// A finger: by its name and the number of the joint, or, as Biped has it, by the digit from 0 and
/// the number of the joint.
fn digit(words: &str, numbers: &str) -> Option<Part> {
    let names = ["thumb", "index", "middle", "ring"];
    let named = names
        .iter()
        .position(|&name| words == name || words == format!("{name}finger"));
    let named = named.or(matches!(words, "pinky" | "little" | "pinkyfinger").then_some(4));
    if let Some(digit) = named {
        let joint: u8 = numbers.parse().ok()?;
        return Some(Part::Digit(u8::try_from(digit).ok()?, joint));
    }
    let digits: Vec<u8> = numbers.bytes().map(|byte| byte - b'0').collect();
    match (words, digits.as_slice()) {
        ("finger", &[digit @ 0..=4]) => Some(Part::Digit(digit, 1)),
        ("finger", &[digit @ 0..=4, joint @ 1..=3]) => Some(Part::Digit(digit, joint + 1)),
        _ => None,
    }
}

/// The words and the numbers of a name in small letters, as [`word_ranges`] finds them.
fn words_of(name: &str) -> impl Iterator<Item = String> {
    let ranges = word_ranges(name).into_iter();
    ranges.map(move |range| name[range].to_lowercase())
}

/// Where the words and the numbers of a name are: they are divided at spaces and signs, between
/// small and capital letters, and between letters and digits.
pub(crate) fn word_ranges(name: &str) -> Vec<Range<usize>> {
    let characters: Vec<(usize, char)> = name.char_indices().collect();
    let mut ranges: Vec<Range<usize>> = Vec::new();
    let mut before: Option<char> = None;
    for (index, &(start, character)) in characters.iter().enumerate() {
        if !character.is_alphanumeric() {
            before = None;
            continue;
        }
        let after = characters.get(index + 1).map(|&(_, after)| after);
        let begins = before.is_none_or(|before| {
            before.is_ascii_digit() != character.is_ascii_digit()
                || (before.is_lowercase() && character.is_uppercase())
                // The last capital of several begins a word: `LThumb`.
                || (before.is_uppercase()
                    && character.is_uppercase()
                    && after.is_some_and(char::is_lowercase))
        });
        let end = start + character.len_utf8();
        match ranges.last_mut() {
            Some(range) if !begins => range.end = end,
            _ => ranges.push(start..end),
        }
        before = Some(character);
    }
    ranges
}
