//! What users should know of a table that was read.

use std::fmt;

use super::error::shortened;

/// Something of a table of points that was left out, replaced or assumed when it was read.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PointTableNote {
    /// Columns that are not positions of named markers were passed over.
    ColumnsPassedOver(Vec<String>),
    /// A marker is 0,0,0 in some frames and elsewhere in others: it was read as not seen there.
    LostAtOrigin {
        /// The name of the point.
        point: String,
        /// The names of the frames.
        frames: Vec<String>,
    },
    /// One point is 0,0,0 in all frames that have it, and was kept there.
    AlwaysAtOrigin(String),
    /// Several points are 0,0,0 in all frames that have them: they were read as not seen.
    NeverFound(Vec<String>),
    /// Points that are seen in no frame were left out.
    NeverSeen(Vec<String>),
    /// The file does not say its unit of length, and was read as metres.
    NoUnit,
    /// Points are farther from each other than those of a face, and the file says no unit.
    PerhapsMillimetres {
        /// The name of the first such frame.
        frame: String,
        /// The diagonal of the box around its points, in metres.
        extent: f64,
    },
    /// The header states another number of frames than there are.
    FrameCount {
        /// What the header states.
        stated: String,
        /// How many there are.
        found: usize,
    },
}

impl PointTableNote {
    /// What it is, as one word for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::ColumnsPassedOver(_) => "columns_passed_over",
            Self::LostAtOrigin { .. } | Self::NeverFound(_) => "lost_at_origin",
            Self::AlwaysAtOrigin(_) => "always_at_origin",
            Self::NeverSeen(_) => "never_seen",
            Self::NoUnit | Self::PerhapsMillimetres { .. } => "unclear_unit",
            Self::FrameCount { .. } => "frame_count",
        }
    }

    /// How many things it is about, where they are counted.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        match self {
            Self::ColumnsPassedOver(names) | Self::NeverFound(names) | Self::NeverSeen(names) => {
                Some(names.len())
            }
            Self::LostAtOrigin { frames, .. } => Some(frames.len()),
            _ => None,
        }
    }
}

impl fmt::Display for PointTableNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ColumnsPassedOver(columns) => write!(
                f,
                "columns that are not positions of named markers are passed over: {}",
                shortened(columns)
            ),
            Self::LostAtOrigin { point, frames } => {
                let first = &frames[..frames.len().min(5)];
                let more = match frames.len() - first.len() {
                    0 => String::new(),
                    more => format!(" and {more} others"),
                };
                write!(
                    f,
                    "point {point} is 0,0,0 in {} of the frames ({}{more}), and is read as not \
                     seen there",
                    frames.len(),
                    first.join(", ")
                )
            }
            Self::AlwaysAtOrigin(point) => write!(
                f,
                "point {point} is 0,0,0 in all frames, and is kept there; if it was never seen, \
                 take its columns out"
            ),
            Self::NeverFound(points) => write!(
                f,
                "points that are 0,0,0 in all frames are read as never seen: {}",
                shortened(points)
            ),
            Self::NeverSeen(points) => write!(
                f,
                "points that are seen in no frame are left out: {}",
                shortened(points)
            ),
            Self::NoUnit => f.write_str("the file does not say its unit of length; metres"),
            Self::PerhapsMillimetres { frame, extent } => write!(
                f,
                "the points of frame {frame} extend over {extent:.1} m, which is too much for a \
                 face: the table may be in millimetres, but metres are expected"
            ),
            Self::FrameCount { stated, found } => write!(
                f,
                "the header states {stated} frames, and there are {found}: the file may have been \
                 cut off"
            ),
        }
    }
}
