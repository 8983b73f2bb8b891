//! Calls of loops that are written with the instructions of the processor.

use crate::batch::skin::{AffinePalette, Bucket, MotorPalette, Motors, Posed};
#[cfg(all(feature = "std", target_arch = "x86_64"))]
use crate::batch::skin::{avx2, avx512};
#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
use crate::cga3::Motor;
#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
use crate::geometry::composition::registers;
use crate::instruction_set::InstructionSet;

/// Moves the points and normals of a bucket by the means of affine maps, if there is a form of the
/// loop for these instructions.
#[inline]
pub(crate) fn skin_by_affine_maps(
    set: InstructionSet,
    bucket: &Bucket<f32>,
    palette: &AffinePalette<f32>,
    posed: &mut Posed<'_, f32>,
) -> bool {
    match set {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx512 if set.is_available() => {
            // SAFETY: the only requirement is that the processor has AVX-512 F, VL and DQ, AVX2 and
            // FMA, which `is_available` has just checked.
            unsafe { avx512::by_affine_maps(bucket, palette, posed) }
            true
        }
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx2 if set.is_available() => {
            // SAFETY: the only requirement is that the processor has AVX2 and FMA, which
            // `is_available` has just checked.
            unsafe { avx2::by_affine_maps(bucket, palette, posed) }
            true
        }
        _ => {
            let _ = (bucket, palette, posed);
            false
        }
    }
}

/// Moves the points and normals of a bucket by the blends of motors, where nothing stretches, if
/// there is a form of the loop for these instructions. Points with influences that are half a turn
/// apart are not right yet.
#[inline]
pub(crate) fn skin_by_motors(
    set: InstructionSet,
    bucket: &Bucket<f32>,
    palette: &MotorPalette<f32>,
    posed: &mut Posed<'_, f32>,
) -> bool {
    match set {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx2 | InstructionSet::Avx512 if set.is_available() => {
            // SAFETY: the only requirement is that the processor has AVX2 and FMA, which
            // `is_available` has just checked.
            unsafe { avx2::by_motors(bucket, palette, posed) }
            true
        }
        _ => {
            let _ = (bucket, palette, posed);
            false
        }
    }
}

/// The weighted sums of motors for the points of a tile, if there is a form of the loop for these
/// instructions.
#[inline]
pub(crate) fn sum_motors(
    set: InstructionSet,
    bucket: &Bucket<f32>,
    start: usize,
    palette: &MotorPalette<f32>,
    sums: &mut Motors<f32>,
) -> bool {
    match set {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx2 | InstructionSet::Avx512 if set.is_available() => {
            // SAFETY: the only requirement is that the processor has AVX2 and FMA, which
            // `is_available` has just checked.
            unsafe { avx2::sum_motors(bucket, start, palette, sums) }
            true
        }
        _ => {
            let _ = (bucket, start, palette, sums);
            false
        }
    }
}

/// The product of two motors in registers of four coefficients.
#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
#[inline(always)]
pub(crate) fn compose_in_registers(left: Motor<f32>, right: Motor<f32>) -> Motor<f32> {
    // SAFETY: the only requirement is SSE, which the target has: the condition on this function.
    unsafe { registers::compose(left, right) }
}
