//! What of two frames is identical.

use serde::{Deserialize, Serialize};

/// Which samples of two frames are all equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Same {
    /// Those of luma.
    pub luma: bool,
    /// Those of the colours: colour differences, or red, green and blue.
    pub colours: bool,
    /// Those of alpha; where a picture has none, it is opaque.
    pub alpha: bool,
}

impl Same {
    /// Of frames that are identical.
    pub const ALL: Self = Self {
        luma: true,
        colours: true,
        alpha: true,
    };

    /// Whether no sample differs.
    ///
    /// ```
    /// use ga_video::quality::Same;
    ///
    /// let same = Same { colours: false, ..Same::ALL };
    /// assert!(!same.is_all());
    /// assert_eq!(same.differing(), ["colours"]);
    /// ```
    #[must_use]
    pub fn is_all(self) -> bool {
        self == Self::ALL
    }

    /// What is the same in both of two pairs of frames.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            luma: self.luma && other.luma,
            colours: self.colours && other.colours,
            alpha: self.alpha && other.alpha,
        }
    }

    /// What differs, in words.
    #[must_use]
    pub fn differing(self) -> Vec<&'static str> {
        let parts = [
            (self.luma, "luma"),
            (self.colours, "colours"),
            (self.alpha, "alpha"),
        ];
        let differing = parts.into_iter().filter(|(same, _)| !same);
        differing.map(|(_, name)| name).collect()
    }
}
