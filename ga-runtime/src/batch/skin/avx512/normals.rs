//! Points with normals, sixteen at a time, coordinate by coordinate.

use core::arch::x86_64::*;

use super::columns::{register, sum};
use crate::batch::skin::avx2::eight;
use crate::batch::skin::bucket::Bucket;
use crate::batch::skin::palette::Columns;
use crate::batch::skin::posed::Posed;
use crate::cga3::Point;
use crate::vga3::Vector;

/// Moves the points and normals of a bucket with `K` influences of each point; 0 is any number.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
pub(super) fn move_all<const K: usize>(
    bucket: &Bucket<f32>,
    maps: &[Columns<f32>],
    posed: &mut Posed<'_, f32>,
) {
    let count = if K == 0 { bucket.influences } else { K };
    let joints = bucket.joints.chunks_exact(16 * count);
    let weights = bucket.weights.chunks_exact(16 * count);
    let points = bucket.points.as_flattened().as_chunks::<64>().0;
    let normals = bucket.normals.as_flattened().as_chunks::<64>().0;
    let (images, turned) = (&mut *posed.points, &mut *posed.normals);
    for ((((order, x), n), joints), weights) in bucket
        .order
        .chunks(16)
        .zip(points)
        .zip(normals)
        .zip(joints)
        .zip(weights)
    {
        let mut rows = [_mm512_setzero_ps(); 16];
        for (v, row) in rows.iter_mut().enumerate() {
            *row = sum!(maps, joints, weights, v, count);
        }
        let columns = transposed(rows);
        write(image(columns, coordinates(x)), order, images, Point::new);
        write(normal(columns, coordinates(n)), order, turned, Vector::new);
    }
}

/// The coordinates of the four columns, each of sixteen points in a register.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn transposed(rows: [__m512; 16]) -> [[__m512; 3]; 4] {
    // For each coordinate and each four points: a quarter for each column.
    let mut fours = [[_mm512_setzero_ps(); 4]; 3];
    for i in 0..4 {
        let (a, b, c, d) = (
            rows[4 * i],
            rows[4 * i + 1],
            rows[4 * i + 2],
            rows[4 * i + 3],
        );
        let (low, other) = (_mm512_unpacklo_ps(a, b), _mm512_unpacklo_ps(c, d));
        let (high, last) = (_mm512_unpackhi_ps(a, b), _mm512_unpackhi_ps(c, d));
        fours[0][i] = _mm512_shuffle_ps::<0x44>(low, other);
        fours[1][i] = _mm512_shuffle_ps::<0xee>(low, other);
        fours[2][i] = _mm512_shuffle_ps::<0x44>(high, last);
    }
    let mut columns = [[_mm512_setzero_ps(); 3]; 4];
    for i in 0..3 {
        let [a, b, c, d] = fours[i];
        let (even, other) = (
            _mm512_shuffle_f32x4::<0x88>(a, b),
            _mm512_shuffle_f32x4::<0x88>(c, d),
        );
        let (odd, last) = (
            _mm512_shuffle_f32x4::<0xdd>(a, b),
            _mm512_shuffle_f32x4::<0xdd>(c, d),
        );
        columns[0][i] = _mm512_shuffle_f32x4::<0x88>(even, other);
        columns[1][i] = _mm512_shuffle_f32x4::<0x88>(odd, last);
        columns[2][i] = _mm512_shuffle_f32x4::<0xdd>(even, other);
        columns[3][i] = _mm512_shuffle_f32x4::<0xdd>(odd, last);
    }
    columns
}

/// e1, e2 and e3 of sixteen points or directions, which are given by fours.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn coordinates(x: &[f32; 64]) -> [__m512; 3] {
    let parts = x.as_chunks::<16>().0;
    let (a, b) = (register(&parts[0]), register(&parts[1]));
    let (c, d) = (register(&parts[2]), register(&parts[3]));
    let xy = _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
    let z = _mm512_setr_epi32(2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31);
    let (first, last) = (
        _mm512_permutex2var_ps(a, xy, b),
        _mm512_permutex2var_ps(c, xy, d),
    );
    let (z_first, z_last) = (
        _mm512_permutex2var_ps(a, z, b),
        _mm512_permutex2var_ps(c, z, d),
    );
    [
        _mm512_shuffle_f32x4::<0x44>(first, last),
        _mm512_shuffle_f32x4::<0xee>(first, last),
        _mm512_shuffle_f32x4::<0x44>(z_first, z_last),
    ]
}

/// The sum of the columns, each times its coordinate.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn image([a, b, c, t]: [[__m512; 3]; 4], [x, y, z]: [__m512; 3]) -> [__m512; 3] {
    let row = |i: usize| {
        let last = _mm512_fmadd_ps(c[i], z, t[i]);
        _mm512_fmadd_ps(a[i], x, _mm512_fmadd_ps(b[i], y, last))
    };
    [row(0), row(1), row(2)]
}

/// The sum of the cross products of the columns, each times its coordinate, with length 1; zero
/// where the square of its length is beyond the range of normal numbers.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn normal([a, b, c, _]: [[__m512; 3]; 4], [x, y, z]: [__m512; 3]) -> [__m512; 3] {
    let product = |u: [__m512; 3], v: [__m512; 3], i: usize, j: usize| {
        _mm512_fmsub_ps(u[i], v[j], _mm512_mul_ps(u[j], v[i]))
    };
    let row = |i: usize, j: usize| {
        let first = _mm512_mul_ps(product(b, c, i, j), x);
        let two = _mm512_fmadd_ps(product(c, a, i, j), y, first);
        _mm512_fmadd_ps(product(a, b, i, j), z, two)
    };
    let [x, y, z] = [row(1, 2), row(2, 0), row(0, 1)];
    let square = _mm512_fmadd_ps(x, x, _mm512_fmadd_ps(y, y, _mm512_mul_ps(z, z)));
    let bounded = _mm512_max_ps(square, _mm512_set1_ps(f32::MIN_POSITIVE));
    let bounded = _mm512_min_ps(bounded, _mm512_set1_ps(f32::MAX));
    let is_regular = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(bounded, square);
    // One step of Newton's method doubles the fourteen bits of the estimate.
    let estimate = _mm512_rsqrt14_ps(bounded);
    let half = _mm512_mul_ps(_mm512_mul_ps(bounded, estimate), _mm512_set1_ps(0.5));
    let step = _mm512_fnmadd_ps(half, estimate, _mm512_set1_ps(1.5));
    let scale = _mm512_maskz_mul_ps(is_regular, estimate, step);
    [
        _mm512_mul_ps(x, scale),
        _mm512_mul_ps(y, scale),
        _mm512_mul_ps(z, scale),
    ]
}

/// Writes sixteen points or directions to their places, or fewer.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn write<X>(
    x: [__m512; 3],
    order: &[u16],
    places: &mut [X],
    new: impl Fn(f32, f32, f32) -> X + Copy,
) {
    let (first, last) = order.split_at(order.len().min(8));
    let low = |i: usize| _mm512_castps512_ps256(x[i]);
    let high = |i: usize| _mm512_extractf32x8_ps::<1>(x[i]);
    eight::write([low(0), low(1), low(2)], first, places, new);
    eight::write([high(0), high(1), high(2)], last, places, new);
}
