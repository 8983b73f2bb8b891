//! The depth of the mesh at each pixel.

use image::{GrayImage, Luma};

/// The depth (distance along the viewing direction) of the nearest surface of the mesh at each
/// pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthMap {
    width: u32,
    height: u32,
    /// Infinite where there is no surface.
    depth: Vec<f32>,
    /// The share of each pixel that shows a surface.
    coverage: Vec<f32>,
}

/// The brightness of the far end of the range: above that of no surface at all.
const FAR_BRIGHTNESS: f64 = 0.2;

impl DepthMap {
    pub(super) fn empty(width: u32, height: u32) -> Self {
        let pixels = width as usize * height as usize;
        Self {
            width,
            height,
            depth: vec![f32::INFINITY; pixels],
            coverage: vec![0.0; pixels],
        }
    }

    pub(super) fn set(&mut self, index: usize, depth: f32, coverage: f32) {
        self.depth[index] = depth;
        self.coverage[index] = coverage;
    }

    /// Row by row; infinite where there is no surface.
    pub(super) fn depths(&self) -> &[f32] {
        &self.depth
    }

    /// Row by row.
    pub(super) fn coverages(&self) -> &[f32] {
        &self.coverage
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The depth at a pixel, in the unit of the model; `None` where there is no surface or no such
    /// pixel.
    pub fn get(&self, column: u32, row: u32) -> Option<f64> {
        let inside = column < self.width && row < self.height;
        let depth = inside.then(|| self.depth[(row * self.width + column) as usize])?;
        depth.is_finite().then_some(f64::from(depth))
    }

    /// The share of a pixel, 0 to 1, that shows the mesh; 0 where there is no such pixel.
    pub fn coverage(&self, column: u32, row: u32) -> f64 {
        if column < self.width && row < self.height {
            f64::from(self.coverage[(row * self.width + column) as usize])
        } else {
            0.0
        }
    }

    /// The least and the greatest depth of any surface; `None` where there is no surface at all.
    pub fn range(&self) -> Option<(f64, f64)> {
        let surfaces = self.depth.iter().copied().filter(|d| d.is_finite());
        let (near, far) = surfaces.fold((f32::INFINITY, 0f32), |(near, far), d| {
            (near.min(d), far.max(d))
        });
        near.is_finite()
            .then_some((f64::from(near), f64::from(far)))
    }

    /// A picture of the depths: white at `near` and before, falling linearly to dark grey at `far`
    /// and beyond, black where there is no surface.
    ///
    /// Pictures made with one range can be compared; [`range`](Self::range) gives this picture's
    /// own.
    pub fn to_image(&self, near: f64, far: f64) -> GrayImage {
        GrayImage::from_fn(self.width, self.height, |column, row| {
            let brightness = self.get(column, row).map_or(0.0, |depth| {
                let towards_far =
                    ((depth - near) / (far - near).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
                self.coverage(column, row) * (1.0 - (1.0 - FAR_BRIGHTNESS) * towards_far)
            });
            Luma([(255.0 * brightness).round() as u8])
        })
    }
}
