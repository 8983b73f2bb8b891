//! Loops of any kind with the instructions of the processor.

use crate::instruction_set::InstructionSet;

/// A loop that can be compiled for several sets of instructions, for
/// [`Batch::run`](crate::batch::Batch::run).
pub trait Work {
    /// Whether registers of AVX-512 make it quicker than those of AVX2. Loops over bytes in blocks
    /// of 32 or more often are; those over records of an odd number of coefficients often are not,
    /// since the compiler reads and writes them by gathers and scatters.
    const WIDE: bool = false;

    /// The loop. It must be `#[inline(always)]`, as must be what it calls, so that it is compiled
    /// as part of the function that enables the instructions.
    fn run(self);
}

/// Runs a loop with a set of instructions, or with those of the target where the processor lacks
/// it.
#[inline]
pub(crate) fn run<W: Work>(set: InstructionSet, work: W) {
    match set {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx512 if W::WIDE && set.is_available() => {
            // SAFETY: the only requirement of the function is that the processor has the sets that
            // it names, which `is_available`, in `instruction_set.rs`, has just checked.
            unsafe { run_with_avx512(work) }
        }
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
#[target_feature(enable = "avx2,fma,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
fn run_with_avx512(work: impl Work) {
    work.run();
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma")]
fn run_with_avx2(work: impl Work) {
    work.run();
}
