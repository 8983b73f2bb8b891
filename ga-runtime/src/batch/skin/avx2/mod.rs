//! Skins in `f32` with AVX2 and FMA. The weighted sum of the columns of the matrices of a point
//! takes two registers. Normals and blends of motors are computed for eight points at a time,
//! coordinate by coordinate.

mod columns;
pub(super) mod eight;
mod motors;
mod normals;

use core::arch::x86_64::*;

pub(crate) use motors::{by_motors, sum_motors};

use columns::halves;

use super::bucket::Bucket;
use super::palette::{AffinePalette, Columns};
use super::posed::Posed;
use crate::cga3::Point;
use crate::unsafe_code::registers::numbers4;

#[target_feature(enable = "avx2,fma")]
pub(crate) fn by_affine_maps(
    bucket: &Bucket<f32>,
    palette: &AffinePalette<f32>,
    posed: &mut Posed<'_, f32>,
) {
    let maps = palette.maps.as_slice();
    match (bucket.influences, posed.normals.is_empty()) {
        (1, true) => points::<1>(bucket, maps, posed.points),
        (2, true) => points::<2>(bucket, maps, posed.points),
        (3, true) => points::<3>(bucket, maps, posed.points),
        (4, true) => points::<4>(bucket, maps, posed.points),
        (_, true) => any_number(bucket, maps, posed.points),
        (1, false) => normals::move_all::<1>(bucket, maps, posed),
        (2, false) => normals::move_all::<2>(bucket, maps, posed),
        (3, false) => normals::move_all::<3>(bucket, maps, posed),
        (4, false) => normals::move_all::<4>(bucket, maps, posed),
        (_, false) => normals::move_all::<0>(bucket, maps, posed),
    }
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn points<const K: usize>(bucket: &Bucket<f32>, maps: &[Columns<f32>], images: &mut [Point<f32>]) {
    let joints = bucket.joints.as_chunks::<K>().0;
    let weights = bucket.weights.as_chunks::<K>().0;
    let rows = joints.iter().zip(weights);
    for ((&place, x), (joints, weights)) in bucket.order.iter().zip(&bucket.points).zip(rows) {
        let [x, y, z, _] = numbers4(image(sum(maps, joints, weights), x));
        if let Some(point) = images.get_mut(usize::from(place)) {
            *point = Point::new(x, y, z);
        }
    }
}

/// The same for more influences.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn any_number(bucket: &Bucket<f32>, maps: &[Columns<f32>], images: &mut [Point<f32>]) {
    let count = bucket.influences;
    let joints = bucket.joints.chunks_exact(count);
    let rows = joints.zip(bucket.weights.chunks_exact(count));
    for ((&place, x), (joints, weights)) in bucket.order.iter().zip(&bucket.points).zip(rows) {
        let mut total = [_mm256_setzero_ps(); 2];
        for (joint, weight) in joints.iter().zip(weights) {
            let [first, last] = halves(&maps[usize::from(*joint)]);
            let weight = _mm256_set1_ps(*weight);
            total[0] = _mm256_fmadd_ps(first, weight, total[0]);
            total[1] = _mm256_fmadd_ps(last, weight, total[1]);
        }
        let [x, y, z, _] = numbers4(image(total, x));
        if let Some(point) = images.get_mut(usize::from(place)) {
            *point = Point::new(x, y, z);
        }
    }
}

/// The weighted sum of the columns of matrices.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn sum<const K: usize>(
    maps: &[Columns<f32>],
    joints: &[u16; K],
    weights: &[f32; K],
) -> [__m256; 2] {
    let [first, last] = halves(&maps[usize::from(joints[0])]);
    let weight = _mm256_set1_ps(weights[0]);
    let mut total = [_mm256_mul_ps(first, weight), _mm256_mul_ps(last, weight)];
    for k in 1..K {
        let [first, last] = halves(&maps[usize::from(joints[k])]);
        let weight = _mm256_set1_ps(weights[k]);
        total[0] = _mm256_fmadd_ps(first, weight, total[0]);
        total[1] = _mm256_fmadd_ps(last, weight, total[1]);
    }
    total
}

/// The four numbers in both halves of a register.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn twice(x: &[f32; 4]) -> __m256 {
    let x = _mm_setr_ps(x[0], x[1], x[2], x[3]);
    _mm256_set_m128(x, x)
}

/// The sum of the columns, each times its coordinate.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn image([first, last]: [__m256; 2], x: &[f32; 4]) -> __m128 {
    let x = twice(x);
    let xy = _mm256_permutevar8x32_ps(x, _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1));
    let zw = _mm256_permutevar8x32_ps(x, _mm256_setr_epi32(2, 2, 2, 2, 3, 3, 3, 3));
    let sum = _mm256_fmadd_ps(first, xy, _mm256_mul_ps(last, zw));
    _mm_add_ps(_mm256_castps256_ps128(sum), _mm256_extractf128_ps::<1>(sum))
}
