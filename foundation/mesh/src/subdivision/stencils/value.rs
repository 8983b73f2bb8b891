//! What can be summed with weights.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

/// A value of which weighted sums can be formed: a number, an array of numbers, a vector, a point.
///
/// A weighted sum of conformal points with total weight 1 is in general not a point but a dual
/// sphere: its e1, e2, e3 and eo are those of the point with the summed coordinates, its ei is
/// larger by half the weighted variance of the points. The centre of that sphere is the affine
/// combination wanted here, and depends on e1, e2, e3 alone; therefore only these three are summed,
/// which costs the same as for vectors.
pub trait Value: Copy {
    /// The type of the weights.
    type Weight: Copy;

    /// An unfinished sum.
    type Sum: Copy;

    /// A weight in the precision of the value.
    fn weight(weight: f64) -> Self::Weight;

    /// `weight · self`.
    fn times(self, weight: Self::Weight) -> Self::Sum;

    /// `sum + weight · self`.
    fn add_to(self, sum: Self::Sum, weight: Self::Weight) -> Self::Sum;

    /// The value of a sum.
    fn of_sum(sum: Self::Sum) -> Self;
}

macro_rules! values {
    ($($scalar:ty)*) => {$(
        impl Value for $scalar {
            type Weight = $scalar;
            type Sum = $scalar;

            #[inline]
            fn weight(weight: f64) -> $scalar {
                weight as $scalar
            }

            #[inline]
            fn times(self, weight: $scalar) -> $scalar {
                weight * self
            }

            #[inline]
            fn add_to(self, sum: $scalar, weight: $scalar) -> $scalar {
                sum + weight * self
            }

            #[inline]
            fn of_sum(sum: $scalar) -> $scalar {
                sum
            }
        }

        impl<const N: usize> Value for [$scalar; N] {
            type Weight = $scalar;
            type Sum = [$scalar; N];

            #[inline]
            fn weight(weight: f64) -> $scalar {
                weight as $scalar
            }

            #[inline]
            fn times(self, weight: $scalar) -> Self {
                self.map(|x| weight * x)
            }

            #[inline]
            fn add_to(self, sum: Self, weight: $scalar) -> Self {
                std::array::from_fn(|axis| sum[axis] + weight * self[axis])
            }

            #[inline]
            fn of_sum(sum: Self) -> Self {
                sum
            }
        }

        impl Value for Vector<$scalar> {
            type Weight = $scalar;
            type Sum = Self;

            #[inline]
            fn weight(weight: f64) -> $scalar {
                weight as $scalar
            }

            #[inline]
            fn times(self, weight: $scalar) -> Self {
                self * weight
            }

            #[inline]
            fn add_to(self, sum: Self, weight: $scalar) -> Self {
                sum + self * weight
            }

            #[inline]
            fn of_sum(sum: Self) -> Self {
                sum
            }
        }

        impl Value for Point<$scalar> {
            type Weight = $scalar;
            type Sum = [$scalar; 3];

            #[inline]
            fn weight(weight: f64) -> $scalar {
                weight as $scalar
            }

            #[inline]
            fn times(self, weight: $scalar) -> [$scalar; 3] {
                self.coordinates().times(weight)
            }

            #[inline]
            fn add_to(self, sum: [$scalar; 3], weight: $scalar) -> [$scalar; 3] {
                self.coordinates().add_to(sum, weight)
            }

            #[inline]
            fn of_sum(sum: [$scalar; 3]) -> Self {
                sum.into()
            }
        }
    )*};
}

values!(f32 f64);
