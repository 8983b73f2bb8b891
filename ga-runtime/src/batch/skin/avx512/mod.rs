//! Skins in `f32` with AVX-512. The weighted sum of the four columns of the matrices of a point
//! takes one register, and four points are finished together, or sixteen with normals.

mod columns;
mod normals;

use core::arch::x86_64::*;

use super::bucket::Bucket;
use super::palette::{AffinePalette, Columns};
use super::posed::Posed;
use crate::cga3::Point;
use crate::unsafe_code::registers::numbers16;
use columns::{register, sum};

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
pub(crate) fn by_affine_maps(
    bucket: &Bucket<f32>,
    palette: &AffinePalette<f32>,
    posed: &mut Posed<'_, f32>,
) {
    let maps = palette.maps.as_slice();
    match (bucket.influences, posed.normals.is_empty()) {
        (1, true) => move_all::<1>(bucket, maps, posed.points),
        (2, true) => move_all::<2>(bucket, maps, posed.points),
        (3, true) => move_all::<3>(bucket, maps, posed.points),
        (4, true) => move_all::<4>(bucket, maps, posed.points),
        (_, true) => move_all::<0>(bucket, maps, posed.points),
        (1, false) => normals::move_all::<1>(bucket, maps, posed),
        (2, false) => normals::move_all::<2>(bucket, maps, posed),
        (3, false) => normals::move_all::<3>(bucket, maps, posed),
        (4, false) => normals::move_all::<4>(bucket, maps, posed),
        (_, false) => normals::move_all::<0>(bucket, maps, posed),
    }
}

/// For `K` influences of each point; 0 is any number.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn move_all<const K: usize>(
    bucket: &Bucket<f32>,
    maps: &[Columns<f32>],
    images: &mut [Point<f32>],
) {
    let count = if K == 0 { bucket.influences } else { K };
    let joints = bucket.joints.chunks_exact(4 * count);
    let weights = bucket.weights.chunks_exact(4 * count);
    let points = bucket.points.as_chunks::<4>().0;
    for (((order, x), joints), weights) in
        bucket.order.chunks(4).zip(points).zip(joints).zip(weights)
    {
        let columns = [
            sum!(maps, joints, weights, 0, count),
            sum!(maps, joints, weights, 1, count),
            sum!(maps, joints, weights, 2, count),
            sum!(maps, joints, weights, 3, count),
        ];
        write(image(columns, x), order, images);
    }
}

/// The images of four points.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn image([a, b, c, d]: [__m512; 4], x: &[[f32; 4]; 4]) -> __m512 {
    sum_of_quarters([
        _mm512_mul_ps(a, spread(&x[0])),
        _mm512_mul_ps(b, spread(&x[1])),
        _mm512_mul_ps(c, spread(&x[2])),
        _mm512_mul_ps(d, spread(&x[3])),
    ])
}

/// The coordinates, each in all places of a quarter.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn spread(x: &[f32; 4]) -> __m512 {
    let x = _mm512_castps128_ps512(_mm_setr_ps(x[0], x[1], x[2], x[3]));
    let places = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
    _mm512_permutexvar_ps(places, x)
}

/// The sum of the quarters of each register, in the quarter with its number.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn sum_of_quarters([a, b, c, d]: [__m512; 4]) -> __m512 {
    let halves = |a, b| {
        let lower = _mm512_shuffle_f32x4::<0x44>(a, b);
        _mm512_add_ps(lower, _mm512_shuffle_f32x4::<0xee>(a, b))
    };
    let (a, b) = (halves(a, b), halves(c, d));
    let even = _mm512_shuffle_f32x4::<0x88>(a, b);
    _mm512_add_ps(even, _mm512_shuffle_f32x4::<0xdd>(a, b))
}

/// Writes the first three numbers of each quarter to their places, which are given in rising order.
/// There may be fewer places.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn write(quarters: __m512, order: &[u16], images: &mut [Point<f32>]) {
    if let &[first, _, _, last] = order
        && last - first == 3
    {
        let packed = _mm512_setr_epi32(0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15);
        let numbers = numbers16(_mm512_permutexvar_ps(packed, quarters));
        let first = usize::from(first);
        if let Some(images) = images.get_mut(first..first + 4) {
            for (image, [x, y, z]) in images.iter_mut().zip(numbers.as_chunks::<3>().0) {
                *image = Point::new(*x, *y, *z);
            }
        }
        return;
    }
    let numbers = numbers16(quarters);
    let numbers = numbers.as_chunks::<4>().0;
    let mut put = |place: u16, [x, y, z, _]: [f32; 4]| {
        if let Some(image) = images.get_mut(usize::from(place)) {
            *image = Point::new(x, y, z);
        }
    };
    if let &[a, b, c, d] = order {
        put(a, numbers[0]);
        put(b, numbers[1]);
        put(c, numbers[2]);
        put(d, numbers[3]);
        return;
    }
    for (&place, numbers) in order.iter().zip(numbers) {
        put(place, *numbers);
    }
}
