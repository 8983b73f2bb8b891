//! The painted skin: texture coordinates, and the texture that formulas paint.

pub(crate) mod coordinates;
mod noise;
mod paint;

use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::landmarks::Landmarks;
use crate::{Human, Vector};

/// Texels that triangles colour around themselves, so that interpolation finds no others.
const MARGIN: f64 = 1.5;

impl Human {
    /// The skin and the clothes as a texture of `size` × `size` texels, 8-bit sRGB, for the texture
    /// coordinates of the mesh: row 0 is at v = 1. What no triangle covers continues
    /// the colours around it.
    ///
    /// The colours are formulas of the place on the body at rest: a face with eyes, brows and lips,
    /// freckles, hair, a checked shirt, trousers, a belt and shoes. No two places look quite the
    /// same, so that pictures of the person can be matched.
    ///
    /// ```
    /// use ga_mannequin::Human;
    ///
    /// let texture = Human::new().texture(64);
    /// assert_eq!((texture.width(), texture.height()), (64, 64));
    /// ```
    #[must_use]
    pub fn texture(&self, size: usize) -> Plane<[u8; 3]> {
        self.painted(size, |_, colour| colour)
    }

    /// The texture with its colours changed: `change` is given the place on the body at rest and
    /// the colour there, encoded as sRGB with channels from 0 to 1.
    pub(crate) fn painted(
        &self,
        size: usize,
        change: impl Fn(Vector, [f64; 3]) -> [f64; 3] + Sync,
    ) -> Plane<[u8; 3]> {
        let landmarks = Landmarks::new();
        let mut texels = Plane::filled(size, size, None);
        let Some(coordinates) = self.mesh.texture_coordinates() else {
            return texels.map(|_: Texel| [0; 3]);
        };
        let positions: Vec<Vector> = self.mesh.coordinates().map(Vector::from).collect();
        for (face, triangle) in self.mesh.triangles().iter().enumerate() {
            let corners = [0, 1, 2].map(|corner| coordinates.get(3 * face + corner));
            let [Some(a), Some(b), Some(c)] = corners else {
                continue;
            };
            let places = [a, b, c].map(|[u, v]| [u * size as f64, (1.0 - v) * size as f64]);
            let corners = triangle.map(|vertex| positions[vertex as usize]);
            paint_triangle(&mut texels, places, |[p, q, r]| {
                corners[0] * p + corners[1] * q + corners[2] * r
            });
        }
        let colour = |texel: &Texel| {
            let (_, point) = (*texel)?;
            let colour = change(point, paint::colour(&landmarks, point));
            Some(colour.map(|c| 255.0 * c.clamp(0.0, 1.0)))
        };
        filled(size, texels.values().par_iter().map(colour).collect())
    }
}

/// A texel: how far outside its triangle it lies, and the point on the body that it shows.
type Texel = Option<(f64, Vector)>;

/// Finds the points of the texels whose centres lie in a triangle or within the margin of it,
/// unless they lie in another one or nearer to it. `point` is given the barycentric coordinates of
/// the place in the triangle that is nearest to the centre, nearly.
fn paint_triangle(
    texels: &mut Plane<Texel>,
    [a, b, c]: [[f64; 2]; 3],
    point: impl Fn([f64; 3]) -> Vector,
) {
    let size = texels.width();
    let edge = |p: [f64; 2], q: [f64; 2], x: [f64; 2]| {
        (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0])
    };
    let area = edge(a, b, c);
    if area == 0.0 {
        return;
    }
    let range = |axis: usize| {
        let [p, q, r] = [a[axis], b[axis], c[axis]];
        let low = (p.min(q).min(r) - MARGIN).floor().max(0.0) as usize;
        let high = (p.max(q).max(r) + MARGIN).ceil().max(0.0) as usize;
        low..high.min(size)
    };
    let length = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
    let lengths = [length(b, c), length(c, a), length(a, b)];
    for row in range(1) {
        for column in range(0) {
            let centre = [column as f64 + 0.5, row as f64 + 0.5];
            let shares = [edge(b, c, centre), edge(c, a, centre), edge(a, b, centre)];
            let shares = shares.map(|share| share / area);
            // The distance from the farthest edge line that the centre lies beyond.
            let beyond = (0..3).map(|i| -shares[i] * area.abs() / lengths[i]);
            let outside = beyond.fold(0.0, f64::max);
            let texel = &mut texels.row_mut(row)[column];
            if outside > MARGIN || texel.is_some_and(|(nearer, _)| nearer <= outside) {
                continue;
            }
            let inside = shares.map(|share| share.max(0.0));
            let sum: f64 = inside.iter().sum();
            *texel = Some((outside, point(inside.map(|share| share / sum))));
        }
    }
}

/// The colours, continued smoothly where there is none, so that smaller copies of the texture show
/// no seams: each gap takes the mean of what is around it (by a pyramid, after Gortler et al. 1996,
/// *The Lumigraph*, section 3.4.2).
fn filled(size: usize, colours: Vec<Option<[f64; 3]>>) -> Plane<[u8; 3]> {
    let mut levels = vec![Plane::from_fn(size, size, |column, row| {
        let colour = colours[row * size + column].map(|colour| colour.map(|c| c as f32));
        colour.map_or([0.0; 4], |[r, g, b]| [r, g, b, 1.0])
    })];
    while let Some(fine) = levels.last().filter(|level| level.width() > 1) {
        let coarse = Plane::from_fn(
            fine.width().div_ceil(2),
            fine.height().div_ceil(2),
            |column, row| {
                let below = [[0, 0], [1, 0], [0, 1], [1, 1]]
                    .map(|[i, j]| fine.get(2 * column + i, 2 * row + j).unwrap_or([0.0; 4]));
                let sum: [f32; 4] = std::array::from_fn(|c| below.iter().map(|p| p[c]).sum());
                let known = sum[3].max(1.0);
                sum.map(|s| s / known)
            },
        );
        levels.push(coarse);
    }
    let mut coarser = levels.pop().unwrap_or_default();
    while let Some(mut fine) = levels.pop() {
        for row in 0..fine.height() {
            for (column, texel) in fine.row_mut(row).iter_mut().enumerate() {
                if texel[3] == 0.0 {
                    *texel = coarser.get(column / 2, row / 2).unwrap_or([0.0; 4]);
                }
            }
        }
        coarser = fine;
    }
    coarser.map(|[r, g, b, _]| [r, g, b].map(|c| c.round() as u8))
}
