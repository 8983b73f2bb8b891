//! The places of the frames on a sheet.

use super::options::Layout;
use super::{Caption, Kind, Options, SheetError};

impl Layout {
    /// The indices of the frames in each row.
    pub(super) fn rows(self, captions: &[Caption]) -> Result<Vec<Vec<usize>>, SheetError> {
        if captions.is_empty() {
            return Err(SheetError::NoFrames);
        }
        match self {
            Self::Columns(0) => Err(SheetError::Size {
                columns: 0,
                rows: 0,
            }),
            Self::Columns(columns) => {
                let all: Vec<usize> = (0..captions.len()).collect();
                Ok(all.chunks(columns).map(<[usize]>::to_vec).collect())
            }
            Self::KeyToKey => {
                let is_key = |&index: &usize| captions[index].kind == Kind::Key;
                let keys: Vec<usize> = (0..captions.len()).filter(is_key).collect();
                let whole = keys.len() >= 2
                    && keys.first() == Some(&0)
                    && keys.last() == Some(&(captions.len() - 1));
                if !whole {
                    return Err(SheetError::NotKeyToKey);
                }
                Ok(keys
                    .windows(2)
                    .map(|pair| (pair[0]..=pair[1]).collect())
                    .collect())
            }
        }
    }
}

/// Free space around the sheet and between pictures, in pixels.
const MARGIN: u32 = 20;
const GAP: u32 = 12;

/// Height of the title and of a caption of two lines.
const TITLE: u32 = 30;
pub(super) const CAPTION: u32 = 44;

/// Width of the frame around each picture.
pub(super) const BORDER: u32 = 3;

/// The places of everything on a sheet, in pixels from its top left.
pub(super) struct Size {
    pub(super) width: u32,
    pub(super) height: u32,
    picture: [u32; 2],
    title: u32,
    row: u32,
}

impl Size {
    pub(super) fn new(rows: &[Vec<usize>], options: &Options) -> Result<Self, SheetError> {
        // More pixels on a side than PNG viewers take, and more in all than memory may hold.
        const LONGEST: u64 = 1 << 16;
        const MOST_PIXELS: u64 = 1 << 28;
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let picture = [options.style.width, options.style.height];
        let title = if options.title.is_empty() { 0 } else { TITLE };
        let depth_rows = if options.depth { 2 } else { 1 };
        let [cell_width, cell_height] = picture.map(|side| u64::from(side) + 2 * u64::from(BORDER));
        let row = cell_height * depth_rows + u64::from(CAPTION) + u64::from(GAP) * depth_rows;
        let gap = u64::from(GAP);
        let around = 2 * u64::from(MARGIN);
        let width = (columns as u64)
            .saturating_mul(cell_width + gap)
            .saturating_add(around)
            - gap;
        let height = (rows.len() as u64)
            .saturating_mul(row)
            .saturating_add(around + u64::from(title))
            - gap;
        if width > LONGEST || height > LONGEST || width * height > MOST_PIXELS {
            return Err(SheetError::Size {
                columns,
                rows: rows.len(),
            });
        }
        Ok(Self {
            width: width as u32,
            height: height as u32,
            picture,
            title,
            row: row as u32,
        })
    }

    /// The top left corner of the title.
    pub(super) fn title(&self) -> [u32; 2] {
        [MARGIN, MARGIN - 4]
    }

    /// The top left corner of the picture at a column and a row.
    pub(super) fn picture(&self, column: usize, row: usize) -> [u32; 2] {
        [
            MARGIN + BORDER + column as u32 * (self.picture[0] + 2 * BORDER + GAP),
            MARGIN + BORDER + self.title + row as u32 * self.row,
        ]
    }

    /// The top left corner of the depth picture that goes with it.
    pub(super) fn depth(&self, column: usize, row: usize) -> [u32; 2] {
        let [x, y] = self.caption(column, row);
        [x, y + CAPTION + BORDER]
    }

    /// The top left corner of its caption.
    pub(super) fn caption(&self, column: usize, row: usize) -> [u32; 2] {
        let [x, y] = self.picture(column, row);
        [x, y + self.picture[1] + 2 * BORDER]
    }
}
