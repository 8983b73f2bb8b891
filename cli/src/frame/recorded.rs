//! What a command said that is part of another.

use ga_draw::document::Page;
use serde_json::Value;

use super::verdict::Verdict;

/// What a command would have printed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorded {
    /// As `--json` prints it.
    pub(crate) values: Value,
    pub(crate) verdict: Option<Verdict>,
    /// That of `--report`, where the command has one of its own.
    pub(crate) page: Option<Page>,
}
