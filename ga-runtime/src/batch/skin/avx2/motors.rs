//! Blends of motors. A motor fills a register; the sums of eight points are transposed.

use core::arch::x86_64::*;

use super::eight::{coordinates, transposed, write};
use crate::batch::skin::bucket::{Bucket, Motors, TILE};
use crate::batch::skin::palette::{Coefficients, MotorPalette};
use crate::batch::skin::posed::Posed;
use crate::cga3::Point;
use crate::unsafe_code::registers::numbers8;
use crate::vga3::Vector;

/// Moves the points and normals of a bucket by the blends of motors, where nothing stretches.
/// Points with influences that are half a turn apart are not right yet: their signs depend on all
/// of them.
#[target_feature(enable = "avx2,fma")]
pub(crate) fn by_motors(
    bucket: &Bucket<f32>,
    palette: &MotorPalette<f32>,
    posed: &mut Posed<'_, f32>,
) {
    match (bucket.influences, posed.normals.is_empty()) {
        (1, true) => move_all::<1, false>(bucket, palette, posed),
        (2, true) => move_all::<2, false>(bucket, palette, posed),
        (3, true) => move_all::<3, false>(bucket, palette, posed),
        (4, true) => move_all::<4, false>(bucket, palette, posed),
        (_, true) => move_all::<0, false>(bucket, palette, posed),
        (1, false) => move_all::<1, true>(bucket, palette, posed),
        (2, false) => move_all::<2, true>(bucket, palette, posed),
        (3, false) => move_all::<3, true>(bucket, palette, posed),
        (4, false) => move_all::<4, true>(bucket, palette, posed),
        (_, false) => move_all::<0, true>(bucket, palette, posed),
    }
}

/// For `K` influences of each point; 0 is any number.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn move_all<const K: usize, const NORMALS: bool>(
    bucket: &Bucket<f32>,
    palette: &MotorPalette<f32>,
    posed: &mut Posed<'_, f32>,
) {
    let count = if K == 0 { bucket.influences } else { K };
    let signed = bucket.signed.chunks_exact(8 * count);
    let weights = bucket.weights.chunks_exact(8 * count);
    let points = bucket.points.as_chunks::<8>().0;
    // Without normals these are points again, which are not read.
    let normals = if NORMALS {
        bucket.normals.as_chunks::<8>().0
    } else {
        points
    };
    let (images, turned) = (&mut *posed.points, &mut *posed.normals);
    let (table, motors) = (palette.signed.as_slice(), palette.motors.as_slice());
    for ((((order, x), n), signed), weights) in bucket
        .order
        .chunks(8)
        .zip(points)
        .zip(normals)
        .zip(signed)
        .zip(weights)
    {
        let mut rows = [_mm256_setzero_ps(); 8];
        for v in 0..8 {
            let signed = &signed[v * count..][..count];
            let weights = &weights[v * count..][..count];
            let first = register(&motors[table[signed[0] as usize] as usize]);
            let mut total = _mm256_mul_ps(first, _mm256_set1_ps(weights[0]));
            for k in 1..count {
                let motor = register(&motors[table[signed[k] as usize] as usize]);
                total = _mm256_fmadd_ps(motor, _mm256_set1_ps(weights[k]), total);
            }
            rows[v] = total;
        }
        let sums = transposed(rows);
        let scale = scale(&sums);
        write(
            moved(&sums, scale, coordinates(x)),
            order,
            images,
            Point::new,
        );
        if NORMALS {
            write(
                rotated(&sums, scale, coordinates(n)),
                order,
                turned,
                Vector::new,
            );
        }
    }
}

/// 2 / |r|², where r is the part of the sum without ∞.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn scale([s, a, b, c, ..]: &[__m256; 8]) -> __m256 {
    let square = _mm256_fmadd_ps(*s, *s, _mm256_mul_ps(*a, *a));
    let square = _mm256_fmadd_ps(*b, *b, _mm256_fmadd_ps(*c, *c, square));
    _mm256_div_ps(_mm256_set1_ps(2.0), square)
}

/// The images of points by the sums divided by their lengths. For the sum
/// s + a e12 + b e13 + c e23 + m ∞ + v e123∞ and the vector u = −c e1 + b e2 − a e3, the image is
/// x + 2/|r|² (s p + u × p + v u) with p = u × x − m; no root is needed.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn moved(
    &[s, a, b, c, e, f, g, v]: &[__m256; 8],
    scale: __m256,
    [x, y, z]: [__m256; 3],
) -> [__m256; 3] {
    let p = _mm256_fmadd_ps(b, z, _mm256_fmsub_ps(a, y, e));
    let q = _mm256_fmsub_ps(c, z, _mm256_fmadd_ps(a, x, f));
    // The third coordinate of p, negative.
    let r = _mm256_fmadd_ps(c, y, _mm256_fmadd_ps(b, x, g));
    let [i, j, k] = crossed([s, a, b, c], [p, q, r]);
    [
        _mm256_fmadd_ps(scale, _mm256_fnmadd_ps(v, c, i), x),
        _mm256_fmadd_ps(scale, _mm256_fmadd_ps(v, b, j), y),
        _mm256_fnmadd_ps(scale, _mm256_fmadd_ps(v, a, k), z),
    ]
}

