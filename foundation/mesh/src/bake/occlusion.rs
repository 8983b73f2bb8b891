//! Ambient occlusion.

use std::f64::consts::TAU;

use crate::TextureSpaceError;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;

/// How ambient occlusion is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OcclusionOptions {
    /// The number of rays for each texel, from 1; 32 by default.
    pub rays: u32,
    /// Chooses the directions; equal seeds give equal maps.
    pub seed: u64,
    /// Only what is nearer than this blocks a ray, in the unit of the coordinates; infinite by
    /// default.
    pub distance: f64,
}

impl Default for OcclusionOptions {
    fn default() -> Self {
        Self {
            rays: 32,
            seed: 0,
            distance: f64::INFINITY,
        }
    }
}

/// Directions of the hemisphere about e3 with the density of the cosine: the points of a
/// Hammersley set (i/N, radical inverse of i), mapped to the disc below (Malley's method).
pub(super) struct Hemisphere {
    directions: Vec<Vector<f64>>,
    seed: u64,
}

impl Hemisphere {
    pub(super) fn new(options: &OcclusionOptions) -> Result<Self, TextureSpaceError> {
        let OcclusionOptions {
            rays,
            seed,
            distance,
        } = *options;
        if rays == 0 || rays > 1 << 16 {
            let value = f64::from(rays);
            let what = "number of rays";
            return Err(TextureSpaceError::Number { what, value });
        }
        if distance <= 0.0 || distance.is_nan() {
            let what = "distance of occlusion";
            return Err(TextureSpaceError::Number {
                what,
                value: distance,
            });
        }
        let directions = (0..rays).map(|i| {
            let square = (f64::from(i) + 0.5) / f64::from(rays);
            let angle = TAU * f64::from(i.reverse_bits()) / (1_u64 << 32) as f64;
            let (sine, cosine) = angle.sin_cos();
            let radius = square.sqrt();
            Vector::new(radius * cosine, radius * sine, (1.0 - square).sqrt())
        });
        Ok(Self {
            directions: directions.collect(),
            seed,
        })
    }

    /// The part of the rays that leave a point without being blocked. The set of directions is
    /// rotated about the normal by an angle that depends on the texel.
    pub(super) fn openness(
        &self,
        texel: u32,
        point: Vector<f64>,
        normal: Vector<f64>,
        is_blocked: impl Fn(Ray<f64>) -> bool,
    ) -> f32 {
        let angle = TAU * fraction(self.seed ^ u64::from(texel) << 32);
        let (sine, cosine) = angle.sin_cos();
        let [x, y] = normal.orthonormal_pair();
        let (x, y) = (x * cosine + y * sine, y * cosine - x * sine);
        let mut open = 0;
        for direction in &self.directions {
            let direction = x * direction.e1 + y * direction.e2 + normal * direction.e3;
            let ray = Ray::new_unchecked(point.into(), direction.into());
            open += u32::from(!is_blocked(ray));
        }
        open as f32 / self.directions.len() as f32
    }
}

/// A number from 0 to 1 from the bits of another, by the mixing of SplitMix64.
fn fraction(number: u64) -> f64 {
    let mut z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}
