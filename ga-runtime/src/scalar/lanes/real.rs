//! Real numbers side by side.

use crate::scalar::{ArcFactors, LaneMask, Lanes, Real};

impl<T: Real<Mask = bool>, const N: usize> Real for Lanes<T, N> {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::splat(T::from_f64(value))
    }
    #[inline(always)]
    fn epsilon() -> Self {
        Self::splat(T::epsilon())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(T::sqrt)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(T::abs)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine) = (self, self);
        for (sine, cosine) in sine.0.iter_mut().zip(&mut cosine.0) {
            (*sine, *cosine) = sine.sin_cos();
        }
        (sine, cosine)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.zip(x, T::atan2)
    }
    #[inline(always)]
    fn sine_by_angle(self) -> (Self, Self, Self) {
        let (mut cosine, mut ratio, mut slope) = (self, self, self);
        for lane in 0..N {
            (cosine.0[lane], ratio.0[lane], slope.0[lane]) = self.0[lane].sine_by_angle();
        }
        (cosine, ratio, slope)
    }
    #[inline(always)]
    fn angle_by_sine(self) -> (Self, Self) {
        T::angle_by_sine_in_lanes(self)
    }
    #[inline(always)]
    fn arc_factors(self, t: Self) -> ArcFactors<Self> {
        let [mut first, mut second, mut first_slope, mut second_slope] = [self; 4];
        for lane in 0..N {
            let factors = self.0[lane].arc_factors(t.0[lane]);
            first.0[lane] = factors.first;
            second.0[lane] = factors.second;
            first_slope.0[lane] = factors.first_slope;
            second_slope.0[lane] = factors.second_slope;
        }
        ArcFactors {
            first,
            second,
            first_slope,
            second_slope,
        }
    }
    #[inline(always)]
    fn exp(self) -> Self {
        self.map(T::exp)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.map(T::ln)
    }
    #[inline(always)]
    fn sinh(self) -> Self {
        self.map(T::sinh)
    }
    #[inline(always)]
    fn cosh(self) -> Self {
        self.map(T::cosh)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        self.map(T::tanh)
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.zip(other, T::hypot)
    }
    #[inline(always)]
    fn less_than(self, other: Self) -> LaneMask<N> {
        let mut mask = [false; N];
        for ((mask, lane), other) in mask.iter_mut().zip(&self.0).zip(&other.0) {
            *mask = lane.less_than(*other);
        }
        LaneMask::from_array(mask)
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> LaneMask<N> {
        let mut mask = [false; N];
        for ((mask, lane), other) in mask.iter_mut().zip(&self.0).zip(&other.0) {
            *mask = lane.less_or_equal(*other);
        }
        LaneMask::from_array(mask)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> LaneMask<N> {
        let mut mask = [false; N];
        for ((mask, lane), other) in mask.iter_mut().zip(&self.0).zip(&other.0) {
            *mask = lane.equals(*other);
        }
        LaneMask::from_array(mask)
    }
    #[inline(always)]
    fn is_finite(self) -> LaneMask<N> {
        let mut mask = [false; N];
        for (mask, lane) in mask.iter_mut().zip(&self.0) {
            *mask = lane.is_finite();
        }
        LaneMask::from_array(mask)
    }
    #[inline(always)]
    fn is_zero(self) -> LaneMask<N> {
        let mut mask = [false; N];
        for (mask, lane) in mask.iter_mut().zip(&self.0) {
            *mask = lane.is_zero();
        }
        LaneMask::from_array(mask)
    }
}
