//! Calibration poses before the motion.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::source::Source;

/// From a calibration pose a joint moves more than this many times as far as between any two later
/// frames.
const JUMP: f64 = 3.0;

/// Whether the first frame is a calibration pose, such as a T, that some converters put before the
/// motion: from there to the second frame some joint moves more than three times as far as any
/// joint between two later frames. Two frames are not enough to tell.
#[must_use]
pub fn begins_with_calibration(motion: &dyn Source) -> bool {
    let places = |frame: usize| -> Option<Vec<Vector<f64>>> {
        let motors = motion.frames_of_joints(frame)?.into_iter();
        Some(
            motors
                .map(|motor| motor.transform(Point::default()).into())
                .collect(),
        )
    };
    let mut steps = (1..motion.frame_count()).filter_map(|frame| {
        let ways = places(frame - 1)?.into_iter().zip(places(frame)?);
        Some(ways.map(|(a, b)| a.distance(b)).fold(0.0, f64::max))
    });
    let Some(first) = steps.next() else {
        return false;
    };
    let greatest = steps.reduce(f64::max).unwrap_or(f64::INFINITY);
    first > JUMP * greatest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::Bvh;

    /// An arm of length 1, rotated by these angles.
    fn arm(degrees: &[f64]) -> Bvh {
        let mut text = format!(
            "HIERARCHY\nROOT arm\n{{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\nJOINT hand\n{{\nOFFSET 1 0 0\nCHANNELS 1 Xrotation\n\
             End Site\n{{\nOFFSET 1 0 0\n}}\n}}\n}}\nMOTION\nFrames: {}\nFrame Time: 0.01\n",
            degrees.len()
        );
        for angle in degrees {
            text += &format!("{angle} 0\n");
        }
        crate::bvh::decode(text.as_bytes()).unwrap()
    }

    #[test]
    fn only_a_leap_at_the_beginning_is_a_calibration_pose() {
        assert!(begins_with_calibration(&arm(&[90.0, 0.0, 1.0, 2.0])));
        assert!(begins_with_calibration(&arm(&[90.0, 0.0, 0.0])));
        assert!(!begins_with_calibration(&arm(&[0.0, 1.0, 2.0, 3.0])));
        assert!(!begins_with_calibration(&arm(&[0.0, 1.0, 90.0, 91.0])));
        assert!(!begins_with_calibration(&arm(&[0.0, 0.0, 0.0])));
        assert!(!begins_with_calibration(&arm(&[90.0, 0.0])));
        assert!(!begins_with_calibration(&arm(&[90.0])));
        assert!(!begins_with_calibration(&arm(&[])));
    }
}
