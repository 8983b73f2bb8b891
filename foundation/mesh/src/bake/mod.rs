//! Maps of a fine surface for a coarse one: normals, displacement, colour and ambient occlusion.
//!
//! The coarse surface has texture coordinates, such as those of an [`atlas`](crate::atlas). Each
//! texel that one of its triangles touches shows a point of it, and each such point p, with the
//! interpolated unit normal n, is assigned a point of the fine surface: the crossing of the line
//! `p + h n` nearest to p, with `|h|` less than the cage distance, at which the fine surface faces
//! along n; where there is none, the point of the fine surface nearest to p. The maps show what is
//! there.
//!
//! | map | numbers of a texel | elsewhere |
//! | --- | --- | --- |
//! | [`Bake::normals`] | the fine normal in the tangent frame, x, y, z of length 1 | 0, 0, 1 |
//! | [`Bake::displacement`] | the height h along n, in the unit of the coordinates | 0 |
//! | [`Bake::colour`] | what a function gives for the fine point | 0 |
//! | [`Bake::occlusion`] | the part of the sky that is seen, 0 to 1 | 1 |
//!
//! Normal maps are those of glTF, also called OpenGL or "+Y": x along the tangent, in which u
//! grows, y along the bitangent, in which v grows (up), z along the normal; a picture stores
//! `(x + 1)/2`. As MikkTSpace asks, the frame is `t, b = σ n × t, n` with n and t as they are
//! interpolated, not made unit vectors again.
//!
//! Texels around the covered ones are copies of them, so that interpolation across a seam reads no
//! others. Equal input gives equal maps, bit for bit, for any number of threads.
//!
//! ```
//! use ga_mesh::bake::{Bake, Coarse, Fine, Options};
//! use ga_mesh::obj;
//!
//! let corners = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
//! let square = b"vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
//! let coarse = Coarse::from_mesh(&obj::decode(&[&corners[..], square].concat())?, 0)?;
//! // A slope that rises by 0.01 along x.
//! let fine = obj::decode(b"v 0 0 0\nv 1 0 0.01\nv 1 1 0.01\nv 0 1 0\nf 1 2 3 4\n")?;
//! let fine = Fine::from_mesh(&fine)?;
//! let bake = Bake::new(&coarse, &fine, &Options::with_size(16))?;
//!
//! let height = bake.displacement().get(15, 0).unwrap()[0];
//! assert!((height - 0.01 * 15.5 / 16.0).abs() < 1e-6);
//! let [x, y, z] = bake.normals().get(3, 3).unwrap();
//! assert!(x < -0.009 && y.abs() < 1e-6 && z > 0.99);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod map;
mod occlusion;
mod surface;
mod texel;

pub use map::Map;
pub use occlusion::OcclusionOptions;
pub use surface::{Coarse, CoarseCorner, Fine, FinePoint, corner_colours, corner_coordinates};
pub use texel::{Texel, Texels};

use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use crate::TextureSpaceError;
use occlusion::Hemisphere;

/// What is baked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The side of the square maps in texels, from 1 to
    /// [`MAX_SIZE`](crate::atlas::MAX_SIZE); 1024 by default.
    pub size: u32,
    /// The cage distance, in the unit of the coordinates; without it, 2 % of the diagonal of the
    /// bounding box of the coarse surface.
    pub cage_distance: Option<f64>,
    /// The number of texels around the covered ones that are filled; 4 by default.
    pub dilation_texels: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            size: 1024,
            cage_distance: None,
            dilation_texels: 4,
        }
    }
}

impl Options {
    /// The default for maps of this size.
    #[must_use]
    pub fn with_size(size: u32) -> Self {
        Self {
            size,
            ..Self::default()
        }
    }
}

/// The points of the fine surface that the texels of maps show.
#[derive(Clone, Debug)]
pub struct Bake<'a> {
    coarse: &'a Coarse,
    fine: &'a Fine,
    size: u32,
    samples: Vec<Sample>,
    /// Texels to be filled, and the covered texels from which they are copied.
    copies: Vec<[u32; 2]>,
}

