//! Moving the chunks of a skin.

use super::bucket::{Bucket, TILE};
use super::palette::{AffinePalette, MotorPalette};
use super::posed::Posed;
use super::tile::{Asked, Tile, is_doubtful};
use super::{Chunk, SkinScalar, maps};
use crate::batch::error::same_length;
use crate::batch::{Batch, BatchError};
use crate::cga3::Point;
use crate::instruction_set::InstructionSet;
use crate::scalar::Real;
use crate::unsafe_code::{Work, run};
use crate::vga3::Vector;

/// How much of the blend of motors is in a mixture with the mean of affine maps: 0 is the mean, 1
/// the blend.
#[derive(Clone, Copy, Debug)]
pub enum Mix<'a, S> {
    /// The same share everywhere.
    Whole(S),
    /// The share of each point of the chunk.
    Each(&'a [S]),
}

impl Batch {
    /// Moves the points of a chunk by the means of the affine maps of their joints.
    ///
    /// # Errors
    /// The lengths differ, the palette belongs to another skin, or directions are asked for that
    /// the skin does not have. Then nothing is written.
    pub fn skin_by_affine_maps<S: SkinScalar>(
        self,
        chunk: &Chunk<S>,
        palette: &AffinePalette<S>,
        mut posed: Posed<'_, S>,
    ) -> Result<(), BatchError> {
        palette.fits(chunk)?;
        let asked = posed.check(chunk)?;
        let set = self.instruction_set;
        for bucket in &chunk.buckets {
            let is_done = !asked.tangents && S::by_affine_maps(set, bucket, palette, &mut posed);
            if !is_done {
                run(
                    set,
                    ByAffineMaps {
                        bucket,
                        palette,
                        asked,
                        posed: &mut posed,
                    },
                );
            }
        }
        Ok(())
    }

    /// Moves the points of a chunk by the blends of the motors of their joints.
    ///
    /// # Errors
    /// As [`skin_by_affine_maps`](Self::skin_by_affine_maps).
    pub fn skin_by_motors<S: SkinScalar>(
        self,
        chunk: &Chunk<S>,
        palette: &MotorPalette<S>,
        mut posed: Posed<'_, S>,
    ) -> Result<(), BatchError> {
        palette.fits(chunk)?;
        let asked = posed.check(chunk)?;
        let set = self.instruction_set;
        let is_plain = !asked.tangents && palette.stretches.is_empty();
        for bucket in &chunk.buckets {
            let is_done = is_plain && S::by_motors(set, bucket, palette, &mut posed);
            if !is_done || palette.has_doubtful {
                run(
                    set,
                    ByMotors {
                        set,
                        bucket,
                        palette,
                        asked,
                        only_doubtful: is_done,
                        posed: &mut posed,
                    },
                );
            }
        }
        Ok(())
    }

    /// Moves the points of a chunk to a place between their image by the mean of affine maps and
    /// that by the blend of motors.
    ///
    /// # Errors
    /// As [`skin_by_affine_maps`](Self::skin_by_affine_maps), and there is not one share for each
    /// point.
    pub fn skin_by_both<S: SkinScalar>(
        self,
        chunk: &Chunk<S>,
        maps: &AffinePalette<S>,
        motors: &MotorPalette<S>,
        mix: Mix<'_, S>,
        mut posed: Posed<'_, S>,
    ) -> Result<(), BatchError> {
        maps.fits(chunk)?;
        motors.fits(chunk)?;
        if let Mix::Each(shares) = mix {
            same_length(chunk.len, shares.len())?;
        }
        let asked = posed.check(chunk)?;
        let set = self.instruction_set;
        for bucket in &chunk.buckets {
            run(
                set,
                ByBoth {
                    set,
                    bucket,
                    maps,
                    motors,
                    mix,
                    asked,
                    posed: &mut posed,
                },
            );
        }
        Ok(())
    }
}

impl<S: SkinScalar> Posed<'_, S> {
    fn check(&self, chunk: &Chunk<S>) -> Result<Asked, BatchError> {
        same_length(chunk.len, self.points.len())?;
        let asked = Asked {
            normals: !self.normals.is_empty(),
            tangents: !self.tangents.is_empty(),
        };
        for (is_asked, length) in [
            (asked.normals, self.normals.len()),
            (asked.tangents, self.tangents.len()),
        ] {
            if is_asked {
                same_length(chunk.len, length)?;
            }
        }
        let lacks = |bucket: &Bucket<S>| {
            (asked.normals && bucket.normals.is_empty())
                || (asked.tangents && bucket.tangents.is_empty())
        };
        if chunk.buckets.iter().any(lacks) {
            return Err(BatchError::NoDirections);
        }
        Ok(asked)
    }

    /// Writes the images of a tile to the places of its points.
    #[inline(always)]
    fn write(&mut self, tile: &Tile<S>, order: &[u16], is_run: bool, asked: Asked) {
        let point = |[x, y, z]: [S; 3]| Point::new(x, y, z);
        scatter(&tile.points, order, is_run, self.points, point);
        if asked.normals {
            scatter(&tile.normals, order, is_run, self.normals, Vector::from);
        }
        if asked.tangents {
            scatter(&tile.tangents, order, is_run, self.tangents, Vector::from);
        }
    }
}

