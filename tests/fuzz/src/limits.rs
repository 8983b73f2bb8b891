//! The bounds of an expansion: two seconds of one processor. libFuzzer has that of memory.

use std::fs::read_to_string;
use std::time::{Duration, Instant};

/// The longest expansion without an error that names the bound which ended it.
const LONGEST: Duration = Duration::from_secs(2);

/// Runs an expansion and checks its time on the processor, which other programs do not change.
///
/// # Panics
/// If it took longer.
pub fn within_limits<T>(text: &str, expansion: impl FnOnce() -> T) -> T {
    let (start, wall) = (processor_time(), Instant::now());
    let result = expansion();
    let time = match (start, processor_time()) {
        (Some(start), Some(end)) => end.saturating_sub(start),
        _ => wall.elapsed(),
    };
    assert!(time < LONGEST, "{time:?} for an expansion of\n{text}");
    result
}

/// How long this thread has had a processor, where the system says so.
fn processor_time() -> Option<Duration> {
    let text = read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds = text.split_whitespace().next()?.parse().ok()?;
    Some(Duration::from_nanos(nanoseconds))
}
