//! What makes stereoscopic video uncomfortable, and its units.

use std::fmt;

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

    /// The name in words, as that of a fault.
    ///
    /// ```
    /// use ga_video::comfort::Dimension;
    ///
    /// assert_eq!(Dimension::OverDivergence.in_words(), "Too far behind");
    /// ```
    #[must_use]
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Brightness => "Difference of brightness",
            Self::Colour => "Difference of colour",
            Self::Vertical => "Vertical misalignment",
            Self::Asynchrony => "Delay of one eye",
            Self::ParallaxDeviation => "Jumps of depth",
            Self::Stereoscopy => "Left and right in order",
            Self::WeakDepth => "Too little depth",
            Self::RichDepth => "Too much depth at once",
            Self::OverConvergence => "Too far in front",
            Self::OverDivergence => "Too far behind",
            Self::FocalGap => "Difference of sharpness",
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

/// The unit of a raw number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Per cent: of luminance in [`Dimension::Brightness`], of the picture's width otherwise.
    Percent,
    /// Units of CIE 1976 L\*a\*b\*.
    ColourDifference,
    /// Sixtieths of a degree of visual angle.
    Arcminutes,
    /// Frames of the video.
    Frames,
    /// Degrees of visual angle.
    Degrees,
    /// The binary logarithm of a ratio.
    Log2,
    /// A number that is positive where the views are in their order, negative where they are
    /// exchanged, and near zero where that cannot be told.
    Evidence,
}

impl Unit {
    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Percent => "percent",
            Self::ColourDifference => "delta_ab",
            Self::Arcminutes => "arcminutes",
            Self::Frames => "frames",
            Self::Degrees => "degrees",
            Self::Log2 => "log2",
            Self::Evidence => "evidence",
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
