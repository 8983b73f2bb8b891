//! How far the depth of a frame is from that of its shot.

use std::collections::VecDeque;

use super::Viewing;

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
        let mut sorted: Vec<f64> = self.shot.iter().copied().collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let count = sorted.len();
        let pair = [
            *sorted.get(count.checked_sub(1)? / 2)?,
            *sorted.get(count / 2)?,
        ];
        Some(0.5 * (pair[0] + pair[1]))
    }
}