#[inline(always)]
fn scatter<S: Copy, X>(
    images: &[[S; TILE]; 3],
    order: &[u16],
    is_run: bool,
    places: &mut [X],
    new: impl Fn([S; 3]) -> X,
) {
    if is_run && order.len() == TILE {
        let first = usize::from(order[0]);
        if let Some(places) = places.get_mut(first..first + TILE) {
            for (i, place) in places.iter_mut().enumerate() {
                *place = new([images[0][i], images[1][i], images[2][i]]);
            }
        }
        return;
    }
    for (i, &place) in order.iter().enumerate().take(TILE) {
        if let Some(place) = places.get_mut(usize::from(place)) {
            *place = new([images[0][i], images[1][i], images[2][i]]);
        }
    }
}

struct ByAffineMaps<'a, 'b, S> {
    bucket: &'a Bucket<S>,
    palette: &'a AffinePalette<S>,
    asked: Asked,
    posed: &'a mut Posed<'b, S>,
}

impl<S: SkinScalar> Work for ByAffineMaps<'_, '_, S> {
    #[inline(always)]
    fn run(self) {
        let mut tile = Tile::new();
        for (number, order) in self.bucket.order.chunks(TILE).enumerate() {
            tile.by_affine_maps(self.bucket, number * TILE, self.palette, self.asked);
            self.posed
                .write(&tile, order, self.bucket.is_run, self.asked);
        }
    }
}

struct ByMotors<'a, 'b, S> {
    set: InstructionSet,
    bucket: &'a Bucket<S>,
    palette: &'a MotorPalette<S>,
    asked: Asked,
    /// Whether the other tiles are moved already.
    only_doubtful: bool,
    posed: &'a mut Posed<'b, S>,
}

impl<S: SkinScalar> Work for ByMotors<'_, '_, S> {
    #[inline(always)]
    fn run(self) {
        let mut tile = Tile::new();
        for (number, order) in self.bucket.order.chunks(TILE).enumerate() {
            let start = number * TILE;
            if self.only_doubtful && !is_doubtful(self.bucket, start, self.palette) {
                continue;
            }
            tile.by_motors(self.set, self.bucket, start, self.palette, self.asked);
            self.posed
                .write(&tile, order, self.bucket.is_run, self.asked);
        }
    }
}

struct ByBoth<'a, 'b, S> {
    set: InstructionSet,
    bucket: &'a Bucket<S>,
    maps: &'a AffinePalette<S>,
    motors: &'a MotorPalette<S>,
    mix: Mix<'a, S>,
    asked: Asked,
    posed: &'a mut Posed<'b, S>,
}

impl<S: SkinScalar> Work for ByBoth<'_, '_, S> {
    #[inline(always)]
    fn run(self) {
        let (mut mixed, mut other) = (Tile::new(), Tile::new());
        for (number, order) in self.bucket.order.chunks(TILE).enumerate() {
            let start = number * TILE;
            mixed.by_affine_maps(self.bucket, start, self.maps, self.asked);
            other.by_motors(self.set, self.bucket, start, self.motors, self.asked);
            let mut shares = [S::zero(); TILE];
            for (share, &place) in shares.iter_mut().zip(order) {
                *share = match self.mix {
                    Mix::Whole(share) => share,
                    Mix::Each(shares) => shares[usize::from(place)],
                };
            }
            mix(&mut mixed.points, &other.points, &shares, |mean| mean);
            if self.asked.normals {
                mix(&mut mixed.normals, &other.normals, &shares, maps::unit);
            }
            if self.asked.tangents {
                mix(&mut mixed.tangents, &other.tangents, &shares, maps::unit);
            }
            self.posed
                .write(&mixed, order, self.bucket.is_run, self.asked);
        }
    }
}

/// Moves each element towards another one by its share of the way.
#[inline(always)]
fn mix<S: Real>(
    from: &mut [[S; TILE]; 3],
    to: &[[S; TILE]; 3],
    shares: &[S; TILE],
    finished: impl Fn(Vector<S>) -> Vector<S>,
) {
    for i in 0..TILE {
        let at = |list: &[[S; TILE]; 3]| Vector::new(list[0][i], list[1][i], list[2][i]);
        let [x, y, z] = finished(at(from).lerp(at(to), shares[i])).coordinates();
        (from[0][i], from[1][i], from[2][i]) = (x, y, z);
    }
}
