//! The contents of vector registers as numbers.

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
