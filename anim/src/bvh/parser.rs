use std::collections::{HashMap, HashSet};

use ga_files::Reading;
use ga_files::text::{self, Encoding};

use super::frames::frames;
use super::root_offset::root_positions;
use super::words::{Words, number};
use super::{Bvh, BvhJoint, BvhProblem, BvhWarning, Channel, PositionChannels, warning};
use crate::file_error::MotionFileError;

pub(super) fn parse(bytes: &[u8], reading: Reading) -> Result<Bvh, MotionFileError> {
    let decoded = text::decode(bytes);
    let (text, encoding) = decoded.map_err(|text::NotText(place)| MotionFileError::Bvh {
        line: text::line_of(bytes, place),
        problem: BvhProblem::NotText,
    })?;
    let mut words = Words::new(&text, reading);
    if encoding != Encoding::Utf8 {
        let (line, count) = lines_not_utf8(bytes);
        words.tolerate_at(line, count, BvhProblem::NotUtf8 { encoding })?;
    }
    words.expect("HIERARCHY")?;
    let joints = hierarchy(&mut words)?;
    motion(words, joints)
}

/// The first line that is not UTF-8, and how many are not.
fn lines_not_utf8(bytes: &[u8]) -> (usize, usize) {
    let (mut line, mut first, mut count) = (0, 1, 0);
    let mut rest = Some(bytes);
    while let Some(text) = rest {
        line += 1;
        let end = text::line_end(text);
        rest = end.as_ref().map(|end| &text[end.end..]);
        if std::str::from_utf8(&text[..end.map_or(text.len(), |end| end.start)]).is_err() {
            if count == 0 {
                first = line;
            }
            count += 1;
        }
    }
    (first, count)
}

/// A joint whose block has begun and not ended, and which lines it has had.
struct Open {
    joint: usize,
    offsets: usize,
    channels: usize,
}

/// The joints up to the word `MOTION`, which is taken too. A stack takes the place of recursion, so
/// that no depth is too great.
fn hierarchy(words: &mut Words) -> Result<Vec<BvhJoint>, MotionFileError> {
    const IN_JOINT: &str = "OFFSET, CHANNELS, JOINT, End Site or }";
    let mut joints: Vec<BvhJoint> = Vec::new();
    let mut lines = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    loop {
        let Some(top) = open.last_mut() else {
            let expected = if joints.is_empty() {
                "ROOT"
            } else {
                "ROOT or MOTION"
            };
            match words.next(expected)? {
                word if word.eq_ignore_ascii_case("ROOT") => {
                    open.push(begin(words, &mut joints, &mut lines, None)?)
                }
                word if word.eq_ignore_ascii_case("MOTION") && !joints.is_empty() => {
                    make_names_unique(words, &mut joints, &lines)?;
                    return Ok(joints);
                }
                word => return Err(words.expected(expected, word)),
            }
            continue;
        };
        let word = words.next(IN_JOINT)?;
        let joint = &mut joints[top.joint];
        match word.to_ascii_uppercase().as_str() {
            "OFFSET" => {
                joint.offset = words.vector()?;
                top.offsets += 1;
                once(words, joint, "OFFSET", top.offsets)?;
            }
            "CHANNELS" => {
                top.channels += 1;
                once(words, joint, "CHANNELS", top.channels)?;
                channels(words, joint)?;
            }
            "JOINT" => {
                let parent = Some(top.joint);
                open.push(begin(words, &mut joints, &mut lines, parent)?);
            }
            "END" => {
                words.expect("Site")?;
                once(
                    words,
                    joint,
                    "End Site",
                    1 + usize::from(joint.end_site.is_some()),
                )?;
                let name = words.name_of_end_site()?;
                if !name.is_empty() {
                    words.tolerate(BvhProblem::EndSiteName { name })?;
                }
                words.expect("{")?;
                words.expect("OFFSET")?;
                joint.end_site = Some(words.vector()?);
                words.expect("}")?;
            }
            "}" => {
                once(words, joint, "OFFSET", top.offsets)?;
                if top.channels == 0 {
                    words.tolerate(not_once(joint, "CHANNELS", 0))?;
                }
                open.pop();
            }
            _ => return Err(words.expected(IN_JOINT, word)),
        }
    }
}

fn once(
    words: &Words,
    joint: &BvhJoint,
    what: &'static str,
    found: usize,
) -> Result<(), MotionFileError> {
    if found == 1 {
        return Ok(());
    }
    Err(words.error(not_once(joint, what, found)))
}

fn not_once(joint: &BvhJoint, what: &'static str, found: usize) -> BvhProblem {
    BvhProblem::NotOnce {
        joint: joint.name.clone(),
        what,
        found,
    }
}

fn begin(
    words: &mut Words,
    joints: &mut Vec<BvhJoint>,
    lines: &mut Vec<usize>,
    parent: Option<usize>,
) -> Result<Open, MotionFileError> {
    let name = words.name()?;
    lines.push(words.line());
    words.expect("{")?;
    joints.push(BvhJoint {
        name,
        parent,
        offset: [0.0; 3],
        channels: Vec::new(),
        first_channel: 0,
        end_site: None,
    });
    Ok(Open {
        joint: joints.len() - 1,
        offsets: 0,
        channels: 0,
    })
}

