//! All unsafe code: the choice of instructions when the program runs, and types as plain memory.

#![allow(unsafe_code)]

/// Instructions for which the loops of this module are compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// Those of the target that the program is built for.
    Baseline,
    /// AVX2 with FMA registers, on x86-64 processors that have them. Needs the feature `std`, which
    /// can ask the processor.
    Avx2,
}

impl Path {
    /// Whether the processor has the instructions.
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            Self::Avx2 => has_avx2(),
        }
    }

    /// The fastest path that the processor has.
    #[must_use]
    pub fn best() -> Self {
        if has_avx2() {
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

/// A loop that can be compiled for several sets of instructions. `run` must be `#[inline(always)]`,
/// so that it becomes part of the function that asks for them.
pub(super) trait Work {
    fn run(self);
}

/// Runs a loop on a path.
#[inline]
pub(super) fn run(path: Path, work: impl Work) {
    match path {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        Path::Avx2 if has_avx2() => {
            // SAFETY: the function needs the processor to have AVX2 and FMA and nothing else, and
            // it was asked just now.
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

/// Plain memory by the traits of bytemuck. It is here because it takes unsafe code, and all of that
/// stays in one file; `interop::bytemuck` documents it and lists the types.
#[cfg(feature = "bytemuck-1")]
macro_rules! plain_memory {
    ($module:ident { $($name:ident $count:literal),* }) => { $(
        // SAFETY: what `algebra!` declares is `repr(C)` with one field of type S for each stored
        // coefficient, so that its size is a multiple of its alignment, which is that of S, and
        // there is no padding. The assertion shows that the fields are those and no others. Any
        // values of them are a valid value: facts are no matter of memory safety.
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
