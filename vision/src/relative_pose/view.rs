//! Which of two views.

/// One of two views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The first view.
    Left,
    /// The second view.
    Right,
}

impl std::fmt::Display for View {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}
