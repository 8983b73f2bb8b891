//! How far the depth of a frame is from that of its shot.

use std::collections::VecDeque;

use super::Viewing;
use ga_numerics::order_statistics::median;

/// The frames of a shot whose median is taken: the last ones.
const FRAMES: usize = 240;

/// Compares the median parallax of each frame with the running median of its shot.
#[derive(Debug, Default)]
pub(super) struct DeviationMeter {
    /// Median parallaxes of the frames of the shot so far, as visual angles in arc minutes.
    shot: VecDeque<f64>,
}

impl DeviationMeter {
    /// The difference, in arc minutes, from the running median of the frames of the shot before
    /// this one. At a cut it is that from the shot before it: the jump that the eyes have to make.
    /// It is zero where there are none.
    pub(super) fn push(
        &mut self,
        median_percent: Option<f64>,
        begins_shot: bool,
        viewing: &Viewing,
    ) -> Option<f64> {
        let usual = self.median();
        if begins_shot {
            self.shot.clear();
        }
        let angle = 60.0 * viewing.degrees_of_parallax(median_percent?);
        if self.shot.len() == FRAMES {
            self.shot.pop_front();
        }
        self.shot.push_back(angle);
        Some(usual.map_or(0.0, |usual| angle - usual))
    }

    fn median(&self) -> Option<f64> {
        let mut angles: Vec<f64> = self.shot.iter().copied().collect();
        median(&mut angles)
    }
}

#[cfg(test)]
mod tests {
    use super::{DeviationMeter, FRAMES};
    use crate::comfort::Viewing;

    #[test]
    fn frames_are_compared_with_those_before_them() {
        let viewing = Viewing::default();
        let angle = |percent: f64| 60.0 * viewing.degrees_of_parallax(percent);
        let mut meter = DeviationMeter::default();
        let mut push = |percent, begins| meter.push(percent, begins, &viewing);
        assert_eq!(push(Some(1.0), true), Some(0.0));
        assert_eq!(push(Some(2.0), false), Some(angle(2.0) - angle(1.0)));
        // The median of two numbers lies between them.
        let middle = 0.5 * (angle(1.0) + angle(2.0));
        assert_eq!(push(Some(3.0), false), Some(angle(3.0) - middle));
        assert_eq!(push(None, false), None);
        // A cut is a jump from the shot before it, which is then forgotten.
        assert_eq!(push(Some(-1.0), true), Some(angle(-1.0) - angle(2.0)));
        assert_eq!(push(Some(-1.5), false), Some(angle(-1.5) - angle(-1.0)));
    }

    #[test]
    fn early_frames_of_a_long_shot_are_forgotten() {
        let viewing = Viewing::default();
        let mut meter = DeviationMeter::default();
        for _ in 0..2 * FRAMES {
            meter.push(Some(0.0), false, &viewing);
        }
        for _ in 0..FRAMES / 2 + 1 {
            meter.push(Some(1.0), false, &viewing);
        }
        assert_eq!(meter.push(Some(1.0), false, &viewing), Some(0.0));
    }
}