/// A texel with its points of both surfaces.
#[derive(Clone, Copy, Debug)]
struct Sample {
    texel: Texel,
    height: f32,
    fine: FinePoint,
    /// Whether the line along the normal does not cross the fine surface.
    is_nearest: bool,
}

impl Sample {
    /// The crossing of the line along the normal of a texel, or else the nearest point.
    fn new(texel: Texel, coarse: &Coarse, fine: &Fine, cage: f64) -> Option<Self> {
        let corners = &coarse.triangles[texel.triangle as usize];
        let point = mean(texel.weights, [0, 1, 2].map(|i| corners[i].position));
        let normal = mean(texel.weights, [0, 1, 2].map(|i| corners[i].normal)).normalized();
        let crossing = normal.and_then(|normal| fine.bvh.nearest_crossing(point, normal, cage));
        let (height, triangle, barycentric) = match &crossing {
            Some(hit) => (hit.height, hit.triangle, hit.barycentric),
            None => {
                let found = fine.bvh.nearest(point.into()).ok()?;
                let offset = Vector::from(found.point) - point;
                let height = offset.dot(normal.unwrap_or_default());
                (height, found.triangle, found.barycentric)
            }
        };
        Some(Self {
            texel,
            height: height as f32,
            fine: FinePoint {
                triangle,
                barycentric,
            },
            is_nearest: crossing.is_none(),
        })
    }
}

impl<'a> Bake<'a> {
    /// Assigns a point of the fine surface to each texel.
    ///
    /// # Errors
    ///
    /// [`TextureSpaceError`] for options that are not allowed, a coarse surface without triangles,
    /// and texture coordinates outside of the unit square.
    pub fn new(
        coarse: &'a Coarse,
        fine: &'a Fine,
        options: &Options,
    ) -> Result<Self, TextureSpaceError> {
        let size = options.size;
        let cage = options
            .cage_distance
            .unwrap_or_else(|| default_cage(coarse));
        if !(cage >= 0.0 && cage.is_finite()) {
            return Err(TextureSpaceError::Number {
                what: "cage distance",
                value: cage,
            });
        }
        let corners = coarse.triangles.iter();
        let coordinates: Vec<_> = corners.map(|t| t.map(|corner| corner.coordinate)).collect();
        let texels = Texels::new(&coordinates, size)?;
        if texels.is_empty() {
            return Err(TextureSpaceError::NoTriangles { surface: "coarse" });
        }
        let texels: Vec<Texel> = texels.iter().collect();
        let found = texels.into_par_iter();
        let found = found.filter_map(|texel| Sample::new(texel, coarse, fine, cage));
        let samples: Vec<Sample> = found.collect();
        let covered: Vec<u32> = samples.iter().map(|sample| sample.texel.index).collect();
        Ok(Self {
            coarse,
            fine,
            size,
            copies: map::dilation(size, &covered, options.dilation_texels),
            samples,
        })
    }

    /// How many texels show a point of the surface; copies around them do not count.
    #[must_use]
    pub fn covered_texels(&self) -> usize {
        self.samples.len()
    }

    /// For how many of them the line along the normal did not cross the fine surface within the
    /// cage distance, so that the nearest point was taken.
    #[must_use]
    pub fn nearest_texels(&self) -> usize {
        let nearest = self.samples.iter().filter(|sample| sample.is_nearest);
        nearest.count()
    }

