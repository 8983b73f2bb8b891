//! The end of the program at a signal: nothing half-done is left.

/// From now on, SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program with temporary files removed
/// and 128 plus the number of the signal as status. Those that the caller ignores, as `nohup` does
/// with SIGHUP, stay ignored.
#[cfg(unix)]
pub(crate) fn clean_up_at_signals() -> std::io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let all = [SIGHUP, SIGINT, SIGTERM].into_iter();
    let mut signals = Signals::new(all.filter(|signal| !is_ignored(*signal, &status)))?;
    std::thread::Builder::new()
        .name("signals".to_owned())
        .spawn(move || {
            if let Some(signal) = signals.forever().next() {
                ga_files::remove_temporaries();
                std::process::exit(128 + signal);
            }
        })?;
    Ok(())
}

/// Other systems end the program by themselves.
#[cfg(not(unix))]
pub(crate) fn clean_up_at_signals() -> std::io::Result<()> {
    Ok(())
}

/// Whether a process ignores a signal, by its status as Linux shows it.
#[cfg(unix)]
fn is_ignored(signal: i32, status: &str) -> bool {
    let mut lines = status.lines();
    let mask = lines.find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn ignored_signals_are_read_from_the_status() {
        let status = "SigBlk:\t0000000000000003\nSigIgn:\t0000000000004001\n";
        assert!(is_ignored(1, status) && is_ignored(15, status));
        assert!(!is_ignored(2, status) && !is_ignored(1, ""));
    }
}
