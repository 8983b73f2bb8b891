//! Affine maps between triangles of a texture and of a picture.

use ga_runtime::vga2::Vector;

/// The affine map between two triangles of the plane, q = o + a x + b y.
///
/// A pinhole maps a triangle of space to its picture by a projective map, whose affine part is
/// exact at the corners; [`affine_error`] bounds the difference between them (Cui, section 2.1.3:
/// the affine transformation of each region of the texture).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleWarp {
    origin: [f64; 2],
    columns: [[f64; 2]; 2],
}

impl TriangleWarp {
    /// The map that takes the corners of one triangle to those of another; `None` where the first
    /// has no area or a number is not finite.
    ///
    /// ```
    /// use ga_vision::texture::TriangleWarp;
    ///
    /// let texture = [[0.0, 0.0], [4.0, 0.0], [0.0, 2.0]];
    /// let picture = [[10.0, 20.0], [14.0, 24.0], [8.0, 20.0]];
    /// let warp = TriangleWarp::new(texture, picture).ok_or("no area")?;
    /// assert_eq!(warp.at([4.0, 0.0]), [14.0, 24.0]);
    /// // The middle of a side goes to the middle of its image.
    /// assert_eq!(warp.at([0.0, 1.0]), [9.0, 20.0]);
    /// // One texel is as large as |(1, 1) × (−1, 0)| = 1 pixel.
    /// assert_eq!(warp.area_ratio(), 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn new(from: [[f64; 2]; 3], to: [[f64; 2]; 3]) -> Option<Self> {
        let sides = |[a, b, c]: [[f64; 2]; 3]| [minus(b, a), minus(c, a)];
        let ([p, q], [r, s]) = (sides(from), sides(to));
        let area = wedge(p, q);
        let column = |x: f64, y: f64| [0, 1].map(|k| (x * r[k] + y * s[k]) / area);
        let columns = [column(q[1], -p[1]), column(-q[0], p[0])];
        let offset = |k: usize| columns[0][k] * from[0][0] + columns[1][k] * from[0][1];
        let origin = [0, 1].map(|k| to[0][k] - offset(k));
        let numbers = columns.as_flattened().iter().chain(&origin);
        (area != 0.0 && numbers.clone().all(|x| x.is_finite())).then_some(Self { origin, columns })
    }

    /// The image of a place.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.columns;
        [0, 1].map(|k| self.origin[k] + a[k] * x + b[k] * y)
    }

    /// The images of the two units.
    pub(super) fn columns(&self) -> [[f64; 2]; 2] {
        self.columns
    }

    /// How many times larger an area becomes: the magnitude of the determinant.
    #[must_use]
    pub fn area_ratio(&self) -> f64 {
        wedge(self.columns[0], self.columns[1]).abs()
    }
}

/// A bound in pixels of the distance between the image of a point of a triangle by a pinhole and
/// by the affine map that agrees with it at the corners, from the depths z > 0 of the corners and
/// their pixels: L (√z₁ − √z₀)/(√z₁ + √z₀) with the longest side L of the image and the least and
/// the greatest depth. It is attained where that side joins them. Infinite where a depth is not
/// positive.
///
/// With barycentric coordinates αᵢ on the triangle and z̄ = Σ αᵢ zᵢ, those of the image are
/// αᵢ zᵢ/z̄. The images differ by at most L ½ Σ αᵢ|zᵢ − z̄|/z̄, and the mean absolute deviation is
/// at most 2 (z₁ − z̄)(z̄ − z₀)/(z₁ − z₀), which divided by z̄ is greatest at z̄ = √(z₀z₁).
///
/// ```
/// use ga_vision::texture::affine_error;
///
/// // A side from depth 1 to depth 4: its point at depth 2 is seen at 2/3, not at 1/3.
/// let bound = affine_error([1.0, 4.0, 1.0], [[0.0, 0.0], [90.0, 0.0], [0.0, 1.0]]);
/// assert!((bound - 90.0 / 3.0).abs() < 0.01);
/// // A triangle parallel to the picture.
/// assert_eq!(affine_error([2.0; 3], [[0.0, 0.0], [90.0, 0.0], [0.0, 1.0]]), 0.0);
/// ```
#[must_use]
pub fn affine_error(depths: [f64; 3], pixels: [[f64; 2]; 3]) -> f64 {
    let near = depths.into_iter().fold(f64::INFINITY, f64::min);
    let far = depths.into_iter().fold(0.0, f64::max);
    if !(near > 0.0 && far.is_finite()) {
        return f64::INFINITY;
    }
    let [a, b, c] = pixels;
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    let longest = [minus(b, a), minus(c, b), minus(a, c)]
        .map(length)
        .into_iter()
        .fold(0.0, f64::max);
    let (near, far) = (near.sqrt(), far.sqrt());
    longest * (far - near) / (far + near)
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The area of the parallelogram of two sides.
fn wedge(a: [f64; 2], b: [f64; 2]) -> f64 {
    (Vector::from(a) ^ Vector::from(b)).e12
}
