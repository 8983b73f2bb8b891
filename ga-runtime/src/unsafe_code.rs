//! All unsafe code of the workspace, in one file, so that it can be reviewed as a whole. There are
//! three kinds:
//!
//! - A loop compiled for AVX2 or AVX-512 is called after a check that the processor has these
//!   instructions. A call on another processor would be undefined behaviour; the functions of this
//!   file are the only callers. The product of two motors is compiled for SSE, on targets that have
//!   it.
//! - The contents of a vector register are read as an array of as many numbers.
//! - bytemuck's traits `Zeroable` and `Pod` are implemented for the declared types. They state that
//!   a type has no padding and that any bits are a valid value; the layout is checked by assertions
//!   when the crate is compiled.

#![allow(unsafe_code)]

use crate::batch::skin::{AffinePalette, Bucket, MotorPalette, Motors, Posed};
#[cfg(all(feature = "std", target_arch = "x86_64"))]
use crate::batch::skin::{avx2, avx512};
#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
use crate::cga3::Motor;
#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
use crate::geometry::composition::registers;
use crate::instruction_set::InstructionSet;

/// A loop that can be compiled for several sets of instructions, for
/// [`Batch::run`](crate::batch::Batch::run).
pub trait Work {
    /// The loop. It must be `#[inline(always)]`, as must be what it calls, so that it is compiled
    /// as part of the function that enables the instructions.
    fn run(self);
}

/// Runs a loop with a set of instructions, or with those of the target where the processor lacks
/// it.
#[inline]
pub(crate) fn run(set: InstructionSet, work: impl Work) {
    match set {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx2 | InstructionSet::Avx512 if set.is_available() => {
            // SAFETY: the only requirement of the function is that the processor has AVX2 and FMA,
            // which `is_available`, in `instruction_set.rs`, has just checked.
            unsafe { run_with_avx2(work) }
        }
        _ => work.run(),
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma")]
fn run_with_avx2(work: impl Work) {
    work.run();
}

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

/// The numbers in a register, from the lowest.
#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
#[inline(always)]
pub(crate) fn numbers4(register: core::arch::x86_64::__m128) -> [f32; 4] {
    // SAFETY: both have 16 bytes, and all bits are valid numbers.
    unsafe { core::mem::transmute(register) }
}

/// The numbers in a register, from the lowest.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline(always)]
pub(crate) fn numbers8(register: core::arch::x86_64::__m256) -> [f32; 8] {
    // SAFETY: both have 32 bytes, and all bits are valid numbers.
    unsafe { core::mem::transmute(register) }
}

/// The numbers in a register, from the lowest.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline(always)]
pub(crate) fn numbers16(register: core::arch::x86_64::__m512) -> [f32; 16] {
    // SAFETY: both have 64 bytes, and all bits are valid numbers.
    unsafe { core::mem::transmute(register) }
}

/// Marks the declared types as plain memory by the traits of bytemuck. `interop::bytemuck`
/// documents this and lists the types.
#[cfg(feature = "bytemuck-1")]
macro_rules! plain_memory {
    ($module:ident { $($name:ident $count:literal),* }) => { $(
        // SAFETY: what `algebra!` declares is `repr(C)` with one field of type S for each stored
        // coefficient, so that its size is a multiple of its alignment, which is that of S, and
        // there is no padding. The assertions check the count of the fields. All values of the
        // fields are valid: if a fact is violated, results are wrong, but behaviour is not
        // undefined.
        unsafe impl<S: bytemuck_1::Zeroable> bytemuck_1::Zeroable for crate::$module::$name<S> {}
        // SAFETY: the same.
        unsafe impl<S: bytemuck_1::Pod> bytemuck_1::Pod for crate::$module::$name<S> {}
        const _: () = {
            assert!(size_of::<crate::$module::$name<u8>>() == $count);
            assert!(align_of::<crate::$module::$name<u8>>() == align_of::<u8>());
            assert!(size_of::<crate::$module::$name<f32>>() == $count * size_of::<f32>());
            assert!(align_of::<crate::$module::$name<f32>>() == align_of::<f32>());
            assert!(size_of::<crate::$module::$name<f64>>() == $count * size_of::<f64>());
            assert!(align_of::<crate::$module::$name<f64>>() == align_of::<f64>());
        };
    )* };
}

#[cfg(feature = "bytemuck-1")]
crate::interop::bytemuck::declared_types!(plain_memory);
