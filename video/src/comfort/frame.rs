//! What is measured of one frame.

use super::dimension::Dimension;
use ga_image::plane::PlaneError;
use ga_image::ycbcr::YCbCr;
use serde::{Deserialize, Serialize};

use super::geometry::{self, Geometry};
use super::matching::{Match, Matcher};
use super::parallax::Parallax;
use super::photometry::{Colours, Photometry};
use super::row::{Missing, Row};
use super::scale::{SIZE, Scale};
use super::sharpness;
use super::viewing::Viewing;
use crate::Samples;
use crate::stereo::pixel_height;

/// What is measured of the two views of one frame.
///
/// A part is `None` where the views do not show what it needs: where they are flat, or too few
/// points of one are found in the other.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::ycbcr::YCbCr;
/// use ga_video::comfort::{Dimension, FrameMeasures, Level, Viewing};
/// use ga_video::{Planes, Samples};
///
/// // Random blocks; the right view is 3 pixels lower, and 4 pixels farther to the right.
/// let grey = |u: usize, v: usize| {
///     let block = (u / 7 + 1) * 7919 + (v / 7 + 1) * 104_729;
///     (40 + block * block / 977 % 150) as u8
/// };
/// let view = |u: usize, v: usize| {
///     let luma = Plane::from_fn(480, 270, |column, row| grey(column + u, row + v));
///     Samples::Eight(Planes { luma, ..Planes::default() })
/// };
/// let found = FrameMeasures::of(&view(4, 3), &view(0, 0), YCbCr::default())?;
/// let geometry = found.geometry.unwrap();
/// assert!((geometry.shift_px - 3.0).abs() < 0.05);
/// assert!((found.parallax.as_ref().unwrap().median_px - 4.0).abs() < 0.05);
///
/// let row = found.row(Dimension::Vertical, &Viewing::default()).unwrap();
/// assert_eq!(row.score.map(|score| score.level()), Ok(Level::Orange));
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FrameMeasures {
    /// The points that both views show and that agree on a geometry, from the top left one.
    pub matches: Vec<Match>,
    /// How rows of the right view differ from those of the left one.
    pub geometry: Option<Geometry>,
    /// How brightness and colour differ.
    pub photometry: Option<Photometry>,
    /// The binary logarithm of the sharpness of the right view over that of the left one: −1 where
    /// slopes are half as steep at equal contrast.
    pub sharpness_log2: Option<f64>,
    /// How far in front of the screen and behind it points appear.
    pub parallax: Option<Parallax>,
}

impl FrameMeasures {
    /// The measures of one frame. For many frames a [`FrameMeter`] keeps its memory.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the views differ in size.
    pub fn of(left: &Samples, right: &Samples, colours: YCbCr) -> Result<Self, PlaneError> {
        let mut meter = FrameMeter::new(left.size(), colours);
        meter.measure(left, right)?;
        Ok(meter.measures)
    }

    /// A row of the table, for eyes before a screen. `None` for what one frame alone does not show:
    /// asynchrony, parallax deviation and stereoscopy.
    ///
    /// The raw number of [`Dimension::FocalGap`] is the difference of sharpness; its score is the
    /// greater one of those of sharpness and of size, the latter by
    /// [`Geometry::zoom_percent`].
    #[must_use]
    pub fn row(&self, dimension: Dimension, viewing: &Viewing) -> Option<Row> {
        let photometry = self.photometry.as_ref();
        let parallax = self.parallax.as_ref();
        let raw = match dimension {
            Dimension::Brightness => photometry.map(|found| found.luminance_percent),
            Dimension::Colour => photometry.map(|found| found.colour_difference),
            Dimension::Vertical => self.vertical_arcminutes(viewing),
            Dimension::WeakDepth | Dimension::RichDepth => parallax.map(Parallax::range_percent),
            Dimension::OverConvergence => parallax.map(|found| found.crossed_degrees(viewing)),
            Dimension::OverDivergence => parallax.map(|found| found.uncrossed_degrees(viewing)),
            Dimension::FocalGap => self.sharpness_log2.map(f64::abs),
            Dimension::Asynchrony | Dimension::ParallaxDeviation | Dimension::Stereoscopy => {
                return None;
            }
        };
        let scale = Scale::of(dimension, viewing)?;
        let Some(raw) = raw else {
            return Some(Row::missing(dimension, Missing::NotMeasurable));
        };
        let mut row = Row::measured(dimension, raw, &scale);
        if let (Dimension::FocalGap, Ok(score), Some(geometry)) =
            (dimension, &mut row.score, self.geometry)
        {
            *score = (*score).max(SIZE.score(geometry.zoom_percent));
        }
        Some(row)
    }

