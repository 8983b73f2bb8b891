//! Names as something that is retargeted.

use ga_anim::retarget::Source;
use ga_runtime::cga3::Motor;

/// Names without a hierarchy and without motion.
#[derive(Debug)]
pub(crate) struct Names<'a>(pub(crate) Vec<&'a str>);

impl Source for Names<'_> {
    fn names(&self) -> Vec<&str> {
        self.0.clone()
    }

    fn parents(&self) -> Vec<Option<usize>> {
        vec![None; self.0.len()]
    }

    fn rest_positions(&self) -> Vec<[f64; 3]> {
        vec![[0.0; 3]; self.0.len()]
    }

    fn frame_count(&self) -> usize {
        0
    }

    fn frame_time(&self) -> f64 {
        1.0
    }

    fn frames_of_joints(&self, _: usize) -> Option<Vec<Motor<f64>>> {
        None
    }
}
