//! The columns of a matrix in two registers.

use core::arch::x86_64::*;

use crate::batch::skin::palette::Columns;

/// The first two columns, and the last two.
#[inline]
#[target_feature(enable = "avx2,fma")]
pub(super) fn halves(columns: &Columns<f32>) -> [__m256; 2] {
    let m = &columns.0;
    [
        _mm256_setr_ps(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7]),
        _mm256_setr_ps(m[8], m[9], m[10], m[11], m[12], m[13], m[14], m[15]),
    ]
}
