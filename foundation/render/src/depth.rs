//! The depth of the mesh at each pixel.

use ga_image::plane::Plane;

/// The depth (distance along the viewing direction) of the nearest surface of the mesh at each
/// pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthMap {
    width: u32,
    height: u32,
    /// Infinite where there is no surface.
    depth: Plane,
    /// The share of each pixel that shows a surface.
    coverage: Plane,
}

/// The brightness of the far end of the range; pixels without a surface are darker.
const FAR_BRIGHTNESS: f64 = 0.2;

impl DepthMap {
    pub(crate) fn empty(width: u32, height: u32) -> Self {
        let filled = |value| Plane::filled(width as usize, height as usize, value);
        Self {
            width,
            height,
            depth: filled(f32::INFINITY),
            coverage: filled(0.0),
        }
    }

    pub(crate) fn set(&mut self, index: usize, depth: f32, coverage: f32) {
        self.depth.values_mut()[index] = depth;
        self.coverage.values_mut()[index] = coverage;
    }

    /// The depth at each pixel, infinite where there is no surface.
    pub fn depths(&self) -> &Plane {
        &self.depth
    }

    /// The share of each pixel, 0 to 1, that shows a surface.
    pub fn coverages(&self) -> &Plane {
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

    /// The depth at a pixel, in the unit of the model; `None` where there is no surface and outside
    /// the picture.
    pub fn get(&self, column: u32, row: u32) -> Option<f64> {
        let depth = self.depth.get(column as usize, row as usize)?;
        depth.is_finite().then_some(f64::from(depth))
    }

    /// The share of a pixel, 0 to 1, that shows the mesh; 0 outside the picture.
    pub fn coverage(&self, column: u32, row: u32) -> f64 {
        let coverage = self.coverage.get(column as usize, row as usize);
        f64::from(coverage.unwrap_or(0.0))
    }

    /// The least and the greatest depth of any surface; `None` where there is no surface at all.
    pub fn range(&self) -> Option<(f64, f64)> {
        let surfaces = self
            .depth
            .values()
            .iter()
            .copied()
            .filter(|d| d.is_finite());
        let (near, far) = surfaces.fold((f32::INFINITY, 0f32), |(near, far), d| {
            (near.min(d), far.max(d))
        });
        near.is_finite()
            .then_some((f64::from(near), f64::from(far)))
    }

    /// A picture of the depths: white up to `near`, darker linearly to dark grey at `far` and
    /// beyond, black where there is no surface.
    ///
    /// Pictures with the same range can be compared; [`range`](Self::range) is the range of this
    /// picture alone.
    pub fn to_plane(&self, near: f64, far: f64) -> Plane<u8> {
        Plane::from_fn(self.width as usize, self.height as usize, |column, row| {
            let [column, row] = [column as u32, row as u32];
            let brightness = self.get(column, row).map_or(0.0, |depth| {
                let towards_far =
                    ((depth - near) / (far - near).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
                self.coverage(column, row) * (1.0 - (1.0 - FAR_BRIGHTNESS) * towards_far)
            });
            (255.0 * brightness).round() as u8
        })
    }
}
