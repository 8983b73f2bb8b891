//! Points that each follow several motions: the skin of an animated body.
//!
//! A [`Skin`] is prepared once from the points at rest and their influences, and moved in any
//! number of frames; moving it allocates nothing. A frame is given as a palette, which has one
//! motion for each joint:
//!
//! - [`AffinePalette`]: a point x with weights wᵢ moves to `(Σ wᵢ Aᵢ) x`, by the mean of affine
//!   maps.
//! - [`MotorPalette`]: it moves to `B S x ~B` with `B = Σ ± wᵢ Mᵢ / |Σ ± wᵢ Mᵢ|` and
//!   `S = Σ wᵢ Sᵢ`, by the blend of motors after the mean of stretches at rest.
//!
//! The blend of motors is that of [`Motor::blend`](crate::cga3::Motor::blend). The signs of the
//! motors depend only on the pairs of joints that influence some point, so they are determined once
//! a frame.
//!
//! Normals are images of the planes tangent to the surface: the mean map acts on them by its
//! cofactors, so that they stay perpendicular to the moved surface. Tangents move as differences of
//! points. Both are returned with length 1, or zero where the map makes them vanish.
//!
//! The points lie in chunks of at most [`CHUNK`], which can be moved on different threads, and
//! within a chunk they are ordered by their number of influences, so that no time is lost on
//! influences that a point does not have.
//!
//! ```
//! use ga_runtime::batch::Batch;
//! use ga_runtime::batch::skin::{MotorPalette, Posed, Skin};
//! use ga_runtime::cga3::{Motor, Point, Translator};
//!
//! let rest = [Point::new(1.0, 0.0, 0.0), Point::new(2.0, 0.0, 0.0)];
//! let skin = Skin::new(2, &rest, [vec![(0, 1.0)], vec![(0, 0.5), (1, 0.5)]])?;
//! let mut palette = MotorPalette::new(&skin);
//! palette.set(&[0.0, 4.0].map(|y| Motor::from(Translator::from_displacement([0.0, y, 0.0]))))?;
//! let mut moved = rest;
//! for chunk in skin.chunks() {
//!     let posed = Posed::of_points(&mut moved[chunk.range()]);
//!     Batch::new().skin_by_motors(chunk, &palette, posed)?;
//! }
//! assert_eq!(moved[1].coordinates(), [2.0, 2.0, 0.0]);
//! # Ok::<(), ga_runtime::batch::BatchError>(())
//! ```

#[cfg(all(feature = "std", target_arch = "x86_64"))]
pub(crate) mod avx2;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
pub(crate) mod avx512;
mod bucket;
mod maps;
mod palette;
mod points;
mod pose;
mod posed;
mod scalar;
mod tile;

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

pub use palette::{AffinePalette, MotorPalette};
pub use points::{Chunk, Skin};
pub use pose::Mix;
pub use posed::Posed;
pub use scalar::SkinScalar;

use super::error::same_length;
use crate::batch::BatchError;
use crate::cga3::Point;
use crate::vga3::Vector;
pub(crate) use bucket::{Bucket, Motors};

/// The largest number of points in a chunk.
pub const CHUNK: usize = 4096;

