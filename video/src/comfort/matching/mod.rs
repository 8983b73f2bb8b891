//! Points that both views show, to a fraction of a pixel.
//!
//! Corners of the left view, one in each cell of a grid, are searched in the right view by the
//! correlation of their surroundings, in views reduced to at most [`WIDEST`] columns. What is
//! ambiguous, or does not lead back to the corner, is left out. Then the surroundings are aligned
//! at full size. Where one view is so much less sharp that this fails, both are smoothed, and the
//! surroundings are aligned in the reduced views alone.

mod alignment;
mod corner;
mod reduced;
mod search;

use ga_image::plane::PlaneView;
use ga_runtime::batch::{Batch, Work};
use serde::{Deserialize, Serialize};

use alignment::{Aligned, align};
use corner::Corners;
use reduced::{RADIUS, Reduced, ZERO};
use search::{Reach, Scores};

/// The greatest number of columns of the views that are reduced for the search.
const WIDEST: usize = 320;

/// A point is searched within this share of the columns to either side, and of the rows.
const REACH: [f64; 2] = [0.2, 0.06];

/// The number of pixels on either side of the middle one in the surroundings that are aligned, in
/// the reduced and in the full view.
const FINE_RADIUS: [usize; 2] = [RADIUS, 7];

/// The greatest distance in pixels that alignment may lead away from where it starts.
const FARTHEST: f32 = 2.5;

/// The least correlation of surroundings, when searched and when aligned at full size.
const LEAST_CORRELATION: [f32; 2] = [0.6, 0.5];

/// A point that both views show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Match {
    /// The pixel in the left view, counted from the centre of the top left one.
    pub left: [f64; 2],
    /// The pixel in the right view.
    pub right: [f64; 2],
    /// The standard deviation of the pixel in the right view along columns and rows, as the
    /// difference of the aligned surroundings has it.
    pub deviation: [f64; 2],
    /// The mean of luma, in the codes of the views, over the surroundings in the left and in the
    /// right view.
    pub luma: [f64; 2],
    /// The correlation of the aligned surroundings, at most 1.
    pub correlation: f64,
}

/// The matcher of views of one size, with its memory.
#[derive(Clone, Debug)]
pub(super) struct Matcher {
    size: [usize; 2],
    /// Columns and rows of a view for each of the reduced view.
    factor: usize,
    reduced: [Reduced; 2],
    corners: Corners,
    scores: Scores,
    matches: Vec<Match>,
}

impl Matcher {
    pub(super) fn new(size: [usize; 2]) -> Self {
        let factor = size[0].div_ceil(WIDEST).max(1);
        let reduced_size = size.map(|side| side / factor);
        Self {
            size,
            factor,
            reduced: [(); 2].map(|()| Reduced::new(reduced_size)),
            corners: Corners::new(reduced_size),
            scores: Scores::default(),
            matches: Vec::new(),
        }
    }

    /// Columns and rows of the views.
    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The points that two views of the size of the matcher show, by the cells of the grid.
    pub(super) fn run(&mut self, views: [PlaneView<'_, u8>; 2]) -> &[Match] {
        self.matches.clear();
        let [width, height] = self.reduced[0].size();
        if width.min(height) > 2 * RADIUS + 2 {
            for (reduced, view) in self.reduced.iter_mut().zip(views) {
                reduced.update(view, self.factor);
            }
            let (matcher, views) = (self, Some(views));
            Batch::new().run(Matching { matcher, views });
            return &matcher.matches;
        }
        &self.matches
    }

    /// The points that the views of the last run show without their details, to a fraction of a
    /// pixel of the reduced views.
    pub(super) fn run_smoothed(&mut self) -> &[Match] {
        self.matches.clear();
        let [width, height] = self.reduced[0].size();
        if width.min(height) > 2 * RADIUS + 2 {
            self.reduced.iter_mut().for_each(Reduced::smooth);
            let (matcher, views) = (self, None);
            Batch::new().run(Matching { matcher, views });
            return &matcher.matches;
        }
        &self.matches
    }
}

struct Matching<'a> {
    matcher: &'a mut Matcher,
    /// The views at full size, where surroundings are aligned in them.
    views: Option<[PlaneView<'a, u8>; 2]>,
}

impl Work for Matching<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { matcher, views } = self;
        let Matcher {
            factor,
            reduced,
            corners,
            scores,
            matches,
            ..
        } = matcher;
        let size = reduced[0].size();
        let reach = [0, 1].map(|axis| (REACH[axis] * size[axis] as f64).ceil() as usize);
        for corner in corners.find(&reduced[0].levels) {
            let found = search(reduced, scores, *corner, reach)
                .and_then(|start| refine(reduced, views, *factor, *corner, start));
            matches.extend(found);
        }
    }
}

/// Where the right view shows a corner of the left one, both reduced.
#[inline(always)]
fn search(
    reduced: &[Reduced; 2],
    scores: &mut Scores,
    corner: [usize; 2],
    reach: [usize; 2],
) -> Option<[f32; 2]> {
    /// A point may lead back to a pixel beside the corner.
    const BACK: usize = 1;
    /// Rows above and below the corner in which the way back is searched.
    const BACK_ROWS: usize = 2;
    let [left, right] = reduced;
    let forth = scores.run(
        left,
        corner,
        right,
        Reach::around(corner, reach, right.size()),
    )?;
    if forth.correlation < LEAST_CORRELATION[0] || !forth.is_distinct() {
        return None;
    }
    let around = Reach {
        columns: Reach::around(forth.pixel, reach, left.size()).columns,
        rows: Reach::around(corner, [0, BACK_ROWS], left.size()).rows,
    };
    let back = scores.run(right, forth.pixel, left, around)?;
    let leads_back = (0..2).all(|axis| back.pixel[axis].abs_diff(corner[axis]) <= BACK);
    leads_back.then_some(forth.place)
}

/// The match of a corner whose place in the right view is known to about a reduced pixel.
#[inline(always)]
fn refine(
    reduced: &[Reduced; 2],
    views: Option<[PlaneView<'_, u8>; 2]>,
    factor: usize,
    corner: [usize; 2],
    start: [f32; 2],
) -> Option<Match> {
    let mut offset = [0, 1].map(|axis| start[axis] - corner[axis] as f32);
    let mut coarse = None;
    if factor > 1 || views.is_none() {
        let levels = [0, 1].map(|side| reduced[side].levels.view());
        let mut aligned: Aligned = align::<f32, { FINE_RADIUS[0] }>(levels, corner, offset, 1.5)?;
        let scaled = |lengths: [f32; 2]| lengths.map(|length| length * factor as f32);
        aligned.offset = scaled(aligned.offset);
        aligned.deviation = scaled(aligned.deviation);
        aligned.means = aligned.means.map(|mean| mean + ZERO);
        offset = aligned.offset;
        coarse = Some(aligned);
    }
    let pixel = corner.map(|x| x * factor + factor / 2);
    let aligned = match views {
        Some(views) => align::<u8, { FINE_RADIUS[1] }>(views, pixel, offset, FARTHEST)?,
        None => coarse?,
    };
    (aligned.correlation >= LEAST_CORRELATION[1]).then(|| Match {
        left: pixel.map(|x| x as f64),
        right: [0, 1].map(|axis| pixel[axis] as f64 + f64::from(aligned.offset[axis])),
        deviation: aligned.deviation.map(f64::from),
        luma: aligned.means.map(f64::from),
        correlation: aligned.correlation.into(),
    })
}
