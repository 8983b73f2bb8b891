//! What is kept of the pictures of a frame until it is known whether they are shown.

use crate::comfort::{Dimension, FrameMeasures, Level, Match, Viewing};
use crate::{Frame, Planes, Samples};
use ga_image::plane::Plane;
use ga_image::resample::box_means;
use ga_image::ycbcr::YCbCr;

/// The greatest number of columns that views are reduced to.
const WIDEST: usize = 480;

/// Columns of the parts that are kept at full size: a part of those of the view, and the least and
/// the greatest number. Their rows are three quarters of that.
const DETAIL_SHARE: usize = 6;
const DETAIL: [usize; 2] = [80, 160];

/// A picture in red, green and blue.
pub(super) type Picture = Plane<[u8; 3]>;

/// The views of a frame, reduced.
#[derive(Debug)]
pub(super) struct Kept {
    pub(super) frame: usize,
    /// Columns and rows of a view at full size.
    pub(super) size: [usize; 2],
    /// Columns, and rows, of a view for each of the reduced one.
    factor: usize,
    /// How many times a pixel is as high as wide.
    pixel_height: f64,
    views: [Frame; 2],
    /// A place that both views show, where one of them is less sharp.
    detail: Option<Detail>,
}

/// The surroundings of a point in both views, at full size.
#[derive(Debug)]
struct Detail {
    /// The pixel of the left view in their middle.
    place: [f64; 2],
    views: [Frame; 2],
}

impl Kept {
    pub(super) fn new(
        views: &[Frame; 2],
        measures: &FrameMeasures,
        viewing: &Viewing,
        pixel_height: f64,
    ) -> Self {
        let size = views[0].samples.size();
        let factor = size[0].div_ceil(WIDEST).max(1);
        let gap = measures.row(Dimension::FocalGap, viewing);
        let gap = gap.and_then(|row| row.score.ok());
        let has_gap = gap.is_some_and(|score| score.level() != Level::Green);
        Self {
            frame: views[0].index,
            size,
            factor,
            pixel_height,
            views: views.each_ref().map(|view| {
                let samples = view.samples.eight_bits();
                frame(Planes {
                    luma: box_means(&samples.luma, factor),
                    differences: samples
                        .differences
                        .each_ref()
                        .map(|plane| box_means(plane, factor)),
                })
            }),
            detail: has_gap.then(|| Detail::new(views, measures)).flatten(),
        }
    }

    /// The reduced views in red, green and blue.
    pub(super) fn views(&self, colours: YCbCr) -> [Picture; 2] {
        self.views.each_ref().map(|view| view.to_rgb(colours))
    }

    /// Where a pixel of a view is shown, where the reduced view is shown `width` wide with its top
    /// left corner at the origin.
    pub(super) fn place(&self, pixel: [f64; 2], width: f64) -> [f64; 2] {
        let [x, y] = pixel.map(|x| (x + 0.5) * self.scale(width));
        [x, self.pixel_height * y]
    }

    /// The pixel of the reduced view that shows a pixel of a view.
    pub(super) fn reduced(&self, pixel: [f64; 2]) -> [usize; 2] {
        // A cast from float saturates.
        [0, 1].map(|axis| {
            let place = (pixel[axis].max(0.0) + 0.5) as usize / self.factor;
            place.min(self.size[axis].div_ceil(self.factor).saturating_sub(1))
        })
    }

    /// The shown width of a pixel of a view, where the reduced view is shown `width` wide.
    pub(super) fn scale(&self, width: f64) -> f64 {
        width / (self.size[0].div_ceil(self.factor) * self.factor) as f64
    }

    /// How many times a pixel is as high as wide.
    pub(super) fn pixel_height(&self) -> f64 {
        self.pixel_height
    }

    /// How high the reduced view is shown where it is `width` wide.
    pub(super) fn height(&self, width: f64) -> f64 {
        let [columns, rows] = self.size.map(|side| side.div_ceil(self.factor) as f64);
        width * self.pixel_height * rows / columns
    }