    /// The vertical deviation as a visual angle.
    fn vertical_arcminutes(&self, viewing: &Viewing) -> Option<f64> {
        Some(60.0 * viewing.degrees_of_length(self.geometry?.deviation_percent))
    }
}

/// Measures frames of one size one after another, without new memory for each.
///
/// Frames do not depend on each other, so that several meters may measure them at the same time.
#[derive(Clone, Debug)]
pub struct FrameMeter {
    colours: YCbCr,
    pixel_height: f64,
    matcher: Matcher,
    distances: Vec<f64>,
    windows: Colours,
    numbers: Vec<f64>,
    measures: FrameMeasures,
}

impl FrameMeter {
    /// For views of this size in columns and rows, in this encoding of colours, with square pixels.
    /// Views that are too small to find points in have measures without any part.
    #[must_use]
    pub fn new(size: [usize; 2], colours: YCbCr) -> Self {
        Self {
            colours,
            pixel_height: 1.0,
            matcher: Matcher::new(size),
            distances: Vec::new(),
            windows: Colours::default(),
            numbers: Vec::new(),
            measures: FrameMeasures::default(),
        }
    }

    /// The same for pixels of this width and height, as in
    /// [`Properties::pixel_aspect`](crate::Properties::pixel_aspect).
    #[must_use]
    pub fn with_pixel_aspect(self, aspect: [u32; 2]) -> Self {
        Self {
            pixel_height: pixel_height(aspect),
            ..self
        }
    }

    /// The measures of a frame. Numbers of 10 bits are rounded to 8.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when a view has another size than the meter.
    pub fn measure(
        &mut self,
        left: &Samples,
        right: &Samples,
    ) -> Result<&FrameMeasures, PlaneError> {
        let size = self.matcher.size();
        for samples in [left, right] {
            if samples.size() != size {
                return Err(PlaneError::Differs {
                    first: samples.size(),
                    second: size,
                });
            }
        }
        let [left, right] = [left.eight_bits(), right.eight_bits()];
        let mut all = self.matcher.run([left.luma.view(), right.luma.view()]);
        let mut geometry = geometry::fit(all, size, self.pixel_height, &mut self.distances);
        if geometry.is_none() {
            all = self.matcher.run_smoothed();
            geometry = geometry::fit(all, size, self.pixel_height, &mut self.distances);
        }
        let mut matches = std::mem::take(&mut self.measures.matches);
        matches.clear();
        self.measures = FrameMeasures {
            geometry,
            ..FrameMeasures::default()
        };
        if self.measures.geometry.is_some() {
            let pairs = all.iter().zip(&self.distances);
            let agreeing = pairs.filter(|(_, distance)| distance.is_finite());
            matches.extend(agreeing.map(|(found, _)| *found));
            self.distances.retain(|distance| distance.is_finite());
            let views = [&*left, &*right];
            let lumas = views.map(|view| &view.luma);
            self.measures.photometry = self.windows.measure(views, self.colours, &matches);
            self.measures.sharpness_log2 = sharpness::measure(lumas, &matches, &mut self.numbers);
            self.measures.parallax = Parallax::new(&matches, &self.distances, size);
        }
        self.measures.matches = matches;
        Ok(&self.measures)
    }
}
