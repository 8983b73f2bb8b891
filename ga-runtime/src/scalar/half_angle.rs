//! The functions of half the angle in exponentials and logarithms of rigid motions, as
//! straight-line code.
//!
//! A rotor contains cos φ and sin φ of half its angle φ, its logarithm φ itself. The factors
//! between them are even functions of φ, so functions of φ² or of cos φ that are smooth where the
//! angle is zero. As polynomials they need no special case for small angles, no reduction of the
//! argument and no branch. What belongs to cos φ is a quotient of two polynomials, without a root.
//! The coefficients are minimax (Remez's exchange algorithm), or nearly so, with an approximation
//! error below 4·10⁻¹⁷. `f32` is evaluated in `f64`, since in `f32` the rounding
//! error for a half turn would be 3 ε; its polynomials are shorter, with an error below 5·10⁻¹⁰,
//! which is a hundredth of the rounding to `f32`.

use super::Field;
#[cfg(doc)]
use super::Real;

/// A field with a number for each constant.
pub(super) trait Constant: Field {
    /// The constant, rounded.
    fn constant(value: f64) -> Self;
}

/// The coefficients of `c₂ − ¼` and `c₃ − ⅛` as polynomials in x − 5 for x from 0 to 9.95, the
/// highest power first. The constants ¼ and ⅛ are exact, and what remains is small and so has a
/// small rounding error. c₂ and c₃ are the Stumpff functions `(1 − cos φ)/φ²` and `(φ − sin φ)/φ³`
/// of x = φ².
const STUMPFF: [[f64; 2]; 10] = [
    [-3.652_696_308_519_567e-19, -1.757_439_221_688_305_2e-20],
    [1.387_016_998_042_339_2e-16, 7.383_718_380_318_964e-18],
    [-4.190_415_789_272_86e-14, -2.499_687_256_149_062e-15],
    [9.903_061_043_864_138e-12, 6.718_692_577_960_992e-13],
    [-1.767_583_919_646_860_8e-9, -1.390_689_290_494_750_8e-10],
    [2.274_804_016_768_68e-7, 2.131_216_801_206_476e-8],
    [-1.978_438_422_580_028_7e-5, -2.292_985_660_696_622e-6],
    [0.001_055_695_932_479_019_3, 0.000_160_640_786_042_843_7],
    [-0.029_506_424_270_716_747, -0.006_543_847_998_314_728],
    [0.073_454_575_291_433_32, 0.004_631_018_424_860_202],
];

/// The coefficients of the numerator and the denominator of `r = (φ/sin φ − 1)/(1 − c)` as a
/// rational function of `c = cos φ` from 0 to 1, the highest power first.
///
/// r is a Stieltjes function: it is an integral of `1/(s + c)` with positive weights over s ≥ 1. So
/// the zeros and poles of its approximations lie below c = −1, and all coefficients are positive:
/// nothing cancels.
const ANGLE: [[f64; 2]; 7] = [
    [1.506_801_607_538_266e-6, 0.004_522_143_399_208_382],
    [0.004_401_332_945_623_951_7, 0.100_369_497_853_071_59],
    [0.083_964_565_821_845_34, 0.735_824_306_182_907_3],
    [0.503_158_771_092_142_5, 2.440_803_192_335_337_3],
    [1.270_621_776_831_763_9, 4.029_598_774_462_565],
    [1.413_570_819_427_777_3, 3.228_427_384_913_851],
    [0.570_796_326_794_896_6, 1.0],
];

/// As [`STUMPFF`], to the precision of `f32`.
const STUMPFF_SINGLE: [[f64; 2]; 7] = [
    [9.918_122_565_264_41e-12, 6.727_181_216_439_052e-13],
    [-1.769_398_937_428_066_4e-9, -1.391_771_934_198_461_2e-10],
    [2.274_800_366_158_895e-7, 2.131_214_712_141_879e-8],
    [-1.978_436_176_626_757e-5, -2.292_984_321_028_476_5e-6],
    [0.001_055_695_934_986_149_5, 0.000_160_640_786_187_138_9],
    [-0.029_506_424_340_201_41, -0.006_543_848_002_459_314],
    [0.073_454_575_288_880_06, 0.004_631_018_424_713_035],
];

/// As [`ANGLE`], to the precision of `f32`.
const ANGLE_SINGLE: [[f64; 2]; 4] = [
    [0.000_398_312_452_119_759_4, 0.144_362_159_728_541_84],
    [0.133_098_148_542_795_2, 0.973_395_628_644_700_1],
    [0.606_394_548_112_277_1, 1.814_304_215_510_365_2],
    [0.570_796_326_536_542_3, 1.0],
];

