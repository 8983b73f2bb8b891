//! The colours of the picture itself, for a light and a dark background.

/// The classes that follow the reader's preference for light or dark. The attributes hold where
/// style sheets are not supported.
pub(super) const STYLE: &str = "\
    text{font-family:system-ui,'Segoe UI','DejaVu Sans',sans-serif}\
    .halo{paint-order:stroke;stroke-linejoin:round}\
    @media(prefers-color-scheme:dark){\
    .ground{fill:#14171c}.ink{fill:#e8eaed}.faint{fill:#a8afb8}\
    .leader{stroke:#a8afb8}.halo{stroke:#14171c}.rim{stroke:#14171c}}";

/// The background.
pub(super) const GROUND: &str = "#ffffff";
/// Titles and labels.
pub(super) const INK: &str = "#1b1f24";
/// The names of axes and of kinds.
pub(super) const FAINT: &str = "#5a626c";