    /// The normals of the fine surface in the tangent frames of the coarse one.
    #[must_use]
    pub fn normals(&self) -> Map<3> {
        self.map([0.0, 0.0, 1.0], |sample| {
            let corners = &self.coarse.triangles[sample.texel.triangle as usize];
            let weights = sample.texel.weights;
            let n = mean(weights, [0, 1, 2].map(|i| corners[i].normal));
            let t = mean(weights, [0, 1, 2].map(|i| corners[i].tangent.direction));
            let b = n.cross(t) * corners[0].tangent.handedness;
            let fine = self.fine_normal(sample);
            // The coefficients of the fine normal by its inner products with the dual basis, which
            // is divided by the volume of the frame; only its sign changes the direction.
            let volume = t.cross(b).dot(n);
            let numbers = Vector::new(
                b.cross(n).dot(fine),
                n.cross(t).dot(fine),
                t.cross(b).dot(fine),
            ) * volume.signum();
            let unit = numbers.normalized().unwrap_or(Vector::Z);
            unit.coordinates().map(|x| x as f32)
        })
    }

    /// The heights of the fine surface above the coarse one, along its interpolated unit normal,
    /// in the unit of the coordinates.
    #[must_use]
    pub fn displacement(&self) -> Map<1> {
        self.map([0.0], |sample| [sample.height])
    }

    /// What a function gives for the points of the fine surface, such as the colour of its texture
    /// or, by [`corner_colours`] and [`FinePoint::mean`], of its vertices.
    #[must_use]
    pub fn colour<const C: usize>(&self, colour: impl Fn(&FinePoint) -> [f32; C] + Sync) -> Map<C> {
        self.map([0.0; C], |sample| colour(&sample.fine))
    }

    /// The part of the sky, weighted by the cosine to the normal of the fine surface, that is not
    /// hidden by it: 1 in the open, 0 where no light enters. Rays leave at 10⁻⁵ of the diagonal of
    /// the bounding box above the surface.
    ///
    /// # Errors
    ///
    /// [`TextureSpaceError::Number`] for options that are not allowed.
    pub fn occlusion(&self, options: &OcclusionOptions) -> Result<Map<1>, TextureSpaceError> {
        let hemisphere = Hemisphere::new(options)?;
        let bounds = self.fine.bvh.bounds().unwrap_or_default();
        let lift = 1e-5 * bounds[0].distance(bounds[1]);
        Ok(self.map([1.0], |sample| {
            let FinePoint {
                triangle,
                barycentric,
            } = sample.fine;
            let corners = self.fine.corners[triangle as usize];
            let face = crate::normals::area_vector(corners).normalized();
            let normal = self.fine_normal(sample);
            let point = mean(barycentric, corners) + face.unwrap_or(normal) * lift;
            let is_blocked = |ray| self.fine.bvh.is_hit(ray, options.distance);
            [hemisphere.openness(sample.texel.index, point, normal, is_blocked)]
        }))
    }

    /// The unit normal at the fine point.
    fn fine_normal(&self, sample: &Sample) -> Vector<f64> {
        let triangle = sample.fine.triangle as usize;
        mean(sample.fine.barycentric, self.fine.normals[triangle])
            .normalized()
            .or_else(|| crate::normals::area_vector(self.fine.corners[triangle]).normalized())
            .unwrap_or(Vector::Z)
    }

    fn map<const C: usize>(
        &self,
        elsewhere: [f32; C],
        value: impl Fn(&Sample) -> [f32; C] + Sync,
    ) -> Map<C> {
        let mut texels = vec![elsewhere; self.size as usize * self.size as usize];
        let values: Vec<_> = self.samples.par_iter().map(&value).collect();
        for (sample, value) in self.samples.iter().zip(values) {
            texels[sample.texel.index as usize] = value;
        }
        for &[target, source] in &self.copies {
            texels[target as usize] = texels[source as usize];
        }
        Map {
            width: self.size,
            height: self.size,
            texels,
        }
    }
}

/// 2 % of the diagonal of the bounding box.
fn default_cage(coarse: &Coarse) -> f64 {
    let corners = coarse.triangles.iter().flatten();
    let bounds = crate::bounds(corners.map(|corner| corner.position));
    bounds.map_or(0.0, |[low, high]| 0.02 * low.distance(high))
}

/// The mean of three vectors.
fn mean([u, v, w]: [f64; 3], [a, b, c]: [Vector<f64>; 3]) -> Vector<f64> {
    a * u + b * v + c * w
}
