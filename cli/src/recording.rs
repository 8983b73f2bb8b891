//! The part of a recording that is the motion.

pub(crate) use ga_anim::bvh::begins_with_calibration;
