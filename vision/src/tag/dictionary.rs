//! Dictionaries: which tags there are, and which one a pattern of modules is.

use std::fmt;
use std::str::FromStr;

use super::words::{april, aruco_4x4, aruco_5x5, aruco_6x6};

/// A set of tags that differ from each other in many modules, also when they are rotated.
///
/// Those of ArUco (S. Garrido-Jurado and others, "Automatic generation and detection of highly
/// reliable fiducial markers under occlusion", 2014) are OpenCV's predefined dictionaries. Those of
/// AprilTag (E. Olson, "AprilTag: a robust and flexible visual fiducial system", 2011) are upright
/// as OpenCV has them, which is rotated by 180° from the pictures of their authors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dictionary {
    /// 50 tags of 4 × 4 modules.
    Aruco4x4_50,
    /// 100 tags of 4 × 4 modules.
    Aruco4x4_100,
    /// 250 tags of 4 × 4 modules.
    Aruco4x4_250,
    /// 1000 tags of 4 × 4 modules.
    Aruco4x4_1000,
    /// 50 tags of 5 × 5 modules.
    Aruco5x5_50,
    /// 100 tags of 5 × 5 modules.
    Aruco5x5_100,
    /// 250 tags of 5 × 5 modules.
    Aruco5x5_250,
    /// 1000 tags of 5 × 5 modules.
    Aruco5x5_1000,
    /// 50 tags of 6 × 6 modules.
    Aruco6x6_50,
    /// 100 tags of 6 × 6 modules.
    Aruco6x6_100,
    /// 250 tags of 6 × 6 modules.
    Aruco6x6_250,
    /// 1000 tags of 6 × 6 modules.
    Aruco6x6_1000,
    /// 30 tags of 4 × 4 modules that differ in 5.
    April16h5,
    /// 35 tags of 5 × 5 modules that differ in 9.
    April25h9,
    /// 587 tags of 6 × 6 modules that differ in 11.
    April36h11,
}

/// A name that no dictionary has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{name:?} is no dictionary of tags: {} are known", TABLE.map(|(_, name, ..)| name).join(", "))]
pub struct UnknownDictionary {
    /// The name.
    pub name: String,
}

/// A dictionary, its name, the modules on a side of a tag, the words of its tags, how many of them
/// it has, and how many wrong modules are corrected: 0.6 of those that could be, which is what
/// OpenCV's detector does.
type Row = (Dictionary, &'static str, usize, &'static [u64], usize, u32);

const TABLE: [Row; 15] = {
    use Dictionary as D;
    [
        (D::Aruco4x4_50, "4X4_50", 4, &aruco_4x4::WORDS, 50, 0),
        (D::Aruco4x4_100, "4X4_100", 4, &aruco_4x4::WORDS, 100, 0),
        (D::Aruco4x4_250, "4X4_250", 4, &aruco_4x4::WORDS, 250, 0),
        (D::Aruco4x4_1000, "4X4_1000", 4, &aruco_4x4::WORDS, 1000, 0),
        (D::Aruco5x5_50, "5X5_50", 5, &aruco_5x5::WORDS, 50, 1),
        (D::Aruco5x5_100, "5X5_100", 5, &aruco_5x5::WORDS, 100, 1),
        (D::Aruco5x5_250, "5X5_250", 5, &aruco_5x5::WORDS, 250, 1),
        (D::Aruco5x5_1000, "5X5_1000", 5, &aruco_5x5::WORDS, 1000, 1),
        (D::Aruco6x6_50, "6X6_50", 6, &aruco_6x6::WORDS, 50, 3),
        (D::Aruco6x6_100, "6X6_100", 6, &aruco_6x6::WORDS, 100, 3),
        (D::Aruco6x6_250, "6X6_250", 6, &aruco_6x6::WORDS, 250, 3),
        (D::Aruco6x6_1000, "6X6_1000", 6, &aruco_6x6::WORDS, 1000, 2),
        (D::April16h5, "APRILTAG_16h5", 4, &april::WORDS_16H5, 30, 0),
        (D::April25h9, "APRILTAG_25h9", 5, &april::WORDS_25H9, 35, 2),
        (
            D::April36h11,
            "APRILTAG_36h11",
            6,
            &april::WORDS_36H11,
            587,
            3,
        ),
    ]
};

/// Which tag a pattern is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Identity {
    /// The number of the tag.
    pub(super) id: usize,
    /// By how many quarters of a turn, clockwise as it is seen, the pattern is rotated from the
    /// upright tag.
    pub(super) quarters: usize,
    /// How many modules are wrong.
    pub(super) hamming: u32,
}

