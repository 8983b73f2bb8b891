//! Points with normals, by means of affine maps.

use core::arch::x86_64::*;

use super::columns::halves;
use super::eight::{coordinates, transposed, write};
use crate::batch::skin::bucket::Bucket;
use crate::batch::skin::palette::Columns;
use crate::batch::skin::posed::Posed;
use crate::cga3::Point;
use crate::vga3::Vector;

/// Moves the points and normals of a bucket with `K` influences of each point; 0 is any number.
#[inline]
#[target_feature(enable = "avx2,fma")]
pub(super) fn move_all<const K: usize>(
    bucket: &Bucket<f32>,
    maps: &[Columns<f32>],
    posed: &mut Posed<'_, f32>,
) {
    let count = if K == 0 { bucket.influences } else { K };
    let joints = bucket.joints.chunks_exact(8 * count);
    let weights = bucket.weights.chunks_exact(8 * count);
    let points = bucket.points.as_chunks::<8>().0;
    let normals = bucket.normals.as_chunks::<8>().0;
    let (images, turned) = (&mut *posed.points, &mut *posed.normals);
    for ((((order, x), n), joints), weights) in bucket
        .order
        .chunks(8)
        .zip(points)
        .zip(normals)
        .zip(joints)
        .zip(weights)
    {
        let mut rows = [[_mm256_setzero_ps(); 8]; 2];
        for v in 0..8 {
            let joints = &joints[v * count..][..count];
            let weights = &weights[v * count..][..count];
            let [first, last] = halves(&maps[usize::from(joints[0])]);
            let weight = _mm256_set1_ps(weights[0]);
            let mut total = [_mm256_mul_ps(first, weight), _mm256_mul_ps(last, weight)];
            for k in 1..count {
                let [first, last] = halves(&maps[usize::from(joints[k])]);
                let weight = _mm256_set1_ps(weights[k]);
                total[0] = _mm256_fmadd_ps(first, weight, total[0]);
                total[1] = _mm256_fmadd_ps(last, weight, total[1]);
            }
            rows[0][v] = total[0];
            rows[1][v] = total[1];
        }
        let [ax, ay, az, _, bx, by, bz, _] = transposed(rows[0]);
        let [cx, cy, cz, _, tx, ty, tz, _] = transposed(rows[1]);
        let (a, b, c, t) = ([ax, ay, az], [bx, by, bz], [cx, cy, cz], [tx, ty, tz]);
        write(
            image([a, b, c, t], coordinates(x)),
            order,
            images,
            Point::new,
        );
        write(
            normal([a, b, c], coordinates(n)),
            order,
            turned,
            Vector::new,
        );
    }
}

/// The sum of the columns, each times its coordinate.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn image([a, b, c, t]: [[__m256; 3]; 4], [x, y, z]: [__m256; 3]) -> [__m256; 3] {
    let row = |i: usize| {
        let last = _mm256_fmadd_ps(c[i], z, t[i]);
        _mm256_fmadd_ps(a[i], x, _mm256_fmadd_ps(b[i], y, last))
    };
    [row(0), row(1), row(2)]
}

/// The sum of the cross products of the columns, each times its coordinate, with length 1.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn normal([a, b, c]: [[__m256; 3]; 3], [x, y, z]: [__m256; 3]) -> [__m256; 3] {
    let product = |u: [__m256; 3], v: [__m256; 3], i: usize, j: usize| {
        _mm256_fmsub_ps(u[i], v[j], _mm256_mul_ps(u[j], v[i]))
    };
    let row = |i: usize, j: usize| {
        let first = _mm256_mul_ps(product(b, c, i, j), x);
        let two = _mm256_fmadd_ps(product(c, a, i, j), y, first);
        _mm256_fmadd_ps(product(a, b, i, j), z, two)
    };
    let n = [row(1, 2), row(2, 0), row(0, 1)];
    let scale = inverse_length(n);
    [
        _mm256_mul_ps(n[0], scale),
        _mm256_mul_ps(n[1], scale),
        _mm256_mul_ps(n[2], scale),
    ]
}

/// 1 / |n|, and 0 where the square of the length is beyond the range of normal numbers.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn inverse_length([x, y, z]: [__m256; 3]) -> __m256 {
    let square = _mm256_fmadd_ps(x, x, _mm256_fmadd_ps(y, y, _mm256_mul_ps(z, z)));
    let bounded = _mm256_max_ps(square, _mm256_set1_ps(f32::MIN_POSITIVE));
    let bounded = _mm256_min_ps(bounded, _mm256_set1_ps(f32::MAX));
    let is_regular = _mm256_cmp_ps::<_CMP_EQ_OQ>(bounded, square);
    // One step of Newton's method doubles the twelve bits of the estimate.
    let estimate = _mm256_rsqrt_ps(bounded);
    let half = _mm256_mul_ps(_mm256_mul_ps(bounded, estimate), _mm256_set1_ps(0.5));
    let step = _mm256_fnmadd_ps(half, estimate, _mm256_set1_ps(1.5));
    _mm256_and_ps(_mm256_mul_ps(estimate, step), is_regular)
}
