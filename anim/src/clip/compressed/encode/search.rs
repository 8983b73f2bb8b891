//! The search for the fewest bits in a segment with which the bound holds.

use super::super::basis::Basis;
use super::super::piece::{Encoded, MOST_BITS};
use super::joint::{CHANNELS, JointState, Level, Segment};
use super::source::Source;

/// The coarsest level of a channel without residual.
const COARSEST: Level = -40;

/// The most joints below a joint whose channels are lowered in exchange for one of its own.
const RELATIVES: usize = 12;

/// How many states are copied in about the time in which one joint is encoded.
const STATES_FOR_ONE: usize = 64;

/// Parts of the tolerance that a channel may use up at first, from which the search begins.
const BEGINNINGS: [f64; 3] = [0.25, 0.12, 0.06];

/// The levels of all channels of a segment and what they lead to.
pub(super) struct Search<'a> {
    segment: Segment<'a>,
    levels: Vec<[Level; CHANNELS]>,
    states: Vec<JointState>,
    /// The states of a trial.
    trial: Vec<JointState>,
    in_trial: Vec<bool>,
    /// The greatest error in tolerances that the search leaves.
    bound: f64,
    /// How many joints may still be encoded in the search for fewer bits.
    budget: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        source: &'a Source<'a>,
        basis: &'a Basis,
        first_frame: usize,
        bound: f64,
        budget: usize,
    ) -> Self {
        let joints = source.joints();
        Self {
            segment: Segment {
                source,
                basis,
                first_frame,
            },
            levels: vec![[0; CHANNELS]; joints],
            states: vec![JointState::default(); joints],
            trial: vec![JointState::default(); joints],
            in_trial: vec![false; joints],
            bound,
            budget,
        }
    }

    /// The channels of each joint with the fewest bits found.
    ///
    /// # Errors
    ///
    /// The joint whose error stays beyond the bound, and the error in tolerances.
    pub(super) fn run(mut self) -> Result<Vec<Vec<Encoded>>, (usize, f64)> {
        self.begin()?;
        self.lower_all();
        self.exchange();
        Ok(self
            .states
            .into_iter()
            .map(|state| state.channels)
            .collect())
    }

    /// Levels with which the bound holds.
    fn begin(&mut self) -> Result<(), (usize, f64)> {
        for part in BEGINNINGS {
            for joint in 0..self.states.len() {
                let (above, rest) = self.states.split_at_mut(joint);
                let parent = self.segment.source.layouts[joint]
                    .parent
                    .map(|parent| &above[parent]);
                self.levels[joint] = self
                    .segment
                    .encode_within(joint, part, parent, &mut rest[0]);
            }
            if self.worst().is_none() {
                return Ok(());
            }
        }
        while let Some(first) = self.worst() {
            // Bits for the first joint beyond the bound and all above it. Once that has used up the
            // budget, bits for every joint beyond the bound and all above it: then the number of
            // rounds does not grow with that of the joints.
            let together = self.budget == 0;
            let states = self.states.iter().enumerate();
            let mut raised: Vec<bool> = states
                .map(|(joint, state)| joint == first || (together && state.error > self.bound))
                .collect();
            let layouts = &self.segment.source.layouts;
            for (joint, layout) in layouts.iter().enumerate().rev() {
                if let (true, Some(parent)) = (raised[joint], layout.parent) {
                    raised[parent] = true;
                }
            }
            if !self.raise(&raised) {
                return Err((first, self.states[first].error));
            }
            for (top, layout) in layouts.iter().enumerate() {
                if raised[top] && layout.parent.is_none() {
                    self.try_subtree(top, f64::INFINITY);
                    self.accept(top);
                }
            }
        }
        Ok(())
    }

    /// Raises the channels of joints by one level; whether any could be raised.
    fn raise(&mut self, joints: &[bool]) -> bool {
        let mut raised = false;
        for (joint, layout) in self.segment.source.layouts.iter().enumerate() {
            for level in &mut self.levels[joint][..layout.channels()] {
                if joints[joint] && *level < MOST_BITS as Level {
                    *level += 1;
                    raised = true;
                }
            }
        }
        raised
    }

    /// The first joint whose error is beyond the bound.
    fn worst(&self) -> Option<usize> {
        self.states
            .iter()
            .position(|state| state.error > self.bound)
    }

    /// Encodes a joint and all below it with the levels as they are; whether the bound holds.
    fn try_subtree(&mut self, joint: usize, bound: f64) -> bool {
        let source = self.segment.source;
        for &below in source.hierarchy.subtree(joint) {
            let parent = source.layouts[below].parent;
            let (above, rest) = self.trial.split_at_mut(below);
            let parent = parent.map(|parent| {
                if self.in_trial[parent] {
                    &above[parent]
                } else {
                    &self.states[parent]
                }
            });
            self.budget = self.budget.saturating_sub(1);
            self.segment
                .encode(below, &self.levels[below], parent, &mut rest[0]);
            self.in_trial[below] = true;
            if rest[0].error > bound {
                self.end_trial(joint);
                return false;
            }
        }
        self.end_trial(joint);
        true
    }

    fn end_trial(&mut self, joint: usize) {
        for &below in self.segment.source.hierarchy.subtree(joint) {
            self.in_trial[below] = false;
        }
    }

    /// Takes the states of the last trial.
    fn accept(&mut self, joint: usize) {
        for &below in self.segment.source.hierarchy.subtree(joint) {
            std::mem::swap(&mut self.states[below], &mut self.trial[below]);
        }
    }

    /// About how many bits a joint and all below it take, by its states or those of the trial.
    fn cost(&self, joint: usize, states: &[JointState]) -> u32 {
        let frames = self.segment.basis.frames as u32;
        let of_joint = |&below: &usize| {
            let residuals: u32 = states[below]
                .channels
                .iter()
                .map(|channel| u32::from(channel.piece.bits))
                .sum();
            states[below].trend_bits + frames * residuals
        };
        let subtree = self.segment.source.hierarchy.subtree(joint);
        subtree.iter().map(of_joint).sum()
    }

    /// Lowers one channel after the other as long as the bound holds.
    fn lower_all(&mut self) {
        loop {
            let mut lowered = false;
            for joint in (0..self.states.len()).rev() {
                for channel in 0..self.segment.source.layouts[joint].channels() {
                    lowered |= self.lower(joint, channel);
                }
            }
            if !lowered {
                return;
            }
        }
    }

    /// Lowers a channel by one level if the bound holds and bits are saved.
    fn lower(&mut self, joint: usize, channel: usize) -> bool {
        let level = self.levels[joint][channel];
        if level <= COARSEST || self.budget == 0 {
            return false;
        }
        self.levels[joint][channel] = level - 1;
        if self.try_subtree(joint, self.bound)
            && self.cost(joint, &self.trial) < self.cost(joint, &self.states)
        {
            self.accept(joint);
            return true;
        }
        self.levels[joint][channel] = level;
        false
    }

    /// Raises one channel where this lets others near it be lowered by more.
    fn exchange(&mut self) {
        for joint in 0..self.states.len() {
            for channel in 0..self.segment.source.layouts[joint].channels() {
                self.exchange_one(joint, channel);
            }
        }
    }

    /// The joints whose channels may be lowered when one of `joint` is raised, the lowest first.
    fn relatives(&self, joint: usize) -> Vec<usize> {
        let source = self.segment.source;
        let mut relatives = source.hierarchy.subtree(joint).to_vec();
        relatives.sort_unstable();
        relatives.truncate(RELATIVES);
        relatives.reverse();
        relatives.extend(source.layouts[joint].parent);
        relatives
    }

    fn exchange_one(&mut self, joint: usize, channel: usize) {
        let level = self.levels[joint][channel];
        if level >= MOST_BITS as Level || self.budget == 0 {
            return;
        }
        let source = self.segment.source;
        // The part of the tree whose states may change: from the joint above.
        let top = source.layouts[joint].parent.unwrap_or(joint);
        let saved_levels = self.levels.clone();
        let subtree = source.hierarchy.subtree(top);
        // To keep the states of many joints takes time as encoding does.
        self.budget = self.budget.saturating_sub(subtree.len() / STATES_FOR_ONE);
        let saved: Vec<JointState> = subtree.iter().map(|&j| self.states[j].clone()).collect();
        let before = self.cost(top, &self.states);

        self.levels[joint][channel] = level + 1;
        if self.try_subtree(joint, self.bound) {
            self.accept(joint);
            for other in self.relatives(joint) {
                for k in 0..source.layouts[other].channels() {
                    if (other, k) != (joint, channel) {
                        self.lower(other, k);
                    }
                }
            }
            if self.cost(top, &self.states) < before {
                return;
            }
        }
        self.levels = saved_levels;
        for (&other, state) in subtree.iter().zip(saved) {
            self.states[other] = state;
        }
    }
}
