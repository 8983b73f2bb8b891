//! The arms of a pixel: how far the levels around it stay near its own (K. Zhang, J. Lu and G.
//! Lafruit, "Cross-based local stereo matching using orthogonal integral images", IEEE Transactions
//! on Circuits and Systems for Video Technology 19, 2009).

use super::cost::difference;
use super::view::View;

/// The longest arm, in pixels.
pub(super) const LONGEST: usize = 20;

/// The arms of the pixels of one row. An arm ends before the first pixel whose level differs from
/// that of the centre, or of the pixel before it on the arm, by more than a threshold.
#[derive(Clone, Debug)]
pub(super) struct Arms {
    pub(super) left: Vec<u8>,
    pub(super) right: Vec<u8>,
    pub(super) up: Vec<u8>,
    pub(super) down: Vec<u8>,
    grows: Vec<u8>,
}

impl Arms {
    /// For rows of `width` pixels.
    pub(super) fn new(width: usize) -> Self {
        let row = || vec![0; width];
        Self {
            left: row(),
            right: row(),
            up: row(),
            down: row(),
            grows: row(),
        }
    }

    /// The arms along a row.
    #[inline(always)]
    pub(super) fn across(&mut self, view: &View, row: usize, threshold: u8) {
        let levels = view.row(row);
        let width = levels.len();
        let longest = LONGEST.min(width - 1);
        let grows = &mut self.grows;
        grows.fill(1);
        self.right.fill(0);
        for length in 1..=longest {
            // The last pixels meet the border.
            grows[width - length] = 0;
            let count = width - length;
            let (centre, end, before) = (levels, &levels[length..], &levels[length - 1..]);
            if !grow(
                &mut self.right[..count],
                &mut grows[..count],
                [centre, end, before],
                threshold,
            ) {
                break;
            }
        }
        grows.fill(1);
        self.left.fill(0);
        for length in 1..=longest {
            grows[length - 1] = 0;
            let count = width - length;
            let (centre, end, before) = (&levels[length..], levels, &levels[1..]);
            let (arms, grows) = (&mut self.left[length..], &mut grows[length..]);
            if !grow(
                &mut arms[..count],
                &mut grows[..count],
                [centre, end, before],
                threshold,
            ) {
                break;
            }
        }
    }

    /// The arms along columns.
    #[inline(always)]
    pub(super) fn along(&mut self, view: &View, row: usize, threshold: u8) {
        let levels = view.row(row);
        let grows = &mut self.grows;
        grows.fill(1);
        self.up.fill(0);
        for length in 1..=LONGEST.min(row) {
            let (end, before) = (view.row(row - length), view.row(row - length + 1));
            if !grow(&mut self.up, grows, [levels, end, before], threshold) {
                break;
            }
        }
        grows.fill(1);
        self.down.fill(0);
        for length in 1..=LONGEST.min(view.height() - 1 - row) {
            let (end, before) = (view.row(row + length), view.row(row + length - 1));
            if !grow(&mut self.down, grows, [levels, end, before], threshold) {
                break;
            }
        }
    }
}

/// Makes those arms longer by one whose next pixel is near; returns whether there are any.
#[inline(always)]
fn grow(arms: &mut [u8], grows: &mut [u8], levels: [&[u8]; 3], threshold: u8) -> bool {
    let count = arms.len();
    let grows = &mut grows[..count];
    let [centre, end, before] = levels.map(|levels| &levels[..count]);
    let mut any = 0;
    for column in 0..count {
        let far =
            difference(centre[column], end[column]).max(difference(before[column], end[column]));
        let near = u8::from(far <= threshold) & grows[column];
        grows[column] = near;
        arms[column] += near;
        any |= near;
    }
    any != 0
}
