//! The two surfaces.

use ga_runtime::vga3::Vector;

use crate::normals::vertex_normals;
use crate::query::Bvh;
use crate::tangents::mikktspace;
use crate::{Mesh, Rgba, Tangent, TextureSpaceError};

/// A corner of a triangle of the coarse surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoarseCorner {
    /// The position.
    pub position: Vector<f64>,
    /// The unit normal.
    pub normal: Vector<f64>,
    /// The tangent and the handedness, as MikkTSpace gives them.
    pub tangent: Tangent,
    /// The texture coordinate (u, v) in the unit square, u to the right and v up.
    pub coordinate: [f64; 2],
}

/// The coarse surface, for which maps are baked.
#[derive(Clone, Debug, PartialEq)]
pub struct Coarse {
    /// The corners of each triangle.
    pub triangles: Vec<[CoarseCorner; 3]>,
}

impl Coarse {
    /// The triangles of a mesh, with one of its sets of texture coordinates. Normals are those of
    /// the mesh, or else [`vertex_normals`]; tangents are those of the mesh, or else
    /// [`mikktspace`]. A corner without a tangent gets one perpendicular to its normal, and one
    /// without a normal gets that of its triangle. Triangles with a corner that has no texture
    /// coordinate, and degenerate ones without normals, are left out.
    ///
    /// # Errors
    ///
    /// [`TextureSpaceError::Mesh`], and [`TextureSpaceError::NoTriangles`] where none is left.
    pub fn from_mesh(mesh: &Mesh, set: usize) -> Result<Self, TextureSpaceError> {
        let computed;
        let tangents = match mesh.tangents() {
            Some(tangents) => tangents,
            None => {
                computed = mikktspace(mesh, set)?;
                &computed
            }
        };
        let Some(coordinates) = mesh.texture_coordinate_sets().get(set) else {
            return Err(crate::MeshError::NoTextureCoordinates { set }.into());
        };
        let normals = corner_normals(mesh);
        let mut triangles = Vec::new();
        for (corners, normals) in mesh.corner_triangles().into_iter().zip(normals) {
            let corner = |i: usize| {
                let index = corners[i] as usize;
                let vertex = mesh.faces().corners()[index] as usize;
                let normal = normals[i];
                (normal != Vector::ZERO).then_some(())?;
                let tangent = tangents.get(index).copied().unwrap_or_else(|| Tangent {
                    direction: normal.orthonormal_pair()[0],
                    handedness: 1.0,
                });
                Some(CoarseCorner {
                    position: mesh.positions()[vertex].into(),
                    normal,
                    tangent,
                    coordinate: *coordinates.get(index)?,
                })
            };
            if let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) {
                triangles.push([a, b, c]);
            }
        }
        if triangles.is_empty() {
            return Err(TextureSpaceError::NoTriangles { surface: "coarse" });
        }
        Ok(Self { triangles })
    }
}

/// The fine surface, of which maps are baked, with a hierarchy over its triangles.
#[derive(Clone, Debug)]
pub struct Fine {
    pub(super) bvh: Bvh,
    pub(super) corners: Vec<[Vector<f64>; 3]>,
    pub(super) normals: Vec<[Vector<f64>; 3]>,
}

impl Fine {
    /// The surface with these corners and normals of each triangle. Normals need not have length 1;
    /// the normal zero stands for that of the triangle.
    ///
    /// # Errors
    ///
    /// [`TextureSpaceError::NoTriangles`], [`TextureSpaceError::Length`], and
    /// [`TextureSpaceError::Mesh`] for a corner that is not finite.
    pub fn new(
        corners: Vec<[Vector<f64>; 3]>,
        mut normals: Vec<[Vector<f64>; 3]>,
    ) -> Result<Self, TextureSpaceError> {
        if corners.is_empty() {
            return Err(TextureSpaceError::NoTriangles { surface: "fine" });
        }
        if corners.len() != normals.len() {
            return Err(TextureSpaceError::Length {
                what: "triples of normals",
                expected: corners.len(),
                found: normals.len(),
            });
        }
        let positions: Vec<[f64; 3]> = corners.iter().flatten().map(|c| c.coordinates()).collect();
        let triangles: Vec<[u32; 3]> = (0..corners.len() as u32)
            .map(|triangle| [3 * triangle, 3 * triangle + 1, 3 * triangle + 2])
            .collect();
        let bvh = Bvh::new(&positions, &triangles)?;
        complete(&corners, &mut normals);
        Ok(Self {
            bvh,
            corners,
            normals,
        })
    }