impl Dictionary {
    /// All dictionaries.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.into_iter().map(|(dictionary, ..)| dictionary)
    }

    /// The name, which is that of OpenCV without `DICT_`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// The modules on a side of a tag, without its black border.
    #[must_use]
    pub fn side(self) -> usize {
        self.row().2
    }

    /// How many tags there are.
    #[must_use]
    pub fn count(self) -> usize {
        self.row().4
    }

    /// The modules of a tag, row by row from its top left one; true is white. `None` for a number
    /// that no tag has.
    ///
    /// ```
    /// use ga_vision::tag::Dictionary;
    ///
    /// let dictionary: Dictionary = "DICT_4X4_50".parse()?;
    /// assert_eq!((dictionary.side(), dictionary.count()), (4, 50));
    /// let modules = dictionary.modules(0).ok_or("no such tag")?;
    /// assert_eq!(modules[..4], [true, false, true, true]);
    /// assert_eq!(dictionary.modules(50), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn modules(self, id: usize) -> Option<Vec<bool>> {
        let word = *self.words().get(id)?;
        let bits = (0..self.side() * self.side()).rev();
        Some(bits.map(|bit| word >> bit & 1 == 1).collect())
    }

    /// The tag that a square pattern is, where no more modules are wrong than are corrected.
    pub(super) fn identify(self, modules: &[bool]) -> Option<Identity> {
        let side = self.side();
        let mut pattern = modules.to_vec();
        let mut best: Option<Identity> = None;
        for quarters in 0..4 {
            let word = pattern
                .iter()
                .fold(0, |word, bit| word << 1 | u64::from(*bit));
            for (id, other) in self.words().iter().enumerate() {
                let hamming = (word ^ other).count_ones();
                if best.is_none_or(|best| hamming < best.hamming) {
                    best = Some(Identity {
                        id,
                        quarters,
                        hamming,
                    });
                }
            }
            // Anticlockwise by a quarter, so that a pattern that is rotated becomes upright.
            let turned = (0..side * side).map(|k| pattern[k % side * side + side - 1 - k / side]);
            pattern = turned.collect();
        }
        best.filter(|best| best.hamming <= self.row().5)
    }

    fn words(self) -> &'static [u64] {
        let (_, _, _, words, count, _) = self.row();
        &words[..count]
    }

    fn row(self) -> Row {
        TABLE[self as usize]
    }
}

impl fmt::Display for Dictionary {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// OpenCV's name, with or without `DICT_`, in small or capital letters.
impl FromStr for Dictionary {
    type Err = UnknownDictionary;

    fn from_str(text: &str) -> Result<Self, UnknownDictionary> {
        let wanted = text.to_ascii_uppercase();
        let wanted = wanted.strip_prefix("DICT_").unwrap_or(&wanted);
        let is_wanted = |dictionary: &Self| dictionary.name().eq_ignore_ascii_case(wanted);
        Self::all()
            .find(is_wanted)
            .ok_or_else(|| UnknownDictionary {
                name: text.to_owned(),
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_has_the_order_of_the_dictionaries() {
        for (index, dictionary) in Dictionary::all().enumerate() {
            assert_eq!(dictionary as usize, index);
            assert_eq!(dictionary.name().parse::<Dictionary>().unwrap(), dictionary);
            assert!(dictionary.modules(dictionary.count() - 1).is_some());
        }
    }

    /// Every tag in every rotation, whole and with as many wrong modules as are corrected.
    #[test]
    fn tags_are_identified_in_every_rotation() {
        for dictionary in Dictionary::all() {
            let side = dictionary.side();
            for id in (0..dictionary.count()).step_by(7) {
                let mut pattern = dictionary.modules(id).unwrap();
                for quarters in 0..4 {
                    let mut wrong = pattern.clone();
                    let most = dictionary.row().5 as usize;
                    (0..most).for_each(|k| wrong[3 * k] = !wrong[3 * k]);
                    for (pattern, hamming) in [(&pattern, 0), (&wrong, most as u32)] {
                        let expected = Identity {
                            id,
                            quarters,
                            hamming,
                        };
                        assert_eq!(dictionary.identify(pattern), Some(expected), "{dictionary}");
                    }
                    // Clockwise: the left column becomes the top row.
                    let turned =
                        (0..side * side).map(|k| pattern[(side - 1 - k % side) * side + k / side]);
                    pattern = turned.collect();
                }
            }
        }
    }
}