/// The images of directions.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn rotated(&[s, a, b, c, ..]: &[__m256; 8], scale: __m256, [x, y, z]: [__m256; 3]) -> [__m256; 3] {
    let p = _mm256_fmadd_ps(b, z, _mm256_mul_ps(a, y));
    let q = _mm256_fmsub_ps(c, z, _mm256_mul_ps(a, x));
    let r = _mm256_fmadd_ps(c, y, _mm256_mul_ps(b, x));
    let [i, j, k] = crossed([s, a, b, c], [p, q, r]);
    [
        _mm256_fmadd_ps(scale, i, x),
        _mm256_fmadd_ps(scale, j, y),
        _mm256_fnmadd_ps(scale, k, z),
    ]
}

/// s p + u × p for p = (p, q, −r), with the third coordinate negative.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn crossed([s, a, b, c]: [__m256; 4], [p, q, r]: [__m256; 3]) -> [__m256; 3] {
    [
        _mm256_fmadd_ps(s, p, _mm256_fmsub_ps(a, q, _mm256_mul_ps(b, r))),
        _mm256_fmsub_ps(s, q, _mm256_fmadd_ps(a, p, _mm256_mul_ps(c, r))),
        _mm256_fmadd_ps(s, r, _mm256_fmadd_ps(c, q, _mm256_mul_ps(b, p))),
    ]
}

/// The weighted sums of motors for the points of a tile that begins at `start`.
#[target_feature(enable = "avx2,fma")]
pub(crate) fn sum_motors(
    bucket: &Bucket<f32>,
    start: usize,
    palette: &MotorPalette<f32>,
    sums: &mut Motors<f32>,
) {
    match bucket.influences {
        1 => sum_tile::<1>(bucket, start, palette, sums),
        2 => sum_tile::<2>(bucket, start, palette, sums),
        3 => sum_tile::<3>(bucket, start, palette, sums),
        4 => sum_tile::<4>(bucket, start, palette, sums),
        _ => sum_any_tile(bucket, start, palette, sums),
    }
}

/// The sums for the points of a tile. A motor fills a register; those of eight points are
/// transposed.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn sum_tile<const K: usize>(
    bucket: &Bucket<f32>,
    start: usize,
    palette: &MotorPalette<f32>,
    sums: &mut Motors<f32>,
) {
    let signed = bucket.signed.as_chunks::<K>().0[start..start + TILE]
        .as_chunks::<8>()
        .0;
    let weights = bucket.weights.as_chunks::<K>().0[start..start + TILE]
        .as_chunks::<8>()
        .0;
    let (table, motors) = (palette.signed.as_slice(), palette.motors.as_slice());
    for (eight, (signed, weights)) in signed.iter().zip(weights).enumerate() {
        let mut rows = [_mm256_setzero_ps(); 8];
        for v in 0..8 {
            let (signed, weights) = (&signed[v], &weights[v]);
            let first = register(&motors[table[signed[0] as usize] as usize]);
            let mut total = _mm256_mul_ps(first, _mm256_set1_ps(weights[0]));
            for k in 1..K {
                let motor = register(&motors[table[signed[k] as usize] as usize]);
                total = _mm256_fmadd_ps(motor, _mm256_set1_ps(weights[k]), total);
            }
            rows[v] = total;
        }
        put(rows, eight, sums);
    }
}

/// The same for more influences.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn sum_any_tile(
    bucket: &Bucket<f32>,
    start: usize,
    palette: &MotorPalette<f32>,
    sums: &mut Motors<f32>,
) {
    let count = bucket.influences;
    let range = start * count..(start + TILE) * count;
    let signed = bucket.signed[range.clone()].chunks_exact(8 * count);
    let weights = bucket.weights[range].chunks_exact(8 * count);
    let (table, motors) = (palette.signed.as_slice(), palette.motors.as_slice());
    for (eight, (signed, weights)) in signed.zip(weights).enumerate() {
        let mut rows = [_mm256_setzero_ps(); 8];
        let points = signed.chunks_exact(count).zip(weights.chunks_exact(count));
        for (row, (signed, weights)) in rows.iter_mut().zip(points) {
            let mut total = _mm256_setzero_ps();
            for (signed, weight) in signed.iter().zip(weights) {
                let motor = register(&motors[table[*signed as usize] as usize]);
                total = _mm256_fmadd_ps(motor, _mm256_set1_ps(*weight), total);
            }
            *row = total;
        }
        put(rows, eight, sums);
    }
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn register(motor: &Coefficients<f32>) -> __m256 {
    let m = &motor.0;
    _mm256_setr_ps(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7])
}

/// Writes the sums of eight points, coefficient by coefficient.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn put(rows: [__m256; 8], eight: usize, sums: &mut Motors<f32>) {
    let columns = transposed(rows);
    for k in 0..8 {
        if let Some(place) = sums[k].as_chunks_mut::<8>().0.get_mut(eight) {
            *place = numbers8(columns[k]);
        }
    }
}
