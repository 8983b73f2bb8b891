//! Scripts of pages, run by Node.js.

use std::io::Write as _;
use std::process::{Command, Stdio};

use serde_json::Value;

/// What a script writes to standard output, given JSON on standard input. `None` where Node.js is
/// not installed; that fails where `NULLCONE_REQUIRE_NODE` is 1.
pub(crate) fn node(script: &str, input: &Value) -> Option<Value> {
    let child = Command::new("node")
        .args(["-e", script])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let mut child = match child {
        Ok(child) => child,
        Err(error) => {
            let required = std::env::var("NULLCONE_REQUIRE_NODE").is_ok_and(|value| value == "1");
            assert!(!required, "NULLCONE_REQUIRE_NODE=1, but node: {error}");
            eprintln!("skipped, since Node.js cannot be run: {error}");
            return None;
        }
    };
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(input.to_string().as_bytes()).unwrap();
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "the script failed");
    Some(serde_json::from_slice(&output.stdout).unwrap())
}
