//! Views as they are compared: reduced, and aligned in height.

use ga_image::plane::Plane;

use super::Alignment;
use crate::keyframe::signature::{Sample, box_means};
use crate::{Planes, Samples};

/// What a reduced view shows: luma and colour differences of each pixel, in numbers of 8 bits.
pub(super) type View = Plane<[f32; 3]>;

/// The greatest number of columns of a reduced view.
const COLUMNS: usize = 480;

/// The reduced left view, and the right one moved to the heights of the left.
pub(super) fn reduced(left: &Samples, right: &Samples, alignment: &Alignment) -> [View; 2] {
    let [width, height] = left.size();
    let scale = (width as f64 / COLUMNS as f64).max(1.0);
    let size = [width, height].map(|side| ((side as f64 / scale).round() as usize).max(1));
    let right = view(right, size);
    let right = match alignment.is_none() {
        true => right,
        false => aligned(&right, alignment, scale),
    };
    [view(left, size), right]
}

fn view(samples: &Samples, size: [usize; 2]) -> View {
    match samples {
        Samples::Eight(planes) => of_planes(planes, size, 1.0),
        Samples::Ten(planes) => of_planes(planes, size, 0.25),
    }
}

fn of_planes<S: Sample>(planes: &Planes<S>, size: [usize; 2], to_eight: f32) -> View {
    let luma = box_means(planes.luma.view(), size);
    let differences = planes.differences.each_ref().map(|plane| {
        let means = (!plane.is_empty()).then(|| box_means(plane.view(), size));
        means.map_or_else(Vec::new, Plane::into_values)
    });
    let mut index = 0;
    luma.map(|luma| {
        let difference = |plane: &Vec<f32>| plane.get(index).map_or(128.0, |v| to_eight * v);
        let colour = [
            to_eight * luma,
            difference(&differences[0]),
            difference(&differences[1]),
        ];
        index += 1;
        colour
    })
}

/// The right view in which each point has the height that it has in the left one.
fn aligned(right: &View, alignment: &Alignment, scale: f64) -> View {
    let middle = [right.width(), right.height()].map(|side| 0.5 * (side as f64 - 1.0));
    let last = right.height() - 1;
    Plane::from_fn(right.width(), right.height(), |column, row| {
        let place = [column as f64 - middle[0], row as f64 - middle[1]];
        let higher = alignment.difference(place.map(|v| v * scale)) / scale;
        let y = (row as f64 + higher).clamp(0.0, last as f64);
        let above = (y as usize).min(last.saturating_sub(1));
        let part = (y - above as f64) as f32;
        let (a, b) = (
            right.row(above)[column],
            right.row((above + 1).min(last))[column],
        );
        std::array::from_fn(|channel| a[channel] + part * (b[channel] - a[channel]))
    })
}

/// A view of half or a third of the size, for a first look at the disparities.
pub(super) fn shrunk(view: &View, factor: usize) -> View {
    let size = [view.width(), view.height()].map(|side| (side / factor).max(1));
    let count = (factor * factor) as f32;
    Plane::from_fn(size[0], size[1], |column, row| {
        let mut sum = [0.0; 3];
        for y in 0..factor.min(view.height()) {
            for colour in &view.row(row * factor + y)[column * factor..][..factor.min(view.width())]
            {
                for (sum, value) in sum.iter_mut().zip(colour) {
                    *sum += value / count;
                }
            }
        }
        sum
    })
}
