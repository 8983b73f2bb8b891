//! Sets of instructions that a processor may have.

/// Instructions for which the loops of [`batch`](crate::batch) are compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// Those of the target that the program is built for.
    Baseline,
    /// AVX2 and FMA, on x86-64 processors that have them. It needs the feature `std`, which can
    /// detect them.
    Avx2,
    /// AVX-512 F, BW, CD, DQ and VL besides AVX2, on x86-64 processors that have them: those of
    /// x86-64-v4. Loops run with AVX2 where they are not [`WIDE`](crate::batch::Work::WIDE). It
    /// needs the feature `std`.
    Avx512,
}

impl InstructionSet {
    /// Whether the processor has the instructions.
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            Self::Avx2 => has_avx2(),
            Self::Avx512 => has_avx512(),
        }
    }

    /// The fastest set that the processor has.
    #[must_use]
    pub fn best() -> Self {
        if has_avx512() {
            Self::Avx512
        } else if has_avx2() {
            Self::Avx2
        } else {
            Self::Baseline
        }
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
fn has_avx2() -> bool {
    false
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
fn has_avx512() -> bool {
    has_avx2()
        && std::arch::is_x86_feature_detected!("avx512f")
        && std::arch::is_x86_feature_detected!("avx512bw")
        && std::arch::is_x86_feature_detected!("avx512cd")
        && std::arch::is_x86_feature_detected!("avx512dq")
        && std::arch::is_x86_feature_detected!("avx512vl")
}

#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
fn has_avx512() -> bool {
    false
}
