//! Data of applications.

/// Data of an application, as JSON.
pub type Extras = Option<serde_json::Value>;
