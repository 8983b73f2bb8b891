//! Runs of frames.

/// Frames of a video that share something, as runs of consecutive ones. Memory does not depend on
/// how many there are.
///
/// ```
/// use ga_video::comfort::FrameRuns;
///
/// let mut runs = FrameRuns::default();
/// [0, 1, 2, 7].into_iter().for_each(|frame| runs.add(frame));
/// assert_eq!((runs.frames(), runs.to_string()), (4, "frames 0 to 2 and 7".into()));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameRuns {
    frames: usize,
    /// The first runs, by their first and last frames.
    runs: Vec<[usize; 2]>,
    /// The number of runs after these, and the last frame of all.
    more: usize,
    last: Option<usize>,
}

/// The runs that are kept.
const MOST: usize = 8;

impl FrameRuns {
    /// Adds a frame after all others.
    pub fn add(&mut self, frame: usize) {
        self.add_run([frame; 2]);
        self.frames += 1;
    }

    /// The number of frames.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// Adds later frames.
    pub(super) fn merge(&mut self, later: &Self) {
        later.runs.iter().for_each(|run| self.add_run(*run));
        self.frames += later.frames;
        self.more += later.more;
        self.last = later.last.or(self.last);
    }

    fn add_run(&mut self, [first, last]: [usize; 2]) {
        let continues = self.last.is_some_and(|before| before + 1 == first);
        self.last = Some(last);
        let is_full = self.runs.len() == MOST;
        match self.runs.last_mut().filter(|_| continues) {
            Some(run) if self.more == 0 => run[1] = last,
            Some(_) => {}
            None if is_full => self.more += 1,
            None => self.runs.push([first, last]),
        }
    }
}

impl std::fmt::Display for FrameRuns {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let is_one = self.frames == 1;
        f.write_str(if is_one { "frame " } else { "frames " })?;
        for (index, [first, last]) in self.runs.iter().enumerate() {
            let joint = match index {
                0 => "",
                _ if index + 1 == self.runs.len() && self.more == 0 => " and ",
                _ => ", ",
            };
            match first == last {
                true => write!(f, "{joint}{first}")?,
                false => write!(f, "{joint}{first} to {last}")?,
            }
        }
        match self.more {
            0 => Ok(()),
            more => write!(f, " and {more} more runs, {} frames in all", self.frames),
        }
    }
}
