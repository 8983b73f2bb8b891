//! The factors of spherical linear interpolation, as functions of the cosine of the arc.
//!
//! With φ the arc, `P = φ/sin φ` and `y = t² φ²`, the factors are `B = t P sin √y/√y` and
//! `A = cos √y − B cos φ`. P is a quotient of two polynomials in cos φ (`half_angle.rs`), and so is
//! φ² = P² sin² φ; what belongs to y are polynomials. The order of the operations is chosen for a
//! short chain of dependent ones: everything that does not need the quotient is computed beside
//! the division.

#[cfg(doc)]
use super::Real;
use super::half_angle::{Constant, angle_quotient, angle_quotient_single, pair, step};

/// The factors of two rotors or motors in the interpolation between them, and their derivatives
/// with respect to the cosine of half the angle; see [`Real::arc_factors`].
///
/// Slerp is `A R + B R′` with `A = sin (1 − t)φ/sin φ` and `B = sin tφ/sin φ` (Cui, eq. 21), where
/// cos φ is the scalar product of the two unit versors. For motors the cosine is a dual number
/// `c + d ω`, and so are the factors: `A(c) + d A′(c) ω`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcFactors<S> {
    /// A, the factor of the first.
    pub first: S,
    /// B, the factor of the second.
    pub second: S,
    /// `dA/d(cos φ)`.
    pub first_slope: S,
    /// `dB/d(cos φ)`.
    pub second_slope: S,
}

/// The coefficients of `(cos √y − 1)/y` and `(sin √y/√y − 1)/y` for y from −0.13 to 2.47, the
/// highest power first: minimax, with an error below 10⁻¹⁷.
const PART: [[f64; 2]; 8] = [
    [4.635_610_985_024_818e-14, 2.735_630_062_309_600_4e-15],
    [-1.146_540_720_921_294_2e-11, -7.644_348_657_861_334e-13],
    [2.087_665_661_790_361_6e-9, 1.605_899_089_532_136_8e-10],
    [-2.755_731_823_275_451e-7, -2.505_210_786_251_299e-8],
    [2.480_158_729_686_518_8e-5, 2.755_731_922_149_436e-6],
    [-0.001_388_888_888_888_145_6, -0.000_198_412_698_412_659_2],
    [0.041_666_666_666_666_73, 0.008_333_333_333_333_337],
    [-0.5, -0.166_666_666_666_666_67],
];

/// As [`PART`], with an error below 5·10⁻¹⁰, for `f32`.
const PART_SINGLE: [[f64; 2]; 5] = [
    [-2.636_384_368_272_106e-7, -2.413_136_070_587_983e-8],
    [2.477_818_150_987_593e-5, 2.753_924_288_221_095_5e-6],
    [-0.001_388_871_601_726_609_8, -0.000_198_411_362_471_600_57],
    [0.041_666_663_500_263_6, 0.008_333_333_088_463_705],
    [-0.500_000_000_294_787_6, -0.166_666_666_689_448],
];

/// See [`Real::arc_factors`].
#[inline(always)]
pub(super) fn arc_factors<S: Constant>(cosine: S, t: S) -> ArcFactors<S> {
    factors(cosine, t, angle_quotient(cosine), |y| {
        let square = y * y;
        let [c7, c6, c5, c4, c3, c2, c1, c0] = PART;
        let high = step(pair(c7, c6, y), square, pair(c5, c4, y));
        let low = step(pair(c3, c2, y), square, pair(c1, c0, y));
        step(high, square * square, low)
    })
}

/// [`arc_factors`] to the precision of `f32`.
#[inline(always)]
pub(super) fn arc_factors_single(cosine: f64, t: f64) -> ArcFactors<f64> {
    factors(cosine, t, angle_quotient_single(cosine), |y| {
        let square = y * y;
        let [c4, c3, c2, c1, c0] = PART_SINGLE;
        let high = step(c4, square, pair(c3, c2, y));
        step(high, square, pair(c1, c0, y))
    })
}

/// The factors from the numerator N and the denominator D of `(P − 1)/(1 − cos φ)` and from the
/// polynomials in y.
///
/// The derivatives with respect to c = cos φ follow from `dP/dc = (c P − 1)/sin² φ` and
/// `d(cos tφ)/dc = t B`; in the first, the difference is `(1 − c)(c N/D − 1)`.
#[inline(always)]
fn factors<S: Constant>(
    cosine: S,
    t: S,
    [numerator, denominator]: [S; 2],
    part: impl Fn(S) -> [S; 2],
) -> ArcFactors<S> {
    let one = S::one();
    let (below, above) = (one - cosine, one + cosine);
    let inverse_above = above.recip();
    let inverse = denominator.recip();
    let inverse_square = inverse * inverse;
    // t P and t² P², times D and D².
    let scaled = below.mul_add(numerator, denominator) * t;
    let scaled_square = scaled * scaled;
    let y = (scaled_square * (below * above)) * inverse_square;
    let [cosine_rate, ratio_rate] = part(y);
    let part_ratio = y.mul_add(ratio_rate, one);
    let second = (scaled * inverse) * part_ratio;
    let first = cosine.neg_mul_add(second, y.mul_add(cosine_rate, one));
    // dP/dc, and twice the derivative of sin √y/√y with respect to y, times (t P)².
    let growth = cosine.neg_mul_add((numerator + denominator) * (inverse * inverse_above), one);
    let bend = (scaled_square * inverse_square) * (cosine_rate - ratio_rate);
    let second_slope = -(t * part_ratio.mul_add(growth, bend));
    ArcFactors {
        first,
        second,
        first_slope: cosine.neg_mul_add(second_slope, (t - one) * second),
        second_slope,
    }
}
