//! The parts of a map that are computed in parallel, with bounded memory.

use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;

/// What computing a part needs in memory, kept from one part to the next.
#[derive(Debug)]
pub(super) struct Spare<S>(Mutex<Vec<S>>);

impl<S> Default for Spare<S> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<S: Send> Spare<S> {
    /// Makes memory for `count` parts that are computed at the same time, and makes all of it
    /// `ready`. This is done in one thread outside the pool: allocators give memory that was freed
    /// to the thread that allocated it, and not to others.
    pub(super) fn prepare(&self, count: usize, new: impl Fn() -> S, ready: impl Fn(&mut S)) {
        let mut spare = locked(&self.0);
        spare.truncate(count);
        spare.resize_with(count, new);
        spare.iter_mut().for_each(ready);
    }

    /// Computes all parts, as many at the same time as there is memory for. The order does not
    /// matter, since each part has its own results.
    pub(super) fn compute<T: Send>(&self, parts: Vec<T>, compute: impl Fn(T, &mut S) + Sync) {
        let workers = locked(&self.0).len();
        debug_assert!(workers > 0 || parts.is_empty(), "nothing was prepared");
        let parts = Mutex::new(parts.into_iter());
        let workers = (0..workers).into_par_iter().with_max_len(1);
        workers.for_each(|_| {
            let next = || locked(&parts).next();
            let mut memory = locked(&self.0).pop();
            if let Some(memory) = &mut memory {
                while let Some(part) = next() {
                    compute(part, memory);
                }
            }
            locked(&self.0).extend(memory);
        });
    }

    /// Gives memory back, unless it is at most `most` of `size` bytes in all.
    pub(super) fn keep_at_most(&self, most: usize, size: usize) {
        locked(&self.0).truncate(most / size.max(1));
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use rayon::ThreadPoolBuilder;

    use super::*;

    /// All parts are computed once, and no more memory is made than allowed.
    #[test]
    fn memory_does_not_rise_with_the_number_of_threads() {
        let pool = ThreadPoolBuilder::new().num_threads(8).build().unwrap();
        let spare = Spare::default();
        let made = AtomicUsize::new(0);
        let mut results = [0; 40];
        for round in 1..=2 {
            let parts = results.iter_mut().collect();
            spare.prepare(3, || made.fetch_add(1, Ordering::Relaxed), |_| ());
            pool.install(|| spare.compute(parts, |part: &mut i32, _| *part += 1));
            assert!(results.iter().all(|result| *result == round));
        }
        assert_eq!(made.into_inner(), 3);
        spare.keep_at_most(100, 60);
        assert!(locked(&spare.0).len() <= 1);
    }
}