    /// The triangles of a mesh, with its normals, or else [`vertex_normals`].
    ///
    /// # Errors
    ///
    /// As [`Fine::new`].
    pub fn from_mesh(mesh: &Mesh) -> Result<Self, TextureSpaceError> {
        let corner = |vertex: u32| Vector::from(mesh.positions()[vertex as usize]);
        let corners = mesh.triangles().iter().map(|t| t.map(corner)).collect();
        Self::new(corners, corner_normals(mesh))
    }

    /// The hierarchy over the triangles.
    #[must_use]
    pub fn bvh(&self) -> &Bvh {
        &self.bvh
    }
}

/// A point of the fine surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FinePoint {
    /// The index of the triangle, as [`Mesh::triangles`] counts them.
    pub triangle: u32,
    /// The barycentric coordinates, with sum 1, in the order of the corners.
    pub barycentric: [f64; 3],
}

impl FinePoint {
    /// The mean of values at the corners of the triangle.
    #[must_use]
    pub fn mean<const N: usize>(&self, corners: &[[f64; N]; 3]) -> [f64; N] {
        let [u, v, w] = self.barycentric;
        std::array::from_fn(|i| corners[0][i] * u + corners[1][i] * v + corners[2][i] * w)
    }
}

/// The colours of the vertices of a mesh at the corners of each of its triangles; `None` for a mesh
/// without colours.
#[must_use]
pub fn corner_colours(mesh: &Mesh) -> Option<Vec<[Rgba; 3]>> {
    let colours = mesh.colours()?;
    let colour = |vertex: u32| colours[vertex as usize];
    Some(mesh.triangles().iter().map(|t| t.map(colour)).collect())
}

/// The texture coordinates at the corners of each triangle of a mesh; zero where a corner has none,
/// and `None` for a mesh without this set of coordinates.
#[must_use]
pub fn corner_coordinates(mesh: &Mesh, set: usize) -> Option<Vec<[[f64; 2]; 3]>> {
    let coordinates = mesh.texture_coordinate_sets().get(set)?;
    let coordinate = |corner: u32| {
        coordinates
            .get(corner as usize)
            .copied()
            .unwrap_or_default()
    };
    let triangles = mesh.corner_triangles();
    Some(triangles.iter().map(|t| t.map(coordinate)).collect())
}

/// The normals at the corners of each triangle; zero only for degenerate triangles.
fn corner_normals(mesh: &Mesh) -> Vec<[Vector<f64>; 3]> {
    let position = |vertex: u32| Vector::from(mesh.positions()[vertex as usize]);
    let triangles = mesh.triangles();
    let corners: Vec<_> = triangles.iter().map(|t| t.map(position)).collect();
    let mut normals: Vec<[Vector<f64>; 3]> = match mesh.normals() {
        Some(normals) => {
            let normal = |corner: u32| normals.get(corner as usize).copied().unwrap_or_default();
            let triangles = mesh.corner_triangles();
            triangles.iter().map(|t| t.map(normal)).collect()
        }
        None => {
            let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
            let normals = vertex_normals(&positions, &triangles);
            let normal = |vertex: u32| Vector::from(normals[vertex as usize]);
            triangles.iter().map(|t| t.map(normal)).collect()
        }
    };
    complete(&corners, &mut normals);
    normals
}

/// Replaces normals that are zero by those of their triangles.
fn complete(corners: &[[Vector<f64>; 3]], normals: &mut [[Vector<f64>; 3]]) {
    for (corners, normals) in corners.iter().zip(normals) {
        for normal in normals {
            if *normal == Vector::ZERO {
                *normal = crate::normals::area_vector(*corners)
                    .normalized()
                    .unwrap_or_default();
            }
        }
    }
}
