//! The product of two motors in registers of four coefficients.

use core::arch::x86_64::*;

use crate::cga3::Motor;
use crate::unsafe_code::registers::numbers4;

/// The product in registers of four coefficients.
///
/// With a motor as `A + A′ ω`, in which A and A′ are rotors times numbers and ω = e123i
/// commutes with them, the product is `A B + (A B′ + A′ B) ω`. Each of the three products of
/// rotors is a sum over the coefficients of its left factor, times the right factor with its
/// coefficients in another order and with other signs: a row of the multiplication table.
#[inline]
#[target_feature(enable = "sse")]
pub(crate) fn compose(left: Motor<f32>, right: Motor<f32>) -> Motor<f32> {
    let rotation = [left.scalar(), left.e12(), left.e13(), left.e23()];
    let moment = [left.e1i(), left.e2i(), left.e3i(), left.e123i()];
    let rotation_rows = rows(
        _mm_setr_ps(right.scalar(), right.e12(), right.e13(), right.e23()),
        [[1, 0, 0, 1], [1, 1, 0, 0], [1, 0, 1, 0]],
    );
    let moment_rows = rows(
        _mm_setr_ps(right.e1i(), right.e2i(), right.e3i(), right.e123i()),
        [[0, 1, 1, 0], [0, 0, 1, 1], [1, 0, 1, 0]],
    );
    let [s, e12, e13, e23] = numbers4(sum(rotation, rotation_rows));
    let [e1i, e2i, e3i, e123i] = numbers4(_mm_add_ps(
        sum(rotation, moment_rows),
        sum(moment, rotation_rows),
    ));
    Motor::new_unchecked(s, e12, e13, e23, e1i, e2i, e3i, e123i)
}

/// The coefficients as they are, with the first two and the last two exchanged, with the first
/// and the last two exchanged, and in reverse order; negative where there is a 1.
#[inline]
#[target_feature(enable = "sse")]
fn rows(c: __m128, negative: [[u32; 4]; 3]) -> [__m128; 4] {
    let [first, second, third] = negative.map(|[c0, c1, c2, c3]| {
        let sign = |is_negative: u32| f32::from_bits(is_negative << 31);
        _mm_setr_ps(sign(c0), sign(c1), sign(c2), sign(c3))
    });
    [
        c,
        _mm_xor_ps(_mm_shuffle_ps::<0b10_11_00_01>(c, c), first),
        _mm_xor_ps(_mm_shuffle_ps::<0b01_00_11_10>(c, c), second),
        _mm_xor_ps(_mm_shuffle_ps::<0b00_01_10_11>(c, c), third),
    ]
}

#[inline]
#[target_feature(enable = "sse")]
fn sum([f0, f1, f2, f3]: [f32; 4], [r0, r1, r2, r3]: [__m128; 4]) -> __m128 {
    _mm_add_ps(
        _mm_add_ps(
            _mm_mul_ps(_mm_set1_ps(f0), r0),
            _mm_mul_ps(_mm_set1_ps(f1), r1),
        ),
        _mm_add_ps(
            _mm_mul_ps(_mm_set1_ps(f2), r2),
            _mm_mul_ps(_mm_set1_ps(f3), r3),
        ),
    )
}
