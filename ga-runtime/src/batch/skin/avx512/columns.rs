//! The four columns of a matrix in one register, and weighted sums of them.

use core::arch::x86_64::*;

/// The weighted sum of the matrices of the point at a place in lists of influences. A macro, since
/// the compiler does not inline a function here, and a register that crosses a call goes through
/// memory.
macro_rules! sum {
    ($maps:expr, $joints:expr, $weights:expr, $place:expr, $count:expr) => {{
        let joints = &$joints[$place * $count..][..$count];
        let weights = &$weights[$place * $count..][..$count];
        let first = register(&$maps[usize::from(joints[0])].0);
        let mut total = _mm512_mul_ps(first, _mm512_set1_ps(weights[0]));
        for k in 1..$count {
            let map = register(&$maps[usize::from(joints[k])].0);
            total = _mm512_fmadd_ps(map, _mm512_set1_ps(weights[k]), total);
        }
        total
    }};
}
pub(super) use sum;

#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
pub(super) fn register(m: &[f32; 16]) -> __m512 {
    _mm512_setr_ps(
        m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11], m[12], m[13],
        m[14], m[15],
    )
}
