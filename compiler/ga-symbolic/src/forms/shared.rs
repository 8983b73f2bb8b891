//! What is cheapest where values that are read several times are computed once.

use super::class::ClassId;
use super::classes::Classes;
use super::selection::{Costs, IMAGES};

/// How often the cheapest sets of classes are improved.
const MOST_ROUNDS: usize = 16;

impl Costs {
    /// The ways to all classes that look cheapest where what is read several times is computed
    /// once: those that need the cheapest sets of classes.
    pub(super) fn shared(&self, classes: &Classes<'_>) -> Vec<usize> {
        let mut ways: Vec<usize> = self.best.iter().map(|(place, _)| *place).collect();
        let mut needed: Vec<Option<(usize, Needed)>> = vec![None; classes.len()];
        for round in 0..MOST_ROUNDS {
            let mut has_changed = false;
            // What operations read may come before them or after.
            let mut ids: Vec<ClassId> = classes.ids().collect();
            if round % 2 == 1 {
                ids.reverse();
            }
            for id in ids {
                for (place, way) in classes.class(id).ways.iter().enumerate() {
                    let reads = way.operation.reads();
                    let Some(set) = Needed::of(&needed, &reads, classes.len()) else {
                        continue;
                    };
                    if set.contains(id) {
                        continue;
                    }
                    let mut cost = self.own[id.index()][place];
                    if self.rounded[id.index()][place] {
                        cost = cost.saturating_mul(IMAGES);
                    }
                    for other in set.ids() {
                        cost += self.own[other][ways[other]];
                    }
                    let known = needed[id.index()].as_ref();
                    if known.is_none_or(|(least, _)| cost < *least) {
                        ways[id.index()] = place;
                        needed[id.index()] = Some((cost, set.with(id)));
                        has_changed = true;
                    }
                }
            }
            if !has_changed {
                break;
            }
        }
        ways
    }
}

/// A set of classes.
#[derive(Clone)]
struct Needed(Vec<u64>);

impl Needed {
    /// What some classes need; none where that is not known of one of them.
    fn of(known: &[Option<(usize, Self)>], reads: &[ClassId], classes: usize) -> Option<Self> {
        let mut set = Self(vec![0; classes.div_ceil(64)]);
        for read in reads {
            let (_, other) = known[read.index()].as_ref()?;
            for (word, other) in set.0.iter_mut().zip(&other.0) {
                *word |= other;
            }
        }
        Some(set)
    }

    fn contains(&self, id: ClassId) -> bool {
        self.0[id.index() / 64] >> (id.index() % 64) & 1 == 1
    }

    fn with(mut self, id: ClassId) -> Self {
        self.0[id.index() / 64] |= 1 << (id.index() % 64);
        self
    }

    fn ids(&self) -> impl Iterator<Item = usize> {
        let words = self.0.iter().enumerate();
        words.flat_map(|(place, word)| {
            (0..64)
                .filter(move |bit| word >> bit & 1 == 1)
                .map(move |bit| 64 * place + bit)
        })
    }
}
