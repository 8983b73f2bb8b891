//! The disparities of reduced views, in both directions and with either sign.

use ga_image::plane::Plane;
use ga_numerics::order_statistics::Sorted;

use super::view::{View, shrunk};
use ga_vision::disparity::StereoError;
use ga_vision::matcher::{Matcher, MatcherOptions, Mode};

/// The first look is taken at a third of the size.
const FIRST_LOOK: usize = 3;

/// Pixels of the reduced views for each pixel of the first look.
pub(super) const FIRST_LOOK_PIXELS: f64 = (FIRST_LOOK * FIRST_LOOK) as f64;

/// The greatest parallax that is looked for, as part of the width.
const REACH: f64 = 0.25;

/// The range of disparities that is matched extends this number of pixels beyond what was seen.
const MARGIN: f32 = 8.0;

/// Steps of luma over two pixels from which a pixel counts as textured, in numbers of 8 bits.
const TEXTURE_CODES: f32 = 10.0;

/// How clear a disparity must be in the first look.
const CLEAR: f32 = 0.08;

/// The least side of a view in pixels.
const LEAST_SIDE: usize = 48;

/// What matching two views shows.
pub(super) struct Correspondence {
    /// The disparities x_L − x_R of the pixels of the left view, NaN where the right one does not
    /// confirm them.
    pub(super) left: Plane<f32>,
    /// The disparities x_R − x_L of the pixels of the right view.
    pub(super) right: Plane<f32>,
    /// Pixels with texture in the first look at the left and at the right view.
    pub(super) textured: [f64; 2],
    /// The pixels of these whose disparity is confirmed.
    pub(super) confirmed: [f64; 2],
}

/// Matches two views; `None` where they are too small.
pub(super) fn correspond(left: &View, right: &View) -> Result<Option<Correspondence>, StereoError> {
    if left.width().min(left.height()) < LEAST_SIDE {
        return Ok(None);
    }
    let small = [shrunk(left, FIRST_LOOK), shrunk(right, FIRST_LOOK)];
    let reach = (REACH * small[0].width() as f64) as i32;
    let (mut textured, mut confirmed, mut seen) = ([0.0; 2], [0.0; 2], Vec::new());
    let [a, b] = &small;
    let (of_left, of_right) = rayon::join(
        || matched(a, b, [-reach, reach], CLEAR),
        || matched(b, a, [-reach, reach], CLEAR),
    );
    for (eye, sign, found) in [(0, 1.0, of_left?), (1, -1.0, of_right?)] {
        let view = &small[eye];
        for row in 1..view.height() - 1 {
            for column in 1..view.width() - 1 {
                let line = view.row(row);
                let step = line[column + 1][0] - line[column - 1][0];
                if step.abs() <= TEXTURE_CODES {
                    continue;
                }
                textured[eye] += 1.0;
                let disparity = found.row(row)[column];
                if !disparity.is_nan() {
                    confirmed[eye] += 1.0;
                    seen.push(sign * FIRST_LOOK as f32 * disparity);
                }
            }
        }
    }
    let most = (REACH * left.width() as f64) as f32;
    let sorted = Sorted::new(&mut seen);
    let quantile = |share: f64| {
        let disparity = sorted.map_or(0.0, |sorted| sorted.quantile(share));
        disparity.clamp(-most, most)
    };
    let range = [
        (quantile(0.01) - MARGIN).floor() as i32,
        (quantile(0.99) + MARGIN).ceil() as i32,
    ];
    let (of_left, of_right) = rayon::join(
        || matched(left, right, range, 0.0),
        || matched(right, left, [-range[1], -range[0]], 0.0),
    );
    Ok(Some(Correspondence {
        left: of_left?,
        right: of_right?,
        textured,
        confirmed,
    }))
}

/// The disparities of a view that are confirmed and clearer than a limit, within a range.
fn matched(
    view: &View,
    other: &View,
    [least, most]: [i32; 2],
    clear: f32,
) -> Result<Plane<f32>, StereoError> {
    let options = MatcherOptions {
        range: [
            least,
            least + (most - least + 1).clamp(1, view.width() as i32),
        ],
        mode: Mode::Balanced,
        threads: 1,
    };
    let mut matcher = Matcher::new(options, view.width(), view.height())?;
    let found = matcher.run(&grey(view), &grey(other))?;
    Ok(found.at_least(clear.next_up()).disparity.into_plane())
}

/// Luma.
fn grey(view: &View) -> Plane<u8> {
    // A cast from float saturates.
    Plane::from_fn(view.width(), view.height(), |column, row| {
        view.row(row)[column][0].round() as u8
    })
}
