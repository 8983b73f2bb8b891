//! Skins in `f32` with AVX-512. The weighted sum of the four columns of the matrices of a point
//! takes one register, and four points are finished together.

use core::arch::x86_64::*;

use super::bucket::Bucket;
use super::palette::{AffinePalette, Columns};
use super::pose::Posed;
use crate::cga3::Point;
use crate::unsafe_code::numbers16;
use crate::vga3::Vector;

/// The permutation of the coordinates of each quarter to y, z, x.
const ROTATED: i32 = 0b11_00_10_01;

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
pub(crate) fn by_affine_maps(
    bucket: &Bucket<f32>,
    palette: &AffinePalette<f32>,
    posed: &mut Posed<'_, f32>,
) {
    let maps = palette.maps.as_slice();
    match (bucket.influences, posed.normals.is_empty()) {
        (1, true) => move_all::<1, false>(bucket, maps, posed),
        (2, true) => move_all::<2, false>(bucket, maps, posed),
        (3, true) => move_all::<3, false>(bucket, maps, posed),
        (4, true) => move_all::<4, false>(bucket, maps, posed),
        (_, true) => any_number::<false>(bucket, maps, posed),
        (1, false) => move_all::<1, true>(bucket, maps, posed),
        (2, false) => move_all::<2, true>(bucket, maps, posed),
        (3, false) => move_all::<3, true>(bucket, maps, posed),
        (4, false) => move_all::<4, true>(bucket, maps, posed),
        (_, false) => any_number::<true>(bucket, maps, posed),
    }
}

/// The weighted sum of the matrices of a point. A macro, since the compiler does not inline a
/// function here, and a register that crosses a call goes through memory.
macro_rules! sum {
    ($maps:expr, $joints:expr, $weights:expr, $count:expr) => {{
        let first = register(&$maps[usize::from($joints[0])]);
        let mut total = _mm512_mul_ps(first, _mm512_set1_ps($weights[0]));
        for k in 1..$count {
            let map = register(&$maps[usize::from($joints[k])]);
            total = _mm512_fmadd_ps(map, _mm512_set1_ps($weights[k]), total);
        }
        total
    }};
}

#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn move_all<const K: usize, const NORMALS: bool>(
    bucket: &Bucket<f32>,
    maps: &[Columns<f32>],
    posed: &mut Posed<'_, f32>,
) {
    let joints = bucket.joints.as_chunks::<K>().0.as_chunks::<4>().0;
    let weights = bucket.weights.as_chunks::<K>().0.as_chunks::<4>().0;
    let (images, turned) = (&mut *posed.points, &mut *posed.normals);
    for (((order, (x, n)), joints), weights) in bucket
        .order
        .chunks(4)
        .zip(rest::<NORMALS>(bucket))
        .zip(joints)
        .zip(weights)
    {
        let columns = [
            sum!(maps, joints[0], weights[0], K),
            sum!(maps, joints[1], weights[1], K),
            sum!(maps, joints[2], weights[2], K),
            sum!(maps, joints[3], weights[3], K),
        ];
        write(points(columns, x), order, images, Point::new);
        if NORMALS {
            write(normals(columns, n), order, turned, Vector::new);
        }
    }
}

/// The same for more influences.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn any_number<const NORMALS: bool>(
    bucket: &Bucket<f32>,
    maps: &[Columns<f32>],
    posed: &mut Posed<'_, f32>,
) {
    let count = bucket.influences;
    let joints = bucket.joints.chunks_exact(4 * count);
    let rows = joints.zip(bucket.weights.chunks_exact(4 * count));
    let (images, turned) = (&mut *posed.points, &mut *posed.normals);
    for ((order, (x, n)), (joints, weights)) in bucket
        .order
        .chunks(4)
        .zip(rest::<NORMALS>(bucket))
        .zip(rows)
    {
        let mut columns = [_mm512_setzero_ps(); 4];
        let rows = joints.chunks_exact(count).zip(weights.chunks_exact(count));
        for (total, (joints, weights)) in columns.iter_mut().zip(rows) {
            for (joint, weight) in joints.iter().zip(weights) {
                let map = register(&maps[usize::from(*joint)]);
                *total = _mm512_fmadd_ps(map, _mm512_set1_ps(*weight), *total);
            }
        }
        write(points(columns, x), order, images, Point::new);
        if NORMALS {
            write(normals(columns, n), order, turned, Vector::new);
        }
    }
}

