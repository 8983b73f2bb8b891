//! What makes stereoscopic video uncomfortable.

use crate::comfort::Unit;

/// A quantity that decides whether stereoscopic video is comfortable: a row of Cui, table 6.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dimension {
    /// One view is brighter.
    Brightness,
    /// The views differ in colour.
    Colour,
    /// Points are higher in one view: by a shift, a rotation or another size of the picture.
    Vertical,
    /// The views were not taken at the same time.
    Asynchrony,
    /// The depth of the scene as a whole changes.
    ParallaxDeviation,
    /// The views are exchanged, equal, or of different scenes.
    Stereoscopy,
    /// There is hardly any depth.
    WeakDepth,
    /// There is much depth at once.
    RichDepth,
    /// Points appear far in front of the screen.
    OverConvergence,
    /// Points appear far behind the screen.
    OverDivergence,
    /// The views differ in sharpness or in size.
    FocalGap,
}

impl Dimension {
    /// All of them, in the order of table 6.
    pub const ALL: [Self; 11] = [
        Self::Brightness,
        Self::Colour,
        Self::Vertical,
        Self::Asynchrony,
        Self::ParallaxDeviation,
        Self::Stereoscopy,
        Self::WeakDepth,
        Self::RichDepth,
        Self::OverConvergence,
        Self::OverDivergence,
        Self::FocalGap,
    ];

    /// The name in files: lower case, words joined by underscores.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Brightness => "brightness",
            Self::Colour => "colour",
            Self::Vertical => "vertical",
            Self::Asynchrony => "asynchrony",
            Self::ParallaxDeviation => "parallax_deviation",
            Self::Stereoscopy => "stereoscopy",
            Self::WeakDepth => "weak_depth",
            Self::RichDepth => "rich_depth",
            Self::OverConvergence => "over_convergence",
            Self::OverDivergence => "over_divergence",
            Self::FocalGap => "focal_gap",
        }
    }

    /// The unit of the raw number.
    #[must_use]
    pub fn unit(self) -> Unit {
        match self {
            Self::Brightness | Self::WeakDepth | Self::RichDepth => Unit::Percent,
            Self::Colour => Unit::ColourDifference,
            Self::Vertical | Self::ParallaxDeviation => Unit::Arcminutes,
            Self::Asynchrony => Unit::Frames,
            Self::Stereoscopy => Unit::Evidence,
            Self::OverConvergence | Self::OverDivergence => Unit::Degrees,
            Self::FocalGap => Unit::Log2,
        }
    }
}
