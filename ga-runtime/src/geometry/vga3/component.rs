//! Operations on the components of vectors of vga3.

use core::ops::{Index, IndexMut};

use crate::scalar::{ConstRing, Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Vector<S> {
    /// The coordinates `[x, y, z]`.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 3] {
        [self.e1, self.e2, self.e3]
    }

    /// The component along the x axis.
    #[inline]
    #[must_use]
    pub fn x(self) -> S {
        self.e1
    }

    /// The component along the y axis.
    #[inline]
    #[must_use]
    pub fn y(self) -> S {
        self.e2
    }

    /// The component along the z axis.
    #[inline]
    #[must_use]
    pub fn z(self) -> S {
        self.e3
    }

    /// The product component by component, `(a₁b₁, a₂b₂, a₃b₃)`: a scaling along the axes.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let scaled = Vector::new(1, 2, 3).component_product(Vector::new(4, 5, 6));
    /// assert_eq!(scaled, Vector::new(4, 10, 18));
    /// ```
    #[inline]
    #[must_use]
    pub fn component_product(self, other: Self) -> Self {
        Self::new(self.e1 * other.e1, self.e2 * other.e2, self.e3 * other.e3)
    }
}

impl<S: Real> Vector<S> {
    /// The smaller value in each component; that of `self` where one is NaN.
    ///
    /// Together with [`max`](Self::max) it gives the corners of the bounding box of points:
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let (a, b) = (Vector::new(1.0, 5.0, -3.0), Vector::new(2.0, 4.0, -3.0));
    /// assert_eq!(a.min(b), Vector::new(1.0, 4.0, -3.0));
    /// assert_eq!(a.max(b), Vector::new(2.0, 5.0, -3.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self::new(
            self.e1.min(other.e1),
            self.e2.min(other.e2),
            self.e3.min(other.e3),
        )
    }

    /// The larger value in each component; that of `self` where one is NaN.
    #[inline]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self::new(
            self.e1.max(other.e1),
            self.e2.max(other.e2),
            self.e3.max(other.e3),
        )
    }

    /// The absolute value of each component.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        Self::new(self.e1.abs(), self.e2.abs(), self.e3.abs())
    }
}

impl<S: ConstRing> Vector<S> {
    /// The unit vector e1 along the x axis.
    pub const X: Self = Self::E1;
    /// The unit vector e2 along the y axis.
    pub const Y: Self = Self::E2;
    /// The unit vector e3 along the z axis.
    pub const Z: Self = Self::E3;
}

/// The component along x, y or z for 0, 1 or 2. Any other index panics, as for an array.
///
/// ```
/// use ga_runtime::vga3::Vector;
/// let mut v = Vector::new(1.0, 2.0, 3.0);
/// v[1] += v[2];
/// assert_eq!(v, Vector::new(1.0, 5.0, 3.0));
/// ```
impl<S> Index<usize> for Vector<S> {
    type Output = S;

    #[inline]
    fn index(&self, index: usize) -> &S {
        match index {
            0 => &self.e1,
            1 => &self.e2,
            2 => &self.e3,
            _ => panic!("a vector has components 0, 1 and 2, not {index}"),
        }
    }
}

impl<S> IndexMut<usize> for Vector<S> {
    #[inline]
    fn index_mut(&mut self, index: usize) -> &mut S {
        match index {
            0 => &mut self.e1,
            1 => &mut self.e2,
            2 => &mut self.e3,
            _ => panic!("a vector has components 0, 1 and 2, not {index}"),
        }
    }
}

impl<S> From<[S; 3]> for Vector<S> {
    #[inline]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<S> From<Vector<S>> for [S; 3] {
    #[inline]
    fn from(Vector { e1, e2, e3 }: Vector<S>) -> Self {
        [e1, e2, e3]
    }
}
