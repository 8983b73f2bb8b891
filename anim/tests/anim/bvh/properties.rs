//! Files of any joints and channels, read as they were made, and damaged ones.

use ga_anim::bvh::{self, Bvh, Channel};
use proptest::collection::vec;
use proptest::prelude::*;

use super::{Link, channel_name, places_by_matrices};

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
        check(&bvh::decode(text.as_bytes()).unwrap(), &joints, &frames)?;
    }

    #[test]
    fn any_order_of_channels_is_obeyed((text, joints, frames) in chains()) {
        let motion = bvh::decode(text.as_bytes()).unwrap();
        for (index, frame) in frames.iter().enumerate() {
            let places = motion.joint_positions(index).unwrap();
            for (ours, known) in places.iter().zip(places_by_matrices(&joints, frame, motion.root_position_channels())) {
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
        if let Ok(motion) = bvh::decode(&bytes) {
            for frame in 0..motion.frame_count() {
                prop_assert!(motion.frame(frame).unwrap().iter().all(|x| x.is_finite()));
            }
        }
    }

    #[test]
    fn no_bytes_make_it_panic(bytes in vec(any::<u8>(), 0..200)) {
        let _ = bvh::decode(&bytes);
    }
}
