//! The numbers that skins can have, with the loops that are written for each.

use super::bucket::{Bucket, Motors};
use super::palette::{AffinePalette, MotorPalette};
use super::posed::Posed;
use crate::instruction_set::InstructionSet;
use crate::scalar::Real;
use crate::unsafe_code::instructions;

/// A number that a skin can have: `f32` or `f64`.
pub trait SkinScalar:
    Real<Mask = bool> + Default + PartialOrd + Into<f64> + Send + Sync + sealed::Loops
{
}

impl SkinScalar for f32 {}
impl SkinScalar for f64 {}

pub(super) mod sealed {
    use super::{AffinePalette, Bucket, InstructionSet, MotorPalette, Motors, Posed};

    /// The loops that have a form of their own for some instructions.
    pub trait Loops: Sized {
        /// Moves the points and normals of a bucket by the means of affine maps, if there is a form
        /// for these instructions.
        fn by_affine_maps(
            set: InstructionSet,
            bucket: &Bucket<Self>,
            palette: &AffinePalette<Self>,
            posed: &mut Posed<'_, Self>,
        ) -> bool;

        /// Moves the points and normals of a bucket by the blends of motors, where nothing
        /// stretches, if there is a form for these instructions. Points with influences that are
        /// half a turn apart are not right yet.
        fn by_motors(
            set: InstructionSet,
            bucket: &Bucket<Self>,
            palette: &MotorPalette<Self>,
            posed: &mut Posed<'_, Self>,
        ) -> bool;

        /// The weighted sums of motors for the points of a tile that begins at `start`, if there is
        /// a form for these instructions.
        fn sum_motors(
            set: InstructionSet,
            bucket: &Bucket<Self>,
            start: usize,
            palette: &MotorPalette<Self>,
            sums: &mut Motors<Self>,
        ) -> bool;
    }
}

impl sealed::Loops for f32 {
    #[inline]
    fn by_affine_maps(
        set: InstructionSet,
        bucket: &Bucket<f32>,
        palette: &AffinePalette<f32>,
        posed: &mut Posed<'_, f32>,
    ) -> bool {
        instructions::skin_by_affine_maps(set, bucket, palette, posed)
    }

    #[inline]
    fn by_motors(
        set: InstructionSet,
        bucket: &Bucket<f32>,
        palette: &MotorPalette<f32>,
        posed: &mut Posed<'_, f32>,
    ) -> bool {
        instructions::skin_by_motors(set, bucket, palette, posed)
    }

    #[inline]
    fn sum_motors(
        set: InstructionSet,
        bucket: &Bucket<f32>,
        start: usize,
        palette: &MotorPalette<f32>,
        sums: &mut Motors<f32>,
    ) -> bool {
        instructions::sum_motors(set, bucket, start, palette, sums)
    }
}

impl sealed::Loops for f64 {
    #[inline(always)]
    fn by_affine_maps(
        _: InstructionSet,
        _: &Bucket<f64>,
        _: &AffinePalette<f64>,
        _: &mut Posed<'_, f64>,
    ) -> bool {
        false
    }

    #[inline(always)]
    fn by_motors(
        _: InstructionSet,
        _: &Bucket<f64>,
        _: &MotorPalette<f64>,
        _: &mut Posed<'_, f64>,
    ) -> bool {
        false
    }

    #[inline(always)]
    fn sum_motors(
        _: InstructionSet,
        _: &Bucket<f64>,
        _: usize,
        _: &MotorPalette<f64>,
        _: &mut Motors<f64>,
    ) -> bool {
        false
    }
}
