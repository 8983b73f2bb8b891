//! Reads tables of points: which dialect it is, and what is checked in all of them.

use ga_mesh::bounds;

use super::error::PointTableError;
use super::layout::Layout;
use super::lost::Zeros;
use super::note::PointTableNote;
use super::points::PointTable;
use super::row::PointRow;
use super::{motive, plain, trc, vicon};

impl PointTable {
    /// Reads a table in one of the [dialects](super), which is found by what the file says.
    ///
    /// # Errors
    /// What is wrong with the table, with the line.
    pub fn decode(bytes: &[u8], zeros: Zeros) -> Result<Self, PointTableError> {
        let layout = layout(bytes)?;
        let frames = layout.frames()?;
        if frames.is_empty() {
            return Err(PointTableError::Empty);
        }
        check_labels(&frames)?;
        let mut notes = layout.notes;
        notes.extend(
            layout
                .stated_frames
                .filter(|stated| stated.parse() != Ok(frames.len()))
                .map(|stated| PointTableNote::FrameCount {
                    stated,
                    found: frames.len(),
                }),
        );
        let names: Vec<_> = layout.points.into_iter().map(|point| point.name).collect();
        let mut table = Self {
            numbers: (0..names.len()).collect(),
            names,
            frames,
            notes,
        };
        if zeros == Zeros::Lost {
            table.lose_zeros();
        }
        table.leave_out_never_seen();
        if table.names.is_empty() {
            return Err(PointTableError::NothingSeen);
        }
        if layout.metres.is_none() {
            let large = table.too_large();
            table.notes.extend(large);
        }
        Ok(table)
    }

    /// A note on the first frame whose points are too far from each other for a face in metres.
    fn too_large(&self) -> Option<PointTableNote> {
        /// The greatest extent, in metres, that a face and its surroundings may have.
        const MOST: f64 = 5.0;
        self.frames.iter().find_map(|row| {
            let [low, high] = bounds(row.points.iter().flatten().map(|&place| place.into()))?;
            let extent = (high - low).length();
            (extent > MOST).then(|| PointTableNote::PerhapsMillimetres {
                frame: row.label.clone(),
                extent,
            })
        })
    }
}

fn check_labels(frames: &[PointRow]) -> Result<(), PointTableError> {
    let mut labels: Vec<_> = frames.iter().map(|f| (f.label.as_str(), f.line)).collect();
    labels.sort_unstable();
    let twice = labels.windows(2).find(|pair| pair[0].0 == pair[1].0);
    match twice {
        Some(pair) => Err(PointTableError::SameFrame {
            line: pair[1].1,
            label: pair[1].0.to_owned(),
        }),
        None => Ok(()),
    }
}

fn layout(bytes: &[u8]) -> Result<Layout, PointTableError> {
    // The first byte of C3D is the block of its parameters, and the second always this.
    if matches!(bytes, [1..=8, 0x50, ..]) {
        return Err(PointTableError::C3d);
    }
    let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let start = start.trim_ascii_start();
    let begins = |word: &str| {
        let found = start.get(..word.len());
        found.is_some_and(|found| found.eq_ignore_ascii_case(word.as_bytes()))
    };
    if begins("PathFileType") {
        trc::layout(bytes)
    } else if begins("Format Version") {
        motive::layout(bytes)
    } else if vicon::is_vicon(bytes) {
        vicon::layout(bytes)
    } else {
        plain::layout(bytes)
    }
}
