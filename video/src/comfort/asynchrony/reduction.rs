//! Pictures of few columns and rows, whatever the video has.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::{Plane, PlaneError};
use ga_image::resample::{Method, resize};

use super::products::SIZE;
use crate::Samples;
use crate::keyframe::signature::{Sample, box_means};

/// The standard deviation of the smoothing, in columns and rows of the reduced picture.
///
/// Detail that is finer than the reduced picture must not remain in it as coarser detail, which
/// changes when it moves by a part of a column, so that no translation explains it. Interpolation
/// between whole translations needs a picture without the finest detail as well.
const SMOOTHING: f64 = 0.75;

/// What is smoothed has at least this multiple of the columns and rows of the reduced picture,
/// where the video has them.
const FINER: usize = 2;

/// Luma in numbers of 8 bits, smoothed and reduced to [`SIZE`]; black where there are no pixels.
pub(super) fn reduced(samples: &Samples) -> Plane<f32> {
    let means = match samples {
        Samples::Eight(planes) => means(&planes.luma, 1.0),
        Samples::Ten(planes) => means(&planes.luma, 0.25),
    };
    smoothed(&means).unwrap_or_else(|_| Plane::filled(SIZE[0], SIZE[1], 0.0))
}

/// Means over equal boxes, as few as are enough to be smoothed.
fn means<S: Sample>(luma: &Plane<S>, to_eight: f32) -> Plane<f32> {
    let size = [luma.width(), luma.height()];
    let factors = [0, 1].map(|axis| size[axis] / (FINER * SIZE[axis]));
    let factor = factors[0].min(factors[1]).max(1);
    let count = size.map(|side| side / factor);
    let whole = luma.view().part(0, 0, factor * count[0], factor * count[1]);
    let mut means = box_means(whole.unwrap_or(luma.view()), count);
    means.values_mut().iter_mut().for_each(|v| *v *= to_eight);
    means
}

fn smoothed(means: &Plane<f32>) -> Result<Plane<f32>, PlaneError> {
    let scale = (means.width() * means.height()) as f64 / (SIZE[0] * SIZE[1]) as f64;
    match Gaussian::new(SMOOTHING * scale.sqrt()) {
        Ok(gaussian) => {
            let smoothed = gaussian.blur(means, Border::Replicate);
            resize(&smoothed, SIZE[0], SIZE[1], Method::Area)
        }
        // A picture without pixels.
        Err(_) => resize(means, SIZE[0], SIZE[1], Method::Area),
    }
}
