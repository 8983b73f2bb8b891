//! BVH: what is read has finite numbers, frames of one length, and joints after their parents.
#![no_main]

use ga_anim::bvh;
use ga_anim::recording::Recording;
use ga_files::Reading;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(motion) = bvh::decode(data) else {
        return;
    };
    if let Ok(strict) = bvh::decode_as(data, Reading::Strict) {
        assert_eq!(strict, motion);
    }
    for (index, joint) in motion.joints().iter().enumerate() {
        assert!(joint.parent.is_none_or(|parent| parent < index));
    }
    for frame in 0..motion.frame_count() {
        let values = motion.frame(frame).expect("a frame that is counted is there");
        assert_eq!(values.len(), motion.channel_count());
        assert!(values.iter().all(|x| x.is_finite()));
    }
    // Lengths may overflow, which is an error and not a number that is not finite.
    if let Ok(recording) = Recording::from_bvh(&motion, 0.01) {
        assert_eq!(recording.frame_count(), motion.frame_count());
    }
});
