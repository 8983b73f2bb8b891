//! Segments that are drawn over pictures.

use std::ops::Range;

use ga_image::plane::Plane;

use crate::text::blend;

/// A segment on a picture with round ends; a dot where both ends are one place. Its edge is one
/// pixel wide and soft.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_render::Segment;
///
/// let mut picture = Plane::filled(20, 10, [0; 3]);
/// let segment = Segment { ends: [[4.0, 5.0], [16.0, 5.0]], radius: 1.5 };
/// segment.draw(&mut picture, [200, 100, 0]);
/// assert_eq!(picture.get(10, 5), Some([200, 100, 0]));
/// assert_eq!(picture.get(10, 8), Some([0; 3]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Columns and rows, from the upper left corner of the picture: the centre of its first pixel
    /// is at `[0.5, 0.5]`. What lies outside the picture is not drawn.
    pub ends: [[f64; 2]; 2],
    /// Half the width in pixels.
    pub radius: f64,
}

impl Segment {
    /// Draws it over a picture. Nothing is drawn where a number is not finite.
    pub fn draw(&self, picture: &mut Plane<[u8; 3]>, colour: [u8; 3]) {
        if !(self.ends.as_flattened().iter().all(|x| x.is_finite()) && self.radius.is_finite()) {
            return;
        }
        let (width, height) = (picture.width(), picture.height());
        self.covered(0..height, width, |[column, row], Cover { share, .. }| {
            let pixel = &mut picture.row_mut(row)[column];
            let share = (255.0 * share).round() as u8;
            *pixel = std::array::from_fn(|k| blend(pixel[k], colour[k], share));
        });
    }

    /// Calls a function for each pixel of these rows, by its column and row, that the segment
    /// covers.
    pub(crate) fn covered(
        &self,
        rows: Range<usize>,
        width: usize,
        mut each: impl FnMut([usize; 2], Cover),
    ) {
        let [a, b] = self.ends;
        let reach = self.radius + 1.0;
        // A cast from float saturates, so that ends far outside the picture leave an empty or a
        // clamped range.
        let range = |low: f64, high: f64, within: Range<usize>| {
            let start = ((low - reach).max(0.0) as usize).max(within.start);
            start..((high + reach).max(0.0) as usize).min(within.end)
        };
        for row in range(a[1].min(b[1]), a[1].max(b[1]), rows) {
            let [low, high] = span(a, b, row as f64 + 0.5, reach);
            for column in range(low, high, 0..width) {
                let place = [column as f64 + 0.5, row as f64 + 0.5];
                let along = nearest(place, a, b);
                let foot = lerp(a, b, along);
                let distance = (place[0] - foot[0]).hypot(place[1] - foot[1]);
                let share = (self.radius + 0.5 - distance).clamp(0.0, 1.0);
                if share > 0.0 {
                    each([column, row], Cover { share, along, foot });
                }
            }
        }
    }
}

/// How a segment covers a pixel.
pub(crate) struct Cover {
    /// The share of the pixel, from 0 to 1.
    pub(crate) share: f64,
    /// Where on the segment the nearest place lies, from 0 to 1.
    pub(crate) along: f64,
    /// That place.
    pub(crate) foot: [f64; 2],
}

/// The least and the greatest column of the part of a segment within `reach` of a row.
fn span(a: [f64; 2], b: [f64; 2], row: f64, reach: f64) -> [f64; 2] {
    let fall = b[1] - a[1];
    let at = |row: f64| {
        let along = ((row - a[1]) / fall).clamp(0.0, 1.0);
        a[0] + (b[0] - a[0]) * along
    };
    if fall.abs() <= reach {
        return [a[0].min(b[0]), a[0].max(b[0])];
    }
    let (p, q) = (at(row - reach), at(row + reach));
    [p.min(q), p.max(q)]
}

/// Where on a segment the place nearest to `p` lies, from 0 at `a` to 1 at `b`.
fn nearest(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (ab, ap) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let squared = ab[0] * ab[0] + ab[1] * ab[1];
    if squared > 0.0 {
        ((ap[0] * ab[0] + ap[1] * ab[1]) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

fn lerp(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}
