//! Visual attention: which parts of a frame people look at, from contours and motion.
//!
//! Cui weights PSNR and SSIM by a model of attention "computed from contour and motion
//! information", without a formula. This module chooses
//!
//! A = ½ N(G ∗ |∇Y|) + ½ N(G ∗ |v − v_global|),   w = 0.2 + 0.8 A,
//!
//! where Y is luma, v the motion since the frame before in each block, v_global the motion of most
//! blocks (that of the camera), G a Gaussian and N the normalisation of maps by Itti, Koch and
//! Niebur ("A model of saliency-based visual attention for rapid scene analysis", 1998), which
//! promotes maps with few strong peaks; here the region around the greatest that lies above half of
//! it is one peak. A lies between 0 and 1. For a picture alone, and the first
//! frame, A = N(G ∗ |∇Y|).
//!
//! Everything is computed on the picture reduced to at most 480 columns and rows, in cells of 8 × 8
//! reduced pixels. G has the standard deviation of 1/40 of the longer side: at three picture
//! heights from a screen of 16:9, 0.85° of the field of view, about the radius of the fovea.

mod block;
mod cell;
mod motion;
mod reduction;
mod saliency;
mod search;

use cell::{CELL, cells};
use ga_image::filter::{Border, Gaussian, Gradient};
use ga_image::plane::{Plane, PlaneError, PlaneView};
use ga_image::quality::Weights;

use reduction::reduced;
use saliency::{enlarged, normalised};

/// The greatest number of columns and of rows of the reduced picture.
const LONGEST: usize = 480;

/// The standard deviation of G, as a share of the longer side.
const SPREAD: f64 = 1.0 / 40.0;

/// Mean slopes in levels a pixel, and motions in reduced pixels a frame, below which the greatest
/// number of a map is not the unit of N: a map of noise alone has no peaks that attract attention.
const LEAST_SLOPE: f32 = 4.0;
const LEAST_MOTION: f32 = 1.0;

/// The weight of pixels without attention, and what full attention adds.
const WEIGHTS: [f32; 2] = [0.2, 0.8];

/// The attention that frames of one size attract, one frame after another.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::attention::Attention;
///
/// // A disc on a dark ground.
/// let picture = Plane::from_fn(320, 200, |column, row| {
///     let [x, y] = [column as f64 - 240.0, row as f64 - 100.0];
///     if x.hypot(y) < 20.0 { 200u8 } else { 30 }
/// });
/// let mut attention = Attention::new([320, 200])?;
/// let weights = attention.next(&picture)?.plane();
/// assert!(weights.get(240, 100) > Some(0.5));
/// assert_eq!(weights.get(10, 100), Some(0.2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Attention {
    size: [usize; 2],
    /// Columns and rows of the picture for each of the reduced picture.
    factor: usize,
    smoothing: Gaussian,
    previous: Option<Plane<u8>>,
    weights: Weights,
}

impl Attention {
    /// For frames of this size, in columns and rows.
    ///
    /// # Errors
    ///
    /// [`PlaneError::TooSmall`] when there are no pixels.
    pub fn new([width, height]: [usize; 2]) -> Result<Self, PlaneError> {
        let too_small = PlaneError::TooSmall {
            width,
            height,
            least: 1,
        };
        if width == 0 || height == 0 {
            return Err(too_small);
        }
        let longest = width.max(height);
        // Sums of 256 rows fit into 16 bits.
        let factor = longest.div_ceil(LONGEST).min(256);
        let spread = SPREAD * longest as f64 / (factor * CELL) as f64;
        Ok(Self {
            size: [width, height],
            factor,
            smoothing: Gaussian::new(spread.max(0.5)).map_err(|_| too_small)?,
            previous: None,
            weights: Weights::default(),
        })
    }

    /// The weights of the pixels of the next frame, from its luma in 8 bits.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the frame has another size; it is not counted as a frame then.
    pub fn next<'a>(&mut self, luma: impl Into<PlaneView<'a, u8>>) -> Result<&Weights, PlaneError> {
        let luma = luma.into();
        let size = [luma.width(), luma.height()];
        if size != self.size {
            let differs = PlaneError::Differs {
                first: size,
                second: self.size,
            };
            return Err(differs);
        }
        let current = reduced(luma, self.factor);
        let contours = contours(&current);
        let mut attention = self.normalised(&contours, LEAST_SLOPE);
        if let Some(previous) = &self.previous {
            let motion = motion::relative(previous, &current);
            let motion = self.normalised(&motion, LEAST_MOTION);
            for (attention, motion) in attention.values_mut().iter_mut().zip(motion.values()) {
                *attention = 0.5 * *attention + 0.5 * motion;
            }
        }
        self.previous = Some(current);
        let [least, more] = WEIGHTS;
        let cells = attention.map(|attention| least + more * attention);
        let mut plane = std::mem::take(&mut self.weights).into_plane();
        if plane.is_empty() {
            plane = Plane::filled(size[0], size[1], 0.0);
        }
        enlarged(&cells, self.factor * CELL, &mut plane);
        self.weights = Weights::new(plane)?;
        Ok(&self.weights)
    }

    /// Forgets the frame before, as at a cut: the next frame is one without motion.
    pub fn restart(&mut self) {
        self.previous = None;
    }

    /// N(G ∗ map).
    fn normalised(&self, map: &Plane, least: f32) -> Plane {
        normalised(self.smoothing.blur(map, Border::Reflect), least)
    }
}

/// The mean of |∇Y| in each cell, in levels a reduced pixel.
fn contours(picture: &Plane<u8>) -> Plane {
    let [dx, dy] = Gradient::Sobel.of(picture, Border::Mirror);
    // Sobel's weights sum up to eight times the slope. The squares are exact.
    let slope = |dx: i16, dy: i16| {
        let [dx, dy] = [f32::from(dx), f32::from(dy)];
        0.125 * (dx * dx + dy * dy).sqrt()
    };
    let [columns, rows] = cells(picture);
    let mut sums = Plane::filled(columns, rows, 0.0);
    for (row, (dx, dy)) in dx.rows().zip(dy.rows()).enumerate() {
        let chunks = dx.chunks(CELL).zip(dy.chunks(CELL));
        for (sum, (dx, dy)) in sums.row_mut(row / CELL).iter_mut().zip(chunks) {
            *sum += dx
                .iter()
                .zip(dy)
                .map(|(dx, dy)| slope(*dx, *dy))
                .sum::<f32>();
        }
    }
    let [width, height] = [picture.width(), picture.height()];
    Plane::from_fn(columns, rows, |column, row| {
        let inside = (width - CELL * column).min(CELL) * (height - CELL * row).min(CELL);
        sums.row(row)[column] / inside as f32
    })
}