    /// The surroundings of a point in both views at full size, and the point in the left view.
    pub(super) fn detail(&self, colours: YCbCr) -> Option<([f64; 2], [Picture; 2])> {
        let detail = self.detail.as_ref()?;
        let views = detail.views.each_ref().map(|view| view.to_rgb(colours));
        Some((detail.place, views))
    }
}

impl Detail {
    /// The surroundings of the point at which the sharper view has the steepest slopes, so that
    /// blur shows well.
    fn new(views: &[Frame; 2], measures: &FrameMeasures) -> Option<Self> {
        let views = views.each_ref().map(|view| view.samples.eight_bits());
        let [width, height] = [views[0].luma.width(), views[0].luma.height()];
        let columns = (width / DETAIL_SHARE).clamp(DETAIL[0], DETAIL[1]);
        let size = [columns.min(width), (columns * 3 / 4).min(height)];
        let start = |place: [f64; 2]| -> [usize; 2] {
            // An even pixel, at which a stored colour difference begins.
            std::array::from_fn(|axis| {
                let most = [width, height][axis] - size[axis];
                // A cast from float saturates.
                let start = (place[axis] - 0.5 * size[axis] as f64).max(0.0) as usize;
                start.min(most) / 2 * 2
            })
        };
        let inside = |found: &&Match| {
            [found.left, found.right].into_iter().all(|place| {
                (0..2).all(|axis| {
                    let half = 0.5 * size[axis] as f64;
                    (half..=[width, height][axis] as f64 - half).contains(&place[axis])
                })
            })
        };
        let sharper = usize::from(measures.sharpness_log2 > Some(0.0));
        let steepness = |found: &&Match| {
            let place = [found.left, found.right][sharper];
            slopes(&views[sharper].luma, place)
        };
        let best = measures
            .matches
            .iter()
            .filter(inside)
            .max_by_key(steepness)?;
        let parts = [(best.left, &views[0]), (best.right, &views[1])];
        Some(Self {
            place: best.left,
            views: parts.map(|(place, view)| frame(part(view, start(place), size))),
        })
    }
}

/// The sum of squared differences of neighbouring pixels around a place.
fn slopes(luma: &Plane<u8>, place: [f64; 2]) -> u64 {
    const RADIUS: usize = 12;
    // A cast from float saturates.
    let [column, row] = place.map(|x| x.max(0.0) as usize);
    let columns = column.saturating_sub(RADIUS)..(column + RADIUS).min(luma.width());
    let rows = row.saturating_sub(RADIUS)..(row + RADIUS).min(luma.height());
    let line = |row: usize| {
        let values = luma.row(row).get(columns.clone()).unwrap_or_default();
        let squares = values
            .windows(2)
            .map(|pair| u64::from(pair[0].abs_diff(pair[1])).pow(2));
        squares.sum::<u64>()
    };
    rows.step_by(2).map(line).sum()
}

fn frame(planes: Planes<u8>) -> Frame {
    Frame {
        samples: Samples::Eight(planes),
        ..Frame::default()
    }
}

/// A rectangle of a view, which begins at even pixels.
fn part(view: &Planes<u8>, [left, top]: [usize; 2], [width, height]: [usize; 2]) -> Planes<u8> {
    let cut = |plane: &Plane<u8>| {
        if plane.is_empty() {
            return Plane::default();
        }
        // 1 or 2 pixels for each stored number.
        let [across, down] = [
            view.luma.width().div_ceil(plane.width()),
            view.luma.height().div_ceil(plane.height()),
        ];
        Plane::from_fn(
            width.div_ceil(across),
            height.div_ceil(down),
            |column, row| {
                let row = (top / down + row).min(plane.height() - 1);
                plane.row(row)[(left / across + column).min(plane.width() - 1)]
            },
        )
    };
    Planes {
        luma: cut(&view.luma),
        differences: view.differences.each_ref().map(cut),
    }
}
