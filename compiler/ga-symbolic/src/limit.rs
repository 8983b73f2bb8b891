//! Limits of the search for the cheapest graph.

/// A limit that was reached. Beyond it the cheapest graph found so far stands, which costs no more
/// than the program step by step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SearchLimit {
    /// The program has too many steps to look for other forms of it.
    Steps,
    /// Other forms have more ways to values than are looked at.
    Ways,
    /// There are more forms than are compared.
    Forms,
    /// A product has too many factors to look for other groupings of all of them.
    Factors,
    /// The graph is so large that not all rules were tried.
    Rules,
    /// The graph is so large that its operations were not merged and factored.
    Operations,
}

impl SearchLimit {
    /// Whether a long program was left as it is written, as a whole or in parts.
    #[must_use]
    pub const fn is_cut(self) -> bool {
        matches!(self, Self::Steps | Self::Factors | Self::Operations)
    }

    /// The limit in words.
    #[must_use]
    pub const fn note(self) -> &'static str {
        match self {
            Self::Steps => "too many steps to look for other forms of the function",
            Self::Ways => "not all forms of the function were looked for",
            Self::Forms => "not all forms of the function were compared",
            Self::Factors => "not all groupings of a long product were tried",
            Self::Rules => "not all rules were tried on so large a graph",
            Self::Operations => "too many operations to merge and factor them",
        }
    }
}
