//! Skins in `f32` with AVX2 and FMA. The weighted sum of the columns of the matrices of a point
//! takes two registers.

use core::arch::x86_64::*;

use super::bucket::Bucket;
use super::palette::{AffinePalette, Coefficients, Columns, MotorPalette};
use super::pose::Posed;
use super::tile::{Motors, TILE};
use crate::cga3::Point;
use crate::unsafe_code::{numbers4, numbers8};
use crate::vga3::Vector;

/// The permutation of the coordinates of each half to y, z, x.
const ROTATED: i32 = 0b11_00_10_01;

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
        (1, false) => points_and_normals::<1>(bucket, maps, posed),
        (2, false) => points_and_normals::<2>(bucket, maps, posed),
        (3, false) => points_and_normals::<3>(bucket, maps, posed),
        (4, false) => points_and_normals::<4>(bucket, maps, posed),
        _ => any_number(bucket, maps, posed),
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

#[inline]
#[target_feature(enable = "avx2,fma")]
fn points_and_normals<const K: usize>(
    bucket: &Bucket<f32>,
    maps: &[Columns<f32>],
    posed: &mut Posed<'_, f32>,
) {
    let (images, turned) = (&mut *posed.points, &mut *posed.normals);
    let joints = bucket.joints.as_chunks::<K>().0.as_chunks::<2>().0;
    let weights = bucket.weights.as_chunks::<K>().0.as_chunks::<2>().0;
    let points = bucket.points.as_chunks::<2>().0;
    let normals = bucket.normals.as_chunks::<2>().0;
    let rest = points.iter().zip(normals);
    // Two at a time, since the normals of two points fill a register.
    for (((order, (x, n)), joints), weights) in
        bucket.order.chunks(2).zip(rest).zip(joints).zip(weights)
    {
        let first = sum(maps, &joints[0], &weights[0]);
        let second = sum(maps, &joints[1], &weights[1]);
        let points = [image(first, &x[0]), image(second, &x[1])];
        let both = _mm256_set_m128(normal(second, &n[1]), normal(first, &n[0]));
        let normals = numbers8(unit(both));
        for (i, &place) in order.iter().enumerate() {
            let place = usize::from(place);
            if let (Some(point), Some(normal)) = (images.get_mut(place), turned.get_mut(place)) {
                let [x, y, z, _] = numbers4(points[i]);
                *point = Point::new(x, y, z);
                *normal = Vector::new(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2]);
            }
        }
    }
}

/// The same for more influences.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn any_number(bucket: &Bucket<f32>, maps: &[Columns<f32>], posed: &mut Posed<'_, f32>) {
    let count = bucket.influences;
    let rows = bucket
        .joints
        .chunks_exact(count)
        .zip(bucket.weights.chunks_exact(count));
    for (i, (&place, (joints, weights))) in bucket.order.iter().zip(rows).enumerate() {
        let mut total = [_mm256_setzero_ps(); 2];
        for (joint, weight) in joints.iter().zip(weights) {
            let [first, last] = halves(&maps[usize::from(*joint)]);
            let weight = _mm256_set1_ps(*weight);
            total[0] = _mm256_fmadd_ps(first, weight, total[0]);
            total[1] = _mm256_fmadd_ps(last, weight, total[1]);
        }
        let place = usize::from(place);
        if let Some(point) = posed.points.get_mut(place) {
            let [x, y, z, _] = numbers4(image(total, &bucket.points[i]));
            *point = Point::new(x, y, z);
        }
        if let Some(turned) = posed.normals.get_mut(place) {
            let normal = normal(total, &bucket.normals[i]);
            let [x, y, z, ..] = numbers8(unit(_mm256_set_m128(normal, normal)));
            *turned = Vector::new(x, y, z);
        }
    }
}

/// The first two columns, and the last two.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn halves(columns: &Columns<f32>) -> [__m256; 2] {
    let m = &columns.0;
    [
        _mm256_setr_ps(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7]),
        _mm256_setr_ps(m[8], m[9], m[10], m[11], m[12], m[13], m[14], m[15]),
    ]
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

/// The sum of the cross products of the columns, each times its coordinate.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn normal([first, last]: [__m256; 2], n: &[f32; 4]) -> __m128 {
    let n = twice(n);
    let xy = _mm256_permutevar8x32_ps(n, _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1));
    let z = _mm_permute_ps::<0b10_10_10_10>(_mm256_castps256_ps128(n));
    // With the columns a, b, c: b × c and c × a in two halves, and a × b; all with their
    // coordinates in the order z, x, y.
    let left = _mm256_permute2f128_ps::<0x21>(first, last);
    let right = _mm256_permute2f128_ps::<0x02>(first, last);
    let two = _mm256_fmsub_ps(
        left,
        _mm256_permute_ps::<ROTATED>(right),
        _mm256_mul_ps(_mm256_permute_ps::<ROTATED>(left), right),
    );
    let (a, b) = (_mm256_castps256_ps128(first), _mm256_castps256_ps128(left));
    let third = _mm_fmsub_ps(
        a,
        _mm_permute_ps::<ROTATED>(b),
        _mm_mul_ps(_mm_permute_ps::<ROTATED>(a), b),
    );
    let two = _mm256_mul_ps(two, xy);
    let sum = _mm_add_ps(_mm256_castps256_ps128(two), _mm256_extractf128_ps::<1>(two));
    _mm_permute_ps::<ROTATED>(_mm_fmadd_ps(third, z, sum))
}

/// Both halves with length 1; zero stays zero.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn unit(x: __m256) -> __m256 {
    // The sum of the squares in all places of each half.
    let squares = _mm256_mul_ps(x, x);
    let pairs = _mm256_add_ps(squares, _mm256_permute_ps::<0b10_11_00_01>(squares));
    let all = _mm256_add_ps(pairs, _mm256_permute_ps::<0b01_00_11_10>(pairs));
    let square = _mm256_max_ps(all, _mm256_set1_ps(f32::MIN_POSITIVE));
    let square = _mm256_min_ps(square, _mm256_set1_ps(1e37));
    // One step of Newton's method doubles the twelve bits of the estimate.
    let estimate = _mm256_rsqrt_ps(square);
    let half = _mm256_mul_ps(_mm256_mul_ps(square, estimate), _mm256_set1_ps(0.5));
    let step = _mm256_fnmadd_ps(half, estimate, _mm256_set1_ps(1.5));
    _mm256_mul_ps(x, _mm256_mul_ps(estimate, step))
}

#[target_feature(enable = "avx2,fma")]
pub(crate) fn sum_motors(
    bucket: &Bucket<f32>,
    start: usize,
    palette: &MotorPalette<f32>,
    sums: &mut Motors<f32>,
) {
    match bucket.influences {
        1 => tile::<1>(bucket, start, palette, sums),
        2 => tile::<2>(bucket, start, palette, sums),
        3 => tile::<3>(bucket, start, palette, sums),
        4 => tile::<4>(bucket, start, palette, sums),
        _ => any_tile(bucket, start, palette, sums),
    }
}

/// The sums for the points of a tile. A motor fills a register; those of eight points are
/// transposed.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn tile<const K: usize>(
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
fn any_tile(
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

#[inline]
#[target_feature(enable = "avx2,fma")]
fn transposed(r: [__m256; 8]) -> [__m256; 8] {
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
