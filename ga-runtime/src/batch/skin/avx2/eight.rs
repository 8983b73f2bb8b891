//! Eight points in registers, a register for each coordinate.

use core::arch::x86_64::*;

use crate::unsafe_code::registers::numbers8;

/// e1, e2 and e3 of eight points or directions.
#[inline]
#[target_feature(enable = "avx2,fma")]
pub(super) fn coordinates(x: &[[f32; 4]; 8]) -> [__m256; 3] {
    let two = |i: usize| {
        let ([a, b, c, d], [e, f, g, h]) = (x[i], x[i + 4]);
        _mm256_setr_ps(a, b, c, d, e, f, g, h)
    };
    let (a, b, c, d) = (two(0), two(1), two(2), two(3));
    let (low, other) = (_mm256_unpacklo_ps(a, b), _mm256_unpacklo_ps(c, d));
    let (high, last) = (_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d));
    [
        _mm256_shuffle_ps::<0x44>(low, other),
        _mm256_shuffle_ps::<0xee>(low, other),
        _mm256_shuffle_ps::<0x44>(high, last),
    ]
}

/// Writes eight points or directions to their places, which are given in rising order. There may be
/// fewer places.
#[inline]
#[target_feature(enable = "avx2,fma")]
pub(in crate::batch::skin) fn write<X>(
    [x, y, z]: [__m256; 3],
    order: &[u16],
    places: &mut [X],
    new: impl Fn(f32, f32, f32) -> X,
) {
    // In the halves of each register the coordinates of four points, one after the other.
    let xy = _mm256_shuffle_ps::<0b10_00_10_00>(x, y);
    let yz = _mm256_shuffle_ps::<0b11_01_11_01>(y, z);
    let zx = _mm256_shuffle_ps::<0b11_01_10_00>(z, x);
    let first = _mm256_shuffle_ps::<0b10_00_10_00>(xy, zx);
    let second = _mm256_shuffle_ps::<0b11_01_10_00>(yz, xy);
    let third = _mm256_shuffle_ps::<0b11_01_11_01>(zx, yz);
    let packed = [
        _mm256_permute2f128_ps::<0x20>(first, second),
        _mm256_permute2f128_ps::<0x30>(third, first),
        _mm256_permute2f128_ps::<0x31>(second, third),
    ];
    if let &[first, _, _, _, _, _, _, last] = order
        && last - first == 7
    {
        let numbers = [
            numbers8(packed[0]),
            numbers8(packed[1]),
            numbers8(packed[2]),
        ];
        let first = usize::from(first);
        if let Some(places) = places.get_mut(first..first + 8) {
            let numbers = numbers.as_flattened().as_chunks::<3>().0;
            for (place, &[x, y, z]) in places.iter_mut().zip(numbers) {
                *place = new(x, y, z);
            }
        }
        return;
    }
    scatter(packed, order, places, new);
}

/// Writes points to places that are not consecutive. Not inlined: the numbers that are read one by
/// one here would otherwise lie in memory above too.
#[inline(never)]
#[target_feature(enable = "avx2,fma")]
fn scatter<X>(
    packed: [__m256; 3],
    order: &[u16],
    places: &mut [X],
    new: impl Fn(f32, f32, f32) -> X,
) {
    let numbers = [
        numbers8(packed[0]),
        numbers8(packed[1]),
        numbers8(packed[2]),
    ];
    let numbers = numbers.as_flattened().as_chunks::<3>().0;
    for (&place, &[x, y, z]) in order.iter().zip(numbers) {
        if let Some(place) = places.get_mut(usize::from(place)) {
            *place = new(x, y, z);
        }
    }
}

/// Eight rows of eight numbers, column by column.
#[inline]
#[target_feature(enable = "avx2,fma")]
pub(super) fn transposed(r: [__m256; 8]) -> [__m256; 8] {
    let low = |a, b| _mm256_unpacklo_ps(a, b);
    let high = |a, b| _mm256_unpackhi_ps(a, b);
    let [a0, a1, a2, a3] = [
        low(r[0], r[1]),
        high(r[0], r[1]),
        low(r[2], r[3]),
        high(r[2], r[3]),
    ];
    let [a4, a5, a6, a7] = [
        low(r[4], r[5]),
        high(r[4], r[5]),
        low(r[6], r[7]),
        high(r[6], r[7]),
    ];
    let first = |a, b| _mm256_shuffle_ps::<0x44>(a, b);
    let second = |a, b| _mm256_shuffle_ps::<0xee>(a, b);
    let [b0, b1, b2, b3] = [first(a0, a2), second(a0, a2), first(a1, a3), second(a1, a3)];
    let [b4, b5, b6, b7] = [first(a4, a6), second(a4, a6), first(a5, a7), second(a5, a7)];
    let lower = |a, b| _mm256_permute2f128_ps::<0x20>(a, b);
    let upper = |a, b| _mm256_permute2f128_ps::<0x31>(a, b);
    [
        lower(b0, b4),
        lower(b1, b5),
        lower(b2, b6),
        lower(b3, b7),
        upper(b0, b4),
        upper(b1, b5),
        upper(b2, b6),
        upper(b3, b7),
    ]
}
