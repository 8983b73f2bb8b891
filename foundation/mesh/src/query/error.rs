//! Why a query has no answer.

/// Why a query has no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum QueryError {
    /// There are no triangles, and so there is no nearest one.
    #[error("the surface has no triangles")]
    NoTriangles,
    /// A number of the query is infinite or NaN.
    #[error("the {what} of the query is not finite")]
    NotFinite {
        /// Which number.
        what: &'static str,
    },
    /// An element of the query has weight zero, or is imaginary, so that it has no points.
    #[error("the {what} of the query has no points")]
    Degenerate {
        /// Which element.
        what: &'static str,
    },
}