/// The points and normals at rest, four by four. Without normals these are points again, which are
/// not read.
#[inline]
fn rest<const NORMALS: bool>(
    bucket: &Bucket<f32>,
) -> impl Iterator<Item = (&[[f32; 4]; 4], &[[f32; 4]; 4])> {
    let normals = if NORMALS {
        &bucket.normals
    } else {
        &bucket.points
    };
    bucket
        .points
        .as_chunks::<4>()
        .0
        .iter()
        .zip(normals.as_chunks::<4>().0)
}

/// The images of four points.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn points([a, b, c, d]: [__m512; 4], x: &[[f32; 4]; 4]) -> __m512 {
    sum_of_quarters([
        _mm512_mul_ps(a, spread(&x[0])),
        _mm512_mul_ps(b, spread(&x[1])),
        _mm512_mul_ps(c, spread(&x[2])),
        _mm512_mul_ps(d, spread(&x[3])),
    ])
}

/// The images of four normals.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn normals([a, b, c, d]: [__m512; 4], n: &[[f32; 4]; 4]) -> __m512 {
    let columns = [products(a), products(b), products(c), products(d)];
    unit(_mm512_permute_ps::<ROTATED>(points(columns, n)))
}

#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn register(columns: &Columns<f32>) -> __m512 {
    let m = &columns.0;
    _mm512_setr_ps(
        m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11], m[12], m[13],
        m[14], m[15],
    )
}

/// The coordinates, each in all places of a quarter.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn spread(x: &[f32; 4]) -> __m512 {
    let x = _mm512_castps128_ps512(_mm_setr_ps(x[0], x[1], x[2], x[3]));
    let places = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
    _mm512_permutexvar_ps(places, x)
}

/// The cross products b × c, c × a, a × b of the columns, each with its coordinates in the order
/// z, x, y, and zero.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn products(columns: __m512) -> __m512 {
    let left = _mm512_shuffle_f32x4::<0b11_00_10_01>(columns, columns);
    let right = _mm512_shuffle_f32x4::<0b11_01_00_10>(columns, columns);
    let product = _mm512_mul_ps(_mm512_permute_ps::<ROTATED>(left), right);
    _mm512_fmsub_ps(left, _mm512_permute_ps::<ROTATED>(right), product)
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

/// All quarters with length 1; zero stays zero.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn unit(x: __m512) -> __m512 {
    let squares = _mm512_mul_ps(x, x);
    let pairs = _mm512_add_ps(squares, _mm512_permute_ps::<0b10_11_00_01>(squares));
    let all = _mm512_add_ps(pairs, _mm512_permute_ps::<0b01_00_11_10>(pairs));
    let square = _mm512_max_ps(all, _mm512_set1_ps(f32::MIN_POSITIVE));
    let square = _mm512_min_ps(square, _mm512_set1_ps(1e37));
    // One step of Newton's method doubles the fourteen bits of the estimate.
    let estimate = _mm512_rsqrt14_ps(square);
    let half = _mm512_mul_ps(_mm512_mul_ps(square, estimate), _mm512_set1_ps(0.5));
    let step = _mm512_fnmadd_ps(half, estimate, _mm512_set1_ps(1.5));
    _mm512_mul_ps(x, _mm512_mul_ps(estimate, step))
}

/// Writes the first three numbers of each quarter to their places, which are given in rising order.
/// There may be fewer places.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn write<X>(quarters: __m512, order: &[u16], places: &mut [X], new: impl Fn(f32, f32, f32) -> X) {
    if let &[first, _, _, last] = order
        && last - first == 3
    {
        let packed = _mm512_setr_epi32(0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15);
        let numbers = numbers16(_mm512_permutexvar_ps(packed, quarters));
        let first = usize::from(first);
        if let Some(places) = places.get_mut(first..first + 4) {
            for (place, [x, y, z]) in places.iter_mut().zip(numbers.as_chunks::<3>().0) {
                *place = new(*x, *y, *z);
            }
        }
        return;
    }
    let numbers = numbers16(quarters);
    for (&place, [x, y, z, _]) in order.iter().zip(numbers.as_chunks::<4>().0) {
        if let Some(place) = places.get_mut(usize::from(place)) {
            *place = new(*x, *y, *z);
        }
    }
}
