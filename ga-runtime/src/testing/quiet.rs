//! Panics that are kept instead of printed: while a smaller failing case is searched for, each step
//! panics, but only the last one is to be read.

use alloc::boxed::Box;
use alloc::string::{String, ToString};
use core::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;
use std::thread_local;

thread_local! {
    /// The text of the last panic on this thread; `None` where panics are printed as usual.
    static KEPT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Runs a test; where it panics, the error says where and why, and nothing is printed.
pub(super) fn quietly<T>(test: impl FnOnce() -> T) -> Result<T, String> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |panic| {
            let is_kept = KEPT.with_borrow_mut(|kept| {
                kept.as_mut()
                    .map(|text| *text = panic.to_string())
                    .is_some()
            });
            if !is_kept {
                usual(panic);
            }
        }));
    });
    let before = KEPT.replace(Some(String::new()));
    let outcome = catch_unwind(AssertUnwindSafe(test));
    let text = KEPT.replace(before).unwrap_or_default();
    outcome.map_err(|_| text)
}

#[cfg(test)]
mod tests {
    use alloc::string::String;
    use std::env::current_exe;
    use std::process::Command;

    use crate::testing::for_all;

    /// Fails; the test below runs it in a process of its own.
    #[test]
    #[ignore = "fails, to show how failures are reported"]
    fn a_failing_property() {
        for_all(0..100_000_u32, |x| assert!(x < 10, "{x} is too large"));
    }

    #[test]
    fn a_failure_is_reported_once() {
        let tests = current_exe().expect("this test");
        let name = "testing::quiet::tests::a_failing_property";
        let run = Command::new(tests)
            .args(["--exact", name, "--ignored", "--nocapture"])
            .output()
            .expect("it runs");
        assert!(!run.status.success());
        let text = String::from_utf8_lossy(&run.stderr);
        assert_eq!(text.matches("panicked at").count(), 2, "{text}");
        assert_eq!(text.matches("is too large").count(), 1, "{text}");
        assert!(
            text.contains("10 is too large") && text.contains("quiet.rs"),
            "{text}"
        );
        assert!(text.contains("minimal failing input: 10"), "{text}");
    }
}
