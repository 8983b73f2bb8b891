//! Views at other times.

use crate::{JointPixel, Observation};

/// What views show, each at its own time: what it shows in frame t is taken from frame t + d of the
/// view, between two frames along a straight line; `None` where one of these does not show it.
pub(crate) fn resampled(observations: &[Observation], offsets: &[f64]) -> Vec<Observation> {
    let at = |view: usize, point: usize, frame: i64| {
        let frame = usize::try_from(frame).ok()?;
        observations.get(frame)?.views[view][point]
    };
    let of_frame = |frame: usize| {
        let views = offsets.iter().enumerate().map(|(view, offset)| {
            let time = frame as f64 + offset;
            let (first, part) = (time.floor() as i64, time - time.floor());
            let points = 0..observations[frame].views[view].len();
            let of_point = |point: usize| {
                let before = at(view, point, first);
                match part > 0.0 {
                    true => Some(between(before?, at(view, point, first + 1)?, part)),
                    false => before,
                }
            };
            points.map(of_point).collect()
        });
        Observation {
            views: views.collect(),
        }
    };
    (0..observations.len()).map(of_frame).collect()
}

fn between(one: JointPixel, other: JointPixel, part: f64) -> JointPixel {
    JointPixel {
        position: [0, 1].map(|k| one.position[k] + (other.position[k] - one.position[k]) * part),
        deviation: one.deviation.max(other.deviation),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_view_that_is_late_shows_what_its_later_frames_have() {
        let frame = |t: usize| Observation {
            views: vec![vec![(t != 3).then_some(JointPixel {
                position: [10.0 * t as f64, 0.0],
                deviation: 1.0 + t as f64,
            })]],
        };
        let observations: Vec<Observation> = (0..6).map(frame).collect();
        let shown = |offset: f64| -> Vec<Option<f64>> {
            let shifted = resampled(&observations, &[offset]);
            shifted
                .iter()
                .map(|o| o.views[0][0].map(|pixel| pixel.position[0]))
                .collect()
        };
        let whole = [Some(20.0), None, Some(40.0), Some(50.0), None, None];
        assert_eq!(shown(2.0), whole);
        let half = [None, Some(5.0), Some(15.0), None, None, Some(45.0)];
        assert_eq!(shown(-0.5), half);
    }
}