/// See [`Real::sine_by_angle`].
#[inline(always)]
pub(super) fn sine_by_angle<S: Constant>(x: S) -> (S, S, S) {
    let u = x - S::from_integer(5);
    let [top, next, below @ ..] = STUMPFF;
    from_stumpff(x, polynomial(pair(top, next, u), below, u))
}

/// [`sine_by_angle`] to the precision of `f32`.
#[inline(always)]
pub(super) fn sine_by_angle_single(x: f64) -> (f64, f64, f64) {
    let u = x - 5.0;
    let [top, c5, c4, c3, c2, c1, c0] = STUMPFF_SINGLE;
    let middle = step(pair(c5, c4, u), u * u, pair(c3, c2, u));
    let high = step(top, (u * u) * (u * u), middle);
    from_stumpff(x, step(high, u * u, pair(c1, c0, u)))
}

/// The three functions from `c₂ − ¼` and `c₃ − ⅛`.
#[inline(always)]
fn from_stumpff<S: Constant>(x: S, rest: [S; 2]) -> (S, S, S) {
    let exact = [S::from_ratio(1, 4), S::from_ratio(1, 8)];
    let start = exact.map(|part| x.neg_mul_add(part, S::one()));
    let [cosine, ratio] = [0, 1].map(|k| x.neg_mul_add(rest[k], start[k]));
    (cosine, ratio, rest[1] - rest[0] - exact[1])
}

/// `high x⁸ + Σ cₖ xᵏ` for k = 7, …, 0, of several polynomials side by side. Evaluated in pairs,
/// pairs of pairs and so on (Estrin's scheme), which shortens the chain of dependent operations.
#[inline(always)]
fn polynomial<S: Constant, const N: usize>(high: [S; N], c: [[f64; N]; 8], x: S) -> [S; N] {
    let (x2, x4) = (x * x, (x * x) * (x * x));
    let middle = step(pair(c[0], c[1], x), x2, pair(c[2], c[3], x));
    let low = step(pair(c[4], c[5], x), x2, pair(c[6], c[7], x));
    step(step(high, x4, middle), x4, low)
}

/// `a x + b`.
#[inline(always)]
pub(super) fn pair<S: Constant, const N: usize>(a: [f64; N], b: [f64; N], x: S) -> [S; N] {
    // Functions given to `array::map` are not always inlined.
    let mut sum = [x; N];
    for k in 0..N {
        sum[k] = S::constant(a[k]).mul_add(x, S::constant(b[k]));
    }
    sum
}

/// `high x + low`.
#[inline(always)]
pub(super) fn step<S: Constant, const N: usize>(high: [S; N], x: S, low: [S; N]) -> [S; N] {
    let mut sum = low;
    for (sum, high) in sum.iter_mut().zip(high) {
        *sum = high.mul_add(x, *sum);
    }
    sum
}

/// See [`Real::angle_by_sine`].
#[inline(always)]
pub(super) fn angle_by_sine<S: Constant>(cosine: S) -> (S, S) {
    from_quotient(cosine, angle_quotient(cosine))
}

/// [`angle_by_sine`] to the precision of `f32`.
#[inline(always)]
pub(super) fn angle_by_sine_single(cosine: f64) -> (f64, f64) {
    from_quotient(cosine, angle_quotient_single(cosine))
}

/// The numerator and the denominator of `r = (φ/sin φ − 1)/(1 − c)` for c = cos φ.
#[inline(always)]
pub(super) fn angle_quotient<S: Constant>(cosine: S) -> [S; 2] {
    let square = cosine * cosine;
    let [c6, c5, c4, c3, c2, c1, c0] = ANGLE;
    let [numerator, denominator] = c6;
    let highest = [S::constant(numerator), S::constant(denominator)];
    let high = step(highest, square, pair(c5, c4, cosine));
    let low = step(pair(c3, c2, cosine), square, pair(c1, c0, cosine));
    step(high, square * square, low)
}

/// [`angle_quotient`] to the precision of `f32`.
#[inline(always)]
pub(super) fn angle_quotient_single(cosine: f64) -> [f64; 2] {
    let [c3, c2, c1, c0] = ANGLE_SINGLE;
    let high = pair(c3, c2, cosine);
    step(high, cosine * cosine, pair(c1, c0, cosine))
}

/// Both functions from `c = cos φ` and r: `A = 1 + (1 − c) r` and `B = −(1 + r)/(1 + c)`.
#[inline(always)]
fn from_quotient<S: Constant>(cosine: S, [numerator, denominator]: [S; 2]) -> (S, S) {
    let one = S::one();
    let above = one + cosine;
    let inverse = (denominator * above).recip();
    let rise = (one - cosine) * (numerator * above);
    let ratio = rise.mul_add(inverse, one);
    (ratio, -((numerator + denominator) * inverse))
}
