//! A view in falling sizes.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::{Plane, PlaneView};
use ga_image::pyramid::Pyramid;
use ga_image::resample::{Method, resize};
use ga_image::sample::Sample;

/// A view with a side below this number of pixels has no features: there is no room for their
/// surroundings.
pub const LEAST_SIDE: usize = 64;

/// A view in one size.
pub(super) struct Scale {
    /// With little blur, for places.
    pub(super) smooth: Plane<f32>,
    /// With more blur, for comparisons of single pixels.
    pub(super) blurred: Plane<f32>,
    /// A place x here is `step · x + first` in the view, along each axis.
    step: [f64; 2],
    first: [f64; 2],
}

impl Scale {
    fn new(picture: &Plane<f32>, step: [f64; 2], first: [f64; 2]) -> Option<Self> {
        let blur = |sigma| Some(Gaussian::new(sigma).ok()?.blur(picture, Border::Mirror));
        Some(Self {
            smooth: blur(1.0)?,
            blurred: blur(2.0)?,
            step,
            first,
        })
    }

    /// A place of this scale in the view.
    pub(super) fn to_view(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.step[axis] * place[axis] + self.first[axis])
    }

    /// The size of a pixel in pixels of the view.
    pub(super) fn size(&self) -> f64 {
        (self.step[0] * self.step[1]).sqrt()
    }
}

/// A view in sizes that fall by √2: it is halved again and again, and so is a copy of it that is
/// smaller by √2.
pub(super) fn scales<T: Sample>(view: PlaneView<'_, T>, count: usize) -> Vec<Scale> {
    let picture = view.map(Sample::to_level);
    let (width, height) = (picture.width(), picture.height());
    if width.min(height) < LEAST_SIDE {
        return Vec::new();
    }
    let reduced = |side: usize| (side as f64 * std::f64::consts::FRAC_1_SQRT_2).round() as usize;
    let between = resize(&picture, reduced(width), reduced(height), Method::Area);
    let ratio = [
        width as f64 / reduced(width) as f64,
        height as f64 / reduced(height) as f64,
    ];
    let whole = Pyramid::new(&picture, count.div_ceil(2));
    let between = between.map(|between| Pyramid::new(&between, count / 2));
    let mut scales = Vec::new();
    for index in 0..count {
        let power = f64::from(1 << (index / 2).min(30));
        // The centre of pixel i of a halved picture is that of pixel 2 i; a resized picture covers
        // the same rectangle, whose edge is half a pixel before the first centre.
        let (level, step, first) = match (index % 2, &between) {
            (0, _) => (whole.levels().get(index / 2), [power; 2], [0.0; 2]),
            (_, Ok(between)) => {
                let step = ratio.map(|r| power * r);
                (
                    between.levels().get(index / 2),
                    step,
                    ratio.map(|r| 0.5 * r - 0.5),
                )
            }
            _ => continue,
        };
        let level = level.filter(|level| level.width().min(level.height()) >= LEAST_SIDE);
        scales.extend(level.and_then(|level| Scale::new(level, step, first)));
    }
    scales
}
