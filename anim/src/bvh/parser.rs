use std::collections::HashSet;

use super::root_offset::root_positions;
use super::words::{Words, number};
use super::{Bvh, BvhJoint, BvhProblem, BvhWarning, Channel, PositionChannels, warning};
use crate::file_error::MotionFileError;

pub(super) fn parse(bytes: &[u8]) -> Result<Bvh, MotionFileError> {
    let mut words = Words::new(text(bytes)?);
    words.expect("HIERARCHY")?;
    let joints = hierarchy(&mut words)?;
    motion(&mut words, joints)
}

fn text(bytes: &[u8]) -> Result<&str, MotionFileError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let end = match std::str::from_utf8(bytes) {
        Ok(text) => match text.find('\0') {
            None => return Ok(text),
            Some(end) => end,
        },
        Err(error) => error.valid_up_to(),
    };
    let line = 1 + bytes[..end].iter().filter(|&&byte| byte == b'\n').count();
    Err(MotionFileError::Bvh {
        line,
        problem: BvhProblem::NotText,
    })
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
    let mut names = HashSet::new();
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
                    open.push(begin(words, &mut joints, &mut names, None)?)
                }
                word if word.eq_ignore_ascii_case("MOTION") && !joints.is_empty() => {
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
                open.push(begin(words, &mut joints, &mut names, parent)?);
            }
            "END" => {
                words.expect("Site")?;
                once(
                    words,
                    joint,
                    "End Site",
                    1 + usize::from(joint.end_site.is_some()),
                )?;
                words.expect("{")?;
                words.expect("OFFSET")?;
                joint.end_site = Some(words.vector()?);
                words.expect("}")?;
            }
            "}" => {
                once(words, joint, "OFFSET", top.offsets)?;
                once(words, joint, "CHANNELS", top.channels)?;
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
    Err(words.error(BvhProblem::NotOnce {
        joint: joint.name.clone(),
        what,
        found,
    }))
}

fn begin(
    words: &mut Words,
    joints: &mut Vec<BvhJoint>,
    names: &mut HashSet<String>,
    parent: Option<usize>,
) -> Result<Open, MotionFileError> {
    let name = words.name()?;
    if !names.insert(name.clone()) {
        return Err(words.error(BvhProblem::DuplicateName { name }));
    }
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

fn channels(words: &mut Words, joint: &mut BvhJoint) -> Result<(), MotionFileError> {
    let count = words.count()?;
    for _ in 0..count {
        let word = words.next("a channel")?;
        let Some(channel) = channel(word) else {
            return Err(words.error(BvhProblem::UnknownChannel {
                word: word.to_owned(),
            }));
        };
        if joint.channels.contains(&channel) {
            let (joint, word) = (joint.name.clone(), word.to_owned());
            return Err(words.error(BvhProblem::DuplicateChannel { joint, word }));
        }
        joint.channels.push(channel);
    }
    Ok(())
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

fn motion(words: &mut Words, mut joints: Vec<BvhJoint>) -> Result<Bvh, MotionFileError> {
    let mut channel_count = 0;
    for joint in &mut joints {
        joint.first_channel = channel_count;
        channel_count += joint.channels.len();
    }
    if channel_count == 0 {
        return Err(words.error(BvhProblem::NoChannels));
    }
    words.expect("Frames:")?;
    let announced = words.count()?;
    let announced_on_line = words.line();
    words.expect("Frame")?;
    words.expect("Time:")?;
    let frame_time = words.number()?;
    if frame_time <= 0.0 {
        return Err(words.error(BvhProblem::FrameTime(frame_time)));
    }
    words.expect_end_of_line()?;

    let mut values = Vec::new();
    let mut found = 0;
    while let Some(line) = words.next_line() {
        let before = values.len();
        for word in line {
            values.push(number(word).map_err(|problem| words.error(problem))?);
        }
        match values.len() - before {
            0 => continue,
            length if length != channel_count => {
                return Err(words.error(BvhProblem::FrameLength {
                    expected: channel_count,
                    found: length,
                }));
            }
            _ => found += 1,
        }
        if found > announced.saturating_add(1) {
            return Err(words.error(BvhProblem::FrameCount {
                expected: announced,
                found,
            }));
        }
    }
    if found.abs_diff(announced) > 1 || (found == 0 && announced > 0) {
        return Err(words.error(BvhProblem::FrameCount {
            expected: announced,
            found,
        }));
    }
    let mut warnings = Vec::new();
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
