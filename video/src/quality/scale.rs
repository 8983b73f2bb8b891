//! A video at the size of another one.

use ga_image::interpolation::cubic_weights;
use ga_image::plane::{Plane, PlaneError};
use ga_image::resample::{Method, resize};
use ga_image::sample::{Pixel, Sample};

use crate::{Frame, Planes, Properties, Samples, Source, VideoError};

/// A video whose frames are scaled as they are read: where it shrinks in both directions by the
/// means over the area of each pixel, and otherwise by cubic convolution.
///
/// The picture covers the same rectangle before and after. Luma and colour differences are scaled
/// each for itself.
#[derive(Debug)]
pub struct Scaled<S> {
    source: S,
    properties: Properties,
    original: Frame,
}

impl<S: Source> Scaled<S> {
    /// A video with this number of columns and rows. Its pixels have the shape of those of
    /// `pixel_aspect`, as the other video states it.
    #[must_use]
    pub fn new(source: S, size: [usize; 2], pixel_aspect: [u32; 2]) -> Self {
        let properties = Properties {
            size,
            pixel_aspect,
            ..*source.properties()
        };
        Self {
            source,
            properties,
            original: Frame::default(),
        }
    }

    /// How the frames are scaled, in words.
    #[must_use]
    pub fn method(&self) -> &'static str {
        match shrinks(self.source.properties().size, self.properties.size) {
            true => "the means over the area of each pixel",
            false => "cubic convolution",
        }
    }

    fn planes<T: Pixel<Sample = T> + Sample>(
        &self,
        planes: &Planes<T>,
    ) -> Result<Planes<T>, PlaneError> {
        let luma = self.properties.size;
        let differences = self.properties.sampling.difference_size(luma);
        let [cb, cr] = &planes.differences;
        Ok(Planes {
            luma: scaled(&planes.luma, luma)?,
            differences: [scaled(cb, differences)?, scaled(cr, differences)?],
        })
    }
}

impl<S: Source> Source for Scaled<S> {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        if !self.source.read(&mut self.original)? {
            return Ok(false);
        }
        let index = self.original.index;
        let samples = match &self.original.samples {
            Samples::Eight(planes) => self.planes(planes).map(Samples::Eight),
            Samples::Ten(planes) => self.planes(planes).map(Samples::Ten),
        };
        *frame = Frame {
            samples: samples.map_err(|problem| VideoError::Unmeasured {
                frame: index,
                problem,
            })?,
            ..Frame {
                index,
                time_seconds: self.original.time_seconds,
                samples: Samples::default(),
            }
        };
        Ok(true)
    }
}

fn shrinks(old: [usize; 2], new: [usize; 2]) -> bool {
    new[0] <= old[0] && new[1] <= old[1]
}

fn scaled<T: Pixel<Sample = T> + Sample>(
    plane: &Plane<T>,
    [width, height]: [usize; 2],
) -> Result<Plane<T>, PlaneError> {
    let old = [plane.width(), plane.height()];
    if plane.is_empty() || shrinks(old, [width, height]) {
        return resize(plane, width, height, Method::Area);
    }
    // The four samples around the centre of a new one, and their weights. Beyond the border the
    // picture is constant.
    let taps = |new: usize, old: usize| -> Vec<[(usize, f64); 4]> {
        let of = |place: usize| {
            let centre = (place as f64 + 0.5) * old as f64 / new as f64 - 0.5;
            let weights = cubic_weights(centre - centre.floor());
            [0, 1, 2, 3].map(|tap| {
                let at = (centre.floor() + tap as f64 - 1.0).clamp(0.0, (old - 1) as f64);
                (at as usize, weights[tap])
            })
        };
        (0..new).map(of).collect()
    };
    let (columns, rows) = (taps(width, old[0]), taps(height, old[1]));
    let across: Vec<Vec<f64>> = (0..old[1])
        .map(|row| {
            let row = plane.row(row);
            let sum = |taps: &[(usize, f64); 4]| {
                let terms = taps
                    .iter()
                    .map(|(at, weight)| weight * f64::from(row[*at].to_f32()));
                terms.sum()
            };
            columns.iter().map(sum).collect()
        })
        .collect();
    Ok(Plane::from_fn(width, height, |column, row| {
        let terms = rows[row]
            .iter()
            .map(|(at, weight)| weight * across[*at][column]);
        T::from_f32(terms.sum::<f64>() as f32)
    }))
}