impl<S: SkinScalar> Skin<S> {
    /// Prepares points for motions of a number of joints. The influences of a point are pairs of a
    /// joint and a weight. The weights of a point should sum to 1; an influence of weight zero is
    /// left out.
    ///
    /// # Errors
    /// The numbers of points and of lists of influences differ, a joint is outside of the palette,
    /// a weight is negative or not finite, a point has no weight above zero, there are more joints
    /// than 2¹⁶ or more pairs of joints than 2³² can count.
    pub fn new<R: IntoIterator<Item = (u32, S)>>(
        joints: usize,
        points: &[Point<S>],
        influences: impl IntoIterator<Item = R>,
    ) -> Result<Self, BatchError> {
        if joints > 1 << 16 {
            return Err(BatchError::TooLarge);
        }
        let mut skin = Self {
            joints,
            points: points.len(),
            has_normals: false,
            has_tangents: false,
            chunks: Vec::with_capacity(points.len().div_ceil(CHUNK)),
            pairs: Vec::new(),
        };
        let mut numbers = BTreeMap::new();
        let mut rows = influences.into_iter();
        let mut row = Vec::new();
        for (index, chunk) in points.chunks(CHUNK).enumerate() {
            let first = index * CHUNK;
            let mut buckets: BTreeMap<usize, Bucket<S>> = BTreeMap::new();
            for (place, point) in chunk.iter().enumerate() {
                let found = first + place;
                let influences = rows.next().ok_or_else(|| skin.mismatch(found))?;
                row.clear();
                row.extend(influences);
                skin.check(found, &mut row)?;
                let bucket = buckets
                    .entry(row.len())
                    .or_insert_with(|| Bucket::new(row.len()));
                bucket.push(place as u16, *point, &row, |pair| {
                    *numbers.entry(pair).or_insert_with(|| {
                        skin.pairs.push(pair);
                        (joints + skin.pairs.len() - 1) as u32
                    })
                });
                if u32::try_from(joints + skin.pairs.len()).is_err() {
                    return Err(BatchError::TooLarge);
                }
            }
            let buckets = buckets.into_values().map(Bucket::padded).collect();
            skin.chunks.push(Chunk {
                first,
                len: chunk.len(),
                joints,
                pairs: 0,
                buckets,
            });
        }
        let left = rows.count();
        if left > 0 {
            return Err(skin.mismatch(points.len() + left));
        }
        let pairs = skin.pairs.len();
        for chunk in &mut skin.chunks {
            chunk.pairs = pairs;
        }
        Ok(skin)
    }

    /// Takes other places of the points at rest, with the influences as they are.
    ///
    /// # Errors
    /// There is another number of them.
    pub fn set_points(&mut self, points: &[Point<S>]) -> Result<(), BatchError> {
        same_length(self.points, points.len())?;
        for chunk in &mut self.chunks {
            let points = &points[chunk.first..chunk.first + chunk.len];
            for bucket in &mut chunk.buckets {
                for (place, &index) in bucket.points.iter_mut().zip(&bucket.order) {
                    let [x, y, z] = points[usize::from(index)].coordinates();
                    *place = [x, y, z, S::one()];
                }
            }
        }
        Ok(())
    }

    /// Adds the normals of the points at rest, of any length.
    ///
    /// # Errors
    /// There is another number of them.
    pub fn with_normals(mut self, normals: &[Vector<S>]) -> Result<Self, BatchError> {
        same_length(self.points, normals.len())?;
        self.has_normals = true;
        for chunk in &mut self.chunks {
            let normals = &normals[chunk.first..chunk.first + chunk.len];
            for bucket in &mut chunk.buckets {
                bucket.normals = bucket.gathered(normals);
            }
        }
        Ok(self)
    }

    /// Adds the tangents of the points at rest, of any length.
    ///
    /// # Errors
    /// There is another number of them.
    pub fn with_tangents(mut self, tangents: &[Vector<S>]) -> Result<Self, BatchError> {
        same_length(self.points, tangents.len())?;
        self.has_tangents = true;
        for chunk in &mut self.chunks {
            let tangents = &tangents[chunk.first..chunk.first + chunk.len];
            for bucket in &mut chunk.buckets {
                bucket.tangents = bucket.gathered(tangents);
            }
        }
        Ok(self)
    }

    /// Sorts the influences from the heaviest down, equals in their order, and checks them.
    fn check(&self, element: usize, row: &mut Vec<(u32, S)>) -> Result<(), BatchError> {
        let is_weight = |weight: S| weight.is_finite() && !weight.less_than(S::zero());
        if !row.iter().all(|&(_, weight)| is_weight(weight)) {
            return Err(BatchError::NotAWeight { element });
        }
        row.retain(|&(_, weight)| S::zero().less_than(weight));
        if let Some(&(place, _)) = row.iter().find(|(place, _)| *place as usize >= self.joints) {
            return Err(BatchError::JointNotInPalette {
                element,
                place: place as usize,
                palette: self.joints,
            });
        }
        if row.is_empty() {
            return Err(BatchError::NoInfluence { element });
        }
        row.sort_by(|(_, a), (_, b)| b.partial_cmp(a).unwrap_or(core::cmp::Ordering::Equal));
        Ok(())
    }

    fn mismatch(&self, found: usize) -> BatchError {
        super::LengthMismatch {
            expected: self.points,
            found,
        }
        .into()
    }
}
