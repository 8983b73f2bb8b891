//! Disparity maps and their errors in colours, to be looked at.

use ga_image::plane::{Plane, PlaneView};
use ga_render::panel::{Panel, beside};

use super::DisparityMap;
use super::evaluation::ErrorMap;

/// Colours for numbers of a range, by one of the perceptually uniform maps of N. Smith and S. van
/// der Walt (matplotlib 2.0, 2015): equal steps of the number look like equal steps of lightness.
///
/// Pixels without a number are marked by greys, which neither map contains.
///
/// ```
/// use ga_vision::disparity::picture::ColourScale;
///
/// let scale = ColourScale::viridis([0.0, 64.0]);
/// assert_eq!(scale.colour(0.0), [68, 1, 84]);
/// assert_eq!(scale.colour(64.0), [253, 231, 37]);
/// assert_eq!(scale.colour(100.0), scale.colour(64.0));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ColourScale {
    gradient: colorous::Gradient,
    range: [f64; 2],
}

impl ColourScale {
    /// From violet through green to yellow; for disparities.
    #[must_use]
    pub fn viridis(range: [f64; 2]) -> Self {
        Self {
            gradient: colorous::VIRIDIS,
            range,
        }
    }

    /// From black through red to pale yellow; for errors.
    #[must_use]
    pub fn inferno(range: [f64; 2]) -> Self {
        Self {
            gradient: colorous::INFERNO,
            range,
        }
    }

    /// The first and the last number of the range.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The colour of a number, as 8-bit sRGB. Numbers outside the range have the colours of its
    /// ends. Where the range has no length, its number has the first colour.
    #[must_use]
    pub fn colour(&self, value: f64) -> [u8; 3] {
        let [first, last] = self.range;
        let share = (value - first) / (last - first);
        // NaN, of a range without length, fails the comparison.
        let share = if share > 0.0 { share.min(1.0) } else { 0.0 };
        let colorous::Color { r, g, b } = self.gradient.eval_continuous(share);
        [r, g, b]
    }

    /// The mark of an unknown disparity: stripes of light and dark grey.
    #[must_use]
    pub fn unknown([column, row]: [usize; 2]) -> [u8; 3] {
        if (column + row) / 3 % 2 == 0 {
            [205; 3]
        } else {
            [105; 3]
        }
    }

    /// The mark of a pixel that an evaluation leaves out: one grey.
    #[must_use]
    pub fn left_out() -> [u8; 3] {
        [150; 3]
    }

    /// A map in the colours of its disparities, in pixels; unknown ones are marked.
    #[must_use]
    pub fn disparities(&self, map: &DisparityMap) -> Plane<[u8; 3]> {
        picture(map.view(), |place, value| match value.is_finite() {
            true => self.colour(f64::from(value)),
            false => Self::unknown(place),
        })
    }

    /// Errors in pixels in colours. Unknown disparities and pixels that are left out are marked.
    #[must_use]
    pub fn errors(&self, errors: &ErrorMap) -> Plane<[u8; 3]> {
        picture(errors.view(), |place, error| match error {
            error if error.is_nan() => Self::left_out(),
            error if error.is_infinite() => Self::unknown(place),
            error => self.colour(error),
        })
    }
}

/// What `colour` gives for the column and row of each pixel, and its number.
fn picture<T: Copy>(
    view: PlaneView<'_, T>,
    colour: impl Fn([usize; 2], T) -> [u8; 3],
) -> Plane<[u8; 3]> {
    Plane::from_fn(view.width(), view.height(), |column, row| {
        colour([column, row], view.row(row)[column])
    })
}

/// Errors of this number of pixels and more have the last colour of a comparison.
const MOST_ERROR_PX: f64 = 4.0;

/// A map in the colours of its own range, with a caption and its scale.
#[must_use]
pub fn captioned(map: &DisparityMap) -> Plane<[u8; 3]> {
    let scale = ColourScale::viridis(map.range().unwrap_or_default().map(f64::from));
    beside(&[of_disparities("disparity", map, scale)])
}

/// A map and the truth in the colours of one scale, and the errors, each with a caption and its
/// scale.
#[must_use]
pub fn comparison(map: &DisparityMap, truth: &DisparityMap, errors: &ErrorMap) -> Plane<[u8; 3]> {
    // A truth of 0 is as unknown as one that is not finite.
    let known = |value: f32| if value == 0.0 { f32::NAN } else { value };
    let truth = DisparityMap::new(truth.plane().map(known));
    let scale = ColourScale::viridis(truth.range().unwrap_or_default().map(f64::from));
    let of_errors = ColourScale::inferno([0.0, MOST_ERROR_PX]);
    beside(&[
        of_disparities("disparity", map, scale),
        of_disparities("truth", &truth, scale),
        Panel {
            caption: format!(
                "error, bad 2 = {:.2} %, D1 = {:.2} %",
                errors.bad(2.0),
                errors.d1()
            ),
            picture: of_errors.errors(errors),
            colours: Box::new(move |share| of_errors.colour(share * MOST_ERROR_PX)),
            ends: ["0.0 px".into(), format!("{MOST_ERROR_PX:.1} px or more")],
            marks: vec![
                (ColourScale::unknown, "disparity unknown"),
                (|_| ColourScale::left_out(), "left out"),
            ],
        },
    ])
}

fn of_disparities(caption: &str, map: &DisparityMap, scale: ColourScale) -> Panel {
    let [first, last] = scale.range();
    Panel {
        caption: caption.into(),
        picture: scale.disparities(map),
        colours: Box::new(move |share| scale.colour(first + share * (last - first))),
        ends: [first, last].map(|end| format!("{end:.1} px")),
        marks: vec![(ColourScale::unknown, "unknown")],
    }
}
