//! The functions of half the angle in exponentials and logarithms of rigid motions, as
//! straight-line code.
//!
//! A rotor contains cos φ and sin φ of half its angle φ, its logarithm φ itself. The factors
//! between them are even functions of φ, so functions of φ² or of cos φ that are smooth where the
//! angle is zero. As polynomials they need no special case for small angles, no reduction of the
//! argument and no branch. The coefficients are minimax (Remez's exchange algorithm) with an
//! approximation error below 4·10⁻¹⁷. `f32` is evaluated in `f64`, since in `f32` the rounding
//! error for a half turn would be 3 ε.

use super::Real;

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

/// The coefficients of `(φ/sin φ − 1)/(1 − cos φ)` as a polynomial in `1 − cos φ` for φ up to π/4,
/// the highest power first.
const ANGLE: [f64; 11] = [
    0.000_307_374_384_047_946_35,
    0.000_102_592_672_184_574_88,
    0.000_630_517_480_143_779_3,
    0.001_147_929_056_277_97,
    0.002_490_572_320_387_375,
    0.005_327_488_321_433_49,
    0.011_544_053_222_937_615,
    0.025_396_823_298_842_682,
    0.057_142_857_203_699_35,
    0.133_333_333_332_465_05,
    0.333_333_333_333_337_53,
];

/// See [`Real::sine_by_angle`].
#[inline(always)]
pub(super) fn sine_by_angle<S: Real>(x: S) -> (S, S, S) {
    let u = x - S::from_integer(5);
    let [top, next, below @ ..] = STUMPFF;
    let rest = polynomial(pair(top, next, u), below, u);
    let exact = [S::from_ratio(1, 4), S::from_ratio(1, 8)];
    let start = exact.map(|part| x.neg_mul_add(part, S::one()));
    let [cosine, ratio] = [0, 1].map(|k| x.neg_mul_add(rest[k], start[k]));
    (cosine, ratio, rest[1] - rest[0] - exact[1])
}

/// `high x⁸ + Σ cₖ xᵏ` for k = 7, …, 0, of several polynomials side by side. Evaluated in pairs,
/// pairs of pairs and so on (Estrin's scheme), which shortens the chain of dependent operations.
#[inline(always)]
fn polynomial<S: Real, const N: usize>(high: [S; N], c: [[f64; N]; 8], x: S) -> [S; N] {
    let (x2, x4) = (x * x, (x * x) * (x * x));
    let middle = step(pair(c[0], c[1], x), x2, pair(c[2], c[3], x));
    let low = step(pair(c[4], c[5], x), x2, pair(c[6], c[7], x));
    step(step(high, x4, middle), x4, low)
}

/// `a x + b`.
#[inline(always)]
fn pair<S: Real, const N: usize>(a: [f64; N], b: [f64; N], x: S) -> [S; N] {
    step(a.map(S::from_f64), x, b.map(S::from_f64))
}

#[inline(always)]
fn step<S: Real, const N: usize>(high: [S; N], x: S, low: [S; N]) -> [S; N] {
    let mut sum = low;
    for (sum, high) in sum.iter_mut().zip(high) {
        *sum = high.mul_add(x, *sum);
    }
    sum
}

/// See [`Real::angle_by_sine`].
#[inline(always)]
pub(super) fn angle_by_sine<S: Real>(cosine: S) -> (S, S) {
    let (one, half) = (S::one(), S::from_ratio(1, 2));
    // For half of φ, so that the polynomial stays far from its pole at cos φ = −1:
    // A = A(φ/2)/cos φ/2, and B = (B(φ/2) − 2 cos φ/2)/(4 cos³ φ/2).
    let c = half.mul_add(cosine, half).sqrt();
    let w = one - c;
    let [top, second, third, below @ ..] = ANGLE.map(|a| [a]);
    let high = step(top.map(S::from_f64), w * w, pair(second, third, w));
    let [rise] = polynomial(high, below, w);
    let both = (c * (one + c)).recip();
    let inverse = both * (one + c);
    let ratio = rise.mul_add(w, one) * inverse;
    let slope_of_half = (one + rise) * (both * c);
    let quarter = (half * inverse) * (half * inverse);
    let slope = -(slope_of_half + c + c) * (quarter * inverse);
    (ratio, slope)
}
