//! Times among frames at equal steps.

/// A time this near to a frame, in frames, is that of the frame: the product of a number of frames
/// and the time between them is rounded.
const SAME_FRAME: f64 = 1e-8;

/// The frame at or before a time, given in frames, and the part of the way to the next, for frames
/// from 0 to `last`. The part is 0 at a frame, before the first and after the last one. A time that
/// is not a number is that of the first frame.
#[inline]
pub(crate) fn frame_at(position: f64, last: usize) -> (usize, f64) {
    let position = position.max(0.0).min(last as f64);
    let nearest = (position + 0.5) as usize;
    if (position - nearest as f64).abs() < SAME_FRAME {
        return (nearest, 0.0);
    }
    let before = position as usize;
    (before, position - before as f64)
}

#[cfg(test)]
mod tests {
    use super::frame_at;

    #[test]
    fn frames_parts_and_times_beyond() {
        assert_eq!(frame_at(2.25, 3), (2, 0.25));
        assert_eq!(frame_at(0.75, 3), (0, 0.75));
        assert_eq!(frame_at(2.999_999_999_9, 3), (3, 0.0));
        assert_eq!(frame_at(1.000_000_000_1, 3), (1, 0.0));
        for (beyond, frame) in [(-1.0, 0), (f64::NAN, 0), (3.5, 3), (f64::INFINITY, 3)] {
            assert_eq!(frame_at(beyond, 3), (frame, 0.0));
        }
        assert_eq!(frame_at(0.4, 0), (0, 0.0));
    }

    /// The product of a step and a number, divided by the step, is rounded twice.
    #[test]
    fn multiples_of_a_step_are_frames() {
        for step in [1.0 / 120.0, 1.0 / 29.97, 0.008_333_3] {
            for frame in 0..100_000_usize {
                assert_eq!(frame_at(frame as f64 * step / step, 100_000), (frame, 0.0));
            }
        }
    }
}
