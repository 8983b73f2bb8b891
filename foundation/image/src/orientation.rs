//! Which side of a picture is up: what a camera notes beside the pixels of its sensor.

pub use image::metadata::Orientation;

use crate::plane::Plane;

impl<T: Copy> Plane<T> {
    /// The plane after the change that an orientation stands for: rotations are clockwise, and
    /// before the mirroring. Four of the eight exchange columns and rows.
    ///
    /// ```
    /// use ga_image::orientation::Orientation;
    /// use ga_image::plane::Plane;
    ///
    /// let stored = Plane::from_values(2, 1, vec!['a', 'b'])?;
    /// let upright = stored.oriented(Orientation::Rotate90);
    /// assert_eq!((upright.width(), upright.height()), (1, 2));
    /// assert_eq!(upright.values(), ['a', 'b']);
    /// assert_eq!(stored.oriented(Orientation::Rotate180).values(), ['b', 'a']);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn oriented(&self, orientation: Orientation) -> Self {
        let (width, height) = (self.width(), self.height());
        let (right, bottom) = (width.wrapping_sub(1), height.wrapping_sub(1));
        let lying = |place: fn([usize; 2], [usize; 2]) -> [usize; 2]| {
            Self::from_fn(width, height, |column, row| {
                let [column, row] = place([column, row], [right, bottom]);
                self.row(row)[column]
            })
        };
        let turned = |place: fn([usize; 2], [usize; 2]) -> [usize; 2]| {
            Self::from_fn(height, width, |column, row| {
                let [column, row] = place([column, row], [right, bottom]);
                self.row(row)[column]
            })
        };
        match orientation {
            Orientation::NoTransforms => self.clone(),
            Orientation::FlipHorizontal => lying(|[u, v], [right, _]| [right - u, v]),
            Orientation::Rotate180 => lying(|[u, v], [right, bottom]| [right - u, bottom - v]),
            Orientation::FlipVertical => lying(|[u, v], [_, bottom]| [u, bottom - v]),
            Orientation::Rotate90FlipH => turned(|[u, v], _| [v, u]),
            Orientation::Rotate90 => turned(|[u, v], [_, bottom]| [v, bottom - u]),
            Orientation::Rotate270FlipH => {
                turned(|[u, v], [right, bottom]| [right - v, bottom - u])
            }
            Orientation::Rotate270 => turned(|[u, v], [right, _]| [right - v, u]),
        }
    }
}
