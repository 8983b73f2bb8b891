//! Whether the positions of a root take the place of its offset.

use ga_numerics::order_statistics::Sorted;
use ga_runtime::vga3::Vector;

use super::{Bvh, Channel, PositionChannels};

/// Frames that are looked at.
const FRAMES: usize = 200;
/// As a part of the body's height, the distance from the ground within which its lowest joint is on
/// it.
const GROUND: f64 = 0.15;

/// How the position channels of a root are meant in a recording in which they take the place of its
/// offset: they are added only where that puts the body on the ground, at 0 along the offset's
/// longest component, and its place alone does not.
pub(super) fn root_positions(motion: &Bvh) -> PositionChannels {
    let roots = motion.joints().iter().filter(|joint| {
        let is_position = |channel: &Channel| matches!(channel, Channel::Position(_));
        joint.parent.is_none() && joint.channels.iter().any(is_position)
    });
    let offsets = roots.map(|joint| Vector::from(joint.offset));
    let longest = offsets.max_by(|a, b| a.length().total_cmp(&b.length()));
    let Some(offset) = longest.filter(|offset| offset.length() > 0.0) else {
        return PositionChannels::InPlace;
    };
    let offset = offset.coordinates();
    let mut axes = [0, 1, 2];
    axes.sort_by(|&a, &b| offset[b].abs().total_cmp(&offset[a].abs()));
    let axis = axes[0];
    let sign = offset[axis].signum();

    let step = motion.frame_count().div_ceil(FRAMES).max(1);
    let (mut lowest, mut heights) = (Vec::new(), Vec::new());
    for frame in (0..motion.frame_count()).step_by(step) {
        let joints = motion.joint_positions(frame).unwrap_or_default();
        let ends = motion.end_site_positions(frame).unwrap_or_default();
        let places = joints.into_iter().chain(ends.into_iter().flatten());
        let [low, high] = places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
            let height = sign * place[axis];
            [low.min(height), high.max(height)]
        });
        lowest.push(low);
        heights.push(high - low);
    }
    let [Some(lowest), Some(height)] = [&mut lowest, &mut heights]
        .map(|list| Sorted::new(list).map(|sorted| sorted.quantile(0.5)))
    else {
        return PositionChannels::InPlace;
    };
    let is_on_ground = |low: f64| low.abs() <= GROUND * height;
    match is_on_ground(lowest + offset[axis].abs()) && !is_on_ground(lowest) {
        true => PositionChannels::Added,
        false => PositionChannels::InPlace,
    }
}