/// Gives joints whose name an earlier one has a name of their own. `lines` has the line of each
/// joint.
fn make_names_unique(
    words: &mut Words,
    joints: &mut [BvhJoint],
    lines: &[usize],
) -> Result<(), MotionFileError> {
    let mut taken: HashSet<String> = joints.iter().map(|joint| joint.name.clone()).collect();
    let (mut seen, mut numbers) = (HashSet::new(), HashMap::new());
    for (joint, &line) in joints.iter_mut().zip(lines) {
        if seen.insert(joint.name.clone()) {
            continue;
        }
        let name = joint.name.clone();
        // Blender numbers such joints in the same way.
        let number = numbers.entry(name.clone()).or_insert(0_u64);
        while !taken.insert(joint.name.clone()) {
            *number += 1;
            joint.name = format!("{name}.{number:03}");
        }
        let instead = joint.name.clone();
        words.tolerate_at(line, 1, BvhProblem::DuplicateName { name, instead })?;
    }
    Ok(())
}

fn channels(words: &mut Words, joint: &mut BvhJoint) -> Result<(), MotionFileError> {
    let announced = words.count()?;
    let line = words.line();
    while let Some(word) = words.peek()? {
        let listed = joint.channels.len();
        let Some(channel) = channel(word) else {
            if listed < announced && !is_keyword(word) {
                words.next("a channel")?;
                return Err(words.error(BvhProblem::UnknownChannel {
                    word: word.to_owned(),
                }));
            }
            break;
        };
        if listed >= announced && words.reading() == Reading::Strict {
            break;
        }
        words.next("a channel")?;
        if joint.channels.contains(&channel) {
            let (joint, word) = (joint.name.clone(), word.to_owned());
            return Err(words.error(BvhProblem::DuplicateChannel { joint, word }));
        }
        joint.channels.push(channel);
    }
    let found = joint.channels.len();
    if found == announced {
        return Ok(());
    }
    let problem = BvhProblem::ChannelCount {
        joint: joint.name.clone(),
        announced,
        found,
    };
    words.tolerate_at(line, 1, problem)
}

/// Whether a word begins or ends something in a joint.
fn is_keyword(word: &str) -> bool {
    let mut keywords = ["OFFSET", "CHANNELS", "JOINT", "END", "{", "}"].iter();
    keywords.any(|keyword| word.eq_ignore_ascii_case(keyword))
}

fn channel(word: &str) -> Option<Channel> {
    Some(match word.to_ascii_lowercase().as_str() {
        "xposition" => Channel::Position(0),
        "yposition" => Channel::Position(1),
        "zposition" => Channel::Position(2),
        "xrotation" => Channel::Rotation(0),
        "yrotation" => Channel::Rotation(1),
        "zrotation" => Channel::Rotation(2),
        _ => return None,
    })
}

fn motion(mut words: Words, mut joints: Vec<BvhJoint>) -> Result<Bvh, MotionFileError> {
    let mut channel_count = 0;
    for joint in &mut joints {
        joint.first_channel = channel_count;
        channel_count += joint.channels.len();
    }
    if channel_count == 0 {
        return Err(words.error(BvhProblem::NoChannels));
    }
    let is_label = |word: &str| {
        word.get(..6)
            .is_some_and(|w| w.eq_ignore_ascii_case("Frames"))
    };
    if words
        .rest_of_line()
        .next()
        .is_some_and(|word| !is_label(word))
    {
        words.leave_out_text()?;
    }
    let word = words.labelled(["", "Frames:"])?;
    let announced = words.as_count(word)?;
    let announced_on_line = words.line();
    if !words
        .rest_of_line()
        .next()
        .is_some_and(|word| word.eq_ignore_ascii_case("Frame"))
    {
        words.leave_out_text()?;
    }
    let word = words.labelled(["Frame", "Time:"])?;
    let frame_time = number(word).map_err(|problem| words.error(problem))?;
    if frame_time <= 0.0 {
        return Err(words.error(BvhProblem::FrameTime(frame_time)));
    }
    words.leave_out_text()?;

    let values = frames(&mut words, channel_count, announced)?;
    let found = values.len() / channel_count;
    let is_far = found.abs_diff(announced) > 1 && words.reading() == Reading::Strict;
    if is_far || (found == 0 && announced > 0) {
        return Err(words.error(BvhProblem::FrameCount {
            expected: announced,
            found,
        }));
    }
    let deviations = words.into_deviations().into_iter();
    let mut warnings: Vec<BvhWarning> = deviations.map(BvhWarning::Deviation).collect();
    if found != announced {
        warnings.push(BvhWarning::FrameCount {
            line: announced_on_line,
            announced,
            found,
        });
    }
    let (positions, warning) = warning::position_channels(&joints, &values, channel_count);
    warnings.extend(warning);
    let mut motion = Bvh {
        joints,
        frame_time,
        frame_count: found,
        values,
        root_positions: PositionChannels::InPlace,
        positions,
        warnings,
    };
    motion.root_positions = root_positions(&motion);
    if motion.root_positions == PositionChannels::Added {
        motion.warnings.push(BvhWarning::RootPositionsAdded);
    }
    Ok(motion)
}
